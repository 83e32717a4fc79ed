// SPDX-License-Identifier: GPL-3.0-or-later
// A run's record as a file: what was measured, and by what its map and pictures are known.
#include <system_error>

#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/file_exchange.hpp"
#include "hitos/base/text_input.hpp"
#include "json_input.hpp"
#include "results/report_json.hpp"
#include "results/written_files.hpp"
#include "spread_json.hpp"
#include "study_files.hpp"

namespace hitos {

nlohmann::ordered_json stages_json(const std::optional<StageSeconds>& stages) {
    return stages ? json_of(kRunStages, *stages) : nlohmann::ordered_json();
}

std::optional<StageSeconds> stages_in(const nlohmann::ordered_json& json) {
    const auto found = json.find("stage_seconds");
    if (found == json.end() || found->is_null()) return std::nullopt;
    StageSeconds stages{};
    for (std::size_t i = 0; i < kRunStages.size(); ++i) stages.at(i) = found->at(kRunStages.at(i));
    return stages;
}

namespace study {
namespace {

using nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr std::size_t kExamples = 3;  // of damaged lines: a study has many runs of one log

/// Nothing too where it is of a version that did not have it.
std::optional<double> figure_in(const ordered_json& json, const Measure& measure,
                                const std::string& file) {
    if (!json.contains(measure.word) || json.at(measure.word).is_null()) return std::nullopt;
    if (!measure.is_count()) return json.at(measure.word).get<double>();
    return whole_number<int>(json, measure.word.c_str(), file, 0, kMostLandmarks);
}

RunFigures figures_in(const ordered_json& json, const std::string& file) {
    RunFigures figures;
    for (const Measure* measure : taken_measures())
        figures[*measure] = figure_in(json, *measure, file);
    // The version before had the kinds alone.
    if (!json.contains("landmarks"))
        figures["landmarks"] = figures["lines"].value_or(0.0) + figures["corners"].value_or(0.0);
    return figures;
}

ordered_json json_of(const std::optional<StudyPicture>& picture) {
    if (!picture) return {};
    return {{"files", picture->digest},
            {"x", picture->origin.x},
            {"y", picture->origin.y},
            {"m_per_pixel", picture->m_per_pixel}};
}

std::optional<StudyPicture> optional_picture(const ordered_json& json) {
    if (json.is_null()) return std::nullopt;
    return StudyPicture{json.at("files"), {json.at("x"), json.at("y")}, json.at("m_per_pixel")};
}

StudyRecord record_of(const ordered_json& json, const std::string& file) {
    StudyRecord record;
    record.ok = json.at("ok");
    record.problem = verbatim(json.at("problem"));
    if (record.ok) record.figures = figures_in(json, file);
    record.reference_found = whole_number<int>(json, "reference_found", file);
    record.scans = whole_number<std::uint64_t>(json, "scans", file);
    record.report = read_report(json.at("log"), file);
    record.report.scans = record.scans;
    record.seconds = json.at("seconds");
    record.cpu_seconds = json.at("cpu_seconds");
    record.stages = stages_in(json);
    record.state_bytes = json.value("state_bytes", std::size_t{0});
    record.map_digest = json.at("map");
    record.picture = optional_picture(json.at("picture"));
    if (json.contains("tour_doubts")) {
        for (const auto& doubt : json.at("tour_doubts"))
            record.tour_doubts.push_back(verbatim(doubt.get<std::string>()));
    }
    return record;
}

bool has_map(const StudyLayout& layout, const StudyPlan& plan, std::size_t run,
             const StudyRecord& record) {
    const fs::path map = map_file(layout, plan, run);
    return is_file(map) && Digest().add_file(map).text() == record.map_digest;
}

bool has_picture(const StudyLayout& layout, const StudyPlan& plan, std::size_t run,
                 const StudyRecord& record) {
    // A grid without a cell that was seen gives neither.
    if (!record.picture) return !record.figures["blur_m2"];
    return is_file(grid_file(layout, plan, run)) && is_file(path_file(layout, plan, run)) &&
           picture_digest(layout, plan, run) == record.picture->digest;
}

}  // namespace

void write_record(const StudyLayout& layout, const StudyPlan& plan, std::size_t run,
                  const StudyRecord& record) {
    ordered_json json{
        {"run", plan.run_digest(run)}, {"ok", record.ok}, {"problem", record.problem.english()}};
    for (const Measure* measure : taken_measures())
        json[measure->word] = hitos::json_of(record.figures[*measure], *measure);
    json.update({{"reference_found", record.reference_found},
                 {"scans", record.scans},
                 {"log", hitos::json_of(record.report, kExamples)},
                 {"seconds", record.seconds},
                 {"cpu_seconds", record.cpu_seconds},
                 {"stage_seconds", stages_json(record.stages)},
                 {"state_bytes", record.state_bytes},
                 {"map", record.map_digest},
                 {"picture", json_of(record.picture)}});
    for (const Message& doubt : record.tour_doubts) json["tour_doubts"].push_back(doubt.english());
    write_file(record_file(layout, plan, run), sealed(json));
}

std::optional<StudyRecord> read_record(const StudyLayout& layout, const StudyPlan& plan,
                                       std::size_t run) {
    const fs::path path = record_file(layout, plan, run);
    if (!is_file(path)) return std::nullopt;
    try {
        const std::string text = input::read_text(path, input::kLargestSettings);
        const auto json = parsed<ordered_json>(text, path.string());
        if (json.at("run") != plan.run_digest(run)) return std::nullopt;
        const StudyRecord record = record_of(json, path.string());
        if (!is_sealed(text, kStudySeal)) return std::nullopt;
        if (record.ok && !has_map(layout, plan, run, record)) return std::nullopt;
        if (record.ok && plan.pictured(run) && !has_picture(layout, plan, run, record)) {
            return std::nullopt;
        }
        return record;
    } catch (const nlohmann::json::exception&) {
        return std::nullopt;  // somebody else's hand was in it; the run is only done anew
    } catch (const FormatError&) {
        return std::nullopt;  // likewise
    }
}

void expect_no_record(const StudyLayout& layout, const StudyPlan& plan, std::size_t run) {
    const fs::path file = record_file(layout, plan, run);
    if (!is_file(file)) return;
    try {
        const std::string text = input::read_text(file, input::kLargestSettings);
        const auto json = parsed<ordered_json>(text, file.string());
        if (is_sealed(text, kStudySeal) && json.at("run") != plan.run_digest(run)) {
            return;  // of another study
        }
    } catch (const nlohmann::json::exception&) {
        // told below
    } catch (const FormatError&) {
        // likewise
    }
    throw FormatError(
        file.string(), 0,
        HITOS_TEXT(
            "Errors",
            "is damaged, was changed, or its map is missing; start the shard that it is of again"));
}

void copy_run(const StudyLayout& from, const StudyLayout& to, const StudyPlan& plan,
              std::size_t run, const StudyRecord& record) {
    const std::vector<fs::path> sources = run_files(from, plan, run);
    const std::vector<fs::path> targets = run_files(to, plan, run);
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const bool wanted = i == 0 || record.picture.has_value();  // the map is the first
        if (!wanted || !is_file(sources[i])) continue;
        write_file(targets[i], input::read_text(sources[i]));
    }
    write_record(to, plan, run, record);
}

}  // namespace study
}  // namespace hitos
