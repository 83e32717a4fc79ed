// SPDX-License-Identifier: GPL-3.0-or-later
#include "report_json.hpp"

#include <algorithm>
#include <cstdint>
#include <span>

#include "json_input.hpp"

namespace hitos {

using nlohmann::ordered_json;

ordered_json json_of(const RunTimes& times) {
    ordered_json json{{"before_s", times.before}, {"stages_s", json_of(kRunStages, times.stages)}};
    if (times.registration)
        json["registration_s"] = json_of(kRegistrationStages, *times.registration);
    json["judging_s"] = times.judging;
    json["files_s"] = ordered_json::object();
    for (const RunTimes::File& file : times.files) json["files_s"][file.name] = file.seconds;
    json["all_s"] = times.all;
    return json;
}

ordered_json json_of(const std::optional<double>& figure, const Measure& measure) {
    if (!figure) return {};
    return measure.is_count() ? ordered_json(static_cast<std::int64_t>(*figure))
                              : ordered_json(*figure);
}

ordered_json json_of(const TourFinding& finding) {
    ordered_json remedies = ordered_json::array();
    for (const Remedy& remedy : finding.remedies) {
        ordered_json set = ordered_json::object();
        for (const auto& [key, value] : remedy.settings) set[key] = value;
        remedies.push_back({{"remedy", remedy.words.english()}, {"set", std::move(set)}});
    }
    return {{"kind", word_of(finding.kind)},
            {"value", finding.value},
            {"found", finding.what.english()},
            {"remedy", advice_of(finding).english()},
            {"remedies", std::move(remedies)}};
}

ordered_json json_of(const ReadReport& report, std::size_t examples) {
    ordered_json skipped = ordered_json::array();
    const std::span<const ReadReport::Skip> all = report.examples;
    for (const ReadReport::Skip& skip : all.first(std::min(examples, all.size()))) {
        skipped.push_back({{"line", skip.line}, {"reason", skip.reason.english()}});
    }
    return {{"odometry_readings", report.odometry},
            {"duplicate_scans", report.duplicate_scans},
            {"stamps_backwards", report.stamps_backwards},
            {"early_scans", report.early_scans},
            {"early_scans_left_out", report.early_scans_left_out},
            {"of_recording", report.of_recording},
            {"skipped_lines", report.skipped},
            {"skipped_examples", skipped}};
}

ReadReport read_report(const ordered_json& json, const std::string& file) {
    const auto count = [&file](const ordered_json& in, const char* name) {
        return whole_number<std::uint64_t>(in, name, file);
    };
    ReadReport report;
    report.odometry = count(json, "odometry_readings");
    report.duplicate_scans = count(json, "duplicate_scans");
    report.stamps_backwards = count(json, "stamps_backwards");
    // Records of earlier versions do not have them.
    if (json.contains("early_scans")) {
        report.early_scans = count(json, "early_scans");
        report.early_scans_left_out = count(json, "early_scans_left_out");
        report.of_recording = json.at("of_recording").get<bool>();
    }
    report.skipped = count(json, "skipped_lines");
    for (const ordered_json& skip : json.at("skipped_examples")) {
        report.examples.push_back({count(skip, "line"), verbatim(skip.at("reason"))});
    }
    return report;
}

}  // namespace hitos
