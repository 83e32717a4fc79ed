// SPDX-License-Identifier: GPL-3.0-or-later
#include "graph_ways.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

#include "line_of_keys.hpp"

namespace hitos {
namespace {

using test::line_of;

TEST(GraphWays, UncertaintyAddsUpAlongTheWay) {
    const KeyGraph graph = line_of(11, 0.01, 1e-4);
    GraphWays ways;
    ways.begin(graph, 10);
    EXPECT_EQ(ways.to(10).variance_m2, 0.0);
    EXPECT_NEAR(ways.to(0).way_m, 10.0, 1e-12);
    EXPECT_NEAR(ways.to(0).variance_rad2, 10 * 1e-4, 1e-12);
    // Each step's turn counts at its distance from where one looks: 1, 2 … 10 m.
    EXPECT_NEAR(ways.to(0).variance_m2, 10 * 0.01 + 1e-4 * 385.0, 1e-12);
}

TEST(GraphWays, AJoinedPassageIsNear) {
    KeyGraph graph = line_of(11, 0.01, 1e-4);
    graph.join(0, 10);
    GraphWays ways;
    ways.begin(graph, 10);
    EXPECT_NEAR(ways.to(0).way_m, 0.1, 1e-12);
    EXPECT_NEAR(ways.to(2).way_m, 2.1, 1e-12);
    EXPECT_NEAR(ways.to(5).way_m, 5.0, 0.2);
    // Within a limit only what it holds is reached.
    graph.poses[0].pose.x = 9.5;
    graph.poses[1].pose.x = 9.0;
    ways.begin(graph, 10, 1.5);
    EXPECT_LT(ways.to(1).way_m, 1.5);
    EXPECT_EQ(ways.to(5).way_m, GraphReach::kNever);
}

/// A walk about a square of 40 m, joined wherever it comes near itself, with two cuts.
KeyGraph walk(std::uint32_t seed) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    KeyGraph graph;
    Pose pose;
    for (std::uint32_t key = 0; key < 400; ++key) {
        KeyScan scan;
        scan.travelled_m = key;
        scan.variance_m2 = 1e-3 * (1.0 + any(engine));
        scan.variance_rad2 = 1e-5 * (1.0 + any(engine));
        graph.add({pose, key}, scan);
        for (std::uint32_t other = 0; other + 10 < key; ++other) {
            if (distance_m(graph.poses[other].pose, pose) < 1.5) graph.join(other, key);
        }
        pose.theta += any(engine);
        pose.x = std::clamp(pose.x + std::cos(pose.theta), -20.0, 20.0);
        pose.y = std::clamp(pose.y + std::sin(pose.theta), -20.0, 20.0);
    }
    graph.cut(120);
    graph.cut(250);
    graph.join(5, 130);
    return graph;
}

/// The least variances of all, by looking at every step and joint until none makes any less
/// (Bellman and Ford), whose bits are the same, for every way is added up from its beginning.
std::vector<double> least_variances(const KeyGraph& graph, std::size_t from) {
    std::vector<double> least(graph.size(), GraphReach::kNever);
    least[from] = 0.0;
    bool less = true;
    const auto go = [&](std::size_t i, std::size_t j, double variance_m2, double variance_rad2) {
        if (least[i] >= GraphReach::kNever) return;
        const double dx = graph.poses[j].pose.x - graph.poses[from].pose.x;
        const double dy = graph.poses[j].pose.y - graph.poses[from].pose.y;
        const double there = least[i] + variance_m2 + variance_rad2 * (dx * dx + dy * dy);
        if (there >= least[j]) return;
        least[j] = there;
        less = true;
    };
    while (less) {
        less = false;
        for (std::size_t i = 0; i < graph.size(); ++i) {
            for (const std::uint32_t j : graph.joined(i)) go(i, j, 1e-4, 1e-6);
            if (i == 0 || graph.is_cut_before(i)) continue;
            const KeyScan& step = graph.scans[i];
            go(i, i - 1, step.variance_m2, step.variance_rad2);
            go(i - 1, i, step.variance_m2, step.variance_rad2);
        }
    }
    return least;
}

TEST(GraphWays, AreTheShortestInWhateverOrderSomebodyAsks) {
    GraphWays ways;  // one, which begins anew from each key
    for (const std::uint32_t seed : {1U, 2U, 3U}) {
        const KeyGraph graph = walk(seed);
        std::mt19937 engine(seed);
        std::vector<std::uint32_t> order(graph.size());
        std::iota(order.begin(), order.end(), 0U);
        for (const std::size_t from : {399U, 0U, 200U}) {
            const std::vector<double> least = least_variances(graph, from);
            std::ranges::shuffle(order, engine);
            ways.begin(graph, from);
            for (const std::uint32_t key : order) {
                ASSERT_EQ(ways.to(key).variance_m2, least[key]) << seed << ": " << key;
                ASSERT_EQ(ways.to(key).way_m < GraphReach::kNever, least[key] < GraphReach::kNever);
            }
        }
    }
}

TEST(GraphWays, WhatIsBesideIsNearBothWays) {
    const KeyGraph graph = walk(4);
    GraphWays ways;
    ways.begin(graph, 300);
    const std::vector<std::uint32_t> beside = ways.beside(8.0, 6.0);
    EXPECT_GT(beside.size(), 20U);
    EXPECT_TRUE(std::ranges::is_sorted(beside));
    for (std::uint32_t key = 0; key < graph.size(); ++key) {
        const bool near = distance_m(graph.poses[key].pose, graph.poses[300].pose) < 8.0;
        EXPECT_EQ(std::ranges::binary_search(beside, key), near && ways.to(key).way_m < 6.0) << key;
    }
}

/// Who is looked for within a limit is no farther as the crow flies, and led to within it.
TEST(GraphWays, ALimitIsOneOfWayAndOfDistance) {
    const KeyGraph graph = walk(5);
    GraphWays all;
    GraphWays limited;
    all.begin(graph, 350);
    limited.begin(graph, 350, 7.0);
    int reached = 0;
    for (std::uint32_t key = 0; key < graph.size(); ++key) {
        if (limited.to(key).way_m >= GraphReach::kNever) continue;
        ++reached;
        EXPECT_LT(distance_m(graph.poses[key].pose, graph.poses[350].pose), 7.0) << key;
        EXPECT_GE(limited.to(key).variance_m2, all.to(key).variance_m2) << key;
    }
    EXPECT_GT(reached, 10);
    EXPECT_LT(reached, 200);
}

}  // namespace
}  // namespace hitos
