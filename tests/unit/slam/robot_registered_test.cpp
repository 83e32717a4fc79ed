// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "hitos/base/error.hpp"
#include "hitos/slam/robot.hpp"
#include "models/gaussian.hpp"

namespace hitos {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

RegisteredStep a_step() {
    RegisteredStep step;
    step.before = {1.0, 2.0, 0.4};
    step.pose = {1.8, 2.5, 1.1};
    step.path_m = 0.95;
    step.turned_rad = 0.7;
    step.covariance << 4e-3, 1e-3, 2e-4, 1e-3, 1e-3, -1e-4, 2e-4, -1e-4, 9e-4;
    return step;
}

MotionParams registered_motion() {
    MotionParams params;
    params.model = "registered";
    params.registered_memory_m = 2.0;
    params.registered_share = 0.5;
    params.registered_sigma_m = 0.02;
    params.registered_heading_rad = 0.01;
    return params;
}

MotionIncrement increment_of(const RegisteredStep& step) {
    MotionIncrement increment;
    increment.registered = &step;
    return increment;
}

Vector3d minus(const Pose& a, const Pose& b) {
    return {a.x - b.x, a.y - b.y, wrap_angle(a.theta - b.theta)};
}

Matrix3d turned(double angle) {
    Matrix3d r;
    r << std::cos(angle), -std::sin(angle), 0, std::sin(angle), std::cos(angle), 0, 0, 0, 1;
    return r;
}

/// S of the motion model, in the axes of the pose after the step.
Matrix3d spread(const MotionParams& params, const RegisteredStep& step) {
    const Matrix3d back = turned(step.before.theta - step.pose.theta);
    Matrix3d s = params.registered_share * back * step.covariance * back.transpose();
    s(0, 0) += 4e-4;
    s(1, 1) += 4e-4;
    s(2, 2) += 1e-4;
    return s;
}

TEST(RobotRegistered, ShrinksTheDeviationFromThePath) {
    const RegisteredStep step = a_step();
    const auto robot = make_robot(registered_motion());
    EXPECT_LT(minus(robot->mean(step.before, increment_of(step)), step.pose).norm(), 1e-12);
    const Pose delta{0.3, -0.2, 0.1};
    const Pose after = robot->mean(compose(step.before, delta), increment_of(step));
    const double rho = std::exp(-0.95 / 2.0);
    const Pose left = between(step.pose, after);
    EXPECT_NEAR(left.x, 0.3 * rho, 1e-12);
    EXPECT_NEAR(left.y, -0.2 * rho, 1e-12);
    EXPECT_NEAR(left.theta, 0.1 * rho, 1e-12);
}

TEST(RobotRegistered, JacobianIsTheSlopeOfTheMean) {
    const RegisteredStep step = a_step();
    const MotionIncrement increment = increment_of(step);
    const auto robot = make_robot(registered_motion());
    const Pose pose{1.3, 1.7, 0.7};
    const Matrix3d f = robot->jacobian(pose, increment);
    constexpr double kStep = 1e-6;
    for (int k = 0; k < 3; ++k) {
        const auto moved = [&](double by) {
            Pose other = pose;
            (k == 0 ? other.x : k == 1 ? other.y : other.theta) += by;
            return robot->mean(other, increment);
        };
        const Vector3d slope = minus(moved(kStep), moved(-kStep)) / (2.0 * kStep);
        EXPECT_LT((f.col(k) - slope).cwiseAbs().maxCoeff(), 1e-8) << k;
    }
}

TEST(RobotRegistered, NoiseCovarianceIsThatOfTheDraws) {
    const MotionParams params = registered_motion();
    const RegisteredStep step = a_step();
    const MotionIncrement increment = increment_of(step);
    const auto robot = make_robot(params);
    const Pose pose{1.3, 1.7, 0.7};
    const Pose mean = robot->mean(pose, increment);
    Matrix3d sampled = Matrix3d::Zero();
    Vector3d sum = Vector3d::Zero();
    constexpr int kDraws = 40000;
    for (int i = 0; i < kDraws; ++i) {
        RandomStream random(7, RandomPurpose::motion, static_cast<std::uint64_t>(i), 0);
        const Vector3d away = minus(robot->sample(pose, increment, random), mean);
        sum += away / kDraws;
        sampled += away * away.transpose() / kDraws;
    }
    const Matrix3d q = robot->noise_covariance(pose, increment);
    const double kept = 1.0 - std::exp(-2.0 * 0.95 / 2.0);
    const Matrix3d expected = kept * turned(1.1) * spread(params, step) * turned(1.1).transpose();
    EXPECT_LT((q - expected).cwiseAbs().maxCoeff(), 1e-15);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(sum(i), 0.0, 5.0 * std::sqrt(q(i, i) / kDraws));
        for (int j = 0; j < 3; ++j) {
            EXPECT_NEAR(sampled(i, j), q(i, j), 0.04 * std::sqrt(q(i, i) * q(j, j))) << i << j;
        }
    }
}

TEST(RobotRegistered, TheSpreadAboutThePathIsBounded) {
    // However long the way: the covariance of the deviation is S, and not the sum of the steps'.
    const MotionParams params = registered_motion();
    const auto robot = make_robot(params);
    RegisteredStep step = a_step();
    const Matrix3d s = spread(params, step);
    Matrix3d sampled = Matrix3d::Zero();
    constexpr std::uint32_t kDraws = 20000;
    for (std::uint32_t i = 0; i < kDraws; ++i) {
        Pose pose = step.before;
        Pose path = step.before;
        for (std::uint64_t k = 0; k < 12; ++k) {
            RegisteredStep next = step;
            next.before = path;
            next.pose = path = compose(path, between(step.before, step.pose));
            RandomStream random(7, RandomPurpose::motion, k, i);
            pose = robot->sample(pose, increment_of(next), random);
        }
        const Vector3d away = minus(between(path, pose), {});
        sampled += away * away.transpose() / kDraws;
    }
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            EXPECT_NEAR(sampled(i, j), s(i, j), 0.05 * std::sqrt(s(i, i) * s(j, j))) << i << j;
        }
    }
}

TEST(RobotRegistered, DrawsNothingWhereRegistrationDidNotMove) {
    RegisteredStep step = a_step();
    step.pose = step.before;
    step.path_m = step.turned_rad = 0.0;
    const auto robot = make_robot(registered_motion());
    RandomStream random(1, RandomPurpose::motion, 1, 1);
    RandomStream untouched = random;
    const Pose pose{1.3, 1.7, 0.7};
    EXPECT_EQ(robot->sample(pose, increment_of(step), random), pose);
    EXPECT_EQ(random.next(), untouched.next());
    EXPECT_EQ(robot->noise_covariance(pose, increment_of(step)), Matrix3d::Zero());
}

TEST(RobotRegistered, ACorrectionOfTheWorldMovesItsDrawsAlong) {
    const RegisteredStep step = a_step();
    const Pose motion{4.0, -3.0, 2.2};
    RegisteredStep moved = step;
    moved.before = compose(motion, step.before);
    moved.pose = compose(motion, step.pose);
    const auto robot = make_robot(registered_motion());
    const Pose pose{1.3, 1.7, 0.7};
    RandomStream random(1, RandomPurpose::motion, 1, 1);
    RandomStream same = random;
    const Pose before = robot->sample(pose, increment_of(step), random);
    const Pose after = robot->sample(compose(motion, pose), increment_of(moved), same);
    EXPECT_LT(minus(after, compose(motion, before)).norm(), 1e-12);
}

TEST(RobotRegistered, NeedsRegistration) {
    const auto robot = make_robot(registered_motion());
    RandomStream random(1, RandomPurpose::motion, 1, 1);
    EXPECT_THROW(robot->mean({}, {}), ConfigError);
    EXPECT_THROW(robot->sample({}, {}, random), ConfigError);
    EXPECT_THROW(robot->noise_covariance({}, {}), ConfigError);
    EXPECT_TRUE(motion_models().find("registered").registered);
    EXPECT_FALSE(motion_models().find("odometry").registered);
}

TEST(Gaussian, TheRootOfASingularCovarianceIsItsCholeskyFactor) {
    const Vector3d a(0.3, -0.2, 0.1);
    const Vector3d b(0.0, 0.5, 0.7);
    Matrix3d regular = a * a.transpose() + b * b.transpose();
    regular(0, 0) += 0.01;
    regular(2, 2) += 0.02;
    for (const Matrix3d& covariance :
         {regular, Matrix3d(a * a.transpose()), Matrix3d(b * b.transpose()),
          Matrix3d(Matrix3d::Zero()), Matrix3d(a * a.transpose() + b * b.transpose())}) {
        const Matrix3d root = root_of(covariance);
        EXPECT_LT((root * root.transpose() - covariance).cwiseAbs().maxCoeff(), 1e-12);
        EXPECT_EQ(root(0, 1), 0.0);
    }
    EXPECT_LT((root_of(regular) - Matrix3d(regular.llt().matrixL())).norm(), 1e-12);
}

}  // namespace
}  // namespace hitos
