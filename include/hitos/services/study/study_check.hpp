// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a study's folder is whole, and its tables made anew of what is.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "hitos/services/study/study.hpp"

namespace hitos {

/// What is there of a study.
struct StudyCheck {
    std::size_t runs = 0;                ///< of the plan
    std::size_t failed = 0;              ///< whose record says why
    std::vector<std::string> missing;    ///< labels of runs that are not there, changed, or of
                                         ///< another plan
    std::vector<std::string> changed;    ///< tables and pictures that are not there, or not as they
                                         ///< were written
    std::vector<std::string> left_over;  ///< of a study, but not of this one
    bool finished = false;               ///< the tables are of all runs
    bool interrupted = false;            ///< while files were put in place; recover_study() ends it
    bool another = false;  ///< one is under way, or was stopped, that will take this one's place

    bool whole() const {
        return finished && !interrupted && missing.empty() && changed.empty() && left_over.empty();
    }
};

/// Whether the folder has a study's plan.
bool is_study(const StudyLayout& layout);

/// Compares every record with its own digest and its map, the tables with the records, and all
/// files with the list in study.json, by content. Throws
/// FileError where there is no plan, FormatError where it is none.
StudyCheck check_study(const StudyLayout& layout);

/// Makes tables, plots and pictures anew of the runs that are there; the others stand in them as
/// failed. The same command as before goes on with them. Throws as check_study(), and FileError
/// where somebody is at work there.
StudyOutcome recover_study(const StudyLayout& layout);

}  // namespace hitos
