// SPDX-License-Identifier: GPL-3.0-or-later
#include "association/scan_twins.hpp"

#include <gtest/gtest.h>

#include "ekf/ekf_slam.hpp"
#include "fastslam/filtro_particulas.hpp"
#include "room_tour.hpp"

namespace hitos {
namespace {

Measurements measured(const Observation& seen, const ObservationParams& params = {}) {
    Measurements out;
    measure(seen, params, out);
    return out;
}

Observation seen(const std::vector<Recta>& lines, const std::vector<Esquina>& corners = {}) {
    Observation observation;
    for (const Recta& line : lines) observation.lines.push_back({line, 0, 0});
    observation.corners = corners;
    return observation;
}

constexpr auto kAllNew = [](std::size_t) { return true; };

TEST(ScanTwins, AreWhatCouldNotBeToldApart) {
    ScanTwins twins(AssociationParams{}, true);
    // Lines 0 and 2 are one wall, 0.1 m and 1 degree apart; so are the corners, rows 3 and 4.
    twins.find(measured(seen({{2.0, 0.3}, {2.0, 1.5}, {2.1, 0.32}}, {{1.0, 2.0}, {1.1, 2.0}})));
    EXPECT_FALSE(twins.of(0, kAllNew));
    EXPECT_FALSE(twins.of(1, kAllNew));
    EXPECT_EQ(twins.of(2, kAllNew), 0U);
    EXPECT_FALSE(twins.of(3, kAllNew));
    EXPECT_EQ(twins.of(4, kAllNew), 3U);
    EXPECT_FALSE(twins.of(2, [](std::size_t i) { return i != 0; }));
    twins.find(measured(seen({{2.0, 0.3}})));
    EXPECT_FALSE(twins.of(0, kAllNew));
}

TEST(ScanTwins, LieWithinTheAmbiguityRatio) {
    // exp(-d^2 / 2) = 0.1 where d^2 = 4.605: 0.429 m of rho at a variance of 0.04 m^2.
    AssociationParams params;
    for (const bool has_p0 : {true, false}) {
        ScanTwins twins(params, has_p0);
        twins.find(measured(seen({{2.0, 0.3}, {2.428, 0.3}})));
        EXPECT_TRUE(twins.of(1, kAllNew));
        twins.find(measured(seen({{2.0, 0.3}, {2.431, 0.3}})));
        EXPECT_FALSE(twins.of(1, kAllNew));
    }
    // Whatever the ratio, the rule's own bound holds: p0, or the gate.
    params.ambiguity_ratio = 0.0;
    params.p0 = 1.0;
    ScanTwins likely(params, true);
    ScanTwins gated(params, false);
    const Measurements far = measured(seen({{2.0, 0.3}, {2.0 + 0.2 * 2.49, 0.3}}));  // d^2 6.2
    likely.find(far);
    EXPECT_TRUE(likely.of(1, kAllNew));  // 22.8 exp(-3.1) = 1.03
    gated.find(far);
    EXPECT_FALSE(gated.of(1, kAllNew));  // the gate of 95 % is at 5.99
}

TEST(ScanTwins, AWallThroughTheRobotIsOneFromBothSides) {
    ScanTwins twins(AssociationParams{}, true);
    twins.find(measured(seen({{0.01, 0.3}, {0.01, 0.3 - kPi}})));
    EXPECT_EQ(twins.of(1, kAllNew), 0U);
}

/// Two pieces of the wall at 2 m and a wall beside it, from a pose that is not the origin.
Observation pieces() {
    return seen({{2.0, 0.0}, {1.5, kPi / 2}, {2.04, 0.01}});
}

void expect_one_landmark_for_both(SlamFilter& filter) {
    const std::vector<Control> controls{{{1.0, 0.0, 0.5}, 1.0}};
    feed(filter, controls, pieces());
    const LandmarkMap map = filter.best_map();
    ASSERT_EQ(map.size(), 2U);
    EXPECT_EQ(map[0].observations, 2);
    EXPECT_EQ(map[1].observations, 1);
    // Of two equally sure pieces the landmark is the mean.
    const Recta local = transform(inverse(filter.best_pose()), std::get<Recta>(map[0].value));
    EXPECT_NEAR(local.rho, 2.02, 1e-4);  // but for the lever of the turn
    EXPECT_NEAR(local.theta, 0.005, 1e-6);
    const auto said = filter.associations();
    ASSERT_EQ(said.size(), 3U);
    EXPECT_EQ(said[0].outcome, Association::Outcome::created);
    EXPECT_EQ(said[1].outcome, Association::Outcome::created);
    EXPECT_EQ(said[2].outcome, Association::Outcome::matched);
    EXPECT_EQ(said[2].landmark, said[0].landmark);
    EXPECT_EQ(said[2].reason, Association::Reason::twin);
}

TEST(ScanTwins, MakeOneLandmarkInFastSlam) {
    FilterParams params;
    params.particles = 5;
    FiltroParticulas filter(params, 1, 1);
    expect_one_landmark_for_both(filter);
}

TEST(ScanTwins, MakeOneLandmarkInEkfSlam) {
    FilterParams params;
    params.algorithm = "ekf-slam";
    EkfSlam filter(params);
    expect_one_landmark_for_both(filter);
    // As if the wall had been seen twice: half the variance.
    EXPECT_NEAR(filter.best_map()[0].covariance(1, 1), 0.00122 / 2.0, 1e-9);
}

TEST(ScanTwins, OneThatIsKnownAlreadyMakesNoOther) {
    FilterParams params;
    params.algorithm = "ekf-slam";
    EkfSlam filter(params);
    feed(filter, {}, seen({{2.0, 0.0}}));
    feed(filter, {}, pieces());
    EXPECT_EQ(filter.best_count(FeatureKind::line), 2);
}

}  // namespace
}  // namespace hitos
