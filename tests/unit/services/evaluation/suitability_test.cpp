// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/evaluation/suitability.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hitos {
namespace {

/// What a tour shows, scan by scan the same.
struct Shown {
    double step_m = 0.1;
    double scatter_m = 0.002;
    int created = 1;  ///< of ten observations
    int empty = 0;    ///< of ten scans
    bool points = true;
};

std::vector<Advice> advice_of(const Shown& shown, const Configuracion& configuration,
                              int scans = 40, bool simulated = false) {
    Suitability suitability;
    Observation seen;
    seen.lines = {{{2.0, 0.0}, 0, 4}};
    for (const double away : {-1.0, 1.0, 1.0, -1.0}) {
        seen.support.push_back(
            {2.0 + away * shown.scatter_m, static_cast<double>(seen.support.size())});
    }
    std::vector<Association> associations(10);
    for (std::size_t i = 0; i < associations.size(); ++i) {
        associations[i].outcome = static_cast<int>(i) < shown.created
                                      ? Association::Outcome::created
                                      : Association::Outcome::matched;
    }
    for (int i = 0; i < scans; ++i) {
        suitability.note(std::vector<Control>{{{shown.step_m, 0.0, 0.0}, 1.0}}, shown.points,
                         i % 10 < shown.empty ? Observation() : seen, associations);
    }
    return suitability.advice(configuration, simulated);
}

TEST(Suitability, NothingSpeaksAgainstWhatSuits) {
    EXPECT_TRUE(advice_of({}, {}).empty());
}

TEST(Suitability, FarStepsAreTooMuchForSmallNoiseOfAFixedSize) {
    Configuracion configuration;  // 8 mm
    const std::vector<Advice> told = advice_of({.step_m = 0.6}, configuration);
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(told[0].words(),
              "The robot drives 0.60 m between scans, which is far for noise of a fixed size at "
              "every scan: the path may be lost. Try --preset recorded.");
    EXPECT_TRUE(advice_of({.step_m = 0.24}, configuration).empty());
    configuration.filter.motion.sigma_y_m = 0.031;  // more than a twentieth of the step
    EXPECT_TRUE(advice_of({.step_m = 0.6}, configuration).empty());
    configuration.filter.motion.unit = MotionUnit::variance;
    configuration.filter.motion.sigma_x_m = 1e-6;
    configuration.filter.motion.sigma_y_m = 0.031 * 0.031;
    EXPECT_TRUE(advice_of({.step_m = 0.6}, configuration).empty());
    configuration.filter.motion.sigma_y_m = 0.029 * 0.029;
    EXPECT_EQ(advice_of({.step_m = 0.6}, configuration).size(), 1U);
    configuration.filter.motion.model = "proportional";
    EXPECT_TRUE(advice_of({.step_m = 0.6}, configuration).empty());
}

TEST(Suitability, WallsBreakWhosePointsScatterForDmax) {
    Configuracion configuration;
    configuration.extraction.split_merge.dmax_m = 0.02;
    const std::vector<Advice> told = advice_of({.scatter_m = 0.009}, configuration, 40, true);
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(told[0].figure, "9.0 mm");
    EXPECT_NE(told[0].text.find("too much for split_merge.dmax"), std::string_view::npos);
    EXPECT_EQ(told[0].preset, "simulated");
    configuration.extraction.circles.find = true;  // no other preset knows trees
    EXPECT_EQ(advice_of({.scatter_m = 0.009}, configuration, 40, true).at(0).preset, "");
    configuration.extraction.circles.find = false;
    EXPECT_TRUE(advice_of({.scatter_m = 0.007}, configuration).empty());
    configuration.extraction.method = "ransac";  // reads no dmax
    EXPECT_TRUE(advice_of({.scatter_m = 0.009}, configuration).empty());
}

TEST(Suitability, ManyObservationsThatMatchNothing) {
    const std::vector<Advice> told = advice_of({.created = 4}, {});
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(told[0].figure, "40 %");
    EXPECT_NE(told[0].text.find("match nothing in the map"), std::string_view::npos);
    EXPECT_TRUE(advice_of({.created = 2}, {}).empty());
}

TEST(Suitability, ManyScansOfPointsThatShowNoWallMayShowTrees) {
    Configuracion configuration;
    const std::vector<Advice> told = advice_of({.empty = 7}, configuration);
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(told[0].words(),
              "70 % of the scans show no wall and no corner: of trees and posts, which are round, "
              "landmarks are made where features.circles is on. Try --preset trees.");
    EXPECT_TRUE(advice_of({.empty = 6}, configuration).empty());
    // Of landmarks that a sensor told a scan has no points.
    EXPECT_TRUE(advice_of({.empty = 7, .points = false}, configuration).empty());
    configuration.extraction.circles.find = true;
    EXPECT_TRUE(advice_of({.empty = 7}, configuration).empty());
}

TEST(Suitability, TheFirstScansSayNothing) {
    const Shown all_wrong{.step_m = 0.6, .scatter_m = 0.009, .created = 9};
    EXPECT_TRUE(advice_of(all_wrong, {}, 19).empty());
    EXPECT_EQ(advice_of(all_wrong, {}, 20).size(), 2U) << "nothing is matched in the first 20";
    EXPECT_EQ(advice_of(all_wrong, {}, 21).size(), 3U);
}

}  // namespace
}  // namespace hitos
