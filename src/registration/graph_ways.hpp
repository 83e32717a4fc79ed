// SPDX-License-Identifier: GPL-3.0-or-later
// How far the keys of a tour are from one of them along the graph.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "key_graph.hpp"

namespace hitos {

/// How far a key is from another one along the graph.
struct GraphReach {
    static constexpr double kNever = 1e9;
    double way_m = kNever;  ///< a joint between passages counts 0.1 m
    double variance_m2 = kNever;
    double variance_rad2 = kNever;
};

/// Of every key from one key, by the way of least variance: each step adds its own and what its
/// heading does at the distance to where one looks from. Nothing leads over a cut but where a loop
/// joins both sides, nor to who rests. The ways are gone only until what somebody asks for is known
/// (Dijkstra, 1959), since most keys of a long tour are far behind those.
class GraphWays {
  public:
    /// From a key of a graph that stays as it is while it is asked about. Nothing that is `way_m`
    /// away along the graph is gone on from, and nothing so far as the crow flies is reached.
    void begin(const KeyGraph& graph, std::size_t from, double way_m = GraphReach::kNever);
    const GraphReach& to(std::size_t key);
    /// The keys within `radius_m` of where it began, less than `way_m` away along the graph,
    /// ascending.
    std::vector<std::uint32_t> beside(double radius_m, double way_m);

  private:
    using Open = std::pair<double, std::uint32_t>;  // variance, key

    void go_on();
    void open(std::uint32_t key, const GraphReach& reach);

    const KeyGraph* graph_ = nullptr;
    std::size_t from_ = 0;
    double way_m_ = GraphReach::kNever;
    std::vector<GraphReach> reached_;
    std::vector<std::uint32_t> touched_;  // what is not as at the beginning
    std::vector<Open> open_;              // a heap, least variance first
};

}  // namespace hitos
