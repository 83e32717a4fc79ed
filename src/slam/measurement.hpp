// What a scan's features say as measurements with their covariances.
#pragma once

#include <cmath>
#include <vector>

#include "hitos/features/extractor.hpp"
#include "hitos/slam/params.hpp"
#include "hitos/slam/sensor.hpp"

namespace hitos {

/// z and its covariance R: (rho, theta) [m, rad] of a line, (range, bearing) [m, rad] of a corner.
struct Measurement {
    Vector2 z;
    Matrix2 r;
};

/// The squared Mahalanobis distance that two degrees of freedom stay below with that probability:
/// P(d^2 <= g) = 1 - exp(-g / 2).
inline double chi_square_gate(double probability) {
    return -2.0 * std::log1p(-probability);
}

/// Measurements of all features of an observation, in its order; R is the feature's own covariance
/// where the observation has it, else diag(var_rho, var_theta). Reused from scan to scan.
struct Measurements {
    std::vector<Measurement> lines;
    std::vector<Measurement> corners;

    std::size_t size() const { return lines.size() + corners.size(); }
    void take(const Observation& observation, const ObservationParams& params);
};

}  // namespace hitos
