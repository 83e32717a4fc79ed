#include "report_json.hpp"

#include <span>

namespace hitos {

using nlohmann::ordered_json;

ordered_json json_of(const ReadReport& report, std::size_t examples) {
    ordered_json skipped = ordered_json::array();
    const std::span<const ReadReport::Skip> all = report.examples;
    for (const ReadReport::Skip& skip : all.first(std::min(examples, all.size()))) {
        skipped.push_back({{"line", skip.line}, {"reason", skip.reason.english()}});
    }
    return {{"odometry_readings", report.odometry},
            {"duplicate_scans", report.duplicate_scans},
            {"stamps_backwards", report.stamps_backwards},
            {"skipped_lines", report.skipped},
            {"skipped_examples", skipped}};
}

ReadReport read_report(const ordered_json& json) {
    ReadReport report;
    report.odometry = json.at("odometry_readings");
    report.duplicate_scans = json.at("duplicate_scans");
    report.stamps_backwards = json.at("stamps_backwards");
    report.skipped = json.at("skipped_lines");
    for (const ordered_json& skip : json.at("skipped_examples")) {
        report.examples.push_back({skip.at("line"), verbatim(skip.at("reason"))});
    }
    return report;
}

}  // namespace hitos
