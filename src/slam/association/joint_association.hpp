// SPDX-License-Identifier: GPL-3.0-or-later
// Joint compatibility in a particle, whose landmarks are independent of each other.
#pragma once

#include <algorithm>
#include <span>
#include <utility>
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
    /// The next observation of `all` of its kind: its candidates are the landmarks inside the gate,
    /// but for those that another one says itself. One that says its landmark is not searched for.
    template <Sensor S, class Watch = Unwatched>
    void add(const Associator& associator, const typename S::Columns& landmarks, const Pose& pose,
             const PreparedObservation& observed, std::span<const SeenFeature> all = {},
             const Watch& watch = {}) {
        // Kinds must not be confused: each has landmarks 0, 1, …
        constexpr std::uint64_t kKind = static_cast<std::uint64_t>(LandmarkKinds::place<S>())
                                        << 32U;
        const std::int32_t identity = observed.seen.measured.identity;
        if (identity != kNameless && landmarks.identified(identity)) {
            known_.emplace_back(search_.observations(),
                                associator.decide<S>(landmarks, pose, observed, nullptr, watch));
            search_.add_observation();
            return;
        }
        const auto taken = [&](std::int32_t named) {
            return named != kNameless && std::ranges::any_of(all, [&](const SeenFeature& other) {
                       return other.measured.identity == named;
                   });
        };
        search_.add_observation();
        associator.for_each_candidate<S>(
            landmarks, pose, observed,
            [&](std::uint32_t landmark, const Likelihood& close) {
                if (taken(landmarks.record(landmark).identity)) return;
                search_.add({kKind | landmark, close.mahalanobis_squared,
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
    std::vector<std::pair<std::size_t, Decision>> known_;  // of observations that say it
    std::vector<double> logs_;  // of all candidates: ln of their likelihoods
};

}  // namespace hitos
