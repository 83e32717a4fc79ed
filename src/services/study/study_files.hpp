// SPDX-License-Identifier: GPL-3.0-or-later
// The files of a study: their names, its plan, and a record for each run.
#pragma once

#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "hitos/base/digest.hpp"
#include "hitos/services/results/results.hpp"
#include "hitos/services/study/study_result.hpp"

namespace hitos::study {

/// Of one kind in a map, so that those of two kinds can be summed.
constexpr int kMostLandmarks = std::numeric_limits<int>::max() / 2;

std::filesystem::path plan_file(const StudyLayout& layout);
std::filesystem::path map_file(const StudyLayout& layout, const StudyPlan& plan, std::size_t run);
std::filesystem::path record_file(const StudyLayout& layout, const StudyPlan& plan,
                                  std::size_t run);

/// The run's grid map, as it is drawn on, and its path; of runs that are pictured.
std::filesystem::path grid_file(const StudyLayout& layout, const StudyPlan& plan, std::size_t run);
std::filesystem::path path_file(const StudyLayout& layout, const StudyPlan& plan, std::size_t run);
/// What the record of a pictured run states of the two.
std::string picture_digest(const StudyLayout& layout, const StudyPlan& plan, std::size_t run);

/// The files that the run can have, but for its record.
std::vector<std::filesystem::path> run_files(const StudyLayout& layout, const StudyPlan& plan,
                                             std::size_t run);
/// Whether a file of that name, which begins with the layout's prefix or is its quality file, can
/// be one of a study's tables, plots and pictures.
bool is_table(const StudyLayout& layout, const std::string& name);

/// Whether the file, named within the layout's folder, is of a run, not one of the tables.
bool is_of_run(const StudyLayout& layout, const std::string& name);

/// What study.json says beside the plan.
struct PlanState {
    bool finished = false;           ///< every run is done, and the tables are theirs
    std::vector<WrittenFile> files;  ///< but for those that hold times; none before the tables
};

/// The plan as study.json has it.
std::string plan_text(const StudyPlan& plan, const PlanState& state);
void write_plan(const StudyLayout& layout, const StudyPlan& plan, const PlanState& state = {});
/// Throws FileError, or FormatError where the file is none of Hitos, is damaged, or of an
/// impossible size.
StudyPlan read_plan(const StudyLayout& layout);
/// Throws as read_plan().
PlanState read_plan_state(const StudyLayout& layout);
/// Whether both are written the same.
bool same(const StudyPlan& a, const StudyPlan& b);

void write_record(const StudyLayout& layout, const StudyPlan& plan, std::size_t run,
                  const StudyRecord& record);

/// The run's record; nothing where there is none, where it is of other settings, or where it, its
/// map or what its picture is drawn of is missing or changed: then the run must be done anew.
std::optional<StudyRecord> read_record(const StudyLayout& layout, const StudyPlan& plan,
                                       std::size_t run);

/// Throws FormatError where the record of a run that read_record() knows nothing of is there.
void expect_no_record(const StudyLayout& layout, const StudyPlan& plan, std::size_t run);

/// Copies what one study folder has of the run to another, the record last.
void copy_run(const StudyLayout& from, const StudyLayout& to, const StudyPlan& plan,
              std::size_t run, const StudyRecord& record);

/// The text of a plan or record, sealed (run/written_files.hpp).
std::string sealed(const nlohmann::ordered_json& json);

}  // namespace hitos::study
