// SPDX-License-Identifier: GPL-3.0-or-later
// How crisp a map is, without any truth and without a grid.
#pragma once

#include <cstdint>
#include <unordered_set>

#include "hitos/capture/scan.hpp"

namespace hitos {

/// Counts the cells that scan points fall into, along a path. A wall that is seen again where it
/// was adds points but no cells; scans laid at wrong poses add both.
class MapCrispness {
  public:
    static constexpr double kCell = 0.05;  // [m]

    void add(const Scan& scan, const Pose& pose_world_robot);
    /// Occupied cells per scan point, in (0, 1], lower is crisper; 0 without any point. It compares
    /// maps of one tour.
    double cells_per_point() const;

  private:
    std::unordered_set<std::uint64_t> cells_;
    std::uint64_t points_ = 0;
};

}  // namespace hitos
