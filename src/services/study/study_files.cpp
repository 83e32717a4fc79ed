// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_files.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "json_input.hpp"
#include "results/written_files.hpp"
#include "study_plot.hpp"

namespace hitos::study {
namespace {

using nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr const char* kPlanFormat = "hitos-study 3";

/// Whether there are runs, and the lists of values fit the keys.
bool is_consistent(const StudyPlan& plan) {
    return plan.seeds >= 1 && std::ranges::all_of(plan.axes, [](const StudyPlan::Axis& axis) {
               return axis.units.size() == axis.keys.size() && !axis.values.empty() &&
                      std::ranges::all_of(axis.values, [&](const StudyValue& value) {
                          return value.size() == axis.keys.size();
                      });
           });
}

StudyPlan plan_of(const ordered_json& json, const fs::path& path) {
    StudyPlan plan;
    for (const ordered_json& axis : json.at("parameters")) {
        plan.axes.push_back({axis.at("name"), axis.at("keys"), axis.at("units"),
                             axis.at("values").get<std::vector<StudyValue>>()});
    }
    const std::string file = path.string();
    plan.first_seed = whole_number<std::uint64_t>(json, "first_seed", file, 0,
                                                  std::numeric_limits<std::int64_t>::max());
    plan.seeds = whole_number<int>(json, "seeds", file);
    plan.source = json.at("source");
    plan.setting = json.at("setting");
    plan.digest = json.at("digest");
    plan.reference_lines = whole_number<int>(json, "reference_lines", file, 0, kMostLandmarks);
    plan.reference_corners = whole_number<int>(json, "reference_corners", file, 0, kMostLandmarks);
    plan.grid = json.at("grid");
    plan.pictures = parse_study_pictures(json.at("pictures").get<std::string>(), path.string());
    return plan;
}

/// What `read` finds in study.json.
template <class Read>
auto with_plan(const StudyLayout& layout, Read read) {
    const fs::path path = plan_file(layout);
    const std::string text = input::read_text(path, input::kLargestSettings);
    try {
        const auto json = parsed<ordered_json>(text, path.string());
        if (json.at("format") != kPlanFormat) {
            throw FormatError(path.string(), 0, HITOS_TEXT("Errors", "expected format %1"),
                              kPlanFormat);
        }
        const StudyPlan plan = plan_of(json, path);
        const bool sound = is_consistent(plan);
        if (sound && !plan.is_possible()) {
            throw FormatError(
                path.string(), 0,
                HITOS_TEXT("Errors", "is a plan of more than %1 runs; the plan is damaged"),
                StudyPlan::kMostRuns);
        }
        if (!sound || !is_sealed(text, kStudySeal)) {
            throw FormatError(path.string(), 0, HITOS_TEXT("Errors", "the plan is damaged"));
        }
        return read(json, plan);
    } catch (const nlohmann::json::exception& error) {
        throw FormatError(path.string(), 0, HITOS_TEXT("Errors", "is no plan of a study: %1"),
                          error.what());
    }
}

fs::path of_run(const StudyLayout& layout, const char* folder, const StudyPlan& plan,
                std::size_t run, const char* extension) {
    return layout.file(folder) / (plan.file_stem(run) + extension);
}

}  // namespace

fs::path plan_file(const StudyLayout& layout) {
    return layout.file("study.json");
}

fs::path map_file(const StudyLayout& layout, const StudyPlan& plan, std::size_t run) {
    return of_run(layout, "maps", plan, run, ".map");
}

fs::path record_file(const StudyLayout& layout, const StudyPlan& plan, std::size_t run) {
    return of_run(layout, "runs", plan, run, ".json");
}

fs::path grid_file(const StudyLayout& layout, const StudyPlan& plan, std::size_t run) {
    return of_run(layout, "runs", plan, run, ".png");
}

fs::path path_file(const StudyLayout& layout, const StudyPlan& plan, std::size_t run) {
    return of_run(layout, "runs", plan, run, ".tum");
}

std::string picture_digest(const StudyLayout& layout, const StudyPlan& plan, std::size_t run) {
    return Digest()
        .add_file(grid_file(layout, plan, run))
        .add("path")
        .add_file(path_file(layout, plan, run))
        .text();
}

std::vector<fs::path> run_files(const StudyLayout& layout, const StudyPlan& plan, std::size_t run) {
    return {map_file(layout, plan, run), grid_file(layout, plan, run),
            path_file(layout, plan, run)};
}

bool is_table(const StudyLayout& layout, const std::string& name) {
    if (name == layout.quality) return true;
    if (!name.starts_with(layout.prefix)) return false;
    static constexpr std::array<std::string_view, 5> kTables{
        "summary.csv", "summary.md", "summary.tex", "timing.csv", "contact-sheet.png"};
    const std::string word = name.substr(layout.prefix.size());
    return std::ranges::count(kTables, word) > 0 || is_plot(word);
}

bool is_of_run(const StudyLayout& layout, const std::string& name) {
    return name.starts_with(layout.prefix + "maps/") || name.starts_with(layout.prefix + "runs/");
}

std::string plan_text(const StudyPlan& plan, const PlanState& state) {
    ordered_json axes = ordered_json::array();
    for (const StudyPlan::Axis& axis : plan.axes) {
        axes.push_back({{"name", axis.name},
                        {"keys", axis.keys},
                        {"units", axis.units},
                        {"values", axis.values}});
    }
    return sealed({{"format", kPlanFormat},
                   {"parameters", axes},
                   {"first_seed", plan.first_seed},
                   {"seeds", plan.seeds},
                   {"source", plan.source},
                   {"setting", plan.setting},
                   {"digest", plan.digest},
                   {"reference_lines", plan.reference_lines},
                   {"reference_corners", plan.reference_corners},
                   {"grid", plan.grid},
                   {"pictures", word_of(plan.pictures)},
                   {"finished", state.finished},
                   {"files", json_of(state.files)}});
}

void write_plan(const StudyLayout& layout, const StudyPlan& plan, const PlanState& state) {
    write_file(plan_file(layout), plan_text(plan, state));
}

StudyPlan read_plan(const StudyLayout& layout) {
    return with_plan(layout, [](const ordered_json&, const StudyPlan& plan) { return plan; });
}

PlanState read_plan_state(const StudyLayout& layout) {
    return with_plan(layout, [&](const ordered_json& json, const StudyPlan&) {
        return PlanState{json.at("finished"), files_named(json, plan_file(layout), true)};
    });
}

bool same(const StudyPlan& a, const StudyPlan& b) {
    return plan_text(a, {}) == plan_text(b, {});
}

std::string sealed(const ordered_json& json) {
    return hitos::sealed(json_text(json, 1) + "\n", kStudySeal);
}

}  // namespace hitos::study
