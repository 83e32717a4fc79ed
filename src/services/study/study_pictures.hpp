// The grid maps of a study as pictures and on one contact sheet.
#pragma once

#include <span>
#include <string>

#include "hitos/base/message.hpp"
#include "hitos/services/study/study_result.hpp"

namespace hitos::study {

/// Draws pictures/ and contact-sheet.png from what the runs have left, and removes those of an
/// earlier time that are no longer asked for. Gives the reason why there is no sheet, else an empty
/// text.
Message write_pictures(const StudyLayout& layout, const StudyPlan& plan,
                       std::span<const StudyRecord> records);

}  // namespace hitos::study
