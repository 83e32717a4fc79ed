// The files by which a study remembers what was done: its plan and a record for each run.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hitos/base/digest.hpp"
#include "hitos/base/folder_lock.hpp"
#include "hitos/base/message.hpp"
#include "hitos/services/study/study_result.hpp"

namespace hitos::study {

std::filesystem::path plan_file(const StudyLayout& layout);
std::filesystem::path map_file(const StudyLayout& layout, const StudyPlan& plan, std::size_t run);
std::filesystem::path record_file(const StudyLayout& layout, const StudyPlan& plan,
                                  std::size_t run);

/// The run's grid map, as it is drawn on, and its path; of runs that are pictured.
std::filesystem::path grid_file(const StudyLayout& layout, const StudyPlan& plan, std::size_t run);
std::filesystem::path path_file(const StudyLayout& layout, const StudyPlan& plan, std::size_t run);
/// What the record of a pictured run states of the two.
std::string picture_digest(const StudyLayout& layout, const StudyPlan& plan, std::size_t run);

/// Keeps the study for this process, alone or (a shard) together with others that work on the same
/// plan. Throws FileError where others are at work that may not be there: any others of a whole
/// study, those on another plan of a shard.
std::unique_ptr<FolderLock> keep(const StudyLayout& layout, const StudyPlan& plan, bool whole);

/// Makes the folders and the plan file. Throws FileError.
void prepare(const StudyLayout& layout, const StudyPlan& plan);

/// Throws FileError, or FormatError where the file is none of Hitos.
StudyPlan read_plan(const StudyLayout& layout);

void write_record(const StudyLayout& layout, const StudyPlan& plan, std::size_t run,
                  const StudyRecord& record);

/// The run's record; nothing where there is none, where it is of other settings, or where its map
/// or what its picture is drawn of is missing or changed: then the run must be done anew.
std::optional<StudyRecord> read_record(const StudyLayout& layout, const StudyPlan& plan,
                                       std::size_t run);

/// The tables of a study, which its records decide to the last byte.
std::vector<std::pair<std::filesystem::path, std::string>> tables(
    const StudyLayout& layout, const StudyPlan& plan, std::span<const StudyRecord> records);

/// Writes tables and plots and removes what a killed process left half-written. Gives the reason
/// why there are no plots, else an empty text.
Message write_tables(const StudyLayout& layout, const StudyPlan& plan,
                     std::span<const StudyRecord> records);

}  // namespace hitos::study
