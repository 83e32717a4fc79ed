// Whether a study's folder is whole, and its tables made anew of what is.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "hitos/services/study/study.hpp"

namespace hitos {

/// What is there of a study.
struct StudyCheck {
    std::size_t runs = 0;              ///< of the plan
    std::size_t failed = 0;            ///< whose record says why
    std::vector<std::string> missing;  ///< labels of runs that are not there, changed, or of
                                       ///< another plan
    std::vector<std::string> tables;   ///< files that are not there or not of these runs

    bool whole() const { return missing.empty() && tables.empty(); }
};

/// Whether the folder has a study's plan.
bool is_study(const StudyLayout& layout);

/// Compares every record with its map, by content, and the tables with the records. Throws
/// FileError where there is no plan, FormatError where it is none.
StudyCheck check_study(const StudyLayout& layout);

/// Makes tables, plots and pictures anew of the runs that are there; the others stand in them as
/// failed. The same command as before goes on with them. Throws as check_study(), and FileError
/// where somebody is at work there.
StudyOutcome recover_study(const StudyLayout& layout);

}  // namespace hitos
