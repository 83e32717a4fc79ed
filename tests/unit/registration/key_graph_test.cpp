// SPDX-License-Identifier: GPL-3.0-or-later
#include "key_graph.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "graph_ways.hpp"
#include "line_of_keys.hpp"

namespace hitos {
namespace {

using test::line_of;

TEST(KeyGraph, NothingLeadsOverACutButALoop) {
    KeyGraph graph = line_of(12, 0.01, 1e-4);
    graph.join(2, 3);
    graph.join(1, 9);
    for (std::uint32_t key = 1; key < 12; ++key) graph.edges.push_back({key - 1, key, {}});
    graph.edges.push_back({0, 8, {}, {}, EdgeKind::fix});
    graph.cut(6);
    EXPECT_EQ(graph.part_begin(5), 0U);
    EXPECT_EQ(graph.part_begin(6), 6U);
    EXPECT_EQ(graph.part_begin(11), 6U);
    EXPECT_EQ(graph.edges.size(), 11U);  // the step from 5 to 6 alone is gone
    GraphWays ways;
    ways.begin(graph, 11);
    EXPECT_LT(ways.to(6).way_m, 5.1);
    EXPECT_EQ(ways.to(5).way_m, GraphReach::kNever);
    EXPECT_EQ(ways.to(1).way_m, GraphReach::kNever);
    std::vector<std::uint32_t> selected;
    const MapOfKeys all{12, graph.poses[11].pose, 30};
    select_keys(graph, all, older_keys(graph, all, ways.beside(20.0, 6.0), 60).keys, selected);
    EXPECT_EQ(selected, (std::vector<std::uint32_t>{6, 7, 8, 9, 10, 11}));

    graph.join(3, 9);
    ways.begin(graph, 11);
    EXPECT_NEAR(ways.to(2).way_m, 2.0 + 0.1 + 0.1, 1e-9);
}

TEST(KeyGraph, WhatSomebodyClosedStaysClosedOverACut) {
    for (const std::uint32_t earlier : {0U, 2U}) {
        KeyGraph graph = line_of(12, 0.01, 1e-4);
        graph.join(earlier, 9);
        graph.edges.push_back({earlier, 9, {}, {}, EdgeKind::by_hand});
        graph.cut(6);
        GraphWays ways;
        ways.begin(graph, 9);
        EXPECT_NEAR(ways.to(earlier).way_m, 0.1, 1e-12) << earlier;
    }
}

TEST(KeyGraph, TheLocalMapHasTheNewestKeysAndTheNearestOfAnEarlierPassage) {
    KeyGraph graph = line_of(40, 0.01, 1e-4);
    graph.join(0, 39);
    graph.poses[39].pose = {0.5, 0.5, 0.0};
    GraphWays ways;
    ways.begin(graph, 39);
    std::vector<std::uint32_t> keys;
    const MapOfKeys map{40, graph.poses[39].pose, 8};
    for (const std::size_t most : {4U, 16U, 40U}) {
        select_keys(graph, map, older_keys(graph, map, ways.beside(20.0, 6.0), most).keys, keys);
        EXPECT_EQ(keys, (std::vector<std::uint32_t>{32, 33, 34, 35, 36, 37, 38, 39, 0, 1, 2, 3}));
    }
}

TEST(KeyGraph, OfACrowdOfPassagesTheOldestAreTaken) {
    const auto passages = [](std::uint32_t count) {
        KeyGraph graph = line_of(std::size_t{10} * count, 0.01, 1e-4);
        for (std::uint32_t key = 0; key < graph.size(); ++key)
            graph.poses[key].pose = {0.3 * (key % 10), 0.0, 0.0};
        std::vector<std::uint32_t> all(graph.size());
        std::iota(all.begin(), all.end(), 0U);
        const MapOfKeys map{graph.size(), {1.5, 0.0, 0.0}, 10};
        return older_keys(graph, map, all, 5).keys;
    };
    EXPECT_EQ(passages(3), (std::vector<std::uint32_t>{5, 15, 6, 16, 4})) << "the nearest";
    EXPECT_EQ(passages(20), (std::vector<std::uint32_t>{4, 5, 6, 14, 15}));
}

/// Ten keys a passage, all the same way. From passage `crowd` on each key is in a crowd, and hangs
/// on the first passage and on the key before it.
KeyGraph passages_with_a_crowd(std::uint32_t count, std::uint32_t crowd) {
    KeyGraph graph;
    for (std::uint32_t key = 0; key < 10 * count; ++key) {
        KeyScan scan;
        scan.travelled_m = 0.5 * key;
        scan.variance_m2 = 1e-4;
        graph.add({{0.5 * (key % 10), 0.0, 0.0}, key}, scan, key >= 10 * crowd);
        if (key > 0) graph.edges.push_back({key - 1, key, {}, {}, EdgeKind::odometry});
        if (key < 10) continue;
        for (std::uint32_t old = key % 10; old < std::min(key % 10 + 3, 10U); ++old)
            graph.edges.push_back({old, key, {}, {}, EdgeKind::loop});
        graph.join(key % 10, key);
    }
    return graph;
}

TEST(KeyGraph, WhoGoesTheSameWayAllDayHasNoMoreKeysToLookAt) {
    const auto reached = [](std::uint32_t passages, std::uint32_t crowd) {
        const KeyGraph graph = passages_with_a_crowd(passages, crowd);
        GraphWays ways;
        ways.begin(graph, graph.size() - 1);
        return static_cast<int>(ways.beside(100.0, GraphReach::kNever).size());
    };
    EXPECT_EQ(reached(20, 20), 200);
    const int after_20 = reached(20, 3);
    EXPECT_EQ(after_20, 31 + 41);  // before the crowd with its first key, and the last 20 m
    EXPECT_EQ(reached(40, 3), after_20);
    // Who rests still knows the way out.
    const KeyGraph graph = passages_with_a_crowd(20, 3);
    ASSERT_TRUE(graph.rests(75));
    EXPECT_FALSE(graph.rests(30) || graph.rests(199));
    GraphWays ways;
    ways.begin(graph, 75, 2.0);
    EXPECT_NEAR(ways.to(5).way_m, 0.1, 1e-12);
    EXPECT_EQ(ways.to(74).way_m, GraphReach::kNever);
}

TEST(KeyGraph, WhoRestsHangsOnKeysThatStay) {
    KeyGraph graph = passages_with_a_crowd(12, 3);
    graph.edges.push_back({74, 75, {}, {}, EdgeKind::by_hand});
    graph.edges.push_back({74, 75, {}, {}, EdgeKind::scan});
    graph.poses[74].pose.theta = 1.0;
    graph.poses[5].pose.theta = 0.4;
    for (PoseEdge& edge : graph.edges) {
        if (edge.kind == EdgeKind::odometry)
            edge.information = Eigen::Vector3d(1.0, 4.0, 9.0).asDiagonal();
    }
    EXPECT_FALSE(graph.thin_if_many_rest());
    EXPECT_TRUE(graph.thin_resting());
    const auto count = [&](std::uint32_t from, std::uint32_t to, EdgeKind kind) {
        return std::ranges::count_if(graph.edges, [&](const PoseEdge& edge) {
            return edge.from == from && edge.to == to && edge.kind == kind;
        });
    };
    EXPECT_EQ(count(74, 75, EdgeKind::odometry) + count(74, 75, EdgeKind::scan), 0);
    EXPECT_EQ(count(74, 75, EdgeKind::by_hand), 1);
    EXPECT_EQ(count(5, 75, EdgeKind::loop), 1);
    EXPECT_EQ(count(29, 30, EdgeKind::odometry) + count(118, 119, EdgeKind::odometry), 2);
    // So no direction is open, whatever scans say.
    const auto step = std::ranges::find_if(graph.edges, [](const PoseEdge& edge) {
        return edge.to == 75 && edge.kind == EdgeKind::odometry;
    });
    ASSERT_NE(step, graph.edges.end());
    EXPECT_EQ(step->from, 5U);
    EXPECT_NEAR(step->z.y, 0.0, 1e-12);
    EXPECT_NEAR(step->z.theta, -0.4, 1e-12);
    const Eigen::Vector3d along(std::cos(0.6), std::sin(0.6), 0.0);  // as seen from key 5
    EXPECT_NEAR(along.dot(step->information * along), 1.0, 1e-9);
    for (std::uint32_t key = 1; key < 120; ++key) {
        EXPECT_EQ(std::ranges::count_if(graph.edges,
                                        [key](const PoseEdge& edge) {
                                            return edge.to == key &&
                                                   edge.kind == EdgeKind::odometry;
                                        }),
                  1)
            << key;
    }
    const std::size_t once = graph.edges.size();
    EXPECT_FALSE(graph.thin_resting());
    EXPECT_EQ(graph.edges.size(), once);
}

/// A stretch that left the crowd and came back is led to, whatever rests about it.
TEST(KeyGraph, NoStretchIsLostBetweenKeysThatRest) {
    KeyGraph graph;
    for (std::uint32_t key = 0; key < 400; ++key) {
        KeyScan scan;
        scan.travelled_m = 0.5 * key;
        scan.variance_m2 = 1e-4;
        const bool away = key >= 200 && key < 240;
        graph.add({{0.5 * (key % 10), away ? 5.0 : 0.0, 0.0}, key}, scan, key >= 30 && !away);
        if (key >= 10 && !away && key != 199 && key != 240) graph.join(key % 10, key);
        if (key >= 40 && !away) graph.join(key - 25, key);  // one that may rest itself
    }
    GraphWays ways;
    ways.begin(graph, 399);
    for (std::uint32_t key = 0; key < 400; ++key) {
        EXPECT_EQ(ways.to(key).way_m < GraphReach::kNever, !graph.rests(key)) << key;
    }
    EXPECT_TRUE(graph.rests(100));
    EXPECT_FALSE(graph.rests(198) || graph.rests(199));
}

TEST(KeyGraph, WhoIsJoinedRestsNoMore) {
    KeyGraph graph = passages_with_a_crowd(20, 3);
    ASSERT_TRUE(graph.rests(75) && graph.rests(95));
    GraphWays ways;
    ways.begin(graph, 199);
    EXPECT_EQ(ways.to(75).way_m, GraphReach::kNever);
    graph.join(75, 199);
    EXPECT_FALSE(graph.rests(75));
    ways.begin(graph, 199);
    EXPECT_NEAR(ways.to(75).way_m, 0.1, 1e-12);
    ways.begin(graph, 5);
    EXPECT_NEAR(ways.to(75).way_m, 0.1, 1e-12);  // by the joint that it had
    EXPECT_TRUE(graph.rests(95) && ways.to(95).way_m == GraphReach::kNever);
}

TEST(KeyGraph, EdgesOfWhoRestsGoByTheHundred) {
    KeyGraph graph = passages_with_a_crowd(30, 3);
    EXPECT_TRUE(graph.thin_if_many_rest());
    EXPECT_FALSE(graph.thin_if_many_rest());
    KeyGraph at_once = passages_with_a_crowd(30, 3);
    at_once.thin_resting();
    EXPECT_EQ(graph.edges.size(), at_once.edges.size());
}

TEST(KeyGraph, AKeyThatWouldMoveTheScanByMoreThanHalfAMetreMakesNoEdge) {
    // A third of a radian counts a metre.
    const auto edges_where = [](const Eigen::Vector3d& step) {
        const KeyGraph graph = line_of(2, 0.01, 1e-4);
        Linearization seen;
        seen.h = 1e6 * Eigen::Matrix3d::Identity();
        seen.b = -seen.h * step;
        seen.matches = 20;
        const std::vector<std::uint32_t> sources{0};
        std::vector<PoseEdge> edges;
        graph.find_scan_edges(1, graph.poses[1].pose, sources, std::vector{seen}, 1.0, 0, edges);
        return edges;
    };
    const auto near = edges_where({0.3, -0.1, 0.03});
    ASSERT_EQ(near.size(), 1U);
    EXPECT_NEAR(near[0].z.x, 1.3, 1e-5);
    EXPECT_NEAR(near[0].z.y, -0.1, 1e-5);
    EXPECT_TRUE(edges_where({0.4, -0.2, 0.0}).empty());
    EXPECT_TRUE(edges_where({0.0, 0.0, 0.2}).empty());
}

}  // namespace
}  // namespace hitos
