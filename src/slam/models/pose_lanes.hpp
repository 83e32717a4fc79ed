// SPDX-License-Identifier: GPL-3.0-or-later
// Poses of many particles side by side.
#pragma once

#include <cstddef>
#include <span>

#include "hitos/base/random_row.hpp"
#include "sensor.hpp"

namespace hitos {

/// As many as a RandomRow draws for at once.
struct PoseLanes {
    static constexpr std::size_t kLanes = NormalRow::kMost;
    // Arrays as compilers know them best.
    alignas(64) double x[kLanes];      // NOLINT(*-avoid-c-arrays)
    alignas(64) double y[kLanes];      // NOLINT(*-avoid-c-arrays)
    alignas(64) double theta[kLanes];  // NOLINT(*-avoid-c-arrays)

    void load(std::span<const Pose> poses) {
        for (std::size_t i = 0; i < poses.size(); ++i) {
            x[i] = poses[i].x;
            y[i] = poses[i].y;
            theta[i] = poses[i].theta;
        }
    }
    void store(std::span<Pose> poses) const {
        for (std::size_t i = 0; i < poses.size(); ++i) poses[i] = {x[i], y[i], theta[i]};
    }
};

}  // namespace hitos
