#include "measurement.hpp"

namespace hitos {

void Measurements::take(const Observation& observation, const ObservationParams& params) {
    Matrix2 fixed;
    fixed << params.var_rho_m2, 0.0, 0.0, params.var_theta_rad2;
    lines.clear();
    for (std::size_t i = 0; i < observation.lines.size(); ++i) {
        lines.push_back(
            {SensorRecta::measurement(observation.lines[i].recta),
             observation.line_covariances.empty() ? fixed : observation.line_covariances[i]});
    }
    corners.clear();
    for (std::size_t i = 0; i < observation.corners.size(); ++i) {
        const Esquina& corner = observation.corners[i];
        Measurement measured{SensorEsquina::measurement(corner), fixed};
        // The bearing of a corner right at the robot means nothing.
        if (!observation.corner_covariances.empty() && measured.z(0) >= SensorEsquina::kNearest) {
            const Matrix2 j = SensorEsquina::jacobian({}, corner);  // of (range, bearing) by (x, y)
            measured.r = j * observation.corner_covariances[i] * j.transpose();
        }
        corners.push_back(measured);
    }
}

}  // namespace hitos
