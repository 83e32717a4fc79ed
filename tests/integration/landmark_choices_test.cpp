// SPDX-License-Identifier: GPL-3.0-or-later
// Bounded lines and vanishing landmarks on simulated tours, with the odometry's truth.
#include <gtest/gtest.h>

#include <filesystem>

#include "hitos/features/extractor.hpp"
#include "hitos/simulation/drive/simulated_tour.hpp"
#include "hitos/slam/filters.hpp"

namespace hitos {
namespace {

World world_of(const char* name) {
    return read_world(std::filesystem::path(HITOS_SOURCE_DIR) / "tests/worlds" /
                      (std::string(name) + ".toml"));
}

ExtractionParams extraction() {
    ExtractionParams params;
    params.detect = Detection::lines;
    params.lines.min_length_m = 0.4;
    params.lines.min_points = 9;
    params.lines.collinear.gap_m = 0.5;
    params.split_merge.dmax_m = 0.04;
    params.split_merge.fit = LineFit::least_squares;
    return params;
}

FilterParams filter_params() {
    FilterParams params;
    params.particles = 20;
    params.motion.model = "proportional";
    params.motion.var_along_m2_per_m = params.motion.var_across_m2_per_m = 1e-5;
    params.motion.var_theta_rad2_per_rad = params.motion.var_theta_rad2_per_m = 1e-5;
    return params;
}

void drive(const World& world, SlamFilter& filter) {
    const SimulatedTour tour(world);
    const auto extractor = make_extractor(extraction());
    Observation seen;
    for (std::uint64_t k = 0; k < tour.scans(); ++k) {
        std::vector<Control> controls;
        if (k > 0) {
            const double seconds = tour.scan_time(k) - tour.scan_time(k - 1);
            const Pose driven = between(tour.true_pose(k - 1), tour.true_pose(k));
            controls.push_back({twist_between(driven, seconds), seconds});
        }
        const Scan scan = tour.scan(k);
        extractor->extract(scan, seen);
        filter.step({scan, controls, seen});
    }
}

/// Landmarks near a line of the world, whose frame the start leaves.
int count_near(const SlamFilter& filter, const World& world, const Recta& line) {
    const Recta expected = transform(inverse(world.tour.start), line);
    int count = 0;
    for (const ICaracteristica& landmark : filter.best_map()) {
        const LineDifference away = difference(std::get<Recta>(landmark.value), expected);
        if (away.rho < 0.07 && away.theta < 0.03) ++count;
    }
    return count;
}

TEST(LandmarkChoices, AWallWithADoorIsTwoBoundedLinesOnEachSide) {
    World world = world_of("door");
    world.tour.laps = 1;
    for (const bool segments : {false, true}) {
        FilterParams params = filter_params();
        params.association.segments = segments;
        const auto filter = make_filter(params, 1, 1);
        drive(world, *filter);
        const int western = count_near(*filter, world, {6.9, 0.0});
        const int eastern = count_near(*filter, world, {7.1, 0.0});
        EXPECT_EQ(western + eastern, segments ? 4 : 1);
        EXPECT_EQ(western, segments ? 2 : western);
    }
}

TEST(LandmarkChoices, AScreenThatIsMovedVanishes) {
    const World before = world_of("screen_before");
    World after = world_of("screen_after");
    const SimulatedTour first(before);
    after.tour.start = compose(before.tour.start, first.true_pose(first.scans() - 1));
    for (const bool vanish : {false, true}) {
        FilterParams params = filter_params();
        params.landmarks.vanish = vanish;
        const auto filter = make_filter(params, 1, 1);
        drive(before, *filter);
        EXPECT_GE(count_near(*filter, before, {2.55, 0.0}), 1);
        drive(after, *filter);
        EXPECT_EQ(count_near(*filter, before, {2.55, 0.0}) > 0, !vanish);
        EXPECT_GE(count_near(*filter, before, {5.05, 0.0}), 1);
        // The room itself stays.
        for (const Recta& wall :
             {Recta{1.0, kPi}, Recta{8.0, 0.0}, Recta{1.0, -kPi / 2.0}, Recta{6.0, kPi / 2.0}}) {
            EXPECT_EQ(count_near(*filter, before, wall), 1);
        }
    }
}

}  // namespace
}  // namespace hitos
