// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/files/trajectory_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "hitos/base/error.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using test::message_of;
using test::TempFolder;
using ::testing::HasSubstr;

std::string path_refusal(std::string_view text) {
    return message_of<FormatError>([&] { parse_trajectory(text, "t.tum"); });
}

TEST(ParseTrajectory, ReadsTheWayOfARobotOfMrclam) {
    const std::string head = "# UTIAS Multi-Robot Cooperative Localization and Mapping Dataset\n";
    const Trajectory way = parse_trajectory(head +
                                                "# Time [s] x [m] y [m] orientation [rad]\n"
                                                "1248272272.841 \t 3.5 \t -2.25 \t 1.5\n"
                                                "1248272272.856 3.5 -2.25 4.0\n",
                                            "Robot1_Groundtruth.dat");
    ASSERT_EQ(way.size(), 2U);
    EXPECT_EQ(way[0].time_s, 1248272272.841);
    EXPECT_EQ(way[0].pose, (Pose{3.5, -2.25, 1.5}));
    EXPECT_DOUBLE_EQ(way[1].pose.theta, wrap_angle(4.0));
    EXPECT_THROW(parse_trajectory(head + "1 2 3\n", "short"), FormatError);
    EXPECT_THROW(parse_trajectory(head, "none"), FormatError);
}

TEST(ParseTrajectory, ReadsPosesInOrder) {
    const Trajectory trajectory = parse_trajectory(
        "# t x y z qx qy qz qw\n\n 5.5 1 -2 7 0 0 0.7071067811865476 0.7071067811865476\r\n"
        "1e0\t0 0 0 0 0 0 1",
        "t");
    ASSERT_EQ(trajectory.size(), 2U);
    EXPECT_EQ(trajectory[0].time_s, 5.5);
    EXPECT_EQ(trajectory[0].pose.x, 1.0);
    EXPECT_EQ(trajectory[0].pose.y, -2.0);
    EXPECT_NEAR(trajectory[0].pose.theta, kPi / 2.0, 1e-15);
    EXPECT_EQ(trajectory[1], (StampedPose{1.0, {}}));
}

TEST(ParseTrajectory, SaysWhereAnotherTourBegins) {
    Trajectory path{{1.0, {}}, {2.0, {1.0, 0.0, 0.0}}, {3.0, {9.0, 5.0, 0.0}, true}, {4.0, {}}};
    const std::string text = trajectory_to_text(path);
    EXPECT_EQ(parse_trajectory(text, "t"), path);
    EXPECT_THAT(text, ::testing::HasSubstr("\n# another tour begins\n3 9.0"));
    // Nothing comes before the first.
    path.front().begins = true;
    EXPECT_EQ(trajectory_to_text(path), text);
}

TEST(ParseTrajectory, HeadingIsTheYawOfAnyQuaternion) {
    // Yaw, then pitch, then roll; and the same rotation from the opposite quaternion.
    std::mt19937_64 random(9);
    std::uniform_real_distribution<double> yaws(-kPi, kPi);
    std::uniform_real_distribution<double> tilts(-1.2, 1.2);
    for (int i = 0; i < 1000; ++i) {
        const double yaw = yaws(random);
        const double p = tilts(random) / 2.0;
        const double r = tilts(random) / 2.0;
        const double y = yaw / 2.0;
        const double w =
            std::cos(r) * std::cos(p) * std::cos(y) + std::sin(r) * std::sin(p) * std::sin(y);
        const double qx =
            std::sin(r) * std::cos(p) * std::cos(y) - std::cos(r) * std::sin(p) * std::sin(y);
        const double qy =
            std::cos(r) * std::sin(p) * std::cos(y) + std::sin(r) * std::cos(p) * std::sin(y);
        const double qz =
            std::cos(r) * std::cos(p) * std::sin(y) - std::sin(r) * std::sin(p) * std::cos(y);
        for (const double side : {1.0, -1.0}) {
            const std::string text =
                fmt::format("0 0 0 0 {} {} {} {}", side * qx, side * qy, side * qz, side * w);
            EXPECT_NEAR(wrap_angle(parse_trajectory(text, "t")[0].pose.theta - yaw), 0.0, 1e-12);
        }
    }
}

TEST(ParseTrajectory, HeadingBackwardsIsPlusPi) {
    EXPECT_EQ(parse_trajectory("0 0 0 0 0 0 1 0", "t")[0].pose.theta, kPi);
    EXPECT_EQ(parse_trajectory("0 0 0 0 0 0 -1 0", "t")[0].pose.theta, kPi);
}

TEST(ParseTrajectory, NamesLineFoundAndExpected) {
    EXPECT_EQ(path_refusal("0 0 0 0 0 0 0 1\n1 2 3\n"),
              "t.tum:2: found 3 fields; expected 8 numbers, t x y z qx qy qz qw");
    EXPECT_EQ(path_refusal("0 0 0 0 0 0 0 1 9"),
              "t.tum:1: found 9 fields; expected 8 numbers, t x y z qx qy qz qw");
    EXPECT_EQ(path_refusal("\n0 0 a 0 0 0 0 1"), "t.tum:2: y is \"a\"; expected a finite number");
    EXPECT_EQ(path_refusal("nan 0 0 0 0 0 0 1"), "t.tum:1: t is \"nan\"; expected a finite number");
    EXPECT_EQ(path_refusal("0 0 0 0 0 0 0 inf"),
              "t.tum:1: qw is \"inf\"; expected a finite number");
    EXPECT_EQ(path_refusal("0 0 0 0 0 0 0 0\n1 0 0 0 0 0 0 1\n2 0 0 0 0 0 0 0"),
              "t.tum:1: the quaternion's length is 0; expected 1");
    EXPECT_EQ(path_refusal("0 0 0 0 0 0 3 4"), "t.tum:1: the quaternion's length is 5; expected 1");
    EXPECT_EQ(path_refusal("# nothing\n"),
              "t.tum: no pose in the file; expected 8 numbers, t x y z qx qy qz qw on each line");
}

TEST(ParseTrajectory, OfPositionsAloneMayHaveZerosForQuaternions) {
    const Trajectory read = parse_trajectory("0 1 2 0 0 0 0 0\n1 3 4 0 0 0 0 0\n", "t.tum");
    EXPECT_EQ(read, (Trajectory{{0.0, {1.0, 2.0, 0.0}}, {1.0, {3.0, 4.0, 0.0}}}));
}

TEST(ParseTrajectory, ReadsCommasNamesAndOtherStampsWhereThereIsNoDoubt) {
    const Trajectory expected = {{1700000000.5, {1.0, -2.0, kPi / 2.0}},
                                 {1700000001.0, {1.5, -2.5, 0.0}}};
    const auto written = [](std::string_view names, std::string_view between,
                            std::string_view stamp_ends, bool qw_first,
                            std::string_view more = "") {
        const std::string first =
            qw_first ? "0.70710678 0 0 0.70710678" : "0 0 0.70710678 0.70710678";
        const std::string second = qw_first ? "1 0 0 0" : "0 0 0 1";
        const std::string rows =
            fmt::format("17000000005{0} 1 -2 7 {1}{3}\r\n17000000010{0} 1.5 -2.5 7 {2}{3}\r\n",
                        stamp_ends, first, second, more);
        std::string text(names);
        for (const char c : rows) c == ' ' ? text.append(between) : text.append(1, c);
        return text;
    };
    const char* euroc =
        "#timestamp [ns],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],q_RS_w [],q_RS_x [],q_RS_y [],"
        "q_RS_z [],v_x [m s^-1],b_x [rad s^-1]\n";
    for (const std::string& text :
         {written("", ",", "e-1", false), written("", ", ", "e-1", false),
          written("", ";", "e-1", false), written("", " , ", "e-1", false),
          written("timestamp,tx,ty,tz,qx,qy,qz,qw\n", ",", "e-1", false),
          written("# t x y z qw qx qy qz\n", " ", "e-1", true),
          written("\xef\xbb\xbf", " ", "00000000", false), written("", " ", "00", false),
          written("", " ", "00000", false), written(euroc, ",", "00000000", true, " 3 4")}) {
        const Trajectory found = parse_trajectory(text, "t");
        ASSERT_EQ(found.size(), 2U) << text;
        for (std::size_t i = 0; i < 2; ++i) {
            EXPECT_NEAR(found[i].time_s, expected[i].time_s, 1e-6) << text;
            EXPECT_EQ(found[i].pose.x, expected[i].pose.x) << text;
            EXPECT_EQ(found[i].pose.y, expected[i].pose.y) << text;
            EXPECT_NEAR(found[i].pose.theta, expected[i].pose.theta, 1e-7) << text;
        }
    }
    // Of a simulation's clock, which says nothing by its size.
    EXPECT_EQ(parse_trajectory("#t [ns],x,y,z,qx,qy,qz,qw\n5000000,0,0,0,0,0,0,1", "t")[0].time_s,
              0.005);
}

/// A hundred poses `metres` from each other and `step` in the stamps.
Trajectory driven(double first, double step, double metres) {
    std::string text;
    for (int i = 0; i < 100; ++i) {
        text += fmt::format("{} {} 0 0 0 0 0 1\n", first + i * step, i * metres);
    }
    return parse_trajectory(text, "some.tum");
}

TEST(ParseTrajectory, StampsOfASimulationsClockAreBroughtToSeconds) {
    for (const double unit : {1e3, 1e6, 1e9}) {
        for (const double begin_s : {0.0, 7.0, 1000.0, 1.7e9}) {
            for (const double step_s : {0.025, 0.2, 2.0}) {
                const Trajectory path = driven(begin_s * unit, step_s * unit, 0.4 * step_s);
                EXPECT_NEAR(path[3].time_s, begin_s + 3 * step_s, 1e-6)
                    << unit << " " << begin_s << " " << step_s;
            }
        }
    }
}

TEST(ParseTrajectory, SecondsStaySeconds) {
    for (const double step_s : {0.5, 1.0, 10.0, 60.0}) {
        EXPECT_EQ(driven(1000.0, step_s, 0.1 * step_s)[1].time_s, 1000.0 + step_s);
    }
    EXPECT_EQ(driven(0.0, 15.0, 0.1)[1].time_s, 15.0);      // slow, and near in time
    EXPECT_EQ(driven(0.0, 3600.0, 0.0)[1].time_s, 3600.0);  // parked
}

TEST(ParseTrajectory, TellsWhatItDoubts) {
    EXPECT_THAT(path_refusal("0,5 1,0 0,0 0 0 0 0 1\n"),
                HasSubstr("t is \"0,5\", with a decimal comma"));
    EXPECT_THAT(path_refusal("0,5;1,0;0,0;0;0;0;0;1\n"), HasSubstr("with a decimal comma"));
    EXPECT_THAT(path_refusal("0 0 0 0 0 0 0 1\n60000000000 0 0 0 0 0 0 1"),
                HasSubstr("go from 0 to 60000000000, which cannot be seconds"));
    EXPECT_THAT(path_refusal("0 0 0 0 1 0 0 0\n1 0 0 0 0.8 0 0 0.6"),
                HasSubstr("qw stands before qx"));
    EXPECT_THAT(path_refusal("time,x,y,theta\n"), HasSubstr("found 4 fields; expected 8 numbers"));
    // A laser that hangs upside down turns about other axes.
    EXPECT_EQ(parse_trajectory("0 0 0 0 1 0 0 0\n1 0 0 0 0.8 0.6 0 0", "t").size(), 2U);
}

TEST(TrajectoryToText, HasFixedDecimalsAndTheShortestTime) {
    EXPECT_EQ(trajectory_to_text({{1234567890.125, {1.0, -2.5, 0.0}},
                                  {0.1, {-1e-12, 1.0 / 3.0, kPi}},
                                  {-0.0, {-0.0, 0.0, -kPi / 2.0}}}),
              "1234567890.125 1.000000000 -2.500000000 0 0 0 0.000000000 1.000000000\n"
              "0.1 0.000000000 0.333333333 0 0 0 1.000000000 0.000000000\n"
              "0 0.000000000 0.000000000 0 0 0 -0.707106781 0.707106781\n");
    EXPECT_EQ(trajectory_to_text({}), "");
    // Whole turns do not show.
    EXPECT_EQ(trajectory_to_text({{0.0, {0.0, 0.0, 1.5 * kPi}}}),
              trajectory_to_text({{0.0, {0.0, 0.0, -0.5 * kPi}}}));
}

TEST(TrajectoryToText, ReadsBackToANanometre) {
    std::mt19937_64 random(6);
    std::uniform_real_distribution<double> lengths(-1000.0, 1000.0);
    std::uniform_real_distribution<double> angles(-20.0, 20.0);
    Trajectory trajectory;
    for (int i = 0; i < 2000; ++i) {
        trajectory.push_back(
            {1e9 + lengths(random), {lengths(random), lengths(random), angles(random)}});
    }
    const Trajectory back = parse_trajectory(trajectory_to_text(trajectory), "t");
    ASSERT_EQ(back.size(), trajectory.size());
    for (std::size_t i = 0; i < back.size(); ++i) {
        EXPECT_EQ(back[i].time_s, trajectory[i].time_s);
        EXPECT_NEAR(back[i].pose.x, trajectory[i].pose.x, 0.51e-9);
        EXPECT_NEAR(back[i].pose.y, trajectory[i].pose.y, 0.51e-9);
        EXPECT_NEAR(wrap_angle(back[i].pose.theta - trajectory[i].pose.theta), 0.0, 2e-9);
    }
}

TEST(TrajectoryToText, RefusesPosesThatAreNotFinite) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(message_of<Error>([&] {
                  trajectory_to_text({{0.0, {}}, {1.0, {2.0, nan, 3.0}}});
              }),
              "pose 1 of the trajectory (t 1, x 2, y nan, theta 3) is not finite and cannot be "
              "written");
    EXPECT_THROW(trajectory_to_text({{HUGE_VAL, {}}}), Error);
    EXPECT_THROW(trajectory_to_text({{0.0, {0.0, 0.0, HUGE_VAL}}}), Error);
}

TEST(TrajectoryFiles, AreWrittenAndRead) {
    const TempFolder folder;
    const auto path = folder / "a.tum";
    const Trajectory trajectory = {{0.25, {1.0, 2.0, 0.0}}};
    write_trajectory(trajectory, path);
    EXPECT_EQ(test::content(path), trajectory_to_text(trajectory));
    EXPECT_EQ(read_trajectory(path), trajectory);
}

TEST(TrajectoryFiles, ErrorsNameTheFile) {
    const TempFolder folder;
    const auto missing = folder / "none.tum";
    EXPECT_EQ(message_of<FileError>([&] { read_trajectory(missing); }),
              missing.string() + ": no such file");
    EXPECT_THAT(message_of<FileError>([&] { read_trajectory(folder.path()); }),
                HasSubstr("is a directory"));
    const auto bad = folder.put("bad.tum", "1 2\n");
    EXPECT_THAT(message_of<FormatError>([&] { read_trajectory(bad); }),
                HasSubstr(bad.string() + ":1: found 2 fields"));
    EXPECT_THAT(message_of<FileError>([&] {
                    write_trajectory({{0.0, {}}}, bad / "x.tum");
                }),
                HasSubstr((bad / "x.tum").string()));
    EXPECT_THROW(write_trajectory({{HUGE_VAL, {}}}, bad), Error);
    EXPECT_EQ(test::content(bad), "1 2\n");
}

TEST(TrajectoryFiles, ReadsTheReferencesOfTheRealTours) {
    const auto folder = std::filesystem::path(HITOS_SHARED_DIR) / "data" / "radish";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no logs in " << folder;
    EXPECT_EQ(read_trajectory(folder / "intel.gt.tum.gz").size(), 910U);
    EXPECT_EQ(read_trajectory(folder / "aces.gt.tum.gz").size(), 440U);
    const StampedPose first = read_trajectory(folder / "intel.gt.tum.gz").front();
    EXPECT_EQ(first.time_s, 32.9068);
    EXPECT_NEAR(first.pose.theta, 2.0 * std::asin(-0.17640454), 1e-7);
}

}  // namespace
}  // namespace hitos
