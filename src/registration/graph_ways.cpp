// SPDX-License-Identifier: GPL-3.0-or-later
#include "graph_ways.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace hitos {

void GraphWays::begin(const KeyGraph& graph, std::size_t from, double way_m) {
    graph_ = &graph;
    from_ = from;
    way_m_ = way_m;
    for (const std::uint32_t key : touched_) reached_[key] = {};
    touched_.clear();
    reached_.resize(graph.size());
    open_.clear();
    open(static_cast<std::uint32_t>(from), {0.0, 0.0, 0.0});
}

void GraphWays::open(std::uint32_t key, const GraphReach& reach) {
    if (reached_[key].variance_m2 == GraphReach::kNever) touched_.push_back(key);
    reached_[key] = reach;
    open_.emplace_back(reach.variance_m2, key);
    std::ranges::push_heap(open_, std::greater<>());
}

const GraphReach& GraphWays::to(std::size_t key) {
    if (graph_->rests(key) && key != from_) return reached_[key];  // never
    while (!open_.empty() && open_.front().first < reached_[key].variance_m2) go_on();
    return reached_[key];
}

/// From the nearest one whose neighbours nobody has looked at.
void GraphWays::go_on() {
    constexpr double kJointWay = 0.1;
    constexpr double kJointVariance = 1e-4;     // (1 cm)^2
    constexpr double kJointVarianceRad = 1e-6;  // (1 mrad)^2
    const double variance = open_.front().first;
    const std::uint32_t i = open_.front().second;
    std::ranges::pop_heap(open_, std::greater<>());
    open_.pop_back();
    const GraphReach here = reached_[i];
    if (variance > here.variance_m2 || here.way_m >= way_m_) return;
    const KeyGraph& graph = *graph_;
    const Pose& from = graph.poses[from_].pose;
    const auto go = [&](std::size_t j, double way, double variance_m2, double variance_rad2) {
        if (graph.rests(j) || reached_[j].variance_m2 <= variance) return;  // or it has its way
        const double dx = graph.poses[j].pose.x - from.x;
        const double dy = graph.poses[j].pose.y - from.y;
        const double far = dx * dx + dy * dy;
        const double there = variance + variance_m2 + variance_rad2 * far;
        if (there >= reached_[j].variance_m2 || far >= way_m_ * way_m_) return;
        open(static_cast<std::uint32_t>(j),
             {here.way_m + way, there, here.variance_rad2 + variance_rad2});
    };
    const auto along = [&](std::size_t step, std::size_t j) {  // from key step - 1 to key step
        go(j, graph.scans[step].travelled_m - graph.scans[step - 1].travelled_m,
           graph.scans[step].variance_m2, graph.scans[step].variance_rad2);
    };
    if (i > 0 && !graph.is_cut_before(i)) along(i, i - 1);
    if (i + 1 < graph.size() && !graph.is_cut_before(i + 1)) along(i + 1, i + 1);
    for (const std::uint32_t j : graph.joined(i)) {
        go(j, kJointWay, kJointVariance, kJointVarianceRad);
    }
}

std::vector<std::uint32_t> GraphWays::beside(double radius_m, double way_m) {
    const Pose& from = graph_->poses[from_].pose;
    std::vector<std::uint32_t> keys;
    for (const std::uint32_t j : graph_->awake()) {
        if (is_within(graph_->poses[j].pose, from, radius_m) && to(j).way_m < way_m)
            keys.push_back(j);
    }
    return keys;
}

}  // namespace hitos
