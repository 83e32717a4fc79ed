// SPDX-License-Identifier: GPL-3.0-or-later
// Mean and covariance of the particles' poses.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <vector>

#include "fastslam/filtro_particulas.hpp"
#include "room_tour.hpp"

namespace hitos {
namespace {

/// Of the hypotheses, reckoned from a pose in their middle, headings the short way round.
struct Belief {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();  ///< from that pose
    Matrix3 covariance = Matrix3::Zero();
};

Belief belief_about(const FiltroParticulas& filter, const Pose& middle) {
    const auto from_middle = [&middle](const Pose& pose) {
        return Eigen::Vector3d(pose.x - middle.x, pose.y - middle.y,
                               std::remainder(pose.theta - middle.theta, 2.0 * kPi));
    };
    Belief belief;
    for (const WeightedPose& h : filter.hypotheses()) {
        belief.mean += h.weight * from_middle(h.pose);
    }
    for (const WeightedPose& h : filter.hypotheses()) {
        const Eigen::Vector3d away = from_middle(h.pose) - belief.mean;
        belief.covariance += h.weight * away * away.transpose();
    }
    return belief;
}

void expect_belief(const FiltroParticulas& filter, const Pose& middle) {
    const Belief expected = belief_about(filter, middle);
    ASSERT_GT(expected.covariance(2, 2), 0.0);
    EXPECT_LT((filter.pose_covariance() - expected.covariance).norm(), 1e-9);
    const Pose told = filter.mean_pose();
    EXPECT_NEAR(told.x, middle.x + expected.mean(0), 1e-9);
    EXPECT_NEAR(told.y, middle.y + expected.mean(1), 1e-9);
    EXPECT_NEAR(std::remainder(told.theta - middle.theta - expected.mean(2), 2.0 * kPi), 0.0, 1e-9);
}

TEST(PoseBelief, IsThatOfTheHypotheses) {
    const Tour tour = make_tour(40, 0.1);
    FilterParams params;
    params.particles = 200;
    params.resampling = {ResamplingRule::neff, 0.0};  // never: the weights stay unequal
    FiltroParticulas filter(params, 1, 1);
    for (std::size_t k = 0; k < tour.controls.size(); ++k) {
        feed(filter, tour.controls[k], tour.observations[k]);
    }
    expect_belief(filter, {});
    EXPECT_EQ(filter.joint_covariance().size(), 0);
}

TEST(PoseBelief, HeadingsGoRound) {
    FilterParams params;
    params.particles = 200;
    FiltroParticulas filter(params, 1, 1);
    const std::vector<Control> turn{{{0.1, 0.0, kPi / 8.0}, 1.0}};
    feed(filter, {}, {});  // the first step moves nobody
    for (int k = 0; k < 8; ++k) feed(filter, turn, {});
    bool left = false;
    bool right = false;
    for (const WeightedPose& h : filter.hypotheses()) {
        ASSERT_GT(std::abs(h.pose.theta), 2.0);
        (h.pose.theta > 0.0 ? left : right) = true;
    }
    ASSERT_TRUE(left && right) << "no cloud on both sides of half a turn";
    expect_belief(filter, {0.0, 0.0, kPi});
    EXPECT_LT(filter.pose_covariance()(2, 2), 0.5);
}

}  // namespace
}  // namespace hitos
