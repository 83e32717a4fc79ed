// SPDX-License-Identifier: GPL-3.0-or-later
// ROS messages from their bytes, against the tests' own serialisation.
#include <gmock/gmock.h>

#include <limits>

#include "hitos/base/error.hpp"
#include "ros/messages.hpp"
#include "support.hpp"
#include "unit/capture/ros_writers.hpp"

namespace hitos {
namespace {

using test::Bytes;
using testing::ElementsAre;
using testing::HasSubstr;

/// ROS 1, and CDR in either order of bytes.
class EverySerialisation : public ::testing::TestWithParam<int> {
  protected:
    static Bytes bytes() { return GetParam() == 0 ? Bytes::ros1() : Bytes::cdr(GetParam() == 2); }
    static Encoding encoding() { return GetParam() == 0 ? Encoding::ros1 : Encoding::cdr; }
};

TEST_P(EverySerialisation, HoldsALaserScan) {
    test::LaserFields laser;
    laser.frame = "/a";  // an odd length: CDR pads behind it
    laser.stamp = {1'700'000'000, 123'456'789};
    laser.ranges = {1.5F, std::numeric_limits<float>::infinity(), 3.25F};
    laser.intensities = {1.0F, 2.0F, 3.0F};
    const LaserScanMessage scan = decode_laser_scan(laser_message(laser, bytes()), encoding());
    EXPECT_EQ(scan.header.stamp_ns, 1'700'000'000'123'456'789);
    EXPECT_EQ(scan.header.frame, "a");
    EXPECT_EQ(scan.min_angle_rad, -0.5);
    EXPECT_EQ(scan.step_rad, 0.5);
    EXPECT_EQ(scan.min_range_m, static_cast<double>(0.05F));
    EXPECT_EQ(scan.max_range_m, 8.0);
    EXPECT_THAT(scan.ranges_m, ElementsAre(1.5F, std::numeric_limits<float>::infinity(), 3.25F));
}

TEST_P(EverySerialisation, HoldsOdometry) {
    const OdometryMessage odometry = decode_odometry(
        odometry_message({3, 4}, {1.0, 2.0, 3.0, 0.0, 0.75}, 0.5, -0.25, bytes(), "base"),
        encoding());
    EXPECT_EQ(odometry.header.stamp_ns, 3'000'000'004);
    EXPECT_EQ(odometry.header.frame, "odom");
    EXPECT_EQ(odometry.child_frame, "base");
    EXPECT_EQ(odometry.pose.x, 1.0);
    EXPECT_EQ(odometry.pose.z, 3.0);
    EXPECT_NEAR(odometry.pose.yaw(), 0.75, 1e-14);
    EXPECT_EQ(odometry.twist, std::optional(Twist{0.5, 0.0, -0.25}));
}

TEST_P(EverySerialisation, HoldsTransforms) {
    const auto told = decode_transforms(
        transforms_message({{{1, 2}, "/map", "odom", {1.0, 2.0, 3.0}}, {{1, 3}, "odom", "b", {}}},
                           bytes()),
        encoding());
    ASSERT_EQ(told.size(), 2U);
    EXPECT_EQ(told[0].header.frame, "map");
    EXPECT_EQ(told[0].child_frame, "odom");
    EXPECT_EQ(told[0].transform.z, 3.0);
    EXPECT_EQ(told[1].header.stamp_ns, 1'000'000'003);
}

// Cut at every byte: an error that says so, or (padding) the whole.
TEST_P(EverySerialisation, IsRefusedWhereItEndsEarly) {
    const std::string laser = laser_message({}, bytes());
    const std::string odometry = odometry_message({1, 2}, {}, 0.0, 0.0, bytes());
    const std::string transforms = transforms_message({{{1, 2}, "a", "b", {}}}, bytes());
    for (std::size_t i = 0; i < laser.size(); ++i) {
        EXPECT_THROW(decode_laser_scan(laser.substr(0, i), encoding()), FormatError) << i;
    }
    for (std::size_t i = 0; i < odometry.size(); ++i) {
        EXPECT_THROW(decode_odometry(odometry.substr(0, i), encoding()), FormatError) << i;
    }
    for (std::size_t i = 0; i < transforms.size(); ++i) {
        EXPECT_THROW(decode_transforms(transforms.substr(0, i), encoding()), FormatError) << i;
    }
    EXPECT_THROW(decode_laser_scan(laser + "12345678", encoding()), FormatError);
}

INSTANTIATE_TEST_SUITE_P(
    Messages, EverySerialisation, testing::Values(0, 1, 2), [](const auto& value) {
        return std::string(value.param == 0 ? "Ros1" : value.param == 1 ? "LittleCdr" : "BigCdr");
    });

std::string refusal_of(const std::string& bytes, Encoding encoding = Encoding::ros1) {
    return test::message_of<FormatError>([&] { decode_laser_scan(bytes, encoding); });
}

TEST(RosMessages, SayWhatIsWrongWithThem) {
    test::LaserFields laser;
    const std::string sound = laser_message(laser);
    EXPECT_THAT(refusal_of(""), HasSubstr("ends in the field \"seq\""));
    EXPECT_THAT(refusal_of("\x09\x09__", Encoding::cdr), HasSubstr("does not begin as CDR"));
    EXPECT_THAT(refusal_of("\x28\xb5\x2f\xfd____", Encoding::cdr),
                HasSubstr("compression_mode MESSAGE"));
    laser.ranges = {};
    EXPECT_THAT(refusal_of(laser_message(laser)), HasSubstr("found 0 rays"));
    laser = {};
    laser.stamp.nanoseconds = 1'000'000'000;
    EXPECT_THAT(refusal_of(laser_message(laser)), HasSubstr("\"stamp\": found 1000000000"));
    laser = {};
    laser.step = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(refusal_of(laser_message(laser)), HasSubstr("\"angle_increment\": found nan"));
    laser.step = -1.1e12;
    EXPECT_THAT(refusal_of(laser_message(laser)), HasSubstr("expected a finite number up to 1e12"));
    // A count that no memory would hold is held against what is there.
    std::string great = sound;
    const std::size_t count = great.size() - 20;  // its empty list of intensities, three ranges
    std::fill_n(great.begin() + static_cast<std::ptrdiff_t>(count), 4, '\xff');
    EXPECT_THAT(refusal_of(great), HasSubstr("found a count of 4294967295, expected at most 4"));
    const std::string no_turn = test::transforms_message({{{1, 2}, "a", "b", {}}});
    std::string zeros = no_turn;  // but for the last number
    std::fill_n(zeros.end() - 8, 8, '\0');
    std::string told;
    decode_transforms(zeros, Encoding::ros1, [&told](const Message& m) { told = m.english(); });
    EXPECT_THAT(told, HasSubstr("quaternion of length 0"));
}

TEST(RosMessages, StampsOfTodayKeepTheirPrecision) {
    const double later = seconds_of(1'700'000'000'100'000'000);
    EXPECT_NEAR(later - seconds_of(1'700'000'000'000'000'000), 0.1, 2.4e-7);
    EXPECT_EQ(seconds_of(12'345'678'901), 12.345678901);
    EXPECT_EQ(seconds_of(-500'000'000), -0.5);
}

TEST(Transforms, AreComposedAndInverted) {
    const Transform a{1.0, 2.0, 3.0, 0.0, 0.0, std::sqrt(0.5), std::sqrt(0.5)};  // yaw 90°
    const Transform upside_down{0.5, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0};              // roll 180°
    const Transform both = compose(a, upside_down);
    EXPECT_NEAR(both.x, 1.0, 1e-14);
    EXPECT_NEAR(both.y, 2.5, 1e-14);
    EXPECT_NEAR(both.yaw(), kPi / 2.0, 1e-14);
    EXPECT_NEAR(both.upward(), -1.0, 1e-14);
    const Transform none = compose(both, inverse(both));
    EXPECT_NEAR(none.x, 0.0, 1e-14);
    EXPECT_NEAR(none.y, 0.0, 1e-14);
    EXPECT_NEAR(none.z, 0.0, 1e-14);
    EXPECT_NEAR(std::abs(none.qw), 1.0, 1e-14);
}

}  // namespace
}  // namespace hitos
