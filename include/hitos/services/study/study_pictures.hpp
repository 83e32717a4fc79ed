// SPDX-License-Identifier: GPL-3.0-or-later
// The grid map of one run of a study.
#pragma once

#include "hitos/services/drawing/contact_sheet.hpp"
#include "hitos/services/study/study_result.hpp"

namespace hitos {

/// Map and path as the run's files hold them, for runs that the plan pictures; value and measures
/// as caption. Without map where the run failed. Throws FileError and FormatError.
SheetTile study_tile(const StudyLayout& layout, const StudyPlan& plan, std::size_t run,
                     const StudyRecord& record);

}  // namespace hitos
