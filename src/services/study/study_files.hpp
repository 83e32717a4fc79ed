// The files by which a study remembers what was done: its plan and a record for each run.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "hitos/base/message.hpp"
#include "hitos/services/study/study_result.hpp"

struct XXH3_state_s;

namespace hitos::study {

/// XXH3, 128 bits: tells changed input from unchanged; no protection against forgery.
class Digest {
  public:
    Digest();
    /// The length goes in too, so that two texts are never taken for one.
    Digest& add(std::string_view text);
    Digest& add_file(const std::filesystem::path& path);
    std::string text() const;

  private:
    struct StateRelease {
        void operator()(XXH3_state_s* state) const;
    };
    void mix(std::string_view bytes);
    std::unique_ptr<XXH3_state_s, StateRelease> state_;
};

std::filesystem::path plan_file(const StudyLayout& layout);
std::filesystem::path map_file(const StudyLayout& layout, const StudyPlan& plan, std::size_t run);
std::filesystem::path record_file(const StudyLayout& layout, const StudyPlan& plan,
                                  std::size_t run);

/// The run's grid map, as it is drawn on, and its path; of runs that are pictured.
std::filesystem::path grid_file(const StudyLayout& layout, const StudyPlan& plan, std::size_t run);
std::filesystem::path path_file(const StudyLayout& layout, const StudyPlan& plan, std::size_t run);
/// What the record of a pictured run states of the two.
std::string picture_digest(const StudyLayout& layout, const StudyPlan& plan, std::size_t run);

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

/// Writes tables and plots and removes what a killed process left half-written. Gives the reason
/// why there are no plots, else an empty text.
Message write_tables(const StudyLayout& layout, const StudyPlan& plan,
                     std::span<const StudyRecord> records);

}  // namespace hitos::study
