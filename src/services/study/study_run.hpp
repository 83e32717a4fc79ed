// What a run of a study is, and what it is measured by.
#pragma once

#include <optional>
#include <stop_token>

#include "evaluation/calibration.hpp"
#include "hitos/services/run/algoritmo.hpp"
#include "hitos/services/study/study.hpp"

namespace hitos::study {

/// Sets what the filter says of the newest scan's pose against the truth.
void note_pose(Calibration& calibration, const Algoritmo& run, const Trajectory& truth);

/// Writes the run's map (and grid and path, where it is pictured) and gives its record. Nothing
/// where the study was stopped before the grid's end.
std::optional<StudyRecord> measure_run(const Study& study, const StudyLayout& layout,
                                       const StudyPlan& plan, std::size_t number,
                                       const Algoritmo& run, Calibration& calibration,
                                       const std::stop_token& stop);

}  // namespace hitos::study
