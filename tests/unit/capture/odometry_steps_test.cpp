// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of a logged path that no robot drives, and those that only look so.
#include "hitos/capture/odometry_steps.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "test_files.hpp"

namespace hitos {
namespace {

using test::expect_near;
using test::Log;
using test::read_text;
using ::testing::HasSubstr;

std::string reading(double time, const Pose& pose) {
    return "position 0 " + std::to_string(time) + " " + std::to_string(pose.x) + " " +
           std::to_string(pose.y) + " " + std::to_string(pose.theta) + " 0 0 0\n";
}

Pose end_of(const std::string& text) {
    return test::summed(read_text("radish", text).odometry).back();
}

/// That the clock goes back is not of the steps.
std::ptrdiff_t of_steps(const Log& log) {
    return std::ranges::count_if(log.findings, [](const TourFinding& finding) {
        return finding.kind != TourFinding::Kind::clock_back;
    });
}

/// Of a robot that drives at 0.5 m/s, 20 readings a second; from `begin` on the odometry hangs at
/// what it was, for that long.
std::string hung(double begin, double seconds) {
    std::string text;
    for (int i = 0; i < 400; ++i) {
        const double time = 0.05 * i;
        const bool hangs = time > begin && time < begin + seconds;
        text += reading(time, {0.5 * (hangs ? begin : time), 0, 0});
    }
    return text;
}

TEST(OdometrySteps, WhatMakesUpForAHaltOfTheOdometryIsNoLeap) {
    const Log log = read_text("radish", hung(10.0, 3.0));
    EXPECT_NEAR(test::summed(log.odometry).back().x, 0.5 * 19.95, 1e-6);
    ASSERT_EQ(log.findings.size(), 1U);
    EXPECT_EQ(log.findings.front().kind, TourFinding::Kind::leaping_odometry);
    EXPECT_NEAR(log.findings.front().value, 1.5, 1e-6);
    EXPECT_THAT(log.findings.front().what.english(), HasSubstr("for up to 3 s"));
    EXPECT_THAT(log.findings.front().what.english(), HasSubstr("1.5 m (line 261), 1 in all"));
    EXPECT_THAT(advice_of(log.findings.front()).english(), HasSubstr("source.odometry=scans"));
    EXPECT_TRUE(read_text("radish", hung(10.0, 0.2)).findings.empty());
}

/// Of a robot that winds its way, 20 readings a second, whose heading is `factor` times as far.
std::string winding(double factor, bool with_velocities) {
    std::string text;
    Pose pose;
    for (int i = 0; i < 600; ++i) {
        const double w = 0.4 * std::sin(0.1 * i);
        pose = compose(pose, displacement({0.4, 0.0, w}, 0.05));
        text += fmt::format("position 0 {:.3f} {:.6f} {:.6f} {:.6f} {} 0 {:.6f}\n", 0.05 * i,
                            pose.x, pose.y, wrap_angle(factor * pose.theta),
                            with_velocities ? 0.4 : 0.0, with_velocities ? w : 0.0);
    }
    return text;
}

TEST(OdometrySteps, DegreesThatWereWrappedAsRadiansAreTold) {
    for (const bool with_velocities : {true, false}) {
        EXPECT_TRUE(read_text("radish", winding(1.0, with_velocities)).findings.empty());
        // To the left, and to the right as a compass counts.
        for (const double factor : {kDegreesPerRadian, -kDegreesPerRadian}) {
            const Log log = read_text("radish", winding(factor, with_velocities));
            ASSERT_EQ(log.findings.size(), 1U);
            EXPECT_EQ(log.findings[0].kind, TourFinding::Kind::odometry_units);
            EXPECT_THAT(advice_of(log.findings[0]).english(),
                        HasSubstr(with_velocities ? "source.odometry=velocities"
                                                  : "source.odometry=scans"));
        }
    }
}

TEST(OdometrySteps, ATurnIsMadeUpForToo) {
    std::string text;
    for (int i = 0; i < 200; ++i) {
        const double time = 0.05 * i;
        text += reading(time, {1, 2, 0.5 * (time > 4.0 && time < 6.0 ? 4.0 : time)});
    }
    EXPECT_NEAR(end_of(text).theta, wrap_angle(0.5 * 9.95), 1e-5);
    const Log log = read_text("radish", text);
    ASSERT_EQ(log.findings.size(), 1U);
    EXPECT_THAT(log.findings[0].what.english(), HasSubstr("while the robot turns, for up to 2 s"));
    EXPECT_THAT(log.findings[0].what.english(), HasSubstr("of up to 57 degrees (line 121)"));
}

/// A reading a second, and one with each scan; between two of them the robot stands, and turns.
TEST(OdometrySteps, WhoTellsFewReadingsDoesNotStand) {
    for (const double turn : {0.0, 0.9}) {
        Pose pose{1, 2, 0};
        std::string text = reading(-1, pose);
        for (int i = 0; i < 60; ++i) {
            if (i % 6 != 5) pose = compose(pose, {i % 6 == 0 ? 0.7 : 0.1, 0.0, 0.0});
            if (i % 6 == 0) pose = compose(pose, {0.0, 0.0, turn});
            text += reading(i, pose);
            if (i % 2 == 0) text += reading(i + 1e-4, pose);
        }
        EXPECT_TRUE(read_text("radish", text).findings.empty()) << turn;
        expect_near(end_of(text), between({1, 2, 0}, pose), 1e-5, "end");
    }
}

/// A reading for every half radian, as of a log that has scans alone; some are stamped late.
TEST(OdometrySteps, TurnsBetweenStampsThatWaverAreNoLeaps) {
    Pose pose{1, 2, 0};
    std::string text = reading(-2.5, pose);
    for (int i = 0; i < 60; ++i) {
        pose = compose(pose, {0.1, 0.0, i < 30 ? 0.55 : -0.55});
        text += reading(2.5 * i + (i % 10 == 4 ? 2.49 : 0.0), pose);
    }
    EXPECT_TRUE(read_text("radish", text).findings.empty());
    expect_near(end_of(text), between({1, 2, 0}, pose), 1e-4, "end");
}

TEST(OdometrySteps, HeadingsThatStepByATurnOfDegreesAreDegrees) {
    std::string text;
    for (int i = 0; i < 400; ++i) {
        text += reading(0.05 * i, {0.02 * i, 0, std::remainder(5.0 * i, 360.0)});
    }
    const Log log = read_text("radish", text);
    ASSERT_EQ(log.findings.size(), 1U);
    EXPECT_EQ(log.findings.front().kind, TourFinding::Kind::odometry_units);
    EXPECT_NEAR(log.findings.front().value, kRadiansPerDegree, 1e-9);
}

TEST(OdometrySteps, OneHeadingThatIsWrongMakesNoDegrees) {
    std::string text;
    for (int i = 0; i < 400; ++i) {
        text += reading(0.05 * i, {0.02 * i, 0, i < 200 ? 0.0 : 350.0});
    }
    for (const TourFinding& finding : read_text("radish", text).findings) {
        EXPECT_NE(finding.kind, TourFinding::Kind::odometry_units);
    }
}

TEST(OdometrySteps, ALeapAfterAHaltStaysALeap) {
    // Further than it may have driven meanwhile.
    std::string text = hung(10.0, 100.0);
    text += reading(20.0, {25, 0, 0});
    EXPECT_NEAR(end_of(text).x, 5.0, 1e-6);
    // A robot that braked before it stood still.
    text.clear();
    double x = 5.0;
    for (int i = 0; i < 200; ++i) {
        const double speed = std::max(0.0, 0.5 - 0.05 * std::max(0, i - 100));
        x += 0.05 * speed;
        text += reading(0.05 * i, {x, 0, 0});
    }
    text += reading(10.0, {x + 4.0, 0, 0});
    EXPECT_NEAR(end_of(text).x, x - 5.025, 1e-6);
    EXPECT_THAT(read_text("radish", text).findings.at(0).what.english(), HasSubstr("leaps"));
    // Where it begins anew, however near.
    text = hung(3.0, 100.0);
    text += reading(20.0, {});
    EXPECT_NEAR(end_of(text).x, 1.5, 1e-6);
}

TEST(OdometrySteps, ALeapWhoseTimeDoesNotAdvanceIsBridged) {
    for (const double stamp : {1.9, 0.0, -100.0}) {
        std::string text;
        for (int i = 0; i < 20; ++i) text += reading(0.1 * i, {20 + 0.1 * i, 0, 0});
        for (int i = 0; i < 20; ++i) text += reading(stamp + 0.1 * i, {0.1 * i, 0, 0});
        expect_near(end_of(text), {3.8, 0, 0}, 1e-6, std::to_string(stamp));
        EXPECT_EQ(of_steps(read_text("radish", text)), 1) << stamp;
    }
}

TEST(OdometrySteps, ReadingsOutOfOrderAreNoLeaps) {
    std::string text;
    for (int i = 0; i < 40; ++i) {
        const int late = i % 4 == 2 ? i - 2 : i;  // half a second and more late
        text += reading(0.5 * late, {1.0 * late, 0, 0});
    }
    EXPECT_NEAR(end_of(text).x, 39.0, 1e-6);
    EXPECT_TRUE(read_text("radish", text).findings.empty());
}

TEST(OdometrySteps, StepsInNoTimeSayNothingOfTheSpeed) {
    // One reading has the stamp of the one before; then a driver begins anew.
    std::string text;
    for (int i = 0; i < 20; ++i) text += reading(0.1 * (i == 19 ? 18 : i), {20 + 0.1 * i, 0, 0});
    for (int i = 0; i < 20; ++i) text += reading(2.0 + 0.1 * i, {0.1 * i, 0, 0});
    EXPECT_NEAR(end_of(text).x, 1.9 + 0.2 + 1.9, 1e-6);
    // A clock that is set back says how fast it goes by its own stamps.
    text.clear();
    for (int i = 0; i < 20; ++i) text += reading(100 + i, {20 + 0.5 * i, 0, 0});
    for (int i = 20; i < 40; ++i)
        text += reading(i + (i >= 30 ? 4 : 0), {20 + 0.5 * i + (i >= 30 ? 1.5 : 0), 0, 0});
    EXPECT_NEAR(end_of(text).x, 0.5 * 39 + 1.5, 1e-6);
    EXPECT_EQ(of_steps(read_text("radish", text)), 0);
}

/// Of one robot a reading each 0.05 s, and of another, that far aside, one after each `every`.
std::string two_programs(double aside, int every) {
    std::string text;
    for (int i = 0; i < 1000; ++i) {
        text += reading(0.05 * i, {0.02 * i, 0, 0});
        if (i % every == every - 1) text += reading(0.05 * i + 0.02, {0.01 * i, aside, 0});
    }
    return text;
}

TEST(OdometrySteps, TwoProgramsThatTellItAreNoticedHoweverOftenEachDoes) {
    for (const int every : {1, 2, 5, 50}) {
        for (const double aside : {0.3, 4.0}) {
            const Log log = read_text("radish", two_programs(aside, every));
            ASSERT_EQ(log.findings.size(), 1U) << every << ' ' << aside;
            EXPECT_EQ(log.findings.front().kind, TourFinding::Kind::two_publishers);
            EXPECT_GE(log.findings.front().value, 10.0);
        }
    }
    // Single poses that are wrong are on no track, and who drives to and fro is one.
    std::string wrong;
    std::string shuttle;
    for (int i = 0; i < 1000; ++i) {
        wrong += reading(0.05 * i, {0.02 * i, i % 50 == 49 ? 0.1 * (i * 37 % 101) - 5.0 : 0.0, 0});
        shuttle += reading(i, {std::abs(i % 20 - 10.0), 0, 0});
    }
    for (const std::string& text : {wrong, shuttle}) {
        for (const TourFinding& finding : read_text("radish", text).findings) {
            EXPECT_NE(finding.kind, TourFinding::Kind::two_publishers);
        }
    }
}

TEST(OdometrySteps, ALeapOfTheHeadingAloneIsToldInDegrees) {
    std::string text;
    for (int i = 0; i < 200; ++i) text += reading(0.05 * i, {0.02 * i, 0, i < 100 ? 0.0 : 1.5708});
    const Log log = read_text("radish", text);
    ASSERT_EQ(log.findings.size(), 1U);
    EXPECT_EQ(log.findings.front().kind, TourFinding::Kind::leaping_odometry);
    EXPECT_THAT(log.findings.front().what.english(), HasSubstr("by up to 90 degrees (line 101)"));
}

}  // namespace
}  // namespace hitos
