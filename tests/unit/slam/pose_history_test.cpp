// SPDX-License-Identifier: GPL-3.0-or-later
#include "fastslam/pose_history.hpp"

#include <gtest/gtest.h>

#include <random>
#include <span>
#include <thread>
#include <utility>
#include <vector>

namespace hitos {
namespace {

/// All ways from the first pose to the newest ones that branches describe, each as often as it is
/// taken.
std::vector<std::vector<Pose>> ways_of(const std::vector<HistoryBranch>& branches,
                                       std::size_t length) {
    std::vector<std::vector<Pose>> ways;
    const auto follow = [&](const auto& self, const HistoryBranch& branch,
                            std::vector<Pose> way) -> void {
        if (!way.empty()) way.pop_back();  // the fork is in both
        way.insert(way.end(), branch.poses.begin(), branch.poses.end());
        if (way.size() == length) {
            ways.insert(ways.end(), branch.particles, way);
            return;
        }
        std::uint32_t particles = 0;
        for (const HistoryBranch& next : branches) {
            if (&next == &branch || next.poses.front() != way.back()) continue;
            self(self, next, way);
            particles += next.particles;
        }
        EXPECT_EQ(particles, branch.particles);
    };
    follow(follow, branches.front(), {});
    return ways;
}

TEST(PoseHistory, BranchesAreTheTreeOfAllHistories) {
    constexpr std::size_t kParticles = 12;
    constexpr std::size_t kSteps = 40;
    std::mt19937 engine(47);
    std::uniform_real_distribution<double> value(-1.0, 1.0);
    std::uniform_int_distribution<std::size_t> pick(0, kParticles - 1);
    PoseHistory history;
    EXPECT_TRUE(history.branches(std::vector<PoseHistory::Node>{PoseHistory::kNone}).empty());
    // They start as copies of one.
    const auto root = history.append(PoseHistory::kNone, {});
    std::vector<PoseHistory::Node> leaves(kParticles, root);
    for (std::size_t i = 1; i < kParticles; ++i) history.share(root);
    for (std::size_t step = 1; step < kSteps; ++step) {
        for (auto& leaf : leaves) {
            leaf = history.append(leaf, {value(engine), value(engine), value(engine)});
        }
        if (step % 3 != 0) continue;
        std::vector<PoseHistory::Node> next;
        for (std::size_t i = 0; i < kParticles; ++i) {
            next.push_back(leaves[pick(engine)]);
            history.share(next.back());
        }
        history.release(leaves);
        leaves = next;
    }
    const std::vector<HistoryBranch> branches = history.branches(leaves);
    EXPECT_GT(branches.size(), 3U);
    std::size_t poses = branches.front().poses.size();
    for (std::size_t i = 1; i < branches.size(); ++i) poses += branches[i].poses.size() - 1;
    EXPECT_EQ(poses, history.size());  // each is drawn once
    // Each says of which scan its first pose is.
    const std::vector<Pose> newest = history.path(leaves.front());
    EXPECT_EQ(branches.front().first, 0U);
    for (const HistoryBranch& branch : branches) {
        ASSERT_LE(branch.first + branch.poses.size(), kSteps);
        const auto on_way = std::ranges::find(newest, branch.poses.back());
        if (on_way == newest.end()) continue;
        EXPECT_EQ(static_cast<std::size_t>(on_way - newest.begin()),
                  branch.first + branch.poses.size() - 1);
    }
    auto ways = ways_of(branches, kSteps);
    ASSERT_EQ(ways.size(), kParticles);
    for (const auto leaf : leaves) {
        const auto way = std::ranges::find(ways, history.path(leaf));
        ASSERT_NE(way, ways.end());
        ways.erase(way);
    }
}

TEST(PoseHistory, EqualsPlainCopiesUnderRandomResampling) {
    constexpr std::size_t kParticles = 20;
    std::mt19937 engine(43);
    std::uniform_real_distribution<double> value(-1.0, 1.0);
    std::uniform_int_distribution<std::size_t> pick(0, kParticles - 1);
    PoseHistory history;
    std::vector<PoseHistory::Node> leaves(kParticles, PoseHistory::kNone);
    std::vector<std::vector<Pose>> plain(kParticles);
    for (int step = 0; step < 300; ++step) {
        for (std::size_t i = 0; i < kParticles; ++i) {
            const Pose pose{value(engine), value(engine), value(engine)};
            leaves[i] = history.append(leaves[i], pose);
            plain[i].push_back(pose);
        }
        std::vector<PoseHistory::Node> next;
        std::vector<std::vector<Pose>> next_plain;
        for (std::size_t i = 0; i < kParticles; ++i) {
            const std::size_t source = pick(engine);
            history.share(leaves[source]);
            next.push_back(leaves[source]);
            next_plain.push_back(plain[source]);
        }
        history.release(leaves);
        leaves = next;
        plain = next_plain;
    }
    for (std::size_t i = 0; i < kParticles; ++i) EXPECT_EQ(history.path(leaves[i]), plain[i]);
    // Memory: the common trunk plus a young crown, far below particles x steps.
    EXPECT_LT(history.size(), 300U + kParticles * 100U);
    // A copy has no more than that, and the same ways.
    PoseHistory held;
    std::vector<PoseHistory::Node> theirs = leaves;
    std::vector<PoseHistory::Node*> named;
    named.reserve(kParticles);
    for (PoseHistory::Node& leaf : theirs) named.push_back(&leaf);
    held.assign_held(history, named);
    held.check(theirs, 300);
    EXPECT_EQ(held.size(), history.size());
    EXPECT_LT(held.bytes(), history.bytes());
    for (std::size_t i = 0; i < kParticles; ++i) EXPECT_EQ(held.path(theirs[i]), plain[i]);
    held.release(theirs);
    EXPECT_EQ(held.size(), 0U);
    history.release(leaves);
    EXPECT_EQ(history.size(), 0U);
}

TEST(PoseHistory, SeveralWorkersLetGoWhatEachAloneWould) {
    constexpr std::size_t kParticles = 4000;
    constexpr std::size_t kWorkers = 4;
    std::mt19937 engine(53);
    std::uniform_int_distribution<std::size_t> pick(0, kParticles - 1);
    PoseHistory alone;
    PoseHistory together;
    std::vector<PoseHistory::Node> ours(kParticles, PoseHistory::kNone);
    std::vector<PoseHistory::Node> theirs = ours;
    for (int step = 0; step < 30; ++step) {
        const Pose pose{static_cast<double>(step), 0.0, 0.0};
        for (auto& node : ours) node = alone.append(node, pose);
        together.begin_row(kParticles);
        for (std::size_t i = kParticles; i-- > 0;) {  // in any order
            theirs[i] = together.append_in_row(i, theirs[i], pose);
        }
        together.end_row();
        // Of few particles many copies, so that workers meet at the same ancestors.
        std::vector<std::size_t> selected;
        for (std::size_t i = 0; i < kParticles; ++i) selected.push_back(pick(engine) / 8);
        std::vector<PoseHistory::Node> next_ours;
        std::vector<PoseHistory::Node> next_theirs;
        for (const std::size_t from : selected) {
            alone.share(ours[from]);
            next_ours.push_back(ours[from]);
            together.share(theirs[from]);
            next_theirs.push_back(theirs[from]);
        }
        alone.release(ours);
        std::vector<std::vector<PoseHistory::Node>> freed(kWorkers);
        {
            std::vector<std::jthread> workers;
            for (std::size_t w = 0; w < kWorkers; ++w) {
                workers.emplace_back([&, w] {
                    constexpr std::size_t kPart = kParticles / kWorkers;
                    together.release(std::span(theirs).subspan(w * kPart, kPart), freed[w], false);
                });
            }
        }
        for (auto& nodes : freed) together.take_back(nodes);
        ours = next_ours;
        theirs = next_theirs;
        ASSERT_EQ(together.size(), alone.size()) << step;
    }
    for (std::size_t i = 0; i < kParticles; i += 61) {
        EXPECT_EQ(together.path(theirs[i]), alone.path(ours[i]));
    }
    together.release(theirs);
    EXPECT_EQ(together.size(), 0U);
}

TEST(PoseHistory, NothingHasNoPoses) {
    PoseHistory history;
    EXPECT_TRUE(history.path(PoseHistory::kNone).empty());
    history.share(PoseHistory::kNone);
    history.release(PoseHistory::kNone);
}

}  // namespace
}  // namespace hitos
