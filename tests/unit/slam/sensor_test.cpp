// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <random>

#include "models/ekf.hpp"
#include "models/landmark_kinds.hpp"

namespace hitos {
namespace {

/// Poses and landmarks at random, with the places where angles wrap and rho changes its sign.
template <class S>
class SensorLaws : public testing::Test {
  protected:
    Pose pose() { return {value_(engine_), value_(engine_), angle_(engine_)}; }
    typename S::Landmark landmark() {
        if constexpr (std::is_same_v<S, SensorRecta>) {
            return Recta{std::abs(value_(engine_)), angle_(engine_)};
        } else {
            return Esquina{value_(engine_), value_(engine_)};
        }
    }
    Vector2 measurement() { return {std::abs(value_(engine_)) + 0.2, angle_(engine_)}; }

    std::mt19937 engine_{23};
    std::uniform_real_distribution<double> value_{-10.0, 10.0};
    std::uniform_real_distribution<double> angle_{-kPi, kPi};
};

using Sensors = testing::Types<SensorRecta, SensorEsquina>;
TYPED_TEST_SUITE(SensorLaws, Sensors);

constexpr double kStep = 1e-6;
constexpr double kTolerance = 1e-5;

Vector2 wrapped(Vector2 difference) {
    difference(1) = wrap_angle(difference(1));
    return difference;
}

TYPED_TEST(SensorLaws, JacobianOfTheLandmark) {
    using S = TypeParam;
    for (int i = 0; i < 500; ++i) {
        const Pose pose = this->pose();
        const auto landmark = this->landmark();
        const Vector2 state = S::to_state(landmark);
        const Matrix2 h = S::jacobian(pose, landmark);
        for (int k = 0; k < 2; ++k) {
            const Vector2 step = kStep * Vector2::Unit(k);
            const Vector2 slope = wrapped(S::predict(pose, S::from_state(state + step)) -
                                          S::predict(pose, S::from_state(state - step))) /
                                  (2.0 * kStep);
            EXPECT_LT((h.col(k) - slope).norm(), kTolerance * (1.0 + slope.norm()));
        }
    }
}

TYPED_TEST(SensorLaws, JacobianOfThePose) {
    using S = TypeParam;
    for (int i = 0; i < 500; ++i) {
        const Pose pose = this->pose();
        const auto landmark = this->landmark();
        const Matrix23 h = S::pose_jacobian(pose, landmark);
        for (int k = 0; k < 3; ++k) {
            const auto moved = [&](double step) {
                Pose other = pose;
                (k == 0 ? other.x : k == 1 ? other.y : other.theta) += step;
                return S::predict(other, landmark);
            };
            const Vector2 slope = wrapped(moved(kStep) - moved(-kStep)) / (2.0 * kStep);
            EXPECT_LT((h.col(k) - slope).norm(), kTolerance * (1.0 + slope.norm()));
        }
    }
}

TYPED_TEST(SensorLaws, InverseUndoesThePrediction) {
    using S = TypeParam;
    for (int i = 0; i < 500; ++i) {
        const Pose pose = this->pose();
        const Vector2 z = this->measurement();
        const auto landmark = S::inverse(pose, z);
        const Innovation innovation = S::innovation(z, pose, landmark);
        EXPECT_LT(innovation.nu.norm(), 1e-9);
    }
}

TYPED_TEST(SensorLaws, JacobiansOfTheInverse) {
    using S = TypeParam;
    for (int i = 0; i < 500; ++i) {
        const Pose pose = this->pose();
        const Vector2 z = this->measurement();
        const auto slope_of = [&](auto&& moved) {
            return ((S::to_state(moved(kStep)) - S::to_state(moved(-kStep))) / (2.0 * kStep))
                .eval();
        };
        const Matrix2 g = S::inverse_jacobian(pose, z);
        for (int k = 0; k < 2; ++k) {
            const Vector2 slope = slope_of(
                [&](double step) { return S::inverse(pose, z + step * Vector2::Unit(k)); });
            EXPECT_LT((g.col(k) - slope).norm(), kTolerance * (1.0 + slope.norm()));
        }
        const Matrix23 gp = S::inverse_pose_jacobian(pose, z);
        for (int k = 0; k < 3; ++k) {
            const Vector2 slope = slope_of([&](double step) {
                Pose other = pose;
                (k == 0 ? other.x : k == 1 ? other.y : other.theta) += step;
                return S::inverse(other, z);
            });
            EXPECT_LT((gp.col(k) - slope).norm(), kTolerance * (1.0 + slope.norm()));
        }
    }
}

TYPED_TEST(SensorLaws, InnovationIsSmallestAndItsJacobianFits) {
    using S = TypeParam;
    for (int i = 0; i < 500; ++i) {
        const Pose pose = this->pose();
        const auto landmark = this->landmark();
        const Vector2 z = this->measurement();
        const Innovation innovation = S::innovation(z, pose, landmark);
        EXPECT_LE(std::abs(innovation.nu(1)),
                  (std::is_same_v<S, SensorRecta> ? kPi / 2.0 : kPi) + 1e-12);
        // nu = z - h: its slope is minus the Jacobian, on whichever side the line was taken.
        const Vector2 state = S::to_state(landmark);
        for (int k = 0; k < 2; ++k) {
            const Vector2 step = kStep * Vector2::Unit(k);
            const Innovation plus = S::innovation(z, pose, S::from_state(state + step));
            const Innovation minus = S::innovation(z, pose, S::from_state(state - step));
            const Vector2 slope = (minus.nu - plus.nu) / (2.0 * kStep);
            if (slope.norm() > 1e3) continue;  // the side or the wrap changed between the two
            EXPECT_LT((innovation.jacobian.col(k) - slope).norm(),
                      kTolerance * (1.0 + slope.norm()));
        }
    }
}

TYPED_TEST(SensorLaws, JointInnovationsJacobiansFitItsSide) {
    using S = TypeParam;
    int flipped = 0;
    for (int i = 0; i < 500; ++i) {
        const Pose pose = this->pose();
        const auto landmark = this->landmark();
        const Vector2 z = this->measurement();
        const JointInnovation joint = S::joint_innovation(z, pose, landmark);
        flipped += joint.by_landmark(0, 0) < 0.0 ? 1 : 0;
        for (int k = 0; k < 3; ++k) {
            const auto moved = [&](double step) {
                Pose other = pose;
                (k == 0 ? other.x : k == 1 ? other.y : other.theta) += step;
                return S::joint_innovation(z, other, landmark).nu;
            };
            const Vector2 slope = (moved(-kStep) - moved(kStep)) / (2.0 * kStep);
            if (slope.norm() > 1e3) continue;  // the side or the wrap changed between the two
            EXPECT_LT((joint.by_pose.col(k) - slope).norm(), kTolerance * (1.0 + slope.norm()));
        }
    }
    EXPECT_GT(flipped, 50);  // of lines half are, of corners those with dx < 0
}

TEST(SensorRecta, AWallSeenFromItsOtherSideIsTheSameLine) {
    const Recta wall{4.0, kPi / 2.0};  // y = 4
    const Pose below{1.0, 2.0, 0.3};
    const Pose above{1.0, 5.0, 0.3};
    for (const Pose& pose : {below, above}) {
        const Recta seen = transform(inverse(pose), wall);
        const Innovation innovation =
            SensorRecta::innovation(SensorRecta::measurement(seen), pose, wall);
        EXPECT_NEAR(innovation.nu.norm(), 0.0, 1e-12);
    }
}

TEST(SensorRecta, AGlanceNeverTellsLinesApartThatAreTheSame) {
    std::mt19937 engine(5);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    int same = 0;
    int apart = 0;
    for (int i = 0; i < 200000; ++i) {
        const Recta a{5.0 * any(engine), kPi * any(engine)};
        Recta b{a.rho + 0.6 * any(engine), a.theta + 0.15 * any(engine)};
        if (i % 2 == 0) b = {-b.rho, wrap_angle(b.theta + kPi)};
        const double low_a = 10.0 * any(engine);
        const double low_b = 10.0 * any(engine);
        const Extent extent_a{low_a, low_a + 2.0 + any(engine), 0};
        const Extent extent_b = i % 5 == 0 ? Extent{} : Extent{low_b, low_b + 4.0, 0};
        Matrix2 p;
        p << 0.01 + 0.01 * any(engine), 0.0, 0.0, 0.001;
        const bool differ = SensorRecta::differ(SensorRecta::glance(a, extent_a, p),
                                                SensorRecta::glance(b, extent_b, p));
        if (SensorRecta::same(a, extent_a, b, extent_b, 2.0 * p)) {
            ++same;
            ASSERT_FALSE(differ) << "rho " << a.rho << " and " << b.rho << ", theta " << a.theta
                                 << " and " << b.theta;
        } else if (differ) {
            ++apart;
        }
    }
    EXPECT_GT(same, 10000);
    EXPECT_GT(apart, 10000);
}

TEST(SensorRecta, NormalFormKeepsTheCovarianceOfTheSameLine) {
    LandmarkEstimate<SensorRecta> estimate{{-2.0, 0.5}, {}};
    auto& [line, covariance] = estimate;
    covariance << 0.04, 0.01, 0.01, 0.02;
    normalize(estimate);
    EXPECT_DOUBLE_EQ(line.rho, 2.0);
    EXPECT_DOUBLE_EQ(line.theta, 0.5 - kPi);
    EXPECT_DOUBLE_EQ(covariance(0, 1), -0.01);
    EXPECT_DOUBLE_EQ(covariance(1, 0), -0.01);
    EXPECT_DOUBLE_EQ(covariance(0, 0), 0.04);
}

TEST(SensorRecta, NormalFormTellsTheSignThatRhoTook) {
    Recta flipped{-2.0, 0.5};
    EXPECT_EQ(SensorRecta::normalize(flipped), -1.0);
    Recta kept{2.0, 7.0};
    EXPECT_EQ(SensorRecta::normalize(kept), 1.0);
    EXPECT_DOUBLE_EQ(kept.theta, 7.0 - 2.0 * kPi);
}

TEST(KindRow, KeepsItsValuesByKindAndInOrder) {
    KindRow<int> row;
    EXPECT_TRUE(row.empty());
    row.add<SensorEsquina>(7);
    EXPECT_EQ(row.first<SensorEsquina>(), 0U);
    EXPECT_TRUE(row.of<SensorRecta>().empty());
    row.clear();
    EXPECT_TRUE(row.of<SensorEsquina>().empty());
    row.add<SensorRecta>(1);
    row.add<SensorRecta>(2);
    row.add<SensorEsquina>(3);
    EXPECT_EQ(row.size(), 3U);
    EXPECT_EQ(row.first<SensorEsquina>(), 2U);
    EXPECT_EQ(row.of<SensorRecta>()[1], 2);
    ASSERT_EQ(row.of<SensorEsquina>().size(), 1U);
    EXPECT_EQ(row.of<SensorEsquina>()[0], 3);
}

TEST(SensorEsquina, ACornerUnderTheRobotStaysFinite) {
    const Pose pose{1.0, 1.0, 0.5};
    const Matrix2 h = SensorEsquina::jacobian(pose, {1.0, 1.0});
    EXPECT_TRUE(h.allFinite());
}

}  // namespace
}  // namespace hitos
