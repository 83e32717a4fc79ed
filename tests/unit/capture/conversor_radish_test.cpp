// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test_files.hpp"

namespace hitos {
namespace {

using test::expect_near;
using test::Log;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Log radish(const std::string& text, const ReadOptions& options = {}) {
    return test::read_text("radish", text, options);
}

TEST(ConversorRadish, ReadsBothLines) {
    const Log log = radish(
        "position 0 1.0 1.0 2.0 0.0 0 0 0\r\n"
        "laser 0 1.5 2.0 -0.5 0 50.00 0.0 0 3.0 0.5 7\r\n"
        "sonar 0 1.5 4 4 4\n"
        "position 0 2.0 2.0 2.0 0.0 0 0 0\n");
    ASSERT_EQ(log.scans.size(), 1U);
    EXPECT_EQ(log.report.skipped, 0U);
    EXPECT_EQ(log.scans[0].fan, (Fan{-0.5, 0.5, 3, 0.0, {}}));
    EXPECT_THAT(log.scans[0].rays, ElementsAre(0, 2));
    EXPECT_THAT(log.scans[0].run_starts, ElementsAre(0, 1));
    expect_near(log.scans[0].points[1], Point2{3 * std::cos(.5), 3 * std::sin(.5)}, 1e-12);
    ASSERT_EQ(log.odometry.size(), 2U);
    EXPECT_EQ(log.odometry[1].twist, (Twist{1, 0, 0}));
}

TEST(ConversorRadish, BearingsRegularToATenthOfAMilliradianMakeAFan) {
    const auto fan = [](const std::string& middle) {
        return radish("laser 0 1 1 -0.5 0 1 " + middle + " 0 1 0.5 0\n").scans.at(0).fan;
    };
    EXPECT_EQ(fan("0.00009").count, 3U);
    EXPECT_EQ(fan("0.00011").count, 0U);
    EXPECT_EQ(radish("laser 0 1 1 0.5 0 1 0 0 1 -0.5 0\n").scans.at(0).fan,
              (Fan{0.5, -0.5, 3, 0.0, {}}));
}

TEST(ConversorRadish, PointsLieWhereTheBearingsSay) {
    const Log log = radish("laser 0 1 1 -0.5 0 1 0.2 0 1 0.5 0\n");
    expect_near(log.scans.at(0).points.at(1), Point2{std::cos(.2), std::sin(.2)}, 1e-15);
    EXPECT_THAT(log.scans[0].rays, ElementsAre(0, 1, 2));
}

/// Scans of 20 rays that move from scan to scan; some rays get the code.
std::string scans_with(const std::string& code, int every, int scans) {
    std::string text;
    for (int s = 0; s < scans; ++s) {
        text += "laser 0 " + std::to_string(s);
        for (int i = 0; i < 20; ++i) {
            const bool none = every > 0 && (i + s) % every == 0;
            text += " " + (none ? code : std::to_string(1.0 + 0.01 * i + 0.013 * s)) + " " +
                    std::to_string(-1.0 + 0.1 * i) + " 0";
        }
        text += "\n";
    }
    return text;
}

TEST(ConversorRadish, ARepeatedMaximumIsNoReturn) {
    const Log log = radish(scans_with("8.00", 5, 30));
    EXPECT_EQ(log.scans.at(0).points.size(), 16U);
    EXPECT_EQ(log.scans[0].fan.max_range_m, 0.0);  // the log does not say it
    // A code seen before may come a little smaller.
    const Log smaller = radish(scans_with("8.00", 5, 30) + "laser 0 99 7.95 0 0 7.85 0.1 0\n");
    EXPECT_EQ(smaller.scans.back().points.size(), 1U);
}

TEST(ConversorRadish, ACodeIsOneAmongWallsThatLieJustBelow) {
    std::string text;
    for (int s = 0; s < 30; ++s) {
        text += "laser 0 " + std::to_string(s);
        for (int i = 0; i < 20; ++i) {
            const bool none = (i + s) % 5 == 0;
            text += " " + (none ? "8.00" : std::to_string(7.52 + 0.0091 * ((7 * i + 3 * s) % 29))) +
                    " " + std::to_string(-1.0 + 0.1 * i) + " 0";
        }
        text += "\n";
    }
    EXPECT_EQ(radish(text).scans.at(0).points.size(), 16U);
}

TEST(ConversorRadish, AFarCornerIsAPoint) {
    // The same distance on one ray, scan after scan, of a robot at rest.
    std::string text;
    for (int s = 0; s < 40; ++s)
        text += "laser 0 " + std::to_string(s) + " 2 0 0 12.40 0.1 0 2.1 0.2 0\n";
    EXPECT_EQ(radish(text).scans.at(0).points.size(), 3U);
}

TEST(ConversorRadish, AFarWallIsPoints) {
    // A wall at 12.4 m fills many rays, scan after scan; readings just below show that it is one.
    std::string text;
    for (int s = 0; s < 20; ++s) {
        text += "laser 0 " + std::to_string(s);
        for (int i = 0; i < 12; ++i) {
            text += (i % 2 == 0 ? " 12.40 " : " 12.31 ") + std::to_string(0.1 * i) + " 0";
        }
        text += "\n";
    }
    EXPECT_EQ(radish(text).scans.at(0).points.size(), 12U);
}

TEST(ConversorRadish, WithoutACodeTheLimitIsAssumed) {
    const Log log = radish("laser 0 1 49.89 0 0 49.90 0.1 0 81.83 0.2 0 81.91 0.3 0\n");
    EXPECT_THAT(log.scans.at(0).rays, ElementsAre(0));
    EXPECT_EQ(radish("laser 0 1 49.89 0 0 60 0.1 0\n", {100.0}).scans.at(0).points.size(), 2U);
}

TEST(ConversorRadish, DamagedLines) {
    const Log log = radish(
        "laser 0 1 1.0 0.0 0\n"
        "laser 0 2\n"
        "laser 0 2 1.0 0.1\n"
        "laser 0 2 1.0 nan 0\n"
        "laser x 2 1.0 0.1 0\n"
        "position 0 1 1 2 3 4 5\n"
        "position 0 1 1 2 3 4 5 6 7\n"
        "12 13\n");
    EXPECT_EQ(log.scans.size(), 1U);
    ASSERT_EQ(log.report.skipped, 7U);
    ASSERT_EQ(log.report.examples.size(), 7U);
    for (std::size_t i = 0; i < 7; ++i) EXPECT_EQ(log.report.examples[i].line, i + 2);
    EXPECT_THAT(log.report.examples[0].reason.english(), HasSubstr("found none"));
    EXPECT_THAT(log.report.examples[1].reason.english(), HasSubstr("intensity"));
    EXPECT_THAT(log.report.examples[2].reason.english(), HasSubstr("bearing"));
}

TEST(ConversorRadish, WhatAreNoTriplesIsRefusedThoughItsNumbersAreAsMany) {
    const auto told = [](int readings, const auto& reading) {
        std::string text = "laser 0 1";
        for (int i = 0; i < readings; ++i)
            text +=
                reading(std::to_string(2.0 + 0.3 * ((7 * i) % 11)), std::to_string(0.1 * i - 1));
        const Log log = radish(text + "\nlaser 0 2 1 0.1 0\n");
        EXPECT_EQ(log.report.skipped, log.scans.size() == 1 ? 1U : 0U);
        return log.report.examples.empty() ? std::string()
                                           : log.report.examples[0].reason.english();
    };
    const auto word = [](const std::string& text) { return " " + text; };
    EXPECT_EQ(told(18, [&](auto r, auto b) { return word(r) + word(b) + " 0"; }), "");
    const char* const expected = "expected range bearing intensity for each";
    const auto pairs = told(18, [&](auto r, auto b) { return word(r) + word(b); });
    EXPECT_THAT(pairs, HasSubstr("readings: found two numbers for each, without an intensity"));
    EXPECT_THAT(pairs, HasSubstr(expected));
    EXPECT_THAT(told(18, [&](auto r, auto b) { return word(b) + word(r); }), HasSubstr(expected));
    EXPECT_THAT(told(18, [&](auto r, auto b) { return word(b) + word(r) + " 0"; }),
                HasSubstr("found the bearings in the place of the ranges, expected"));
    // Bearings of no order at all, beyond a turn.
    EXPECT_THAT(told(18, [&](auto r, auto) { return word("1") + word(r + "e1") + " 0"; }),
                HasSubstr("expected no more than a turn"));
}

TEST(ConversorRadish, TheFirstDeviceIsUsed) {
    const Log log = radish("laser 1 1 1 0 0\nlaser 0 2 1 0 0\nlaser 1 3 1 0 0\n");
    ASSERT_EQ(log.scans.size(), 2U);
    EXPECT_EQ(log.scans[1].time_s, 3.0);
}

TEST(ConversorRadish, TheCodeIsFoundBehindManyDamagedLines) {
    std::string damaged;
    for (int i = 0; i < 1500; ++i) damaged += "laser 0 2 1.0 nan 0\n";
    const Log log = radish(damaged + scans_with("8.00", 5, 30));
    EXPECT_EQ(log.report.skipped, 1500U);
    EXPECT_EQ(log.scans.at(0).points.size(), 16U);
}

}  // namespace
}  // namespace hitos
