// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of a run's grid, kept up to date while the run goes on.
#pragma once

#include <chrono>
#include <cstdint>

#include "hitos/services/grid/grid_tiles.hpp"
#include "hitos/services/run/algoritmo.hpp"

namespace hitos {

/// Belongs to one run. Drawing a grid anew after a correction takes longer than many scans: while
/// the run goes on the one from before the correction may be shown for a while, so that this takes
/// no more than its share of the time.
class ShownGrid {
  public:
    /// The run is elsewhere: earlier pictures mean nothing.
    void begin_anew();
    /// To be called after every step.
    void note_step(const Algoritmo& run) { tiler_.note_change(run.step_grid_change()); }
    /// Whether a correction came so soon after the last one that last() will do.
    bool may_wait(const Algoritmo& run) const;
    /// The grid as it is, drawn anew where it has to be.
    const GridTiles& now(const Algoritmo& run);
    /// As it was shown last.
    const GridTiles& last() const { return tiler_.last(); }

  private:
    using Clock = std::chrono::steady_clock;

    GridTiler tiler_;
    std::uint64_t redrawn_ = 0;
    Clock::time_point waits_until_;
};

}  // namespace hitos
