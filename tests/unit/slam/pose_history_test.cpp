#include "pose_history.hpp"

#include <gtest/gtest.h>

#include <random>
#include <utility>
#include <vector>

#include "map_store.hpp"
#include "own_landmarks.hpp"

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

LandmarkEstimate<SensorRecta> wall(double rho, double theta = 0.5) {
    return {{rho, theta}, Matrix2::Identity()};
}

TEST(MapStore, WritingASharedMapLeavesTheOtherAlone) {
    MapStore store;
    const auto a = store.create();
    const auto b = store.create();
    auto first = store.landmarks<SensorRecta>(a);
    first.set(first.append(), wall(1.0));
    store.copy(a, b);
    store.landmarks<SensorRecta>(b).set(0, wall(2.0));
    store.landmarks<SensorRecta>(b).append();
    EXPECT_EQ(store.landmarks<SensorRecta>(a).size(), 1U);
    EXPECT_EQ(store.landmarks<SensorRecta>(b).size(), 2U);
    EXPECT_EQ(store.landmarks<SensorRecta>(a).get(0).mean.rho, 1.0);
    EXPECT_EQ(store.landmarks<SensorRecta>(b).get(0).mean.rho, 2.0);
    const MapStore copy = store;
    store.landmarks<SensorRecta>(a).set(0, wall(3.0));
    EXPECT_EQ(std::as_const(copy).landmarks<SensorRecta>(a).get(0).mean.rho, 1.0);
}

TEST(MapStore, CopiesOnlyTheLeavesThatAreWritten) {
    MapStore store;
    const auto a = store.create();
    const auto b = store.create();
    auto lines = store.landmarks<SensorRecta>(a);
    for (int i = 0; i < 100; ++i) lines.set(lines.append(), wall(i));
    store.copy(a, b);
    auto others = store.landmarks<SensorRecta>(b);
    const auto& is = std::as_const(lines);
    for (std::size_t leaf = 0; leaf < lines.leaves(); ++leaf) {
        EXPECT_EQ(&is.leaf(leaf), &std::as_const(others).leaf(leaf));
    }
    others.set(50, wall(-1.0));
    for (std::size_t leaf = 0; leaf < lines.leaves(); ++leaf) {
        EXPECT_EQ(&is.leaf(leaf) == &std::as_const(others).leaf(leaf), leaf != 50 / 8) << leaf;
    }
    EXPECT_EQ(lines.get(50).mean.rho, 50.0);
    EXPECT_EQ(others.get(51).mean.rho, 51.0);
}

/// Maps that are copied over each other and written at random hold what plain vectors hold, and
/// what nobody has any more is used again.
TEST(MapStore, EqualsPlainCopies) {
    constexpr std::size_t kMaps = 20;
    MapStore store;
    std::vector<std::vector<double>> plain(kMaps);
    for (std::size_t i = 0; i < kMaps; ++i) store.create();
    std::mt19937 random(3);
    const auto below = [&](std::size_t most) {
        return std::uniform_int_distribution<std::size_t>(0, most - 1)(random);
    };
    for (int round = 0; round < 20000; ++round) {
        const std::size_t map = below(kMaps);
        auto lines = store.landmarks<SensorRecta>(static_cast<MapStore::Handle>(map));
        const double value = round;
        const std::size_t what = below(10);
        if (what < 2 && plain[map].size() < 60) {
            lines.set(lines.append(), wall(value));
            plain[map].push_back(value);
        } else if (what < 7 && !plain[map].empty()) {
            const std::size_t i = below(plain[map].size());
            lines.set(i, wall(value));
            plain[map][i] = value;
        } else if (what == 7 && !plain[map].empty()) {
            const std::size_t left = below(plain[map].size());
            lines.cut(left);
            plain[map].resize(left);
        } else {
            const std::size_t from = below(kMaps);
            if (from == map) continue;
            store.copy(static_cast<MapStore::Handle>(from), static_cast<MapStore::Handle>(map));
            plain[map] = plain[from];
        }
    }
    for (std::size_t map = 0; map < kMaps; ++map) {
        const auto lines = store.landmarks<SensorRecta>(static_cast<MapStore::Handle>(map));
        ASSERT_EQ(lines.size(), plain[map].size());
        EXPECT_EQ(lines.leaves(), (plain[map].size() + 7) / 8);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            EXPECT_EQ(lines.get(i).mean.rho, plain[map][i]);
        }
    }
    EXPECT_LE(store.leaves(), kMaps * 8 + 64 + 16);
}

TEST(LandmarkColumns, KeepsValuesWhileItGrows) {
    OwnLandmarks<SensorRecta> own;
    LineColumns lines = own.columns();
    for (int i = 0; i < 1000; ++i) {
        Matrix2 covariance;
        covariance << i, 0.1, 0.1, 2.0 * i;
        const std::size_t index = lines.append();
        lines.set(index, {{1.0 * i, 0.003 * i}, covariance});
        lines.record(index).observations = i;
    }
    ASSERT_EQ(lines.size(), 1000U);
    for (std::size_t i = 0; i < 1000; ++i) {
        EXPECT_EQ(lines.get(i).mean.rho, static_cast<double>(i));
        EXPECT_EQ(lines.get(i).covariance(1, 1), 2.0 * static_cast<double>(i));
        EXPECT_NEAR(lines.lane(i).sine, std::sin(0.003 * static_cast<double>(i)), 1e-15);
        EXPECT_EQ(std::as_const(lines).record(i).observations, static_cast<int>(i));
    }
}

}  // namespace
}  // namespace hitos
