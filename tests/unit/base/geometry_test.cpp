// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/geometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "unit/capture/test_files.hpp"

namespace hitos {
namespace {

using test::expect_near;

class GeometryTest : public ::testing::Test {
  protected:
    double uniform(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }
    Pose random_pose() { return {uniform(-50, 50), uniform(-50, 50), uniform(-kPi, kPi)}; }

  private:
    std::mt19937_64 engine_{7};
};

TEST_F(GeometryTest, WrapsToHalfOpenInterval) {
    EXPECT_EQ(wrap_angle(0.5), 0.5);
    EXPECT_EQ(wrap_angle(kPi), kPi);
    EXPECT_EQ(wrap_angle(-kPi), kPi);
    EXPECT_NEAR(wrap_angle(3 * kPi), kPi, 1e-12);
    EXPECT_NEAR(wrap_angle(-kPi - 0.1), kPi - 0.1, 1e-12);
    EXPECT_NEAR(wrap_angle(1e9 * 2 * kPi + 0.25), 0.25, 1e-6);
    EXPECT_TRUE(std::isnan(wrap_angle(std::numeric_limits<double>::infinity())));
    for (int i = 0; i < 10000; ++i) {
        const double angle = uniform(-1000, 1000);
        const double wrapped = wrap_angle(angle);
        EXPECT_GT(wrapped, -kPi);
        EXPECT_LE(wrapped, kPi);
        EXPECT_NEAR(std::remainder(angle - wrapped, 2 * kPi), 0.0, 1e-10);
    }
}

TEST_F(GeometryTest, ComposeKnownCase) {
    expect_near(compose({1, 2, kPi / 2}, {3, 0, kPi / 2}), {1, 5, kPi}, 1e-15);
    expect_near(transform({1, 2, kPi / 2}, {3, 1}), Point2{0, 5}, 1e-15);
}

TEST_F(GeometryTest, PosesFormAGroup) {
    for (int i = 0; i < 2000; ++i) {
        const Pose a = random_pose();
        const Pose b = random_pose();
        const Pose c = random_pose();
        expect_near(compose(a, inverse(a)), {}, 1e-12);
        expect_near(compose(inverse(a), a), {}, 1e-12);
        expect_near(compose(compose(a, b), c), compose(a, compose(b, c)), 1e-12);
        expect_near(between(a, b), compose(inverse(a), b), 1e-12);
        expect_near(compose(a, between(a, b)), b, 1e-12);
        const Point2 point{c.x, c.y};
        expect_near(transform(compose(a, b), point), transform(a, transform(b, point)), 1e-12);
    }
}

TEST_F(GeometryTest, DisplacementOfAQuarterCircle) {
    // Radius v/w = 2 m.
    expect_near(displacement({kPi, 0, kPi / 2}, 1.0), {2, 2, kPi / 2}, 1e-12);
    expect_near(displacement({1, 0, 0}, 3.0), {3, 0, 0}, 1e-15);
    expect_near(displacement({0, 1, 0}, 3.0), {0, 3, 0}, 1e-15);
}

TEST_F(GeometryTest, DisplacementIsTheLimitOfSmallSteps) {
    const Twist twist{0.7, -0.2, 1.3};
    constexpr int kSteps = 200000;
    Pose pose;
    for (int i = 0; i < kSteps; ++i) {
        const double dt = 1.5 / kSteps;
        pose = compose(pose, {twist.v * dt, twist.v_lateral * dt, twist.w * dt});
    }
    expect_near(pose, displacement(twist, 1.5), 2e-5);
}

TEST_F(GeometryTest, DisplacementAddsOverTime) {
    for (int i = 0; i < 1000; ++i) {
        const Twist twist{uniform(-2, 2), uniform(-1, 1), uniform(-1, 1)};
        const double first = uniform(0, 1);
        const double second = uniform(0, 1);
        expect_near(compose(displacement(twist, first), displacement(twist, second)),
                    displacement(twist, first + second), 1e-12);
    }
}

TEST_F(GeometryTest, TwistBetweenInvertsDisplacement) {
    const auto check = [](const Pose& moved, double seconds) {
        expect_near(displacement(twist_between(moved, seconds), seconds), moved, 1e-11);
    };
    for (int i = 0; i < 5000; ++i) check(random_pose(), uniform(1e-3, 10));
    for (const double turn : {0.0, 1e-300, 1e-12, -1e-9, 9.9e-5, 1.01e-4, -1e-3, kPi, kPi - 1e-9,
                              -kPi + 1e-9, kPi / 2}) {
        check({0.3, -0.1, turn}, 0.1);
        check({0, 0, turn}, 0.1);
    }
}

TEST_F(GeometryTest, SeriesMeetsTheQuotient) {
    for (const double w : {0.99999e-4, 1.00001e-4, -0.99999e-4, -1.00001e-4}) {
        const Pose moved = displacement({1, 0, w}, 1.0);
        const auto turn = static_cast<long double>(w);
        const auto half = std::sin(turn / 2);
        EXPECT_NEAR(moved.x, static_cast<double>(std::sin(turn) / turn), 1e-15);
        EXPECT_NEAR(moved.y, static_cast<double>(2 * half * half / turn), 1e-12);
    }
}

TEST_F(GeometryTest, APathIsALineForEachTour) {
    EXPECT_TRUE(lines_of({}).empty());
    const Trajectory path{{0.0, {1.0, 0.0, 0.0}},
                          {1.0, {2.0, 0.0, 0.0}},
                          {2.0, {9.0, 5.0, 0.0}, true},
                          {3.0, {9.0, 6.0, 0.0}}};
    const std::vector<std::vector<Point2>> lines = lines_of(path);
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(lines[0], (std::vector<Point2>{{1.0, 0.0}, {2.0, 0.0}}));
    EXPECT_EQ(lines[1], (std::vector<Point2>{{9.0, 5.0}, {9.0, 6.0}}));
}

}  // namespace
}  // namespace hitos
