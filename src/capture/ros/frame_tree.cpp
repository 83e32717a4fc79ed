// SPDX-License-Identifier: GPL-3.0-or-later
#include "ros/frame_tree.hpp"

#include <algorithm>

#include "hitos/base/error.hpp"

namespace hitos {
namespace {

/// No robot is a longer chain; damage may be a circle.
constexpr std::size_t kLongestChain = 64;

bool is_world_frame(std::string_view frame) {
    const std::string_view name = frame.substr(frame.rfind('/') + 1);
    return name == "map" || name == "world" || name == "earth";
}

}  // namespace

bool is_odometry_frame(std::string_view frame) {
    return frame.ends_with("odom") || frame.ends_with("odom_combined");
}

void FrameTree::hold(const std::vector<StampedTransform>& transforms) {
    constexpr std::size_t kMostFrames = 4096;
    for (const StampedTransform& next : transforms) {
        const auto known = links_.find(next.child_frame);
        if (known != links_.end()) {
            if (known->second.parent != next.header.frame) {
                known->second.parent = next.header.frame;
            }
            known->second.transform = next.transform;
        } else if (links_.size() < kMostFrames) {
            links_.emplace(next.child_frame, Link{next.header.frame, next.transform});
        } else {
            throw FormatError({}, 0, HITOS_TEXT("Errors", "more than %1 frames"), kMostFrames);
        }
    }
}

void FrameTree::complete(const FrameTree& other) {
    for (const auto& [frame, link] : other.links_) links_.emplace(frame, link);
}

void FrameTree::join(const std::string& a, const std::string& b) {
    if (!knows(a)) {
        links_.emplace(a, Link{b, {}});
    } else if (!knows(b)) {
        links_.emplace(b, Link{a, {}});
    }
}

bool FrameTree::differs(const FrameTree& other, std::string_view frame) const {
    constexpr double kNear = 1e-3;
    const auto here = links_.find(frame);
    const auto there = other.links_.find(frame);
    if (here == links_.end() || there == other.links_.end()) return false;
    return here->second.parent != there->second.parent ||
           apart(here->second.transform, there->second.transform) > kNear;
}

std::vector<std::string> FrameTree::above(std::string_view frame, std::string_view end) const {
    std::vector<std::string> names;
    for (auto& [name, transform] : upwards(frame)) {
        if (name == end) break;
        names.push_back(std::move(name));
    }
    return names;
}

std::vector<std::pair<std::string, std::string>> FrameTree::below_odometry() const {
    std::vector<std::pair<std::string, std::string>> found;
    for (const auto& [frame, link] : links_) {
        if (is_odometry_frame(link.parent)) found.emplace_back(frame, link.parent);
    }
    return found;
}

std::vector<std::pair<std::string, Transform>> FrameTree::upwards(std::string_view frame) const {
    std::vector<std::pair<std::string, Transform>> chain{{std::string(frame), Transform{}}};
    while (chain.size() < kLongestChain) {
        const auto link = links_.find(chain.back().first);
        if (link == links_.end()) break;
        chain.emplace_back(link->second.parent,
                           compose(link->second.transform, chain.back().second));
    }
    return chain;
}

std::vector<std::pair<std::string, std::string>> FrameTree::links() const {
    std::vector<std::pair<std::string, std::string>> pairs;
    for (const auto& [frame, link] : links_) pairs.emplace_back(frame, link.parent);
    return pairs;
}

std::optional<Transform> FrameTree::between(std::string_view a, std::string_view b) const {
    if (a == b) return Transform{};
    const auto above_a = upwards(a);
    for (const auto& [frame, frame_b] : upwards(b)) {
        // Beyond these the robot moves: two frames that meet there are not fixed to each other.
        if (frame != a && (is_odometry_frame(frame) || is_world_frame(frame))) break;
        const auto common =
            std::ranges::find(above_a, frame, [](const auto& p) { return p.first; });
        if (common != above_a.end()) return compose(inverse(common->second), frame_b);
    }
    return std::nullopt;
}

std::pair<std::string, std::string> FrameTree::robot_above(std::string_view frame) const {
    const auto chain = upwards(frame);
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
        if (is_odometry_frame(chain[i + 1].first)) return {chain[i].first, chain[i + 1].first};
    }
    for (std::size_t i = 0; i < chain.size(); ++i) {
        if (i + 1 == chain.size() || is_world_frame(chain[i + 1].first)) {
            return {chain[i].first, {}};
        }
    }
    return {std::string(frame), {}};
}

}  // namespace hitos
