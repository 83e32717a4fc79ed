// SPDX-License-Identifier: GPL-3.0-or-later
#include "graph/graph_slam.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "graph/graph_merging.hpp"
#include "graph/graph_window.hpp"
#include "graph_oracle.hpp"
#include "graph_tour.hpp"
#include "hitos/base/error.hpp"

namespace hitos {
namespace {

constexpr double kGraphStep = 0.5;
// So that the first walls are out of the window and no edge ties them to the newest key.
constexpr int kMore = 12;

GraphRun corridor_run(const SimNoise& noise, unsigned seed, int scans_per_key = 1) {
    return {graph_params(noise), noise, seed, corridor_walls(), corridor_corners(), scans_per_key};
}

/// The true landmark of an estimate, in the frame of the first pose: the nearest one.
Vector2 error_of(const ICaracteristica& landmark, const Pose& first) {
    Vector2 least = Vector2::Constant(1e9);
    if (const auto* line = std::get_if<Recta>(&landmark.value)) {
        for (const SimWall& wall : corridor_walls()) {
            const Recta truth = transform(inverse(first), line_through(wall.a, wall.b));
            Vector2 error{line->rho - truth.rho, wrap_angle(line->theta - truth.theta)};
            if (std::abs(error(1)) > kPi / 2) {
                error = {line->rho + truth.rho, error(1) - std::copysign(kPi, error(1))};
            }
            if (error.norm() < least.norm()) least = error;
        }
    } else {
        const auto& corner = std::get<Esquina>(landmark.value);
        for (const Esquina& known : corridor_corners()) {
            const Esquina truth = transform(inverse(first), known);
            const Vector2 error{corner.x - truth.x, corner.y - truth.y};
            if (error.norm() < least.norm()) least = error;
        }
    }
    return least;
}

TEST(GraphSlam, JacobiansAreThoseOfNumericalDifferentiation) {
    constexpr double kSmall = 1e-6;
    const Pose pose{310.0, -208.0, 2.7};
    for (const FeatureKind kind : {FeatureKind::line, FeatureKind::corner}) {
        const GraphLandmark landmark{kind, {{312.0, -204.0}, 1.2}, {}, {}};
        const Vector2 z{4.0, -1.4};
        const SightingError error = sighting_error(z, pose, landmark);
        for (int c = 0; c < 3; ++c) {
            const auto at = [&](double by) {
                Pose moved = pose;
                (c == 0 ? moved.x : c == 1 ? moved.y : moved.theta) += by;
                return sighting_error(z, moved, landmark).value;
            };
            const Vector2 slope = (at(kSmall) - at(-kSmall)) / (2 * kSmall);
            EXPECT_LT((error.by_pose.col(c) - slope).norm(), 1e-6) << "component " << c;
        }
        for (int c = 0; c < 2; ++c) {
            const auto at = [&](double by) {
                GraphLandmark moved = landmark;
                move(moved, by * Vector2::Unit(c));
                return sighting_error(z, pose, moved).value;
            };
            const Vector2 slope = (at(kSmall) - at(-kSmall)) / (2 * kSmall);
            EXPECT_LT((error.by_landmark.col(c) - slope).norm(), 1e-6) << "component " << c;
        }
    }
}

TEST(GraphSlam, DifferenceOfLandmarksHasItsDerivatives) {
    constexpr double kSmall = 1e-6;
    const GraphLandmark a{FeatureKind::line, {{30.0, 4.0}, 1.50}, {-2.0, 2.0}, {}};
    const GraphLandmark b{FeatureKind::line, {{28.0, 4.2}, 1.56}, {-1.0, 4.0}, {}};
    const PlaceDifference apart = difference(a, b);
    for (int c = 0; c < 2; ++c) {
        const auto at = [&](double by_a, double by_b) {
            GraphLandmark first = a;
            GraphLandmark second = b;
            move(first, by_a * Vector2::Unit(c));
            move(second, by_b * Vector2::Unit(c));
            return difference(first, second).value;
        };
        // The point in the middle moves with the first line, by the second order only.
        const Vector2 by_a = (at(kSmall, 0) - at(-kSmall, 0)) / (2 * kSmall);
        const Vector2 by_b = (at(0, kSmall) - at(0, -kSmall)) / (2 * kSmall);
        EXPECT_LT((apart.by_first.col(c) - by_a).norm(), 0.1) << "component " << c;
        EXPECT_LT((apart.by_second.col(c) - by_b).norm(), 0.1) << "component " << c;
    }
    // A wall 10 cm behind another, in its direction.
    GraphLandmark behind = a;
    move(behind, {0.1, 0.0});
    EXPECT_NEAR(difference(a, behind).value(0), 0.1, 1e-9);
    EXPECT_NEAR(difference(a, behind).value(1), 0.0, 1e-12);
}

TEST(GraphSlam, ExactDataGiveTheExactMap) {
    SimNoise exact;
    exact.odometry = 0.0;
    exact.features = 0.0;
    GraphRun run = corridor_run(exact, 1);
    const std::vector<Pose> path = corridor_path(kGraphStep, kMore);
    run.drive(path);
    run.filter.correct(run.registration.close(3));
    const LandmarkMap map = run.filter.best_map();
    EXPECT_EQ(run.filter.best_count(FeatureKind::line), 8);
    EXPECT_EQ(run.filter.best_count(FeatureKind::corner), 8);
    ASSERT_EQ(map.size(), 16U);
    for (std::size_t i = 0; i < map.size(); ++i) {
        EXPECT_LT(error_of(map[i], path.front()).norm(), 1e-6) << "landmark " << i;
        EXPECT_EQ(map[i].kind(), i < 8 ? FeatureKind::line : FeatureKind::corner);
    }
    const std::vector<Pose> truth = from_first(path);
    const std::vector<Pose> history = run.filter.best_history();
    ASSERT_EQ(history.size(), truth.size());
    for (std::size_t i = 0; i < truth.size(); ++i) {
        EXPECT_NEAR(history[i].x, truth[i].x, 1e-6);
        EXPECT_NEAR(history[i].y, truth[i].y, 1e-6);
    }
}

TEST(GraphSlam, EqualsADenseOracle) {
    const SimNoise noise;
    GraphRun run = corridor_run(noise, 5);
    run.drive(corridor_path(1.0, kMore));
    run.filter.correct(run.registration.close(2));
    const LandmarkMap map = run.filter.best_map();
    GraphOracle oracle(run.filter.graph());
    oracle.solve();
    const LandmarkMap dense = oracle.map();
    ASSERT_EQ(map.size(), dense.size());
    for (std::size_t i = 0; i < map.size(); ++i) {
        const Vector2 sigma = dense[i].covariance.diagonal().cwiseSqrt();
        EXPECT_LT((value_of(map[i]) - value_of(dense[i])).cwiseQuotient(sigma).norm(), 0.02) << i;
        EXPECT_LT((map[i].covariance - dense[i].covariance)
                      .cwiseQuotient(sigma * sigma.transpose())
                      .cwiseAbs()
                      .maxCoeff(),
                  0.02)
            << i;
    }
    const Matrix3 pose = oracle.pose_covariance();
    EXPECT_LT((run.filter.pose_covariance() - pose).norm(), 0.02 * pose.norm());
}

TEST(GraphWindow, KnowsTheCovarianceOfSumsOfLandmarks) {
    GraphRun run = corridor_run(SimNoise{}, 5);
    run.drive(corridor_path(1.0, 2));
    LandmarkGraph graph = run.filter.graph();
    GraphWindow window;
    window.solve(graph);
    const Matrix2 one = Matrix2::Identity();
    const std::vector<std::uint32_t>& reachable = window.reachable();
    ASSERT_GE(reachable.size(), 2U);
    const std::size_t a = reachable.front();
    const std::size_t b = reachable.back();
    const Matrix2 of_a = window.landmark_covariance(graph, a);
    const double scale = of_a.norm();
    EXPECT_LT(window.covariance(graph, a, one, a, -one).norm(), 1e-9 * scale);
    EXPECT_LT((window.covariance(graph, a, one, a, one) - 4.0 * of_a).norm(), 1e-9 * scale);
    const Matrix2 sum = window.covariance(graph, a, one, b, one);
    const Matrix2 difference = window.covariance(graph, a, one, b, -one);
    EXPECT_LT((sum - sum.transpose()).norm(), 1e-9 * scale);
    EXPECT_LT((sum + difference - 2.0 * (of_a + window.landmark_covariance(graph, b))).norm(),
              1e-9 * scale);
}

// What landmarks that are seen again say of the pose counts before any loop is closed.
TEST(GraphSlam, LandmarksSeenAgainBoundThePosesCovariance) {
    const SimNoise noise;
    GraphRun run = corridor_run(noise, 5);
    const std::vector<Pose> path = corridor_path(kGraphStep, kMore);
    run.drive(path);
    GraphOracle oracle(run.filter.graph());
    oracle.solve();
    const double exact = oracle.pose_covariance().topLeftCorner<2, 2>().trace();
    const double told = run.filter.pose_covariance().topLeftCorner<2, 2>().trace();
    const double of_steps =
        2.0 * noise.sigma_m * noise.sigma_m * static_cast<double>(path.size() - 1);
    EXPECT_GT(told, 0.9 * exact);
    EXPECT_LT(told, 2.0 * exact);
    EXPECT_GT(of_steps, 2.0 * told) << "nor what its steps alone would say";
}

TEST(GraphSlam, ErrorsAreWhatTheCovariancesSay) {
    const SimNoise noise;
    const std::vector<Pose> path = corridor_path(kGraphStep, kMore);
    const Pose truth = between(path.front(), path.back());
    constexpr int kRuns = 40;
    double landmarks = 0.0;
    double poses = 0.0;
    double largest = 0.0;
    int count = 0;
    for (unsigned seed = 1; seed <= kRuns; ++seed) {
        GraphRun run = corridor_run(noise, seed);
        run.drive(path);
        run.filter.correct(run.registration.close(4));
        for (const ICaracteristica& landmark : run.filter.best_map()) {
            const Vector2 error = error_of(landmark, path.front());
            landmarks += error.dot(landmark.covariance.inverse() * error);
            largest = std::max(largest, error.norm());
            ++count;
        }
        const Pose off = between(truth, run.filter.best_pose());
        const Eigen::Vector3d error{run.filter.best_pose().x - truth.x,
                                    run.filter.best_pose().y - truth.y, off.theta};
        poses += error.dot(run.filter.pose_covariance().inverse() * error);
    }
    // Two and three where all is Gaussian and linear. Robust weights take errors of one sigma for
    // a tenth less certain, so that covariances are a little too great.
    EXPECT_GT(landmarks / count, 1.5);
    EXPECT_LT(landmarks / count, 2.3);
    EXPECT_GT(poses / kRuns, 1.9);
    EXPECT_LT(poses / kRuns, 3.7);
    EXPECT_NEAR(count / double{kRuns}, 16.0, 0.3);
    EXPECT_LT(largest, 0.5);
}

TEST(GraphSlam, AClosedLoopMakesOneOfWhatWasSeenTwice) {
    SimNoise noise;
    noise.sigma_rad = 0.008;
    GraphRun run = corridor_run(noise, 3);
    run.drive(corridor_path(kGraphStep, kMore));
    EXPECT_GT(run.filter.best_count(FeatureKind::line), 8);
    EXPECT_GT(run.filter.best_count(FeatureKind::corner), 8);
    const auto observations = [&] {
        int sum = 0;
        for (const ICaracteristica& landmark : run.filter.best_map()) sum += landmark.observations;
        return sum;
    };
    const int before = observations();
    run.filter.correct(run.registration.close(4));
    EXPECT_EQ(run.filter.best_count(FeatureKind::line), 8);
    EXPECT_EQ(run.filter.best_count(FeatureKind::corner), 8);
    EXPECT_EQ(observations(), before);  // pooled
    for (const Association& association : run.filter.associations()) {
        if (association.landmark < 0) continue;
        ASSERT_LT(association.landmark, 16);
        EXPECT_EQ(run.filter.best_map()[static_cast<std::size_t>(association.landmark)].kind(),
                  association.kind);
    }
}

TEST(GraphSlam, EdgesMayHaveGoneWhereANewKeyComes) {
    const std::vector<Pose> path = corridor_path(kGraphStep, kMore);
    const std::size_t cut = path.size() / 2;
    GraphRun run = corridor_run({}, 5);
    GraphRun whole = corridor_run({}, 5);
    for (std::size_t i = 0; i < path.size(); ++i) {
        if (i == cut) run.registration.cut(static_cast<std::uint32_t>(i - 2));
        run.step(path[i]);
        whole.step(path[i]);
        if (i == cut) run.filter.correct(run.registration.correction());
    }
    // Noise is small: what is left holds the map together, by the landmarks.
    EXPECT_EQ(run.filter.best_count(FeatureKind::line), whole.filter.best_count(FeatureKind::line));
    const Pose a = run.filter.best_pose();
    const Pose b = whole.filter.best_pose();
    EXPECT_LT(std::hypot(a.x - b.x, a.y - b.y), 0.2);
}

TEST(GraphSlam, TwoWallsInOneDirectionWithADoorStayTwo) {
    const SimNoise noise;
    GraphRun run(graph_params(noise), noise, 1, {{{0, 2}, {5, 2}}, {{6, 2}, {12, 2}}}, {});
    for (int i = 0; i <= 24; ++i) run.step({0.5 * i, 0.0, 0.0});
    EXPECT_EQ(run.filter.best_count(FeatureKind::line), 2);
    run.filter.correct(run.registration.close(0));
    EXPECT_EQ(run.filter.best_count(FeatureKind::line), 2);
    for (const ICaracteristica& wall : run.filter.best_map()) {
        EXPECT_NEAR(std::get<Recta>(wall.value).rho, 2.0, 0.15);
        EXPECT_GT(wall.observations, 10);
    }
}

TEST(GraphSlam, TheFacesOfAWallAreTwoAndStayApart) {
    SimNoise noise;
    noise.odometry = 0.0;  // the way round the wall's end is short
    GraphRun run(graph_params(noise), noise, 1, {{{0, 1.9}, {8, 1.9}}, {{8, 2.1}, {0, 2.1}}}, {});
    for (int i = 0; i <= 16; ++i) run.step({0.5 * i, 0.0, 0.0});
    for (int i = 0; i <= 8; ++i) run.step({9.0, 0.5 * i, kPi / 2});
    for (int i = 16; i >= 0; --i) run.step({0.5 * i, 4.0, kPi});
    run.filter.correct(run.registration.close(5));
    const LandmarkMap map = run.filter.best_map();
    ASSERT_EQ(map.size(), 2U);
    EXPECT_NEAR(std::get<Recta>(map[0].value).rho, 1.9, 0.03);
    EXPECT_NEAR(std::get<Recta>(map[1].value).rho, 2.1, 0.03);
}

/// A wall through (0, 2) as a scan at `pose` shows its part from x = `low` to `high`.
Observation piece(const Pose& pose, std::initializer_list<std::pair<double, double>> parts) {
    Observation seen;
    for (const auto& [low, high] : parts) {
        const Pose to_robot = inverse(pose);
        const Point2 a = transform(to_robot, Point2{low, 2.0});
        const Point2 b = transform(to_robot, Point2{high, 2.0});
        const auto first = static_cast<std::uint32_t>(seen.support.size());
        seen.support.push_back(a);
        seen.support.push_back(b);
        seen.lines.push_back({line_through(a, b), first, 2});
    }
    return seen;
}

void feed_scan(GraphSlam& filter, SimRegistration& registration, const Pose& pose,
               const Observation& seen) {
    const RegisteredStep registered = registration.add(pose);
    const Scan scan;
    filter.step({scan, {}, seen, &registered});
}

TEST(GraphSlam, APieceThatJoinsTwoWallsMakesThemOne) {
    GraphSlam filter(graph_params());
    SimRegistration registration({0.0, 0.0}, 1);
    for (int i = 0; i < 4; ++i) {
        const Pose pose{0.3 * i, 0.0, 0.0};
        feed_scan(filter, registration, pose, piece(pose, {{-3.0, -0.5}, {1.5, 4.0}}));
    }
    EXPECT_EQ(filter.best_count(FeatureKind::line), 2);
    const Pose pose{1.2, 0.0, 0.0};
    feed_scan(filter, registration, pose, piece(pose, {{-2.0, 4.0}}));
    EXPECT_EQ(filter.best_count(FeatureKind::line), 1);
    EXPECT_EQ(filter.best_map()[0].observations, 8);
    feed_scan(filter, registration, {1.5, 0.0, 0.0}, piece({1.5, 0.0, 0.0}, {{-2.0, 4.0}}));
    ASSERT_EQ(filter.associations().size(), 1U);
    EXPECT_EQ(filter.associations()[0].outcome, Association::Outcome::matched);
    EXPECT_EQ(filter.associations()[0].landmark, 0);
}

TEST(GraphSlam, PiecesOfANewWallThatMeetAreOne) {
    GraphSlam filter(graph_params());
    SimRegistration registration({0.0, 0.0}, 1);
    feed_scan(filter, registration, {}, piece({}, {{-3.0, -0.2}, {0.1, 4.0}}));
    EXPECT_EQ(filter.best_count(FeatureKind::line), 1);
    EXPECT_EQ(filter.best_map()[0].observations, 2);
    ASSERT_EQ(filter.associations().size(), 2U);
    EXPECT_EQ(filter.associations()[0].outcome, Association::Outcome::created);
    EXPECT_EQ(filter.associations()[1].outcome, Association::Outcome::matched);
    EXPECT_EQ(filter.associations()[1].landmark, 0);
}

TEST(GraphSlam, ScansBetweenKeysHaveTheirPlaceInTheHistory) {
    const SimNoise noise;
    GraphRun run = corridor_run(noise, 7, 4);
    const std::vector<Pose> path = corridor_path(0.3, 40);
    run.drive(path);
    const std::vector<Pose> truth = from_first(path);
    ASSERT_EQ(run.filter.steps(), path.size());
    EXPECT_EQ(run.filter.graph().keys().size(), (path.size() + 3) / 4);
    const auto worst = [&] {
        const std::vector<Pose> history = run.filter.best_history();
        EXPECT_EQ(history.size(), truth.size());
        EXPECT_EQ(history.back(), run.filter.best_pose());
        double greatest = 0.0;
        for (std::size_t i = 0; i < truth.size(); ++i) {
            greatest = std::max(greatest,
                                std::hypot(history[i].x - truth[i].x, history[i].y - truth[i].y));
        }
        return greatest;
    };
    const double before = worst();
    run.filter.correct(run.registration.close(6));
    EXPECT_LT(worst(), before);
    EXPECT_LT(worst(), 0.5);
}

TEST(GraphSlam, ScansBetweenKeysAreComparedButTeachNothing) {
    GraphSlam filter(graph_params());
    SimRegistration registration({0.0, 0.0}, 1, 3);
    feed_scan(filter, registration, {}, piece({}, {{-3.0, 4.0}}));
    const Pose next{0.1, 0.0, 0.0};
    Observation seen = piece(next, {{-3.0, 4.0}});
    Observation other = piece({0.1, -1.5, 0.0}, {{-3.0, 4.0}});  // a wall at y = 3.5
    seen.support.insert(seen.support.end(), other.support.begin(), other.support.end());
    seen.lines.push_back({other.lines[0].recta, 2, 2});
    feed_scan(filter, registration, next, seen);
    ASSERT_EQ(filter.associations().size(), 2U);
    EXPECT_EQ(filter.associations()[0].outcome, Association::Outcome::matched);
    EXPECT_EQ(filter.associations()[0].landmark, 0);
    EXPECT_EQ(filter.associations()[1].outcome, Association::Outcome::ignored);
    EXPECT_EQ(filter.graph().sightings().size(), 1U);
    EXPECT_EQ(filter.best_count(FeatureKind::line), 1);
}

TEST(GraphSlam, WhatLiesBetweenTheGatesIsLeftAlone) {
    GraphSlam filter(graph_params());
    SimRegistration registration({0.0, 0.0}, 1);
    feed_scan(filter, registration, {}, piece({}, {{-3.0, 4.0}}));
    // S is about (2 R + odometry): sigma of rho about 3.5 cm.
    for (const auto& [off, outcome] : {std::pair{0.03, Association::Outcome::matched},
                                       std::pair{0.12, Association::Outcome::ignored},
                                       std::pair{0.60, Association::Outcome::created}}) {
        GraphSlam one = filter;
        SimRegistration at = registration;
        Observation seen = piece({0.2, 0.0, 0.0}, {{-3.0, 4.0}});
        seen.lines[0].recta.rho += off;
        feed_scan(one, at, {0.2, 0.0, 0.0}, seen);
        EXPECT_EQ(one.associations()[0].outcome, outcome) << off;
    }
}

TEST(GraphSlam, SameInputSameBits) {
    const SimNoise noise;
    const auto run_once = [&] {
        GraphRun run = corridor_run(noise, 11);
        run.drive(corridor_path(kGraphStep, kMore));
        run.filter.correct(run.registration.close(4));
        return std::pair(run.filter.best_map(), run.filter.best_history());
    };
    const auto [map_a, history_a] = run_once();
    const auto [map_b, history_b] = run_once();
    EXPECT_EQ(history_a, history_b);
    ASSERT_EQ(map_a.size(), map_b.size());
    for (std::size_t i = 0; i < map_a.size(); ++i) {
        EXPECT_EQ(map_a[i].value, map_b[i].value);
        EXPECT_EQ(map_a[i].covariance, map_b[i].covariance);
    }
}

TEST(GraphSlam, NeedsRegistration) {
    EXPECT_TRUE(needs_registration(graph_params()));
    const auto filter = make_filter(graph_params(), 1, 1);
    const Scan scan;
    const Observation seen;
    EXPECT_THROW(filter->step({scan, {}, seen}), ConfigError);
    EXPECT_EQ(filter->steps(), 0U);
    EXPECT_TRUE(filter->best_map().empty());
}

TEST(GraphSlam, ReadsWhatItsEntrySays) {
    EXPECT_TRUE(slam_algorithms().reads("graph-slam", "association.gate_probability"));
    EXPECT_TRUE(slam_algorithms().reads("graph-slam", "association.new_probability"));
    EXPECT_FALSE(slam_algorithms().reads("graph-slam", "filter.particles"));
    EXPECT_FALSE(slam_algorithms().reads("graph-slam", "association.method"));
    EXPECT_FALSE(slam_algorithms().reads("graph-slam", "association.p0"));
}

TEST(GraphSlam, AShortPieceJoinsShortWallsByAQuarterOfThem) {
    // Of walls of 0.6 m it sees 0.2 m, or 0.1 m.
    for (const auto& [end, left] : {std::pair{0.6, 1}, std::pair{0.5, 2}}) {
        GraphSlam filter(graph_params());
        SimRegistration registration({0.0, 0.0}, 1);
        for (int i = 0; i < 4; ++i) {
            const Pose pose{0.3 * i, 0.0, 0.0};
            feed_scan(filter, registration, pose, piece(pose, {{-1.0, -0.4}, {0.4, 1.0}}));
        }
        ASSERT_EQ(filter.best_count(FeatureKind::line), 2);
        const Pose pose{1.2, 0.0, 0.0};
        feed_scan(filter, registration, pose, piece(pose, {{-end, end}}));
        EXPECT_EQ(filter.best_count(FeatureKind::line), left) << end;
    }
}

TEST(GraphSlam, OfADifferenceThatIsNotKnownNothingIsSaid) {
    // Two corners 0.2 m apart, and two walls: known to 0.2 m they are one, to 0.3 m nobody knows.
    PlaceDifference apart;
    apart.value << 0.2, 0.0;
    for (const FeatureKind kind : {FeatureKind::corner, FeatureKind::line}) {
        EXPECT_TRUE(is_none(apart, Vector2(0.04, 0.04).asDiagonal(), kind, 9.0));
        EXPECT_FALSE(is_none(apart, Vector2(0.09, 0.04).asDiagonal(), kind, 9.0));
    }
    EXPECT_FALSE(is_none(apart, Vector2(0.04, 0.09).asDiagonal(), FeatureKind::corner, 9.0));
    EXPECT_TRUE(is_none(apart, Vector2(0.04, 0.09).asDiagonal(), FeatureKind::line, 9.0))
        << "its direction is bounded by what is near";
}

}  // namespace
}  // namespace hitos
