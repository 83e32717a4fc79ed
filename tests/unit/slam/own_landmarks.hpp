// SPDX-License-Identifier: GPL-3.0-or-later
// Landmarks of one kind that belong to a test alone.
#pragma once

#include "models/landmark_kinds.hpp"

namespace hitos {

template <class S>
class OwnLandmarks {
  public:
    typename S::Columns columns() { return {pools_, row_, pages_, caches_}; }

  private:
    typename S::Columns::Pools pools_;
    LandmarkRow row_;
    std::vector<std::uint32_t> pages_;
    typename S::Columns::Caches caches_;
};

}  // namespace hitos
