// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings by other programs give the scans and poses of the logs that they were made from.
#include <gtest/gtest.h>

#include <map>
#include <ostream>

#include "hitos/capture/log_format.hpp"
#include "unit/capture/test_files.hpp"

namespace hitos {
namespace {

using test::Log;

/// What NOTES.md of the recordings says that they hold.
struct RecordingGolden {
    const char* recording;
    const char* format;
    const char* log;
    std::size_t scans;
    std::size_t odometry;
    friend std::ostream& operator<<(std::ostream& out, const RecordingGolden& golden) {
        return out << golden.recording;
    }
};

class RosRecording : public ::testing::TestWithParam<RecordingGolden> {};

/// Poses by stamp.
std::map<std::int64_t, Pose> poses_of(const Log& log) {
    std::map<std::int64_t, Pose> poses;
    const std::vector<Pose> sums = test::summed(log.odometry);
    for (std::size_t i = 0; i < sums.size(); ++i) {
        poses[std::llround(log.odometry[i].time_s * 1e6)] = sums[i];
    }
    return poses;
}

void expect_scan_of_log(const Scan& scan, const Scan& logged) {
    ASSERT_EQ(scan.rays, logged.rays) << scan.time_s;
    ASSERT_EQ(scan.run_starts, logged.run_starts) << scan.time_s;
    ASSERT_EQ(scan.fan.count, logged.fan.count);
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
        test::expect_near(scan.points[i], logged.points[i], 5e-5);  // angles of four decimals
    }
}

TEST_P(RosRecording, GivesTheScansAndPosesOfItsLog) {
    const RecordingGolden& golden = GetParam();
    const auto path = test::shared_log(std::string("ros/") + golden.recording);
    const auto log_path = test::shared_log(golden.log);
    HITOS_SKIP_WITHOUT(path);
    HITOS_SKIP_WITHOUT(log_path);
    const Log recorded = test::read_log(path);
    EXPECT_EQ(open_log(path)->format().word, golden.format);
    EXPECT_EQ(recorded.scans.size(), golden.scans);
    EXPECT_EQ(recorded.odometry.size(), golden.odometry);
    EXPECT_EQ(recorded.report.skipped, 0U);
    EXPECT_EQ(recorded.report.duplicate_scans, 0U);
    EXPECT_EQ(recorded.report.stamps_backwards, 0U);

    const Log logged = test::read_log(log_path);
    ASSERT_LE(recorded.scans.size(), logged.scans.size());
    for (std::size_t i = 0; i < recorded.scans.size(); ++i) {
        ASSERT_NEAR(recorded.scans[i].time_s, logged.scans[i].time_s, 1e-6) << i;
        ASSERT_NO_FATAL_FAILURE(expect_scan_of_log(recorded.scans[i], logged.scans[i]));
    }
    // Every reading's pose is one of the log at that stamp; both begin with the same one.
    const std::map<std::int64_t, Pose> poses = poses_of(logged);
    std::size_t found = 0;
    for (const auto& [stamp_us, pose] : poses_of(recorded)) {
        const auto same = poses.find(stamp_us);
        if (same == poses.end()) continue;  // 0.1 ms before a scan
        ++found;
        test::expect_near(pose, same->second, 1e-6, std::to_string(stamp_us));
    }
    EXPECT_GT(found, golden.odometry / 2);
}

constexpr const char* kFreiburg = "radish/freiburg-101.log.gz";
constexpr const char* kBigloop = "player/bigloop.log.gz";

INSTANTIATE_TEST_SUITE_P(
    Recorded, RosRecording,
    ::testing::Values(
        RecordingGolden{"freiburg-101.bag", "rosbag", kFreiburg, 292, 957},
        RecordingGolden{"freiburg-101.bz2.bag", "rosbag", kFreiburg, 292, 957},
        RecordingGolden{"freiburg-101.lz4.bag", "rosbag", kFreiburg, 292, 957},
        RecordingGolden{"freiburg-101_mcap", "rosbag2", kFreiburg, 292, 957},
        RecordingGolden{"freiburg-101_mcap_zstd", "rosbag2", kFreiburg, 292, 957},
        RecordingGolden{"freiburg-101_mcap_lz4", "rosbag2", kFreiburg, 292, 957},
        RecordingGolden{"freiburg-101_db3", "rosbag2", kFreiburg, 292, 957},
        RecordingGolden{"bigloop-lap1.bag", "rosbag", kBigloop, 550, 1100},
        RecordingGolden{"bigloop.bz2.bag", "rosbag", kBigloop, 1050, 2102},
        RecordingGolden{"bigloop.lz4.bag", "rosbag", kBigloop, 1050, 2102},
        RecordingGolden{"bigloop-lap1_mcap", "rosbag2", kBigloop, 550, 1100},
        RecordingGolden{"bigloop-lap1_mcap/bigloop-lap1_mcap_0.mcap", "mcap", kBigloop, 550, 1100},
        RecordingGolden{"bigloop_mcap_zstd", "rosbag2", kBigloop, 1050, 2102},
        RecordingGolden{"bigloop_mcap_lz4", "rosbag2", kBigloop, 1050, 2102},
        RecordingGolden{"bigloop-lap1_db3", "rosbag2", kBigloop, 550, 1100},
        RecordingGolden{"freiburg-101_db3/freiburg-101_db3_0.db3", "db3", kFreiburg, 292, 957}),
    [](const auto& value) { return "recording" + std::to_string(value.index); });

/// The difficult ones: two lasers whose halves are the source's fan.
struct Halves {
    const char* recording;
    const char* log;

    std::size_t front;
    std::size_t rear;
    std::size_t odometry;
    std::size_t finite;
    std::size_t early_front;  ///< before the odometry
    std::size_t early_rear;
    friend std::ostream& operator<<(std::ostream& out, const Halves& halves) {
        return out << halves.recording;
    }
};

class TwoLasers : public ::testing::TestWithParam<Halves> {
  protected:
    Log read(const std::string& topics) const {
        ReadOptions options;
        options.scan_topic = topics;
        Procesador reader(open_log(path_, kAutoFormat, options), options);
        return test::read_all(reader);
    }
    const std::filesystem::path path_ =
        test::shared_log(std::string("ros/") + GetParam().recording);
};

TEST_P(TwoLasers, AreRefusedWhereNoneIsChosen) {
    HITOS_SKIP_WITHOUT(path_);
    EXPECT_THROW(open_log(path_), ConfigError);
}

TEST_P(TwoLasers, GiveWhatEachSaw) {
    HITOS_SKIP_WITHOUT(path_);
    const Halves& halves = GetParam();
    std::size_t points = 0;
    for (const char* topic : {"/scan_front", "/scan_rear"}) {
        const Log log = read(topic);
        EXPECT_EQ(log.scans.size(), topic[6] == 'f' ? halves.front : halves.rear) << topic;
        EXPECT_EQ(log.odometry.size(), halves.odometry);
        EXPECT_EQ(log.report.skipped, 0U);
        EXPECT_EQ(log.report.early_scans, topic[6] == 'f' ? halves.early_front : halves.early_rear);
        for (const Scan& scan : log.scans) {
            points += scan.points.size();
            EXPECT_NEAR(scan.fan.pose_robot_laser.x, 0.20, 1e-9);
            EXPECT_NEAR(scan.fan.pose_robot_laser.y, 0.05, 1e-9);
        }
        EXPECT_TRUE(std::ranges::is_sorted(log.scans, {}, &Scan::time_s));
    }
    EXPECT_EQ(points, halves.finite);
}

// Every point is that of the source's beam, moved by the mounting; what the other knows better
// (NaN, a beam fewer) may be missing.
TEST_P(TwoLasers, TogetherGiveTheFanOfTheLog) {
    HITOS_SKIP_WITHOUT(path_);
    const auto log_path = test::shared_log(GetParam().log);
    HITOS_SKIP_WITHOUT(log_path);
    std::map<std::int64_t, Scan> logged;
    for (Scan& scan : test::read_log(log_path).scans) {
        logged.emplace(std::llround(scan.time_s * 1e4), std::move(scan));
    }
    const Log both = read("all");
    std::size_t points = 0;
    std::size_t merged = 0;
    for (const Scan& scan : both.scans) {
        const auto same = logged.find(std::llround((scan.time_s - 1.7e9) * 1e4));
        ASSERT_NE(same, logged.end()) << scan.time_s;
        const Scan& source = same->second;
        const Pose& mount = source.fan.pose_robot_laser;
        std::map<std::int64_t, double> by_angle;
        for (const Point2& p : source.points) {
            const double x = p.x - mount.x;
            const double y = p.y - mount.y;
            by_angle[std::llround(std::atan2(y, x) * 1e4)] = std::hypot(x, y);
        }
        points += scan.points.size();
        if (scan.fan.count > source.fan.count / 2 + 1) ++merged;
        for (const Point2& p : scan.points) {
            const double x = p.x - 0.20;
            const double y = p.y - 0.05;
            const std::int64_t angle = std::llround(std::atan2(y, x) * 1e4);
            auto beam = by_angle.lower_bound(angle - 2);
            ASSERT_TRUE(beam != by_angle.end() && beam->first <= angle + 2) << scan.time_s;
            ASSERT_NEAR(std::hypot(x, y), beam->second, 1e-5) << scan.time_s;
        }
    }
    EXPECT_LE(points, GetParam().finite);
    EXPECT_GT(points, GetParam().finite * 99 / 100);  // the middle beam may be in both
    EXPECT_GT(merged, both.scans.size() / 2);
}

INSTANTIATE_TEST_SUITE_P(
    Recorded, TwoLasers,
    ::testing::Values(Halves{"two-lasers.bag", kBigloop, 181, 173, 321, 27050, 36, 35},
                      Halves{"two-lasers_mcap", kFreiburg, 45, 42, 132, 14429, 6, 6}),
    [](const auto& value) { return "two" + std::to_string(value.index); });

}  // namespace
}  // namespace hitos
