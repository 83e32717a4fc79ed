// SPDX-License-Identifier: GPL-3.0-or-later
// What a study keeps of itself, and how it is asked for.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "hitos/services/study/study.hpp"
#include "hitos/services/study/study_check.hpp"
#include "json_input.hpp"
#include "laws.hpp"
#include "study/study_files.hpp"
#include "targets.hpp"

namespace hitos::fuzz {
namespace {

/// The text with the checksum that it must have: else nearly nothing would be read any farther.
std::string with_seal(std::string_view input) {
    std::string text(input);
    try {
        auto json = parsed<nlohmann::ordered_json>(text, "input");
        if (!json.is_object()) return text;
        json.erase("checksum");
        return study::sealed(json);
    } catch (const std::exception&) {
        return text;
    }
}

/// A study of one run, whose map is there.
class StudyOfOneRun {
  public:
    StudyOfOneRun() : layout_(study_in_folder(folder_.path())) {
        plan_.axes.push_back({"dmax", {"split_merge.dmax"}, {"m"}, {{"0.02"}}});
        plan_.seeds = 1;
        plan_.source = "some.log";
        plan_.digest = "a study of one run";
        std::filesystem::create_directory(layout_.file("runs"));
        study::write_plan(layout_, plan_);
        folder_.put("maps/" + plan_.file_stem(0) + ".map", "rho: 1 theta: 90\n");
        record_ = study::record_file(layout_, plan_, 0);
    }
    std::optional<StudyRecord> read(std::string_view text) const {
        folder_.put(record_.lexically_relative(folder_.path()).string(), text);
        return study::read_record(layout_, plan_, 0);
    }
    std::optional<StudyRecord> read_back(const StudyRecord& record) const {
        study::write_record(layout_, plan_, 0, record);
        return study::read_record(layout_, plan_, 0);
    }

  private:
    ScratchFolder folder_;
    StudyLayout layout_;
    StudyPlan plan_;
    std::filesystem::path record_;
};

void require_sound(const StudyRecord& record) {
    for (const Measure* measure : taken_measures()) {
        const std::optional<double>& figure = record.figures[*measure];
        require(is_finite_if_any(figure), "a record's figures are finite");
        require(!figure || !measure->is_count() || *figure >= 0.0, "a record counts from 0");
    }
    require(record.reference_found >= 0, "a record counts from 0");
}

bool equal(const StudyRecord& a, const StudyRecord& b) {
    return a.ok == b.ok && a.problem.english() == b.problem.english() && a.figures == b.figures &&
           a.reference_found == b.reference_found && a.scans == b.scans && a.seconds == b.seconds &&
           a.cpu_seconds == b.cpu_seconds && a.map_digest == b.map_digest &&
           a.picture.has_value() == b.picture.has_value();
}

/// Of the fields of a value; a range gives values of its own.
void require_sound(const StudyParameter& parameter) {
    require(!parameter.values.empty(), "a parameter of a study has values");
    require(std::ranges::all_of(
                parameter.values,
                [&](const StudyValue& value) { return value.size() == parameter.keys.size(); }),
            "a value has a component for every key");
}

}  // namespace

bool check_study_plan(std::string_view input) {
    static const ScratchFolder scratch;
    static const ScratchFolder copied;
    const StudyLayout layout = study_in_folder(scratch.path());
    scratch.put("study.json", with_seal(input));
    const auto plan = unless_refused([&] { return study::read_plan(layout); });
    if (!plan) return false;
    constexpr std::size_t kMostRuns = 1000000;
    require(plan->runs() > 0 && plan->runs() <= kMostRuns, "a plan has a number of runs");
    require(plan->label(plan->runs() - 1) != plan->label(0) || plan->runs() == 1,
            "runs have labels of their own");
    require(!plan->file_stem(0).empty() && !plan->run_digest(0).empty(), "runs have files");
    const StudyLayout copy = study_in_folder(copied.path());
    study::write_plan(copy, *plan);
    require(study::read_plan(copy) == *plan, "a plan reads back");
    constexpr std::size_t kFewRuns = 20;
    if (plan->runs() > kFewRuns) return true;
    const auto check = unless_refused([&] { return check_study(layout); });
    require(!check || (check->runs == plan->runs() && check->missing.size() == check->runs),
            "a study without a run is not whole");
    return true;
}

bool check_study_record(std::string_view input) {
    static const StudyOfOneRun study_of_one;
    const std::optional<StudyRecord> record = study_of_one.read(with_seal(input));
    if (!record) return false;
    require_sound(*record);
    const std::optional<StudyRecord> again = study_of_one.read_back(*record);
    require(again && equal(*record, *again), "a record reads back");
    return true;
}

bool check_study_values(std::string_view input) {
    const auto parameter = unless_refused([&] { return parse_study_parameter(input); });
    if (parameter) require_sound(*parameter);
    const auto values = unless_refused([&] { return expand_range(input); });
    require(!values || !values->empty(), "a range has values");
    const auto shard = unless_refused([&] { return parse_shard(input); });
    require(!shard || (shard->index >= 1 && shard->index <= shard->count),
            "a shard is one of its study's");
    return parameter || values || shard;
}

}  // namespace hitos::fuzz
