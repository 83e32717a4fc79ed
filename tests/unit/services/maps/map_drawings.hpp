// SPDX-License-Identifier: GPL-3.0-or-later
// A small map for the tests of files that show maps.
#pragma once

#include <vector>

#include "hitos/services/files/line_extents.hpp"

namespace hitos::test {

/// Two lines, the first with two segments, and a corner; all but the second line are uncertain.
struct SmallMap {
    LandmarkMap map;
    std::vector<LineExtent> segments;
    Trajectory path;

    SmallMap() {
        ICaracteristica wall;
        wall.value = Recta{2.0, kPi / 2.0};  // y = 2
        wall.covariance << 0.01, 0.001, 0.001, 0.0004;
        wall.observations = 7;
        wall.first_seen = 1;
        wall.last_seen = 9;
        ICaracteristica other;
        other.value = Recta{1.0, -kPi};  // x = -1
        ICaracteristica corner;
        corner.value = Esquina{-1.0, 2.0};
        corner.covariance << 0.04, 0.0, 0.0, 0.01;
        corner.observations = 3;
        map = {wall, other, corner};
        segments = {{0, {-1.0, 2.0}, {1.0, 2.0}, 40},
                    {0, {2.0, 2.0}, {5.0, 2.0}, 60},
                    {1, {-1.0, -2.0}, {-1.0, 2.0}, 50}};
        path = {{0.0, {0.0, 0.0, 0.0}}, {1.0, {2.0, 0.5, 0.1}}, {2.0, {4.0, 0.0, -0.1}}};
    }
};

}  // namespace hitos::test
