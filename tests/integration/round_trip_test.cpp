// SPDX-License-Identifier: GPL-3.0-or-later
// Recorded logs through the writers and back.
#include <gtest/gtest.h>

#include "hitos/capture/log_writer.hpp"
#include "unit/capture/test_files.hpp"

namespace hitos {
namespace {

using test::Log;
using test::TempDir;

/// Both sequences in the order of time, as a converter of files gives them to the writer.
void write_merged(const Log& log, LogWriter& writer) {
    std::size_t next = 0;
    for (const Odometria& reading : log.odometry) {
        while (next < log.scans.size() && log.scans[next].time_s < reading.time_s) {
            writer.write(log.scans[next++]);
        }
        writer.write(reading);
    }
    while (next < log.scans.size()) writer.write(log.scans[next++]);
    writer.finish();
}

class RoundTrip : public ::testing::TestWithParam<const char*> {};

TEST_P(RoundTrip, ThroughTheNormalizedFormatToTheLastBit) {
    const auto source = test::shared_log(GetParam());
    HITOS_SKIP_WITHOUT(source);
    const TempDir folder;
    const Log log = test::read_log(source);
    write_merged(log, *make_log_writer("normalized", folder / "n.log"));
    const Log again = test::read_log(folder / "n.log");
    EXPECT_EQ(again.report.skipped, 0U);
    EXPECT_EQ(again.report.stamps_backwards, 0U);
    EXPECT_EQ(again.report.duplicate_scans, 0U);
    ASSERT_EQ(again.scans.size(), log.scans.size());
    for (std::size_t i = 0; i < log.scans.size(); ++i) {
        ASSERT_EQ(again.scans[i].points, log.scans[i].points) << i;
        ASSERT_EQ(again.scans[i].run_starts, log.scans[i].run_starts) << i;
        if (log.report.stamps_backwards == 0) {
            ASSERT_EQ(again.scans[i].time_s, log.scans[i].time_s);
        }
    }
    ASSERT_EQ(again.odometry.size(), log.odometry.size());
    for (std::size_t i = 0; i < log.odometry.size(); ++i) {
        ASSERT_EQ(again.odometry[i].time_s, log.odometry[i].time_s) << i;
        ASSERT_EQ(again.odometry[i].twist, log.odometry[i].twist) << i;
    }
    write_merged(again, *make_log_writer("normalized", folder / "n2.log"));
    EXPECT_EQ(test::content(folder / "n2.log"), test::content(folder / "n.log"));
}

TEST_P(RoundTrip, ThroughTheOtherFormatsToTheirDecimals) {
    const auto source = test::shared_log(GetParam());
    HITOS_SKIP_WITHOUT(source);
    const TempDir folder;
    const Log log = test::read_log(source);
    const Pose end = test::summed(log.odometry).back();
    for (const std::string format : {"player", "radish", "carmen"}) {
        SCOPED_TRACE(format);
        write_merged(log, *make_log_writer(format, folder / "x.log"));
        const Log again = test::read_log(folder / "x.log");
        EXPECT_EQ(again.report.skipped, 0U);
        ASSERT_EQ(again.scans.size(), log.scans.size());
        for (std::size_t i = 0; i < log.scans.size(); ++i) {
            ASSERT_EQ(again.scans[i].rays, log.scans[i].rays) << i;
            ASSERT_EQ(again.scans[i].run_starts, log.scans[i].run_starts) << i;
            for (std::size_t k = 0; k < log.scans[i].points.size(); ++k) {
                const Point2& point = log.scans[i].points[k];
                // Half a unit of the range's digits, and bearings of five decimals.
                const double tolerance = 1e-4 + 2e-5 * std::hypot(point.x, point.y);
                test::expect_near(again.scans[i].points[k], point, tolerance);
            }
        }
        test::expect_near(test::summed(again.odometry).back(), end, 3e-6);
    }
}

/// Back from MCAP: ranges are floats there, and angles, of which those of the last ray are as wrong
/// as all steps together. A radish log says each bearing, up to 1e-4 rad beside its ray.
void expect_same_but_for_floats(const Log& log, const Log& again, const std::string& name) {
    const double beside_rad = name.find("radish") == std::string::npos ? 3e-7 : 1e-4;
    EXPECT_EQ(again.report.skipped, 0U);
    EXPECT_EQ(again.report.duplicate_scans, 0U);
    EXPECT_EQ(again.report.stamps_backwards, 0U);
    ASSERT_EQ(again.scans.size(), log.scans.size());
    for (std::size_t i = 0; i < log.scans.size(); ++i) {
        ASSERT_NEAR(again.scans[i].time_s, log.scans[i].time_s, 1e-9) << i;
        if (!log.scans[i].rays.empty()) {
            ASSERT_EQ(again.scans[i].rays, log.scans[i].rays) << i;
        }
        ASSERT_EQ(again.scans[i].run_starts, log.scans[i].run_starts) << i;
        ASSERT_EQ(again.scans[i].points.size(), log.scans[i].points.size()) << i;
        for (std::size_t k = 0; k < log.scans[i].points.size(); ++k) {
            const Point2& point = log.scans[i].points[k];
            test::expect_near(again.scans[i].points[k], point,
                              2e-7 + beside_rad * std::hypot(point.x, point.y));
        }
    }
    ASSERT_EQ(again.odometry.size(), log.odometry.size());
    const std::vector<Pose> poses = test::summed(log.odometry);
    const std::vector<Pose> poses_again = test::summed(again.odometry);
    for (std::size_t i = 0; i < poses.size(); ++i) {
        ASSERT_NEAR(again.odometry[i].time_s, log.odometry[i].time_s, 1e-9) << i;
        test::expect_near(poses_again[i], poses[i], 1e-9, std::to_string(i));
    }
}

Log through_mcap(const Log& log, const ReadOptions& options = {}) {
    const TempDir folder;
    write_merged(log, *make_log_writer("mcap", folder / "tour.mcap"));
    return test::read_log(folder / "tour.mcap", kAutoFormat, options);
}

TEST_P(RoundTrip, ThroughMcapToFloats) {
    const auto source = test::shared_log(GetParam());
    HITOS_SKIP_WITHOUT(source);
    const Log log = test::read_log(source);
    expect_same_but_for_floats(log, through_mcap(log), GetParam());
}

class ShippedThroughMcap : public ::testing::TestWithParam<const char*> {};

TEST_P(ShippedThroughMcap, ComesBack) {
    const Log log = test::read_log(std::filesystem::path(HITOS_SOURCE_DIR) / "data" / GetParam());
    ASSERT_FALSE(log.scans.empty());
    expect_same_but_for_floats(log, through_mcap(log), GetParam());
    // The velocities that stand there are the twists: read as such they are those of the log.
    ReadOptions logged;
    logged.odometry = OdometryFrom::velocities;
    const Log again = through_mcap(log, logged);
    ASSERT_EQ(again.odometry.size(), log.odometry.size());
    for (std::size_t i = 0; i < log.odometry.size(); ++i) {
        ASSERT_EQ(again.odometry[i].twist, log.odometry[i].twist) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Shipped, ShippedThroughMcap,
                         ::testing::Values("bigloop.log.gz", "bigloop-noisy.log.gz",
                                           "logs/carmen-flaser.log.gz",
                                           "logs/carmen-rawlaser.log.gz",
                                           "logs/carmen-robotlaser.log.gz",
                                           "logs/normalized.log.gz", "logs/player-laser.log.gz",
                                           "logs/player-ranger.log.gz", "logs/radish.log.gz"),
                         [](const auto& value) { return "log" + std::to_string(value.index); });

INSTANTIATE_TEST_SUITE_P(Recorded, RoundTrip,
                         ::testing::Values("player/bigloop.log.gz", "player/recinto.log.gz",
                                           "radish/intel.log.gz", "radish/aces.a2.log.gz",
                                           "radish/freiburg-101.log.gz"),
                         [](const auto& value) { return "log" + std::to_string(value.index); });

}  // namespace
}  // namespace hitos
