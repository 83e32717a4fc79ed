// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <limits>

#include "association/map_correction.hpp"
#include "ekf/ekf_slam.hpp"
#include "fastslam/filtro_particulas.hpp"
#include "registered_tour.hpp"

namespace hitos {
namespace {

FilterParams registered_params(const std::string& algorithm) {
    FilterParams params;
    params.algorithm = algorithm;
    params.particles = 40;
    params.motion.model = "registered";
    params.observation = {0.003, 0.0003};
    return params;
}

double apart(const Pose& a, const Pose& b) {
    return std::max(
        {std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(wrap_angle(a.theta - b.theta))});
}

void expect_same(const ICaracteristica& a, const ICaracteristica& b, double tolerance) {
    ASSERT_EQ(a.kind(), b.kind());
    if (const auto* line = std::get_if<Recta>(&a.value)) {
        const LineDifference away = difference(*line, std::get<Recta>(b.value));
        EXPECT_LT(std::max(away.rho, away.theta), tolerance);
        EXPECT_GE(line->rho, 0.0);
    } else {
        EXPECT_LT(std::hypot(a.point().x - b.point().x, a.point().y - b.point().y), tolerance);
    }
    EXPECT_LT((a.covariance - b.covariance).cwiseAbs().maxCoeff(), tolerance);
    EXPECT_EQ(a.observations, b.observations);
}

/// That all that a filter has is what another one has, in a world moved by that motion.
void expect_moved(const SlamFilter& filter, const SlamFilter& still, const Pose& motion,
                  double tolerance) {
    EXPECT_LT(apart(filter.best_pose(), compose(motion, still.best_pose())), tolerance);
    const auto expected = still.best_history();
    const auto history = filter.best_history();
    ASSERT_EQ(history.size(), expected.size());
    for (std::size_t k = 0; k < history.size(); ++k) {
        EXPECT_LT(apart(history[k], compose(motion, expected[k])), tolerance);
    }
    const LandmarkMap map = filter.best_map();
    const LandmarkMap known = still.best_map();
    ASSERT_EQ(map.size(), known.size());
    ASSERT_GE(map.size(), 6U);
    for (std::size_t i = 0; i < map.size(); ++i) {
        expect_same(map[i], transform(motion, known[i]), tolerance);
    }
    const auto hypotheses = filter.hypotheses();
    for (std::size_t i = 0; i < hypotheses.size(); ++i) {
        EXPECT_LT(apart(hypotheses[i].pose, compose(motion, still.hypotheses()[i].pose)),
                  tolerance);
        EXPECT_NEAR(hypotheses[i].weight, still.hypotheses()[i].weight, tolerance);
    }
    ASSERT_EQ(filter.associations().size(), still.associations().size());
    for (std::size_t i = 0; i < filter.associations().size(); ++i) {
        EXPECT_EQ(filter.associations()[i].landmark, still.associations()[i].landmark);
    }
}

TEST(Correction, OneMotionForAllScansIsAnotherWorldFrame) {
    const Tour tour = make_tour(80, 0.1);
    const auto path = registered_path(tour, 0.02);
    const Pose motion{3.0, -7.0, 1.9};  // walls change the side of the origin
    for (const char* algorithm : {"fastslam", "ekf-slam"}) {
        const auto still = make_filter(registered_params(algorithm), 1, 1);
        const auto corrected = make_filter(registered_params(algorithm), 1, 1);
        feed_registered(*still, tour, path, 0, 50);
        feed_registered(*corrected, tour, path, 0, 50);
        const std::vector<Pose> motions(50, motion);
        corrected->correct({motions, {}, {}});
        expect_moved(*corrected, *still, motion, 1e-9);
        // From then on equal but for what is left out where h is made linear, which depends on the
        // place of the origin.
        feed_registered(*still, tour, path, 50, 80);
        feed_registered(*corrected, tour, path, 50, 80, motion);
        expect_moved(*corrected, *still, motion, 5e-4);
    }
}

/// A motion for every scan, another for each.
std::vector<Pose> growing_motions(std::size_t scans) {
    std::vector<Pose> motions;
    for (std::size_t k = 0; k < scans; ++k) {
        const auto t = static_cast<double>(k);
        motions.push_back({0.004 * t, -0.003 * t, 0.001 * t});
    }
    return motions;
}

TEST(Correction, HistoriesAndLandmarksFollowTheirScans) {
    const Tour tour = make_tour(61, 0.1);
    const auto path = registered_path(tour, 0.02);
    const auto motions = growing_motions(61);
    for (const char* algorithm : {"fastslam", "ekf-slam"}) {
        const auto filter = make_filter(registered_params(algorithm), 1, 1);
        feed_registered(*filter, tour, path, 0, 60);
        // In the last scan only what stands in this one is seen.
        Observation part = tour.observations[60];
        ASSERT_GE(part.corners.size(), 1U);
        part.lines.clear();
        part.corners.resize(1);
        feed_registered(*filter, path[60], part);
        ASSERT_EQ(filter->associations().size(), 1U);
        ASSERT_EQ(filter->associations()[0].outcome, Association::Outcome::matched);
        const auto seen = static_cast<std::size_t>(filter->associations()[0].landmark);
        const LandmarkMap before = filter->best_map();
        const auto history = filter->best_history();
        std::vector<std::vector<Pose>> all;
        for (std::size_t i = 0; i < filter->hypotheses().size(); ++i) {
            all.push_back(filter->history(i));
        }
        filter->correct({motions, {}, {}});
        const LandmarkMap after = filter->best_map();
        ASSERT_EQ(after.size(), before.size());
        expect_same(after[seen], transform(motions[60], before[seen]), 1e-9);
        int of_scans_before = 0;
        for (std::size_t i = 0; i < after.size(); ++i) {
            const ICaracteristica wrong = transform(motions[60], before[i]);
            if (std::hypot(wrong.point().x - after[i].point().x,
                           wrong.point().y - after[i].point().y) > 1e-3) {
                ++of_scans_before;
            }
        }
        EXPECT_GE(of_scans_before, 2) << algorithm;
        for (std::size_t k = 0; k < history.size(); ++k) {
            EXPECT_LT(apart(filter->best_history()[k], compose(motions[k], history[k])), 1e-12);
        }
        for (std::size_t i = 0; i < all.size(); ++i) {  // each once, though they share their past
            const auto moved = filter->history(i);
            for (std::size_t k = 0; k < moved.size(); ++k) {
                EXPECT_LT(apart(moved[k], compose(motions[k], all[i][k])), 1e-12) << i << " " << k;
            }
        }
    }
}

TEST(Correction, OnlyForMotionThatFollowsRegistration) {
    const Tour tour = make_tour(20, 0.1);
    FilterParams params;
    for (const char* algorithm : {"fastslam", "ekf-slam"}) {
        params.algorithm = algorithm;
        const auto filter = make_filter(params, 1, 1);
        for (std::size_t k = 0; k < 20; ++k) {
            feed(*filter, tour.controls[k], tour.observations[k]);
        }
        const Pose pose = filter->best_pose();
        filter->correct({growing_motions(20), {}, {}});
        EXPECT_EQ(filter->best_pose(), pose);
        const auto registered = make_filter(registered_params(algorithm), 1, 1);
        const RegisteredStep first;
        feed_registered(*registered, first, Observation{});
        EXPECT_THROW(registered->correct({growing_motions(2), {}, {}}), std::invalid_argument);
    }
}

/// A wall x = rho before the robot, between two heights.
void add_wall(Observation& seen, double rho, double low, double high) {
    DetectedLine line;
    line.recta = {rho, 0.0};
    line.first = static_cast<std::uint32_t>(seen.support.size());
    for (int i = 0; i <= 10; ++i) seen.support.push_back({rho, low + 0.1 * i * (high - low)});
    line.count = 11;
    seen.lines.push_back(line);
}

/// The same wall and corner seen at scan 0 and, after a drift, at scan 1 beside another wall; then
/// scan 1 is corrected.
std::unique_ptr<SlamFilter> after_a_loop(const std::string& algorithm, double second_low,
                                         double second_high) {
    auto filter = make_filter(registered_params(algorithm), 1, 1);
    Observation seen;
    add_wall(seen, 4.0, -1.0, 1.0);
    seen.corners.push_back({4.0, 1.0});
    RegisteredStep step;
    feed_registered(*filter, step, seen);
    feed_registered(*filter, step, seen);
    step.pose = {1.0, 0.0, 0.0};
    step.path_m = 1.0;
    Observation again;  // 0.8 m off
    add_wall(again, 7.0, -1.0, 1.0);
    add_wall(again, 3.8, second_low, second_high);
    again.corners.push_back({3.8, 1.0});
    feed_registered(*filter, step, again);
    return filter;
}

TEST(Correction, LandmarksLaidUponEachOtherBecomeOne) {
    for (const char* algorithm : {"fastslam", "ekf-slam"}) {
        const auto filter = after_a_loop(algorithm, -0.5, 2.0);
        ASSERT_EQ(filter->best_map().size(), 5U);
        const std::vector<Pose> motions{{}, {}, {-0.8, 0.0, 0.0}};
        filter->correct({motions, {}, {}});
        const LandmarkMap map = filter->best_map();
        ASSERT_EQ(map.size(), 3U) << algorithm;
        EXPECT_NEAR(std::get<Recta>(map[0].value).rho, 4.0, 0.05);
        EXPECT_EQ(map[0].observations, 3);
        EXPECT_NEAR(std::get<Recta>(map[1].value).rho, 7.2, 0.05);
        EXPECT_EQ(map[1].observations, 1);
        EXPECT_NEAR(map[2].point().x, 4.0, 0.05);
        EXPECT_EQ(map[2].observations, 3);
        // What the last scan saw is where it now is in the map.
        ASSERT_EQ(filter->associations().size(), 3U);
        EXPECT_EQ(filter->associations()[0].landmark, 1);
        EXPECT_EQ(filter->associations()[1].landmark, 0);
        EXPECT_EQ(filter->associations()[2].landmark, 2);
        // And the map goes on: the next scan finds both walls in it.
        RegisteredStep step;
        step.before = step.pose = {0.2, 0.0, 0.0};
        Observation seen;
        add_wall(seen, 7.0, -1.0, 1.0);
        add_wall(seen, 3.8, -0.5, 1.0);
        feed_registered(*filter, step, seen);
        EXPECT_EQ(filter->best_map().size(), 3U);
        EXPECT_EQ(filter->associations()[0].landmark, 1);
        EXPECT_EQ(filter->associations()[1].landmark, 0);
    }
}

TEST(Correction, APieceThatWasTakenInReachesToTheNextOne) {
    for (const char* algorithm : {"fastslam", "ekf-slam"}) {
        const auto filter = after_a_loop(algorithm, -0.5, 2.0);
        std::vector<Pose> motions{{}, {}, {-0.8, 0.0, 0.0}};
        filter->correct({motions, {}, {}});
        ASSERT_EQ(filter->best_count(FeatureKind::line), 2) << algorithm;
        RegisteredStep step;
        step.before = {0.2, 0.0, 0.0};
        step.pose = {1.0, 0.0, 0.0};
        step.path_m = 1.0;
        Observation beyond;  // 0.8 m off once more, 0.3 m beyond the second piece, 1.3 m the first
        add_wall(beyond, 3.8, 2.3, 3.0);
        feed_registered(*filter, step, beyond);
        ASSERT_EQ(filter->best_count(FeatureKind::line), 3) << algorithm;
        motions = {{}, {}, {}, {-0.8, 0.0, 0.0}};
        filter->correct({motions, {}, {}});
        EXPECT_EQ(filter->best_count(FeatureKind::line), 2) << algorithm;
    }
}

TEST(Correction, PiecesWithAGapBetweenThemStayTwo) {
    for (const char* algorithm : {"fastslam", "ekf-slam"}) {
        for (const auto& [gap, lines] : {std::pair{0.4, 2}, std::pair{0.6, 3}}) {
            const auto filter = after_a_loop(algorithm, 1.0 + gap, 3.0);
            const std::vector<Pose> motions{{}, {}, {-0.8, 0.0, 0.0}};
            filter->correct({motions, {}, {}});
            EXPECT_EQ(filter->best_count(FeatureKind::line), lines) << algorithm << gap;
        }
    }
}

TEST(KeptLandmark, ExtentsFollowTheirPoints) {
    const Recta line{20.0, 0.7};
    const PreparedRecta prepared(line);
    const Extent extent{-3.0, 5.0};
    // Another estimate of it, which even lies on the other side of the origin's normal form.
    for (const Recta& other : {Recta{20.1, 0.703}, Recta{-20.0, 0.7 - kPi}, Recta{20.0, 0.695}}) {
        const Extent carried = SensorRecta::carried(extent, line, other);
        const PreparedRecta after(other);
        const double a = after.along(prepared.at(-3.0));
        const double b = after.along(prepared.at(5.0));
        EXPECT_NEAR(carried.low, std::min(a, b), 1e-12);
        EXPECT_NEAR(carried.high, std::max(a, b), 1e-12);
    }
    KeptLandmark<SensorRecta> kept{{line, Matrix2::Identity()}, extent, {}};
    const Pose motion{-40.0, 3.0, 2.5};
    move(kept, motion);
    const PreparedRecta after(kept.estimate.mean);
    EXPECT_GE(kept.estimate.mean.rho, 0.0);
    const Point2 low = transform(motion, prepared.at(-3.0));
    const Point2 high = transform(motion, prepared.at(5.0));
    EXPECT_NEAR(kept.extent.low, std::min(after.along(low), after.along(high)), 1e-9);
    EXPECT_NEAR(kept.extent.high, std::max(after.along(low), after.along(high)), 1e-9);
    EXPECT_NEAR(after.signed_distance(low), 0.0, 1e-9);
    // Nothing known is the whole line, wherever it goes.
    kept.extent = {};
    move(kept, motion);
    EXPECT_EQ(kept.extent.gap({-1.0, 1.0}), -2.0);
}

TEST(KeptLandmark, ExtentsLieWhereTheyWereSeen) {
    const Pose pose{3.0, -2.0, 2.4};
    const Point2 from{1.5, 0.7};
    const Point2 to{1.4, 2.9};
    for (const Recta& line : {Recta{2.0, 0.3}, Recta{-2.0, 0.3 - kPi}, Recta{9.0, -2.8}}) {
        const PreparedRecta prepared(line);
        const double a = prepared.along(transform(pose, from));
        const double b = prepared.along(transform(pose, to));
        const Extent seen = SensorRecta::placed({true, true, from, to}, pose, line);
        EXPECT_NEAR(seen.low, std::min(a, b), 1e-12);
        EXPECT_NEAR(seen.high, std::max(a, b), 1e-12);
        const bool behind = prepared.signed_distance({pose.x, pose.y}) > 0.0;
        EXPECT_EQ(seen.side, behind ? -1.0 : 1.0);
        const Extent unknown = SensorRecta::placed({}, pose, line);
        EXPECT_EQ(unknown.side, 0.0);
        EXPECT_EQ(unknown.length(), std::numeric_limits<double>::infinity());
    }
}

TEST(KeptLandmark, FusionAddsInformation) {
    Matrix2 pa;
    pa << 0.04, 0.01, 0.01, 0.01;
    Matrix2 pb;
    pb << 0.02, -0.005, -0.005, 0.03;
    KeptLandmark<SensorRecta> a{{{3.0, 0.5}, pa}, {-1.0, 1.0}, {4, 7}};
    // The same wall on the other side of the origin's normal form: (-rho, theta + pi).
    KeptLandmark<SensorRecta> b{{{-3.1, wrap_angle(0.55 + kPi)}, pb}, {-2.0, 0.0}, {5, 6}};
    Matrix2 f = Matrix2::Identity();
    f(0, 0) = -1.0;
    const Matrix2 pb_turned = f * pb * f;
    const Matrix2 information = pa.inverse() + pb_turned.inverse();
    const Vector2 expected = information.inverse() * (pa.inverse() * Vector2(3.0, 0.5) +
                                                      pb_turned.inverse() * Vector2(3.1, 0.55));
    fuse(a, b);
    EXPECT_NEAR(a.estimate.mean.rho, expected(0), 1e-12);
    EXPECT_NEAR(a.estimate.mean.theta, expected(1), 1e-12);
    EXPECT_LT((a.estimate.covariance - information.inverse()).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_EQ(a.record.observations, 9);
    EXPECT_EQ(a.record.last_seen, 7U);
    EXPECT_GT(a.extent.high, 1.9);  // b's -2 … 0 is 0 … 2 here
    EXPECT_LT(a.extent.low, -0.9);
}

TEST(EkfCorrection, JointCovarianceIsCarriedByTheJacobian) {
    const Tour tour = make_tour(60, 0.1);
    const auto path = registered_path(tour, 0.02);
    const auto motions = growing_motions(60);
    EkfSlam filter(registered_params("ekf-slam"));
    std::vector<std::size_t> last_seen(4, 0);
    for (std::size_t k = 0; k < 60; ++k) {
        Observation lines = tour.observations[k];
        lines.corners.clear();
        if (k == 59 && lines.lines.size() > 1) lines.lines.resize(1);
        feed_registered(filter, path[k], lines);
        for (const Association& association : filter.associations()) {
            if (association.landmark >= 0) {
                last_seen.at(static_cast<std::size_t>(association.landmark)) = k;
            }
        }
    }
    const LandmarkMap map = filter.best_map();
    ASSERT_EQ(map.size(), 4U);  // of one kind, so in the order of their creation
    const Pose pose = filter.best_pose();
    Eigen::VectorXd state(11);
    state << pose.x, pose.y, pose.theta, Eigen::VectorXd::Zero(8);
    for (std::size_t i = 0; i < 4; ++i) {
        const auto at = static_cast<Eigen::Index>(3 + 2 * i);
        state.segment<2>(at) = SensorRecta::to_state(std::get<Recta>(map[i].value));
    }
    const auto corrected = [&](const Eigen::VectorXd& x) {
        Eigen::VectorXd y = x;
        const Pose after = compose(motions[59], {x(0), x(1), x(2)});
        y.head<3>() << after.x, after.y, after.theta;
        for (std::size_t i = 0; i < 4; ++i) {
            const auto at = static_cast<Eigen::Index>(3 + 2 * i);
            y.segment<2>(at) =
                SensorRecta::to_state(transform(motions[last_seen[i]], Recta{x(at), x(at + 1)}));
        }
        return y;
    };
    Eigen::MatrixXd jacobian(11, 11);
    constexpr double kStep = 1e-6;
    for (Eigen::Index k = 0; k < 11; ++k) {
        Eigen::VectorXd plus = state;
        Eigen::VectorXd minus = state;
        plus(k) += kStep;
        minus(k) -= kStep;
        Eigen::VectorXd slope = corrected(plus) - corrected(minus);
        for (const Eigen::Index angle : {2, 4, 6, 8, 10}) slope(angle) = wrap_angle(slope(angle));
        jacobian.col(k) = slope / (2.0 * kStep);
    }
    const Eigen::MatrixXd expected = jacobian * filter.covariance() * jacobian.transpose();
    filter.correct({motions, {}, {}});
    const double scale = expected.cwiseAbs().maxCoeff();
    EXPECT_LT((filter.covariance() - expected).cwiseAbs().maxCoeff(), 1e-7 * scale);
    const Eigen::VectorXd mean = corrected(state);
    EXPECT_LT(apart(filter.best_pose(), {mean(0), mean(1), mean(2)}), 1e-12);
    EXPECT_NEAR(std::get<Recta>(filter.best_map()[2].value).rho, mean(7), 1e-12);
}

TEST(JointState, JoiningIsAMeasurementOfTheDifferenceAndRemovingMarginalises) {
    JointState state;
    Matrix3 start;
    start << 0.04, 0.01, 0.0, 0.01, 0.03, 0.002, 0.0, 0.002, 0.01;
    state.move({1.0, 2.0, 0.3}, Matrix3::Identity(), start);
    Matrix23 g;
    g << 0.8, 0.6, 0.4, 0.0, 0.0, 1.0;
    Matrix2 own;
    own << 0.01, 0.001, 0.001, 0.002;
    const Eigen::Index a = state.append({3.0, 0.5}, g, own);
    const Eigen::Index b = state.append({1.0, -0.5}, 0.5 * g, 2.0 * own);
    const Eigen::Index c = state.append({-3.1, 0.6}, -g, 3.0 * own);
    const Eigen::MatrixXd p = state.covariance();
    Eigen::MatrixXd h = Eigen::MatrixXd::Zero(2, 9);
    h.block<2, 2>(0, a) = Matrix2::Identity();
    h(0, c) = 1.0;  // sign -1: first component of the second turned
    h(1, c + 1) = -1.0;
    const Vector2 nu(0.1, -0.1);
    const Matrix2 r = 0.001 * Matrix2::Identity();
    const Eigen::MatrixXd s = h * p * h.transpose();
    EXPECT_LT((state.difference_covariance(a, c, -1.0) - s).norm(), 1e-15);
    const Eigen::MatrixXd k = p * h.transpose() * (s + r).inverse();
    const Eigen::MatrixXd after = p - k * h * p;
    const Eigen::VectorXd shift = -k * nu;
    state.join(a, c, nu, -1.0, r);
    EXPECT_LT((state.covariance() - after).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_NEAR(state.pose().x, 1.0 + shift(0), 1e-12);
    EXPECT_LT((state.landmark(b) - Vector2(1.0, -0.5) - shift.segment<2>(b)).norm(), 1e-12);
    state.remove(b);
    ASSERT_EQ(state.size(), 7);
    EXPECT_LT((state.landmark(b) - Vector2(-3.1, 0.6) - shift.segment<2>(c)).norm(), 1e-12);
    Eigen::MatrixXd rest(7, 7);
    const std::vector<Eigen::Index> left{0, 1, 2, 3, 4, 7, 8};
    for (std::size_t i = 0; i < 7; ++i) {
        for (std::size_t j = 0; j < 7; ++j) {
            rest(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
                after(left[i], left[j]);
        }
    }
    EXPECT_LT((state.covariance() - rest).cwiseAbs().maxCoeff(), 1e-12);
}

}  // namespace
}  // namespace hitos
