// SPDX-License-Identifier: GPL-3.0-or-later
// From the messages of a recording to scans and odometry.
#include <gmock/gmock.h>

#include <limits>

#include "unit/capture/ros_packings.hpp"
#include "unit/capture/ros_tours.hpp"
#include "unit/capture/test_files.hpp"

namespace hitos {
namespace {

using test::at_ns;
using test::Bytes;
using test::LaserFields;
using test::Link;
using test::Log;
using test::Placing;
using test::Said;
using test::Stamp;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

Bytes cdr() {
    return Bytes::cdr();
}

class RosTour : public ::testing::Test {
  protected:
    Log read(const std::vector<Said>& all, const ReadOptions& options = ReadOptions()) const {
        const auto file = folder_.put("a.mcap", test::mcap_of(all));
        Procesador reader(open_log(file, kAutoFormat, options), options);
        return test::read_all(reader);
    }
    template <class Kind>
    std::string refusal(const std::vector<Said>& all,
                        const ReadOptions& options = ReadOptions()) const {
        return test::message_of<Kind>([&] { read(all, options); });
    }
    test::TempDir folder_;
};

ReadOptions topics(const std::string& scan, const std::string& odometry = "") {
    ReadOptions options;
    options.scan_topic = scan;
    options.odom_topic = odometry;
    return options;
}

void expect_same(const Log& a, const Log& b) {
    EXPECT_EQ(a.scans, b.scans);
    EXPECT_EQ(a.odometry, b.odometry);
}

TEST_F(RosTour, IsTheSameFromEveryContainer) {
    const Log expected = read(test::small_tour(cdr()));
    ASSERT_EQ(expected.scans.size(), 5U);
    ASSERT_EQ(expected.odometry.size(), 5U);
    EXPECT_EQ(expected.report.skipped, 0U);
    const Scan& third = expected.scans[2];
    EXPECT_EQ(third.time_s, 1'700'000'002.25);
    ASSERT_EQ(third.points.size(), 3U);
    EXPECT_EQ(third.points[1], (Point2{0.25 + 4.0, 0.0}));
    EXPECT_EQ(third.fan.count, 3U);
    EXPECT_EQ(third.fan.max_range_m, 8.0);
    EXPECT_EQ(third.fan.pose_robot_laser, (Pose{0.25, 0.0, 0.0}));
    for (const Pose& pose : test::summed(expected.odometry)) EXPECT_EQ(pose.theta, 0.0);
    EXPECT_NEAR(test::summed(expected.odometry).back().x, 0.4, 1e-12);

    const std::string bag =
        test::bag_of(test::small_tour(Bytes::ros1()), {"lz4", test::packed_lz4});
    expect_same(test::read_log(folder_.put("a.bag", bag)), expected);
    expect_same(test::read_log(folder_.put("a.bag", bag), "rosbag"), expected);
    write_db3(folder_ / "a.db3", test::small_tour(Bytes::cdr(true)));
    expect_same(test::read_log(folder_ / "a.db3"), expected);
    const auto folder = folder_ / "folder";
    std::filesystem::create_directory(folder);
    std::filesystem::rename(folder_ / "a.db3", folder / "a_0.db3");
    expect_same(test::read_log(folder), expected);
    test::McapLayout layout;
    layout.encoding = "ros1";
    expect_same(test::read_log(
                    folder_.put("b.mcap", test::mcap_of(test::small_tour(Bytes::ros1()), layout))),
                expected);
}

TEST_F(RosTour, LoggedVelocitiesAreTheTwistsOfTheMessages) {
    ReadOptions options;
    options.odometry = OdometryFrom::velocities;
    const Log log = read(test::small_tour(cdr()), options);
    ASSERT_EQ(log.odometry.size(), 5U);
    EXPECT_EQ(log.odometry.back().twist, (Twist{0.5, 0.0, 0.25}));
}

TEST_F(RosTour, IsInTheOrderOfStampsAndReadsTwiceAlike) {
    std::vector<Said> all = test::small_tour(cdr(), 20);
    const Log expected = read(all);
    // Bundles of five scans, the last first; odometry in pairs, too.
    for (std::size_t i = 1; i + 10 < all.size(); i += 10) {
        std::reverse(all.begin() + static_cast<std::ptrdiff_t>(i),
                     all.begin() + static_cast<std::ptrdiff_t>(i + 10));
    }
    const auto file = folder_.put("a.mcap", test::mcap_of(all));
    Procesador reader(open_log(file));
    for (int round = 0; round < 2; ++round) {
        const Log log = test::read_all(reader);
        ASSERT_EQ(log.scans.size(), 20U);
        for (std::size_t i = 0; i < 20; ++i) {
            EXPECT_EQ(log.scans[i].points, expected.scans[i].points);
            EXPECT_EQ(log.odometry[i].time_s, expected.odometry[i].time_s);
        }
        EXPECT_EQ(log.report.stamps_backwards, 0U);
        reader.restart();
    }
}

/// Of stamps that a driver left empty, or that are of another clock, and of what is played twice.
TEST_F(RosTour, BrokenStampsAreLeftOutAndWhatIsPlayedAgainComesInItsOrder) {
    constexpr std::uint32_t kScans = 300;
    const std::vector<Said> sound = test::small_tour(cdr(), kScans);
    const auto with_stamps = [&](auto stamp_of) {
        std::vector<Said> all = {sound.front()};
        for (std::uint32_t i = 0; i < kScans; ++i) {
            const Stamp stamp = stamp_of(i);
            Said odometry = test::said_odometry(stamp, {0.1 * i, 0.0}, cdr());
            LaserFields laser;
            laser.stamp = stamp;
            laser.ranges = {1.0F + static_cast<float>(i), 2.0F, 3.0F};
            Said scan = test::said_laser(laser, cdr());
            odometry.log_time_ns = scan.log_time_ns = test::at_ns({1'700'000'000 + i, 0});
            all.push_back(std::move(odometry));
            all.push_back(std::move(scan));
        }
        return read(all);
    };
    const Log tenth = with_stamps([](std::uint32_t i) {
        return i % 10 == 3 ? Stamp{0, 0} : Stamp{1'700'000'000 + i, 0};
    });
    EXPECT_EQ(tenth.scans.size(), 270U);
    EXPECT_EQ(tenth.odometry.size(), 270U);
    EXPECT_EQ(tenth.report.skipped, 60U);
    ASSERT_EQ(tenth.findings.size(), 1U);
    EXPECT_EQ(tenth.findings[0].kind, TourFinding::Kind::broken_stamps);
    EXPECT_NEAR(tenth.findings[0].value, 0.1, 1e-9);
    EXPECT_NEAR(test::summed(tenth.odometry).back().x, 0.1 * (kScans - 1), 1e-9);
    const Log ahead = with_stamps([](std::uint32_t i) {
        return i == 100 || i == kScans - 1 ? Stamp{4'000'000'000, 0} : Stamp{1'700'000'000 + i, 0};
    });
    EXPECT_EQ(ahead.scans.size(), kScans - 2);
    EXPECT_EQ(ahead.report.skipped, 4U);
    EXPECT_TRUE(ahead.findings.empty());
    const Log twice = with_stamps([](std::uint32_t i) {
        return Stamp{1'700'000'000 + i % (kScans / 2), 0};
    });
    EXPECT_EQ(twice.scans.size(), kScans);
    EXPECT_EQ(twice.report.duplicate_scans, 0U);
    EXPECT_EQ(twice.report.skipped, 0U);
    EXPECT_EQ(std::ranges::count(twice.findings, TourFinding::Kind::clock_back, &TourFinding::kind),
              1);
    for (std::uint32_t i = 1; i < kScans; ++i) {
        EXPECT_TRUE(i == kScans / 2 || twice.scans[i].time_s > twice.scans[i - 1].time_s) << i;
    }
}

// A minute behind all others, of each sequence the last.
TEST_F(RosTour, WhatIsTooLateIsLeftOut) {
    std::vector<Said> all = test::small_tour(cdr(), 700);
    std::rotate(all.begin() + 1, all.begin() + 3, all.end());
    const Log log = read(all);
    EXPECT_EQ(log.scans.size(), 699U);
    EXPECT_EQ(log.odometry.size(), 699U);
    EXPECT_EQ(log.report.skipped, 2U);
    EXPECT_EQ(log.report.stamps_backwards, 0U);
}

TEST_F(RosTour, ReadingsThatAreNoneEndARun) {
    constexpr float kInf = std::numeric_limits<float>::infinity();
    LaserFields laser;
    laser.step = -0.25;  // clockwise
    laser.min_angle = 1.0;
    laser.ranges = {1.0F, 0.01F, std::nanf(""), 2.0F, kInf, 8.0F, -kInf, 3.0F, 9.0F};
    const Log log = read({test::said_laser(laser, cdr())});
    ASSERT_EQ(log.scans.size(), 1U);
    const Scan& scan = log.scans.front();
    EXPECT_EQ(scan.fan.min_angle_rad, -1.0);
    EXPECT_EQ(scan.fan.max_angle_rad, 1.0);
    EXPECT_THAT(scan.rays, testing::ElementsAre(1, 5, 8));
    EXPECT_EQ(scan.run_starts.size(), 3U);
    EXPECT_NEAR(scan.points.front().x, 3.0 * std::cos(-0.75), 1e-12);
    EXPECT_NEAR(scan.points.front().y, 3.0 * std::sin(-0.75), 1e-12);
    EXPECT_NEAR(scan.points.back().y, std::sin(1.0), 1e-12);
}

// map -> odom -> base_footprint -> base_link -> laser, upside down, and told after the first scan.
TEST_F(RosTour, TheMountingFollowsTheTransforms) {
    std::vector<Said> all;
    LaserFields laser;
    laser.frame = "/rear";
    laser.stamp = {10, 0};
    all.push_back(said_laser(laser, cdr()));
    all.push_back(test::said_transforms({{{10, 0}, "odom", "base_footprint", {5.0, 5.0}},
                                         {{10, 0}, "map", "odom", {7.0, 7.0}},
                                         {{10, 0}, "base_link", "wheel", {7.0, 7.0}}},
                                        cdr()));
    all.push_back(test::said_transforms(
        {{{0, 0}, "base_footprint", "base_link", {0.0, 0.0, 0.1, 0.0, kPi / 2.0}},
         {{0, 0}, "base_link", "rear", {0.5, 0.25, 0.2, kPi, kPi / 4.0}}},
        cdr(), "/tf_static"));
    all.push_back({"/odom", test::kOdometryMessageType,
                   odometry_message({10, 0}, {5.0, 5.0}, 0.0, 0.0, cdr(), "base_footprint"), 1});
    const Log log = read(all);
    EXPECT_EQ(log.report.skipped, 0U);
    ASSERT_EQ(log.scans.size(), 1U);
    test::expect_near(log.scans.front().fan.pose_robot_laser, {-0.25, 0.5, 0.75 * kPi}, 1e-12);
    EXPECT_TRUE(log.scans.front().fan.upside_down);
    // The ray at -0.5 rad of a laser upside down points to +0.5.
    test::expect_near(log.scans.front().points.back(),
                      {-0.25 + std::cos(0.75 * kPi + 0.5), 0.5 + std::sin(0.75 * kPi + 0.5)}, 1e-7);
}

TEST_F(RosTour, TransformsAreTheOdometryWhereThereIsNoTopic) {
    const std::vector<Said> all = test::small_tour(cdr());
    std::vector<Said> moved;
    for (const Said& said : all) {
        if (said.topic != "/odom") moved.push_back(said);
    }
    for (std::uint32_t i = 0; i < 5; ++i) {
        const Stamp stamp{1'700'000'000 + i, 250'000'000};
        moved.push_back(test::said_transforms({{stamp, "robot/odom", "base_link", {0.1 * i, 0.0}},
                                               {stamp, "map", "robot/odom", {9.0 * i, 9.0}}},
                                              cdr()));
    }
    const Log log = read(moved);
    const Log expected = read(all);
    EXPECT_EQ(log.scans.size(), 5U);
    ASSERT_EQ(log.odometry.size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(log.odometry[i].time_s, expected.odometry[i].time_s);
        EXPECT_EQ(log.odometry[i].twist, expected.odometry[i].twist);
    }
    moved.insert(moved.end(), all.begin(), all.end());
    EXPECT_EQ(read(moved, topics("", "tf")).odometry.size(), 5U);
    EXPECT_THAT(refusal<ConfigError>(all, topics("", "tf")), HasSubstr("no transform in"));
}

/// Two lasers in one place, of which one looks to the right and the other, upside down, to the
/// left.
std::vector<Said> two_lasers(double apart = 0.0) {
    std::vector<Said> all{
        test::said_transforms({{{1, 0}, "base_link", "right", {0.5, 0.0, 0.1, 0.0, -0.5}},
                               {{1, 0}, "base_link", "left", {0.5 + apart, 0.0, 0.2, kPi, 0.5}}},
                              cdr(), "/tf_static")};
    for (std::uint32_t i = 1; i <= 3; ++i) {
        LaserFields right{{i, 0}, "right", -0.5, 0.5, 0.05, 8.0, {1.0F, 2.0F, 3.0F}};
        LaserFields left{{i, 0}, "left", -0.5, 0.5, 0.05, 8.0, {6.0F, 5.0F, 4.0F}};
        for (float& range : right.ranges) range += 0.001F * static_cast<float>(i);
        all.push_back(test::said_laser(right, cdr(), "/right"));
        if (i != 2) all.push_back(test::said_laser(left, cdr(), "/left"));
    }
    return all;
}

TEST_F(RosTour, OneOfSeveralLasersIsChosen) {
    const std::vector<Said> all = two_lasers();
    EXPECT_THAT(refusal<ConfigError>(all),
                AllOf(HasSubstr("source.scan_topic: found 2 laser topics"),
                      HasSubstr("/right (3), /left (2)"), HasSubstr("--scan-topic")));
    EXPECT_THAT(refusal<ConfigError>(all, topics("/front")), HasSubstr("found \"/front\""));
    EXPECT_THAT(refusal<ConfigError>(all, topics("/right, /front")), HasSubstr("\"/front\""));
    EXPECT_EQ(read(all, topics("/right")).scans.size(), 3U);
    EXPECT_EQ(read(all, topics("left")).scans.size(), 2U);
    EXPECT_EQ(read(all, topics("left")).scans.front().points.size(), 3U);
}

TEST_F(RosTour, LasersOfOnePlaceAreOneSensor) {
    for (const char* chosen : {"all", "/right,/left"}) {
        const Log log = read(two_lasers(), topics(chosen));
        ASSERT_EQ(log.scans.size(), 3U);
        const Scan& both = log.scans.front();
        // Right: -1, -0.5, 0; left, turned over: 1, 0.5, 0. Of two readings on one ray the nearer.
        EXPECT_EQ(both.fan.count, 5U);
        EXPECT_NEAR(both.fan.angle_rad(0) + both.fan.pose_robot_laser.theta, -1.0, 1e-7);
        EXPECT_NEAR(both.fan.angle_rad(4) + both.fan.pose_robot_laser.theta, 1.0, 1e-7);
        ASSERT_EQ(both.points.size(), 5U);
        EXPECT_EQ(both.run_starts.size(), 1U);
        test::expect_near(both.points[2], {0.5 + 3.001, 0.0}, 1e-6);
        test::expect_near(both.points[4], {0.5 + 6.0 * std::cos(1.0), 6.0 * std::sin(1.0)}, 1e-6);
        EXPECT_EQ(log.scans[1].points.size(), 3U);  // alone
    }
}

TEST_F(RosTour, LasersOfTwoPlacesGiveScansOfTheirOwn) {
    const Log log = read(two_lasers(0.1), topics("all"));
    ASSERT_EQ(log.scans.size(), 5U);
    EXPECT_EQ(log.scans[0].fan.pose_robot_laser.x, 0.5);
    EXPECT_EQ(log.scans[1].fan.pose_robot_laser.x, 0.6);
    EXPECT_EQ(log.scans[0].time_s, log.scans[1].time_s);
}

TEST_F(RosTour, OneOfSeveralOdometriesIsChosen) {
    std::vector<Said> all = test::small_tour(cdr());
    all.push_back(test::said_odometry({1'700'000'000, 0}, {}, cdr(), "/filtered"));
    EXPECT_THAT(refusal<ConfigError>(all),
                AllOf(HasSubstr("source.odom_topic: found 2 odometry topics"),
                      HasSubstr("/odom (5), /filtered (1)"), HasSubstr("--odom-topic")));
    EXPECT_EQ(read(all, topics("", "/odom")).odometry.size(), 5U);
    EXPECT_EQ(read(all, topics("", "filtered")).odometry.size(), 1U);
}

TEST_F(RosTour, WithoutLaserItSaysWhatThereIs) {
    EXPECT_THAT(
        refusal<FormatError>({test::said_odometry({1, 0}, {}, cdr()), {"/events", "", "{}", 0}}),
        AllOf(HasSubstr("holds no laser scans"),
              HasSubstr("/odom (nav_msgs/Odometry, 1), /events (1)")));
    EXPECT_THAT(refusal<FormatError>({}), HasSubstr("holds no laser scans"));
}

TEST_F(RosTour, DamagedMessagesAreCountedAndTold) {
    std::vector<Said> all = test::small_tour(cdr());
    all[2].bytes.resize(50);   // a scan
    all[3].bytes.resize(100);  // odometry
    LaserFields stranger;
    stranger.frame = "arm";
    stranger.stamp = {1'700'000'000, 0};
    all.push_back(test::said_laser(stranger, cdr()));
    all.push_back({"/ticks", "acme_msgs/WheelTicks", "???", 0});
    for (int order = 0; order < 2; ++order) {
        Procesador reader(open_log(folder_.put("a.mcap", test::mcap_of(all))));
        if (order == 1) {
            while (reader.next_odometry()) {
            }
        }
        const Log log = test::read_all(reader);
        EXPECT_EQ(log.scans.size(), 4U);
        EXPECT_EQ(log.report.odometry, 4U);
        EXPECT_EQ(log.report.skipped, 3U);
        ASSERT_EQ(log.report.examples.size(), 3U);
        EXPECT_EQ(log.report.examples[0].line, 3U);
        EXPECT_THAT(log.report.examples[0].reason.english(),
                    HasSubstr("/scan: the message ends in the field \"range_max\""));
        EXPECT_THAT(log.report.examples[1].reason.english(), HasSubstr("/odom: "));
        EXPECT_THAT(log.report.examples[2].reason.english(),
                    HasSubstr("no transform leads from the laser's frame \"arm\""));
    }
}

TEST_F(RosTour, ScansBeforeTheOdometryAreCountedOrLeftOut) {
    std::vector<Said> all = test::small_tour(cdr());
    std::erase_if(all, [](const Said& said) {
        return said.topic == "/odom" && said.log_time_ns < at_ns({1'700'000'002, 0});
    });
    const Log kept = read(all);
    EXPECT_EQ(kept.scans.size(), 5U);
    EXPECT_EQ(kept.report.early_scans, 2U);
    EXPECT_TRUE(kept.report.of_recording);
    ReadOptions options;
    options.leave_out_early_scans = true;
    const Log log = read(all, options);
    ASSERT_EQ(log.scans.size(), 3U);
    EXPECT_EQ(log.scans.front().time_s, 1'700'000'002.25);
    EXPECT_EQ(log.report.early_scans_left_out, 2U);
    EXPECT_EQ(log.odometry.size(), 3U);
}

// What cannot be read may be where the scans are.
TEST_F(RosTour, WhyItsScansCannotBeReadIsSaid) {
    test::McapLayout layout;
    layout.packing = {"xz", test::packed_lz4};
    const auto unknown = folder_.put("xz.mcap", test::mcap_of(test::small_tour(cdr()), layout));
    EXPECT_THAT(test::message_of<FormatError>([&] { open_log(unknown); }),
                AllOf(HasSubstr("no laser scans"), HasSubstr("found the compression \"xz\"")));
    std::string bag = test::bag_of(test::small_tour(Bytes::ros1()), {"none", test::unpacked});
    const auto size = bag.find("size=") + 5;
    bag.replace(size, 4, "\x10\x00\x00\x00", 4);
    const auto lying = folder_.put("size.bag", bag);
    EXPECT_THAT(test::message_of<FormatError>([&] { open_log(lying); }),
                AllOf(HasSubstr("no laser scans"), HasSubstr("in the chunk at byte ")));
}

// One bad transform does not cost the others of its message, nor a bad twist its pose.
TEST_F(RosTour, TheGoodRestOfAMessageIsKept) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    std::vector<Said> all = test::small_tour(cdr());
    const Log expected = read(all);
    all[0] = test::said_transforms({{{1, 0}, "base_link", "wheel", {kNan, 0.0}},
                                    {{1, 0}, "base_link", "laser", {0.25, 0.0, 0.1}},
                                    {{1, 2'000'000'000}, "base_link", "arm", {}}},
                                   cdr(), "/tf_static");
    all[3].bytes =
        test::odometry_message({1'700'000'001, 250'000'000}, {0.1, 0.0}, kNan, 0.0, cdr());
    const Log log = read(all);
    EXPECT_EQ(log.scans, expected.scans);
    EXPECT_EQ(log.odometry, expected.odometry);
    EXPECT_EQ(log.report.skipped, 3U);
    ASSERT_EQ(log.report.examples.size(), 3U);
    EXPECT_THAT(log.report.examples[0].reason.english(),
                HasSubstr("/tf_static: field \"position\""));
    EXPECT_THAT(log.report.examples[1].reason.english(), HasSubstr("field \"stamp\""));
    EXPECT_THAT(log.report.examples[2].reason.english(), HasSubstr("/odom: field \"twist\""));
    ReadOptions logged;
    logged.odometry = OdometryFrom::velocities;
    EXPECT_EQ(read(all, logged).odometry.size(), 4U);
}

// A laser that is fixed to the world moves against the robot: it has no mounting.
TEST_F(RosTour, TheMountingIsSoughtOnTheRobotAlone) {
    for (const char* meeting : {"odom", "map"}) {
        std::vector<Said> all = test::small_tour(cdr());
        all[0] = test::said_transforms({{{1, 0}, "odom", "base_link", {}},
                                        {{1, 0}, "map", "odom", {}},
                                        {{1, 0}, meeting, "laser", {1.0, 0.0}}},
                                       cdr());
        const Log log = read(all);
        EXPECT_THAT(log.scans, IsEmpty()) << meeting;
        EXPECT_THAT(log.report.examples.front().reason.english(),
                    HasSubstr("or choose another laser"));
    }
}

TEST_F(RosTour, ATiltedLaserIsTold) {
    std::vector<Said> all = test::small_tour(cdr());
    all[0] =
        test::said_transforms({{{1, 0}, "base_link", "laser", {0.0, 0.0, 0.0, kPi / 6.0}}}, cdr());
    const Log log = read(all);
    EXPECT_THAT(log.scans, IsEmpty());
    EXPECT_EQ(log.report.skipped, 5U);
    EXPECT_THAT(log.report.examples.front().reason.english(), HasSubstr("is tilted by 30°"));
}

// Transforms in a circle end, and join nothing.
TEST_F(RosTour, ACircleOfFramesIsNoTree) {
    std::vector<Said> all = test::small_tour(cdr());
    all[0] = test::said_transforms({{{1, 0}, "a", "laser", {}}, {{1, 0}, "laser", "a", {}}}, cdr());
    const Log log = read(all);
    EXPECT_THAT(log.scans, IsEmpty());
    EXPECT_EQ(log.report.skipped, 5U);
}

TEST_F(RosTour, WithoutAnyTransformTheLaserSitsInTheOrigin) {
    std::vector<Said> all = test::small_tour(cdr());
    all.erase(all.begin());
    const Log log = read(all);
    ASSERT_EQ(log.scans.size(), 5U);
    EXPECT_EQ(log.scans.front().fan.pose_robot_laser, Pose{});
}

}  // namespace
}  // namespace hitos
