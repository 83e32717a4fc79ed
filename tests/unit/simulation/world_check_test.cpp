// SPDX-License-Identifier: GPL-3.0-or-later
// Whether start, room and tour of a world are sound.
#include "hitos/simulation/drive/world_check.hpp"

#include <cmath>

#include "worlds.hpp"

namespace hitos {
namespace {

TEST(WorldCheck, TheShippedWorldsAreGood) {
    for (const std::string& name : test::shipped_names()) {
        const WorldCheck check = check_world(test::shipped(name));
        EXPECT_TRUE(check.good()) << name << check.tour_problem.english();
        EXPECT_TRUE(check.has_tour) << name;
    }
}

TEST(WorldCheck, AStartNearAWallIsTold) {
    World world = test::small_world();
    world.tour.start = {7.8, 0, 0};
    const WorldCheck check = check_world(world);
    EXPECT_NEAR(check.nearest_m, 0.2, 1e-12);
    EXPECT_FALSE(check.start_free);
    EXPECT_FALSE(check.good());
    EXPECT_EQ(sentences_of(check, world).front().english(),
              "start: 0.200 m from what is nearest, expected at least the robot's radius of "
              "0.26 m");
}

TEST(WorldCheck, AnOpeningIsFoundWhereItIs) {
    World world = test::small_world();
    EXPECT_TRUE(check_world(world).closed());
    for (const Pose& start : {Pose{0, 0, 0}, Pose{3, 1, 2}, Pose{-1, 3, 0}}) {
        // The eastern wall from (8, -2) to (8, 4) gets a hole from y = 1 to y = 1.01.
        World open = world;
        open.tour.start = start;
        open.walls[1].b.y = 1.0;
        open.walls.push_back({{8, 1.01}, {8, 4}, 2});
        const WorldCheck check = check_world(open);
        ASSERT_FALSE(check.closed());
        const double y = start.y + std::tan(*check.way_out_rad) * (8 - start.x);
        EXPECT_NEAR(y, 1.005, 0.005);
        // A door closes it; so does a joint of less than a millimetre.
        open.doors.push_back({{8, 0.5}, {8, 1.5}, 1});
        EXPECT_TRUE(check_world(open).closed());
        open.doors.clear();
        open.walls.back().a.y = 1.0015;
        EXPECT_TRUE(check_world(open).closed());
    }
    // Behind the start, where angles begin anew.
    World west = world;
    west.walls[3].b.y = 0.1;
    west.walls.push_back({{-2, -0.1}, {-2, -2}, 2});
    ASSERT_FALSE(check_world(west).closed());
    EXPECT_NEAR(std::abs(*check_world(west).way_out_rad), kPi, 1e-9);
}

TEST(WorldCheck, ATourThatHitsAWallIsTold) {
    World world = test::small_world();
    world.tour.way_points.push_back({{7.9, 0}, 9});
    const WorldCheck check = check_world(world);
    EXPECT_FALSE(check.good());
    EXPECT_NE(sentences_of(check, world).back().english().find("tour: small.toml:9: "),
              std::string::npos)
        << sentences_of(check, world).back().english();
    world.tour.way_points.clear();
    EXPECT_TRUE(check_world(world).good());
    EXPECT_FALSE(check_world(world).has_tour);
    EXPECT_EQ(sentences_of(check_world(world), world).back().english(),
              "tour: none yet; it can be driven by hand, or given way points");
}

}  // namespace
}  // namespace hitos
