// SPDX-License-Identifier: GPL-3.0-or-later
// Golden counts of recorded logs, and the poses that they log.
#include <gtest/gtest.h>

#include <map>
#include <ostream>

#include "fields.hpp"
#include "hitos/capture/tour_summary.hpp"
#include "line_reader.hpp"
#include "unit/capture/test_files.hpp"

namespace hitos {
namespace {

using test::Log;

struct Golden {
    const char* file;
    std::string_view format;
    std::uint64_t scans;
    std::uint64_t duplicates;
    std::uint64_t odometry;
    std::uint32_t rays;
    double duration_s;
};

std::ostream& operator<<(std::ostream& out, const Golden& golden) {
    return out << golden.file;
}

TourSummary inspect(const std::filesystem::path& path) {
    Procesador reader(open_log(path));
    return inspect_tour(reader);
}

class RealLog : public ::testing::TestWithParam<Golden> {};

TEST_P(RealLog, HasTheKnownCounts) {
    const Golden& golden = GetParam();
    const auto path = test::shared_log(golden.file);
    HITOS_SKIP_WITHOUT(path);
    const TourSummary summary = inspect(path);
    EXPECT_EQ(summary.format, golden.format);
    EXPECT_EQ(summary.report.scans, golden.scans);
    EXPECT_EQ(summary.report.duplicate_scans, golden.duplicates);
    EXPECT_EQ(summary.report.odometry, golden.odometry);
    EXPECT_EQ(summary.report.skipped, 0U);
    EXPECT_EQ(summary.report.stamps_backwards, 0U);
    EXPECT_EQ(summary.fan.count, golden.rays);
    EXPECT_NEAR(summary.duration_s, golden.duration_s, 0.11);
}

/// The poses of a log by line, taken from its text without the layer's converters.
std::map<std::uint64_t, Pose> logged_poses(const std::filesystem::path& path) {
    std::map<std::uint64_t, Pose> poses;
    LineReader reader(path);
    while (const std::optional<LineReader::Line> line = reader.next()) {
        std::vector<std::string> fields;
        for (Fields walk(line->text); !walk.at_end();) fields.emplace_back(walk.take());
        std::size_t at = 0;
        if (fields.empty() || fields[0].front() == '#') continue;
        if (fields[0] == "ODOM") at = 1;
        if (fields[0] == "FLASER") at = 2 + std::stoul(fields[1]) + 3;
        if (fields[0] == "position") at = 3;
        if (fields.size() == 14 && fields[3] == "position2d") at = 7;
        if (at == 0) continue;
        poses[line->number] = {std::stod(fields[at]), std::stod(fields[at + 1]),
                               std::stod(fields[at + 2])};
    }
    return poses;
}

TEST_P(RealLog, SummedTwistsReproduceEveryLoggedPose) {
    const auto path = test::shared_log(GetParam().file);
    HITOS_SKIP_WITHOUT(path);
    const std::map<std::uint64_t, Pose> poses = logged_poses(path);
    const Log log = test::read_log(path);
    ASSERT_FALSE(poses.empty());
    const std::vector<Pose> sums = test::summed(log.odometry, poses.begin()->second);
    std::size_t reading = 0;
    for (const auto& [line, pose] : poses) {
        // A line that repeats stamp and pose gives no reading: the one before stands for it.
        while (reading + 1 < sums.size() && log.odometry[reading + 1].line <= line) ++reading;
        ASSERT_LE(log.odometry[reading].line, line);
        ASSERT_NEAR(sums[reading].x, pose.x, 1e-9) << line;
        ASSERT_NEAR(sums[reading].y, pose.y, 1e-9) << line;
        ASSERT_NEAR(wrap_angle(sums[reading].theta - pose.theta), 0.0, 1e-9) << line;
    }
    double chords_m = 0.0;
    for (auto it = poses.begin(); std::next(it) != poses.end(); ++it) {
        const Pose& next = std::next(it)->second;
        chords_m += std::hypot(next.x - it->second.x, next.y - it->second.y);
    }
    EXPECT_NEAR(inspect(path).distance_m, chords_m, 0.01 * chords_m);
    for (const Scan& scan : log.scans) {
        if (scan.carries_odometry) {
            ASSERT_TRUE(poses.contains(scan.line));
        }
    }
}

TEST_P(RealLog, StampsOfReadingsIncrease) {
    const auto path = test::shared_log(GetParam().file);
    HITOS_SKIP_WITHOUT(path);
    const Log log = test::read_log(path);
    for (std::size_t i = 1; i < log.odometry.size(); ++i) {
        ASSERT_GT(log.odometry[i].time_s, log.odometry[i - 1].time_s);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Recorded, RealLog,
    ::testing::Values(Golden{"player/recinto.log.gz", "player", 1054, 421, 2108, 181, 210.8},
                      Golden{"player/bigloop.log.gz", "player", 1050, 291, 2102, 181, 210.2},
                      Golden{"player/bigloop2.log.gz", "player", 1357, 426, 2714, 181, 271.4},
                      Golden{"radish/intel.log.gz", "carmen", 910, 0, 14541, 180, 2673.62},
                      Golden{"radish/aces.log.gz", "carmen", 440, 0, 7814, 180, 1350.46},
                      Golden{"radish/aces.a2.log.gz", "radish", 440, 0, 7374, 180, 1350.46},
                      Golden{"radish/freiburg-079.log.gz", "carmen", 4791, 0, 9725, 360, 1061.37},
                      Golden{"radish/freiburg-101.log.gz", "carmen", 292, 0, 4569, 360, 921.04}),
    [](const auto& value) { return "log" + std::to_string(value.index); });

TEST(RealLogs, NoReturnCodesAreNoPoints) {
    for (const char* name : {"intel", "aces", "freiburg-079", "freiburg-101"}) {
        const auto path = test::shared_log(std::string("radish/") + name + ".log.gz");
        HITOS_SKIP_WITHOUT(path);
        double greatest = 0.0;
        for (const Scan& scan : test::read_log(path).scans) {
            for (const Point2& point : scan.points) {
                greatest = std::max(greatest, std::hypot(point.x, point.y));
            }
        }
        EXPECT_LT(greatest, std::string(name) == "aces" ? 49.9 : 81.73) << name;
        EXPECT_GT(greatest, 20.0) << name;
    }
}

TEST(RealLogs, TheRadishTextIsTheSameTour) {
    const auto carmen = test::shared_log("radish/aces.log.gz");
    const auto radish = test::shared_log("radish/aces.a2.log.gz");
    HITOS_SKIP_WITHOUT(carmen);
    HITOS_SKIP_WITHOUT(radish);
    const Log a = test::read_log(carmen);
    const Log b = test::read_log(radish);
    ASSERT_EQ(a.scans.size(), b.scans.size());
    for (std::size_t i = 0; i < a.scans.size(); ++i) {
        ASSERT_EQ(a.scans[i].rays, b.scans[i].rays) << i;
        ASSERT_EQ(a.scans[i].run_starts, b.scans[i].run_starts) << i;
        for (std::size_t k = 0; k < a.scans[i].points.size(); ++k) {
            ASSERT_NEAR(a.scans[i].points[k].x, b.scans[i].points[k].x, 1e-3);
            ASSERT_NEAR(a.scans[i].points[k].y, b.scans[i].points[k].y, 1e-3);
        }
    }
}

}  // namespace
}  // namespace hitos
