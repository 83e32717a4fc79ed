// SPDX-License-Identifier: GPL-3.0-or-later
// Golden figures of the logs in data/logs, one of every dialect that is read.
#include <gtest/gtest.h>

#include <ostream>

#include "hitos/capture/tour_summary.hpp"
#include "unit/capture/test_files.hpp"

namespace hitos {
namespace {

using test::Log;

struct ShippedGolden {
    const char* name;
    std::string_view format;
    std::uint64_t odometry;
    std::size_t points;  ///< of all scans
    double sum_x_m;      ///< of all points, in the robot's frame
    double sum_y_m;
    Pose last;  ///< by odometry alone
    std::uint32_t rays;
    bool carries_odometry;
};

std::ostream& operator<<(std::ostream& out, const ShippedGolden& golden) {
    return out << golden.name;
}

Log shipped_log(const std::string& name) {
    return test::read_log(std::filesystem::path(HITOS_SOURCE_DIR) / "data/logs" /
                          (name + ".log.gz"));
}

constexpr Pose kLast{0.611765, 3.300868, 1.514884};

class ShippedLog : public ::testing::TestWithParam<ShippedGolden> {};

TEST_P(ShippedLog, HasTheKnownFigures) {
    const ShippedGolden& golden = GetParam();
    const auto path = std::filesystem::path(HITOS_SOURCE_DIR) / "data/logs" /
                      (std::string(golden.name) + ".log.gz");
    EXPECT_EQ(open_log(path)->format().word, golden.format);
    const Log log = shipped_log(golden.name);
    EXPECT_EQ(log.report.skipped, 0U);
    EXPECT_EQ(log.report.duplicate_scans, 0U);
    EXPECT_EQ(log.report.stamps_backwards, 0U);
    ASSERT_EQ(log.scans.size(), 50U);
    EXPECT_EQ(log.odometry.size(), golden.odometry);
    EXPECT_NEAR(log.scans.front().time_s, 0.0, 1e-9);
    EXPECT_NEAR(log.scans.back().time_s, 9.8, 1e-9);
    EXPECT_NEAR(log.odometry.back().time_s, 9.8, 1e-9);
    EXPECT_EQ(log.scans.front().fan.count, golden.rays);
    EXPECT_EQ(log.scans.front().carries_odometry, golden.carries_odometry);
    test::expect_near(test::summed(log.odometry).back(), golden.last, 1e-5);
    std::size_t points = 0;
    Point2 sum;
    for (const Scan& scan : log.scans) {
        points += scan.points.size();
        for (const Point2& p : scan.points) sum = {sum.x + p.x, sum.y + p.y};
    }
    EXPECT_EQ(points, golden.points);
    EXPECT_NEAR(sum.x, golden.sum_x_m, 0.01);
    EXPECT_NEAR(sum.y, golden.sum_y_m, 0.01);
}

INSTANTIATE_TEST_SUITE_P(
    All, ShippedLog,
    ::testing::Values(
        ShippedGolden{"player-laser", "player", 99, 4864, 12557.976, 1636.410, kLast, 181, false},
        ShippedGolden{"player-ranger", "player", 99, 4864, 12557.976, 1636.410, kLast, 181, false},
        ShippedGolden{"radish", "radish", 99, 4864, 12557.976, 1636.410, kLast, 181, false},
        ShippedGolden{"normalized", "normalized", 99, 4864, 12557.976, 1636.410, kLast, 0, false},
        ShippedGolden{"carmen-flaser", "carmen", 99, 4864, 12557.976, 1636.410, kLast, 181, true},
        ShippedGolden{"carmen-robotlaser", "carmen", 99, 4882, 8749.417, 1115.614, kLast, 161,
                      true},
        ShippedGolden{"carmen-rawlaser", "carmen", 99, 4882, 8749.417, 1115.614, kLast, 161,
                      false}),
    [](const auto& value) {
        std::string name = value.param.name;
        std::ranges::replace(name, '-', '_');
        return name;
    });

void expect_same_points(const std::string& a, const std::string& b, double tolerance) {
    const Log one = shipped_log(a);
    const Log other = shipped_log(b);
    ASSERT_EQ(one.scans.size(), other.scans.size());
    for (std::size_t i = 0; i < one.scans.size(); ++i) {
        ASSERT_EQ(one.scans[i].run_starts, other.scans[i].run_starts) << a << ' ' << b << ' ' << i;
        ASSERT_EQ(one.scans[i].points.size(), other.scans[i].points.size());
        for (std::size_t k = 0; k < one.scans[i].points.size(); ++k) {
            test::expect_near(one.scans[i].points[k], other.scans[i].points[k], tolerance);
        }
    }
}

TEST(ShippedLogs, AllDialectsTellOneTour) {
    for (const char* name : {"player-ranger", "radish", "normalized", "carmen-flaser"}) {
        expect_same_points("player-laser", name, 2e-4);
    }
    expect_same_points("carmen-robotlaser", "carmen-rawlaser", 1e-5);
}

}  // namespace
}  // namespace hitos
