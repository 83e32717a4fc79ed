// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/slam/robot.hpp"

#include <gtest/gtest.h>

#include "hitos/base/error.hpp"

namespace hitos {
namespace {

/// [T eq 7.17] as printed, for w != 0.
Pose thesis_motion(const Pose& pose, double v, double w, double dt) {
    return {pose.x - v / w * std::sin(pose.theta) + v / w * std::sin(pose.theta + w * dt),
            pose.y + v / w * std::cos(pose.theta) - v / w * std::cos(pose.theta + w * dt),
            wrap_angle(pose.theta + w * dt)};
}

TEST(Robot, MeanIsTheThesissArc) {
    const auto robot = make_robot(MotionParams{});
    for (const double w : {0.5, -0.8, 1e-3, 3.0}) {
        const Pose start{1.0, -2.0, 2.5};
        const Control control{{0.7, 0.0, w}, 0.9};
        const Pose end = robot->mean(start, sum_controls(std::span(&control, 1)));
        const Pose expected = thesis_motion(start, 0.7, w, 0.9);
        EXPECT_NEAR(end.x, expected.x, 1e-9);
        EXPECT_NEAR(end.y, expected.y, 1e-9);
        EXPECT_NEAR(wrap_angle(end.theta - expected.theta), 0.0, 1e-12);
    }
}

TEST(Robot, StraightLineLimit) {
    const auto robot = make_robot(MotionParams{});
    const Control control{{0.5, 0.0, 0.0}, 2.0};
    const Pose end = robot->mean({0.0, 0.0, kPi / 2.0}, sum_controls(std::span(&control, 1)));
    EXPECT_NEAR(end.x, 0.0, 1e-12);
    EXPECT_NEAR(end.y, 1.0, 1e-12);
    // Next to it the arc must agree.
    const Control arc{{0.5, 0.0, 1e-7}, 2.0};
    const Pose near = robot->mean({0.0, 0.0, kPi / 2.0}, sum_controls(std::span(&arc, 1)));
    EXPECT_NEAR(near.x, end.x, 1e-6);
    EXPECT_NEAR(near.y, end.y, 1e-9);
}

TEST(Robot, SumOfControlsIsTheirSequence) {
    const std::vector<Control> controls{
        {{0.3, 0.0, 0.2}, 0.4}, {{0.5, 0.05, -1.0}, 0.3}, {{0, 0, 1.0}, 0.5}};
    const auto robot = make_robot(MotionParams{});
    Pose pose{2.0, 1.0, -3.0};
    const Pose at_once = robot->mean(pose, sum_controls(controls));
    for (const Control& control : controls) {
        pose = robot->mean(pose, sum_controls(std::span(&control, 1)));
    }
    EXPECT_NEAR(at_once.x, pose.x, 1e-12);
    EXPECT_NEAR(at_once.y, pose.y, 1e-12);
    EXPECT_NEAR(at_once.theta, pose.theta, 1e-12);
    const MotionIncrement sum = sum_controls(controls);
    EXPECT_NEAR(sum.turned_rad, 0.08 + 0.3 + 0.5, 1e-12);
    EXPECT_NEAR(sum.path_m, 0.12 + 0.3 * std::hypot(0.5, 0.05), 1e-12);
}

TEST(Robot, NoNoiseAtRest) {
    for (const char* model : {"odometry", "proportional", "increments"}) {
        MotionParams params;
        params.model = model;
        const auto robot = make_robot(params);
        RandomStream random(1, RandomPurpose::motion, 1, 1);
        const Pose pose{1.0, 2.0, 3.0};
        const Control rest{{0.0, 0.0, 0.0}, 1.0};
        EXPECT_EQ(robot->sample(pose, sum_controls({}), random), pose);
        EXPECT_EQ(robot->sample(pose, sum_controls(std::span(&rest, 1)), random), pose);
    }
}

struct Moments {
    double mean_x = 0, mean_y = 0, mean_t = 0, var_x = 0, var_y = 0, var_t = 0, cov_xy = 0;
};

Moments sample_moments(const MotionParams& params, const Pose& start, const Control& control) {
    constexpr int kDraws = 100000;
    const auto robot = make_robot(params);
    const MotionIncrement increment = sum_controls(std::span(&control, 1));
    const Pose centre = robot->mean(start, increment);
    Moments m;
    for (int i = 0; i < kDraws; ++i) {
        RandomStream random(9, RandomPurpose::motion, 1, static_cast<std::uint32_t>(i));
        const Pose drawn = robot->sample(start, increment, random);
        const double dx = drawn.x - centre.x;
        const double dy = drawn.y - centre.y;
        const double dt = wrap_angle(drawn.theta - centre.theta);
        m.mean_x += dx / kDraws;
        m.mean_y += dy / kDraws;
        m.mean_t += dt / kDraws;
        m.var_x += dx * dx / kDraws;
        m.var_y += dy * dy / kDraws;
        m.var_t += dt * dt / kDraws;
        m.cov_xy += dx * dy / kDraws;
    }
    return m;
}

/// Five standard errors of a variance from 100,000 normal draws: 5 sqrt(2 / n) of it.
constexpr double kVarianceTolerance = 0.0224;

TEST(Robot, ConstantNoiseHasTheStatedSigmas) {
    MotionParams params;
    params.sigma_x_m = 0.03;
    params.sigma_y_m = 0.01;
    params.sigma_theta_rad = 0.02;
    const Moments m = sample_moments(params, {0, 0, 1.0}, {{0.5, 0, 0.1}, 0.2});
    EXPECT_NEAR(m.var_x, 9e-4, 9e-4 * kVarianceTolerance);
    EXPECT_NEAR(m.var_y, 1e-4, 1e-4 * kVarianceTolerance);
    EXPECT_NEAR(m.var_t, 4e-4, 4e-4 * kVarianceTolerance);
    EXPECT_NEAR(m.mean_x, 0.0, 5.0 * 0.03 / std::sqrt(1e5));
    EXPECT_NEAR(m.mean_t, 0.0, 5.0 * 0.02 / std::sqrt(1e5));
}

TEST(Robot, TheNumbersOfConstantNoiseMayBeVariances) {
    MotionParams variances;
    variances.unit = MotionUnit::variance;
    variances.sigma_x_m = 9e-4;
    variances.sigma_y_m = 1e-4;
    variances.sigma_theta_rad = 4e-4;
    const Moments m = sample_moments(variances, {0, 0, 1.0}, {{0.5, 0, 0.1}, 0.2});
    EXPECT_NEAR(m.var_x, 9e-4, 9e-4 * kVarianceTolerance);
    EXPECT_NEAR(m.var_y, 1e-4, 1e-4 * kVarianceTolerance);
    EXPECT_NEAR(m.var_t, 4e-4, 4e-4 * kVarianceTolerance);
}

TEST(Robot, ProportionalNoiseGrowsWithTheMotion) {
    MotionParams params;
    params.model = "proportional";
    params.var_along_m2_per_m = 0.01;
    params.var_across_m2_per_m = 0.0025;
    params.var_theta_rad2_per_rad = 0.02;
    params.var_theta_rad2_per_m = 0.005;
    // 2 m straight along +y: along is y, across is x.
    const Moments straight = sample_moments(params, {0, 0, kPi / 2.0}, {{1.0, 0, 0}, 2.0});
    EXPECT_NEAR(straight.var_y, 0.02, 0.02 * kVarianceTolerance);
    EXPECT_NEAR(straight.var_x, 0.005, 0.005 * kVarianceTolerance);
    EXPECT_NEAR(straight.var_t, 0.01, 0.01 * kVarianceTolerance);
    // Half a radian in place.
    const Moments turn = sample_moments(params, {0, 0, 0}, {{0, 0, -1.0}, 0.5});
    EXPECT_EQ(turn.var_x, 0.0);
    EXPECT_NEAR(turn.var_t, 0.01, 0.01 * kVarianceTolerance);
}

/// What is drawn for many poses at once is what each draws by itself, to the last bit, and a row
/// that needs none says so.
TEST(Robot, ManyPosesDrawWhatEachDraws) {
    RegisteredStep step;
    step.before = {1.0, 2.0, 3.0};
    step.pose = {1.2, 2.1, -3.1};
    step.covariance = Eigen::Vector3d(1e-4, 2e-4, 3e-4).asDiagonal();
    step.path_m = 0.25;
    step.turned_rad = 0.2;
    const Control control{{0.7, 0.1, -0.9}, 0.6};
    MotionIncrement increment = sum_controls(std::span(&control, 1));
    increment.registered = &step;
    for (const MotionModelEntry& entry : motion_models().entries()) {
        MotionParams params;
        params.model = entry.word;
        const auto robot = make_robot(params);
        std::vector<Pose> poses;
        for (int i = 0; i < 45; ++i) poses.push_back({0.1 * i, -3.0, 0.2 * i - 3.1});
        const std::vector<Pose> before = poses;
        const RandomRow row{5, RandomPurpose::motion, 17, 100};
        ASSERT_TRUE(robot->sample_row(poses, increment, row)) << entry.word;
        for (std::size_t i = 0; i < poses.size(); ++i) {
            RandomStream random = row.stream(i);
            ASSERT_EQ(poses[i], robot->sample(before[i], increment, random)) << entry.word;
        }
    }
}

TEST(Robot, WithoutOdometryParticlesOnlySpread) {
    MotionParams params;
    params.model = "no-odometry";
    const Pose start{1.0, 2.0, 0.5};
    const Control control{{0.5, 0, 0.1}, 1.0};
    EXPECT_EQ(make_robot(params)->mean(start, sum_controls(std::span(&control, 1))), start);
    const Moments m = sample_moments(params, start, {{0, 0, 0}, 0.0});
    EXPECT_NEAR(m.var_x, 6.4e-5, 6.4e-5 * kVarianceTolerance);
}

TEST(Robot, JacobianIsTheSlopeOfTheMean) {
    const Control control{{0.7, 0.1, -0.9}, 0.6};
    const MotionIncrement increment = sum_controls(std::span(&control, 1));
    for (const char* model : {"odometry", "no-odometry", "increments"}) {
        MotionParams params;
        params.model = model;
        const auto robot = make_robot(params);
        for (const double theta : {0.0, 2.0, -3.0}) {
            const Pose pose{1.0, -2.0, theta};
            const Eigen::Matrix3d f = robot->jacobian(pose, increment);
            constexpr double kStep = 1e-6;
            for (int k = 0; k < 3; ++k) {
                const auto moved = [&](double step) {
                    Pose other = pose;
                    (k == 0 ? other.x : k == 1 ? other.y : other.theta) += step;
                    return robot->mean(other, increment);
                };
                const Pose plus = moved(kStep);
                const Pose minus = moved(-kStep);
                EXPECT_NEAR(f(0, k), (plus.x - minus.x) / (2.0 * kStep), 1e-8);
                EXPECT_NEAR(f(1, k), (plus.y - minus.y) / (2.0 * kStep), 1e-8);
                EXPECT_NEAR(f(2, k), wrap_angle(plus.theta - minus.theta) / (2.0 * kStep), 1e-8);
            }
        }
    }
}

TEST(Robot, NoiseCovarianceIsThatOfTheDraws) {
    const Control control{{0.7, 0.0, -0.9}, 0.6};
    const MotionIncrement increment = sum_controls(std::span(&control, 1));
    const Pose pose{1.0, -2.0, 0.6};
    for (const char* model : {"odometry", "no-odometry", "proportional", "increments"}) {
        MotionParams params;
        params.model = model;
        params.sigma_y_m = 0.02;
        const auto robot = make_robot(params);
        const Pose mean = robot->mean(pose, increment);
        Eigen::Matrix3d sampled = Eigen::Matrix3d::Zero();
        constexpr int kDraws = 40000;
        for (int i = 0; i < kDraws; ++i) {
            RandomStream random(7, RandomPurpose::motion, static_cast<std::uint64_t>(i), 0);
            const Pose drawn = robot->sample(pose, increment, random);
            const Eigen::Vector3d away(drawn.x - mean.x, drawn.y - mean.y,
                                       wrap_angle(drawn.theta - mean.theta));
            sampled += away * away.transpose() / kDraws;
        }
        const Eigen::Matrix3d q = robot->noise_covariance(pose, increment);
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                const double scale = std::sqrt(sampled(i, i) * sampled(j, j));
                EXPECT_NEAR(q(i, j) / scale, sampled(i, j) / scale, 0.04) << i << j;
            }
        }
    }
    const MotionIncrement rest;
    EXPECT_EQ(make_robot(MotionParams{})->noise_covariance(pose, rest), Eigen::Matrix3d::Zero());
}

TEST(Robot, NoiseOfIncrementsIsInProportionToEachInTheHeadingBefore) {
    MotionParams params;
    params.model = "increments";
    params.ratio_x = 0.1;
    params.ratio_y = 0.3;
    params.ratio_theta = 0.2;
    // 2 m ahead and 0.5 m to the left, heading +y: ahead is y, left is -x.
    const Moments m = sample_moments(params, {1.0, 2.0, kPi / 2.0}, {{1.0, 0.25, 0}, 2.0});
    EXPECT_NEAR(m.var_y, 0.04, 0.04 * kVarianceTolerance);
    EXPECT_NEAR(m.var_x, 0.0225, 0.0225 * kVarianceTolerance);
    EXPECT_EQ(m.var_t, 0.0);
    const Moments turn = sample_moments(params, {}, {{0, 0, -1.0}, 0.5});
    EXPECT_NEAR(turn.var_x, 0.0, 1e-12);
    EXPECT_NEAR(turn.var_t, 0.01, 0.01 * kVarianceTolerance);
    // [P eq 14]: Q = G S G' with the heading before the step, not half way round it.
    const Pose start{1.0, 2.0, 0.3};
    const Control arc{{1.0, 0.0, 0.8}, 1.0};
    const MotionIncrement increment = sum_controls(std::span(&arc, 1));
    const Pose& step = increment.pose_start_end;
    Eigen::Matrix3d g;
    g << std::cos(0.3), -std::sin(0.3), 0, std::sin(0.3), std::cos(0.3), 0, 0, 0, 1;
    const Eigen::Vector3d variances(0.01 * step.x * step.x, 0.09 * step.y * step.y,
                                    0.04 * step.theta * step.theta);
    const Eigen::Matrix3d expected = g * variances.asDiagonal() * g.transpose();
    const Eigen::Matrix3d q = make_robot(params)->noise_covariance(start, increment);
    EXPECT_LT((q - expected).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(Robot, ProportionalNoiseLiesAlongTheMeanHeading) {
    MotionParams params;
    params.model = "proportional";
    params.var_along_m2_per_m = 0.01;
    params.var_across_m2_per_m = 0.0;
    const auto robot = make_robot(params);
    const Control turning{{1.0, 0.0, 0.8}, 1.0};
    const MotionIncrement increment = sum_controls(std::span(&turning, 1));
    const Pose start{1.0, 2.0, 0.3};
    const double heading = 0.3 + 0.4;  // half of the turn
    const Eigen::Vector2d along(std::cos(heading), std::sin(heading));

    const Pose mean = robot->mean(start, increment);
    RandomStream random(1, RandomPurpose::motion, 1, 1);
    const Pose drawn = robot->sample(start, increment, random);
    const Eigen::Vector2d away(drawn.x - mean.x, drawn.y - mean.y);
    EXPECT_GT(away.norm(), 1e-3);
    EXPECT_NEAR(away.x() * along.y() - away.y() * along.x(), 0.0, 1e-12);

    const Eigen::Matrix2d q = robot->noise_covariance(start, increment).topLeftCorner<2, 2>();
    EXPECT_LT((q - 0.01 * along * along.transpose()).norm(), 1e-12);
}

TEST(Robot, MotionModelsAreRegistered) {
    EXPECT_EQ(motion_models().words(),
              "odometry, no-odometry, proportional, increments, registered");
    for (const MotionModelEntry& entry : motion_models().entries()) {
        EXPECT_NE(entry.make({}), nullptr);
        EXPECT_FALSE(entry.label.empty() || entry.purpose.empty());
    }
    EXPECT_TRUE(motion_models().reads("no-odometry", "motion.sigma_x"));
    EXPECT_FALSE(motion_models().reads("proportional", "motion.sigma_x"));
    MotionParams params;
    params.model = "legs";
    EXPECT_THROW(make_robot(params), ConfigError);
}

}  // namespace
}  // namespace hitos
