// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/landmark_index.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "association/association.hpp"
#include "own_landmarks.hpp"

namespace hitos {
namespace {

class IndexDraws {
  public:
    double uniform(double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(engine_);
    }
    double normal(double sigma) { return std::normal_distribution<double>(0.0, sigma)(engine_); }
    /// Between the two, whatever their sizes.
    double scale(double from, double to) { return std::exp(uniform(std::log(from), std::log(to))); }
    Pose pose(double side) {
        return {uniform(-side, side), uniform(-side, side), uniform(-kPi, kPi)};
    }

  private:
    std::mt19937 engine_{11};
};

Matrix2 covariance(IndexDraws& draws, double sigma0, double sigma1) {
    const double correlation = draws.uniform(-0.99, 0.99);
    Matrix2 p;
    p << sigma0 * sigma0, correlation * sigma0 * sigma1, correlation * sigma0 * sigma1,
        sigma1 * sigma1;
    return p;
}

/// As dense everywhere.
Recta place(IndexDraws& draws, SensorRecta /*kind*/, double side) {
    return {side * std::sqrt(draws.uniform(0.0, 1.0)), draws.uniform(-kPi, kPi)};
}
Esquina place(IndexDraws& draws, SensorEsquina /*kind*/, double side) {
    return {draws.uniform(-side, side), draws.uniform(-side, side)};
}

LandmarkEstimate<SensorRecta> landmark(IndexDraws& draws, SensorRecta /*kind*/, double side) {
    // Many through the origin, where angle and side mean least, and both ways along the axes.
    const double rho =
        draws.uniform(0.0, 1.0) < 0.3 ? draws.uniform(0.0, 0.2) : draws.uniform(0.0, 1.4 * side);
    return {{rho, draws.uniform(-kPi, kPi)},
            covariance(draws, draws.scale(1e-4, 1.0), draws.scale(1e-4, 0.5))};
}
LandmarkEstimate<SensorEsquina> landmark(IndexDraws& draws, SensorEsquina kind, double side) {
    return {place(draws, kind, side),
            covariance(draws, draws.scale(1e-4, 2.0), draws.scale(1e-4, 2.0))};
}

template <class S>
std::vector<std::uint32_t> near_without_index(const typename S::Columns& landmarks,
                                              const Pose& pose,
                                              const PreparedObservation& observed) {
    std::vector<std::uint32_t> near;
    landmarks.each_group([&](const auto& group) {
        std::uint64_t bits = S::Columns::near_in(group, pose, observed);
        for (; bits != 0; bits &= bits - 1) {
            near.push_back(group.landmark(static_cast<std::size_t>(std::countr_zero(bits))));
        }
    });
    return near;
}

/// An observation near what the pose sees of some landmark, or of none.
template <class S>
SeenFeature seen_feature(IndexDraws& draws, const typename S::Columns& landmarks,
                         const Pose& pose) {
    const auto i =
        static_cast<std::size_t>(draws.uniform(0.0, static_cast<double>(landmarks.size()) - 1e-6));
    Vector2 z = S::predict(pose, landmarks.mean(i));
    if (S::kKind == FeatureKind::line && z(0) < 0.0) z << -z(0), z(1) + kPi;
    const double off = draws.scale(1e-3, 3.0);
    z += Vector2(draws.normal(off), draws.normal(0.3 * off));
    z << std::abs(z(0)), wrap_angle(z(1));
    Matrix2 r = covariance(draws, draws.scale(1e-4, 0.5), draws.scale(1e-4, 0.3));
    double slack = draws.uniform(-1.0, 30.0);
    // As sure as can be, one way or both, and not at all.
    constexpr double kEndless = std::numeric_limits<double>::infinity();
    const double odd = draws.uniform(0.0, 1.0);
    if (odd < 0.1) {
        r(0, 1) = r(1, 0) = r(odd < 0.05, odd < 0.05) = 0.0;
        slack = kEndless;
    } else if (odd < 0.15) {
        r(1, 1) = kEndless;
    }
    const auto [sine, cosine] = elementary::sine_cosine(z(1));
    return {{z, r}, slack, {}, cosine, sine};
}

template <class S>
class Index : public testing::Test {};
using Kinds = testing::Types<SensorRecta, SensorEsquina>;
TYPED_TEST_SUITE(Index, Kinds, );

/// In maps large and small, sure and unsure, near the origin and far, while landmarks move, come
/// and go, the index finds all that the quick rejection of every landmark lets through, in order.
TYPED_TEST(Index, FindsAllThatMayBeIt) {
    using S = TypeParam;
    IndexDraws draws;
    std::size_t found = 0;
    for (const double side : {1.0, 10.0, 300.0, 1e6}) {
        OwnLandmarks<S> own;
        typename S::Columns landmarks = own.columns();
        std::vector<std::uint32_t> places;
        for (int round = 0; round < 4000; ++round) {
            if (round < 300 || round % 3 == 0) {
                landmarks.set(landmarks.append(), landmark(draws, S(), side));
            }
            const auto i = static_cast<std::size_t>(
                draws.uniform(0.0, static_cast<double>(landmarks.size()) - 1e-6));
            // As an update does: the estimate shifts and gets surer.
            typename S::Lane lane = landmarks.lane(i);
            lane = S::Lane::of(landmarks.mean(i),
                               {0.9 * lane.p.p00, 0.9 * lane.p.p01, 0.9 * lane.p.p11});
            auto mean = S::to_state(landmarks.mean(i));
            mean += Vector2(draws.normal(0.1), draws.normal(0.1));
            lane = S::Lane::of(S::from_state(mean), lane.p);
            lane.store(landmarks.own_leaf_of(i).values.data() + i % S::Columns::kLeaf,
                       S::Columns::kLeaf);
            landmarks.moved(i);
            if (round % 50 == 49) {
                landmarks.take_out([&](std::uint32_t) { return draws.uniform(0.0, 1.0) < 0.02; },
                                   places);
            }
            if (round % 1500 == 1499) landmarks.cut(30);
            const Pose pose = draws.pose(side);
            const SeenFeature seen = seen_feature<S>(draws, landmarks, pose);
            const PreparedObservation observed = prepare(seen, pose);
            std::vector<std::uint32_t> near;
            landmarks.each_near(pose, observed, [&](std::uint32_t k) { near.push_back(k); });
            ASSERT_EQ(near, near_without_index<S>(landmarks, pose, observed))
                << side << ' ' << round;
            found += near.size();
        }
        EXPECT_TRUE(landmarks.indexed());
    }
    EXPECT_GT(found, 5000U);  // or nothing was shown
}

/// What is looked at does not grow with the map where the robot sees as far in each.
TYPED_TEST(Index, LooksAtWhatIsNear) {
    using S = TypeParam;
    std::vector<std::size_t> looked_at;
    for (const int count : {400, 6400}) {
        IndexDraws draws;
        OwnLandmarks<S> own;
        typename S::Columns landmarks = own.columns();
        const double side = std::sqrt(count);
        for (int i = 0; i < count; ++i) {
            landmarks.set(landmarks.append(),
                          {place(draws, S(), side), 1e-4 * Matrix2::Identity()});
        }
        std::size_t sum = 0;
        std::vector<IndexEntry> entries;
        for (int k = 0; k < 200; ++k) {
            const Pose pose = draws.pose(2.0);
            const double z1 = draws.uniform(-kPi, kPi);
            const auto [sine, cosine] = elementary::sine_cosine(z1);
            const SeenFeature seen{{{3.0, z1}, 1e-4 * Matrix2::Identity()}, 10.0, {}, cosine, sine};
            const NearQuery query = near_query(prepare(seen, pose));
            const IndexRegion region =
                IndexRegion::of(S::region(query, lane_of(pose), NearReach::of(query)));
            landmarks.find(region, entries);
            sum += entries.size();
        }
        looked_at.push_back(sum);
    }
    EXPECT_GT(looked_at[0], 20U);
    EXPECT_LT(looked_at[1], 2 * looked_at[0]);
}

/// A landmark whose estimate is no number is none that anything may be.
TYPED_TEST(Index, WhatIsNoNumberIsNowhere) {
    using S = TypeParam;
    IndexDraws draws;
    OwnLandmarks<S> own;
    typename S::Columns landmarks = own.columns();
    constexpr double kNot = std::numeric_limits<double>::quiet_NaN();
    for (int i = 0; i < 200; ++i) {
        LandmarkEstimate<S> one = landmark(draws, S(), 5.0);
        if (i % 7 == 0) one.mean = S::from_state({kNot, kNot});
        if (i % 11 == 0) one.covariance.fill(kNot);
        landmarks.set(landmarks.append(), one);
    }
    for (int k = 0; k < 300; ++k) {
        const Pose pose = draws.pose(5.0);
        SeenFeature seen = seen_feature<S>(draws, landmarks, pose);
        if (!seen.measured.z.allFinite()) continue;
        const PreparedObservation observed = prepare(seen, pose);
        std::vector<std::uint32_t> near;
        landmarks.each_near(pose, observed, [&](std::uint32_t i) { near.push_back(i); });
        ASSERT_EQ(near, near_without_index<S>(landmarks, pose, observed));
    }
}

}  // namespace
}  // namespace hitos
