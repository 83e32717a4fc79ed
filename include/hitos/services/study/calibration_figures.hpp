// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the regions that a filter gives hold the truth as often as they say, over several runs.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "hitos/base/translatable.hpp"
#include "hitos/services/evaluation/nees.hpp"
#include "hitos/services/study/study_result.hpp"

namespace hitos {

/// What a filter gives regions of.
struct CalibrationKind {
    const char* word;  ///< as measures' words begin: "pose"
    const char* name;  ///< HITOS_TEXT("Calibration", "poses")
};
inline constexpr std::array kCalibrationKinds{
    CalibrationKind{"pose", HITOS_TEXT("Calibration", "poses")},
    CalibrationKind{"landmark", HITOS_TEXT("Calibration", "landmarks")},
    CalibrationKind{"distance", HITOS_TEXT("Calibration", "distances")}};

/// The word of the measure: "pose_in_95".
std::string word_of_share(const CalibrationKind& kind, double region);
/// The shares of the truth in the regions of kRegions, as means over runs; nothing where it is not
/// known.
std::array<std::optional<double>, kRegions.size()> shares_in_regions(
    const ByMeasure<Spread>& figures, const CalibrationKind& kind);
bool has_shares(const ByMeasure<Spread>& figures, const CalibrationKind& kind);

/// The mean of the runs' NEES, and where it ought to lie.
struct NeesFigure {
    double mean = 0.0;
    int runs = 0;     ///< that have one
    int degrees = 0;  ///< its mean where the covariances tell the truth
    /// nees_interval() of one value a run. A run's own mean is of many values that hang together:
    /// it varies less than one of them, but nobody knows how much less. So what lies outside is not
    /// calibrated; what lies inside may be.
    NeesInterval interval;
};
std::optional<NeesFigure> nees_figure(const ByMeasure<Spread>& figures,
                                      const CalibrationKind& kind);

}  // namespace hitos
