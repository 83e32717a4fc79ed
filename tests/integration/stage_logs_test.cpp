// SPDX-License-Identifier: GPL-3.0-or-later
// The simulated laser against the recorded one: logs of the genuine Player/Stage in the same
// worlds, whose odometry is the true pose (shared data, skipped where absent).
#include <cmath>
#include <iostream>

#include "hitos/capture/archivo.hpp"
#include "hitos/capture/procesador.hpp"
#include "hitos/features/control.hpp"
#include "hitos/simulation/laser/simulated_laser.hpp"
#include "unit/simulation/worlds.hpp"

namespace hitos {
namespace {

class StageLog : public ::testing::TestWithParam<std::string> {};

// A ray is compared where it hits the inside of a wall: its two neighbours end on the same wall.
// Beside an edge or at the greatest range a pose rounded to 1 mm and 1 mrad decides which of two
// very different ranges is measured, and that is no error of either laser. All other rays count,
// at whatever range and angle.
TEST_P(StageLog, RangesAgreeWithinTheGridOfStage) {
    const auto path =
        std::filesystem::path(HITOS_SHARED_DIR) / "data/player" / (GetParam() + ".log.gz");
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is absent";
    const World world = test::shipped(GetParam());
    Procesador reader(open_log(path));
    ControlTrack track([&] { return reader.next_odometry(); });
    std::vector<Control> controls;
    Pose pose;
    std::vector<RayHit> hits;
    double sum = 0.0;
    double squares = 0.0;
    long compared = 0;
    long readings = 0;
    long far_off = 0;
    while (const auto scan = reader.next_scan()) {
        track.controls_until(*scan, controls);
        for (const Control& control : controls)
            pose = compose(pose, displacement(control.twist, control.duration_s));
        const SimulatedLaser laser(world.walls, scan->fan);
        laser.cast(pose, hits);
        for (std::size_t i = 0; i < scan->points.size(); ++i) {
            const std::uint32_t ray = scan->rays[i];
            ++readings;
            if (ray == 0 || ray + 1 >= hits.size()) continue;
            const int wall = hits[ray].segment;
            if (wall < 0 || hits[ray - 1].segment != wall || hits[ray + 1].segment != wall)
                continue;
            const double error =
                std::hypot(scan->points[i].x, scan->points[i].y) - hits[ray].range_m;
            ++compared;
            sum += error;
            squares += error * error;
            if (std::abs(error) > 0.1) ++far_off;
        }
    }
    ASSERT_GT(compared, 50'000);
    const auto n = static_cast<double>(compared);
    const double mean = sum / n;
    const double sigma = std::sqrt(squares / n - mean * mean);
    std::cout << GetParam() << ": " << compared << " of " << readings << " readings, mean "
              << 1000.0 * mean << " mm, sigma " << 1000.0 * sigma << " mm, " << far_off
              << " off by more than 0.1 m\n";
    EXPECT_LT(std::abs(mean), 0.01);
    EXPECT_LT(sigma, 0.015);
    EXPECT_GT(n / static_cast<double>(readings), 0.9);
    // Stage's grid lets a few rays that graze a wall slip along it.
    EXPECT_LT(static_cast<double>(far_off) / n, 5e-4);
}

INSTANTIATE_TEST_SUITE_P(All, StageLog, ::testing::Values("recinto", "bigloop", "bigloop2"),
                         [](const auto& log) { return log.param; });

}  // namespace
}  // namespace hitos
