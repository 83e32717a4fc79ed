// SPDX-License-Identifier: GPL-3.0-or-later
// Worlds for the tests of the simulation.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hitos/simulation/worlds/world.hpp"
#include "support.hpp"

namespace hitos::test {

/// The worlds of SPEC 9: long tours that close loops. The corridor of [P fig 3] is another kind.
inline const std::vector<std::string>& shipped_names() {
    static const std::vector<std::string> names = {"recinto", "lineamedia", "bigloop", "bigloop2",
                                                   "complex", "iusiani",    "usc-sal"};
    return names;
}

inline World shipped(const std::string& name) {
    return read_world(std::filesystem::path(HITOS_SOURCE_DIR) / "data/worlds" / (name + ".toml"));
}

/// A room of 10 x 6 m round the origin, and a short tour.
inline World small_world() {
    return parse_world(
        "walls = [[[-2, -2], [8, -2], [8, 4], [-2, 4], [-2, -2]]]\n"
        "[tour]\nstart = [0, 0, 0]\nrest = 1\nway_points = [[0, 2], [5, 2], [5, 0]]\n",
        "small.toml");
}

}  // namespace hitos::test
