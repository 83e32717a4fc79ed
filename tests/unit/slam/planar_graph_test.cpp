// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/slam/planar_graph.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "graph/planar_error.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/random_stream.hpp"
#include "hitos/registration/graph_edit.hpp"
#include "manhattan.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using test::ManhattanWorld;
using test::message_of;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using VertexKind = PlanarVertex::Kind;
using EdgeKind = PlanarEdge::Kind;

PlanarGraph small_world(std::uint64_t seed = 1) {
    return ManhattanWorld({.poses = 300, .half_m = 6.0, .points = 12, .lines = 4, .seed = seed})
        .graph;
}

void add_prior(PlanarGraph& graph, EdgeKind kind, std::uint32_t vertex, const Eigen::Vector3d& z) {
    PlanarEdge& edge = graph.edges.emplace_back();
    edge.kind = kind;
    edge.from = edge.to = vertex;
    edge.z = z;
    edge.information = Eigen::Vector3d(30.0, 20.0, 50.0).asDiagonal();
}

/// The world turned and moved: the same measurements, other places.
PlanarGraph moved(PlanarGraph graph, const Pose& by) {
    for (PlanarVertex& vertex : graph.vertices) {
        if (vertex.kind == VertexKind::line) {
            const Recta line = transform(by, Recta{vertex.at(1), vertex.at(0)});
            // In normal form the normal may point the other way.
            const bool turned = std::abs(wrap_angle(line.theta - vertex.at(0) - by.theta)) > 1.0;
            vertex.at.head<2>() << wrap_angle(line.theta + (turned ? kPi : 0.0)),
                turned ? -line.rho : line.rho;
        } else if (vertex.kind == VertexKind::pose) {
            const Pose pose = compose(by, vertex.pose());
            vertex.at << pose.x, pose.y, pose.theta;
        } else {
            const Point2 point = transform(by, vertex.point());
            vertex.at.head<2>() << point.x, point.y;
        }
    }
    return graph;
}

double furthest(const PlanarGraph& a, const PlanarGraph& b) {
    double greatest = 0.0;
    for (std::size_t i = 0; i < a.vertices.size(); ++i) {
        Eigen::Vector3d difference = a.vertices[i].at - b.vertices[i].at;
        const Eigen::Index angle = a.vertices[i].kind == VertexKind::pose ? 2 : 0;
        if (a.vertices[i].kind != VertexKind::point) {
            difference(angle) = wrap_angle(difference(angle));
        }
        greatest = std::max(greatest, difference.cwiseAbs().maxCoeff());
    }
    return greatest;
}

TEST(PlanarGraph, WhatIsKnownVeryWellHoldsNothingElse) {
    // As a fixed vertex would, though its information is 10^23 times the edges'.
    PlanarGraph fixed = small_world();
    for (PlanarEdge& edge : fixed.edges) edge.information *= 1e-5;
    PlanarGraph prior = fixed;
    ASSERT_EQ(fixed.vertices.front().kind, VertexKind::pose);
    fixed.vertices.front().fixed = true;
    prior.vertices.front().fixed = false;
    add_prior(prior, EdgeKind::pose_prior, 0, prior.vertices.front().at);
    prior.edges.back().information = 1e18 * Eigen::Matrix3d::Identity();
    EXPECT_TRUE(solve(fixed, false).converged);
    const PlanarSolution solution = solve(prior, false);
    EXPECT_TRUE(solution.converged);
    EXPECT_GT(solution.greatest_move_m, 0.01);
    EXPECT_LT(furthest(fixed, prior), 1e-5);
}

TEST(PlanarGraph, ADirectionALittleBelowNothingIsNone) {
    PlanarGraph graph;
    for (std::uint64_t id = 0; id < 2; ++id) {
        PlanarVertex& vertex = graph.vertices.emplace_back();
        vertex.id = id;
        vertex.at(0) = 50.0 * static_cast<double>(id);
    }
    PlanarEdge& edge = graph.edges.emplace_back();
    edge.to = 1;
    edge.information = Eigen::Vector3d(-1e-7, 1.0, 1.0).asDiagonal();
    EXPECT_EQ(chi_square(graph), 0.0);
}

TEST(PlanarGraph, ErrorsHaveTheDerivativesThatTheySay) {
    PlanarGraph graph = small_world();
    add_prior(graph, EdgeKind::pose_prior, 5, {1.0, 2.0, 0.5});
    add_prior(graph, EdgeKind::position_prior, 6, {1.0, 2.0, 0.0});
    add_prior(graph, EdgeKind::point_prior, 300, {1.0, 2.0, 0.0});
    constexpr double kStep = 1e-6;
    for (const PlanarEdge& edge : graph.edges) {
        const PlanarError error = planar_error(graph, edge);
        const auto check = [&](std::uint32_t vertex, const SmallMatrix& by) {
            for (Eigen::Index k = 0; k < by.cols(); ++k) {
                PlanarGraph other = graph;
                other.vertices[vertex].at(k) += kStep;
                const SmallVector slope = (planar_error(other, edge).value - error.value) / kStep;
                ASSERT_LT((slope - by.col(k)).cwiseAbs().maxCoeff(), 1e-4)
                    << static_cast<int>(edge.kind);
            }
        };
        if ((&edge - graph.edges.data()) % 17 != 0 && !edge.prior()) continue;
        if (!edge.prior()) check(edge.from, error.by_from);
        check(edge.to, error.by_to);
    }
}

TEST(PlanarGraph, ChiSquareIsThatOfG2o) {
    // The error of EDGE_SE2 is z^-1 (a^-1 b), in the axes of z.
    PlanarGraph graph;
    graph.vertices.resize(2);
    graph.vertices[0].at << 1.0, 2.0, 0.5;
    graph.vertices[1].at << 2.0, 2.5, 1.5;
    PlanarEdge& edge = graph.edges.emplace_back();
    edge.to = 1;
    edge.z << 0.9, 0.1, 0.8;
    edge.information << 4.0, 1.0, 0.5, 1.0, 3.0, 0.25, 0.5, 0.25, 9.0;
    const Pose seen =
        between(Pose{0.9, 0.1, 0.8}, between(graph.vertices[0].pose(), graph.vertices[1].pose()));
    const Eigen::Vector3d e(seen.x, seen.y, seen.theta);
    EXPECT_NEAR(chi_square(graph), e.dot(edge.information * e), 1e-12);
    EXPECT_GT(chi_square(graph), 0.1);
}

TEST(PlanarGraph, IsSolvedFromItsOdometry) {
    for (const int poses : {3500, 10000}) {
        ManhattanWorld world({.poses = poses, .half_m = poses == 3500 ? 20.0 : 35.0});
        const PlanarSolution solution = solve(world.graph, false);
        EXPECT_TRUE(solution.converged) << poses;
        EXPECT_EQ(solution.parts, 1U);
        EXPECT_TRUE(solution.held.empty());
        // As much as its noise makes of it.
        const double freedom = 3.0 * (static_cast<double>(world.graph.edges.size()) -
                                      static_cast<double>(poses) + 1.0);
        EXPECT_NEAR(solution.chi_square_after, freedom, 5.0 * std::sqrt(2.0 * freedom)) << poses;
        EXPECT_GT(solution.chi_square_before, 100.0 * solution.chi_square_after) << poses;
        double greatest = 0.0;
        for (std::size_t i = 0; i < world.truth.size(); ++i) {
            const Pose& truth = world.truth[i];
            greatest =
                std::max(greatest, distance(world.graph.vertices[i].point(), {truth.x, truth.y}));
        }
        EXPECT_LT(greatest, 1.0) << poses;
    }
}

TEST(PlanarGraph, SolvedAgainItStays) {
    PlanarGraph graph = small_world();
    const double chi_square_after = solve(graph, false).chi_square_after;
    const PlanarGraph before = graph;
    const PlanarSolution again = solve(graph, false);
    EXPECT_LE(again.chi_square_after, chi_square_after);
    EXPECT_LE(again.steps, 3);
    EXPECT_LT(furthest(before, graph), 1e-6);
}

TEST(PlanarGraph, FewStepsFromWhereItIsForeseeASmallChange) {
    for (const bool robust : {false, true}) {
        PlanarGraph graph = small_world();
        solve(graph, robust);
        std::erase_if(graph.edges, [](const PlanarEdge& edge) {
            return edge.kind == EdgeKind::step && edge.to - edge.from > 100;
        });
        PlanarGraph afresh = graph;
        const PlanarSolution whole = solve(afresh, robust);
        const PlanarSolution soon = solve(graph, robust, PlanarStart::here);
        EXPECT_GT(soon.greatest_move_m, 1e-4);
        EXPECT_LT(furthest(graph, afresh), 0.01);  // [m, rad], which no eye sees
        EXPECT_LT(soon.steps, whole.steps);
    }
}

TEST(PlanarGraph, AskedToStopItMovesNothingAnyMore) {
    PlanarGraph graph = small_world();
    std::stop_source stop;
    stop.request_stop();
    const PlanarSolution solution = solve(graph, true, PlanarStart::here, stop.get_token());
    EXPECT_EQ(solution.steps, 0);
    EXPECT_FALSE(solution.converged);
    EXPECT_EQ(furthest(graph, small_world()), 0.0);
}

TEST(PlanarGraph, ChiSquareNeverGrows) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        // So noisy that Gauss-Newton steps alone miss.
        PlanarGraph graph = ManhattanWorld({.poses = 300,
                                            .half_m = 6.0,
                                            .sigma_m = 0.2,
                                            .sigma_rad = 0.2,
                                            .points = 5,
                                            .lines = 3,
                                            .seed = seed})
                                .graph;
        const PlanarSolution solution = solve(graph, false);
        EXPECT_LE(solution.chi_square_after, solution.chi_square_before) << seed;
        EXPECT_EQ(solution.chi_square_after, chi_square(graph)) << seed;
    }
}

TEST(PlanarGraph, TurnedAndMovedAsAWholeIsTheSame) {
    const Pose by{30.0, -70.0, 2.5};
    PlanarGraph graph = small_world();
    PlanarGraph other = moved(graph, by);
    const PlanarSolution one = solve(graph, false);
    const PlanarSolution two = solve(other, false);
    EXPECT_NEAR(one.chi_square_after, two.chi_square_after, 1e-6);
    EXPECT_NEAR(one.greatest_move_m, two.greatest_move_m, 1e-6);
    EXPECT_LT(furthest(moved(graph, by), other), 1e-6);
}

TEST(PlanarGraph, FixedVerticesStay) {
    PlanarGraph graph = small_world();
    for (const std::size_t i : {7U, 150U, 301U, 313U}) graph.vertices[i].fixed = true;
    const PlanarGraph before = graph;
    solve(graph, false);
    for (std::size_t i = 0; i < graph.vertices.size(); ++i) {
        const bool same = graph.vertices[i].at == before.vertices[i].at;
        EXPECT_EQ(same, graph.vertices[i].fixed) << i;
    }
}

TEST(PlanarGraph, HoldsOnePoseOfEachPart) {
    PlanarGraph graph = small_world();
    const PlanarGraph other = small_world(2);
    const auto first = static_cast<std::uint32_t>(graph.vertices.size());
    for (const PlanarVertex& vertex : other.vertices) graph.vertices.push_back(vertex);
    for (PlanarEdge edge : other.edges) {
        edge.from += first;
        edge.to += first;
        graph.edges.push_back(edge);
    }
    graph.vertices.emplace_back().kind = VertexKind::point;  // alone
    graph.vertices[first].fixed = false;
    PlanarGraph again = graph;
    const PlanarSolution solution = solve(graph, false);
    EXPECT_EQ(solution.parts, 3U);
    EXPECT_THAT(solution.held, ElementsAre(first, graph.vertices.size() - 1));
    EXPECT_TRUE(solution.converged);
    EXPECT_EQ(graph.vertices[first].at, other.vertices[0].at);
    // What a prior says of a place is believed.
    add_prior(again, EdgeKind::pose_prior, first, {1.0, 2.0, 0.5});
    EXPECT_THAT(solve(again, false).held, ElementsAre(graph.vertices.size() - 1));
    EXPECT_LT((again.vertices[first].at - Eigen::Vector3d(1.0, 2.0, 0.5)).norm(), 1e-6);
}

TEST(PlanarGraph, APositionThatIsKnownLeavesTheHeadingFree) {
    PlanarGraph graph = small_world();
    graph.vertices.front().fixed = false;
    add_prior(graph, EdgeKind::position_prior, 10, {5.0, 6.0, 0.0});
    const PlanarSolution solution = solve(graph, false);
    EXPECT_TRUE(solution.converged);
    EXPECT_NEAR(graph.vertices[10].at(0), 5.0, 1e-6);
    EXPECT_NEAR(graph.vertices[10].at(1), 6.0, 1e-6);
    PlanarGraph held = small_world();
    EXPECT_NEAR(solution.chi_square_after, solve(held, false).chi_square_after, 1e-6);
}

TEST(PlanarGraph, AFalseEdgeBendsARobustOneNot) {
    const ManhattanWorld world({.poses = 300, .half_m = 6.0});
    const auto error_with = [&](bool robust) {
        PlanarGraph graph = world.graph;
        PlanarEdge edge = graph.edges.back();
        edge.from = 20;
        edge.to = 250;
        edge.z << 0.0, 0.0, 0.0;
        graph.edges.push_back(edge);
        solve(graph, robust);
        EXPECT_EQ(worst_edges(graph, 1).front(), graph.edges.size() - 1);
        double sum = 0.0;
        for (std::size_t i = 0; i < world.truth.size(); ++i) {
            sum += distance(graph.vertices[i].point(), {world.truth[i].x, world.truth[i].y});
        }
        return sum / static_cast<double>(world.truth.size());
    };
    EXPECT_LT(error_with(true), 0.3);
    EXPECT_GT(error_with(false), 0.5);
}

TEST(PlanarGraph, ManyFalseLoopsAreSeenThrough) {
    constexpr std::uint32_t kFalse = 20;
    PlanarGraph graph = ManhattanWorld({.poses = 3500}).graph;
    RandomStream random(3, RandomPurpose::association, 0, 0);
    for (std::uint32_t i = 0; i < kFalse; ++i) {
        PlanarEdge edge = graph.edges.front();
        edge.from = random.next() % 1700U;
        edge.to = 1800U + random.next() % 1700U;
        edge.z.setZero();
        graph.edges.push_back(edge);
    }
    EXPECT_TRUE(solve(graph, true).converged);
    const std::vector<std::size_t> worst = worst_edges(graph, kFalse + 1);
    for (std::uint32_t i = 0; i < kFalse; ++i) EXPECT_GE(worst[i], graph.edges.size() - kFalse);
    EXPECT_LT(mahalanobis_squared(graph, graph.edges[worst.back()]), 50.0);
}

TEST(PlanarGraph, TellsTheWorstEdgesInOrder) {
    const PlanarGraph graph = small_world();
    const std::vector<std::size_t> worst = worst_edges(graph, 5);
    ASSERT_EQ(worst.size(), 5U);
    for (std::size_t i = 1; i < worst.size(); ++i) {
        EXPECT_GE(mahalanobis_squared(graph, graph.edges[worst[i - 1]]),
                  mahalanobis_squared(graph, graph.edges[worst[i]]));
    }
    EXPECT_EQ(worst_edges(graph, 1U << 30U).size(), graph.edges.size());
}

TEST(PlanarGraph, RefusesErrorsBeyondReckoning) {
    PlanarGraph graph;
    graph.vertices.resize(2);
    PlanarEdge& edge = graph.edges.emplace_back();
    edge.to = 1;
    edge.z << 1e200, 0.0, 0.0;
    edge.information = Eigen::Vector3d(1.0, 1.0, 1.0).asDiagonal();
    EXPECT_THAT(message_of<Error>([&] { solve(graph, false); }), HasSubstr("beyond reckoning"));
}

TEST(PlanarGraph, RefusesWhatWouldTakeAllMemory) {
    constexpr std::uint32_t kPoses = 30'000;
    PlanarGraph graph;
    graph.vertices.resize(kPoses);
    RandomStream random(1, RandomPurpose::association, 0, 0);
    for (std::uint32_t i = 0; i < 3 * kPoses; ++i) {
        PlanarEdge& edge = graph.edges.emplace_back();
        edge.from = i % kPoses;
        edge.to = (edge.from + 1 + random.next() % (kPoses - 1)) % kPoses;
        edge.information = Eigen::Matrix3d::Identity();
    }
    EXPECT_THAT(message_of<Error>([&] { solve(graph, false); }),
                HasSubstr("takes more than 100 million numbers"));
}

/// 0 to 3 in a row, with the ids 10 to 40, and an edge from 40 back to 10.
PlanarGraph row() {
    PlanarGraph graph;
    for (std::uint32_t i = 0; i < 4; ++i) {
        PlanarVertex& vertex = graph.vertices.emplace_back();
        vertex.id = std::uint64_t{10} * (i + 1);
        vertex.at << i, 0.0, 0.0;
        PlanarEdge& edge = graph.edges.emplace_back();
        edge.from = i;
        edge.to = (i + 1) % 4;
        edge.z << (i < 3 ? 1.0 : -3.0), 0.0, 0.0;
        edge.information = Eigen::Vector3d(100.0, 100.0, 400.0).asDiagonal();
    }
    graph.vertices.front().fixed = true;
    return graph;
}

PlanarGraph edited(std::string_view changes) {
    PlanarGraph graph = row();
    edit(graph, parse_vertex_edits(changes, "edits"));
    return graph;
}

TEST(PlanarGraph, IsEditedByHand) {
    EXPECT_EQ(edited("refuse 40 10").edges.size(), 3U);
    EXPECT_EQ(edited("refuse 10 40 # either way").edges.size(), 3U);
    PlanarGraph graph = edited("close 30 10 2.5 0 0\nslip 20");
    ASSERT_EQ(graph.edges.size(), 5U);
    EXPECT_EQ(graph.edges[4].from, 0U) << "30 seen from 10";
    EXPECT_EQ(graph.edges[4].to, 2U);
    EXPECT_TRUE(graph.edges[4].by_hand);
    EXPECT_NEAR(graph.edges[4].information(0, 0), 400.0, 1e-9) << "5 cm";
    EXPECT_EQ(graph.edges[0].information, Eigen::Matrix3d::Identity());
    EXPECT_EQ(graph.edges[1].information, row().edges[1].information);
    solve(graph, false);
    EXPECT_NEAR(graph.vertices[2].at(0), 2.4, 0.1);
    graph = edited("fix 40 3 1 0");
    ASSERT_EQ(graph.edges.size(), 5U);
    EXPECT_EQ(graph.edges[4].kind, EdgeKind::pose_prior);
    EXPECT_NEAR(graph.edges[4].information(0, 0), 1e4, 1e-6) << "1 cm";
    solve(graph, false);
    EXPECT_NEAR(graph.vertices[3].at(1), 1.0, 0.05);
}

TEST(PlanarGraph, EditsAreWrittenAsTheyWereRead) {
    const std::string text =
        "refuse 812 40  # the kitchen; not the hall\nclose 9000000000 37 0.1 -0.25 1.57\n"
        "fix 0 1e-05 -2 6.28\nslip 55\n";
    const std::vector<GraphEdit> edits = parse_vertex_edits(text, "edits").edits;
    EXPECT_EQ(vertex_text_of(edits), text);
    EXPECT_EQ(parse_vertex_edits(vertex_text_of(edits), "edits").edits, edits);
}

TEST(PlanarGraph, RefusesEditsThatMeetNothing) {
    const auto refusal = [](std::string_view changes) {
        return message_of<FormatError>([&] { edited(changes); });
    };
    EXPECT_THAT(refusal("slip 20; refuse 30 10"),
                HasSubstr("edits:1: change 2: the graph has no edge between the poses 30 and 10"));
    EXPECT_THAT(refusal("refuse 10 20; slip 20"), HasSubstr("no edge between the poses 10 and 20"));
    EXPECT_THAT(refusal("slip 15"), HasSubstr("the graph has no pose with the id 15"));
    EXPECT_THAT(refusal("close 10 18446744073709551615 0 0 0"),
                HasSubstr("id 18446744073709551615"));
    EXPECT_THAT(refusal("slip 10"), HasSubstr("pose 10 has the lowest id"));
    EXPECT_THAT(refusal("slip 20; wall 20 0 0 0 4 0"),
                HasSubstr("change 2: a graph from a file has no scans that see a wall"));
    EXPECT_THAT(refusal("point 20 0 0 4 0"), HasSubstr("change 1: a graph from a file"));
    EXPECT_THAT(refusal("fix 10 0 0 0"), HasSubstr("pose 10 is fixed by the graph already"));
}

}  // namespace
}  // namespace hitos
