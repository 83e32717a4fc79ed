// SPDX-License-Identifier: GPL-3.0-or-later
// Bounded lines, exclusion, several hypotheses, vanishing landmarks and probation.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

#include "association/free_space.hpp"
#include "fastslam/filtro_particulas.hpp"
#include "room_tour.hpp"

namespace hitos {
namespace {

using Outcome = Association::Outcome;

FilterParams still_params() {
    FilterParams params;
    params.particles = 5;
    params.motion.sigma_x_m = params.motion.sigma_y_m = params.motion.sigma_theta_rad = 0.0;
    params.observation = {0.01, 0.001};
    return params;
}

/// A wall x = rho in the robot's frame, between two heights.
void add_choice_wall(Observation& seen, double rho, double low, double high) {
    DetectedLine line;
    line.recta = normalized({rho, 0.0});
    line.first = static_cast<std::uint32_t>(seen.support.size());
    for (int i = 0; i <= 10; ++i) seen.support.push_back({rho, low + 0.1 * i * (high - low)});
    line.count = 11;
    seen.lines.push_back(line);
}

Observation choice_wall(double rho, double low, double high) {
    Observation seen;
    add_choice_wall(seen, rho, low, high);
    return seen;
}

std::vector<Outcome> outcomes(const SlamFilter& filter) {
    std::vector<Outcome> all;
    for (const Association& association : filter.associations()) all.push_back(association.outcome);
    return all;
}

TEST(Segments, WallsInOneLineStayTwoLandmarks) {
    for (const auto& [gap, bounded] : {std::pair{1.0, 2}, std::pair{0.4, 1}}) {
        Observation seen;
        add_choice_wall(seen, 4.0, -3.0, -0.5 * gap);
        add_choice_wall(seen, 4.0, 0.5 * gap, 3.0);
        for (const bool segments : {false, true}) {
            FilterParams params = still_params();
            params.association.segments = segments;
            FiltroParticulas filter(params, 1, 1);
            const int expected = segments ? bounded : 1;
            for (int k = 0; k < 3; ++k) feed(filter, {}, seen);
            EXPECT_EQ(filter.best_count(FeatureKind::line), expected) << gap << segments;
            EXPECT_EQ(filter.associations()[0].landmark, 0);
            EXPECT_EQ(filter.associations()[1].landmark, expected - 1);
        }
    }
}

TEST(Segments, AnExtentGrowsWithWhatIsSeen) {
    FilterParams params = still_params();
    params.association.segments = true;
    FiltroParticulas filter(params, 1, 1);
    feed(filter, {}, choice_wall(4.0, -1.0, 1.0));
    feed(filter, {}, choice_wall(4.0, 1.3, 3.0));  // within the margin
    feed(filter, {}, choice_wall(4.0, 3.4, 5.0));  // of what it is by then
    EXPECT_EQ(filter.best_count(FeatureKind::line), 1);
    feed(filter, {}, choice_wall(4.0, 5.6, 7.0));
    EXPECT_EQ(filter.best_count(FeatureKind::line), 2);
    EXPECT_EQ(filter.associations()[0].outcome, Outcome::created);
}

TEST(Segments, StretchesThatMeetBecomeOne) {
    FilterParams params = still_params();
    params.association.segments = true;
    FiltroParticulas filter(params, 1, 1);
    Observation ends;
    add_choice_wall(ends, 6.0, -3.0, 3.0);
    add_choice_wall(ends, 4.0, -3.0, -1.0);
    add_choice_wall(ends, 4.0, 1.0, 3.0);
    feed(filter, {}, ends);
    ASSERT_EQ(filter.best_count(FeatureKind::line), 3);
    feed(filter, {}, choice_wall(4.0, -1.2, 1.2));  // of either, so of both
    ASSERT_EQ(filter.best_count(FeatureKind::line), 2);
    EXPECT_EQ(filter.associations()[0].outcome, Outcome::matched);
    EXPECT_EQ(filter.associations()[0].landmark, 1);
    EXPECT_EQ(filter.best_map()[1].observations, 3);
    feed(filter, {}, ends);
    EXPECT_EQ(filter.best_count(FeatureKind::line), 2);
    EXPECT_EQ(outcomes(filter),
              (std::vector{Outcome::matched, Outcome::matched, Outcome::matched}));
    // What overlaps and is not in one line stays ambiguous.
    Observation parallel;
    add_choice_wall(parallel, 4.6, -3.0, 3.0);
    feed(filter, {}, parallel);
    feed(filter, {}, choice_wall(4.3, -1.0, 1.0));
    EXPECT_EQ(filter.best_count(FeatureKind::line), 3);
    EXPECT_EQ(filter.associations()[0].outcome, Outcome::ignored);
}

TEST(Segments, BothSidesOfAWallAreTwoLandmarks) {
    const Control passing{{5.0, 0.0, 0.0}, 1.0};
    const Control turning{{0.0, 0.0, kPi}, 1.0};
    for (const bool segments : {false, true}) {
        FilterParams params = still_params();
        params.association.segments = segments;
        FiltroParticulas filter(params, 1, 1);
        feed(filter, {}, choice_wall(4.0, -1.0, 1.0));
        const std::vector<Control> round{passing, turning};
        feed(filter, round, choice_wall(1.0, -1.0, 1.0));
        EXPECT_EQ(filter.best_count(FeatureKind::line), segments ? 2 : 1);
        feed(filter, {}, choice_wall(1.0, -1.0, 1.0));
        EXPECT_EQ(filter.best_count(FeatureKind::line), segments ? 2 : 1);
        EXPECT_EQ(filter.associations()[0].outcome, Outcome::matched);
    }
}

TEST(Segments, HoldForThePosteriorProposalToo) {
    FilterParams params = still_params();
    params.motion.sigma_x_m = 0.05;
    params.proposal = "posterior";
    params.association.segments = true;
    FiltroParticulas filter(params, 1, 1);
    feed(filter, {}, choice_wall(4.0, -3.0, -1.0));
    const Control ahead{{0.5, 0.0, 0.0}, 1.0};
    feed(filter, std::span(&ahead, 1),
         choice_wall(3.4, 1.0, 3.0));  // of another wall: tells nothing
    feed(filter, {}, Observation{});
    double mean = 0.0;
    for (const WeightedPose& hypothesis : filter.hypotheses()) {
        mean += 0.2 * hypothesis.pose.x;
    }
    EXPECT_EQ(filter.best_count(FeatureKind::line), 2);
    EXPECT_NEAR(mean, 0.5, 0.1);
}

TEST(Segments, ThePosteriorProposalReachesAsFarAsThePoseIsUnsure) {
    // A wall seen a metre behind the landmark's end, by a robot whose place is known to 5 cm, tells
    // nothing; one that the landmark reaches moves the robot by all that it is off.
    FilterParams params = still_params();
    params.particles = 200;
    params.motion.sigma_x_m = 0.05;
    params.observation = {1e-6, 1e-6};
    params.proposal = "posterior";
    params.association.segments = true;
    for (const auto& [low, x] : {std::pair{0.0, 0.5}, std::pair{-1.0, 0.6}}) {
        FiltroParticulas filter(params, 1, 1);
        feed(filter, {}, choice_wall(4.0, -3.0, -1.0));
        const Control ahead{{0.5, 0.0, 0.0}, 1.0};
        feed(filter, std::span(&ahead, 1), choice_wall(3.4, low, 3.0));
        double mean = 0.0;
        for (const WeightedPose& hypothesis : filter.hypotheses()) {
            mean += hypothesis.pose.x / params.particles;
        }
        EXPECT_NEAR(mean, x, 0.02) << low;
    }
}

TEST(Exclusion, OfTwoThatClaimALandmarkTheLikelierTakesIt) {
    FilterParams params = still_params();
    params.association.ambiguity = AmbiguityRule::off;
    Observation two;
    add_choice_wall(two, 4.1, -1.0, 1.0);
    add_choice_wall(two, 4.02, -0.5, 1.5);
    two.corners = {{4.1, 1.0}, {4.0, 1.05}};
    Observation first = choice_wall(4.0, -1.0, 1.0);
    first.corners = {{4.0, 1.0}};
    for (const bool exclusive : {false, true}) {
        params.association.exclusive = exclusive;
        FiltroParticulas filter(params, 1, 1);
        feed(filter, {}, first);
        feed(filter, {}, two);
        const auto loser = exclusive ? Outcome::ignored : Outcome::matched;
        EXPECT_EQ(outcomes(filter),
                  (std::vector{loser, Outcome::matched, loser, Outcome::matched}));
        EXPECT_EQ(filter.best_map()[0].observations, exclusive ? 2 : 3);
        EXPECT_EQ(filter.best_map()[1].observations, exclusive ? 2 : 3);
    }
}

TEST(Exclusion, PiecesOfOneWallShareIt) {
    FilterParams params = still_params();
    params.association.exclusive = true;
    Observation pieces;
    add_choice_wall(pieces, 4.01, -1.0, 0.0);
    add_choice_wall(pieces, 4.0, 0.3, 1.0);
    for (const bool segments : {false, true}) {
        params.association.segments = segments;
        FiltroParticulas filter(params, 1, 1);
        feed(filter, {}, choice_wall(4.0, -1.0, 1.0));
        feed(filter, {}, pieces);
        EXPECT_EQ(outcomes(filter),
                  (std::vector{segments ? Outcome::matched : Outcome::ignored, Outcome::matched}));
    }
}

TEST(Hypotheses, AreDrawnByTheirLikelihoodsAndWeighTheirSum) {
    AssociationParams params;
    params.p0 = 0.5;
    params.hypotheses = true;
    const Associator associator(params);
    MapStore maps;
    const MapStore::Handle handle = maps.create();
    auto lines = maps.landmarks<SensorRecta>(handle);
    const Matrix2 covariance = Vector2(0.01, 0.001).asDiagonal();
    for (const double rho : {3.0, 3.4, 9.0}) {
        lines.set(lines.append(), {{rho, 0.0}, covariance});
    }
    const Measurement measured{{3.19, 0.0}, covariance};
    const SeenFeature seen = associator.seen(measured);
    std::array<double, 3> likelihoods{};  // of both near walls, of a new one
    for (std::size_t i = 0; i < 2; ++i) {
        const double nu = 3.19 - (i == 0 ? 3.0 : 3.4);
        likelihoods.at(i) = std::exp(-0.5 * nu * nu / 0.02) / (2.0 * kPi * std::sqrt(0.02 * 0.002));
    }
    likelihoods[2] = params.p0;
    const double sum = likelihoods[0] + likelihoods[1] + likelihoods[2];
    std::array<double, 3> drawn{};
    constexpr std::uint32_t kDraws = 20000;
    for (std::uint32_t i = 0; i < kDraws; ++i) {
        RandomStream random(1, RandomPurpose::association, 7, i);
        const Decision decision =
            associator.decide<SensorRecta>(lines, {}, prepare(seen, {}), &random);
        EXPECT_NEAR(decision.log_likelihood, std::log(sum), 1e-9);
        drawn.at(decision.outcome == Outcome::created ? 2 : decision.landmark) += 1.0 / kDraws;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const double expected = likelihoods.at(i) / sum;
        EXPECT_NEAR(drawn.at(i), expected, 5.0 * std::sqrt(expected * (1.0 - expected) / kDraws));
    }
    // Without doubt nothing is drawn.
    const SeenFeature clear = associator.seen({{3.0, 0.0}, 0.01 * covariance});
    RandomStream random(1, RandomPurpose::association, 7, 1);
    RandomStream untouched = random;
    EXPECT_EQ(associator.decide<SensorRecta>(lines, {}, prepare(clear, {}), &random).landmark, 0U);
    EXPECT_EQ(random.next(), untouched.next());
}

TEST(Hypotheses, ParticlesPart) {
    FilterParams params = still_params();
    params.particles = 60;
    params.resampling = {ResamplingRule::neff, 0.0};
    Observation walls = choice_wall(3.0, -1.0, 1.0);
    add_choice_wall(walls, 3.4, -1.0, 1.0);
    std::set<double> rhos;
    for (const bool hypotheses : {false, true}) {
        params.association.hypotheses = hypotheses;
        FiltroParticulas filter(params, 1, 1);
        feed(filter, {}, walls);
        feed(filter, {}, choice_wall(3.2, -1.0, 1.0));
        EXPECT_EQ(filter.associations()[0].outcome == Outcome::ignored, !hypotheses);
        std::set<std::pair<double, double>> maps;
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            FiltroParticulas another(params, seed, 1);
            feed(another, {}, walls);
            feed(another, {}, choice_wall(3.2, -1.0, 1.0));
            maps.emplace(std::get<Recta>(another.best_map()[0].value).rho,
                         std::get<Recta>(another.best_map()[1].value).rho);
        }
        if (hypotheses) {
            EXPECT_GE(maps.size(), 2U);
        } else {
            EXPECT_EQ(maps.size(), 1U);
        }
    }
}

/// Readings of a round wall of that radius, from -60 to 60 degrees.
Scan round_scan(double radius) {
    Scan scan;
    for (int i = -60; i <= 60; ++i) {
        const double angle = i * kPi / 180.0;
        scan.points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return scan;
}

TEST(FreeSpace, TellsWhatRaysPassThrough) {
    FreeSpace space;
    space.set(round_scan(8.0));
    const Extent extent{-1.0, 1.0};
    EXPECT_EQ(space.sight({}, Recta{4.0, 0.0}, extent), Sight::missing);
    EXPECT_EQ(space.sight({}, Recta{4.0, 0.0}, {}), Sight::unknown);      // seen nobody knows where
    EXPECT_EQ(space.sight({}, Recta{7.9, 0.0}, extent), Sight::unknown);  // it is what is seen
    EXPECT_EQ(space.sight({}, Recta{9.0, 0.0}, extent), Sight::unknown);  // hidden
    EXPECT_EQ(space.sight({}, Recta{4.0, kPi}, extent), Sight::unknown);  // behind
    EXPECT_EQ(space.sight({}, Recta{4.0, 0.0}, {20.0, 25.0}), Sight::unknown);  // beside
    EXPECT_EQ(space.sight({}, Recta{4.0, 0.0}, {0.0, 0.6}), Sight::unknown);    // too few rays
    EXPECT_EQ(space.sight({}, Recta{0.4, kPi / 2.0}, {-7.0, -1.0}), Sight::unknown);  // along it
    EXPECT_EQ(space.sight({}, Esquina{4.0, 1.0}, {}), Sight::missing);
    EXPECT_EQ(space.sight({}, Esquina{8.0, 0.1}, {}), Sight::unknown);
    EXPECT_EQ(space.sight({}, Esquina{-4.0, 1.0}, {}), Sight::unknown);
    // From elsewhere, and in a world where the line's normal comes from its other side.
    const Pose laser{20.0, 5.0, kPi};
    EXPECT_EQ(space.sight(laser, Recta{16.0, 0.0}, {4.0, 6.0}), Sight::missing);
    EXPECT_EQ(space.sight(laser, Recta{16.0, 0.0}, {14.0, 16.0}), Sight::unknown);
    EXPECT_EQ(space.sight(laser, Esquina{16.0, 5.0}, {}), Sight::missing);
    space.set(round_scan(4.0));
    EXPECT_EQ(space.sight({}, Recta{4.0, 0.0}, extent), Sight::unknown);
    Scan mounted = round_scan(8.0);
    mounted.fan.pose_robot_laser = {0.2, 0.0, 0.0};
    space.set(mounted);
    EXPECT_EQ(space.laser({1.0, 0.0, kPi / 2.0}),
              (compose({1.0, 0.0, kPi / 2.0}, {0.2, 0.0, 0.0})));
}

TEST(Vanishing, ALandmarkThatIsLookedThroughGoes) {
    FilterParams params = still_params();
    params.landmarks.vanish = true;
    params.landmarks.hit = 0.8;
    params.landmarks.miss = -0.3;
    params.landmarks.limit = 1.0;
    FiltroParticulas filter(params, 1, 1);
    Observation seen = choice_wall(4.0, -1.0, 1.0);
    add_choice_wall(seen, 7.0, -4.0, 4.0);
    for (int k = 0; k < 5; ++k) feed(filter, {}, seen);
    ASSERT_EQ(filter.best_count(FeatureKind::line), 2);
    const Scan beyond = round_scan(8.0);
    const Observation behind = choice_wall(7.0, -4.0, 4.0);
    for (int k = 1; k <= 4; ++k) {  // 1 - 0.3 k
        filter.step({beyond, {}, behind});
        const int left = k < 4 ? 2 : 1;
        ASSERT_EQ(filter.best_count(FeatureKind::line), left) << k;
        // What is found stays, and its association points to where it then is.
        ASSERT_EQ(filter.associations().size(), 1U);
        EXPECT_EQ(filter.associations()[0].landmark, left - 1);
        EXPECT_NEAR(std::get<Recta>(filter.best_map().back().value).rho, 7.0, 1e-6);
    }
    // And where nothing at all was found.
    for (int k = 1; k <= 4; ++k) filter.step({round_scan(12.0), {}, Observation{}});
    EXPECT_EQ(filter.best_count(FeatureKind::line), 0);
}

TEST(Vanishing, WhatIsFoundOrHiddenStays) {
    FilterParams params = still_params();
    params.landmarks.vanish = true;
    FiltroParticulas filter(params, 1, 1);
    const Observation seen = choice_wall(4.0, -1.0, 1.0);
    for (int k = 0; k < 50; ++k) filter.step({round_scan(8.0), {}, seen});  // found all the same
    for (int k = 0; k < 50; ++k) filter.step({round_scan(2.0), {}, Observation{}});  // hidden
    EXPECT_EQ(filter.best_count(FeatureKind::line), 1);
}

TEST(Probation, OnlyWhatIsSeenAgainInTimeIsTold) {
    FilterParams params = still_params();
    params.landmarks.probation = 3;
    params.landmarks.probation_scans = 6;
    FiltroParticulas filter(params, 1, 1);
    Observation both = choice_wall(2.0, -1.0, 1.0);
    add_choice_wall(both, 5.0, -1.0, 1.0);
    feed(filter, {}, both);
    EXPECT_EQ(filter.best_map().size(), 0U);
    EXPECT_EQ(filter.associations()[0].landmark, -1);
    feed(filter, {}, both);
    const Observation one = choice_wall(5.0, -1.0, 1.0);
    feed(filter, {}, one);
    // The first one is on probation still; the other is told, as the first of the map.
    ASSERT_EQ(filter.best_map().size(), 1U);
    EXPECT_EQ(filter.best_count(FeatureKind::line), 1);
    EXPECT_EQ(filter.associations()[0].outcome, Outcome::matched);
    EXPECT_EQ(filter.associations()[0].landmark, 0);
    for (int k = 0; k < 4; ++k) feed(filter, {}, one);
    // Its time is over: what is seen in its place is new.
    feed(filter, {}, both);
    EXPECT_EQ(filter.associations()[0].outcome, Outcome::created);
    EXPECT_EQ(filter.associations()[1].landmark, 0);
    feed(filter, {}, both);
    feed(filter, {}, both);
    EXPECT_EQ(filter.best_map().size(), 2U);
}

TEST(FreeSpace, AWallOfWhichOnlyAPartIsLookedThroughIsNotMissing) {
    // The scan ends at the wall but for `open` of its 29 rays.
    const auto sight_with = [](int open) {
        Scan scan;
        for (int i = -14; i <= 14; ++i) {
            const double angle = i * kPi / 180.0;
            const double range = i + 14 < open ? 8.0 : 4.0 / std::cos(angle);
            scan.points.push_back({range * std::cos(angle), range * std::sin(angle)});
        }
        FreeSpace space;
        space.set(scan);
        return space.sight({}, Recta{4.0, 0.0}, {-1.3, 1.3});
    };
    EXPECT_EQ(sight_with(0), Sight::unknown);
    EXPECT_EQ(sight_with(15), Sight::unknown);
    EXPECT_EQ(sight_with(22), Sight::unknown);
    EXPECT_EQ(sight_with(29), Sight::missing);
}

}  // namespace
}  // namespace hitos
