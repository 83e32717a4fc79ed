#include "study_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>

#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/folder_entries.hpp"
#include "hitos/base/text_input.hpp"
#include "study_plot.hpp"

namespace hitos::study {
namespace {

using nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr const char* kPlanFormat = "hitos-study 2";

void make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error || !fs::is_directory(folder)) {
        throw FileError(folder.string(),
                        message(HITOS_TEXT("Errors", "cannot make this output folder: %1"),
                                error ? system_message(error.value())
                                      : message(HITOS_TEXT("Errors", "a file is in its place"))));
    }
}

std::string content_digest(const fs::path& path) {
    return Digest().add_file(path).text();
}

std::optional<double> optional_number(const ordered_json& value) {
    return value.is_null() ? std::nullopt : std::optional(value.get<double>());
}

ordered_json json_of(const std::optional<double>& value) {
    return value ? ordered_json(*value) : ordered_json();
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

std::string dumped(const ordered_json& json) {
    // Values from a command line may be no UTF-8.
    return json.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::string plan_text(const StudyPlan& plan) {
    ordered_json axes = ordered_json::array();
    for (const StudyPlan::Axis& axis : plan.axes) {
        axes.push_back({{"name", axis.name},
                        {"keys", axis.keys},
                        {"units", axis.units},
                        {"values", axis.values}});
    }
    return dumped({{"format", kPlanFormat},
                   {"parameters", axes},
                   {"first_seed", plan.first_seed},
                   {"seeds", plan.seeds},
                   {"source", plan.source},
                   {"setting", plan.setting},
                   {"digest", plan.digest},
                   {"reference_lines", plan.reference_lines},
                   {"reference_corners", plan.reference_corners},
                   {"grid", plan.grid},
                   {"pictures", word_of(plan.pictures)}});
}

/// Of AtomicFile. Whoever holds the study alone knows that no writer of one is left.
bool is_leftover(std::string_view name) {
    return name.starts_with(".hitos-") && (name.ends_with(".tmp") || name.ends_with("-plots"));
}

void remove_leftovers(const fs::path& folder) {
    std::error_code ignored;
    for (const fs::directory_entry& entry : folder_entries(folder, ignored)) {
        if (is_leftover(entry.path().filename().string())) fs::remove_all(entry.path(), ignored);
    }
}

}  // namespace

fs::path plan_file(const StudyLayout& layout) {
    return layout.file("study.json");
}

fs::path map_file(const StudyLayout& layout, const StudyPlan& plan, std::size_t run) {
    return layout.file("maps") / (plan.file_stem(run) + ".map");
}

fs::path record_file(const StudyLayout& layout, const StudyPlan& plan, std::size_t run) {
    return layout.file("runs") / (plan.file_stem(run) + ".json");
}

fs::path grid_file(const StudyLayout& layout, const StudyPlan& plan, std::size_t run) {
    return layout.file("runs") / (plan.file_stem(run) + ".png");
}

fs::path path_file(const StudyLayout& layout, const StudyPlan& plan, std::size_t run) {
    return layout.file("runs") / (plan.file_stem(run) + ".tum");
}

std::string picture_digest(const StudyLayout& layout, const StudyPlan& plan, std::size_t run) {
    return Digest()
        .add_file(grid_file(layout, plan, run))
        .add("path")
        .add_file(path_file(layout, plan, run))
        .text();
}

std::unique_ptr<FolderLock> keep(const StudyLayout& layout, const StudyPlan& plan, bool whole) {
    make_folder(layout.folder);
    const fs::path file = plan_file(layout);
    if (whole) return std::make_unique<FolderLock>(file);
    auto lock = std::make_unique<FolderLock>(file, FolderLock::Shared{});
    if (lock->alone()) return lock;
    // Who has written it is at work.
    if (read_plan(layout) == plan) return lock;
    throw FileError(file.string(),
                    message(HITOS_TEXT("Errors",
                                       "is the plan of another study, on which others are at work: "
                                       "program, configuration, log, values or seeds differ; wait "
                                       "for them or choose another folder")));
}

void prepare(const StudyLayout& layout, const StudyPlan& plan) {
    make_folder(layout.folder);
    make_folder(layout.file("maps"));
    make_folder(layout.file("runs"));
    // Destroyed without commit, the probe leaves nothing behind.
    AtomicFile(layout.quality_file()).write("");
    write_file(plan_file(layout), plan_text(plan));
}

StudyPlan read_plan(const StudyLayout& layout) {
    const fs::path path = plan_file(layout);
    const std::string text = input::read_text(path, input::kLargestSettings);
    try {
        const ordered_json json = ordered_json::parse(text);
        if (json.at("format") != kPlanFormat) {
            throw FormatError(path.string(), 0,
                              message(HITOS_TEXT("Errors", "expected format %1"), kPlanFormat));
        }
        StudyPlan plan;
        for (const ordered_json& axis : json.at("parameters")) {
            plan.axes.push_back({axis.at("name"), axis.at("keys"), axis.at("units"),
                                 axis.at("values").get<std::vector<StudyValue>>()});
        }
        plan.first_seed = json.at("first_seed");
        plan.seeds = json.at("seeds");
        plan.source = json.at("source");
        plan.setting = json.at("setting");
        plan.digest = json.at("digest");
        plan.reference_lines = json.at("reference_lines");
        plan.reference_corners = json.at("reference_corners");
        plan.grid = json.at("grid");
        plan.pictures = parse_study_pictures(json.at("pictures").get<std::string>(), path.string());
        const bool whole =
            std::all_of(plan.axes.begin(), plan.axes.end(), [](const StudyPlan::Axis& axis) {
                return axis.units.size() == axis.keys.size() && !axis.values.empty() &&
                       std::all_of(
                           axis.values.begin(), axis.values.end(),
                           [&](const StudyValue& v) { return v.size() == axis.keys.size(); });
            });
        if (plan.seeds < 1 || !whole) {
            throw FormatError(path.string(), 0,
                              message(HITOS_TEXT("Errors", "the plan is damaged")));
        }
        return plan;
    } catch (const nlohmann::json::exception& error) {
        throw FormatError(path.string(), 0,
                          message(HITOS_TEXT("Errors", "is no plan of a study: %1"), error.what()));
    }
}

namespace {

bool has_picture(const StudyLayout& layout, const StudyPlan& plan, std::size_t run,
                 const StudyRecord& record) {
    // A grid without a cell that was seen gives neither.
    if (!record.picture) return !record.blur_m2;
    std::error_code ignored;
    return fs::is_regular_file(grid_file(layout, plan, run), ignored) &&
           fs::is_regular_file(path_file(layout, plan, run), ignored) &&
           picture_digest(layout, plan, run) == record.picture->digest;
}

}  // namespace

void write_record(const StudyLayout& layout, const StudyPlan& plan, std::size_t run,
                  const StudyRecord& record) {
    const ordered_json json{{"run", plan.run_digest(run)},
                            {"ok", record.ok},
                            {"problem", record.problem.english()},
                            {"error_m", json_of(record.error_m)},
                            {"aligned_error_m", json_of(record.aligned_error_m)},
                            {"trajectory_error_m", json_of(record.trajectory_error_m)},
                            {"odometry_error_m", json_of(record.odometry_error_m)},
                            {"blur_m2", json_of(record.blur_m2)},
                            {"lines", record.lines},
                            {"corners", record.corners},
                            {"reference_found", record.reference_found},
                            {"scans", record.scans},
                            {"seconds", record.seconds},
                            {"cpu_seconds", record.cpu_seconds},
                            {"map", record.map_digest},
                            {"picture", json_of(record.picture)}};
    write_file(record_file(layout, plan, run), dumped(json));
}

std::optional<StudyRecord> read_record(const StudyLayout& layout, const StudyPlan& plan,
                                       std::size_t run) {
    const fs::path path = record_file(layout, plan, run);
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored)) return std::nullopt;
    try {
        const ordered_json json =
            ordered_json::parse(input::read_text(path, input::kLargestSettings));
        if (json.at("run") != plan.run_digest(run)) return std::nullopt;
        StudyRecord record;
        record.ok = json.at("ok");
        record.problem = verbatim(json.at("problem"));
        record.error_m = optional_number(json.at("error_m"));
        record.aligned_error_m = optional_number(json.at("aligned_error_m"));
        record.trajectory_error_m = optional_number(json.at("trajectory_error_m"));
        record.odometry_error_m = optional_number(json.at("odometry_error_m"));
        record.blur_m2 = optional_number(json.at("blur_m2"));
        record.lines = json.at("lines");
        record.corners = json.at("corners");
        record.reference_found = json.at("reference_found");
        record.scans = json.at("scans");
        record.seconds = json.at("seconds");
        record.cpu_seconds = json.at("cpu_seconds");
        record.map_digest = json.at("map");
        record.picture = optional_picture(json.at("picture"));
        const fs::path map = map_file(layout, plan, run);
        if (record.ok &&
            (!fs::is_regular_file(map, ignored) || content_digest(map) != record.map_digest)) {
            return std::nullopt;
        }
        if (record.ok && plan.pictured(run) && !has_picture(layout, plan, run, record)) {
            return std::nullopt;
        }
        return record;
    } catch (const nlohmann::json::exception&) {
        return std::nullopt;  // somebody else's hand was in it; the run is only done anew
    }
}

std::vector<std::pair<fs::path, std::string>> tables(const StudyLayout& layout,
                                                     const StudyPlan& plan,
                                                     std::span<const StudyRecord> records) {
    const std::vector<StudyCell> cells = summarize(plan, records);
    return {{layout.quality_file(), quality_csv(layout, plan, records)},
            {layout.file("summary.csv"), summary_csv(plan, cells)},
            {layout.file("summary.md"), summary_markdown(plan, cells)},
            {layout.file("summary.tex"), summary_latex(plan, cells)},
            {layout.file("timing.csv"), timing_csv(plan, records)}};
}

Message write_tables(const StudyLayout& layout, const StudyPlan& plan,
                     std::span<const StudyRecord> records) {
    for (const char* folder : {"maps", "runs"}) remove_leftovers(layout.file(folder));
    remove_leftovers(layout.folder);

    for (const auto& [file, text] : tables(layout, plan, records)) write_file(file, text);
    return write_plots(layout, plan, summarize(plan, records));
}

}  // namespace hitos::study
