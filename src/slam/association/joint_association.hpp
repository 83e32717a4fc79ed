// Joint compatibility in a particle, whose landmarks are independent of each other.
#pragma once

#include <span>
#include <vector>

#include "association.hpp"
#include "joint_compatibility.hpp"

namespace hitos {

/// Decides for all observations of a scan at once. Given the particle's pose its landmarks are
/// independent, so that the distances of single pairings add up to the joint one. An observation
/// that fits landmarks but gets none, since others fit them better together, is kept out of the
/// map; its weight is that of an ambiguous one. Reused from particle to particle.
class JointAssociation {
  public:
    /// Forgets all observations.
    void begin(double probability);
    /// The next observation: its candidates are the landmarks inside the gate.
    template <Sensor S, class Watch = Unwatched>
    void add(const Associator& associator, const typename S::Columns& landmarks, const Pose& pose,
             const PreparedObservation& observed, const Watch& watch = {}) {
        // Kinds must not be confused: each has landmarks 0, 1, …
        constexpr std::uint64_t kKind = static_cast<std::uint64_t>(LandmarkKinds::place<S>())
                                        << 32U;
        search_.add_observation();
        const bool known = observed.seen.measured.identity != kNameless;  // then nothing speaks
                                                                          // against it
        associator.for_each_candidate<S>(
            landmarks, pose, observed,
            [&](std::uint32_t landmark, const Likelihood& close) {
                search_.add({kKind | landmark, known ? 0.0 : close.mahalanobis_squared,
                             static_cast<std::uint32_t>(logs_.size())});
                logs_.push_back(close.log_likelihood);
            },
            watch);
    }
    /// One decision for each observation, in their order. False where the search was cut.
    bool decide(const Associator& associator, std::span<Decision> decisions);

  private:
    JointSearch search_;
    IndependentDistance distance_;
    std::vector<double> logs_;  // of all candidates: ln of their likelihoods
};

}  // namespace hitos
