// SPDX-License-Identifier: GPL-3.0-or-later
// What a finished run is worth, judged without any truth.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "hitos/capture/tour_finding.hpp"
#include "hitos/registration/registration.hpp"
#include "hitos/services/evaluation/run_evidence.hpp"
#include "hitos/services/evaluation/run_loops.hpp"
#include "hitos/services/evaluation/suitability.hpp"

namespace hitos {

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

/// `path` is the best one, with a pose for every scan. Reads the tour once more. Once `stop` says
/// so, crispness and findings are left out: nobody knows them.
RunQuality judge(const RunEvidence& run, const Trajectory& path,
                 const std::function<bool()>& stop = {});

}  // namespace hitos
