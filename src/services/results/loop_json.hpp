// SPDX-License-Identifier: GPL-3.0-or-later
// The loops of a run as summary.json states them.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hitos/services/evaluation/run_loops.hpp"

namespace hitos {

/// Of the closed loops, the refused ones or all; scans count from 1.
nlohmann::ordered_json json_of(std::span<const RunLoop> loops,
                               std::optional<bool> closed = std::nullopt);

/// The loops that a summary's "quality" states; of versions that stated none there are none. Throws
/// FormatError of `file` for counts that are none or scans that the path lacks, and JSON's own
/// exception where something is missing.
std::vector<RunLoop> read_loops(const nlohmann::json& quality, const Trajectory& path,
                                const std::string& file);

}  // namespace hitos
