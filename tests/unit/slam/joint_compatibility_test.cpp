// SPDX-License-Identifier: GPL-3.0-or-later
#include "association/joint_compatibility.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <functional>
#include <random>

#include "association/measurement.hpp"
#include "ekf/joint_innovation.hpp"

namespace hitos {
namespace {

struct Problem {
    std::vector<std::vector<JointCandidate>> candidates;  // of each observation
};

struct Best {
    std::size_t pairs = 0;
    double distance = 0.0;
};

/// The squared distance of a set of pairings.
using Together = std::function<double(const std::vector<JointCandidate>&)>;

/// Tries every set of pairings.
void try_all(const Problem& problem, const Together& together, double probability,
             std::size_t observation, std::vector<JointCandidate>& chosen, Best& best) {
    if (observation == problem.candidates.size()) {
        if (chosen.empty()) return;
        const double distance = together(chosen);
        if (distance > joint_gate(probability, chosen.size())) return;
        if (chosen.size() > best.pairs ||
            (chosen.size() == best.pairs && distance < best.distance)) {
            best = {chosen.size(), distance};
        }
        return;
    }
    try_all(problem, together, probability, observation + 1, chosen, best);
    for (const JointCandidate& candidate : problem.candidates[observation]) {
        if (std::ranges::find(chosen, candidate.landmark, &JointCandidate::landmark) !=
            chosen.end()) {
            continue;
        }
        chosen.push_back(candidate);
        try_all(problem, together, probability, observation + 1, chosen, best);
        chosen.pop_back();
    }
}

double summed(const std::vector<JointCandidate>& chosen) {
    double sum = 0.0;
    for (const JointCandidate& candidate : chosen) sum += candidate.distance;
    return sum;
}

void fill(JointSearch& search, const Problem& problem, double probability) {
    search.begin(probability);
    for (const auto& candidates : problem.candidates) {
        search.add_observation();
        for (const JointCandidate& candidate : candidates) search.add(candidate);
    }
}

/// What the search says is a pairing, as great as it says, and the best there is.
void expect_best(JointSearch& search, const Problem& problem, JointDistance& distance,
                 const Together& together, double probability) {
    fill(search, problem, probability);
    ASSERT_TRUE(search.run(distance));
    std::vector<JointCandidate> chosen;
    for (std::size_t i = 0; i < search.observations(); ++i) {
        const JointCandidate* pairing = search.paired(i);
        if (pairing == nullptr) continue;
        for (const JointCandidate& before : chosen) EXPECT_NE(before.landmark, pairing->landmark);
        chosen.push_back(*pairing);
    }
    EXPECT_EQ(chosen.size(), search.pairs());
    if (!chosen.empty()) {
        EXPECT_NEAR(together(chosen), search.distance(), 1e-9);
    }
    Best best;
    std::vector<JointCandidate> none;
    try_all(problem, together, probability, 0, none, best);
    EXPECT_EQ(search.pairs(), best.pairs);
    EXPECT_NEAR(search.distance(), best.distance, 1e-9);
}

struct JointDraws {
    std::mt19937 engine;
    double unit() { return std::uniform_real_distribution<double>(0.0, 1.0)(engine); }
    double normal() { return std::normal_distribution<double>(0.0, 1.0)(engine); }
    int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(engine); }
};

TEST(JointGate, IsTheChiSquareQuantile) {
    EXPECT_NEAR(joint_gate(0.95, 1), chi_square_gate(0.95), 1e-12);
    EXPECT_NEAR(joint_gate(0.95, 1), 5.991464547, 1e-9);  // printed tables
    EXPECT_NEAR(joint_gate(0.95, 2), 9.487729037, 1e-9);
    EXPECT_NEAR(joint_gate(0.99, 5), 23.209251159, 1e-9);
    EXPECT_NEAR(joint_gate(0.5, 10), 19.337429229, 1e-9);
    EXPECT_NEAR(joint_gate(0.95, 50), 124.342113400, 1e-8);
}

TEST(JointSearch, EqualsExhaustiveSearchOfIndependentPairings) {
    JointDraws draws{std::mt19937(71)};
    JointSearch search;
    IndependentDistance distance;
    int unpaired = 0;
    for (int round = 0; round < 500; ++round) {
        Problem problem;
        const int landmarks = 1 + draws.below(5);
        problem.candidates.resize(
            static_cast<std::size_t>(draws.below(7)));  // often more than those
        for (auto& candidates : problem.candidates) {
            for (int landmark = 0; landmark < landmarks; ++landmark) {
                if (draws.unit() < 0.5) continue;
                // Whole numbers now and then: ties.
                const double apart = 6.0 * draws.unit();
                candidates.push_back({static_cast<std::uint64_t>(landmark),
                                      round % 3 == 0 ? std::round(apart) : apart});
            }
        }
        const double probability = round % 2 == 0 ? 0.95 : 0.6;
        expect_best(search, problem, distance, summed, probability);
        unpaired += search.pairs() < problem.candidates.size() ? 1 : 0;
    }
    EXPECT_GT(unpaired, 100);
}

/// A joint state with landmarks that know of each other, and every observation compared with all.
struct Scene {
    JointState state;
    std::vector<JointState::Row> rows;
    Problem problem;
};

Scene make_scene(JointDraws& draws) {
    Scene scene;
    Matrix3 spread;
    spread << draws.normal(), draws.normal(), draws.normal(), draws.normal(), draws.normal(),
        draws.normal(), draws.normal(), draws.normal(), draws.normal();
    scene.state.move({}, Matrix3::Identity(), 0.1 * spread * spread.transpose());
    const int landmarks = 1 + draws.below(4);
    std::vector<Eigen::Index> at;
    for (int i = 0; i < landmarks; ++i) {
        const Vector2 mean(draws.normal(), draws.normal());
        Matrix23 by_pose;
        by_pose << 1.0, 0.0, draws.normal(), 0.0, 1.0, draws.normal();
        at.push_back(scene.state.append(mean, by_pose, 0.05 * Matrix2::Identity()));
    }
    scene.problem.candidates.resize(1 + static_cast<std::size_t>(draws.below(5)));
    for (auto& candidates : scene.problem.candidates) {
        const Vector2 z(draws.normal(), draws.normal());
        for (const Eigen::Index place : at) {
            JointState::Row row;
            row.at = place;
            row.nu = 0.7 * (z - scene.state.landmark(place));
            row.by_pose << -1.0, 0.0, draws.normal(), 0.0, -1.0, draws.normal();
            row.by_landmark << 1.0, 0.2 * draws.normal(), 0.0, 1.0;
            row.r = 0.05 * Matrix2::Identity();
            JointInnovationDistance alone(scene.state, std::span(&row, 1));
            const double distance = alone.push({0, 0.0, 0});
            if (distance > 9.0) continue;
            candidates.push_back({static_cast<std::uint64_t>(place), distance,
                                  static_cast<std::uint32_t>(scene.rows.size())});
            scene.rows.push_back(row);
        }
    }
    return scene;
}

/// nu' S^-1 nu with the whole S = H P H' + R at once.
double dense_distance(const Scene& scene, const std::vector<JointCandidate>& chosen) {
    const Eigen::MatrixXd p = scene.state.covariance();
    const auto count = 2 * static_cast<Eigen::Index>(chosen.size());
    Eigen::MatrixXd h = Eigen::MatrixXd::Zero(count, p.rows());
    Eigen::MatrixXd r = Eigen::MatrixXd::Zero(count, count);
    Eigen::VectorXd nu(count);
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const auto k = 2 * static_cast<Eigen::Index>(i);
        const JointState::Row& row = scene.rows[chosen[i].place];
        h.block<2, 3>(k, 0) = row.by_pose;
        h.block<2, 2>(k, row.at) = row.by_landmark;
        r.block<2, 2>(k, k) = row.r;
        nu.segment<2>(k) = row.nu;
    }
    return nu.dot((h * p * h.transpose() + r).inverse() * nu);
}

TEST(JointSearch, EqualsExhaustiveSearchOfCorrelatedPairings) {
    JointDraws draws{std::mt19937(73)};
    JointSearch search;
    int several = 0;
    for (int round = 0; round < 400; ++round) {
        const Scene scene = make_scene(draws);
        JointInnovationDistance distance(scene.state, scene.rows);
        expect_best(
            search, scene.problem, distance,
            [&](const std::vector<JointCandidate>& chosen) {
                return dense_distance(scene, chosen);
            },
            0.9);
        several += search.pairs() > 1 ? 1 : 0;
    }
    EXPECT_GT(several, 100);
}

TEST(JointSearch, WithoutCandidatesPairsNothing) {
    JointSearch search;
    IndependentDistance distance;
    search.begin(0.95);
    EXPECT_TRUE(search.run(distance));
    EXPECT_EQ(search.observations(), 0U);
    fill(search, {{{}, {}, {}}}, 0.95);
    EXPECT_TRUE(search.run(distance));
    EXPECT_EQ(search.pairs(), 0U);
    EXPECT_EQ(search.paired(1), nullptr);
}

TEST(JointSearch, OfEqualSetsTheNearestAndThenTheFirstLandmarkWins) {
    JointSearch search;
    IndependentDistance distance;
    fill(search, {{{{7, 1.0}, {3, 1.0}}}}, 0.95);
    EXPECT_TRUE(search.run(distance));
    EXPECT_EQ(search.paired(0)->landmark, 3U);
    // Both orders of two observations and two landmarks cost the same.
    fill(search, {{{{1, 1.0}, {2, 1.0}}, {{1, 1.0}, {2, 1.0}}}}, 0.95);
    EXPECT_TRUE(search.run(distance));
    EXPECT_EQ(search.paired(0)->landmark, 1U);
    EXPECT_EQ(search.paired(1)->landmark, 2U);
}

TEST(JointSearch, MorePairingsBeatANearerOne) {
    // Observation 0 fits both landmarks and is nearer to 1, the only one that observation 1 fits.
    JointSearch search;
    IndependentDistance distance;
    fill(search, {{{{1, 0.1}, {2, 3.0}}, {{1, 0.5}}}}, 0.95);
    EXPECT_TRUE(search.run(distance));
    EXPECT_EQ(search.paired(0)->landmark, 2U);
    EXPECT_EQ(search.paired(1)->landmark, 1U);
}

TEST(JointSearch, ACutSearchIsCountedAndStillAPairing) {
    // Ten observations of ten landmarks that all fit each other.
    JointDraws draws{std::mt19937(79)};
    Problem problem;
    problem.candidates.resize(10);
    for (auto& candidates : problem.candidates) {
        for (std::uint64_t landmark = 0; landmark < 10; ++landmark) {
            candidates.push_back({landmark, 1.0 + draws.unit()});
        }
    }
    JointSearch search;
    IndependentDistance distance;
    const auto result = [&](std::uint64_t nodes) {
        fill(search, problem, 0.95);
        const bool whole = search.run(distance, nodes);
        EXPECT_LE(search.nodes(), nodes + 1);
        return std::pair(whole, search.distance());
    };
    const auto [nothing, in_turn] = result(0);
    const auto [some, better] = result(1000);
    EXPECT_FALSE(nothing);
    EXPECT_FALSE(some);
    EXPECT_EQ(search.pairs(), 10U);
    EXPECT_LE(better, in_turn);
    EXPECT_EQ(result(1000).second, better);
}

}  // namespace
}  // namespace hitos
