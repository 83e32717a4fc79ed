// SPDX-License-Identifier: GPL-3.0-or-later
// Grids of a whole tour along one path.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "hitos/capture/tour_reader.hpp"
#include "hitos/features/control.hpp"
#include "hitos/services/grid/grid.hpp"

namespace hitos {

/// Builds a grid from the scans of a tour, scan by scan, along a path: a finished one, whose poses
/// and the scans are paired in order, or the odometry, which is read as it goes. Reads the tour
/// anew, so memory does not grow with it.
class GridBuilder {
  public:
    /// Along the odometry.
    GridBuilder(const GridParams& params, std::unique_ptr<TourReader> reader);
    /// Along `path`.
    GridBuilder(const GridParams& params, std::unique_ptr<TourReader> reader, Trajectory path);

    /// Adds the next scan; false when poses or scans are at their end.
    bool step();
    const Grid& grid() const { return grid_; }
    /// Gives it away; an empty one is left.
    Grid take_grid() { return std::exchange(grid_, Grid()); }
    /// The poses of the scans added so far.
    Trajectory path() const;
    /// 0 … 1
    double progress() const;

  private:
    std::unique_ptr<TourReader> reader_;
    std::optional<Trajectory> given_;
    ControlTrack controls_;
    std::vector<Control> step_controls_;
    OdometryPath odometry_;
    std::size_t steps_ = 0;
    Grid grid_;
};

/// The whole grid at once.
Grid build_grid(const GridParams& params, const TourReader& reader, Trajectory path);

}  // namespace hitos
