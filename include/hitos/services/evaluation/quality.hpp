// SPDX-License-Identifier: GPL-3.0-or-later
// What a finished run is worth, judged without any truth.
#pragma once

#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <vector>

#include "hitos/capture/tour_finding.hpp"
#include "hitos/registration/registration.hpp"
#include "hitos/services/evaluation/run_evidence.hpp"
#include "hitos/services/evaluation/run_loops.hpp"
#include "hitos/services/evaluation/suitability.hpp"

namespace hitos {

class TourExamination;

/// What speaks for a run, or against it, without any truth.
struct RunQuality {
    /// Crispness of the map as MapCrispness has it, along the best path and along the odometry.
    std::optional<double> cells_per_point;
    std::optional<double> odometry_cells_per_point;
    std::optional<RegistrationFigures> registration;   ///< of a run that has one
    std::vector<RunLoop> loops;                        ///< likewise, the refused ones too
    std::vector<Advice> warnings;                      ///< why the map should not be trusted
    std::optional<std::vector<TourFinding>> findings;  ///< what looks wrong in the tour itself
};

/// Why path and map should not be trusted, as far as the run so far shows it.
std::vector<Advice> warnings(const RunEvidence& run);

/// What there is to doubt in a tour, as it is being looked for.
using DoubtsAhead = std::shared_future<std::vector<TourFinding>>;

/// By what was noted of the tour, besides what its reader has `told`: on a thread of its own where
/// a run may have so many threads (0: as many as there are), else when they are asked for.
DoubtsAhead doubts_of(std::shared_ptr<const TourExamination> examination,
                      std::vector<TourFinding> told, int threads);

/// All but the findings. `path` is the best one, with a pose for every scan. Reads the tour once
/// more. Once `stop` says so, crispness is left out: nobody knows it.
RunQuality judge(const RunEvidence& run, const Trajectory& path,
                 const std::function<bool()>& stop = {});
/// The findings too: nobody is told to do what the run does.
void take_findings(std::vector<TourFinding> findings, RunQuality& quality);

}  // namespace hitos
