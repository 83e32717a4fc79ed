// SPDX-License-Identifier: GPL-3.0-or-later
// What a scan's features say as measurements with their covariances.
#pragma once

#include <cmath>

#include "hitos/slam/params.hpp"
#include "models/landmark_kinds.hpp"

namespace hitos {

/// The squared Mahalanobis distance that two degrees of freedom stay below with that probability:
/// P(d^2 <= g) = 1 - exp(-g / 2).
inline double chi_square_gate(double probability) {
    return -2.0 * std::log1p(-probability);
}

/// Measurements of all features of an observation, kind by kind and in its order; R is the
/// feature's own covariance where the observation has it, else diag(var_rho, var_theta). Without
/// `known` identities are forgotten. Reused from scan to scan.
using Measurements = KindRow<Measurement>;

void measure(const Observation& observation, const ObservationParams& params, Measurements& out,
             bool known = true);

/// Between which points each feature was seen, in the same order; `sided`: and from which side.
void note_reaches(const Observation& observation, bool sided, KindRow<SeenReach>& out);

}  // namespace hitos
