// SPDX-License-Identifier: GPL-3.0-or-later
// Where the time of a run goes.
#pragma once

#include <array>
#include <cstddef>

namespace hitos {

/// What a step does, in this order.
enum class RunStage : std::size_t { reading, features, registration, filter, rest };
inline constexpr std::array kRunStages{"reading", "features", "registration", "filter", "rest"};

/// Processor time of the run's thread in each [s], by RunStage.
using StageSeconds = std::array<double, kRunStages.size()>;

}  // namespace hitos
