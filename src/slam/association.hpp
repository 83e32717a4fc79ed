// Which landmark an observation belongs to [T ch. 5].
#pragma once

#include <cstdint>

#include "hitos/slam/ekf.hpp"
#include "hitos/slam/params.hpp"
#include "hitos/slam/slam_filter.hpp"
#include "landmark_store.hpp"

namespace hitos {

/// The decision for one observation in one particle.
struct Decision {
    Association::Outcome outcome = Association::Outcome::created;
    std::uint32_t landmark = 0;   ///< where matched
    double log_likelihood = 0.0;  ///< factor of the particle's weight, in logarithm
};

/// An observation prepared for a particle: the measurement and, for the quick rejection, its
/// direction in the world.
struct PreparedObservation {
    Vector2 z;
    double cos_world = 1.0;  ///< of the line's normal, or of the corner's bearing, in the world
    double sin_world = 0.0;
};

/// Decides by maximum likelihood [T table 5.1] or by the nearest landmark in a chi-square gate
/// [T 5.3], with the rule for ambiguous observations of AssociationParams.
class Associator {
  public:
    explicit Associator(const AssociationParams& params, const ObservationParams& observation);

    Decision decide(const LineColumns& lines, const Pose& pose,
                    const PreparedObservation& observed) const;
    Decision decide(const CornerColumns& corners, const Pose& pose,
                    const PreparedObservation& observed) const;

    const EKF<SensorRecta>& line_ekf() const { return line_ekf_; }
    const EKF<SensorEsquina>& corner_ekf() const { return corner_ekf_; }

  private:
    template <class Columns, class Filter>
    Decision decide_among(const Columns& landmarks, const Filter& ekf, const Pose& pose,
                          const PreparedObservation& observed) const;
    Decision resolve(std::uint32_t best, double best_log, double second_log) const;

    AssociationParams params_;
    EKF<SensorRecta> line_ekf_;
    EKF<SensorEsquina> corner_ekf_;
    double var0_;
    double var1_;
    double log_p0_;
    double log_ratio_;
    double gate_;   ///< squared Mahalanobis distance of the chi-square gate
    double slack_;  ///< squared Mahalanobis distance from which a landmark is out of the question
};

}  // namespace hitos
