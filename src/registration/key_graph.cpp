// SPDX-License-Identifier: GPL-3.0-or-later
#include "key_graph.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "hitos/registration/odometry_step.hpp"
#include "hitos/registration/pose_algebra.hpp"

namespace hitos {

void KeyGraph::add(const KeyPose& pose, KeyScan scan, bool in_crowd) {
    constexpr double kAwake = 20.0;  // [m] of way behind the newest key, more than loops look at
    poses.push_back(pose);
    scans.push_back(std::move(scan));
    joined_.emplace_back();
    in_crowd_.push_back(in_crowd);
    rests_.push_back(false);
    awake_.push_back(static_cast<std::uint32_t>(size() - 1));
    for (; scans.back().travelled_m - scans[unjudged_].travelled_m > kAwake; ++unjudged_) {
        const std::size_t key = unjudged_;
        if (key > 0 && in_crowd_[key - 1] && in_crowd_[key] && in_crowd_[key + 1]) rest(key);
    }
}

/// Whether it is joined to an older key that never comes to rest.
bool KeyGraph::is_anchored(std::size_t key) const {
    return std::ranges::any_of(
        joined_[key], [&](std::uint32_t other) { return other < key && !in_crowd_[other]; });
}

/// It leads to others still. Those beside it are anchored too, so that every stretch of keys that
/// do not rest is still led to by its first one.
void KeyGraph::rest(std::size_t key) {
    if (!is_anchored(key - 1) || !is_anchored(key) || !is_anchored(key + 1)) return;
    rests_[key] = true;
    awake_.erase(std::ranges::lower_bound(awake_, key));
    ++rest_;
    for (const std::uint32_t other : joined_[key]) std::erase(joined_[other], key);
}

bool KeyGraph::thin_resting() {
    rest_ = 0;
    constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> anchors(size(), kNone);  // of who rests, the first one
    for (const PoseEdge& edge : edges) {
        const bool seen = edge.kind == EdgeKind::scan || edge.kind == EdgeKind::loop;
        if (!seen || !rests_[edge.to] || rests_[edge.from]) continue;
        anchors[edge.to] = std::min(anchors[edge.to], edge.from);
    }
    const auto among_resting = [&](const PoseEdge& edge) {
        return !edge.said() && rests_[edge.to] && rests_[edge.from] && anchors[edge.to] != kNone;
    };
    bool changed = false;
    for (PoseEdge& edge : edges) {
        if (edge.kind != EdgeKind::odometry || !among_resting(edge)) continue;
        changed = true;
        const Pose& anchor = poses[anchors[edge.to]].pose;
        edge.information = turned(edge.information, poses[edge.from].pose.theta - anchor.theta);
        edge.z = between(anchor, poses[edge.to].pose);
        edge.from = anchors[edge.to];
    }
    return std::erase_if(edges, among_resting) > 0 || changed;
}

void KeyGraph::cut(std::size_t begin) {
    if (!std::ranges::binary_search(cuts_, begin))
        cuts_.insert(std::ranges::upper_bound(cuts_, begin), begin);
    const auto across = [&](std::size_t a, std::size_t b) { return (a < begin) != (b < begin); };
    std::erase_if(edges,
                  [&](const PoseEdge& edge) { return !edge.said() && across(edge.from, edge.to); });
    for (std::size_t key = 0; key < size(); ++key) {
        std::erase_if(joined_[key], [&](std::uint32_t other) { return across(key, other); });
    }
    for (const PoseEdge& edge : edges) {
        if (edge.kind == EdgeKind::by_hand && across(edge.from, edge.to)) join(edge.from, edge.to);
    }
}

bool KeyGraph::thin_if_many_rest() {
    constexpr std::size_t kMany = 100;  // all edges are looked at for them
    return rest_ >= kMany && thin_resting();
}

void KeyGraph::wake(std::size_t key) {
    if (!rests_[key]) return;
    rests_[key] = false;
    awake_.insert(std::ranges::lower_bound(awake_, key), static_cast<std::uint32_t>(key));
    for (const std::uint32_t other : joined_[key])
        joined_[other].push_back(static_cast<std::uint32_t>(key));
}

void KeyGraph::join(std::uint32_t a, std::uint32_t b) {
    wake(a);
    wake(b);
    joined_[a].push_back(b);
    joined_[b].push_back(a);
}

std::size_t KeyGraph::part_begin(std::size_t key) const {
    const auto after = std::ranges::upper_bound(cuts_, key);
    return after == cuts_.begin() ? 0 : *std::prev(after);
}

std::size_t KeyGraph::key_at(std::uint64_t scan) const {
    const auto after = std::ranges::upper_bound(poses, scan, {}, &KeyPose::scan);
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, after - poses.begin())) - 1;
}

void KeyGraph::find_scan_edges(std::uint32_t to, const Pose& pose,
                               std::span<const std::uint32_t> sources,
                               std::span<const Linearization> by_source, double information,
                               std::size_t newest, std::vector<PoseEdge>& found) const {
    constexpr int kFewestMatches = 8;
    constexpr double kFar = 0.5;  // [m], a third of a radian counts a metre
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const Linearization& l = by_source[i];
        if (sources[i] == to || l.matches < kFewestMatches) continue;
        const Eigen::Matrix3d h = information * l.h;
        // The unit matrix holds what the key does not determine.
        const Eigen::Vector3d step =
            -(h + Eigen::Matrix3d::Identity()).ldlt().solve(Eigen::Vector3d(information * l.b));
        if (!(std::abs(step(0)) + std::abs(step(1)) + 3.0 * std::abs(step(2)) <= kFar)) continue;
        const Pose& from = poses[sources[i]].pose;
        found.push_back({sources[i], to, between(from, shifted(pose, step)), turned(h, -from.theta),
                         to - sources[i] > newest || part_begin(to) != part_begin(sources[i])
                             ? EdgeKind::loop
                             : EdgeKind::scan});
    }
}

namespace {

/// The first of the newest keys that a map has.
std::size_t first_new(const KeyGraph& graph, const MapOfKeys& map) {
    const std::size_t begin = graph.part_begin(std::min(map.end, graph.size() - 1));
    return std::max(begin, map.end > map.newest ? map.end - map.newest : 0);
}

/// The `most` nearest, nearest first. Where a crowd of others is hardly farther, since the robot
/// has gone the same way a dozen times, the oldest of all of them, oldest first: tied to passages
/// at random a graph of many is one whose factor grows with the square of its keys.
OlderKeys nearest_of(std::vector<std::pair<double, std::uint32_t>> keys, std::size_t most) {
    constexpr std::size_t kCrowd = 4;       // times as many as are wanted
    constexpr double kHardlyFarther = 0.5;  // [m]
    const std::size_t kept = std::min(keys.size(), most);
    const auto end = keys.begin() + static_cast<std::ptrdiff_t>(kept);
    std::partial_sort(keys.begin(), end, keys.end());
    OlderKeys nearest;
    if (kept > 0) {
        const double farthest_m = std::prev(end)->first + kHardlyFarther;
        const auto crowd = std::partition(end, keys.end(),
                                          [&](const auto& key) { return key.first < farthest_m; });
        nearest.crowd = crowd - keys.begin() > static_cast<std::ptrdiff_t>(kCrowd * most);
        if (nearest.crowd) {
            std::ranges::partial_sort(keys.begin(), end, crowd, {},
                                      &std::pair<double, std::uint32_t>::second);
        }
    }
    nearest.keys.reserve(kept);
    for (std::size_t i = 0; i < kept; ++i) nearest.keys.push_back(keys[i].second);
    return nearest;
}

}  // namespace

OlderKeys older_keys(const KeyGraph& graph, const MapOfKeys& map,
                     std::span<const std::uint32_t> beside, std::size_t most) {
    std::vector<std::pair<double, std::uint32_t>> older;
    const std::size_t end = first_new(graph, map);
    for (const std::uint32_t j : beside) {
        if (j < end) older.emplace_back(distance_m(graph.poses[j].pose, map.at), j);
    }
    return nearest_of(std::move(older), most);
}

void select_keys(const KeyGraph& graph, const MapOfKeys& map, std::span<const std::uint32_t> older,
                 std::vector<std::uint32_t>& selected) {
    selected.clear();
    for (std::size_t j = first_new(graph, map); j < map.end; ++j)
        selected.push_back(static_cast<std::uint32_t>(j));
    std::vector<std::pair<double, std::uint32_t>> near;
    for (const std::uint32_t j : older) {
        const double distance = distance_m(graph.poses[j].pose, map.at);
        if (distance < kNearKey) near.emplace_back(distance, j);
    }
    std::ranges::copy(nearest_of(std::move(near), map.newest / 2).keys,
                      std::back_inserter(selected));
}

void build_map(const KeyGraph& graph, std::span<const std::uint32_t> selected, const Pose& centre,
               double half_m, PointMap& map) {
    map.begin({centre.x, centre.y}, half_m);
    for (std::size_t i = 0; i < selected.size(); ++i) {
        map.add(graph.scans[selected[i]].points(), graph.poses[selected[i]].pose,
                static_cast<std::uint32_t>(i));
    }
    map.build();
}

}  // namespace hitos
