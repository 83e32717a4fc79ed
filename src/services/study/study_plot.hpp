// SPDX-License-Identifier: GPL-3.0-or-later
// Plots of a study's summary, drawn by gnuplot.
#pragma once

#include <span>
#include <string>

#include "hitos/base/message.hpp"
#include "hitos/services/study/study_result.hpp"

namespace hitos::study {

/// Writes the measures that have a plot, where they were taken, such as error and landmarks (.dat,
/// .gp, and .png and .svg where gnuplot is installed) against the first parameter, one curve for
/// each value of the second. Gives the reason why there are no pictures, else an empty text; a
/// study without parameter has none and needs none.
Message write_plots(const StudyLayout& layout, const StudyPlan& plan,
                    std::span<const StudyCell> cells);

/// Whether write_plots() can write a file of that name.
bool is_plot(const std::string& name);

}  // namespace hitos::study
