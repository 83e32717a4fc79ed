// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/features/line_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "wall_scan.hpp"

namespace hitos {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

/// The covariance of the fitted (rho, theta) over many noisy scans of one wall.
template <class Fit>
Matrix2d sampled_covariance(const std::vector<Point2>& points, const Recta& truth, double sigma,
                            const Fit& fit) {
    constexpr int kDraws = 8000;
    Matrix2d sampled = Matrix2d::Zero();
    for (unsigned seed = 0; seed < kDraws; ++seed) {
        const Scan scan = scan_of({points}, sigma, seed);
        const Recta line = fit(scan.points);
        const Vector2d away(line.rho - truth.rho, wrap_angle(line.theta - truth.theta));
        sampled += away * away.transpose() / kDraws;
    }
    return sampled;
}

void expect_near(const Matrix2d& computed, const Matrix2d& sampled) {
    // The standard error of a sampled variance over 8000 draws is 1.6 %.
    const double s0 = std::sqrt(sampled(0, 0));
    const double s1 = std::sqrt(sampled(1, 1));
    EXPECT_NEAR(computed(0, 0) / sampled(0, 0), 1.0, 0.08);
    EXPECT_NEAR(computed(1, 1) / sampled(1, 1), 1.0, 0.08);
    EXPECT_NEAR(computed(0, 1) / (s0 * s1), sampled(0, 1) / (s0 * s1), 0.06);
}

TEST(LineCovariance, IsThatOfTheFitOverManyScans) {
    struct Case {
        Point2 from, to;
        int points;
    };
    for (const Case& c : {Case{{2.0, -2.0}, {2.0, 3.0}, 60}, Case{{1.0, 0.5}, {6.0, 1.0}, 25},
                          Case{{-3.0, 4.0}, {-5.0, -1.0}, 40}}) {
        const std::vector<Point2> points = wall(c.from, c.to, c.points);
        const Recta truth = line_through(c.from, c.to);
        const Matrix2d sampled = sampled_covariance(
            points, truth, 0.01, [](const auto& p) { return fit_least_squares(p); });
        expect_near(line_covariance(truth, points, PointErrors{0.01, 0.0, {}}), sampled);
    }
}

TEST(LineCovariance, WithTwoPointsIsThatOfTheLineThroughThem) {
    const std::vector<Point2> ends = wall({2.0, -1.5}, {2.5, 3.0}, 2);
    const Recta truth = line_through(ends[0], ends[1]);
    const Matrix2d sampled = sampled_covariance(
        ends, truth, 0.01, [](const auto& p) { return line_through(p.front(), p.back()); });
    expect_near(line_covariance(truth, ends, PointErrors{0.01, 0.0, {}}), sampled);
}

TEST(LineCovariance, GrowsWithTheScatterButNeverShrinks) {
    const std::vector<Point2> points = wall({2.0, -2.0}, {2.0, 2.0}, 50);
    const Recta truth{2.0, 0.0};
    const Matrix2d exact =
        line_covariance(truth, points, PointErrors{0.01, 0.0, {}});  // no scatter at all
    const Scan rough = scan_of({points}, 0.05, 7);
    const Matrix2d grown =
        line_covariance(fit_least_squares(rough.points), rough.points, PointErrors{0.01, 0.0, {}});
    EXPECT_NEAR(std::sqrt(grown(1, 1) / exact(1, 1)), 5.0, 1.5);
    EXPECT_GT(exact(1, 1), 0.0);
}

TEST(LineCovariance, AWallAlongTheRaysStaysPositive) {
    const std::vector<Point2> points = wall({1.0, 0.0}, {4.0, 0.0}, 20);
    const Matrix2d covariance =
        line_covariance({0.0, kPi / 2.0}, points, PointErrors{0.01, 0.0, {}});
    EXPECT_GT(covariance.determinant(), 0.0);
    EXPECT_GT(covariance(0, 0), 0.0);
}

TEST(LineCovariance, CountsRangesFromTheLaser) {
    const std::vector<Point2> points = wall({2.0, -2.0}, {2.0, 2.0}, 50);
    const Matrix2d central = line_covariance({2.0, 0.0}, points, PointErrors{0.01, 0.0, {}});
    // From far to the side the rays graze the wall: their errors are along it.
    const Matrix2d aside = line_covariance({2.0, 0.0}, points, PointErrors{0.01, 0.0, {0.0, 8.0}});
    EXPECT_LT(aside(1, 1), 0.5 * central(1, 1));
}

TEST(LineCovariance, WhatAllPointsShareDoesNotAverageOut) {
    // Of a wall 4 m long: its middle gets the common error, and its tilt that error over the root
    // mean square distance of the points from the middle.
    for (const int points : {10, 1000}) {
        const std::vector<Point2> wall_points = wall({2.0, -2.0}, {2.0, 2.0}, points);
        const Recta truth{2.0, 0.0};
        const Matrix2d without = line_covariance(truth, wall_points, PointErrors{0.01, 0.0, {}});
        const Matrix2d with = line_covariance(truth, wall_points, PointErrors{0.01, 0.02, {}});
        double mean_square = 0.0;
        for (const Point2& p : wall_points) mean_square += p.y * p.y / points;
        EXPECT_NEAR(with(0, 0) - without(0, 0), 4e-4, 1e-9);
        EXPECT_NEAR(with(1, 1) - without(1, 1), 4e-4 / mean_square, 1e-9);
    }
}

TEST(LineCovariance, OfAWallSeenAlongItselfDoesNotVanish) {
    // The laser stands on the wall's line: a tenth of sigma is what remains across it.
    const std::vector<Point2> points = wall({1.0, 0.0}, {3.0, 0.0}, 21);
    const Matrix2d covariance = line_covariance({0.0, kPi / 2}, points, PointErrors{0.1, 0.0, {}});
    double squares = 0.0;
    for (const Point2& p : points) squares += (p.x - 2.0) * (p.x - 2.0);
    EXPECT_NEAR(covariance(1, 1), 1e-4 / squares, 1e-12);
    EXPECT_NEAR(covariance(0, 0), 1e-4 / 21.0 + 4.0 * 1e-4 / squares, 1e-12);
}

TEST(IntersectionCovariance, IsThatOfTheMeetingOverManyDraws) {
    const Recta a{2.0, 0.1};
    const Recta b{3.0, 1.4};
    Matrix2d ca;
    ca << 4e-6, -2e-6, -2e-6, 9e-6;
    Matrix2d cb;
    cb << 1e-6, 5e-7, 5e-7, 4e-6;
    const auto meet = [](const Recta& l, const Recta& m) {
        Matrix2d n;
        n << std::cos(l.theta), std::sin(l.theta), std::cos(m.theta), std::sin(m.theta);
        return Vector2d(n.inverse() * Vector2d(l.rho, m.rho));
    };
    const Vector2d truth = meet(a, b);
    const Matrix2d ra = ca.llt().matrixL();
    const Matrix2d rb = cb.llt().matrixL();
    std::mt19937 engine(67);
    std::normal_distribution<double> normal(0.0, 1.0);
    Matrix2d sampled = Matrix2d::Zero();
    constexpr int kDraws = 40000;
    for (int i = 0; i < kDraws; ++i) {
        const Vector2d da = ra * Vector2d(normal(engine), normal(engine));
        const Vector2d db = rb * Vector2d(normal(engine), normal(engine));
        const Vector2d away =
            meet({a.rho + da(0), a.theta + da(1)}, {b.rho + db(0), b.theta + db(1)}) - truth;
        sampled += away * away.transpose() / kDraws;
    }
    const Matrix2d computed = intersection_covariance(a, ca, b, cb, {truth(0), truth(1)});
    expect_near(computed, sampled);
}

TEST(Covariances, ComeWithTheObservationOnlyWhereAskedFor) {
    const Scan scan = scan_of(
        {joined(wall({2.0, -2.0}, {2.0, 3.0}, 40), wall({2.0, 3.0}, {-3.0, 3.0}, 40))}, 0.003);
    ExtractionParams params;
    params.corner_distance_m = 0.2;
    EXPECT_TRUE(extract(params, scan).line_covariances.empty());
    EXPECT_TRUE(extract(params, scan).corner_covariances.empty());
    params.covariance = ObservationCovariance::points;
    params.point_sigma_m = 0.003;
    for (const char* method : {"split-merge", "ransac"}) {
        params.method = method;
        const Observation seen = extract(params, scan);
        ASSERT_EQ(seen.lines.size(), 2U);
        ASSERT_EQ(seen.line_covariances.size(), 2U);
        ASSERT_EQ(seen.corners.size(), 1U);
        ASSERT_EQ(seen.corner_covariances.size(), 1U);
        for (std::size_t i = 0; i < 2; ++i) {
            EXPECT_GT(seen.line_covariances[i].determinant(), 0.0);
            EXPECT_LT(std::sqrt(seen.line_covariances[i](0, 0)), 0.01);
        }
        EXPECT_LT(std::sqrt(seen.corner_covariances[0].trace()), 0.02);
    }
    // All points of a line tell more than its ends.
    params.method = "split-merge";
    const double ends = extract(params, scan).line_covariances[0](1, 1);
    params.split_merge.fit = LineFit::least_squares;
    EXPECT_LT(extract(params, scan).line_covariances[0](1, 1), 0.5 * ends);
    params.detect = Detection::corners;
    EXPECT_TRUE(extract(params, scan).line_covariances.empty());
}

}  // namespace
}  // namespace hitos
