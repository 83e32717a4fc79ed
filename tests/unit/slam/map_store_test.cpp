// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/map_store.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "own_landmarks.hpp"

namespace hitos {
namespace {

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

/// Maps beside vectors that should hold the same.
class PlainCopies {
  public:
    explicit PlainCopies(std::size_t most) : most_(most) {
        for (std::size_t i = 0; i < kMaps; ++i) store_.create();
    }
    void change(int round) {
        const std::size_t map = below(kMaps);
        auto lines = store_.landmarks<SensorRecta>(map);
        auto& plain = plain_[map];
        const double value = round;
        const std::size_t what = below(20);
        if (what < 8 && plain.size() < most_) {
            lines.set(lines.append(), wall(value));
            plain.push_back(value);
        } else if (what < 15 && !plain.empty()) {
            const std::size_t i = below(plain.size());
            lines.set(i, wall(value));
            plain[i] = value;
        } else if (what == 15 && below(most_) < 8 && !plain.empty()) {
            const std::size_t left = below(plain.size());
            lines.cut(left);
            plain.resize(left);
        } else if (what == 16) {
            const auto gone = static_cast<double>(below(7));
            const auto goes = [&](double rho) { return std::fmod(rho, 7.0) == gone; };
            std::vector<std::uint32_t> places;
            lines.take_out([&](std::uint32_t i) { return goes(lines.mean(i).rho); }, places);
            std::erase_if(plain, goes);
        } else if (what == 17) {
            select();
        } else {
            const std::size_t from = below(kMaps);
            store_.copy(from, map);
            if (from != map) plain = plain_[from];
        }
    }
    void expect_equal() const {
        for (std::size_t map = 0; map < kMaps; ++map) {
            const auto lines = store_.landmarks<SensorRecta>(map);
            ASSERT_EQ(lines.size(), plain_[map].size());
            EXPECT_EQ(lines.leaves(), (plain_[map].size() + 7) / 8);
            EXPECT_TRUE(lines.indexed() || lines.size() <= LineColumns::kWithoutIndex);
            for (std::size_t i = 0; i < lines.size(); ++i) {
                ASSERT_EQ(lines.get(i).mean.rho, plain_[map][i]);
            }
            expect_all_found(lines);
        }
    }
    const MapStore& store() const { return store_; }
    void become_a_copy() {
        const MapStore copy = store_;
        store_ = copy;
        worker_ = {};
        store_.check({&worker_});
    }
    void make_all_one() {
        while (plain_[0].empty()) change(1);
        for (std::size_t map = 1; map < kMaps; ++map) store_.copy(0, map);
        plain_.assign(kMaps, plain_[0]);
    }
    std::size_t leaves_of_one() const { return (plain_[0].size() + 7) / 8; }
    static constexpr std::size_t kMaps = 20;

  private:
    std::size_t below(std::size_t most) {
        return std::uniform_int_distribution<std::size_t>(0, most - 1)(random_);
    }
    /// As resampling does.
    void select() {
        std::vector<std::size_t> drawn;
        for (std::size_t i = 0; i < kMaps; ++i) drawn.push_back(below(kMaps));
        std::ranges::sort(drawn);
        std::vector<std::vector<double>> next;
        const auto again = [&](std::size_t m) { return m > 0 && drawn[m] == drawn[m - 1]; };
        store_.begin_selection();
        for (std::size_t m = 0; m < kMaps; ++m) {
            store_.select(drawn[m], m, again(m), worker_);
            next.push_back(plain_[drawn[m]]);
        }
        for (std::size_t m = 0; m < kMaps; ++m) {
            if (!again(m)) store_.take_over(drawn[m], m);
            if (!std::ranges::binary_search(drawn, m)) store_.pass_over(m, worker_);
        }
        store_.end_selection();
        plain_ = std::move(next);
    }
    /// The index has every landmark.
    static void expect_all_found(const LineColumns& lines) {
        std::vector<IndexEntry> found;
        IndexRegion everywhere = IndexRegion::nowhere();
        everywhere.high.fill(std::numeric_limits<float>::infinity());
        everywhere.by_spread0 = everywhere.by_spread1 = 1.0F;
        lines.find(everywhere, found);
        std::vector<bool> is_in(lines.size(), !lines.indexed());
        for (const IndexEntry& entry : found) is_in.at(entry.id) = true;
        EXPECT_EQ(std::ranges::count(is_in, false), 0);
    }

    MapStore::Worker worker_;
    MapStore store_;
    std::size_t most_;
    std::vector<std::vector<double>> plain_{kMaps};
    std::mt19937 random_{3};
};

/// Maps that are copied over each other, selected and written at random hold what plain vectors
/// hold, and what nobody has any more is used again.
TEST(MapStore, EqualsPlainCopies) {
    for (const std::size_t most : {60U, 300U}) {
        PlainCopies copies(most);
        for (int round = 0; round < 20000; ++round) copies.change(round);
        copies.expect_equal();
        const std::size_t leaves = PlainCopies::kMaps * (most / 8 + 1);
        EXPECT_LE(copies.store().leaves(), leaves + 64 + 32);
        for (int round = 0; round < 20000; ++round) copies.change(round);
        copies.expect_equal();
    }
}

/// What is in stock, here most of the leaves, stays behind; and a copy can be gone on with.
TEST(MapStore, ACopyHasWhatMapsHoldAlone) {
    for (const std::size_t most : {60U, 300U}) {
        PlainCopies copies(most);
        for (int round = 0; round < 20000; ++round) copies.change(round);
        copies.make_all_one();
        const std::size_t before = copies.store().leaves();
        copies.become_a_copy();
        copies.expect_equal();
        EXPECT_EQ(copies.store().leaves(), copies.leaves_of_one());
        EXPECT_LT(4 * copies.store().leaves(), before);
        for (int round = 0; round < 20000; ++round) copies.change(round);
        copies.expect_equal();
        copies.become_a_copy();
        copies.expect_equal();
    }
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
