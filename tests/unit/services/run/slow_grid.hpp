// SPDX-License-Identifier: GPL-3.0-or-later
// An occupancy grid as slow and plain as can be, to compare the real one with.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include "hitos/services/grid/grid.hpp"

namespace hitos {

using Cell = std::pair<std::int64_t, std::int64_t>;  // (column, row) from the world's origin

/// The slow obvious grid: every cell near a ray is asked whether the ray crosses it.
class SlowGrid {
  public:
    explicit SlowGrid(const GridParams& params) : params_(params) {}

    void add(const Scan& scan, const Pose& pose) {
        const Pose laser = compose(pose, scan.fan.pose_robot_laser);
        const auto limit = static_cast<float>(params_.log_odds_limit);
        std::map<Cell, int> hits;
        std::map<Cell, int> misses;
        for (const Point2& point : scan.points) {
            const Point2 end = transform(pose, point);
            ++hits[cell(end.x, end.y)];
            cross({laser.x, laser.y}, end, misses);
        }
        for (const auto& [where, count] : hits) {
            for (int i = 0; i < count; ++i) {
                cells[where] =
                    std::min(cells[where] + static_cast<float>(params_.log_odds_hit), limit);
            }
        }
        for (const auto& [where, count] : misses) {
            if (hits.contains(where)) continue;
            for (int i = 0; i < count; ++i) {
                cells[where] =
                    std::max(cells[where] + static_cast<float>(params_.log_odds_miss), -limit);
            }
        }
    }

    std::map<Cell, float> cells;
    std::set<Cell> doubtful;  ///< touched so narrowly that rounding decides

  private:
    Cell cell(double x, double y) const {
        return {static_cast<std::int64_t>(std::floor(x / params_.resolution_m)),
                static_cast<std::int64_t>(std::floor(y / params_.resolution_m))};
    }

    void cross(const Point2& a, const Point2& b, std::map<Cell, int>& misses) {
        constexpr double kDoubt = 1e-5;
        const Cell low = cell(std::min(a.x, b.x), std::min(a.y, b.y));
        const Cell high = cell(std::max(a.x, b.x), std::max(a.y, b.y));
        for (std::int64_t column = low.first - 1; column <= high.first + 1; ++column) {
            for (std::int64_t row = low.second - 1; row <= high.second + 1; ++row) {
                const bool surely = crosses(a, b, column, row, -kDoubt);
                if (surely) ++misses[{column, row}];
                if (surely != crosses(a, b, column, row, kDoubt)) doubtful.insert({column, row});
            }
        }
    }

    /// Liang and Barsky: the part of the segment inside the cell, widened on each side.
    bool crosses(const Point2& a, const Point2& b, std::int64_t column, std::int64_t row,
                 double widened) const {
        double enter = 0.0;
        double leave = 1.0;
        const auto clip = [&](double from, double to, double low, double high) {
            if (from == to) {
                if (from < low || from > high) leave = -1.0;
                return;
            }
            const double t0 = (low - from) / (to - from);
            const double t1 = (high - from) / (to - from);
            enter = std::max(enter, std::min(t0, t1));
            leave = std::min(leave, std::max(t0, t1));
        };
        const double r = params_.resolution_m;
        clip(a.x / r, b.x / r, static_cast<double>(column) - widened,
             static_cast<double>(column + 1) + widened);
        clip(a.y / r, b.y / r, static_cast<double>(row) - widened,
             static_cast<double>(row + 1) + widened);
        return enter <= leave;
    }

    GridParams params_;
};

}  // namespace hitos
