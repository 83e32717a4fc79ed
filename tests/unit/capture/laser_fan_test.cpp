// SPDX-License-Identifier: GPL-3.0-or-later
// Lasers of a recording as fans, and two of them as one.
#include "ros/laser_fan.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace hitos {
namespace {

MountedScan laser(double first_rad, double step_rad, std::size_t rays = 2) {
    LaserScanMessage message;
    message.min_angle_rad = first_rad;
    message.step_rad = step_rad;
    message.max_range_m = 8.0;
    message.ranges_m.assign(rays, 1.0F);
    return mounted_scan(message, Transform{});
}

TEST(MergedLasers, FillOnlyWhatLiesBetweenThem) {
    const auto both = merged(laser(0.0, 0.25), laser(1.0, 0.25));
    ASSERT_TRUE(both);
    EXPECT_EQ(both->fan.count, 6U);
    EXPECT_EQ(both->ranges_m.size(), 6U);
    EXPECT_TRUE(std::isnan(both->ranges_m[2]));
    EXPECT_EQ(both->ranges_m[4], 1.0F);
}

TEST(MergedLasers, OfTinyStepsFarApartAreNone) {
    for (int power = 21; power < 60; ++power) {
        const double step = std::ldexp(1.0, -power);
        EXPECT_FALSE(merged(laser(0.0, step), laser(1.0, step))) << power;
        EXPECT_FALSE(merged(laser(1.0, step), laser(0.0, step))) << power;
    }
}

TEST(MergedLasers, OfAnglesThatAreNoNumbersAreNone) {
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity(), 1e300}) {
        EXPECT_FALSE(merged(laser(0.0, 0.25), laser(bad, 0.25))) << bad;
        EXPECT_FALSE(merged(laser(bad, 0.25), laser(0.0, 0.25))) << bad;
    }
}

}  // namespace
}  // namespace hitos
