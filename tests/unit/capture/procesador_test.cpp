// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/capture/procesador.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test_files.hpp"
#include "text_out.hpp"

namespace hitos {
namespace {

using test::expect_near;
using test::Log;
using test::read_text;
using test::TempDir;
using ::testing::HasSubstr;

std::string position(double time, double x, double v = 0.0) {
    return "position 0 " + std::to_string(time) + " " + std::to_string(x) + " 0 0 " +
           std::to_string(v) + " 0 0\n";
}

TEST(Procesador, SumOfTwistsReproducesRandomPoses) {
    std::mt19937_64 engine(11);
    std::uniform_real_distribution<double> step(-0.5, 0.5);
    std::uniform_real_distribution<double> turn(-kPi, kPi);
    std::vector<Pose> poses;
    std::string text;
    double time = 1.6e9;
    Pose pose{3, -4, 1};
    for (int i = 0; i < 5000; ++i) {
        text += "position 0";
        for (const double value : {time, pose.x, pose.y, pose.theta}) {
            text += ' ';
            append_exact(text, value);
        }
        text += " 0 0 0\n";
        poses.push_back(pose);
        // Stamps stand still, go back and jump; turns go up to half a circle, or are tiny.
        time += i % 7 == 0 ? -0.3 : i % 11 == 0 ? 0.0 : 0.1;
        const double theta = i % 5 == 0 ? turn(engine) : i % 3 == 0 ? 1e-7 : 0.0;
        pose = compose(pose, {step(engine), step(engine), theta});
    }
    const Log log = read_text("radish", text, {.mend = Mend::rays});
    ASSERT_EQ(log.odometry.size(), poses.size());
    const std::vector<Pose> sums = test::summed(log.odometry, poses.front());
    for (std::size_t i = 0; i < poses.size(); ++i) {
        expect_near(sums[i], poses[i], 1e-9, "reading " + std::to_string(i));
        if (i == 0) continue;
        ASSERT_GT(log.odometry[i].time_s, log.odometry[i - 1].time_s);
    }
    EXPECT_GT(log.report.stamps_backwards, 700U);
}

TEST(Procesador, RepeatedReadingIsDroppedSilently) {
    const Log log = read_text("radish", position(1, 0) + position(1, 0) + position(2, 1));
    EXPECT_EQ(log.odometry.size(), 2U);
    EXPECT_EQ(log.report.odometry, 2U);
    EXPECT_EQ(log.report.stamps_backwards, 0U);
    EXPECT_EQ(log.report.skipped, 0U);
}

TEST(Procesador, StampsThatDoNotAdvanceArePutAMillisecondLater) {
    const Log log = read_text("radish", position(1, 0) + position(1, 1) + position(0.5, 2) +
                                            position(0.5, 2) + position(1.5, 3));
    ASSERT_EQ(log.odometry.size(), 4U);
    EXPECT_EQ(log.odometry[1].time_s, 1.0 + 1e-3);
    EXPECT_EQ(log.odometry[2].time_s, 1.0 + 1e-3 + 1e-3);
    EXPECT_EQ(log.odometry[3].time_s, 1.5);
    EXPECT_EQ(log.report.stamps_backwards, 2U);
    EXPECT_NEAR(test::summed(log.odometry).back().x, 3.0, 1e-12);
}

/// A recording that was played twice is whole, and its map is none.
TEST(Procesador, AClockThatGoesBackIsTold) {
    const auto played = [](int seconds) {
        std::string text;
        for (int i = 0; i < seconds; ++i) text += position(100 + i, i);
        return text;
    };
    const Log twice = read_text("radish", played(20) + played(20));
    ASSERT_FALSE(twice.findings.empty());  // where it begins anew the odometry leaps, too
    EXPECT_EQ(twice.findings[0].kind, TourFinding::Kind::clock_back);
    EXPECT_EQ(word_of(twice.findings[0].kind), "clock-back");
    EXPECT_NEAR(twice.findings[0].value, 19.0, 1e-9);
    EXPECT_THAT(twice.findings[0].what.english(), HasSubstr("at 119.0 s by 19.0 s"));
    EXPECT_THAT(twice.findings[0].what.english(), HasSubstr("(line 21)"));
    EXPECT_TRUE(read_text("radish", played(20)).findings.empty());
    const std::string late = played(20) + position(118, 20) + position(120, 21);
    EXPECT_TRUE(read_text("radish", late).findings.empty());  // out of order
    const std::string broken = played(20) + position(0, 20) + position(121, 21) + position(122, 22);
    EXPECT_TRUE(read_text("radish", broken).findings.empty());
    EXPECT_EQ(read_text("radish", broken).report.skipped, 1U);
    EXPECT_NEAR(test::summed(read_text("radish", broken).odometry).back().x, 22.0, 1e-12);
    // Of scans alone, and of what is added to their times.
    std::string set;
    for (int i = 0; i < 40; ++i) {
        const std::string time = std::to_string(i < 20 ? 100 + i : 90 + i);
        set += "ODOM " + std::to_string(100 + i) + " " + std::to_string(i) + " 0 0\n";
        set += "LASER " + time + " 2 1 0 1 1." + std::to_string(i) + "\n";
    }
    const auto back = [&](const ReadOptions& options) {
        const Log log = read_text("normalized", set, options);
        return std::ranges::count(log.findings, TourFinding::Kind::clock_back, &TourFinding::kind);
    };
    ReadOptions options;
    EXPECT_EQ(back(options), 1);
    options.scan_clock = "0@0,0@19.5,10@19.5";
    EXPECT_EQ(back(options), 0);
}

/// Poses of a robot that drives a metre ahead a second; from `reset` on they begin anew at zero.
std::string poses(int count, int reset, double scale = 1.0) {
    std::string text;
    for (int i = 0; i < count; ++i) {
        text += position(i, scale * (i < reset ? i : i - reset));
    }
    return text;
}

TEST(Procesador, VelocitiesInsteadOfPoses) {
    const std::string text = position(1, 0, 9) + position(2, 1, 0.5) + position(2, 1, 0.5) +
                             position(1.5, 1, 0.7) + position(3, 2, 0.25);
    const Log log = read_text("radish", text, {.odometry = OdometryFrom::velocities});
    ASSERT_EQ(log.odometry.size(), 3U);
    EXPECT_EQ(log.odometry[0].twist, Twist{});
    EXPECT_EQ(log.odometry[1].twist, (Twist{0.5, 0, 0}));
    EXPECT_EQ(log.odometry[2].twist, (Twist{0.25, 0, 0}));
    EXPECT_EQ(log.report.stamps_backwards, 1U);
    // CARMEN's FLASER has no velocities: the next ODOM holds for the whole time.
    const Log carmen = read_text("carmen",
                                 "ODOM 0 0 0 0 0 0 1 h 1\nFLASER 1 1 0 0 0 1 0 0 1.5 h 1\n"
                                 "ODOM 2 0 0 3 0 0 2 h 2\n",
                                 {.odometry = OdometryFrom::velocities});
    ASSERT_EQ(carmen.odometry.size(), 2U);
    EXPECT_EQ(carmen.odometry[1].twist, (Twist{3, 0, 0}));
    EXPECT_TRUE(carmen.findings.empty()) << carmen.findings[0].what.english();
    // Where no line has any, nothing of the odometry is left; that is told, with the way back.
    const Log bare = read_text("carmen", "FLASER 1 1 0 0 0 1 0 0 1.5 h 1\n",
                               {.odometry = OdometryFrom::velocities});
    EXPECT_TRUE(bare.odometry.empty());
    ASSERT_EQ(bare.findings.size(), 1U);
    EXPECT_EQ(bare.findings[0].kind, TourFinding::Kind::no_odometry);
    ASSERT_EQ(bare.findings[0].remedies.size(), 1U);
    // And where they are logged as 0 while the poses move, as by many drivers.
    const Log still = read_text("radish", poses(5, 5), {.odometry = OdometryFrom::velocities});
    ASSERT_EQ(still.findings.size(), 1U);
    EXPECT_EQ(still.findings[0].kind, TourFinding::Kind::still_odometry);
    EXPECT_THAT(options_of(still.findings[0].remedies[0].settings), HasSubstr("odometry=poses"));
    EXPECT_TRUE(read_text("radish", poses(5, 5)).findings.empty());
}

TEST(Procesador, ALeapOfTheOdometryIsBridgedAndTold) {
    const Log log = read_text("radish", poses(40, 20));
    EXPECT_NEAR(test::summed(log.odometry).back().x, 39.0, 1e-9);
    ASSERT_EQ(log.findings.size(), 1U);
    EXPECT_EQ(log.findings.front().kind, TourFinding::Kind::leaping_odometry);
    EXPECT_EQ(log.findings.front().value, 19.0);
    EXPECT_THAT(log.findings.front().what.english(), HasSubstr("19 m (line 21)"));
    // As it is logged where nothing is to be mended.
    const Log raw = read_text("radish", poses(40, 20), {.mend = Mend::rays});
    EXPECT_NEAR(test::summed(raw.odometry).back().x, 19.0, 1e-9);
    EXPECT_TRUE(raw.findings.empty());
    // Where every step is one, as of millimetres, units are wrong, which is told elsewhere.
    const Log units = read_text("radish", poses(40, 100, 1000.0));
    EXPECT_NEAR(test::summed(units.odometry).back().x, 38000.0, 1e-6);
    EXPECT_TRUE(units.findings.empty());
    EXPECT_TRUE(read_text("radish", poses(40, 100)).findings.empty());
}

TEST(Procesador, ASinglePoseThatIsWrongIsPassedOver) {
    std::string text;
    for (int i = 0; i < 40; ++i) text += position(0.2 * i, i % 10 == 5 ? 40.0 : 0.1 * i);
    const Log log = read_text("radish", text);
    const std::vector<Pose> sums = test::summed(log.odometry);
    ASSERT_EQ(sums.size(), 40U);
    for (int i = 0; i < 40; ++i) {
        EXPECT_NEAR(sums[static_cast<std::size_t>(i)].x, 0.1 * i, 1e-9) << i;
    }
    ASSERT_EQ(log.findings.size(), 1U);
    EXPECT_EQ(log.findings.front().kind, TourFinding::Kind::leaping_odometry);
}

TEST(Procesador, AHeadingThatJumpsIsALeapAndAPauseIsNotDrivenThrough) {
    std::string text;
    for (int i = 0; i < 40; ++i) {
        const double turned = i < 20 ? 0.0 : 2.5;
        text +=
            "position 0 " + std::to_string(0.2 * i) + " " +
            std::to_string(0.1 * std::min(i, 19) + 0.1 * std::cos(turned) * std::max(i - 19, 0)) +
            " " + std::to_string(0.1 * std::sin(turned) * std::max(i - 19, 0)) + " " +
            std::to_string(turned) + " 0 0 0\n";
    }
    expect_near(test::summed(read_text("radish", text).odometry).back(), {3.9, 0.0, 0.0}, 2e-5);
    // Nobody knows what was driven in a minute without odometry: no more than a second of it.
    text.clear();
    for (int i = 0; i < 40; ++i) {
        text += position(i < 20 ? i : i + 60, i < 20 ? 10.0 + 0.5 * i : 0.5 * (i - 20));
    }
    EXPECT_NEAR(test::summed(read_text("radish", text).odometry).back().x, 9.5 + 0.5 + 9.5, 0.02);
}

TEST(Procesador, VelocitiesThatMoveWithoutPosesAreTold) {
    std::string text;
    for (int i = 0; i < 5; ++i) text += position(i, 0, 0.5);
    const Log log = read_text("radish", text);
    ASSERT_EQ(log.findings.size(), 1U);
    EXPECT_EQ(log.findings.front().kind, TourFinding::Kind::still_odometry);
    EXPECT_THAT(advice_of(log.findings.front()).english(), HasSubstr("source.odometry=velocities"));
    EXPECT_TRUE(read_text("radish", text, {.odometry = OdometryFrom::velocities}).findings.empty());
}

TEST(Procesador, TheOdometrysWayIsScaled) {
    const Log log = read_text("radish", poses(3, 9), {.odometry_scale = 1.5});
    EXPECT_NEAR(test::summed(log.odometry).back().x, 3.0, 1e-12);
}

TEST(Procesador, RangesAndAnglesAreScaled) {
    const std::string text =
        "ROBOTLASER1 0 -1.0 2.0 1.0 8 0 0 3 1 2 8 0 0 0 0 0 0 0 0 0 0 0 0 1 host 1\n";
    const Log plain = read_text("carmen", text);
    const Log log = read_text("carmen", text, {.range_scale = 0.5, .fan_scale = 0.25});
    ASSERT_EQ(plain.scans.at(0).points.size(), 2U);
    ASSERT_EQ(log.scans.at(0).points.size(), 2U);  // 8 m of 8 is none, and so are 4 of 4
    EXPECT_NEAR(log.scans[0].fan.max_range_m, 4.0, 1e-12);
    test::expect_near(log.scans[0].points[0], {0.5 * std::cos(0.25), -0.5 * std::sin(0.25)}, 1e-12);
    test::expect_near(log.scans[0].points[1], {1.0, 0.0}, 1e-12);
    const Log points = read_text("normalized", "LASER 0 1 3 4\nODOM 0 0 0\n", {.range_scale = 0.1});
    test::expect_near(points.scans.at(0).points.at(0), {0.3, 0.4}, 1e-12);
}

TEST(Procesador, AnglesInDegreesAreRefusedUnlessTheyAreSaidToBe) {
    const std::string text =
        "ROBOTLASER1 0 -90 180 90 8 0 0 3 1 2 3 0 0 0 0 0 0 0 0 0 0 0 0 1 host 1\n";
    const Log log = read_text("carmen", text);
    EXPECT_TRUE(log.scans.empty());
    ASSERT_EQ(log.report.examples.size(), 1U);
    EXPECT_THAT(log.report.examples[0].reason.english(),
                HasSubstr("in degrees and not in radians: --set source.fan_scale=0.0174"));
    const Log said = read_text("carmen", text, {.fan_scale = kRadiansPerDegree});
    ASSERT_EQ(said.scans.size(), 1U);
    test::expect_near(said.scans[0].points.at(0), {0.0, -1.0}, 1e-12);
}

TEST(Procesador, TheLaserSitsWhereTheOptionsSay) {
    const std::string text = "laser 0 2 1 0 0 2 0.1 0 3 1.0 0\n";
    const Log log = read_text("radish", text, {.laser_pose = "0.5, 0.25, 90"});
    const Log turned = read_text("radish", text, {.laser_pose = "0.5,0.25,90,upside-down"});
    const Log plain = read_text("radish", text);
    const Pose mount{0.5, 0.25, kPi / 2.0};
    ASSERT_FALSE(plain.scans.at(0).points.empty());
    test::expect_near(log.scans.at(0).fan.pose_robot_laser, mount, 1e-12);
    EXPECT_FALSE(log.scans.at(0).fan.upside_down);
    EXPECT_TRUE(turned.scans.at(0).fan.upside_down);
    for (std::size_t i = 0; i < plain.scans[0].points.size(); ++i) {
        const Point2 seen =
            transform(inverse(plain.scans[0].fan.pose_robot_laser), plain.scans[0].points[i]);
        test::expect_near(log.scans[0].points[i], transform(mount, seen), 1e-12);
        test::expect_near(turned.scans[0].points[i], transform(mount, {seen.x, -seen.y}), 1e-12);
    }
    for (const char* wrong :
         {"1,2", "a,b,c", "1,2,3,4", "1,2,3,upsidedown", "1e9,0,0", "nan,0,0"}) {
        EXPECT_THAT(test::message_of<ConfigError>(
                        [&] { read_text("radish", text, {.laser_pose = wrong}); }),
                    HasSubstr("source.laser_pose: found \"" + std::string(wrong)))
            << wrong;
    }
}

TEST(Procesador, NearReadingsAreNoPoints) {
    const std::string text = "laser 0 1 1 0 0 0.3 0.1 0\n";
    EXPECT_EQ(read_text("radish", text).scans.at(0).points.size(), 2U);
    EXPECT_EQ(read_text("radish", text, {.min_range_m = 0.35}).scans.at(0).points.size(), 1U);
}

TEST(Procesador, DuplicateScansAreOne) {
    const std::string a = "laser 0 1 1 0 0 2 0.1 0\n";
    const std::string same_time = "laser 0 1 1 0 0 2.5 0.1 0\n";
    const std::string same_ranges = "laser 0 2 1 0 0 2.5 0.1 0\n";
    const Log log = read_text("radish", a + position(1, 0) + a + a + same_time + same_ranges + a);
    EXPECT_EQ(log.scans.size(), 4U);
    EXPECT_EQ(log.report.scans, 4U);
    EXPECT_EQ(log.report.duplicate_scans, 2U);
}

/// Two scans, the second one twice, before the first reading; two from it on.
std::string late_odometry() {
    return "laser 0 1 1 0 0\nlaser 0 2 2 0 0\nlaser 0 2 2 0 0\n" + position(3, 0) +
           "laser 0 3 3 0 0\nlaser 0 4 4 0 0\n" + position(5, 1);
}

TEST(Procesador, ScansBeforeTheOdometryAreKeptAndCounted) {
    const Log log = read_text("radish", late_odometry());
    EXPECT_EQ(log.scans.size(), 4U);
    EXPECT_EQ(log.report.early_scans, 2U);
    EXPECT_EQ(log.report.early_scans_left_out, 0U);
    EXPECT_EQ(log.report.duplicate_scans, 1U);
    EXPECT_EQ(log.report.odometry, 2U);
    EXPECT_EQ(read_text("radish", position(1, 0) + late_odometry()).report.early_scans, 0U);
}

TEST(Procesador, ScansBeforeTheOdometryAreLeftOutWhereAskedFor) {
    ReadOptions options;
    options.leave_out_early_scans = true;
    const TempDir folder;
    const auto path = folder.put("a.log", late_odometry());
    Procesador procesador(open_log(path), options);
    for (int round = 0; round < 2; ++round) {
        const std::unique_ptr<TourReader> again = procesador.reopen();
        for (const Log& log : {test::read_all(procesador), test::read_all(*again)}) {
            ASSERT_EQ(log.scans.size(), 2U);
            EXPECT_EQ(log.scans.front().time_s, 3.0);
            EXPECT_EQ(log.report.scans, 2U);
            EXPECT_EQ(log.report.early_scans, 0U);
            EXPECT_EQ(log.report.early_scans_left_out, 2U);
            EXPECT_EQ(log.report.duplicate_scans, 1U);
        }
        procesador.restart();
    }
}

// A damaged first reading is none; it counts once, where the odometry is read.
TEST(Procesador, NothingIsBeforeAnOdometryThatIsNotThere) {
    ReadOptions options;
    options.leave_out_early_scans = true;
    const std::string scans = "laser 0 1 1 0 0\nlaser 0 2 2 0 0\n";
    const Log none = read_text("radish", scans, options);
    EXPECT_EQ(none.scans.size(), 2U);
    EXPECT_EQ(none.report.early_scans + none.report.early_scans_left_out, 0U);
    const Log damaged = read_text("radish", "position 0 0 x\n" + scans + position(2, 0), options);
    EXPECT_EQ(damaged.scans.size(), 1U);
    EXPECT_EQ(damaged.report.skipped, 1U);
    // A line that is a scan and its reading is not before it, whatever the stamps.
    const Log both = read_text(
        "carmen", "FLASER 1 1 0 0 0 0 0 0 2 h 1\nFLASER 1 2 0 0 0 1 0 0 1 h 1\n", options);
    EXPECT_EQ(both.scans.size(), 2U);
}

TEST(Procesador, DamageIsCountedOnceWhateverTheOrderOfReading) {
    const TempDir folder;
    const std::string text = position(1, 0) + "?\nlaser 0 1 1 0\nposition 0 x\n" +
                             std::string(2U << 20U, 'z') + "\nlaser 0 1 1 0 0\n" +
                             std::string("\0\n", 2) + position(2, 1);
    const auto path = folder.put("d.log", text);
    for (const bool scans_first : {true, false}) {
        Procesador procesador(open_log(path));
        const auto scans = [&] {
            while (procesador.next_scan()) {
            }
        };
        const auto odometry = [&] {
            while (procesador.next_odometry()) {
            }
        };
        if (scans_first) scans();
        odometry();
        if (!scans_first) scans();
        const ReadReport& report = procesador.report();
        EXPECT_EQ(report.skipped, 5U);
        ASSERT_EQ(report.examples.size(), 5U);
        const std::vector<std::uint64_t> expected = {2, 3, 4, 5, 7};
        for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(report.examples[i].line, expected[i]);
        EXPECT_EQ(report.scans, 1U);
        EXPECT_EQ(report.odometry, 2U);
    }
}

TEST(Procesador, KeepsOnlyTheFirstExamples) {
    std::string text = position(1, 0);
    for (int i = 0; i < 100; ++i) text += i % 2 == 0 ? "position 0 x\n" : "laser 0 1 1\n";
    const Log log = read_text("radish", text);
    EXPECT_EQ(log.report.skipped, 100U);
    ASSERT_EQ(log.report.examples.size(), ReadReport::kExamples);
    for (std::size_t i = 0; i < ReadReport::kExamples; ++i) {
        EXPECT_EQ(log.report.examples[i].line, i + 2);
    }
}

TEST(Procesador, TruncatedGzipGivesWhatCanBeReadAndCountsOnce) {
    const TempDir folder;
    std::string text;
    for (int i = 0; i < 20000; ++i) text += position(i, i * 0.37);
    const std::string packed = test::content(folder.put_gz("a", text));
    const Log log = test::read_log(folder.put("cut.gz", packed.substr(0, packed.size() / 2)));
    EXPECT_GT(log.odometry.size(), 5000U);
    EXPECT_LT(log.odometry.size(), 15000U);
    ASSERT_EQ(log.report.skipped, 1U);
    EXPECT_EQ(log.report.examples[0].line, log.odometry.size() + 1);
    EXPECT_THAT(log.report.examples[0].reason.english(), HasSubstr("end early"));
}

TEST(Procesador, RestartBeginsAnew) {
    const TempDir folder;
    Procesador procesador(
        open_log(folder.put("a", position(1, 0) + "?\nlaser 0 1 1 0 0\n" + position(2, 1))));
    const Log first = test::read_all(procesador);
    procesador.restart();
    EXPECT_EQ(procesador.report().skipped, 0U);
    const Log second = test::read_all(procesador);
    EXPECT_EQ(first.scans.size(), second.scans.size());
    EXPECT_EQ(first.odometry.size(), second.odometry.size());
    EXPECT_EQ(second.odometry.at(1).twist, first.odometry.at(1).twist);
    EXPECT_EQ(second.report.skipped, 1U);
}

}  // namespace
}  // namespace hitos
