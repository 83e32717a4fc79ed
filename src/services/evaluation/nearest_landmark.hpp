// SPDX-License-Identifier: GPL-3.0-or-later
// Which landmark of a map another one is held against.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "hitos/features/caracteristica.hpp"

namespace hitos {

/// Of a map that stays: the nearest landmark of a kind, by their points [T 10.3], or the namesake.
class NearestLandmark {
  public:
    explicit NearestLandmark(const LandmarkMap& map);

    /// Its place in the map; nothing where the map has none of the kind. With `identities` a
    /// landmark is held against that of its own identity, one without against those without.
    std::optional<std::size_t> of(const ICaracteristica& landmark, bool identities) const;

  private:
    const LandmarkMap& map_;
    std::vector<Point2> points_;
};

}  // namespace hitos
