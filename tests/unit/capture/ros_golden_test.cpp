// SPDX-License-Identifier: GPL-3.0-or-later
// Two seconds of a recording by ROS's own Python library: two-lasers-cut.bag is cut out of
// two-lasers.bag of the shared data (made from the Player log bigloop, under its terms), messages
// and connections as they stood there, in one chunk.
#include <gmock/gmock.h>

#include "unit/capture/test_files.hpp"

namespace hitos {
namespace {

using test::Log;

const std::filesystem::path kCut =
    std::filesystem::path(HITOS_SOURCE_DIR) / "tests/unit/capture/two-lasers-cut.bag";

Log read_recording(const std::string& topics) {
    ReadOptions options;
    options.scan_topic = topics;
    Procesador reader(open_log(kCut, kAutoFormat, options), options);
    return test::read_all(reader);
}

TEST(RosGolden, TwoLasersOfABag) {
    std::size_t points = 0;
    for (const char* topic : {"/scan_front", "/scan_rear"}) {
        const Log log = read_recording(topic);
        EXPECT_EQ(log.scans.size(), 9U);
        EXPECT_EQ(log.odometry.size(), 15U);
        EXPECT_EQ(log.report.skipped, 0U);
        EXPECT_EQ(log.report.stamps_backwards, 0U);
        EXPECT_TRUE(std::ranges::is_sorted(log.scans, {}, &Scan::time_s));
        for (const Scan& scan : log.scans) points += scan.points.size();
        // base_footprint -> base_link -> laser; the rear one hangs upside down.
        test::expect_near(log.scans.front().fan.pose_robot_laser,
                          {0.20, 0.05, topic[6] == 'f' ? -kPi / 4.0 : kPi / 4.0}, 1e-9);
        EXPECT_GT(log.scans.front().time_s, 1.7e9 + 11.0);
    }
    EXPECT_EQ(points, 1243U);
}

TEST(RosGolden, TwoLasersAsOneSensor) {
    const Log log = read_recording("all");
    EXPECT_EQ(log.scans.size(), 11U);
    std::size_t whole = 0;
    for (const Scan& scan : log.scans) {
        if (scan.fan.count == 181) ++whole;
        test::expect_near({scan.fan.pose_robot_laser.x, scan.fan.pose_robot_laser.y},
                          Point2{0.20, 0.05}, 1e-9);
    }
    EXPECT_EQ(whole, 7U);  // the others lack one half
}

}  // namespace
}  // namespace hitos
