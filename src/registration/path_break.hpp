// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a scan can follow on the one before at all.
#pragma once

#include <span>

#include "key_graph.hpp"
#include "step_matcher.hpp"

namespace hitos {

/// That a scan fitted nothing, or badly while one of it and the newest keys looks through what the
/// other saw: the robot was carried, or the log has a gap.
bool breaks_path(std::span<const SurfacePoint> scan, const MatchedStep& matched,
                 const KeyGraph& graph);

}  // namespace hitos
