// SPDX-License-Identifier: GPL-3.0-or-later
// How often the truth lies in a filter's regions, against how often it ought to.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "hitos/base/message.hpp"
#include "hitos/services/evaluation/run_measures.hpp"
#include "hitos/services/study/study_result.hpp"

namespace hitos::study {

/// The shares in the regions of 50, 68, 95 and 99 %, as means over runs.
struct CalibrationCurve {
    std::string name;
    const ByMeasure<Spread>* figures = nullptr;
};

/// The same of several rows: the mean of their means.
ByMeasure<Spread> mean_shares(std::span<const ByMeasure<Spread>* const> rows);

/// Writes calibration.dat and .gp with the layout's prefix, and .png and .svg where gnuplot is
/// installed: a panel each for poses, landmarks and distances, where any curve has them. Gives the
/// reason why there are no pictures; nothing is written, and none given, where there is no share.
Message write_calibration(const StudyLayout& layout, std::vector<CalibrationCurve> curves);

/// The stem of its files.
inline constexpr const char* kCalibrationPlot = "calibration";

}  // namespace hitos::study
