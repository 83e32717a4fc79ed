// SPDX-License-Identifier: GPL-3.0-or-later
#include "loop_json.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string_view>

#include "json_input.hpp"

namespace hitos {
namespace {

using nlohmann::ordered_json;

/// Those that a loop may lack.
struct Figure {
    const char* word;
    std::optional<double> LoopRecord::*value;
};
constexpr std::array kFigures{Figure{"seen_through", &LoopRecord::seen_through},
                              Figure{"chi_square", &LoopRecord::chi_square},
                              Figure{"chi_square_limit", &LoopRecord::chi_square_limit},
                              Figure{"weight", &LoopRecord::weight}};

ordered_json json_of(const RunLoop& loop) {
    const LoopRecord& record = loop.record;
    const Pose& seen = record.pose_earlier_scan;
    ordered_json json{{"scan", record.scan + 1},
                      {"earlier", record.earlier + 1},
                      {"verdict", word_of(record.verdict)},
                      {"place", {loop.scan.pose.x, loop.scan.pose.y}},
                      {"earlier_place", {loop.earlier.pose.x, loop.earlier.pose.y}},
                      {"pose", {seen.x, seen.y, seen.theta}},
                      {"way_m", record.way_m},
                      {"score", record.score},
                      {"overlap", record.overlap}};
    for (const Figure& figure : kFigures) {
        if (const auto& value = record.*figure.value) json[figure.word] = *value;
    }
    if (loop.closed()) json["move_m"] = record.move_m;
    if (record.by_hand) json["by_hand"] = true;
    if (loop.error_m) json["error_m"] = *loop.error_m;
    if (loop.error_rad) json["error_rad"] = *loop.error_rad;
    json["reason"] = reason_of(record).english();
    return json;
}

/// What versions before had not is as it is in a loop of which nothing is known.
LoopRecord record_in(const nlohmann::json& json, std::string_view verdict, const Trajectory& path,
                     const std::string& file) {
    LoopRecord record;
    record.scan = whole_number<std::uint64_t>(json, "scan", file, 1, path.size()) - 1;
    record.earlier = whole_number<std::uint64_t>(json, "earlier", file, 1, path.size()) - 1;
    record.verdict = verdict_of(json.value("verdict", std::string(verdict)));
    const auto pose = json.at("pose").get<std::array<double, 3>>();
    record.pose_earlier_scan = {pose[0], pose[1], pose[2]};
    record.way_m = json.value("way_m", 0.0);
    record.score = json.value("score", 0.0);
    record.overlap = json.value("overlap", 0.0);
    record.move_m = json.value("move_m", 0.0);
    record.by_hand = json.value("by_hand", false);
    for (const Figure& figure : kFigures) {
        if (json.contains(figure.word)) record.*figure.value = json.at(figure.word).get<double>();
    }
    return record;
}

}  // namespace

ordered_json json_of(std::span<const RunLoop> loops, std::optional<bool> closed) {
    ordered_json json = ordered_json::array();
    for (const RunLoop& loop : loops) {
        if (!closed || loop.closed() == *closed) json.push_back(json_of(loop));
    }
    return json;
}

std::vector<RunLoop> read_loops(const nlohmann::json& quality, const Trajectory& path,
                                const std::string& file) {
    const auto records = [&](const char* word, LoopVerdict verdict) {
        std::vector<LoopRecord> found;
        if (!quality.contains(word)) return found;
        for (const nlohmann::json& loop : quality.at(word)) {
            if (loop.contains("pose"))
                found.push_back(record_in(loop, word_of(verdict), path, file));
        }
        return found;
    };
    return run_loops(records("loops", LoopVerdict::closed),
                     records("refused_loops", LoopVerdict::alone), path);
}

}  // namespace hitos
