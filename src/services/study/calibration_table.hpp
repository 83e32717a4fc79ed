// SPDX-License-Identifier: GPL-3.0-or-later
// A filter's calibration as a table below that of a study or benchmark.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hitos/base/text_table.hpp"
#include "hitos/services/study/calibration_figures.hpp"

namespace hitos::study {

/// A row of the table above, with the fields that say which it is.
struct CalibrationRow {
    std::vector<std::string> keys;
    const ByMeasure<Spread>* figures = nullptr;
};

/// Up to three rows for each: poses, landmarks, distances, where they were taken. Without rows
/// where nothing was.
TextTable calibration_table(std::vector<std::string> keys, std::span<const CalibrationRow> rows);

/// What it says, in one line.
inline constexpr const char* kCalibrationWords =
    "Calibration: shares of the truth in the filter's regions, and its squared error in units of "
    "the covariance (NEES). Where covariances tell the truth, the mean of one value a run lies "
    "between the two limits in 95 of 100 rows (chi-square). That of a run's many values, which "
    "hang together, varies less: what lies outside is not calibrated, what lies within may be.";

/// The words, behind what makes a remark of them, and the table in that form, with an empty line
/// before each; empty where there are no rows.
std::string below(const TextTable& table, std::string (*form)(const TextTable&),
                  const char* remark = "");

/// For tables of programs: the columns "pose_nees_low", "pose_nees_high" and their fields, of the
/// kinds that any of `all` has.
class IntervalColumns {
  public:
    explicit IntervalColumns(std::span<const ByMeasure<Spread>* const> all);
    std::vector<std::pair<std::string, std::string>> of(const ByMeasure<Spread>& figures) const;

  private:
    std::vector<const CalibrationKind*> kinds_;
};

}  // namespace hitos::study
