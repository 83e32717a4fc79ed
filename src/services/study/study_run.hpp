// SPDX-License-Identifier: GPL-3.0-or-later
// What a run of a study is, and what it is measured by.
#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "evaluation/calibration.hpp"
#include "hitos/services/evaluation/position_error.hpp"
#include "hitos/services/run/algoritmo.hpp"
#include "hitos/services/study/study.hpp"

namespace hitos::study {

/// How the run's poses, and at its end its landmarks, lie in the filter's regions about them.
class RunCalibration {
  public:
    /// Nothing is counted where the tour does not know the truth.
    explicit RunCalibration(const TourReader& tour);
    /// After a step.
    void note(const Algoritmo& run);
    /// Of the finished run, with a reference map in the world's frame; null without truth.
    const Calibration* counted(const Algoritmo& run, const LandmarkMap& map, const Trajectory& path,
                               const LandmarkMap& reference);

  private:
    std::optional<PositionError> truth_;
    Calibration calibration_;
};

/// Whether the study's runs differ in how their tour is read.
bool varies_source(const StudyPlan& plan);
/// Whether this run says what there is to doubt about its tour: the first one of all that read it
/// alike.
bool looks_at_tour(const StudyPlan& plan, std::size_t number);
/// What a finished run that examined its tour has to doubt, and what can be done.
std::vector<Message> doubts_of_tour(const Algoritmo& run);

/// Writes the run's map (and grid and path, where it is pictured) and gives its record. Nothing
/// where the study was stopped before the grid's end.
std::optional<StudyRecord> measure_run(const Study& study, const StudyLayout& layout,
                                       const StudyPlan& plan, std::size_t number,
                                       const Algoritmo& run, RunCalibration& calibration,
                                       const std::stop_token& stop);

}  // namespace hitos::study
