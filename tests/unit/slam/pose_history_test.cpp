#include "pose_history.hpp"

#include <gtest/gtest.h>

#include <random>
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
    history.release(leaves);
    EXPECT_EQ(history.size(), 0U);
}

TEST(PoseHistory, NothingHasNoPoses) {
    PoseHistory history;
    EXPECT_TRUE(history.path(PoseHistory::kNone).empty());
    history.share(PoseHistory::kNone);
    history.release(PoseHistory::kNone);
}

}  // namespace
}  // namespace hitos
