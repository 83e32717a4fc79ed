// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/features/control.hpp"

#include <gtest/gtest.h>

#include <deque>

namespace hitos {
namespace {

ControlTrack track_of(std::deque<Odometria> readings) {
    return ControlTrack([readings = std::move(readings)]() mutable -> std::optional<Odometria> {
        if (readings.empty()) return std::nullopt;
        const Odometria first = readings.front();
        readings.pop_front();
        return first;
    });
}

Scan scan_at(double time_s) {
    Scan scan;
    scan.time_s = time_s;
    return scan;
}

Odometria reading(double time_s, double v, double w, std::uint64_t line = 0) {
    return {time_s, {v, 0.0, w}, line};
}

TEST(ControlTrack, DividesTheReadingThatSpansAScan) {
    auto track = track_of({reading(0.0, 0, 0), reading(1.0, 1.0, 0.1), reading(2.0, 2.0, 0.2)});
    std::vector<Control> controls;
    track.controls_until(scan_at(0.25), controls);
    ASSERT_EQ(controls.size(), 1U);
    EXPECT_EQ(controls[0], (Control{{1.0, 0.0, 0.1}, 0.25}));
    track.controls_until(scan_at(1.5), controls);
    ASSERT_EQ(controls.size(), 2U);
    EXPECT_EQ(controls[0], (Control{{1.0, 0.0, 0.1}, 0.75}));
    EXPECT_EQ(controls[1], (Control{{2.0, 0.0, 0.2}, 0.5}));
    track.controls_until(scan_at(9.0), controls);  // beyond the log: what is left, then nothing
    ASSERT_EQ(controls.size(), 1U);
    EXPECT_EQ(controls[0], (Control{{2.0, 0.0, 0.2}, 0.5}));
    track.controls_until(scan_at(10.0), controls);
    EXPECT_TRUE(controls.empty());
}

TEST(ControlTrack, AReadingAtTheScansTimeIsUsedWhole) {
    auto track = track_of({reading(0.0, 0, 0), reading(1.0, 1.0, 0.0), reading(2.0, 3.0, 0.0)});
    std::vector<Control> controls;
    track.controls_until(scan_at(1.0), controls);
    ASSERT_EQ(controls.size(), 1U);
    EXPECT_EQ(controls[0].duration_s, 1.0);
    track.controls_until(scan_at(1.0), controls);
    EXPECT_TRUE(controls.empty());
}

TEST(ControlTrack, AScanBeforeAnyOdometryHasNoControl) {
    auto track = track_of({reading(5.0, 0, 0), reading(6.0, 1.0, 0.0)});
    std::vector<Control> controls;
    track.controls_until(scan_at(1.0), controls);
    EXPECT_TRUE(controls.empty());
    track.controls_until(scan_at(5.5), controls);
    ASSERT_EQ(controls.size(), 1U);
    EXPECT_EQ(controls[0].duration_s, 0.5);
}

TEST(ControlTrack, AScanThatGoesBackInTimeGetsNoControlAndLosesNone) {
    auto track = track_of({reading(0.0, 0, 0), reading(1.0, 1.0, 0.0), reading(2.0, 1.0, 0.0)});
    std::vector<Control> controls;
    track.controls_until(scan_at(1.5), controls);
    track.controls_until(scan_at(1.2), controls);
    EXPECT_TRUE(controls.empty());
    track.controls_until(scan_at(2.0), controls);
    ASSERT_EQ(controls.size(), 1U);
    EXPECT_DOUBLE_EQ(controls[0].duration_s, 0.5);
}

TEST(ControlTrack, AScanWithItsOwnOdometryGoesByLine) {
    // The stamps say that the second scan (line 4) was taken before its own odometry.
    auto track = track_of({reading(0.0, 0, 0, 1), reading(1.0, 1.0, 0, 2),
                           reading(1.001, 5.0, 0, 4), reading(2.0, 1.0, 0, 5)});
    Scan scan = scan_at(0.4);
    scan.line = 4;
    scan.carries_odometry = true;
    std::vector<Control> controls;
    track.controls_until(scan, controls);
    ASSERT_EQ(controls.size(), 2U);
    EXPECT_EQ(controls[0].duration_s, 1.0);
    EXPECT_NEAR(controls[1].duration_s, 0.001, 1e-12);
    scan.line = 5;
    track.controls_until(scan, controls);
    ASSERT_EQ(controls.size(), 1U);
}

TEST(ControlTrack, DurationsSumToTheTimeCovered) {
    std::deque<Odometria> readings;
    for (int i = 0; i <= 100; ++i) readings.push_back(reading(0.1 * i, 0.5, 0.01 * i));
    auto track = track_of(readings);
    std::vector<Control> controls;
    double total = 0.0;
    double path = 0.0;
    for (int i = 0; i < 58; ++i) {
        const double t = 0.173 * i;
        track.controls_until(scan_at(t), controls);
        for (const Control& control : controls) {
            total += control.duration_s;
            path += control.duration_s * control.twist.v;
        }
        EXPECT_NEAR(total, t, 1e-9);
        EXPECT_NEAR(path, 0.5 * t, 1e-9);
    }
}

}  // namespace
}  // namespace hitos
