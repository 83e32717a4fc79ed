// SPDX-License-Identifier: GPL-3.0-or-later
// A robot round a ring of corridors, for tests of registration.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "drawn_scan.hpp"
#include "hitos/registration/registration.hpp"

namespace hitos::test {

/// Round a block of corridors, `laps` times; a step is about 0.35 m or 0.2 rad.
inline std::vector<Pose> round_tour(const std::vector<Point2>& way, int laps) {
    std::vector<Pose> poses{
        {way[0].x, way[0].y, std::atan2(way[1].y - way[0].y, way[1].x - way[0].x)}};
    for (std::size_t leg = 1; leg <= static_cast<std::size_t>(laps) * way.size(); ++leg) {
        const Point2& to = way[leg % way.size()];
        const Pose from = poses.back();
        const double heading = std::atan2(to.y - from.y, to.x - from.x);
        const double turn = wrap_angle(heading - from.theta);
        const int turns = static_cast<int>(std::ceil(std::abs(turn) / 0.2));
        for (int i = 1; i <= turns; ++i) {
            poses.push_back({from.x, from.y, wrap_angle(from.theta + turn * i / turns)});
        }
        const double way_m = std::hypot(to.x - from.x, to.y - from.y);
        const int steps = static_cast<int>(std::ceil(way_m / 0.35));
        for (int i = 1; i <= steps; ++i) {
            poses.push_back({from.x + (to.x - from.x) * i / steps,
                             from.y + (to.y - from.y) * i / steps, heading});
        }
    }
    return poses;
}

/// A ring of corridors 2 m wide about a block of 12 m x 8 m, with recesses unlike each other.
inline Walls ring_walls() {
    Walls walls = closed({{-1, -1},
                          {4, -1},
                          {4, -2},
                          {6, -2},
                          {6, -1},
                          {15, -1},
                          {15, 4},
                          {16.5, 4},
                          {16.5, 5},
                          {15, 5},
                          {15, 11},
                          {3, 11},
                          {3, 11.8},
                          {2, 11.8},
                          {2, 11},
                          {-1, 11}});
    const Walls block = closed({{1, 1},
                                {13, 1},
                                {13, 3},
                                {12.2, 3},
                                {12.2, 5},
                                {13, 5},
                                {13, 9},
                                {1, 9},
                                {1, 6},
                                {1.7, 6},
                                {1.7, 5},
                                {1, 5}});
    walls.insert(walls.end(), block.begin(), block.end());
    return walls;
}

/// Half a turn takes this ring onto itself; the recess tells its corners from its sides.
inline Walls ring_of_two_halves() {
    Walls walls = closed({{-1, -1},
                          {6, -1},
                          {6, -2},
                          {8, -2},
                          {8, -1},
                          {15, -1},
                          {15, 11},
                          {8, 11},
                          {8, 12},
                          {6, 12},
                          {6, 11},
                          {-1, 11}});
    const Walls block = closed({{1, 1}, {13, 1}, {13, 9}, {1, 9}});
    walls.insert(walls.end(), block.begin(), block.end());
    return walls;
}

inline const std::vector<Point2> kRing{{0, 0}, {14, 0}, {14, 10}, {0, 10}};

struct Driven {
    Registration registration;
    std::vector<Pose> online;
    std::vector<Pose> odometry;
    int corrections = 0;
};

/// Odometry whose heading drifts by `drift` radians a metre and that is `scale` times too long.
inline Driven drive(const Walls& walls, const std::vector<Pose>& truth, double drift, double scale,
                    const RegistrationParams& params = {}, double sigma = 0.005, int threads = 1) {
    Driven driven{Registration(params, threads), {}, {}};
    std::mt19937 engine(9);
    Pose odometry;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        std::vector<Control> controls;
        if (i > 0) {
            Pose step = between(truth[i - 1], truth[i]);
            step.theta += drift * std::hypot(step.x, step.y);
            step.x *= scale;
            odometry = compose(odometry, step);
            controls.push_back({twist_between(step, 1.0), 1.0});
        }
        const RegisteredStep step =
            driven.registration.add(drawn_scan(walls, truth[i], sigma, &engine), controls);
        EXPECT_EQ(step.scan, i);
        driven.odometry.push_back(odometry);
        if (driven.registration.correction()) ++driven.corrections;
        driven.online.push_back(driven.registration.path().back());
    }
    return driven;
}

inline double greatest_path_error(const std::vector<Pose>& path, const std::vector<Pose>& truth) {
    double greatest = 0.0;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const Pose at = compose(truth.front(), path[i]);
        greatest = std::max(greatest, std::hypot(at.x - truth[i].x, at.y - truth[i].y));
    }
    return greatest;
}

}  // namespace hitos::test
