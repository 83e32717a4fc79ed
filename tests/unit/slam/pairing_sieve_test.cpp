// SPDX-License-Identifier: GPL-3.0-or-later
#include "ekf/pairing_sieve.hpp"

#include <gtest/gtest.h>

#include <random>

#include "ekf/ekf_slam.hpp"
#include "hitos/slam/association_record.hpp"
#include "room_tour.hpp"

namespace hitos {
namespace {

/// A field of walls and corners, some next to each other, and a robot that drives through it.
Tour make_sieve_tour(int steps, double noise) {
    std::mt19937 engine(71);
    std::uniform_real_distribution<double> place(-15.0, 15.0);
    std::normal_distribution<double> normal;
    std::vector<Recta> walls;
    std::vector<Esquina> corners;
    for (int i = 0; i < 60; ++i) {
        corners.push_back({place(engine), place(engine)});
        corners.push_back({corners.back().x + 0.3, corners.back().y});
        walls.push_back(normalized({place(engine), 0.2 * place(engine)}));
        walls.push_back(normalized({walls.back().rho + 0.2, walls.back().theta}));
    }
    walls.push_back({0.0, 0.3});  // through where the robot begins
    Tour tour;
    Pose pose;
    std::uniform_int_distribution<std::size_t> any(0, walls.size() - 2);
    for (int k = 0; k < steps; ++k) {
        const Control control{{0.5, 0.0, 0.1}, k == 0 ? 0.0 : 0.5};
        pose = compose(pose, displacement(control.twist, control.duration_s));
        Observation seen;
        for (int i = 0; i < 4; ++i) {
            Recta wall = transform(inverse(pose), walls[i == 0 ? walls.size() - 1 : any(engine)]);
            wall.rho += noise * normal(engine);
            wall.theta += 0.3 * noise * normal(engine);
            seen.lines.push_back({normalized(wall), 0, 0});
            Esquina corner = transform(inverse(pose), corners[any(engine)]);
            corner.x += noise * normal(engine);
            corner.y += noise * normal(engine);
            seen.corners.push_back(corner);
        }
        if (k == 20) seen.corners.push_back({1e-4, 0.0});  // right at the robot
        tour.controls.push_back({control});
        tour.truth.push_back(pose);
        tour.observations.push_back(seen);
    }
    return tour;
}

/// A step that is recorded compares with all landmarks, others only with what the sieve leaves.
void expect_the_same_decisions(const FilterParams& params, const Tour& tour) {
    EkfSlam sieved(params);
    EkfSlam asked(params);
    std::array<int, 3> outcomes{};
    const Scan scan;
    for (std::size_t k = 0; k < tour.controls.size(); ++k) {
        AssociationRecord record;
        feed(sieved, tour.controls[k], tour.observations[k]);
        asked.step({scan, tour.controls[k], tour.observations[k], nullptr, &record});
        ASSERT_EQ(sieved.associations().size(), asked.associations().size());
        for (std::size_t i = 0; i < sieved.associations().size(); ++i) {
            const Association& a = sieved.associations()[i];
            const Association& b = asked.associations()[i];
            ASSERT_EQ(a.outcome, b.outcome) << "step " << k << " feature " << i;
            ASSERT_EQ(a.reason, b.reason);
            ASSERT_EQ(a.landmark, b.landmark);
            ++outcomes[static_cast<std::size_t>(a.outcome)];
        }
        ASSERT_EQ(sieved.statistics().best_log_weight, asked.statistics().best_log_weight);
    }
    EXPECT_EQ(sieved.covariance(), asked.covariance());
    for (const int outcome : outcomes) EXPECT_GT(outcome, 10);
}

TEST(PairingSieve, ChangesNoDecision) {
    FilterParams params;
    params.algorithm = "ekf-slam";
    for (const AssociationMethod method :
         {AssociationMethod::gated_nearest, AssociationMethod::joint_compatibility}) {
        params.association.method = method;
        expect_the_same_decisions(params, make_sieve_tour(200, 0.02));
        expect_the_same_decisions(params, with_covariances(make_sieve_tour(100, 0.1)));
    }
    params.observation = {1e-4, 1e-5};
    expect_the_same_decisions(params, make_sieve_tour(200, 0.02));
}

TEST(PairingSieve, ChangesNoDecisionWhereVariancesAreNextToNothing) {
    FilterParams params;
    params.algorithm = "ekf-slam";
    params.observation = {1e-12, 1e-12};
    params.motion = {"odometry", 1.0, 1.0, 0.5};
    expect_the_same_decisions(params, make_sieve_tour(60, 0.02));
}

TEST(PairingSieve, LeavesFewOfMany) {
    JointState state;
    state.move({1.0, 2.0, 0.5}, Matrix3::Identity(), 1e-4 * Matrix3::Identity());
    struct Place {
        Eigen::Index at;
    };
    std::vector<Place> places;
    for (int i = 0; i < 20; ++i) {
        for (int j = 0; j < 20; ++j) {
            places.push_back(
                {state.append({1.0 * i, 1.0 * j}, Matrix23::Zero(), 1e-4 * Matrix2::Identity())});
        }
    }
    const Measurement measured{SensorEsquina::predict({1.0, 2.0, 0.5}, {7.0, 9.0}),
                               1e-4 * Matrix2::Identity()};
    PairingSieve<SensorEsquina> sieve;
    sieve.begin(state, places, std::span(&measured, 1), 20.0);
    std::vector<std::size_t> near;
    sieve.for_each_near(measured, [&](std::size_t i) { near.push_back(i); });
    EXPECT_EQ(std::ranges::count(near, 7U * 20U + 9U), 1);
    // Itself, and the one that the robot stands upon, of which no direction is known.
    EXPECT_LE(near.size(), 2U);
    const Measurement useless{measured.z, Matrix2::Zero()};
    sieve.begin(state, places, std::span(&useless, 1), 20.0);
    std::size_t all = 0;
    sieve.for_each_near(useless, [&](std::size_t i) { EXPECT_EQ(i, all++); });
    EXPECT_EQ(all, places.size());
}

}  // namespace
}  // namespace hitos
