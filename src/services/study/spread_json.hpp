// Figures of several runs as the JSON of studies and benchmarks has them.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "hitos/services/study/study_result.hpp"

namespace hitos {

/// Null where there is none.
nlohmann::ordered_json spread_json(const std::optional<Spread>& spread);

}  // namespace hitos
