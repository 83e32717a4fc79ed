// SPDX-License-Identifier: GPL-3.0-or-later
// Worlds with trees and posts that a laser sees as circles.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "hitos/base/error.hpp"
#include "hitos/simulation/drive/simulated_tour.hpp"
#include "hitos/simulation/text/world_text.hpp"
#include "hitos/simulation/worlds/reference_map.hpp"
#include "worlds.hpp"

namespace hitos {
namespace {

const std::string kGrove =
    "walls = [[[-2, -2], [8, -2], [8, 4], [-2, 4], [-2, -2]]]\n"
    "[landmarks]\n"
    "radii = [0.3, 0.1]\n"
    "at = [[3, 0], [2, 2.5]]\n"
    "[laser]\nrays = 181\nsigma = 0\n"
    "[tour]\nstart = [0, 0, 0]\nrest = 1\nway_points = [[0, 2], [1, 1]]\n";

World grove() {
    return parse_world(kGrove, "grove.toml");
}

std::string grove_with(const std::string& piece, const std::string& other) {
    std::string text = kGrove;
    return text.replace(text.find(piece), piece.size(), other);
}

TEST(Trees, AreCirclesToTheLaserExactly) {
    for (const char* cell : {"raster.cell=0", "raster.cell=0.05"}) {
        World world = grove();
        set_world_value(world, cell);
        const Scan scan = SimulatedTour(world).scan(0);
        EXPECT_TRUE(scan.landmarks.empty());
        std::size_t on_bark = 0;
        for (const Point2& p : scan.points) {
            for (std::size_t i = 0; i < 2; ++i) {
                const Point2& middle = world.landmarks.at[i];
                const double away = std::hypot(p.x - middle.x, p.y - middle.y);
                EXPECT_GT(away, world.landmarks.radii_m[i] - 1e-9);  // nothing is seen through it
                if (away > world.landmarks.radii_m[i] + 1e-9) continue;
                ++on_bark;
                EXPECT_LT(p.x * (p.x - middle.x) + p.y * (p.y - middle.y), 0.0);  // its near side
            }
        }
        // 2 asin(0.3 / 3) and 2 asin(0.1 / 3.2) are 11.5 and 3.6 degrees.
        EXPECT_NEAR(static_cast<double>(on_bark), 15.0, 1.0);
    }
}

TEST(Trees, AreReferenceLandmarksBesideTheWalls) {
    const LandmarkMap map = reference_map(grove());
    ASSERT_EQ(map.size(), 4U + 4U + 2U);
    EXPECT_EQ(map[8].point(), (Point2{3.0, 0.0}));
    EXPECT_EQ(map[9].point(), (Point2{2.0, 2.5}));
    EXPECT_EQ(map[9].identity, -1);
}

TEST(Trees, BarTheWay) {
    const auto live = SimulatedTour::live(grove());
    for (int i = 0; i < 150; ++i) live->drive_on(0.5, 0.0);
    EXPECT_NEAR(live->pose_now().x, 3.0 - 0.3 - 0.26, 0.06);
    EXPECT_LE(live->pose_now().x, 3.0 - 0.3 - 0.26);
    for (int i = 0; i < 30; ++i) live->drive_on(-0.5, 0.0);
    EXPECT_LT(live->pose_now().x, 2.0);
    EXPECT_NE(test::message_of<FormatError>([] {
                  SimulatedTour(parse_world(grove_with("[1, 1]]", "[4, 2.5]]"), "grove.toml"));
              }).find("of landmark 1, (2, 2.5); expected at least its radius"),
              std::string::npos);
    EXPECT_NE(test::message_of<FormatError>([] {
                  SimulatedTour(parse_world(grove_with("[0, 0, 0]", "[3.4, 0, 0]"), "grove.toml"));
              }).find("the start at (3.4, 0) is 0.100 m from landmark 0, (3, 0)"),
              std::string::npos);
}

TEST(Trees, HaveARadiusEach) {
    const auto told = [](const std::string& radii) {
        return test::message_of<FormatError>(
            [&] { parse_world(grove_with("[0.3, 0.1]", radii), "grove.toml"); });
    };
    EXPECT_NE(told("[0.3]").find("grove.toml:3: landmarks.radii: found 1 radii of 2 landmarks"),
              std::string::npos);
    EXPECT_NE(told("[[0.3], 0.1]").find("expected a radius in metres"), std::string::npos);
    EXPECT_NE(told("[\"0.3\", 0.1]").find("expected a radius in metres"), std::string::npos);
    EXPECT_NE(told("[]").find("landmarks.radii: found none"), std::string::npos);
    EXPECT_NE(told("[0.3, -1]").find("landmarks.radii: found the radius -1 m"), std::string::npos);
    EXPECT_NE(told("[0.3, 'thick']").find("expected a radius in metres"), std::string::npos);
    EXPECT_NE(told("0.3").find("landmarks.radii: expected [radius, ...]"), std::string::npos);
    World world = grove();
    world.landmarks.radii_m.pop_back();
    EXPECT_THROW(check(world), ConfigError);
}

TEST(Trees, StayWhereTextIsEdited) {
    WorldText text(kGrove, "grove.toml");
    World world = text.world();
    text.set(world);
    EXPECT_EQ(text.text(), kGrove);
    world.landmarks.at.push_back({6.0, 2.0});
    world.landmarks.radii_m.push_back(0.25);
    text.set(world);
    EXPECT_NE(text.text().find("radii = [0.3, 0.1, 0.25]"), std::string::npos);
    EXPECT_EQ(parse_world(text.text(), "grove.toml").landmarks.radii_m.size(), 3U);
    world.landmarks.radii_m.clear();
    text.set(world);
    EXPECT_TRUE(parse_world(text.text(), "grove.toml").landmarks.told());
}

}  // namespace
}  // namespace hitos
