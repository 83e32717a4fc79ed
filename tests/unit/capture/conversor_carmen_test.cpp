// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test_files.hpp"

namespace hitos {
namespace {

using test::expect_near;
using test::Log;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Log carmen(const std::string& text, const ReadOptions& options = {}) {
    return test::read_text("carmen", text, options);
}

std::string ones(int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += " 1";
    return text;
}

std::string flaser(int count, const std::string& tail = " 5 5 5 1 2 0.5 3.25 h 3.25\n") {
    return "FLASER " + std::to_string(count) + ones(count) + tail;
}

double degrees(double rad) {
    return rad * 180.0 / kPi;
}

TEST(ConversorCarmen, FlaserIsScanAndOdometry) {
    const Log log = carmen("ODOM 0 0 0 0.5 0.1 0 3.0 h 3.0\n" + flaser(180));
    ASSERT_EQ(log.scans.size(), 1U);
    EXPECT_EQ(log.scans[0].time_s, 3.25);
    EXPECT_TRUE(log.scans[0].carries_odometry);
    ASSERT_EQ(log.odometry.size(), 2U);
    EXPECT_EQ(log.odometry[1].line, 2U);
    expect_near(test::summed(log.odometry).back(), {1, 2, 0.5}, 1e-12);  // not 5 5 5
}

TEST(ConversorCarmen, FlaserFans) {
    const auto fan = [](int count, const std::string& parameter = {}) {
        return carmen(parameter + flaser(count)).scans.at(0).fan;
    };
    EXPECT_NEAR(degrees(fan(180).min_angle_rad), -90, 1e-12);
    EXPECT_NEAR(degrees(fan(180).max_angle_rad), 89, 1e-12);
    EXPECT_NEAR(degrees(fan(360).max_angle_rad), 89.5, 1e-12);
    EXPECT_NEAR(degrees(fan(181).max_angle_rad), 90, 1e-12);
    EXPECT_NEAR(degrees(fan(361).min_angle_rad), -90, 1e-12);
    EXPECT_EQ(fan(1).min_angle_rad, 0.0);
    const std::string half = "PARAM laser_front_laser_resolution 0.5 h 0\n";
    EXPECT_NEAR(degrees(fan(360, half).min_angle_rad), -90, 1e-12);
    EXPECT_NEAR(degrees(fan(360, half).max_angle_rad), 89.5, 1e-12);
    EXPECT_NEAR(degrees(fan(361, half).max_angle_rad), 90, 1e-12);
    EXPECT_NEAR(degrees(fan(201, half).min_angle_rad), -50, 1e-12);
    EXPECT_NEAR(degrees(fan(200, half).min_angle_rad), -49.75, 1e-12);
    EXPECT_NEAR(degrees(fan(201, half).max_angle_rad), 50, 1e-12);
}

TEST(ConversorCarmen, ParametersOfTheLaser) {
    const std::string scan = "FLASER 3 1.0 20.0 30.0 0 0 0 0 0 0 1 h 1\n";
    EXPECT_THAT(carmen(scan).scans.at(0).rays, ElementsAre(0, 1, 2));
    const Log log = carmen(
        "PARAM robot_front_laser_max 20.0 h 0\nPARAM robot_width xyz h 0\n"
        "PARAM robot_frontlaser_offset 0.3 nohost 0\n" +
        scan);
    EXPECT_THAT(log.scans.at(0).rays, ElementsAre(0));
    EXPECT_EQ(log.scans[0].fan.max_range_m, 20.0);
    expect_near(log.scans[0].points[0], Point2{0.3, -1.0}, 1e-12);
    EXPECT_EQ(log.report.skipped, 0U);
    EXPECT_EQ(carmen("PARAM robot_front_laser_max x h 0\n" + scan).report.skipped, 1U);
}

TEST(ConversorCarmen, StatedMaximumAboveTheCode) {
    // SICK scanners under CARMEN state 81.92 and write 81.91.
    std::string text = "PARAM robot_front_laser_max 81.92 h 0\n";
    for (int s = 0; s < 12; ++s) {
        text += "FLASER 8 1 1 81.91 81.91 81.91 81.91 81.91 " + std::to_string(2 + 0.1 * s) +
                " 0 0 0 0 0 0 " + std::to_string(s) + " h 0\n";
    }
    EXPECT_EQ(carmen(text).scans.at(0).points.size(), 3U);
}

TEST(ConversorCarmen, RobotLaser) {
    const std::string head = "ROBOTLASER1 0 -1.570796 3.141593 1.570796 20.0 0.01 0 3 1 2 30 ";
    const std::string tail = "1.0 0.2 1.570796 1 0 1.570796 0.5 0.1 0.8 0.4 0.0 7.5 h 7.5\n";
    const Log log = carmen(head + "3 10 20 30 " + tail);
    ASSERT_EQ(log.scans.size(), 1U) << log.report.examples.at(0).reason.english();
    const Scan& scan = log.scans[0];
    EXPECT_TRUE(scan.carries_odometry);
    EXPECT_EQ(scan.time_s, 7.5);
    EXPECT_NEAR(scan.fan.max_angle_rad, kPi / 2, 1e-6);
    EXPECT_EQ(scan.fan.max_range_m, 20.0);
    expect_near(scan.fan.pose_robot_laser, {0.2, 0, 0}, 1e-6);
    EXPECT_THAT(scan.rays, ElementsAre(0, 1));
    expect_near(scan.points[1], Point2{2.2, 0}, 1e-5);
    ASSERT_EQ(log.odometry.size(), 1U);
    // The same line in its other shapes: no remissions; none of them; no turn axis; no logger time.
    const std::vector<std::string> shapes = {
        head + tail, head + "0 " + tail,
        head + "1.0 0.2 1.570796 1 0 1.570796 0.5 0.1 0.8 0.4 7.5 h 7.5\n",
        head + "0 1.0 0.2 1.570796 1 0 1.570796 0.5 0.1 0.8 0.4 0.0 7.5 h\n"};
    for (const std::string& shape : shapes) {
        const Log other = carmen(shape);
        ASSERT_EQ(other.scans.size(), 1U) << shape << other.report.examples.at(0).reason.english();
        EXPECT_EQ(other.scans[0].points, scan.points) << shape;
        EXPECT_EQ(other.scans[0].time_s, 7.5) << shape;
        EXPECT_EQ(other.odometry.size(), 1U) << shape;
    }
    EXPECT_EQ(carmen(head + "4 10 20 30 " + tail).report.skipped, 1U);
    const Log sparing = carmen(head + "2 10 20 30 " + tail);
    ASSERT_EQ(sparing.report.skipped, 1U);
    EXPECT_THAT(sparing.report.examples.at(0).reason.english(),
                HasSubstr("num_remissions: found 2"));
    const Log lying = carmen(head + "9 10 20 30 " + tail);
    ASSERT_EQ(lying.report.skipped, 1U);
    EXPECT_THAT(lying.report.examples.at(0).reason.english(), HasSubstr("num_remissions: found 9"));
}

TEST(ConversorCarmen, RoundedPosesDoNotMoveTheMounting) {
    const std::string head = "ROBOTLASER1 0 -1.5 3.0 1.5 20.0 0.01 0 3 1 2 3 0 ";
    const Log log = carmen(head + "0.2 0 0 0 0 0 0 0 0 0 0 1.0 h 1\n" + head +
                           "1.200003 0.000002 0 1 0 0 0 0 0 0 0 2.0 h 2\n");
    EXPECT_EQ(log.scans.at(0).fan, log.scans.at(1).fan);
}

TEST(ConversorCarmen, LaserThatLeavesTheLastRayOut) {
    std::string line = "RAWLASER1 0 -1.570796 3.141593 0.008727 81.92 0.01 0 360" + ones(360);
    const Log log = carmen(line + " 0 5.0 h 5.0\n");
    ASSERT_EQ(log.scans.size(), 1U);
    EXPECT_NEAR(degrees(log.scans[0].fan.max_angle_rad), 89.5, 1e-4);
    EXPECT_FALSE(log.scans[0].carries_odometry);
    EXPECT_TRUE(log.odometry.empty());
    EXPECT_EQ(carmen(line + " 5.0 h 5.0\n").scans.size(), 1U);  // before remission
}

TEST(ConversorCarmen, ALaserLoggedRawAndAsRobotLaserIsReadOnce) {
    const std::string raw = "RAWLASER1 0 -1.5 3.0 1.5 20.0 0.01 0 3 1 2 3 0 1.0 h 1\n";
    // As CARMEN logs it: a little later, so that it is no duplicate by its stamp.
    const std::string robot =
        "ROBOTLASER1 0 -1.5 3.0 1.5 20.0 0.01 0 3 1 2 3 0 0 0 0 0 0 0 0 0 0 0 0 1.02 h 1\n";
    const std::string damaged = "ROBOTLASER1 0 -1.5 3.0 1.5 20.0 0.01 0 9 1 2 3 0 1.0 h 1\n";
    const Log log = carmen(raw + robot + damaged);
    ASSERT_EQ(log.scans.size(), 1U);
    EXPECT_EQ(log.scans[0].time_s, 1.0);
    EXPECT_EQ(log.report.duplicate_scans, 0U);
    EXPECT_EQ(carmen(robot + raw).scans.size(), 1U);  // whichever comes first
    EXPECT_EQ(log.odometry.size(), 1U);
    EXPECT_EQ(log.report.skipped, 1U);
}

/// Of a laser 0.2 m ahead on the robot.
std::string robot_laser(double time_s) {
    return fmt::format(
        "ROBOTLASER1 0 -1.5 3.0 1.5 20.0 0.01 0 3 1 2 3 0 0.2 0 0 0 0 0 0 0 0 0 0 {} h 1\n",
        time_s);
}

std::string raw_laser(double time_s) {
    return fmt::format("RAWLASER1 0 -1.5 3.0 1.5 20.0 0.01 0 3 1 2 3 0 {} h 1\n", time_s);
}

std::vector<double> times_of(const Log& log) {
    std::vector<double> times;
    for (const Scan& scan : log.scans) times.push_back(scan.time_s);
    return times;
}

TEST(ConversorCarmen, WhereOneMessageEndsTheOtherGoesOn) {
    std::string text;
    for (const double time_s : {1.0, 2.0, 3.0}) text += robot_laser(time_s);
    for (const double time_s : {4.0, 5.0, 6.0, 7.0, 8.0, 9.0}) text += raw_laser(time_s);
    // One that comes back is the same laser again.
    for (const double time_s : {10.0, 11.0}) text += robot_laser(time_s) + raw_laser(time_s);
    const Log log = carmen(text);
    EXPECT_EQ(times_of(log), (std::vector<double>{1.0, 2.0, 3.0, 8.0, 9.0, 10.0, 11.0}));
    for (const Scan& scan : log.scans) EXPECT_EQ(scan.fan.pose_robot_laser.x, 0.2) << scan.time_s;
    const Log stated = carmen("PARAM robot_frontlaser_offset 0.1\n" + text);
    EXPECT_EQ(stated.scans.front().fan.pose_robot_laser.x, 0.2);
    EXPECT_EQ(stated.scans.back().fan.pose_robot_laser.x, 0.1);
}

TEST(ConversorCarmen, NoStampAndNoPauseMakesAnotherMessageTheOneInUse) {
    // One bad stamp, a pause of both, and the other by a clock that is ahead.
    std::string text =
        robot_laser(1.0) + raw_laser(1e6) + robot_laser(2.0) + raw_laser(12.0) + robot_laser(3.0);
    for (const double time_s : {30.0, 31.0}) text += raw_laser(time_s) + robot_laser(time_s);
    EXPECT_EQ(times_of(carmen(text)), (std::vector<double>{1.0, 2.0, 3.0, 30.0, 31.0}));
}

TEST(ConversorCarmen, IgnoresOtherMessages) {
    const Log log = carmen(
        "# CARMEN Logfile\nSYNC x 1 h 1\nRLASER 2 1 1 0 0 0 0 0 0 1 h 1\n"
        "TRUEPOS 0 0 0 0 0 0 1 h 1\nGPS 1 2 3\n" +
        flaser(2));
    EXPECT_EQ(log.scans.size(), 1U);
    EXPECT_EQ(log.report.skipped, 0U);
}

TEST(ConversorCarmen, ADamagedFlaserIsOutOfBothSequencesAndCountedOnce) {
    for (const std::string& bad :
         {std::string("FLASER 3 1 1 0 0 0 1 1 1 2 h 2\n"),
          std::string("FLASER 2 1 x 0 0 0 1 1 1 2 h 2\n"),
          std::string("FLASER 2 1 1 0 0 0 1 nan 1 2 h 2\n"),
          std::string("FLASER 0 0 0 0 1 1 1 2 h 2\n"),
          std::string("FLASER -2 1 1 0 0 0 1 1 1 2 h 2\n"), std::string("FLASER\n"),
          std::string("FLASER 2 1 1 0 0 0 1 1 1 2 h 2 3\n"),
          std::string("FLASER 2 1 1 0 0 0 1 1 1\n")}) {
        const Log log = carmen(flaser(2) + bad);
        EXPECT_EQ(log.scans.size(), 1U) << bad;
        EXPECT_EQ(log.odometry.size(), 1U) << bad;
        ASSERT_EQ(log.report.skipped, 1U) << bad;
        EXPECT_EQ(log.report.examples.at(0).line, 2U) << bad;
    }
}

/// A robot that drives 0.1 m every 0.2 s, with a scan between two readings; `stamp` makes a line's
/// stamp of its message and the logger's time.
template <class Stamp>
std::string drive(Stamp stamp, int readings = 60) {
    std::string text;
    const auto tail = [&](const char* name, double logged_s) {
        text += " " + stamp(name, logged_s) + " h " + std::to_string(logged_s) + "\n";
    };
    for (int i = 0; i < readings; ++i) {
        text += "ODOM " + std::to_string(0.1 * i) + " 0 0 0.5 0 0";
        tail("ODOM", 0.2 * i);
        text += "FLASER 2 1 " + std::to_string(1 + 0.01 * i) + " 0 0 0 " +
                std::to_string(0.1 * i + 0.05) + " 0 0";
        tail("FLASER", 0.2 * i + 0.1);
    }
    return text;
}

std::string late_scans(double late_s) {
    return drive([late_s](std::string_view name, double logged_s) {
        return std::to_string(1e9 + logged_s - (name == "FLASER" ? late_s : 0.0));
    });
}

std::string whole_seconds() {
    return drive([](std::string_view, double logged_s) {
        return std::to_string(1'000'000'000 + static_cast<int>(logged_s));
    });
}

TEST(ConversorCarmen, TheLoggersTimesTellThatScansAreOfAnotherClock) {
    for (const double late_s : {5.0, -12.0}) {
        const Log log = carmen(late_scans(late_s));
        ASSERT_EQ(log.findings.size(), 1U) << late_s;
        EXPECT_EQ(log.findings[0].kind, TourFinding::Kind::late_stamps);
        ASSERT_TRUE(log.findings[0].later_s);
        EXPECT_NEAR(*log.findings[0].later_s, late_s, 1e-3);
    }
    EXPECT_TRUE(carmen(late_scans(0.0)).findings.empty());
    EXPECT_TRUE(carmen(late_scans(0.7)).findings.empty());  // as a logger may hold lines up
}

TEST(ConversorCarmen, ScansOfAnotherClockHaveNoPoseAmongTheReadings) {
    for (const double late_s : {5.0, -12.0, 0.7}) {
        const Log log = carmen(late_scans(late_s));
        EXPECT_EQ(log.odometry.size(), 60U) << late_s;
        EXPECT_EQ(log.report.stamps_backwards, 0U) << late_s;
        EXPECT_EQ(log.scans.size(), 60U) << late_s;
        EXPECT_FALSE(log.scans[0].carries_odometry) << late_s;
    }
    EXPECT_EQ(carmen(late_scans(0.0)).odometry.size(), 120U);
}

TEST(ConversorCarmen, StampsOfWholeSecondsGiveWayToTheLoggersTimes) {
    const Log log = carmen(whole_seconds());
    ASSERT_EQ(log.findings.size(), 1U);
    EXPECT_EQ(log.findings[0].kind, TourFinding::Kind::coarse_stamps);
    EXPECT_NEAR(log.findings[0].value, 0.8, 0.05);
    EXPECT_NEAR(log.scans.at(1).time_s - log.scans.at(0).time_s, 0.2, 1e-6);
    EXPECT_NEAR(log.scans[0].time_s, 1e9, 1.0);  // still of the stamps' clock
    EXPECT_EQ(log.report.stamps_backwards, 0U);
    for (std::size_t i = 1; i < log.odometry.size(); ++i) {
        EXPECT_NEAR(log.odometry[i].twist.v, 0.5, 1e-3) << i;
    }
    ReadOptions as_it_is;
    as_it_is.mend = Mend::rays;
    const Log told = carmen(whole_seconds(), as_it_is);
    EXPECT_EQ(told.scans.at(0).time_s, told.scans.at(1).time_s);
    EXPECT_TRUE(told.findings.empty());  // TourExamination counts them
}

TEST(ConversorCarmen, WithoutTheLoggersTimesNothingIsSaidOfClocks) {
    std::string text = late_scans(5.0);
    std::string bare;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find('\n', at);
        bare += text.substr(at, text.rfind(' ', end) - at) + "\n";
        at = end + 1;
    }
    const Log log = carmen(bare);
    EXPECT_EQ(log.scans.size(), 60U);
    // The scans' own odometry is out of line among that of the other lines.
    ASSERT_EQ(log.findings.size(), 1U);
    EXPECT_EQ(log.findings[0].kind, TourFinding::Kind::broken_stamps);
}

/// Twenty scans of ten rays that vary by `step` from `first` on.
std::string scans_from(double first, double step, const std::string& parameter = {}) {
    std::string text = parameter;
    for (int i = 0; i < 20; ++i) {
        text += "FLASER 10";
        for (int ray = 0; ray < 10; ++ray) text += " " + std::to_string(first + step * (i + ray));
        text += " 0 0 0 0 0 0 " + std::to_string(i) + " h " + std::to_string(i) + "\n";
    }
    return text;
}

TEST(ConversorCarmen, ReadingsInMillimetresAreTold) {
    for (const std::string& limit :
         {std::string(), std::string("PARAM robot_front_laser_max 30.0 h 0\n")}) {
        const Log log = carmen(scans_from(2000.0, 13.0, limit));
        EXPECT_TRUE(log.scans.at(0).points.empty());
        ASSERT_EQ(log.findings.size(), 1U);
        EXPECT_EQ(log.findings[0].kind, TourFinding::Kind::laser_units);
        EXPECT_NEAR(log.findings[0].value, 2200.0, 100.0);
    }
    EXPECT_TRUE(carmen(scans_from(2.0, 0.013)).findings.empty());
    EXPECT_TRUE(carmen(scans_from(50.0, 0.5)).findings.empty());    // outdoors, in metres
    EXPECT_TRUE(carmen(scans_from(8191.0, 0.0)).findings.empty());  // no return
    // In metres, and a limit that leaves none of them.
    const Log blind = carmen(scans_from(2.0, 0.013, "PARAM robot_front_laser_max 1.5 h 0\n"));
    ASSERT_EQ(blind.findings.size(), 1U);
    EXPECT_EQ(blind.findings[0].kind, TourFinding::Kind::blind_laser);
    EXPECT_EQ(blind.findings[0].value, 1.0);
}

TEST(ConversorCarmen, WallsBeyondAGreatestRangeThatIsTooSmallAreTold) {
    const auto of = [](double greatest, double far) {
        std::string text = "PARAM robot_front_laser_max " + std::to_string(greatest) + " h 0\n";
        for (int i = 0; i < 20; ++i) {
            text += "FLASER 20";
            for (int ray = 0; ray < 20; ++ray)
                text += " " + std::to_string(ray < 15 ? 2.0 + 0.02 * ray
                                                      : far + 0.1 * (far < 50.0 ? ray : 0));
            text += " 0 0 0 0 0 0 " + std::to_string(i) + " h " + std::to_string(i) + "\n";
        }
        return carmen(text);
    };
    const Log log = of(4.0, 8.0);
    ASSERT_EQ(log.findings.size(), 1U);
    EXPECT_EQ(log.findings[0].kind, TourFinding::Kind::blind_laser);
    EXPECT_NEAR(log.findings[0].value, 0.2, 0.01);
    EXPECT_EQ(log.findings[0].remedies.front().settings.front().value, "10");
    EXPECT_TRUE(of(40.0, 8.0).findings.empty());
    EXPECT_TRUE(of(4.0, 81.91).findings.empty()) << "a code for no return";
}

}  // namespace
}  // namespace hitos
