// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings that are whole and wrong: whose transforms, where the laser sits, whose clock.
#include <gmock/gmock.h>

#include <limits>

#include "unit/capture/ros_packings.hpp"
#include "unit/capture/ros_tours.hpp"
#include "unit/capture/test_files.hpp"

namespace hitos {
namespace {

using test::Bytes;
using test::Log;
using test::Placing;
using test::Said;
using test::Stamp;
using testing::AllOf;
using testing::HasSubstr;
using Doubt = TourFinding::Kind;

constexpr std::uint32_t kDoubtfulBegin = 1'700'000'000;

class DoubtfulRecording : public ::testing::Test {
  protected:
    Log read(const std::vector<Said>& all, const ReadOptions& options = ReadOptions()) const {
        const auto file = folder_.put("a.mcap", test::mcap_of(all));
        Procesador reader(open_log(file, kAutoFormat, options), options);
        return test::read_all(reader);
    }
    static std::vector<Doubt> kinds(const Log& log) {
        std::vector<Doubt> found;
        for (const TourFinding& finding : log.findings) found.push_back(finding.kind);
        return found;
    }
    test::TempDir folder_;
};

/// The small tour under a namespace, its laser `ahead` of the robot's origin.
std::vector<Said> robot(const std::string& space, double ahead) {
    std::vector<Said> all{
        test::said_transforms({{{kDoubtfulBegin, 0}, "base_link", "laser", {ahead, 0.0, 0.1}}},
                              Bytes::cdr(), space + "/tf_static")};
    for (std::uint32_t i = 0; i < 5; ++i) {
        const Stamp stamp{kDoubtfulBegin + i, 250'000'000};
        test::LaserFields laser;
        laser.stamp = stamp;
        all.push_back(test::said_transforms({{stamp, "odom", "base_link", {ahead * i, 0.0}}},
                                            Bytes::cdr(), space + "/tf"));
        all.push_back(test::said_odometry(stamp, {0.1 * i, 0.0}, Bytes::cdr(), space + "/odom"));
        all.push_back(test::said_laser(laser, Bytes::cdr(), space + "/scan"));
    }
    return all;
}

ReadOptions of_robot(const std::string& space, const std::string& odometry) {
    ReadOptions options;
    options.scan_topic = space + "/scan";
    options.odom_topic = odometry;
    return options;
}

TEST_F(DoubtfulRecording, ARobotHasTheTransformsOfItsNamespace) {
    std::vector<Said> all = robot("/one", 0.25);
    for (const Said& said : robot("/two", 0.5)) all.push_back(said);
    for (const auto& [space, ahead] : {std::pair("/one", 0.25), std::pair("/two", 0.5)}) {
        const Log log = read(all, of_robot(space, std::string(space) + "/odom"));
        ASSERT_EQ(log.scans.size(), 5U);
        EXPECT_EQ(log.scans.front().fan.pose_robot_laser.x, ahead);
        EXPECT_TRUE(log.findings.empty());
        // The path too.
        const Log by_tf = read(all, of_robot(space, "tf"));
        EXPECT_NEAR(test::summed(by_tf.odometry).back().x, 4.0 * ahead, 1e-12);
    }
}

TEST_F(DoubtfulRecording, LasersOfTwoRobotsAreRefusedWithBothNamed) {
    std::vector<Said> all = robot("/one", 0.25);
    for (const Said& said : robot("/two", 0.5)) all.push_back(said);
    for (const char* odometry : {"", "tf", "/one/odom"}) {
        ReadOptions options = of_robot("", odometry);
        options.scan_topic = "all";
        EXPECT_THAT(
            test::message_of<ConfigError>([&] { read(all, options); }),
            AllOf(HasSubstr("two robots"), HasSubstr("/one/scan, whose odometry is in /one/odom"),
                  HasSubstr("/two/scan, whose is in /two/odom"), HasSubstr("--scan-topic")))
            << odometry;
    }
}

TEST_F(DoubtfulRecording, EachLaserOfARobotHasTheTransformsOfItsNamespace) {
    std::vector<Said> all = robot("", 0.0);
    const Stamp begin{kDoubtfulBegin, 0};
    std::erase_if(all, [](const Said& said) { return said.topic == "/scan"; });
    all.erase(all.begin());
    for (const auto& [space, ahead] : {std::pair("/front", 0.25), std::pair("/rear", -0.5)}) {
        all.push_back(test::said_transforms({{begin, "base_link", "laser", {ahead, 0.0, 0.1}}},
                                            Bytes::cdr(), std::string(space) + "/tf_static"));
        test::LaserFields laser;
        laser.stamp = {kDoubtfulBegin + 1, ahead > 0.0 ? 0U : 500'000'000U};
        all.push_back(test::said_laser(laser, Bytes::cdr(), std::string(space) + "/scan"));
    }
    for (const char* odometry : {"/odom", "tf"}) {
        ReadOptions options = of_robot("", odometry);
        options.scan_topic = "all";
        const Log log = read(all, options);
        ASSERT_EQ(log.scans.size(), 2U) << odometry;
        EXPECT_EQ(log.scans[0].fan.pose_robot_laser.x, 0.25);
        EXPECT_EQ(log.scans[1].fan.pose_robot_laser.x, -0.5);
        EXPECT_EQ(log.odometry.size(), 5U);
        // An odometry of a laser's own beside that of the robot makes no second robot.
        std::vector<Said> more = all;
        for (const char* own : {"/front/odom", "/rear/odom"}) {
            more.push_back(test::said_odometry(begin, {}, Bytes::cdr(), own));
        }
        if (std::string_view(odometry) == "/odom") {
            EXPECT_EQ(read(more, options).scans.size(), 2U);
        }
    }
}

TEST_F(DoubtfulRecording, TwoSourcesOfOneFrameThatDisagreeAreNamed) {
    std::vector<Said> all = robot("/one", 0.25);
    for (const Said& said : robot("/two", 0.5)) all.push_back(said);
    for (Said& said : all) {
        if (said.topic == "/one/scan") said.topic = "/scan";  // of neither
    }
    std::erase_if(all, [](const Said& said) { return said.topic == "/two/scan"; });
    ReadOptions options = of_robot("", "/one/odom");
    options.scan_topic = "/scan";
    EXPECT_THAT(test::message_of<FormatError>([&] { read(all, options); }),
                AllOf(HasSubstr("\"laser\""), HasSubstr("/one/tf_static"),
                      HasSubstr("/two/tf_static"), HasSubstr("--laser-pose")));
    options.laser_pose = "0.75,0,0";
    EXPECT_EQ(read(all, options).scans.at(0).fan.pose_robot_laser.x, 0.75);
    // Two that say the same are no contradiction.
    std::vector<Said> twice = robot("", 0.25);
    twice.push_back(twice.front());
    twice.back().topic = "/tf";
    EXPECT_EQ(read(twice).scans.size(), 5U);
}

TEST_F(DoubtfulRecording, AFixedPlaceThatIsToldTwiceDifferentlyIsNone) {
    std::vector<Said> all = robot("", 0.25);
    const std::vector<Said> other = robot("", 0.5);
    all.insert(all.begin() + 1, other.front());
    EXPECT_THAT(test::message_of<FormatError>([&] { read(all); }), HasSubstr("/tf_static"));
    all[1] = all[0];
    EXPECT_EQ(read(all).scans.size(), 5U);
}

TEST_F(DoubtfulRecording, FramesThatAreOneUnderTwoNamesAreJoined) {
    std::vector<Said> all = robot("", 0.25);
    for (std::uint32_t i = 0; i < 5; ++i) {
        all[2 + 3 * i].bytes =
            test::odometry_message({kDoubtfulBegin + i, 250'000'000}, {0.1 * i, 0.0}, 0, 0,
                                   Bytes::cdr(), "base_footprint");
    }
    const Log none = read(all);
    EXPECT_TRUE(none.scans.empty());
    EXPECT_THAT(none.report.examples.at(0).reason.english(),
                AllOf(HasSubstr("\"laser\""), HasSubstr("\"base_footprint\""),
                      HasSubstr("--laser-pose"), HasSubstr("--same-frames base_footprint=NAME")));
    for (const char* same : {"base_footprint=base_link", "base_link = base_footprint",
                             "a=b,base_link=base_footprint"}) {
        ReadOptions options;
        options.same_frames = same;
        ASSERT_EQ(read(all, options).scans.size(), 5U) << same;
        EXPECT_EQ(read(all, options).scans.front().fan.pose_robot_laser.x, 0.25);
    }
    for (const char* wrong : {"base_link", "=", "a=a", "base_link="}) {
        ReadOptions options;
        options.same_frames = wrong;
        EXPECT_THAT(test::message_of<ConfigError>([&] { read(all, options); }),
                    HasSubstr("source.same_frames: found"))
            << wrong;
    }
}

TEST_F(DoubtfulRecording, WithoutTheStaticTransformsTheOdometryIsInTheOthers) {
    std::vector<Said> all;
    for (Said& said : robot("", 0.25)) {
        if (said.topic == "/scan" || said.topic == "/tf") all.push_back(std::move(said));
    }
    const Log lost = read(all);
    EXPECT_EQ(lost.odometry.size(), 5U);
    EXPECT_TRUE(lost.scans.empty());
    ReadOptions options;
    options.laser_pose = "0.25,0,0";
    const Log log = read(all, options);
    EXPECT_EQ(log.scans.size(), 5U);
    EXPECT_NEAR(test::summed(log.odometry).back().x, 1.0, 1e-12);
    EXPECT_TRUE(log.findings.empty());
}

TEST_F(DoubtfulRecording, AMountingThatNothingSaysIsAssumedAndTold) {
    std::vector<Said> all;
    for (Said& said : robot("", 0.25)) {
        if (said.topic == "/scan" || said.topic == "/odom") all.push_back(std::move(said));
    }
    const Log log = read(all);
    EXPECT_EQ(log.scans.size(), 5U);
    ASSERT_EQ(kinds(log), std::vector{Doubt::assumed_mounting});
    EXPECT_THAT(advice_of(log.findings.front()).english(), HasSubstr("--laser-pose"));
    ReadOptions options;
    options.laser_pose = "0.25,0,0";
    EXPECT_TRUE(read(all, options).findings.empty());
}

TEST_F(DoubtfulRecording, OdometryThatCannotBeReadLeavesTheTransforms) {
    std::vector<Said> all = robot("", 0.25);
    for (std::uint32_t i = 0; i < 5; ++i) {
        std::string& bytes = all[2 + 3 * i].bytes;
        const std::string sound = test::odometry_message({kDoubtfulBegin + i, 250'000'000},
                                                         {7.0, 7.0}, 0.5, 0.25, Bytes::cdr());
        // A quaternion of zeros, as drivers that do not fill it in send.
        const double one = 1.0;
        const std::size_t w = sound.find(std::string(reinterpret_cast<const char*>(&one), 8));
        ASSERT_NE(w, std::string::npos);
        bytes = sound;
        bytes.replace(w, 8, 8, '\0');
    }
    const Log log = read(all);
    EXPECT_EQ(log.scans.size(), 5U);
    ASSERT_EQ(kinds(log), std::vector{Doubt::unread_odometry});
    EXPECT_NEAR(test::summed(log.odometry).back().x, 1.0, 1e-12);
}

/// Its orientation as four numbers of that length, the last of which stands in for 1.
void make_longer(std::string& bytes, double length) {
    const double one = 1.0;
    const std::size_t w = bytes.find(std::string(reinterpret_cast<const char*>(&one), 8));
    ASSERT_NE(w, std::string::npos);
    bytes.replace(w, 8, std::string(reinterpret_cast<const char*>(&length), 8));
}

TEST_F(DoubtfulRecording, QuaternionsOfAnotherLengthAreTold) {
    for (const auto& [length, told] : {std::pair(1.009, false), std::pair(2.0, true)}) {
        std::vector<Said> all = robot("", 0.25);
        for (std::uint32_t i = 0; i < 5; ++i) {
            std::string& bytes = all[2 + 3 * i].bytes;
            bytes = test::odometry_message({kDoubtfulBegin + i, 250'000'000}, {7.0 + 0.1 * i, 7.0},
                                           0.5, 0.25, Bytes::cdr());
            make_longer(bytes, length);
        }
        const Log log = read(all);
        if (!told) {
            EXPECT_TRUE(log.findings.empty());
            continue;
        }
        ASSERT_EQ(kinds(log), std::vector{Doubt::odometry_units});
        EXPECT_THAT(log.findings[0].what.english(),
                    HasSubstr("of 5 of 5 odometry readings is no quaternion of length 1 (of length "
                              "2 in message 3), as where nobody divided by it"));
        EXPECT_TRUE(log.findings[0].remedies.at(0).settings.empty());
    }
}

TEST_F(DoubtfulRecording, HeadingsInPlaceOfQuaternionsAreTold) {
    std::vector<Said> all = robot("", 0.25);
    for (std::uint32_t i = 0; i < 5; ++i) {
        std::string& bytes = all[2 + 3 * i].bytes;
        bytes = test::odometry_message({kDoubtfulBegin + i, 250'000'000}, {0.1 * i, 0.0}, 0.5, 0.25,
                                       Bytes::cdr());
        const double one = 1.0;
        const std::size_t w = bytes.find(std::string(reinterpret_cast<const char*>(&one), 8));
        ASSERT_NE(w, std::string::npos);
        const double heading = 0.4 * (i + 1);
        bytes.replace(w - 8, 8, std::string(reinterpret_cast<const char*>(&heading), 8));
    }
    const Log log = read(all);
    ASSERT_EQ(kinds(log), std::vector{Doubt::odometry_units});
    EXPECT_THAT(log.findings[0].what.english(), HasSubstr("as where a heading was written into z"));
    EXPECT_THAT(advice_of(log.findings[0]).english(), HasSubstr("source.odometry=velocities"));
}

TEST_F(DoubtfulRecording, TransformsOfAnotherRobotAreNotTakenUnnoticed) {
    std::vector<Said> all = robot("/one", 0.25);
    for (const Said& said : robot("/two", 0.5)) all.push_back(said);
    std::erase_if(all, [](const Said& said) { return said.topic.starts_with("/one/tf"); });
    // Those of a namespace with a laser are that laser's.
    const Log without = read(all, of_robot("/one", "/one/odom"));
    ASSERT_EQ(without.scans.size(), 5U);
    EXPECT_EQ(without.scans.front().fan.pose_robot_laser.x, 0.0);
    ASSERT_EQ(kinds(without), std::vector{Doubt::assumed_mounting});
    // Others may be its own.
    std::erase_if(all, [](const Said& said) { return said.topic == "/two/scan"; });
    const Log taken = read(all, of_robot("/one", "/one/odom"));
    EXPECT_EQ(taken.scans.front().fan.pose_robot_laser.x, 0.5);
    ASSERT_EQ(kinds(taken), std::vector{Doubt::assumed_mounting});
    EXPECT_THAT(taken.findings.front().what.english(),
                AllOf(HasSubstr("/one/scan"), HasSubstr("/two/tf_static")));
}

TEST_F(DoubtfulRecording, RangeLimitsThatAreSwappedAreTakenTheOtherWayRound) {
    std::vector<Said> all = robot("", 0.25);
    const auto laser = [&](double least, double greatest) {
        for (std::uint32_t i = 0; i < 5; ++i) {
            test::LaserFields fields;
            fields.stamp = {kDoubtfulBegin + i, 250'000'000};
            fields.ranges = {1.0F, 2.0F, 3.0F, 3.15F};
            fields.min_range = least;
            fields.max_range = greatest;
            all[3 + 3 * i] = test::said_laser(fields, Bytes::cdr());
        }
        return read(all);
    };
    const Log sound = laser(0.1, 12.0);
    EXPECT_TRUE(sound.findings.empty());
    const Log swapped = laser(12.0, 0.1);
    ASSERT_EQ(swapped.scans.size(), 5U);
    EXPECT_EQ(swapped.scans.front().points, sound.scans.front().points);
    ASSERT_EQ(kinds(swapped), std::vector{Doubt::blind_laser});
    EXPECT_THAT(swapped.findings.front().what.english(), HasSubstr("the other way round"));
    // Limits that leave hardly anything.
    const Log near = laser(5.0, 12.0);
    ASSERT_EQ(kinds(near), std::vector{Doubt::blind_laser});
    EXPECT_EQ(near.findings.front().value, 1.0);
    const Log far = laser(0.1, 2.5);
    ASSERT_EQ(kinds(far), std::vector{Doubt::blind_laser});
    EXPECT_THAT(far.findings.front().what.english(), HasSubstr("go on from ray to ray"));
    EXPECT_EQ(far.findings.front().remedies.front().settings.front().value, "4");
}

TEST_F(DoubtfulRecording, TwoSendersOfOneTransformAreNoticed) {
    const auto tour = [](double apart) {
        std::vector<Said> all;
        for (std::uint32_t i = 0; i < 60; ++i) {
            const Stamp stamp{kDoubtfulBegin + i, 0};
            test::LaserFields laser;
            laser.stamp = stamp;
            all.push_back(test::said_transforms(
                {{stamp, "odom", "base_link", {0.2 * i, i % 2 == 0 ? 0.0 : apart}},
                 {stamp, "base_link", "laser", {0.25, 0.0, 0.1}}},
                Bytes::cdr()));
            all.push_back(test::said_laser(laser, Bytes::cdr()));
        }
        return all;
    };
    EXPECT_TRUE(read(tour(0.0)).findings.empty());
    const Log log = read(tour(3.0));
    ASSERT_EQ(kinds(log), std::vector{Doubt::two_publishers});
    EXPECT_THAT(log.findings.front().what.english(), HasSubstr("\"base_link\""));
}

TEST_F(DoubtfulRecording, TwoSendersAtUnequalRatesAreNoticedToo) {
    for (const char* child : {"base_link", "laser"}) {
        std::vector<Said> all;
        for (std::uint32_t i = 0; i < 200; ++i) {
            const Stamp stamp{kDoubtfulBegin + i, 0};
            test::LaserFields laser;
            laser.stamp = stamp;
            all.push_back(test::said_transforms({{stamp, "odom", "base_link", {0.2 * i, 0.0}},
                                                 {stamp, "base_link", "laser", {0.25, 0.0, 0.1}}},
                                                Bytes::cdr()));
            all.push_back(test::said_laser(laser, Bytes::cdr()));
            if (i % 7 != 6) continue;
            const bool robot = std::string_view(child) == "base_link";
            all.push_back(test::said_transforms({{{kDoubtfulBegin + i, 500'000'000},
                                                  robot ? "odom" : "base_link",
                                                  child,
                                                  {robot ? 0.1 * i : 0.0, robot ? 8.0 : 0.4, 0.1}}},
                                                Bytes::cdr()));
        }
        const Log log = read(all);
        ASSERT_EQ(kinds(log), std::vector{Doubt::two_publishers}) << child;
        EXPECT_THAT(log.findings.front().what.english(), HasSubstr(child));
    }
}

TEST_F(DoubtfulRecording, StampsOfAnotherClockThanThatOfReceiptAreTold) {
    std::vector<Said> all = robot("", 0.25);
    for (Said& said : all) {
        said.log_time_ns += 100'000'000;
        if (said.topic == "/scan") said.log_time_ns += 2'000'000'000;
    }
    const Log log = read(all);
    ASSERT_EQ(kinds(log), std::vector{Doubt::late_stamps});
    EXPECT_NEAR(log.findings.front().value, 2.0, 1e-3);
    EXPECT_THAT(advice_of(log.findings.front()).english(), HasSubstr("--scan-delay 2.00"));
    for (Said& said : all) {
        if (said.topic == "/odom") said.log_time_ns += 2'000'000'000;  // both received late
    }
    EXPECT_TRUE(read(all).findings.empty());
}

TEST_F(DoubtfulRecording, WithoutScansItsTopicsAreListedWithTypesAndAdvice) {
    std::vector<Said> all{{"/points", "sensor_msgs/PointCloud2", std::string(40, 'x'), 1}};
    EXPECT_THAT(test::message_of<FormatError>([&] { read(all); }),
                AllOf(HasSubstr("/points (sensor_msgs/PointCloud2, 1)"),
                      HasSubstr("pointcloud_to_laserscan")));
}

TEST_F(DoubtfulRecording, OfSeveralEchoesTheFirstIsTheReading) {
    test::LaserFields laser;
    laser.ranges = {1.0F, std::numeric_limits<float>::infinity(), 3.0F};
    for (const Bytes& bytes : {Bytes::cdr(), Bytes::cdr(true)}) {
        std::vector<Said> one{test::said_laser(laser, bytes)};
        std::vector<Said> several{
            {"/scan", "sensor_msgs/MultiEchoLaserScan", test::multi_echo_message(laser, bytes), 0}};
        EXPECT_EQ(read(several).scans, read(one).scans);
        ASSERT_EQ(read(several).scans.size(), 1U);
        // Cut anywhere it is damage, not a scan.
        const std::string whole = several[0].bytes;
        for (std::size_t cut = 0; cut + 8 < whole.size(); ++cut) {
            several[0].bytes = whole.substr(0, cut);
            EXPECT_TRUE(read(several).scans.empty()) << cut;
        }
    }
}

}  // namespace
}  // namespace hitos
