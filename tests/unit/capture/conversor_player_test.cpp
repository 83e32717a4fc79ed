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

const std::string kLaserHead = " 16777343 6665 laser 00 ";
const std::string kPositionHead = " 16777343 6665 position2d 00 001 001 ";
const std::string kTwoRays = " -1.5708 +1.5708 +0.01735687 +8.0000 0002 1.000  1 2.000  1";

Log player(const std::string& text, const ReadOptions& options = {}) {
    return test::read_text("player", text, options);
}

/// The reason for which the one damaged line was skipped.
std::string reason(const std::string& line) {
    const Log log = player("0.1" + kLaserHead + "001 001 0000" + kTwoRays + "\n" + line + "\n");
    EXPECT_EQ(log.report.skipped, 1U) << line;
    if (log.report.examples.empty()) return {};
    EXPECT_EQ(log.report.examples.front().line, 2U);
    return log.report.examples.front().reason.english();
}

TEST(ConversorPlayer, LinesAsWritelogWritesThem) {
    const Log log = player(
        "## Player version 3.1.1-dev \n"
        "0000000000.050 16777343 6665 position2d 00 004 001 +00.000 +00.000 +0.000 +00.450 "
        "+00.380\n"
        "0000000000.150 16777343 6665 laser 00 004 001  +0.000  +0.000   0.000   0.100   0.100\n"
        "0000000000.100 16777343 6665 position2d 00 001 001 +00.500 -01.250 -0.000 +00.100 +00.000 "
        "-00.200 0\n"
        "0000000000.200 16777343 6665 laser 00 001 001 0000 -1.5708 +1.5708 +0.01735687 +8.0000 "
        "0003 1.000  1 8.000  0 2.500  1 \n");
    ASSERT_EQ(log.scans.size(), 1U);
    ASSERT_EQ(log.odometry.size(), 1U);
    EXPECT_EQ(log.report.skipped, 0U);
    const Scan& scan = log.scans[0];
    EXPECT_EQ(scan.time_s, 0.2);
    EXPECT_EQ(scan.line, 5U);
    EXPECT_EQ(scan.fan, (Fan{-1.5708, 1.5708, 3, 8.0, {}}));
    EXPECT_FALSE(scan.carries_odometry);
    ASSERT_EQ(scan.points.size(), 2U);
    expect_near(scan.points[0], Point2{std::cos(-1.5708), std::sin(-1.5708)}, 1e-15);
    expect_near(scan.points[1], Point2{2.5 * std::cos(1.5708), 2.5 * std::sin(1.5708)}, 1e-15);
    EXPECT_THAT(scan.rays, ElementsAre(0, 2));
    EXPECT_THAT(scan.run_starts, ElementsAre(0, 1));
    EXPECT_EQ(log.odometry[0].time_s, 0.1);
    EXPECT_EQ(log.odometry[0].line, 4U);
    EXPECT_EQ(log.odometry[0].twist, Twist{});
}

TEST(ConversorPlayer, AnglesComeFromTheCountNotFromTheStatedResolution) {
    std::string text = "0.1" + kLaserHead + "001 001 0000 -1.5708 +1.5708 +0.01735687 +8.0000 0181";
    for (int i = 0; i < 181; ++i) text += " 1.000  1";
    const Log log = player(text + " \n");
    ASSERT_EQ(log.scans.at(0).points.size(), 181U);
    expect_near(log.scans[0].points[90], Point2{1, 0}, 1e-12);
    expect_near(log.scans[0].points[180], Point2{std::cos(1.5708), std::sin(1.5708)}, 1e-12);
    EXPECT_THAT(log.scans[0].run_starts, ElementsAre(0));
}

TEST(ConversorPlayer, MountingPoseMovesThePoints) {
    const Log log =
        player("0.1" + kLaserHead + "004 001  +0.200  -0.100   1.570796   0.100   0.100\n" + "0.2" +
               kLaserHead + "001 001 0000 0.0 +1.0 0.1 +8.0000 0001 2.000  1\n");
    expect_near(log.scans.at(0).points.at(0), Point2{0.2, 1.9}, 1e-6);
    EXPECT_EQ(log.scans[0].fan.pose_robot_laser.x, 0.2);
}

TEST(ConversorPlayer, LaterGeometryCountsFromThereOn) {
    const std::string scan = kLaserHead + "001 001 0000 0.0 +1.0 0.1 +8.0000 0001 2.000  1\n";
    const Log log = player("0.1" + scan + "0.2" + kLaserHead + "004 001 1 0 0 0 0\n0.3" + scan);
    expect_near(log.scans.at(0).points.at(0), Point2{2, 0}, 1e-12);
    expect_near(log.scans.at(1).points.at(0), Point2{3, 0}, 1e-12);
}

TEST(ConversorPlayer, ReadingsThatAreNoPointsBreakRuns) {
    const Log log = player("0.1" + kLaserHead + "001 001 0000 -1.0 +1.0 0.1 +8.0000 0012 " +
                           "1 1 nan 0 1 1 1 1 inf 0 0.0 0 1 1 -1.0 0 1 1 8.000 0 9.5 0 -nan 0\n");
    ASSERT_EQ(log.scans.size(), 1U)
        << (log.report.examples.empty() ? "" : log.report.examples[0].reason.english());
    EXPECT_THAT(log.scans[0].rays, ElementsAre(0, 2, 3, 6, 8));
    EXPECT_THAT(log.scans[0].run_starts, ElementsAre(0, 1, 3, 4));
}

TEST(ConversorPlayer, MaximumWithFourDecimalsMatchesReadingsWithThree) {
    const Log log =
        player("0.1" + kLaserHead + "001 001 0000 -1.0 +1.0 0.1 +5.6004 0002 5.600 0 5.599 1\n");
    EXPECT_THAT(log.scans.at(0).rays, ElementsAre(1));
}

TEST(ConversorPlayer, MaxRangeOptionOverrules) {
    const std::string text =
        "0.1" + kLaserHead + "001 001 0000 -1.0 +1.0 0.1 +8.0000 0003 1.0 1 5.0 1 8.0 0\n";
    EXPECT_THAT(player(text, {5.0}).scans.at(0).rays, ElementsAre(0));
    EXPECT_THAT(player(text, {20.0}).scans.at(0).rays, ElementsAre(0, 1, 2));
    EXPECT_EQ(player(text, {5.0}).scans.at(0).fan.max_range_m, 5.0);
}

TEST(ConversorPlayer, ScanPoseAndScanAngle) {
    const Log log = player(
        "0.1" + kLaserHead +
        "001 002 0007 +01.000 +02.000 +00.500 -1.0 +1.0 +0.1 +8.0000 0002 1.0 1 2.0 1\n" + "0.2" +
        kLaserHead + "001 003 0007 +8.0000 0003 1.000 -0.500  1 8.000 0.000  0 2.000 0.500  1\n" +
        "0.3" + kLaserHead +
        "001 003 0007 +8.0000 0003 1.000 -0.500  1 1.000 0.300  0 2.000 0.500  1\n");
    ASSERT_EQ(log.scans.size(), 3U);
    EXPECT_EQ(log.scans[0].fan.count, 2U);
    expect_near(log.scans[0].points.at(1), Point2{2 * std::cos(1), 2 * std::sin(1)}, 1e-12);
    EXPECT_EQ(log.scans[1].fan, (Fan{-0.5, 0.5, 3, 8.0, {}}));
    EXPECT_THAT(log.scans[1].rays, ElementsAre(0, 2));
    expect_near(log.scans[1].points.at(1), Point2{2 * std::cos(.5), 2 * std::sin(.5)}, 1e-12);
    EXPECT_EQ(log.scans[2].fan.count, 0U);  // irregular
    EXPECT_EQ(log.scans[2].points.size(), 3U);
}

TEST(ConversorPlayer, RangerTakesAnglesFromItsConfiguration) {
    const std::string ranger = " 16777343 6665 ranger 00 ";
    const Log log = player(
        "0.1" + ranger + "001 001 0003 1.000 1.000 1.000\n" + "0.1" + ranger +
        "004 001 0.1 0.2 0.3 0 0 1.570796 0.1 0.1 0.1 0001 0 0 0 0 0 0 0000\n" + "0.15" + ranger +
        "004 005 -1.570796 1.570796 0.017357 0.0 8.0 0.01 5.0\n" + "0.2" + ranger +
        "001 001 0003 1.000 2.000 8.000 \n" + "0.2" + ranger + "001 003 0003 1.000 1.000 1.000 \n");
    ASSERT_EQ(log.scans.size(), 1U);
    EXPECT_EQ(log.scans[0].line, 4U);
    EXPECT_THAT(log.scans[0].rays, ElementsAre(0, 1));
    expect_near(log.scans[0].points[1], Point2{0.1, 2.2}, 1e-5);
    EXPECT_EQ(log.scans[0].fan.max_range_m, 8.0);
    ASSERT_EQ(log.report.skipped, 1U);
    EXPECT_THAT(log.report.examples[0].reason.english(), HasSubstr("angles are unknown"));
}

TEST(ConversorPlayer, EndlessDevicesDoNotFillTheMemory) {
    std::string text;
    for (int i = 0; i < 1000; ++i) {
        const std::string device = "0.1 1 2 ranger " + std::to_string(i) + " ";
        text += device + "004 005 -1.5 1.5 0.01 0.0 8.0 0.01 5.0\n";
    }
    const Log log = player(text + "0.2 1 2 ranger 7 001 001 0003 1.0 2.0 3.0\n");
    ASSERT_EQ(log.scans.size(), 1U) << "those that are known go on";
    EXPECT_EQ(log.report.skipped, 744U);
    EXPECT_THAT(log.report.examples[0].reason.english(), HasSubstr("more than 256 lasers"));
}

TEST(ConversorPlayer, TheFirstDeviceOfEachKindIsUsed) {
    const std::string scan = " 001 001 0000" + kTwoRays + "\n";
    const Log log =
        player("0.1 1 2 laser 01" + scan + "0.2 1 2 laser 00" + scan + "0.3 1 2 laser 01" + scan +
               "0.1 1 2 position2d 03 001 001 0 0 0 0 0 0 0\n"
               "0.2 1 2 position2d 00 001 001 9 9 0 0 0 0 0\n"
               "0.3 1 2 position2d 03 001 001 1 0 0 0 0 0 0\n");
    ASSERT_EQ(log.scans.size(), 2U);
    EXPECT_EQ(log.scans[1].time_s, 0.3);
    ASSERT_EQ(log.odometry.size(), 2U);
    EXPECT_NEAR(log.odometry[1].twist.v, 5.0, 1e-9);
    EXPECT_EQ(log.report.skipped, 0U);
}

TEST(ConversorPlayer, OldHeadersAndTheirPayloads) {
    const Log log = player(
        "## Player version 1.6.5\n"
        "0000000001.000 myhost 6665 sync 00 0000000001.000 \n"
        "0000000001.000 myhost 6665 position 00 0000000001.000 +00.000 +00.000 +0.000 +00.000 "
        "+00.000 +00.000 0\n"
        "0000000002.000 myhost 6665 position 00 0000000002.000 +01.000 +00.000 +0.000 +00.000 "
        "+00.000 +00.000 0\n"
        "0000000002.000 myhost 6665 laser 00 0000000002.000 -1.5708 +1.5708 +0.0175 0003 1.000  0 "
        "2.000  0 81.910  0 \n");
    ASSERT_EQ(log.scans.size(), 1U);
    EXPECT_EQ(log.report.skipped, 0U);
    EXPECT_EQ(log.scans[0].fan, (Fan{-1.5708, 1.5708, 3, 0.0, {}}));
    EXPECT_THAT(log.scans[0].rays, ElementsAre(0, 1));  // 81.91 is over the assumed 49.9
    ASSERT_EQ(log.odometry.size(), 2U);
    EXPECT_EQ(log.odometry[1].twist, (Twist{1, 0, 0}));
}

TEST(ConversorPlayer, PayloadsOfTheMonthsBetweenTheVersions) {
    const Log log = player("1" + kLaserHead + "001 001 -1.0 +1.0 +0.1 +8.0000 0002 1.0 1 2.0 1\n" +
                           "2" + kLaserHead + "001 001 -1.0 +1.0 +0.1 0002 1.0 1 2.0 1\n" + "3" +
                           kLaserHead + "001 001 0007 -1.0 +1.0 +0.1 0002 1.0 1 2.0 1\n" + "4" +
                           kLaserHead + "001 001 0007 -1.0 +1.0 +0.1 8 0002 1.0 1 2.0 1\n");
    ASSERT_EQ(log.scans.size(), 4U);
    EXPECT_EQ(log.scans[0].fan.max_range_m, 8.0);
    EXPECT_EQ(log.scans[1].fan.max_range_m, 0.0);
    EXPECT_EQ(log.scans[2].fan.max_range_m, 0.0);
    EXPECT_EQ(log.scans[3].fan.max_range_m, 8.0);
    for (const Scan& scan : log.scans) {
        EXPECT_EQ(scan.points, log.scans[0].points);
        EXPECT_EQ(scan.points.size(), 2U);
    }
}

TEST(ConversorPlayer, HeaderOnlyLinesSurvive) {
    const Log log =
        player("0.1" + kLaserHead + "001 001 0000" + kTwoRays + "\n0.1" + kLaserHead +
               "001 002 \n" + "0.1" + kLaserHead + "004 001 \n0.1 1 2 position2d 00 001 002 \n");
    EXPECT_EQ(log.report.skipped, 0U);
    EXPECT_EQ(log.scans.size(), 1U);
}

TEST(ConversorPlayer, DamagedLinesSayWhatIsWrong) {
    const std::string head =
        "0.2" + kLaserHead + "001 001 0000 -1.5708 +1.5708 +0.01735687 +8.0000 ";
    EXPECT_THAT(reason(head + "0003 1.000  1 2.000  1"), HasSubstr("range: found the end"));
    EXPECT_THAT(reason(head + "0001 1.000  1 2.000  1"), HasSubstr("expected the end of the line"));
    EXPECT_THAT(reason(head + "-002 1.000  1 2.000  1"), HasSubstr("count: found \"-002\""));
    EXPECT_THAT(reason(head + "0000"), HasSubstr("whole number from 1"));
    EXPECT_THAT(reason(head + "4294967297 1.0 1"), HasSubstr("count"));
    EXPECT_THAT(reason(head + "0002 1.0x0  1 2.000  1"), HasSubstr("range: found \"1.0x0\""));
    EXPECT_THAT(reason(head + "0002 1.000  1 2.000"), HasSubstr("intensity"));
    EXPECT_THAT(reason("0.2.3" + kLaserHead + "001 001 0000" + kTwoRays), HasSubstr("time"));
    EXPECT_THAT(reason("nan" + kLaserHead + "001 001 0000" + kTwoRays), HasSubstr("player"));
    EXPECT_THAT(reason("-inf" + kLaserHead + "001 001 0000" + kTwoRays), HasSubstr("time"));
    EXPECT_THAT(reason("0.2" + kLaserHead + "0x1 001 0000" + kTwoRays), HasSubstr("type"));
    EXPECT_THAT(reason("0.2" + kLaserHead + "001 001"), HasSubstr("found the end"));
    EXPECT_THAT(reason("0.2" + kLaserHead + "004 001 0 0 x 0 0"), HasSubstr("pyaw"));
    EXPECT_THAT(reason("0.2" + kPositionHead + "1 2 3 4 5 6"), HasSubstr("stall"));
    EXPECT_THAT(reason("0.2" + kPositionHead + "1 2 3 4 5 6 0 7"), HasSubstr("after stall"));
    EXPECT_THAT(reason("0.2" + kPositionHead + "nan 2 3 4 5 6 0"), HasSubstr("px"));
    EXPECT_THAT(reason("0.2 1 2 laser"), HasSubstr("player"));
    EXPECT_THAT(reason("what is this"), HasSubstr("player"));
}

}  // namespace
}  // namespace hitos
