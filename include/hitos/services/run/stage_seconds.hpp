// SPDX-License-Identifier: GPL-3.0-or-later
// Where the time of a run goes.
#pragma once

#include <array>
#include <cstddef>

#include "hitos/base/stage_clock.hpp"

namespace hitos {

/// What a step does, in this order.
enum class RunStage : std::size_t { reading, features, registration, filter, rest };
inline constexpr std::array kRunStages{"reading", "features", "registration", "filter", "rest"};

using RunClock = StageClock<RunStage, kRunStages.size()>;
/// Processor time of the run's thread in each [s], by RunStage.
using StageSeconds = RunClock::Seconds;

}  // namespace hitos
