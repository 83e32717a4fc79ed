#include "hitos/services/study/study_check.hpp"

#include <system_error>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "study_files.hpp"
#include "study_pictures.hpp"

namespace hitos {
namespace {

/// Run by run; those that are not there are not ok and say so.
std::vector<StudyRecord> records_of(const StudyLayout& layout, const StudyPlan& plan,
                                    std::vector<std::string>& missing) {
    std::vector<StudyRecord> records;
    records.reserve(plan.runs());
    for (std::size_t run = 0; run < plan.runs(); ++run) {
        auto record = study::read_record(layout, plan, run);
        if (!record) {
            missing.push_back(plan.label(run));
            record.emplace().problem = message(HITOS_TEXT("Errors", "the run is not there"));
        }
        records.push_back(*std::move(record));
    }
    return records;
}

bool holds(const std::filesystem::path& file, const std::string& text) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(file, ignored) && input::read_text(file) == text;
}

}  // namespace

bool is_study(const StudyLayout& layout) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(study::plan_file(layout), ignored);
}

StudyCheck check_study(const StudyLayout& layout) {
    const StudyPlan plan = study::read_plan(layout);
    StudyCheck check;
    check.runs = plan.runs();
    const std::vector<StudyRecord> records = records_of(layout, plan, check.missing);
    for (const StudyRecord& record : records) check.failed += record.ok ? 0 : 1;
    check.failed -= check.missing.size();
    for (const auto& [file, text] : study::tables(layout, plan, records)) {
        if (!holds(file, text)) check.tables.push_back(file.filename().string());
    }
    return check;
}

StudyOutcome recover_study(const StudyLayout& layout) {
    StudyOutcome outcome;
    outcome.plan = study::read_plan(layout);
    const auto lock = study::keep(layout, outcome.plan, true);
    std::vector<std::string> missing;
    outcome.records = records_of(layout, outcome.plan, missing);
    for (const StudyRecord& record : outcome.records)
        ++(record.ok ? outcome.reused : outcome.failed);
    outcome.plot_problem = study::write_tables(layout, outcome.plan, outcome.records);
    outcome.picture_problem = study::write_pictures(layout, outcome.plan, outcome.records);
    return outcome;
}

}  // namespace hitos
