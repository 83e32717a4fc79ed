// SPDX-License-Identifier: GPL-3.0-or-later
// Where along its infinite line each line landmark was seen: the segments of pictures, segment
// files and drawings. The filters do not need them.
#pragma once

#include <cstdint>
#include <vector>

#include "hitos/services/files/trajectory_file.hpp"
#include "hitos/slam/slam_filter.hpp"

namespace hitos {

/// A segment of a line landmark: both ends lie on the landmark's line, in the map's frame [m].
struct LineExtent {
    int landmark = -1;  ///< index in the map
    Point2 a;
    Point2 b;
    std::uint64_t points = 0;  ///< scan points that support it, over all scans
};

/// Remembers, scan by scan, between which points each line was seen, in the robot's frame, so that
/// the segments of a map can be laid out along the path that belongs to that map, whichever
/// hypothesis was best when they were seen.
class LineExtents {
  public:
    /// Neighbouring points of one line that are further apart than this along it, over all scans
    /// together, leave an opening [m]: less than a door, more than what neighbouring rays leave on
    /// a wall that the robot passes.
    static constexpr double kOpening = 0.4;

    /// What one scan showed and the filter did not ignore; once for every scan, in order.
    void note(const SlamFilter& filter, const Observation& observation);

    /// The segments of the lines of a map, by landmark and along each line. `path` holds the pose
    /// at every scan noted. A stretch of points belongs to the line nearest to it, within 0.4 m and
    /// 0.15 rad, or to none. The stretches of one line that overlap or are less than kOpening apart
    /// are one segment. It ends where its outermost stretches do: at the projection of an end point
    /// with two thirds of the ends within 0.3 m of the outermost one inside it, since the path's
    /// errors scatter them. A segment of fewer than 10 points is left out, unless its line has no
    /// other: then the line gets one over all its points. A line on which no point was noted gets
    /// none.
    std::vector<LineExtent> of(const LandmarkMap& map, const Trajectory& path) const;

    void clear();
    /// Memory that it takes.
    std::size_t bytes() const { return stretches_.size() * sizeof(Stretch); }

  private:
    /// Consecutive points of one line in one scan, robot frame.
    struct Stretch {
        Point2 a;      // first point
        Point2 b;      // last point, the first where there is no other
        Point2 along;  // from the first to the last point of the whole line
        std::uint32_t scan = 0;
        std::uint32_t points = 0;
    };

    std::vector<Stretch> stretches_;
    std::uint32_t scans_ = 0;
};

}  // namespace hitos
