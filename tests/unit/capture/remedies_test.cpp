// SPDX-License-Identifier: GPL-3.0-or-later
#include "remedies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "support.hpp"

namespace hitos {
namespace {

using testing::ElementsAre;

SourceSetting setting(std::string key, std::string value) {
    return {std::move(key), std::move(value)};
}

TEST(WholeValues, ComeOnTopOfHowTheTourIsRead) {
    ReadOptions read;
    EXPECT_THAT(WholeValues(read).later_by(-0.72),
                ElementsAre(setting("source.scan_delay", "-0.72")));
    EXPECT_THAT(WholeValues(read).range_scale(0.001),
                ElementsAre(setting("source.range_scale", "0.001")));
    read.scan_delay_s = -1.0;
    read.range_scale = 0.0254;
    read.range_offset_m = 0.5;
    read.fan_scale = 0.9;
    read.odometry_scale = 0.001;
    read.odometry_turns = -1.0;
    EXPECT_THAT(WholeValues(read).later_by(-0.72),
                ElementsAre(setting("source.scan_delay", "-1.72")));
    EXPECT_THAT(WholeValues(read).later_by(1.0), ElementsAre(setting("source.scan_delay", "0.00")));
    EXPECT_THAT(WholeValues(read).range_scale(2.0),
                ElementsAre(setting("source.range_scale", "0.0508"),
                            setting("source.range_offset", "1.00")));
    EXPECT_THAT(WholeValues(read).range_offset(-0.2),
                ElementsAre(setting("source.range_offset", "0.30")));
    EXPECT_THAT(WholeValues(read).fan_scale(1.1), ElementsAre(setting("source.fan_scale", "0.99")));
    EXPECT_THAT(WholeValues(read).odometry_scale(1.2),
                ElementsAre(setting("source.odometry_scale", "0.0012")));
    EXPECT_THAT(WholeValues(read).odometry_turns(-1.12),
                ElementsAre(setting("source.odometry_turns", "1.12")));
}

TEST(WholeValues, AClockTakesUpADelayAndADelayAClock) {
    ReadOptions read;
    read.scan_delay_s = 1.0;
    const auto clock = WholeValues(read).clock(ScanClock("0@0,-2@100"));
    EXPECT_THAT(clock, ElementsAre(setting("source.scan_clock", "1.00@0,-1.00@100"),
                                   setting("source.scan_delay", "0")));
    EXPECT_EQ(options_of(clock), "--scan-delay 1.00@0,-1.00@100");
    read.scan_delay_s = 0.0;
    read.scan_clock = "0@50,2.5@50";
    EXPECT_THAT(WholeValues(read).later_by(0.25),
                ElementsAre(setting("source.scan_clock", "0.25@0,0.25@50,2.75@50")));
}

TEST(WholeValues, AreWrittenAsOneGivesThem) {
    EXPECT_EQ(
        options_of({setting("source.scan_delay", "-1.72"), setting("source.laser_pose", "0,0,180"),
                    setting("source.fan_scale", "0.5")}),
        "--scan-delay -1.72 --laser-pose 0,0,180 --set source.fan_scale=0.5");
    TourFinding finding;
    finding.remedies = {{verbatim("turn it"), {setting("source.odometry_turns", "-1")}},
                        {verbatim("or leave it")}};
    EXPECT_EQ(advice_of(finding).english(), "turn it: --set source.odometry_turns=-1; or leave it");
}

TEST(ScanClock, OnTopOfAnotherAddsWhatBothAdd) {
    for (const std::string_view known : {"", "1@0", "0@0,-3@300", "0@100,2.5@100", "0.5@20,1@80"}) {
        for (const std::string_view more : {"0.3@0", "0@0,1.5@300", "-1@150,0.5@150"}) {
            ScanClock first(known);
            ScanClock second(more);
            ScanClock both = ScanClock(known).plus(ScanClock(more));
            ScanClock written(both.text());
            for (int reading = 0; reading < 427; ++reading) {
                const double stamp_s = 1000.0 + 0.75 * reading;
                const double once_s = first.added(stamp_s);
                const double twice_s = once_s + second.added(stamp_s + once_s);
                EXPECT_NEAR(both.added(stamp_s), twice_s, 2e-2) << known << " + " << more;
                EXPECT_NEAR(written.added(stamp_s), twice_s, 3e-2) << both.text();
            }
        }
    }
}

TEST(OdometryAxes, OneAfterTheOtherIsOne) {
    for (const std::string_view first :
         {"x,y,theta", "y,x,90-theta", "-x,y,theta+30", "y,-x,degrees", "x,y,10-degrees"}) {
        for (const std::string_view then : {"x,y,-theta", "-y,x,theta-45", "y,x,90-theta"}) {
            OdometryAxes one(first);
            OdometryAxes other(then);
            OdometryAxes both = OdometryAxes(first).then(OdometryAxes(then));
            OdometryAxes written(both.text());
            for (int i = 0; i < 50; ++i) {
                const Pose logged{0.3 * i, 1.0 - 0.2 * i * i, 0.05 * i};
                const Pose expected = other.taken(one.taken(logged));
                for (const Pose& found : {both.taken(logged), written.taken(logged)}) {
                    EXPECT_NEAR(found.x, expected.x, 1e-12);
                    EXPECT_NEAR(found.y, expected.y, 1e-12);
                    EXPECT_NEAR(wrap_angle(found.theta - expected.theta), 0.0, 1e-9)
                        << first << " then " << then << ": " << both.text();
                }
            }
        }
    }
    EXPECT_EQ(OdometryAxes("x,y,theta+90").then(OdometryAxes("x,y,degrees")).text(),
              "x,y,degrees+1.571");
    EXPECT_EQ(OdometryAxes("x,y,theta+450").text(), "x,y,theta+90");
    EXPECT_EQ(OdometryAxes("x,-y,theta-12.5").text(), "x,-y,theta-12.5");
}

}  // namespace
}  // namespace hitos
