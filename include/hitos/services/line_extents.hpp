// Where along an infinite line it was seen, for pictures; the filters do not need it.
#pragma once

#include <vector>

#include "hitos/slam/slam_filter.hpp"

namespace hitos {

/// A stretch of a line landmark; its ends lie on the line or near it, in the world [m].
struct LineExtent {
    int landmark = -1;  ///< index in the map
    Point2 a;
    Point2 b;
};

/// Collects the stretches of line that the best hypothesis used, step by step.
class LineExtents {
  public:
    /// What the last step observed and did not ignore.
    void note(const SlamFilter& filter, const Observation& observation);
    /// The stretches of the lines of a map; each one belongs to the line nearest to it.
    std::vector<LineExtent> of(const LandmarkMap& map) const;
    void clear() { stretches_.clear(); }

  private:
    struct Stretch {
        Recta line;         // world
        double from = 0.0;  // along the line, from its foot [m]
        double to = 0.0;
    };
    void add(const Recta& line, const Point2& a, const Point2& b);

    std::vector<Stretch> stretches_;
};

}  // namespace hitos
