// Pose histories that share their past.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "hitos/base/geometry.hpp"

namespace hitos {

/// A tree of poses: every particle holds a leaf, the way from it to the root is the particle's
/// history. Copying a history costs one count; branches that no particle holds are freed, so
/// memory grows with the length of the tour plus the width of the newest, unmerged part.
class PoseHistory {
  public:
    using Node = std::uint32_t;
    static constexpr Node kNone = UINT32_MAX;

    /// A new pose after `parent` (kNone: the first). The caller's hold on `parent` passes to the
    /// new node, which the caller holds.
    Node append(Node parent, const Pose& pose) {
        if (free_.empty()) {
            nodes_.push_back({pose, parent, 1});
            return static_cast<Node>(nodes_.size() - 1);
        }
        const Node node = free_.back();
        free_.pop_back();
        nodes_[node] = {pose, parent, 1};
        return node;
    }

    void share(Node node) {
        if (node != kNone) ++nodes_[node].references;
    }

    void release(Node node) {
        while (node != kNone && --nodes_[node].references == 0) {
            free_.push_back(node);
            node = nodes_[node].parent;
        }
    }

    /// Moves all poses that these nodes, all of the newest scan, have behind them and their own:
    /// each by the motion of its scan.
    void move(std::span<const Node> newest, std::span<const Pose> by_scan) {
        std::vector<bool> moved(nodes_.size(), false);
        for (Node node : newest) {
            for (std::size_t scan = by_scan.size(); node != kNone && !moved[node];) {
                Entry& entry = nodes_[node];
                entry.pose = compose(by_scan[--scan], entry.pose);
                moved[node] = true;
                node = entry.parent;
            }
        }
    }

    /// Poses from the first to `node`.
    std::vector<Pose> path(Node node) const {
        std::vector<Pose> poses;
        for (; node != kNone; node = nodes_[node].parent) poses.push_back(nodes_[node].pose);
        std::reverse(poses.begin(), poses.end());
        return poses;
    }

    std::size_t bytes() const {
        return nodes_.size() * sizeof(Entry) + free_.size() * sizeof(Node);
    }
    /// Nodes in use.
    std::size_t size() const { return nodes_.size() - free_.size(); }

  private:
    struct Entry {
        Pose pose;
        Node parent;
        std::uint32_t references;
    };
    std::vector<Entry> nodes_;
    std::vector<Node> free_;
};

}  // namespace hitos
