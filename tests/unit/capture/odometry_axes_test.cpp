// SPDX-License-Identifier: GPL-3.0-or-later
// Logged poses of other axes, of headings that count the other way or are in degrees: told, and
// read as they are meant by what is advised.
#include "hitos/capture/odometry_axes.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "hitos/base/error.hpp"
#include "test_files.hpp"

namespace hitos {
namespace {

using test::expect_near;
using test::read_text;
using ::testing::HasSubstr;
using Change = std::function<Pose(const Pose&)>;

/// A robot that drives bends of more than a turn to either side, and stops in between.
std::string bends(const Change& change) {
    std::string text;
    Pose pose;
    for (int i = 0; i < 1600; ++i) {
        const double time = 0.05 * i;
        const Pose told = change(pose);
        text += fmt::format("position 0 {:.3f} {} {} {} 0 0 0\n", time, told.x, told.y, told.theta);
        const double speed = i % 200 < 20 ? 0.0 : 0.5;
        pose = compose(pose, displacement({speed, 0.0, (i / 400) % 2 == 0 ? 0.6 : -0.45}, 0.05));
    }
    return text;
}

Pose last_of(const std::string& text, const ReadOptions& options = {}) {
    return test::summed(read_text("radish", text, options).odometry).back();
}

struct Convention {
    Change change;
    std::string_view axes;
};

TEST(OdometryAxes, WhatIsAdvisedReadsThePosesAsTheyAreMeant) {
    const std::vector<Convention> conventions{
        {[](const Pose& p) {
             return Pose{p.x, p.y, -p.theta};
         },
         "x,y,-theta"},
        {[](const Pose& p) {
             return Pose{p.x, p.y, wrap_angle(kPi / 2.0 - p.theta)};
         },
         "x,y,90-theta"},
        {[](const Pose& p) {
             return Pose{p.y, p.x, p.theta};
         },
         "y,x,theta"},
        {[](const Pose& p) {
             return Pose{-p.y, -p.x, p.theta};
         },
         "-y,-x,theta"},
        {[](const Pose& p) {
             return Pose{-p.x, p.y, p.theta};
         },
         "-x,y,theta"},
        {[](const Pose& p) {
             return Pose{p.x, -p.y, p.theta};
         },
         "x,-y,theta"},
        {[](const Pose& p) {
             return Pose{p.x, p.y, p.theta * kDegreesPerRadian};
         },
         "x,y,degrees"}};
    const std::string meant = bends([](const Pose& pose) { return pose; });
    EXPECT_TRUE(read_text("radish", meant).findings.empty());
    for (const Convention& one : conventions) {
        const std::string text = bends(one.change);
        const auto found = read_text("radish", text).findings;
        ASSERT_EQ(found.size(), 1U) << one.axes;
        EXPECT_THAT(advice_of(found.front()).english(),
                    HasSubstr("source.odometry_axes=" + std::string(one.axes)));
        ReadOptions options;
        options.odometry_axes = one.axes;
        EXPECT_TRUE(read_text("radish", text, options).findings.empty()) << one.axes;
        expect_near(last_of(text, options), last_of(meant), 1e-4);
    }
}

TEST(OdometryAxes, DegreesThatWereWrappedAsRadiansAreReadToo) {
    const auto wrapped = [](const Pose& p) {
        return Pose{p.x, p.y, wrap_angle(p.theta * kDegreesPerRadian)};
    };
    ReadOptions options;
    options.odometry_axes = "x,y,degrees";
    // Within a degree of the half turn they are two degrees off.
    expect_near(last_of(bends(wrapped), options),
                last_of(bends([](const Pose& pose) { return pose; })), 0.03);
}

TEST(OdometryAxes, TurnsAreWidenedAndMirrored) {
    const std::string text = bends([](const Pose& pose) { return pose; });
    const std::string mirrored = bends([](const Pose& p) { return Pose{p.x, -p.y, -p.theta}; });
    ReadOptions options;
    options.odometry_turns = -1.0;
    expect_near(last_of(mirrored, options), last_of(text), 1e-4);
    options.odometry_turns = 1.25;
    const auto told = read_text("radish", text).odometry;
    const auto wide = read_text("radish", text, options).odometry;
    ASSERT_EQ(told.size(), wide.size());
    EXPECT_EQ(wide[100].twist.w, 1.25 * told[100].twist.w);
    EXPECT_EQ(wide[100].twist.v, told[100].twist.v);
}

TEST(OdometryAxes, OtherTextsAreRefused) {
    for (const char* wrong : {"x,y", "x,x,theta", "x,y,theta,1", "x,z,theta", "x,y,heading",
                              "x,y,2theta", "x,y,theta90", "x,y,90*theta", "x,y,inf-theta"}) {
        try {
            const OdometryAxes axes{wrong};
            ADD_FAILURE() << wrong;
        } catch (const ConfigError& error) {
            EXPECT_THAT(error.what(), HasSubstr("source.odometry_axes: found \""));
        }
    }
    OdometryAxes turned{" -y , x , theta-30 "};
    expect_near(turned.taken({1, 2, 0}), {-2, 1, -kPi / 6.0}, 1e-12);
}

}  // namespace
}  // namespace hitos
