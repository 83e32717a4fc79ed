// SPDX-License-Identifier: GPL-3.0-or-later
// Which landmark an observation belongs to [T ch. 5].
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "hitos/base/random_stream.hpp"
#include "hitos/slam/association_record.hpp"
#include "hitos/slam/params.hpp"
#include "measurement.hpp"
#include "models/ekf.hpp"

namespace hitos {

/// The two candidates that matter for an observation: the best by the method's score, and the
/// greatest likelihood among all others.
class BestTwo {
  public:
    static constexpr double kNothing = -std::numeric_limits<double>::infinity();

    /// Takes a landmark in; true where it is the best so far. Of two that score the same the first
    /// stays.
    bool offer(std::uint32_t landmark, double score, double log_likelihood) {
        if (!(score > score_)) {
            second_log_ = std::max(second_log_, log_likelihood);
            return false;
        }
        second_log_ = std::max(second_log_, best_log_);
        best_ = landmark;
        score_ = score;
        best_log_ = log_likelihood;
        return true;
    }
    bool none() const { return score_ == kNothing; }
    std::uint32_t best() const { return best_; }
    double best_log() const { return best_log_; }      ///< ln likelihood of the best
    double second_log() const { return second_log_; }  ///< -infinity where there is no other

  private:
    std::uint32_t best_ = 0;
    double score_ = kNothing;
    double best_log_ = kNothing;
    double second_log_ = kNothing;
};

/// An observation as each_near() of the columns takes it.
inline PreparedObservation prepare(const SeenFeature& seen, const Pose& pose) {
    const auto [sine, cosine] = elementary::sine_cosine(pose.theta);
    const NearQuery query = turned(near_query({seen, seen.cosine, seen.sine}), cosine, sine);
    return {seen, query.cos_world, query.sin_world};
}

/// What is the same in every filter: the gate of [T 5.3] and what is ambiguous [T 5.4.2, SPEC 5].
class AssociationRule {
  public:
    explicit AssociationRule(const AssociationParams& params);

    /// Squared Mahalanobis distance of the chi-square gate.
    double gate() const { return gate_; }
    /// Whether both candidates are plausible: the second likelihood is above a share of the best,
    /// and above that of a new landmark where the filter has one (`least_log` is its logarithm).
    bool ambiguous(const BestTwo& candidates, double least_log = BestTwo::kNothing) const {
        return enabled_ && candidates.second_log() > least_log &&
               candidates.second_log() > candidates.best_log() + log_ratio_;
    }

  private:
    double gate_;
    double log_ratio_;
    bool enabled_;
};

/// The decision for one observation in one particle.
struct Decision {
    Association::Outcome outcome = Association::Outcome::created;
    Association::Reason reason = Association::Reason::fits_none;
    std::uint32_t landmark = 0;   ///< where matched
    double log_likelihood = 0.0;  ///< factor of the particle's weight, in logarithm
    std::uint32_t unseen = 0;     ///< as Association's, once the landmark is updated
};

/// Sees nothing of the comparisons.
struct Unwatched {
    static constexpr bool kWatches = false;
    Unwatched feature(std::size_t /*place*/) const { return {}; }
};

/// Records the comparisons of one hypothesis, landmarks by their places in their kind.
class Watched {
  public:
    static constexpr bool kWatches = true;
    class Feature {
      public:
        static constexpr bool kWatches = true;
        explicit Feature(std::vector<ComparedLandmark>& compared) : compared_(compared) {}
        void note(std::size_t landmark, const Vector2& nu, const Likelihood& close,
                  Standing standing) const {
            compared_.push_back({static_cast<std::int32_t>(landmark), nu, close.mahalanobis_squared,
                                 close.log_likelihood, standing});
        }

      private:
        std::vector<ComparedLandmark>& compared_;
    };

    explicit Watched(std::vector<RecordedFeature>& features) : features_(features) {}
    Feature feature(std::size_t place) const { return Feature(features_[place].compared); }

  private:
    std::vector<RecordedFeature>& features_;
};

/// Decides by maximum likelihood [T table 5.1] or by the nearest landmark in a chi-square gate
/// [T 5.3], with the rule for ambiguous observations of AssociationParams.
class Associator {
  public:
    explicit Associator(const AssociationParams& params);

    SeenFeature seen(const Measurement& measured) const;

    /// With `random` an ambiguous observation is of one of its landmarks, or of a new one, drawn by
    /// their likelihoods, and weighs the sum of these: the likelihood of the one drawn over the
    /// probability of drawing it.
    template <Sensor S, class Watch = Unwatched>
    Decision decide(const typename S::Columns& landmarks, const Pose& pose,
                    const PreparedObservation& observed, RandomStream* random = nullptr,
                    const Watch& watch = {}) const;

    /// Whether a landmark was seen where the observation is, or near enough, and from its side;
    /// always where lines are not bounded. `unsure` is how far the pose may be wrong [m].
    template <Sensor S>
    bool beside(const typename S::Columns& landmarks, std::size_t i, const Pose& pose,
                const SeenReach& reach, double unsure = 0.0) const {
        if (!params_.segments) return true;
        const Extent known = landmarks.extent(i);
        const Extent seen = S::placed(reach, pose, landmarks.mean(i));
        return !known.opposite(seen) && known.gap(seen) <= params_.segment_margin_m + unsure;
    }

    /// Calls body(landmark, Likelihood) for every landmark above p0 or inside the gate; of an
    /// observation that says which landmark it is, for that one, wherever it lies, and where there
    /// is none for those that nobody has named. What watches sees all the others too.
    template <Sensor S, class Body, class Watch = Unwatched>
    void for_each_candidate(const typename S::Columns& landmarks, const Pose& pose,
                            const PreparedObservation& observed, const Body& body,
                            const Watch& watch = {}) const;
    /// Whether a landmark cannot be what was observed: no likelier than p0, or outside the gate.
    bool outside(const Likelihood& close) const {
        return by_likelihood() ? !(close.log_likelihood > log_p0_)
                               : !(close.mahalanobis_squared <= rule_.gate());
    }
    void offer(BestTwo& candidates, std::uint32_t landmark, const Likelihood& close) const {
        candidates.offer(landmark,
                         by_likelihood() ? close.log_likelihood : -close.mahalanobis_squared,
                         close.log_likelihood);
    }
    /// The decision where nothing but the candidates matters.
    Decision resolve(const BestTwo& candidates) const;
    /// For an observation that fits no landmark.
    Decision fits_none() const {
        return {Association::Outcome::created, Association::Reason::fits_none, 0, log_p0_};
    }
    /// For one that fits landmarks but is kept out of the map; `best_log` is the greatest of their
    /// likelihoods.
    Decision kept_out(double best_log, Association::Reason reason) const;
    /// What all decisions go by.
    void note_limits(AssociationRecord& record) const;

  private:
    bool by_likelihood() const { return params_.method == AssociationMethod::maximum_likelihood; }
    /// Whether all that the observation is ambiguous between are stretches of one bounded line,
    /// which it joins.
    template <Sensor S>
    bool joins(const typename S::Columns& landmarks, const Pose& pose,
               const PreparedObservation& observed, const BestTwo& candidates) const;
    /// Of landmarks with these likelihoods, each at most the best one's share that makes an
    /// observation ambiguous away from it, and a new one.
    template <Sensor S>
    Decision draw(const typename S::Columns& landmarks, const Pose& pose,
                  const PreparedObservation& observed, double best_log, RandomStream& random) const;

    AssociationParams params_;
    AssociationRule rule_;
    double log_p0_;
};

inline Decision Associator::resolve(const BestTwo& candidates) const {
    if (candidates.none()) return fits_none();
    if (!rule_.ambiguous(candidates, log_p0_)) {
        return {Association::Outcome::matched, Association::Reason::fits, candidates.best(),
                candidates.best_log()};
    }
    return kept_out(std::max(candidates.best_log(), candidates.second_log()),
                    Association::Reason::ambiguous);
}

inline Decision Associator::kept_out(double best_log, Association::Reason reason) const {
    switch (params_.ambiguity) {
        case AmbiguityRule::neutral:
            return {Association::Outcome::ignored, reason, 0, 0.0};
        case AmbiguityRule::new_landmark:
            return {Association::Outcome::ignored, reason, 0, log_p0_};
        default:
            return {Association::Outcome::ignored, reason, 0, best_log};
    }
}

template <Sensor S, class Body, class Watch>
void Associator::for_each_candidate(const typename S::Columns& landmarks, const Pose& pose,
                                    const PreparedObservation& observed, const Body& body,
                                    const Watch& watch) const {
    const LanePose from = lane_of(pose);
    const LaneObservation seen = lane_of(observed.seen.measured);
    const std::int32_t identity = observed.seen.measured.identity;
    const auto compare = [&](std::uint32_t i, bool far) {
        const std::int32_t its = identity == kNameless ? kNameless : landmarks.record(i).identity;
        const bool known = identity != kNameless && its == identity;
        const bool elsewhere =
            !far && !known &&
            (!may_be_one(identity, its) || !beside<S>(landmarks, i, pose, observed.seen.reach));
        if (!Watch::kWatches && elsewhere) return;
        const LaneInnovation innovation = S::innovation(landmarks.lane(i), from, seen);
        const Likelihood close = likelihood_of(innovation);
        const bool no = far || elsewhere || (!known && outside(close));
        if constexpr (Watch::kWatches) {
            const Standing standing = far         ? Standing::far
                                      : elsewhere ? Standing::elsewhere
                                      : no        ? Standing::outside
                                                  : Standing::candidate;
            watch.note(i, {innovation.nu0, innovation.nu1}, close, standing);
        }
        if (!no) body(i, close);
    };
    if (identity != kNameless) {
        if (const auto landmark = landmarks.identified(identity)) {
            compare(*landmark, false);
            return;
        }
    }
    if constexpr (Watch::kWatches) {
        std::uint32_t next = 0;
        landmarks.each_near(pose, observed, [&](std::uint32_t near) {
            while (next < near) compare(next++, true);
            compare(next++, false);
        });
        while (next < landmarks.size()) compare(next++, true);
    } else {
        landmarks.each_near(pose, observed, [&](std::uint32_t near) { compare(near, false); });
    }
}

template <Sensor S>
Decision Associator::draw(const typename S::Columns& landmarks, const Pose& pose,
                          const PreparedObservation& observed, double best_log,
                          RandomStream& random) const {
    // Relative to the best, which cannot underflow.
    thread_local std::vector<std::pair<std::uint32_t, double>> plausible;
    plausible.clear();
    const double of_new = std::exp(log_p0_ - best_log);
    double sum = of_new;
    for_each_candidate<S>(landmarks, pose, observed,
                          [&](std::uint32_t landmark, const Likelihood& close) {
                              const double share = std::exp(close.log_likelihood - best_log);
                              if (!(share > params_.ambiguity_ratio)) return;
                              plausible.emplace_back(landmark, share);
                              sum += share;
                          });
    double left = random.uniform() * sum;
    const double log_sum = best_log + std::log(sum);
    for (const auto& [landmark, share] : plausible) {
        left -= share;
        if (left < 0.0) {
            return {Association::Outcome::matched, Association::Reason::drawn, landmark, log_sum};
        }
    }
    return {Association::Outcome::created, Association::Reason::drawn, 0, log_sum};
}

template <Sensor S>
bool Associator::joins(const typename S::Columns& landmarks, const Pose& pose,
                       const PreparedObservation& observed, const BestTwo& candidates) const {
    const auto grown = [&](std::size_t i) {
        return landmarks.extent(i).joined(S::placed(observed.seen.reach, pose, landmarks.mean(i)));
    };
    const std::uint32_t best = candidates.best();
    const double least = candidates.best_log() + std::log(params_.ambiguity_ratio);
    bool all = true;
    for_each_candidate<S>(
        landmarks, pose, observed, [&](std::uint32_t other, const Likelihood& close) {
            if (other == best || !(close.log_likelihood > least)) return;
            const Matrix2 together = landmarks.covariance(best) +
                                     S::difference(landmarks.mean(best), landmarks.mean(other))
                                         .turned(landmarks.covariance(other));
            all = all && S::same(landmarks.mean(best), grown(best), landmarks.mean(other),
                                 grown(other), together);
        });
    return all;
}

template <Sensor S, class Watch>
Decision Associator::decide(const typename S::Columns& landmarks, const Pose& pose,
                            const PreparedObservation& observed, RandomStream* random,
                            const Watch& watch) const {
    BestTwo candidates;
    for_each_candidate<S>(
        landmarks, pose, observed,
        [&](std::uint32_t landmark, const Likelihood& close) {
            offer(candidates, landmark, close);
        },
        watch);
    if (candidates.none() || !rule_.ambiguous(candidates, log_p0_)) {
        const std::int32_t identity = observed.seen.measured.identity;
        // Where rounding leaves no comparison with its landmark, it is no new one either.
        if (candidates.none() && identity != kNameless && landmarks.identified(identity)) {
            return {Association::Outcome::ignored, Association::Reason::between_gates, 0, 0.0};
        }
        Decision decision = resolve(candidates);
        if (identity != kNameless && !candidates.none() &&
            landmarks.record(candidates.best()).identity == identity) {
            decision.reason = Association::Reason::known;
        }
        return decision;
    }
    if (params_.segments && S::kKind == FeatureKind::line &&
        joins<S>(landmarks, pose, observed, candidates)) {
        return {Association::Outcome::matched, Association::Reason::stretches, candidates.best(),
                candidates.best_log()};
    }
    if (random == nullptr) return resolve(candidates);
    return draw<S>(landmarks, pose, observed,
                   std::max(candidates.best_log(), candidates.second_log()), *random);
}

}  // namespace hitos
