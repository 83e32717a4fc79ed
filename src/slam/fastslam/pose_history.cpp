// SPDX-License-Identifier: GPL-3.0-or-later
#include "pose_history.hpp"

#include "models/sound.hpp"

namespace hitos {

void PoseHistory::check(std::span<const Node> leaves, std::size_t scans) const {
    const std::size_t nodes = poses_.size();
    std::vector<bool> is_free(nodes, false);
    for (const Node node : free_) {
        expect_sound(node < nodes && !is_free[node], "history: node {} of {} is free twice", node,
                     nodes);
        is_free[node] = true;
    }
    std::vector<std::uint32_t> holders(nodes, 0);
    const auto hold = [&](Node node, const char* kind, std::size_t holder) {
        if (node == kNone) return;
        expect_sound(node < nodes && !is_free[node],
                     "history: {} {} holds node {} of {}, which is free or none", kind, holder,
                     node, nodes);
        ++holders[node];
    };
    for (std::size_t i = 0; i < leaves.size(); ++i) hold(leaves[i], "particle", i);
    for (Node node = 0; node < nodes; ++node) {
        if (!is_free[node]) hold(parents_[node], "node", node);
    }
    std::vector<std::size_t> length(nodes, 0);  // of the way to the node
    std::vector<Node> way;
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        way.clear();
        Node node = leaves[i];
        for (; node != kNone && length[node] == 0; node = parents_[node]) {
            way.push_back(node);
            expect_sound(way.size() <= nodes, "history: the way of particle {} has no end", i);
        }
        std::size_t poses = node == kNone ? 0 : length[node];
        for (std::size_t k = way.size(); k-- > 0;) length[way[k]] = ++poses;
        expect_sound(poses == scans, "history: the way of particle {} has {} poses for {} scans", i,
                     poses, scans);
    }
    for (Node node = 0; node < nodes; ++node) {
        expect_sound(holders[node] == references_[node],
                     "history: node {} is held {} times, and counts {}", node, holders[node],
                     references_[node]);
        expect_sound(is_free[node] || length[node] > 0,
                     "history: node {} is in use, and no particle reaches it", node);
    }
}

}  // namespace hitos
