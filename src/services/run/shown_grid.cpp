// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/run/shown_grid.hpp"

namespace hitos {

void ShownGrid::begin_anew() {
    tiler_.clear();
    redrawn_ = 0;
    waits_until_ = {};
}

bool ShownGrid::may_wait(const Algoritmo& run) const {
    return run.step_grid_stale() && Clock::now() < waits_until_;
}

const GridTiles& ShownGrid::now(const Algoritmo& run) {
    constexpr int kTimesItself = 40;
    const auto begin = Clock::now();
    const bool stale = run.step_grid_stale();
    const Grid& grid = run.step_grid();
    if (redrawn_ != run.step_grid_redrawn()) {
        redrawn_ = run.step_grid_redrawn();
        tiler_.clear();
        tiler_.note_change(grid.area());
    }
    const GridTiles& tiles = tiler_.tiles(grid);
    const auto end = Clock::now();
    if (stale) waits_until_ = end + kTimesItself * (end - begin);
    return tiles;
}

}  // namespace hitos
