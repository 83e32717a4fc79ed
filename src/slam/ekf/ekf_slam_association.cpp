// SPDX-License-Identifier: GPL-3.0-or-later
// Which landmarks the observations of EKF-SLAM are of.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "ekf_slam.hpp"

namespace hitos {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Of a landmark that no observation is compared with.
constexpr Likelihood kNoLikelihood{-kNever, kNever};

/// Rounding can cost S its positivity where variances are next to nothing: no comparison then.
Likelihood compared(const Vector2& nu, const Matrix2& s) {
    const Likelihood likelihood = likelihood_of(nu, s);
    return s.determinant() > 0.0 && likelihood.mahalanobis_squared >= 0.0 ? likelihood
                                                                          : kNoLikelihood;
}

}  // namespace

void EkfSlam::associate(Recorded recorded) {
    for_each_kind([&]<class S>() {
        const auto seen = measurements_.of<S>();
        if (recorded == nullptr && !seen.empty()) {
            sieve<S>().begin(state_, marks<S>(), seen, std::max(rule_.gate(), new_gate_));
        }
    });
    if (params_.association.method == AssociationMethod::joint_compatibility) {
        associate_together(recorded);
    } else {
        for_each_kind([&]<class S>() {
            std::uint32_t observed = 0;
            for (const Measurement& measured : measurements_.of<S>()) {
                associate<S>(measured, observed++, recorded);
            }
        });
    }
}

template <Sensor S, class Body>
double EkfSlam::compare(const Measurement& measured, Recorded recorded, const Body& body) {
    const Pose pose = state_.pose();
    const Matrix3 pose_covariance = state_.pose_covariance();
    double nearest = kNever;
    const bool is_known = identified<S>(measured.identity).has_value();
    const auto compare_with = [&](std::size_t i) {
        const Eigen::Index at = marks<S>()[i].at;
        const JointInnovation seen =
            S::joint_innovation(measured.z, pose, S::from_state(state_.landmark(at)));
        const Matrix23 cross = state_.cross_covariance(at);
        const Matrix23 hp = seen.by_pose * pose_covariance + seen.by_landmark * cross;
        const Matrix2 s =
            hp * seen.by_pose.transpose() +
            (seen.by_pose * cross.transpose() + seen.by_landmark * state_.landmark_covariance(at)) *
                seen.by_landmark.transpose() +
            measured.r;
        const Likelihood close = compared(seen.nu, s);
        if (recorded != nullptr) {
            const bool inside = is_known || close.mahalanobis_squared <= rule_.gate();
            recorded->back().compared.push_back({static_cast<std::int32_t>(i), seen.nu,
                                                 close.mahalanobis_squared, close.log_likelihood,
                                                 inside ? Standing::candidate : Standing::outside});
        }
        nearest = std::min(nearest, close.mahalanobis_squared);
        body(static_cast<std::uint32_t>(i),
             JointState::Row{at, seen.nu, seen.by_pose, seen.by_landmark, measured.r}, close);
    };
    if (recorded != nullptr) recorded->emplace_back();
    if (const auto known = identified<S>(measured.identity)) {
        compare_with(*known);
        return nearest;
    }
    std::size_t compared_with = 0;
    const auto compare_if_it_may_be = [&](std::size_t i) {
        if (!may_be_one(measured.identity, marks<S>()[i].record.identity)) return;
        ++compared_with;
        compare_with(i);
    };
    if (recorded != nullptr) {
        for (std::size_t i = 0; i < marks<S>().size(); ++i) compare_if_it_may_be(i);
    } else {
        sieve<S>().for_each_near(measured, compare_if_it_may_be);
    }
    // The others are outside both gates, how far does not matter.
    const bool all = compared_with == marks<S>().size();
    return all ? nearest : std::min(nearest, std::numeric_limits<double>::max());
}

template <Sensor S>
std::optional<std::size_t> EkfSlam::identified(std::int32_t identity) const {
    if (identity == kNameless) return std::nullopt;
    for (std::size_t i = 0; i < marks<S>().size(); ++i) {
        if (marks<S>()[i].record.identity == identity) return i;
    }
    return std::nullopt;
}

template <Sensor S>
void EkfSlam::associate(const Measurement& measured, std::uint32_t observed, Recorded recorded) {
    const bool known = identified<S>(measured.identity).has_value();  // then no gate is asked
    BestTwo inside;  // of the landmarks whose gate it lies in, by distance
    JointState::Row row;
    const double nearest =
        compare<S>(measured, recorded,
                   [&](std::uint32_t i, const JointState::Row& compared, const Likelihood& close) {
                       const double distance = close.mahalanobis_squared;
                       const bool fits = known || distance <= rule_.gate();
                       if (fits && inside.offer(i, -distance, close.log_likelihood)) row = compared;
                   });
    Association association{S::kKind, observed};
    if (!inside.none() && !rule_.ambiguous(inside)) {
        match(association, inside.best(), row, inside.best_log());
        if (known) association.reason = Association::Reason::known;
    } else if (!inside.none()) {
        association.reason = Association::Reason::ambiguous;
    } else if (is_new<S>(nearest)) {
        association.outcome = Association::Outcome::created;
        association.reason = Association::Reason::fits_none;
    }
    associations_.push_back(association);
}

void EkfSlam::match(Association& association, std::uint32_t landmark, const JointState::Row& row,
                    double log_likelihood) {
    association.outcome = Association::Outcome::matched;
    association.reason = Association::Reason::fits;
    association.landmark = static_cast<std::int32_t>(landmark);
    rows_.push_back(row);
    statistics_.best_log_weight += log_likelihood;
}

template <Sensor S>
bool EkfSlam::is_new(double nearest) const {
    // Where no comparison was possible nothing is known, and so nothing is new.
    const bool comparable = marks<S>().empty() || nearest < kNever;
    return comparable && nearest > new_gate_;
}

void EkfSlam::associate_together(Recorded recorded) {
    search_.begin(params_.association.joint_probability);
    found_.clear();
    found_rows_.clear();
    for_each_kind([&]<class S>() {
        std::uint32_t observed = 0;
        for (const Measurement& measured : measurements_.of<S>()) {
            search_.add_observation();
            if (identified<S>(measured.identity)) {
                associate<S>(measured, observed++, recorded);
                continue;
            }
            const auto taken = [&](std::int32_t named) {
                return named != kNameless &&
                       std::ranges::any_of(measurements_.of<S>(), [&](const Measurement& other) {
                           return other.identity == named;
                       });
            };
            const double nearest = compare<S>(
                measured, recorded,
                [&](std::uint32_t i, const JointState::Row& row, const Likelihood& close) {
                    if (close.mahalanobis_squared > rule_.gate()) return;
                    if (taken(marks<S>()[i].record.identity)) return;
                    search_.add({static_cast<std::uint64_t>(row.at), close.mahalanobis_squared,
                                 static_cast<std::uint32_t>(found_.size())});
                    found_.push_back({i, close.log_likelihood});
                    found_rows_.push_back(row);
                });
            Association association{S::kKind, observed++};
            if (is_new<S>(nearest)) {
                association.outcome = Association::Outcome::created;
                association.reason = Association::Reason::fits_none;
            }
            associations_.push_back(association);
        }
    });
    std::vector<Eigen::Index> places;
    for (const JointState::Row& row : found_rows_) places.push_back(row.at);
    state_.attend(std::move(places));  // the search asks for all their covariances
    JointInnovationDistance distance(state_, found_rows_);
    if (!search_.run(distance)) ++statistics_.searches_cut;
    for (std::size_t i = 0; i < associations_.size(); ++i) {
        if (const JointCandidate* pairing = search_.paired(i)) {
            const Found& found = found_[pairing->place];
            match(associations_[i], found.landmark, found_rows_[pairing->place],
                  found.log_likelihood);
            associations_[i].reason = Association::Reason::together;
        } else if (!search_.candidates(i).empty()) {
            associations_[i].reason = Association::Reason::left_over;
        }
    }
}

}  // namespace hitos
