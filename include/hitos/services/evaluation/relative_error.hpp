// SPDX-License-Identifier: GPL-3.0-or-later
// The relative pose error of a trajectory.
#pragma once

#include <optional>

#include "hitos/services/evaluation/error_figures.hpp"
#include "hitos/services/evaluation/measures.hpp"
#include "hitos/services/evaluation/pose_pairs.hpp"

namespace hitos {

/// The relative pose error (J. Sturm et al., "A benchmark for the evaluation of RGB-D SLAM
/// systems", IROS 2012): of each pair (i, j) of poses E = (Qi⁻¹ Qj)⁻¹ (Pi⁻¹ Pj), with Q the
/// reference and P the estimate; its translation [m] and the absolute value of its angle [rad].
struct RelativeError {
    int poses = 0;  ///< of the estimate that have one of the reference at their stamp
    int pairs = 0;
    ErrorFigures translation_m;
    ErrorFigures rotation_rad;
};

/// The poses are paired by stamp as trajectory_error() pairs them; of those, in the order of their
/// stamps, the pairs are what pose_pairs() takes of the estimate. Nothing where there is no pair,
/// or where the reference has no headings (ReferenceFit::headings).
std::optional<RelativeError> relative_error(const Trajectory& estimate, const Trajectory& reference,
                                            const PairSpacing& spacing,
                                            double tolerance_s = kSameStamp);

}  // namespace hitos
