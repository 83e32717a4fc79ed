// Which landmark an observation belongs to [T ch. 5].
#pragma once

#include <cstdint>

#include "hitos/slam/params.hpp"
#include "hitos/slam/slam_filter.hpp"
#include "map_store.hpp"
#include "measurement.hpp"

namespace hitos {

/// The decision for one observation in one particle.
struct Decision {
    Association::Outcome outcome = Association::Outcome::created;
    std::uint32_t landmark = 0;   ///< where matched
    double log_likelihood = 0.0;  ///< factor of the particle's weight, in logarithm
};

/// An observation, the same for all particles.
struct SeenFeature {
    Measurement measured;
    double slack = 0.0;  ///< squared Mahalanobis distance from which no landmark can be it
};

/// An observation prepared for a particle: with its direction in the world, for the quick
/// rejection.
struct PreparedObservation {
    const SeenFeature& seen;
    double cos_world = 1.0;  ///< of the line's normal, or of the corner's bearing, in the world
    double sin_world = 0.0;
};

/// Decides by maximum likelihood [T table 5.1] or by the nearest landmark in a chi-square gate
/// [T 5.3], with the rule for ambiguous observations of AssociationParams.
class Associator {
  public:
    explicit Associator(const AssociationParams& params);

    SeenFeature seen(const Measurement& measured) const;

    Decision decide(const LineColumns& lines, const Pose& pose,
                    const PreparedObservation& observed) const;
    Decision decide(const CornerColumns& corners, const Pose& pose,
                    const PreparedObservation& observed) const;

  private:
    template <class Filter, class Columns>
    Decision decide_among(const Columns& landmarks, const Pose& pose,
                          const PreparedObservation& observed) const;
    Decision resolve(std::uint32_t best, double best_log, double second_log) const;

    AssociationParams params_;
    double log_p0_;
    double log_ratio_;
    double gate_;  ///< squared Mahalanobis distance of the chi-square gate
};

}  // namespace hitos
