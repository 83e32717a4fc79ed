// SPDX-License-Identifier: GPL-3.0-or-later
// What clocks did, read off a table: each pair fits at one delay, or at all of them.
#include "tour_clocks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace hitos {
namespace {

constexpr double kStep = 0.5;
constexpr int kSteps = 20;

/// A pair a second, which fit within half a second of the delay that is told for their time.
DelayTable table_of(int pairs, const std::function<double(double)>& delay_at) {
    DelayTable table(kStep, kSteps);
    for (int i = 0; i < pairs; ++i) {
        std::vector<double> fits(table.columns());
        for (std::size_t column = 0; column < fits.size(); ++column) {
            const double off = std::abs(table.delay_s(column) - delay_at(i));
            fits[column] = std::max(0.2, 1.0 - off);
        }
        table.add(i, fits);
    }
    return table;
}

TEST(DelayTable, AClockThatGainsIsFoundWithItsBegin) {
    const DelayTable table = table_of(60, [](double time_s) { return -1.0 + 6.0 * time_s / 59.0; });
    const DelayTable::Clock clock = table.drifting(10.0);
    EXPECT_DOUBLE_EQ(clock.delay_s, -1.0);
    EXPECT_DOUBLE_EQ(clock.gained_s, 6.0);
    EXPECT_GT(clock.agreement, 0.7);
    EXPECT_LT(std::abs(table.drifting(4.0).gained_s), 4.1);
}

TEST(DelayTable, AClockThatIsSetIsFoundWithItsTime) {
    const DelayTable table = table_of(60, [](double time_s) { return time_s < 24.5 ? 0.5 : -4.0; });
    const DelayTable::Clock clock = table.set(0.1);
    EXPECT_DOUBLE_EQ(clock.delay_s, 0.5);
    EXPECT_DOUBLE_EQ(clock.set_by_s, -4.5);
    EXPECT_DOUBLE_EQ(clock.set_at_s, 24.5);
    EXPECT_GT(clock.agreement, table.drifting(10.0).agreement + 0.2);
}

TEST(DelayTable, OneDelayIsNoClockThatWasSet) {
    EXPECT_EQ(table_of(60, [](double) { return 2.0; }).set(0.1).agreement, 0.0);
}

TEST(DelayTable, AFewPairsAtTheEndAreNoClockThatWasSet) {
    const DelayTable table = table_of(60, [](double time_s) { return time_s < 55.5 ? 0.0 : 3.0; });
    EXPECT_EQ(table.set(0.1).agreement, 0.0);
}

}  // namespace
}  // namespace hitos
