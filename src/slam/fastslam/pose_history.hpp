// SPDX-License-Identifier: GPL-3.0-or-later
// Pose histories that share their past.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hitos/slam/slam_filter.hpp"

namespace hitos {

/// A tree of poses: every particle holds a leaf, the way from it to the root is the particle's
/// history. Copying a history costs one count; branches that no particle holds are freed, so
/// memory grows with the length of the tour plus the width of the newest, unmerged part.
class PoseHistory {
  public:
    using Node = std::uint32_t;
    static constexpr Node kNone = UINT32_MAX;

    PoseHistory() = default;
    PoseHistory(const PoseHistory&) = delete;
    PoseHistory& operator=(const PoseHistory&) = delete;
    ~PoseHistory() = default;

    /// Becomes what somebody holds of the other's nodes, side by side; `leaves` are made to name
    /// them.
    void assign_held(const PoseHistory& other, std::span<Node* const> leaves) {
        std::vector<Node> numbers(other.poses_.size(), kNone);
        std::vector<Node> held;
        held.reserve(other.size());
        for (Node node = 0; node < other.poses_.size(); ++node) {
            if (other.references_[node] == 0) continue;
            numbers[node] = static_cast<Node>(held.size());
            held.push_back(node);
        }
        const auto now = [&](Node node) { return node == kNone ? kNone : numbers[node]; };
        poses_.resize(held.size());
        parents_.resize(held.size());
        references_.resize(held.size());
        free_.clear();
        for (std::size_t i = 0; i < held.size(); ++i) {
            poses_[i] = other.poses_[held[i]];
            parents_[i] = now(other.parents_[held[i]]);
            references_[i] = other.references_[held[i]];
        }
        for (Node* const leaf : leaves) *leaf = now(*leaf);
    }

    /// A new pose after `parent` (kNone: the first). The caller's hold on `parent` passes to the
    /// new node, which the caller holds.
    Node append(Node parent, const Pose& pose) {
        begin_row(1);
        const Node node = append_in_row(0, parent, pose);
        end_row();
        return node;
    }
    /// Makes room for a new pose in each of `count` histories. Then any worker may append any.
    void begin_row(std::size_t count) {
        reused_ = std::min(count, free_.size());
        first_new_ = poses_.size();
        const std::size_t size = first_new_ + count - reused_;
        if (size == first_new_) return;
        references_.resize(size);  // what may fail; poses count
        parents_.resize(size);
        poses_.resize(size);
    }
    /// The `place`-th append() of a row.
    Node append_in_row(std::size_t place, Node parent, const Pose& pose) {
        const Node node = place < reused_ ? free_[free_.size() - 1 - place]
                                          : static_cast<Node>(first_new_ + place - reused_);
        poses_[node] = pose;
        parents_[node] = parent;
        references_[node] = 1;
        return node;
    }
    void end_row() { free_.resize(free_.size() - reused_); }

    void share(Node node, std::uint32_t times = 1) {
        if (node != kNone) references_[node] += times;
    }

    void release(Node node) { release(node, free_, true); }
    void release(std::span<const Node> nodes) { release(nodes, free_, true); }

    /// Releases all of these, which stand in memory in no order. Where no worker is alone, others
    /// may release at the same time; take_back() gets what was `freed`.
    void release(std::span<const Node> nodes, std::vector<Node>& freed, bool alone) noexcept {
        constexpr std::size_t kAhead = 8;
        const auto ahead = [&](std::size_t i) { return i < nodes.size() ? nodes[i] : kNone; };
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            if (const Node later = ahead(i + 2 * kAhead); later != kNone) {
                __builtin_prefetch(&references_[later]);
                __builtin_prefetch(&parents_[later]);
            }
            if (const Node later = ahead(i + kAhead); later != kNone && parents_[later] != kNone) {
                __builtin_prefetch(&references_[parents_[later]]);
            }
            release(nodes[i], freed, alone);
        }
    }
    void take_back(std::vector<Node>& freed) noexcept {
        for (const Node node : freed) note_free(node, free_);
        freed.clear();
    }

    /// Moves all poses that these nodes, all of the newest scan, have behind them and their own:
    /// each by the motion of its scan.
    void move(std::span<const Node> newest, std::span<const Pose> by_scan) {
        std::vector<bool> moved(poses_.size(), false);
        for (Node node : newest) {
            for (std::size_t scan = by_scan.size(); node != kNone && !moved[node];) {
                poses_[node] = compose(by_scan[--scan], poses_[node]);
                moved[node] = true;
                node = parents_[node];
            }
        }
    }

    /// Poses from the first to `node`.
    std::vector<Pose> path(Node node) const {
        std::vector<Pose> poses;
        for (; node != kNone; node = parents_[node]) poses.push_back(poses_[node]);
        std::reverse(poses.begin(), poses.end());
        return poses;
    }

    /// What the leaves, all of the newest scan, have behind them, as branches; the oldest first.
    std::vector<HistoryBranch> branches(std::span<const Node> leaves) const {
        constexpr std::size_t kNoBranch = SIZE_MAX;
        std::vector<HistoryBranch> branches;
        std::vector<std::size_t> branch_of(poses_.size(), kNoBranch);
        std::vector<Node> level;  // nodes of one scan
        std::vector<Node> before;
        const auto open = [&](Node node, std::vector<Node>& nodes) {
            branch_of[node] = branches.size();
            branches.emplace_back();
            nodes.push_back(node);
        };
        for (const Node leaf : leaves) {
            if (leaf == kNone) continue;
            if (branch_of[leaf] == kNoBranch) open(leaf, level);
            ++branches[branch_of[leaf]].particles;
        }
        std::uint64_t behind = 0;  // scans, until the newest
        for (; !level.empty(); level.swap(before), ++behind) {
            before.clear();
            for (const Node node : level) {
                const std::size_t branch = branch_of[node];
                branches[branch].poses.push_back(poses_[node]);
                branches[branch].first = behind;
                const Node parent = parents_[node];
                if (parent == kNone) continue;
                if (references_[parent] == 1) {
                    branch_of[parent] = branch;
                    before.push_back(parent);
                    continue;
                }
                if (branch_of[parent] == kNoBranch) open(parent, before);
                branches[branch].poses.push_back(poses_[parent]);
                branches[branch].first = behind + 1;
                branches[branch_of[parent]].particles += branches[branch].particles;
            }
        }
        for (HistoryBranch& branch : branches) {
            std::ranges::reverse(branch.poses);
            branch.first = behind - 1 - branch.first;
        }
        std::ranges::reverse(branches);
        return branches;
    }

    /// Throws std::logic_error where the tree is not what these leaves, of so many scans, hold:
    /// counts that are others than the holders, nodes that are held and free, or neither, ways of
    /// another length.
    void check(std::span<const Node> leaves, std::size_t scans) const;

    std::size_t bytes() const {
        return poses_.size() * (sizeof(Pose) + sizeof(Node) + sizeof(std::uint32_t)) +
               free_.size() * sizeof(Node);
    }
    /// Nodes in use.
    std::size_t size() const { return poses_.size() - free_.size(); }

  private:
    static void note_free(Node node, std::vector<Node>& free) noexcept {
        try {
            free.push_back(node);
        } catch (...) {  // no memory to note it: it is used no more, which is all
        }
    }
    void release(Node node, std::vector<Node>& freed, bool alone) noexcept {
        while (node != kNone) {
            std::uint32_t& holds = references_[node];
            // Who holds it last must see what the others have done with it.
            const std::uint32_t left =
                alone ? --holds
                      : std::atomic_ref(holds).fetch_sub(1, std::memory_order_acq_rel) - 1;
            if (left != 0) return;
            note_free(node, freed);
            node = parents_[node];
        }
    }

    // Of every node. Counts apart from the rest: resampling runs through them in no order.
    std::vector<Pose> poses_;
    std::vector<Node> parents_;
    std::vector<std::uint32_t> references_;
    std::vector<Node> free_;
    // Of the row that is being appended.
    std::size_t reused_ = 0;
    std::size_t first_new_ = 0;
};

}  // namespace hitos
