// SPDX-License-Identifier: GPL-3.0-or-later
// What summaries of runs and records of studies state alike.
#pragma once

#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "hitos/capture/tour_examination.hpp"
#include "hitos/capture/tour_reader.hpp"
#include "hitos/services/evaluation/run_measures.hpp"
#include "hitos/services/results/run_times.hpp"

namespace hitos {

/// A count as a whole number; null where there is none.
nlohmann::ordered_json json_of(const std::optional<double>& figure, const Measure& measure);

/// Its word, its number and its sentences in English.
nlohmann::ordered_json json_of(const TourFinding& finding);

/// The seconds of stages, by their names.
template <std::size_t kStages>
nlohmann::ordered_json json_of(const std::array<const char*, kStages>& names,
                               const std::array<double, kStages>& seconds) {
    nlohmann::ordered_json json;
    for (std::size_t i = 0; i < kStages; ++i) json[names.at(i)] = seconds.at(i);
    return json;
}

nlohmann::ordered_json json_of(const RunTimes& times);

/// The counts, but for the scans, and the first `examples` damaged lines.
nlohmann::ordered_json json_of(const ReadReport& report,
                               std::size_t examples = ReadReport::kExamples);

/// What json_of() has written; the reasons are in English. Throws FormatError of `file` for counts
/// that are none, and JSON's own exception where something is missing.
ReadReport read_report(const nlohmann::ordered_json& json, const std::string& file);

}  // namespace hitos
