// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/features/caracteristica.hpp"

#include <gtest/gtest.h>

#include <random>

#include "hitos/features/line_fit.hpp"

namespace hitos {
namespace {

constexpr double kTolerance = 1e-12;

void expect_same_line(const Recta& a, const Recta& b, double tolerance) {
    const LineDifference apart = difference(a, b);
    EXPECT_NEAR(apart.rho, 0.0, tolerance);
    EXPECT_NEAR(apart.theta, 0.0, tolerance);
}

TEST(Recta, NormalFormHasPositiveRhoAndWrappedTheta) {
    std::mt19937 engine(7);
    std::uniform_real_distribution<double> rho(-10.0, 10.0);
    std::uniform_real_distribution<double> theta(-20.0, 20.0);
    for (int i = 0; i < 2000; ++i) {
        const Recta raw{rho(engine), theta(engine)};
        const Recta normal = normalized(raw);
        EXPECT_GE(normal.rho, 0.0);
        EXPECT_GT(normal.theta, -kPi);
        EXPECT_LE(normal.theta, kPi);
        // The same points lie on both.
        const double along = rho(engine);
        const Point2 point{raw.rho * std::cos(raw.theta) - along * std::sin(raw.theta),
                           raw.rho * std::sin(raw.theta) + along * std::cos(raw.theta)};
        EXPECT_NEAR(signed_distance(normal, point), 0.0, 1e-12);
        EXPECT_EQ(normalized(normal), normal);
    }
}

TEST(Recta, NegativeRhoIsTheOppositeNormal) {
    expect_same_line({2.0, 0.3}, {-2.0, 0.3 + kPi}, kTolerance);
    expect_same_line({2.0, 0.3}, {-2.0, 0.3 - kPi}, kTolerance);
    const LineDifference apart = difference({2.0, 0.3}, {2.0, 0.3 + kPi});
    EXPECT_NEAR(apart.rho, 4.0, kTolerance);
    EXPECT_NEAR(apart.theta, 0.0, kTolerance);
}

TEST(Recta, DifferenceWrapsTheta) {
    const LineDifference apart = difference({1.0, kPi - 0.01}, {1.5, -kPi + 0.02});
    EXPECT_NEAR(apart.rho, 0.5, kTolerance);
    EXPECT_NEAR(apart.theta, 0.03, kTolerance);
}

TEST(Recta, LineThroughTwoPointsHoldsBoth) {
    std::mt19937 engine(11);
    std::uniform_real_distribution<double> coordinate(-20.0, 20.0);
    for (int i = 0; i < 1000; ++i) {
        const Point2 a{coordinate(engine), coordinate(engine)};
        const Point2 b{coordinate(engine), coordinate(engine)};
        const Recta line = line_through(a, b);
        EXPECT_NEAR(signed_distance(line, a), 0.0, 1e-10);
        EXPECT_NEAR(signed_distance(line, b), 0.0, 1e-10);
        expect_same_line(line, line_through(b, a), 1e-10);
    }
}

TEST(Recta, LineThroughTheOriginHasRhoZero) {
    const Recta line = line_through({-1.0, -1.0}, {3.0, 3.0});
    EXPECT_NEAR(line.rho, 0.0, kTolerance);
    EXPECT_NEAR(signed_distance(line, {5.0, 5.0}), 0.0, kTolerance);
}

TEST(Recta, TransformMovesItsPoints) {
    std::mt19937 engine(13);
    std::uniform_real_distribution<double> value(-5.0, 5.0);
    for (int i = 0; i < 1000; ++i) {
        const Pose pose{value(engine), value(engine), value(engine)};
        const Point2 a{value(engine), value(engine)};
        const Point2 b{value(engine), value(engine)};
        const Recta moved = transform(pose, line_through(a, b));
        EXPECT_NEAR(signed_distance(moved, transform(pose, a)), 0.0, 1e-9);
        EXPECT_NEAR(signed_distance(moved, transform(pose, b)), 0.0, 1e-9);
        expect_same_line(transform(inverse(pose), moved), line_through(a, b), 1e-9);
    }
}

TEST(ICaracteristica, ThePartThatWasSeenMovesWithTheLine) {
    std::mt19937 engine(18);
    std::uniform_real_distribution<double> value(-3.0, 3.0);
    for (int i = 0; i < 200; ++i) {
        const Pose pose{value(engine), value(engine), value(engine)};
        const Recta line = normalized({std::abs(value(engine)), value(engine)});
        ICaracteristica landmark{line};
        landmark.from_m = value(engine);
        landmark.to_m = landmark.from_m + 1.5;
        const Point2 from = transform(pose, PreparedRecta(line).at(landmark.from_m));
        const Point2 to = transform(pose, PreparedRecta(line).at(landmark.to_m));
        const ICaracteristica moved = transform(pose, landmark);
        const PreparedRecta prepared(std::get<Recta>(moved.value));
        EXPECT_NEAR(moved.from_m, std::min(prepared.along(from), prepared.along(to)), 1e-9);
        EXPECT_NEAR(moved.to_m, std::max(prepared.along(from), prepared.along(to)), 1e-9);
        EXPECT_EQ(transform(pose, ICaracteristica{line}).to_m,
                  std::numeric_limits<double>::infinity());
    }
}

TEST(ICaracteristica, CovarianceMovesWithTheLandmark) {
    std::mt19937 engine(17);
    std::uniform_real_distribution<double> value(-3.0, 3.0);
    for (int i = 0; i < 200; ++i) {
        const Pose pose{value(engine), value(engine), value(engine)};
        for (const bool is_line : {true, false}) {
            ICaracteristica landmark;
            if (is_line) {
                landmark.value = Recta{std::abs(value(engine)) + 0.5, value(engine)};
            } else {
                landmark.value = Esquina{value(engine), value(engine)};
            }
            landmark.covariance << 0.04, 0.01, 0.01, 0.09;
            const ICaracteristica moved = transform(pose, landmark);
            // Against numerical differentiation of the values.
            Eigen::Matrix2d jacobian;
            const double h = 1e-6;
            for (int k = 0; k < 2; ++k) {
                const auto shifted = [&](double step) {
                    ICaracteristica other = landmark;
                    if (auto* line = std::get_if<Recta>(&other.value)) {
                        (k == 0 ? line->rho : line->theta) += step;
                    } else {
                        auto& corner = std::get<Esquina>(other.value);
                        (k == 0 ? corner.x : corner.y) += step;
                    }
                    return transform(pose, other);
                };
                const auto plus = shifted(h);
                const auto minus = shifted(-h);
                if (is_line) {
                    const auto& p = std::get<Recta>(plus.value);
                    const auto& m = std::get<Recta>(minus.value);
                    if (std::abs(wrap_angle(p.theta - m.theta)) > 1.0) return;  // at the flip
                    jacobian(0, k) = (p.rho - m.rho) / (2 * h);
                    jacobian(1, k) = wrap_angle(p.theta - m.theta) / (2 * h);
                } else {
                    jacobian(0, k) = (plus.point().x - minus.point().x) / (2 * h);
                    jacobian(1, k) = (plus.point().y - minus.point().y) / (2 * h);
                }
            }
            const Eigen::Matrix2d expected = jacobian * landmark.covariance * jacobian.transpose();
            EXPECT_LT((moved.covariance - expected).cwiseAbs().maxCoeff(), 1e-6);
        }
    }
}

TEST(LineFit, LeastSquaresMinimisesTheSquaredDistances) {
    std::mt19937 engine(19);
    std::normal_distribution<double> noise(0.0, 0.02);
    std::uniform_real_distribution<double> angle(-kPi, kPi);
    for (int i = 0; i < 100; ++i) {
        const Recta truth{3.0, angle(engine)};
        std::vector<Point2> points;
        for (int k = -10; k <= 10; ++k) {
            const double along = 0.1 * k;
            const double off = truth.rho + noise(engine);
            points.push_back({off * std::cos(truth.theta) - along * std::sin(truth.theta),
                              off * std::sin(truth.theta) + along * std::cos(truth.theta)});
        }
        const auto cost = [&](const Recta& line) {
            double sum = 0.0;
            for (const Point2& p : points) {
                const double d = signed_distance(line, p);
                sum += d * d;
            }
            return sum;
        };
        const Recta best = fit_least_squares(points);
        const double least = cost(best);
        EXPECT_LE(least, cost(truth));
        for (const double step : {1e-4, -1e-4}) {
            EXPECT_LT(least, cost({best.rho + step, best.theta}));
            EXPECT_LT(least, cost({best.rho, best.theta + step}));
        }
    }
}

}  // namespace
}  // namespace hitos
