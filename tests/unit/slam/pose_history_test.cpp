#include "pose_history.hpp"

#include <gtest/gtest.h>

#include <random>

#include "map_store.hpp"

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
        for (const auto leaf : leaves) history.release(leaf);
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
        for (const auto leaf : leaves) history.release(leaf);
        leaves = next;
        plain = next_plain;
    }
    for (std::size_t i = 0; i < kParticles; ++i) EXPECT_EQ(history.path(leaves[i]), plain[i]);
    // Memory: the common trunk plus a young crown, far below particles x steps.
    EXPECT_LT(history.size(), 300U + kParticles * 100U);
    for (const auto leaf : leaves) history.release(leaf);
    EXPECT_EQ(history.size(), 0U);
}

TEST(PoseHistory, NothingHasNoPoses) {
    PoseHistory history;
    EXPECT_TRUE(history.path(PoseHistory::kNone).empty());
    history.share(PoseHistory::kNone);
    history.release(PoseHistory::kNone);
}

TEST(MapStore, WritingASharedMapLeavesTheOtherAlone) {
    MapStore store;
    auto a = store.create();
    store.reserve_more<SensorRecta>(2);
    auto first = store.landmarks<SensorRecta>(a);
    first.set(first.append(), {{1.0, 0.5}, Matrix2::Identity()});
    store.share(a);
    auto b = a;
    const auto source = store.detach(b);
    ASSERT_NE(a, b);
    EXPECT_EQ(source, a);
    store.copy(source, b);
    EXPECT_EQ(store.detach(a), a);  // alone again: no copy is due
    store.landmarks<SensorRecta>(b).set(0, {{2.0, 0.5}, Matrix2::Identity()});
    store.landmarks<SensorRecta>(b).append();
    EXPECT_EQ(store.landmarks<SensorRecta>(a).size(), 1U);
    EXPECT_EQ(store.landmarks<SensorRecta>(b).size(), 2U);
    EXPECT_EQ(store.landmarks<SensorRecta>(a).get(0).mean.rho, 1.0);
    EXPECT_EQ(store.landmarks<SensorRecta>(b).get(0).mean.rho, 2.0);
    store.release(b);
    EXPECT_EQ(store.create(), b);  // its block is used again, empty
    EXPECT_EQ(store.landmarks<SensorRecta>(b).size(), 0U);
    EXPECT_EQ(store.blocks(), 2U);
}

TEST(LandmarkTable, KeepsValuesWhileItGrows) {
    LandmarkTable<SensorRecta> table;
    for (int block = 0; block < 3; ++block) table.add_block();
    for (int i = 0; i < 100; ++i) {
        table.reserve_more(1);
        for (std::size_t block = 0; block < 3; block += 2) {  // block 1 stays empty
            Matrix2 covariance;
            covariance << i, 0.1, 0.1, 2.0 * i;
            auto lines = table[block];
            const std::size_t index = lines.append();
            lines.set(index, {{1.0 * i + static_cast<double>(block), 0.01 * i}, covariance});
            lines.record(index).observations = i;
        }
    }
    EXPECT_EQ(table.size(1), 0U);
    table.copy(2, 1);
    const auto copy = table[1];
    ASSERT_EQ(copy.size(), 100U);
    for (std::size_t i = 0; i < 100; ++i) {
        EXPECT_EQ(table[0].get(i).mean.rho, static_cast<double>(i));
        EXPECT_EQ(copy.get(i).mean.rho, static_cast<double>(i) + 2.0);
        EXPECT_EQ(copy.get(i).covariance(1, 1), 2.0 * static_cast<double>(i));
        EXPECT_EQ(copy.column(LineColumns::kSine)[i], std::sin(0.01 * static_cast<double>(i)));
        EXPECT_EQ(copy.record(i).observations, static_cast<int>(i));
    }
}

}  // namespace
}  // namespace hitos
