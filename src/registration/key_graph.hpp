// SPDX-License-Identifier: GPL-3.0-or-later
// The key scans of a tour with the edges between them, and how far they are from each other.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "hitos/registration/pose_graph.hpp"
#include "point_map.hpp"
#include "scan_matcher.hpp"

namespace hitos {

/// What the graph keeps of a key beside its pose.
struct KeyScan {
    std::span<const SurfacePoint> points() const { return *points_; }  ///< robot frame
    void hold(std::vector<SurfacePoint> points) {
        points_ = std::make_shared<const std::vector<SurfacePoint>>(std::move(points));
    }
    double travelled_m = 0.0;  ///< way driven up to it
    /// Variance of the position and of the heading against the key before.
    double variance_m2 = 0.0;
    double variance_rad2 = 0.0;

  private:
    // Copies of a graph share them: they never change.
    std::shared_ptr<const std::vector<SurfacePoint>> points_ =
        std::make_shared<const std::vector<SurfacePoint>>();
};

/// Where two passages are at one place: the way driven until each.
struct Joint {
    static constexpr double kAlong = 12.0;  // [m] of way without a joint
    static constexpr double kBeside = 5.0;  // [m] of way, as wide as what is searched for
    double later_m;
    double earlier_m;

    /// Whether the robot comes from one to the other along both passages, the same way round or
    /// the other.
    bool is_near(const Joint& other) const {
        const double later = std::abs(later_m - other.later_m);
        const double earlier = std::abs(earlier_m - other.earlier_m);
        return later <= kAlong && std::abs(earlier - later) <= kBeside;
    }
};

/// Keys in the order of the tour. Memory is linear in their number.
class KeyGraph {
  public:
    std::vector<KeyPose> poses;
    std::vector<KeyScan> scans;
    std::vector<PoseEdge> edges;

    std::size_t size() const { return poses.size(); }
    /// `in_crowd`: at a place where so many keys were that it says nothing new (older_keys). Those
    /// of a way through such places come to rest when the robot is far enough along: nothing leads
    /// to them any more, so that who goes the same way all day has no more keys to look at than
    /// after a dozen times.
    void add(const KeyPose& pose, KeyScan scan, bool in_crowd = false);
    bool rests(std::size_t key) const { return rests_[key]; }
    /// Those that do not, ascending.
    std::span<const std::uint32_t> awake() const { return awake_; }
    /// The keys of other passages that see the same walls, but for those that rest.
    std::span<const std::uint32_t> joined(std::size_t key) const { return joined_[key]; }
    bool is_cut_before(std::size_t key) const {
        return !cuts_.empty() && std::ranges::binary_search(cuts_, key);
    }
    /// A key that rests and has an edge from one that does not loses those from others that rest:
    /// it hangs on keys that stay, and costs a solution next to nothing. Its step by the odometry
    /// becomes one from the first of these to where it lies, as sure as the step was.
    /// Whether any edge is another.
    bool thin_resting();
    /// The same where many have come to rest since.
    bool thin_if_many_rest();
    /// Cuts the tour before a key: no edge but those by hand stays between the keys before it and
    /// the others, until one joins them.
    void cut(std::size_t begin);
    /// That two keys of different passages saw the same walls. Who rested is led to again.
    void join(std::uint32_t a, std::uint32_t b);
    /// The first key of the part that a key belongs to.
    std::size_t part_begin(std::size_t key) const;
    /// The key at a scan, else the last one before it; there is one.
    std::size_t key_at(std::uint64_t scan) const;
    Joint joint_at(std::uint64_t scan, std::uint64_t earlier) const {
        return {scans[key_at(scan)].travelled_m, scans[key_at(earlier)].travelled_m};
    }

    /// Puts to `found` edges from what a scan says against each key of a map at `pose`, where it
    /// became key `to`: `by_source` belongs to the keys `sources`. Left out are those of fewer than
    /// 8 matches, or where the key alone would move the scan by more than half a metre. An edge is
    /// of a loop where its key is none of the `newest` before `to`.
    void find_scan_edges(std::uint32_t to, const Pose& pose, std::span<const std::uint32_t> sources,
                         std::span<const Linearization> by_source, double information,
                         std::size_t newest, std::vector<PoseEdge>& found) const;

  private:
    bool is_anchored(std::size_t key) const;
    void rest(std::size_t key);
    void wake(std::size_t key);

    std::vector<std::vector<std::uint32_t>> joined_;
    std::vector<std::size_t> cuts_;  // ascending
    std::vector<bool> in_crowd_;
    std::vector<bool> rests_;
    std::vector<std::uint32_t> awake_;
    std::size_t unjudged_ = 0;  // the first key that may still come to rest
    std::size_t rest_ = 0;      // how many have since edges were thinned
};

inline double distance_m(const Pose& a, const Pose& b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}
/// The same as distance_m(a, b) < far_m, which takes longer where most are not.
inline bool is_within(const Pose& a, const Pose& b, double far_m) {
    return std::abs(a.x - b.x) < far_m && std::abs(a.y - b.y) < far_m && distance_m(a, b) < far_m;
}

/// [m] How far from a map's middle older keys may be that take part in it.
inline constexpr double kNearKey = 6.0;

/// A map about `at` for the key that comes at `end`, or is there: of its part the `newest` keys
/// before it, and half as many older ones.
struct MapOfKeys {
    std::size_t end;
    Pose at;
    std::size_t newest;
};
/// `crowd` where hardly farther ones are many times as many: then they are the oldest of those.
struct OlderKeys {
    std::vector<std::uint32_t> keys;
    bool crowd = false;
};
/// Of `beside`, keys near the map's middle in ascending order, the `most` nearest of those that are
/// older than the newest ones, nearest first.
OlderKeys older_keys(const KeyGraph& graph, const MapOfKeys& map,
                     std::span<const std::uint32_t> beside, std::size_t most);

/// Which keys make the map: the newest ones, and of these older ones, in any order, the nearest
/// within kNearKey.
void select_keys(const KeyGraph& graph, const MapOfKeys& map, std::span<const std::uint32_t> older,
                 std::vector<std::uint32_t>& selected);

/// Puts those keys' points into a map about `centre`; a point's source is its key's place in
/// `selected`.
void build_map(const KeyGraph& graph, std::span<const std::uint32_t> selected, const Pose& centre,
               double half_m, PointMap& map);

}  // namespace hitos
