// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of poses of one trajectory that are so far apart on the way, or in time.
#pragma once

#include <cstddef>
#include <vector>

#include "hitos/base/geometry.hpp"

namespace hitos {

/// How far apart the poses of a pair are.
struct PairSpacing {
    enum class By { distance, time };
    By by = By::distance;
    double length = 1.0;  ///< > 0; of the way between them [m] or of tour_seconds()
    /// Share of the length that a pair may miss it by; for overlapping pairs.
    double tolerance = 0.1;
    /// Pairs one after the other, else one that begins at every pose.
    bool consecutive = false;
};

/// Both by their place in the trajectory; from < to.
struct PosePair {
    std::size_t from = 0;
    std::size_t to = 0;
    friend bool operator==(const PosePair&, const PosePair&) = default;
};

/// Which pairs are taken (the way is the sum of the straight lines from pose to pose):
/// - overlapping: for every pose the later one whose way (or time) from it is nearest to the
///   length, the first of several, where it misses the length by no more than the tolerance;
/// - consecutive: the way (or time) is counted from the first pose; where it reaches the length
///   the pose is marked and counting begins anew at 0. The pairs are each marked pose and the next
///   one, so what lies before the first mark is in no pair. A time that falls short by a
///   microsecond counts as reached, since stamps of today have no finer steps.
/// By distance these are the pairs of evo (M. Grupp, 2017) with `--delta_unit m`, with and without
/// `--all_pairs`. The trajectory is in the order of its stamps; no length that is not positive and
/// finite has pairs.
std::vector<PosePair> pose_pairs(const Trajectory& trajectory, const PairSpacing& spacing);

}  // namespace hitos
