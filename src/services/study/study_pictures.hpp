// SPDX-License-Identifier: GPL-3.0-or-later
// The grid maps of a study as pictures and on one contact sheet.
#pragma once

#include <span>
#include <string>

#include "hitos/base/message.hpp"
#include "hitos/services/study/study_result.hpp"

namespace hitos::study {

/// Draws pictures/ and contact-sheet.png in `out` from what the runs have left in `runs`. Gives the
/// reason why there is no sheet, else an empty text.
Message write_pictures(const StudyLayout& runs, const StudyLayout& out, const StudyPlan& plan,
                       std::span<const StudyRecord> records);

}  // namespace hitos::study
