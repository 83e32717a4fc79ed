// What was found in a log, as summaries of runs and records of studies state it.
#pragma once

#include <nlohmann/json.hpp>

#include "hitos/capture/tour_reader.hpp"

namespace hitos {

/// The counts, but for the scans, and the first `examples` damaged lines.
nlohmann::ordered_json json_of(const ReadReport& report,
                               std::size_t examples = ReadReport::kExamples);

/// What json_of() has written; the reasons are in English. Throws nlohmann::json::exception.
ReadReport read_report(const nlohmann::ordered_json& json);

}  // namespace hitos
