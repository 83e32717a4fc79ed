// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/simulation/worlds/reference_map.hpp"

#include <algorithm>
#include <cmath>

#include "hitos/services/files/map_file.hpp"
#include "worlds.hpp"

namespace hitos {
namespace {

World world_of(const std::string& walls, const std::string& start = "[0, 0, 0]") {
    return parse_world(
        "walls = " + walls + "\n[tour]\nstart = " + start + "\nway_points = [[1, 1]]", "w.toml");
}

std::vector<std::string> sorted_lines(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find('\n', at);
        lines.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    std::ranges::sort(lines);
    return lines;
}

TEST(ReferenceMap, OfTheShippedWorldsIsTheStoredOneToTheLastDigit) {
    const std::vector<std::size_t> expected = {8, 9, 16, 22, 26};  // SPEC 10
    std::size_t i = 0;
    std::vector<std::string> names = test::shipped_names();
    names.emplace_back("corridor");
    for (const std::string& name : names) {
        SCOPED_TRACE(name);
        const LandmarkMap map = reference_map(test::shipped(name));
        if (i < expected.size()) {
            EXPECT_EQ(map.size(), expected[i]);
        }
        ++i;
        const std::string stored =
            test::content(std::filesystem::path(HITOS_SOURCE_DIR) / "data/maps" / (name + ".map"));
        EXPECT_EQ(sorted_lines(map_to_text(map)), sorted_lines(stored));
    }
}

TEST(ReferenceMap, MergesWallsOnOneLineAndCountsCornersOnce) {
    // Two pieces of y = 2, a wall that ends on one of them, one that crosses the other, and one
    // that ends just short.
    const LandmarkMap map = reference_map(
        world_of("[[[0, 2], [3, 2]], [[5, 2], [9, 2]], [[1, 2], [1, 4]], [[6, 1], [6, 3]], "
                 "[[8, 2.01], [8, 3]]]"));
    EXPECT_EQ(map_to_text(map),
              "rho: 2 theta: 90\nrho: 1 theta: 0\nrho: 6 theta: 0\nrho: 8 theta: 0\n"
              "x: 1 y: 2\nx: 6 y: 2\n");
}

TEST(ReferenceMap, IsInTheFrameOfTheStart) {
    const LandmarkMap map = reference_map(world_of("[[[4, -9], [4, 7], [1, 7]]]", "[1, 2, 90]"));
    ASSERT_EQ(map.size(), 3U);
    // x = 4 lies 3 m to the right of a robot at x = 1 that faces +y.
    EXPECT_NEAR(map[0].point().x, 0.0, 1e-12);
    EXPECT_NEAR(map[0].point().y, -3.0, 1e-12);
    EXPECT_NEAR(map[1].point().x, 5.0, 1e-12);
    EXPECT_NEAR(map[2].point().x, 5.0, 1e-12);
    EXPECT_NEAR(map[2].point().y, -3.0, 1e-12);
}

}  // namespace
}  // namespace hitos
