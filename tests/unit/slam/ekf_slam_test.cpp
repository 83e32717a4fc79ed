// SPDX-License-Identifier: GPL-3.0-or-later
#include "ekf/ekf_slam.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "hitos/base/error.hpp"
#include "hitos/slam/filters.hpp"
#include "room_tour.hpp"
#include "slow_ekf_slam.hpp"

namespace hitos {
namespace {

using Eigen::MatrixXd;

FilterParams ekf_params() {
    FilterParams params;
    params.algorithm = "ekf-slam";
    return params;
}

void compare_ekf_with_slow(const FilterParams& params, const Tour& tour) {
    EkfSlam fast(params);
    SlowEkfSlam slow(params);
    for (std::size_t k = 0; k < tour.controls.size(); ++k) {
        feed(fast, tour.controls[k], tour.observations[k]);
        slow.step(tour.controls[k], tour.observations[k]);
        const MatrixXd covariance = fast.covariance();
        ASSERT_EQ(covariance.rows(), slow.covariance().rows()) << "step " << k;
        ASSERT_NEAR(fast.best_pose().x, slow.pose().x, 1e-6) << "step " << k;
        ASSERT_NEAR(fast.best_pose().y, slow.pose().y, 1e-6);
        ASSERT_NEAR(wrap_angle(fast.best_pose().theta - slow.pose().theta), 0.0, 1e-6);
        ASSERT_LT((covariance - slow.covariance()).cwiseAbs().maxCoeff(), 1e-6) << "step " << k;
    }
    EXPECT_GE(fast.best_count(FeatureKind::line), 3);
    EXPECT_GE(fast.best_count(FeatureKind::corner), 3);
}

TEST(EkfSlam, EqualsTheTextbook) {
    compare_ekf_with_slow(ekf_params(), make_tour(120, 0.1));
}

TEST(EkfSlam, EqualsTheTextbookWithProportionalNoise) {
    FilterParams params = ekf_params();
    params.motion.model = "proportional";
    params.observation = {0.001, 0.0001};
    compare_ekf_with_slow(params, make_tour(120, 0.1));
}

TEST(EkfSlam, EqualsTheTextbookWithCovariancesOfItsOwnForEveryFeature) {
    compare_ekf_with_slow(ekf_params(), with_covariances(make_tour(120, 0.1)));
}

TEST(EkfSlam, EqualsTheTextbookWithoutOdometry) {
    FilterParams params = ekf_params();
    params.motion = {"no-odometry", 0.1, 0.1, 0.05};
    compare_ekf_with_slow(params, make_tour(60, 0.1));
}

/// Three walls and a field of corners, of which only those nearby are seen: far more than the
/// filter has at hand at a time.
Tour tour_of_a_field() {
    Tour tour;
    std::mt19937 engine(67);
    std::normal_distribution<double> normal(0.0, 1.0);
    Pose pose;
    for (int k = 0; k < 80; ++k) {
        const Control control{{1.0, 0.0, 0.16}, k == 0 ? 0.0 : 0.5};
        pose = compose(pose, displacement(control.twist, control.duration_s));
        Control logged = control;
        logged.twist.v *= 1.0 + 0.05 * normal(engine);
        tour.controls.push_back({logged});
        tour.truth.push_back(pose);
        Observation seen;
        for (const Recta& wall : {Recta{20.0, 0.1}, Recta{21.0, 1.7}, Recta{22.0, -1.5}}) {
            Recta local = transform(inverse(pose), wall);
            local.rho += 0.01 * normal(engine);
            seen.lines.push_back({local, 0, 0});
        }
        for (int i = 0; i < 64; ++i) {
            const int row = i / 8;
            Esquina local = transform(inverse(pose), Esquina{2.5 * (i % 8) - 9.0, 2.5 * row - 3.0});
            local.x += 0.01 * normal(engine);
            local.y += 0.01 * normal(engine);
            if (std::hypot(local.x, local.y) < 3.5) seen.corners.push_back(local);
        }
        tour.observations.push_back(seen);
    }
    return tour;
}

TEST(EkfSlam, EqualsTheTextbookWithMoreLandmarksThanAreAtHand) {
    FilterParams params = ekf_params();
    params.motion.model = "proportional";
    params.observation = {0.001, 0.0001};
    const Tour tour = tour_of_a_field();
    compare_ekf_with_slow(params, tour);
    EkfSlam filter(params);
    for (std::size_t k = 0; k < tour.controls.size(); ++k) {
        feed(filter, tour.controls[k], tour.observations[k]);
    }
    EXPECT_GT(filter.best_count(FeatureKind::corner), 40);
}

/// A wall right behind the start, seen by a robot that has gone 2 m ahead, and a corner: whose
/// side of the origin the wall lies on is not certain.
Tour tour_beside_the_origin() {
    Tour tour;
    std::mt19937 engine(61);
    std::normal_distribution<double> normal(0.0, 1.0);
    Pose pose;
    // Such that the mean changes its sign with every one of them.
    constexpr std::array<double, 5> kFirst{0.05, -0.12, 0.16, -0.22, 0.0};
    for (std::size_t k = 0; k < 60; ++k) {
        const Control control{{k < 20 ? 0.5 : 0.0, 0.0, k < 20 ? 0.0 : 0.1}, 0.2};
        pose = compose(pose, displacement(control.twist, control.duration_s));
        Observation seen;
        if (k >= 20) {
            Recta wall = transform(inverse(pose), Recta{0.0, 0.0});
            wall.rho += kFirst[std::min<std::size_t>(k - 20, 4)] + 0.01 * normal(engine);
            Esquina corner = transform(inverse(pose), Esquina{3.0, 1.0});
            corner.x += 0.01 * normal(engine);
            seen.lines.push_back({wall, 0, 0});
            seen.corners.push_back(corner);
        }
        tour.controls.push_back({control});
        tour.truth.push_back(pose);
        tour.observations.push_back(seen);
    }
    return tour;
}

TEST(EkfSlam, ALineThatFlipsStaysTheTextbooks) {
    const Tour tour = tour_beside_the_origin();
    EkfSlam fast(ekf_params());
    SlowEkfSlam slow(ekf_params());
    int flips = 0;
    double cosine = 0.0;
    for (std::size_t k = 0; k < tour.controls.size(); ++k) {
        feed(fast, tour.controls[k], tour.observations[k]);
        slow.step(tour.controls[k], tour.observations[k]);
        if (tour.observations[k].empty()) continue;
        const double now = std::cos(std::get<Recta>(fast.best_map().at(0).value).theta);
        if (now * cosine < 0.0) ++flips;
        cosine = now;
        ASSERT_EQ(fast.best_map().size(), 2U) << "step " << k;
        ASSERT_LT((fast.covariance() - slow.covariance()).cwiseAbs().maxCoeff(), 1e-6) << k;
    }
    EXPECT_GT(flips, 0);
}

TEST(EkfSlam, WhereNothingCanBeComparedNothingIsNew) {
    EkfSlam filter(ekf_params());
    Observation seen;
    seen.lines.push_back({{3.0, 0.0}, 0, 0});
    feed(filter, {}, seen);
    seen.lines[0].recta.rho = 3.1;
    seen.line_covariances.emplace_back(-10.0 * Matrix2::Identity());  // S is not positive
    feed(filter, {}, seen);
    EXPECT_EQ(filter.associations()[0].outcome, Association::Outcome::ignored);
    EXPECT_EQ(filter.best_count(FeatureKind::line), 1);
}

TEST(JointState, AnUpdateThatCannotBeComputedChangesNothing) {
    JointState state;
    const Eigen::Index at = state.append({3.0, 0.0}, Matrix23::Zero(), 0.01 * Matrix2::Identity());
    const MatrixXd before = state.covariance();
    const JointState::Row row{
        at, {0.1, 0.1}, Matrix23::Zero(), Matrix2::Identity(), -Matrix2::Identity()};
    state.update(std::span(&row, 1));
    EXPECT_EQ(state.landmark(at), Vector2(3.0, 0.0));
    EXPECT_EQ(state.covariance(), before);
}

TEST(EkfSlam, MapsTheRoom) {
    const Tour tour = make_tour(300, 0.1);
    EkfSlam filter(ekf_params());
    double odometry_error = 0.0;
    Pose odometry;
    for (std::size_t k = 0; k < tour.controls.size(); ++k) {
        feed(filter, tour.controls[k], tour.observations[k]);
        odometry = make_robot(MotionParams{})->mean(odometry, sum_controls(tour.controls[k]));
        odometry_error = std::hypot(odometry.x - tour.truth[k].x, odometry.y - tour.truth[k].y);
    }
    EXPECT_EQ(filter.best_count(FeatureKind::line), 4);
    EXPECT_EQ(filter.best_count(FeatureKind::corner), 4);
    const double error = std::hypot(filter.best_pose().x - tour.truth.back().x,
                                    filter.best_pose().y - tour.truth.back().y);
    EXPECT_LT(error, 0.1);
    EXPECT_LT(error, odometry_error);
    for (const ICaracteristica& landmark : filter.best_map()) {
        if (const auto* line = std::get_if<Recta>(&landmark.value)) {
            EXPECT_NEAR(line->rho, 5.0, 0.1);
        }
        EXPECT_GT(landmark.observations, 50);
        EXPECT_GT(landmark.covariance.determinant(), 0.0);
    }
    EXPECT_EQ(filter.best_history().size(), tour.controls.size());
}

TEST(EkfSlam, CovarianceIsPositiveAfterTenThousandSteps) {  // symmetric it is by construction
    const Tour tour = make_tour(10000, 0.1);
    FilterParams params = ekf_params();
    params.motion.model = "proportional";
    params.observation = {1e-4, 1e-5};
    EkfSlam filter(params);
    double least = 1e300;
    for (std::size_t k = 0; k < tour.controls.size(); ++k) {
        feed(filter, tour.controls[k], tour.observations[k]);
        if (k % 500 != 499) continue;
        const MatrixXd covariance = filter.covariance();
        const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(covariance);
        least = std::min(least, solver.eigenvalues().minCoeff());
    }
    EXPECT_EQ(filter.steps(), 10000U);
    EXPECT_GT(filter.best_count(FeatureKind::line) + filter.best_count(FeatureKind::corner), 7);
    EXPECT_GT(least, 0.0);
}

TEST(EkfSlam, ALandmarkIsNeverSurerThanTheStartAllows) {
    // A robot that is unsure of its place when it first sees a wall never gets to know the wall
    // better than that: the landmarks' limit covariance (Dissanayake et al., 2001).
    FilterParams params = ekf_params();
    params.motion = {"odometry", 0.2, 0.2, 0.0};
    params.observation = {1e-4, 1e-6};
    params.association.ambiguity = AmbiguityRule::off;
    EkfSlam filter(params);
    feed(filter, {}, Observation{});
    const Control control{{0.1, 0.0, 0.0}, 1.0};
    feed(filter, std::span(&control, 1), Observation{});  // now unsure by 0.2 m
    Observation seen;
    seen.lines.push_back({{3.0, 0.0}, 0, 0});
    for (int k = 0; k < 200; ++k) feed(filter, {}, seen);
    const double var_rho = filter.best_map().at(0).covariance(0, 0);
    EXPECT_GE(var_rho, 0.04);
    EXPECT_LT(var_rho, 0.04 + 1e-4);
}

TEST(EkfSlam, GatesPartMatchedIgnoredAndNew) {
    FilterParams params = ekf_params();
    params.observation = {0.01, 0.01};  // sigma 0.1, alone in the innovation: 0.141
    EkfSlam filter(params);
    const auto outcome = [&](double rho) {
        Observation seen;
        seen.lines.push_back({{rho, 0.0}, 0, 0});
        EkfSlam copy = filter;
        feed(copy, {}, seen);
        return copy.associations()[0].outcome;
    };
    Observation seen;
    seen.lines.push_back({{3.0, 0.0}, 0, 0});
    feed(filter, {}, seen);
    EXPECT_EQ(filter.associations()[0].outcome, Association::Outcome::created);
    const double sigma = std::sqrt(0.02);
    // Square roots of the chi-square gates with 2 degrees of freedom: 2.448 and 4.292.
    EXPECT_EQ(outcome(3.0 + 2.44 * sigma), Association::Outcome::matched);
    EXPECT_EQ(outcome(3.0 + 2.46 * sigma), Association::Outcome::ignored);
    EXPECT_EQ(outcome(3.0 + 4.28 * sigma), Association::Outcome::ignored);
    EXPECT_EQ(outcome(3.0 + 4.30 * sigma), Association::Outcome::created);
}

TEST(EkfSlam, AnAmbiguousObservationChangesNoLandmark) {
    FilterParams params = ekf_params();
    params.observation = {0.01, 0.01};
    params.association.ambiguity_ratio = 0.1;
    for (const AmbiguityRule rule : {AmbiguityRule::keep_likelihood, AmbiguityRule::off}) {
        params.association.ambiguity = rule;
        params.association.new_probability = 0.95;
        EkfSlam filter(params);
        Observation walls;
        walls.lines.push_back({{3.0, 0.0}, 0, 0});
        walls.lines.push_back({{3.4, 0.0}, 0, 0});
        feed(filter, {}, walls);
        ASSERT_EQ(filter.best_count(FeatureKind::line), 2);
        Observation between;
        between.lines.push_back({{3.21, 0.0}, 0, 0});
        feed(filter, {}, between);
        EXPECT_EQ(filter.associations()[0].outcome, rule == AmbiguityRule::off
                                                        ? Association::Outcome::matched
                                                        : Association::Outcome::ignored);
        EXPECT_EQ(filter.associations()[0].landmark, rule == AmbiguityRule::off ? 1 : -1);
        EXPECT_EQ(filter.best_count(FeatureKind::line), 2);
    }
}

TEST(EkfSlam, VariancesNextToNothingBreakNothing) {
    // Far below what doubles can tell apart beside the pose's variance.
    FilterParams params = ekf_params();
    params.observation = {1e-12, 1e-12};
    params.motion = {"odometry", 1.0, 1.0, 0.5};
    const Tour tour = make_tour(400, 0.1);
    EkfSlam filter(params);
    for (std::size_t k = 0; k < tour.controls.size(); ++k) {
        feed(filter, tour.controls[k], tour.observations[k]);
    }
    EXPECT_TRUE(std::isfinite(filter.best_pose().x));
    EXPECT_TRUE(filter.covariance().allFinite());
    EXPECT_LT(filter.best_count(FeatureKind::line) + filter.best_count(FeatureKind::corner),
              2500);  // what was seen: 1,800 or so
}

TEST(EkfSlam, AssociationsPointIntoTheMap) {
    EkfSlam filter(ekf_params());
    Observation seen;
    seen.corners.push_back({2.0, 2.0});
    feed(filter, {}, seen);
    EXPECT_EQ(filter.associations()[0].landmark, 0);
    seen.lines.push_back({{4.0, 1.0}, 0, 0});  // lines come first in the map
    feed(filter, {}, seen);
    ASSERT_EQ(filter.associations().size(), 2U);
    const LandmarkMap map = filter.best_map();
    for (const Association& association : filter.associations()) {
        ASSERT_GE(association.landmark, 0);
        EXPECT_EQ(map.at(static_cast<std::size_t>(association.landmark)).kind(), association.kind);
    }
    EXPECT_EQ(filter.associations()[0].outcome, Association::Outcome::created);
    EXPECT_EQ(filter.associations()[1].outcome, Association::Outcome::matched);
    EXPECT_EQ(map[1].observations, 2);
}

TEST(EkfSlam, TheJointCovarianceIsInTheOrderOfTheMap) {
    EkfSlam filter(ekf_params());
    Observation seen;
    seen.corners.push_back({2.0, 2.0});
    feed(filter, {}, seen);
    seen.lines.push_back({{4.0, 1.0}, 0, 0});  // made later, but lines come first in the map
    const Control control{{0.1, 0.0, 0.05}, 1.0};
    feed(filter, std::span(&control, 1), seen);
    const LandmarkMap map = filter.best_map();
    ASSERT_EQ(map.size(), 2U);
    const MatrixXd joint = filter.joint_covariance();
    const MatrixXd as_made = filter.covariance();
    ASSERT_EQ(joint.rows(), 7);
    EXPECT_EQ(joint, joint.transpose());
    EXPECT_EQ((joint.block<3, 3>(0, 0)), filter.pose_covariance());
    EXPECT_EQ((joint.block<2, 2>(3, 3)), map[0].covariance);
    EXPECT_EQ((joint.block<2, 2>(5, 5)), map[1].covariance);
    EXPECT_EQ((joint.block<2, 3>(3, 0)), (as_made.block<2, 3>(5, 0)));
    EXPECT_EQ((joint.block<2, 2>(3, 5)), (as_made.block<2, 2>(5, 3)));
    EXPECT_GT((joint.block<2, 3>(3, 0).norm()), 0.0);
}

TEST(EkfSlam, TheWeightIsTheProductOfTheLikelihoods) {
    FilterParams params = ekf_params();
    params.observation = {0.01, 0.01};
    EkfSlam filter(params);
    Observation seen;
    seen.lines.push_back({{3.0, 0.0}, 0, 0});
    feed(filter, {}, seen);
    EXPECT_EQ(filter.statistics().best_log_weight, 0.0);  // a new landmark says nothing
    seen.lines[0].recta.rho = 3.05;
    feed(filter, {}, seen);
    // S = P + R = 0.02 I, nu = (0.05, 0).
    const double first = -std::log(2.0 * kPi * 0.02) - 0.5 * 0.05 * 0.05 / 0.02;
    EXPECT_NEAR(filter.statistics().best_log_weight, first, 1e-9);
    seen.lines[0].recta.rho = 3.025;  // where the landmark now is: P = 0.005 I
    feed(filter, {}, seen);
    EXPECT_NEAR(filter.statistics().best_log_weight, first - std::log(2.0 * kPi * 0.015), 1e-9);
}

TEST(EkfSlam, ReadsWhatItsEntrySays) {
    EXPECT_EQ(slam_algorithms().words(), "fastslam, ekf-slam, graph-slam");
    EXPECT_TRUE(slam_algorithms().reads("ekf-slam", "association.new_probability"));
    EXPECT_FALSE(slam_algorithms().reads("fastslam", "association.new_probability"));
    EXPECT_FALSE(slam_algorithms().reads("ekf-slam", "filter.particles"));
    for (const char* algorithm : {"fastslam", "ekf-slam"}) {
        EXPECT_TRUE(slam_algorithms().reads(algorithm, "association.gate_probability"));
        EXPECT_TRUE(slam_algorithms().reads(algorithm, "motion.model"));  // nobody's own
    }
}

TEST(EkfSlam, FactoryRefusesImpossibleValues) {
    FilterParams params = ekf_params();
    EXPECT_NE(make_filter(params, 1, 1), nullptr);
    params.association.new_probability = 0.9;  // below the gate
    EXPECT_THROW(make_filter(params, 1, 1), ConfigError);
    params = ekf_params();
    params.observation.var_rho_m2 = 0.0;
    EXPECT_THROW(make_filter(params, 1, 1), ConfigError);
}

}  // namespace
}  // namespace hitos
