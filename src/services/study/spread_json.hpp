// SPDX-License-Identifier: GPL-3.0-or-later
// Figures and times of runs as the JSON of studies and benchmarks has them.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "hitos/services/study/study_result.hpp"

namespace hitos {

/// Null where there is none.
nlohmann::ordered_json spread_json(const std::optional<Spread>& spread);

/// Likewise.
nlohmann::ordered_json stages_json(const std::optional<StageSeconds>& stages);
/// Of the object's "stage_seconds"; nothing too where a version before made it.
std::optional<StageSeconds> stages_in(const nlohmann::ordered_json& json);

}  // namespace hitos
