// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/capture/stamp_line.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace hitos {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct Line {
    std::vector<double> went_on;
    std::vector<std::uint64_t> left_out;
    std::vector<std::string> reasons;
    std::size_t most_waiting = 0;
    std::uint64_t returns = 0;
};

Line through(const std::vector<double>& times_s) {
    StampLine<double> line;
    Line found;
    const auto take = [&] {
        while (const auto time_s = line.take([&](std::uint64_t number, const Message& reason) {
            found.left_out.push_back(number);
            found.reasons.push_back(reason.english());
        })) {
            found.went_on.push_back(*time_s);
        }
    };
    for (std::size_t i = 0; i < times_s.size(); ++i) {
        line.add(times_s[i], i, times_s[i]);
        take();
        const std::size_t done = found.went_on.size() + found.left_out.size();
        found.most_waiting = std::max(found.most_waiting, i + 1 - done);
    }
    line.end();
    take();
    found.returns = line.returns();
    return found;
}

std::vector<double> tour(double from_s, std::size_t count, double step_s = 0.1) {
    std::vector<double> times_s;
    for (std::size_t i = 0; i < count; ++i) {
        times_s.push_back(from_s + static_cast<double>(i) * step_s);
    }
    return times_s;
}

std::vector<double> operator+(std::vector<double> one, const std::vector<double>& other) {
    one.insert(one.end(), other.begin(), other.end());
    return one;
}

/// A few of any value, anywhere in a tour of any pace.
TEST(StampLine, WhatIsBrokenIsLeftOutAndNothingElse) {
    for (const double pace_s : {0.01, 0.1, 1.0, 3.0}) {
        for (const double broken_s : {0.0, 1e12, -5.0, 1'600'000'000.0, 1'700'100'000.0}) {
            for (const std::uint64_t at : {0U, 1U, 2U, 25U, 47U, 48U, 49U}) {
                if (at == 49 && broken_s == 1'700'100'000.0) continue;  // may be a pause
                std::vector<double> times_s = tour(1'700'000'000.0, 50, pace_s);
                times_s[at] = broken_s;
                const Line found = through(times_s);
                EXPECT_THAT(found.left_out, ElementsAre(at)) << pace_s << ' ' << broken_s;
                EXPECT_EQ(found.went_on.size(), 49U);
                EXPECT_EQ(found.returns, 0U);
            }
        }
    }
}

TEST(StampLine, EveryTenthAndSeveralInARowAreLeftOut) {
    for (const double broken_s : {0.0, 500.0, 1'030.0, 3'000.0, 1e12}) {
        for (const std::size_t run : {1U, 2U, 5U, 7U}) {
            std::vector<double> times_s = tour(1'000.0, 100);
            std::size_t broken = 0;
            for (std::size_t i = 10; i + run < times_s.size(); i += 10) {
                for (std::size_t k = 0; k < run; ++k, ++broken) {
                    times_s[i + k] = broken_s + 0.1 * static_cast<double>(k);
                }
            }
            const Line found = through(times_s);
            EXPECT_EQ(found.left_out.size(), broken) << broken_s << ' ' << run;
            EXPECT_EQ(found.went_on.size(), 100U - broken);
        }
    }
}

/// As where a driver's clock is set once it runs.
TEST(StampLine, TheFirstOfAnotherClockAreLeftOut) {
    for (const double broken_s : {0.0, 1e9, 1e12}) {
        for (const std::size_t run : {1U, 2U, 4U}) {
            const Line found = through(tour(broken_s, run) + tour(1'700'000'000.0, 50));
            EXPECT_EQ(found.left_out.size(), run) << broken_s;
            EXPECT_EQ(found.went_on, tour(1'700'000'000.0, 50));
        }
    }
    // A pause may come at once.
    EXPECT_EQ(through(tour(100.0, 2) + tour(900.0, 50)).left_out.size(), 0U);
    EXPECT_EQ(through(tour(0.0, 3) + tour(1e9, 2)).left_out.size(), 2U);
}

/// Of any unit.
TEST(StampLine, AnyPaceGoesOn) {
    for (const double pace_s : {1e-3, 100.0, 7'200.0, 1e5, 1e8}) {
        const std::vector<double> times_s = tour(0.0, 60, pace_s);
        EXPECT_EQ(through(times_s).went_on, times_s) << pace_s;
        std::vector<double> uneven;
        for (int i = 0; i < 60; ++i) uneven.push_back(pace_s * (i + (i % 3) * 0.4));
        EXPECT_EQ(through(uneven).went_on, uneven) << pace_s;
    }
}

/// A pause, a slow device, what is a little out of order, a clock that was set, a tour that was
/// played again: all of it goes on, in its order.
TEST(StampLine, ClocksThatAreSetAndPausesGoOn) {
    const std::vector<double> first = tour(100.0, 30);
    for (const double set_s : {-50.0, -10.0, -2.5, 2.5, 30.0, 4'000.0, 1e9}) {
        for (const double pace_s : {0.1, 1.0, 3.0}) {
            const std::vector<double> times_s =
                tour(100.0, 30, pace_s) + tour(100.0 + 30.0 * pace_s + set_s, 30, pace_s);
            const Line found = through(times_s);
            EXPECT_EQ(found.went_on, times_s) << set_s << ' ' << pace_s;
            EXPECT_THAT(found.left_out, IsEmpty());
        }
    }
    const Line again = through(first + first);
    EXPECT_EQ(again.went_on, first + first);
    EXPECT_EQ(again.returns, 1U);
    const std::vector<double> jumbled = {100.0, 101.5, 100.2, 102.0, 100.9, 102.5};
    EXPECT_EQ(through(jumbled).went_on, jumbled);
}

/// Before any more come.
std::size_t waiting_behind(const std::vector<double>& times_s) {
    StampLine<double> line;
    std::size_t waiting = 0;
    for (std::size_t i = 0; i < times_s.size(); ++i, ++waiting) line.add(times_s[i], i, times_s[i]);
    while (line.take([&](std::uint64_t, const Message&) { --waiting; })) --waiting;
    return waiting;
}

/// Who maps live waits for nothing where the stamps are sound, but for the first ones.
TEST(StampLine, NothingWaitsWhereAllIsSound) {
    EXPECT_EQ(through(tour(100.0, 50)).most_waiting, StampJudge::kRun);
    EXPECT_LE(through(tour(100.0, 20) + tour(1e9, 20)).most_waiting, StampJudge::kRun);
    EXPECT_EQ(waiting_behind(tour(100.0, 9)), 0U);
    EXPECT_EQ(waiting_behind(tour(100.0, 20) + tour(105.0, 2)), 0U);
    EXPECT_EQ(waiting_behind(tour(100.0, 20) + tour(150.0, 8)), 0U);
    EXPECT_THAT(through({}).went_on, IsEmpty());
    EXPECT_THAT(through({7.0}).went_on, ElementsAre(7.0));
    EXPECT_THAT(through({7.0, 0.0}).went_on, ElementsAre(7.0));
}

TEST(StampLine, SaysBetweenWhichTimesItStands) {
    const Line found = through({100.0, 100.1, 1e12, 100.3});
    ASSERT_EQ(found.reasons.size(), 1U);
    EXPECT_THAT(found.reasons[0],
                HasSubstr("its time, 1000000000000 s, is out of line: that before it is of 100.1 s "
                          "and that behind it of 100.3 s"));
    EXPECT_THAT(through({0.0, 1e9, 1e9 + 0.1}).reasons[0],
                HasSubstr("its time, 0 s, is out of line with its neighbour's, 1000000000 s"));
}

/// Whatever comes: nothing is lost untold, and the order stays.
TEST(StampLine, EachGoesOnOrIsToldInItsOrder) {
    std::mt19937 random(7);
    for (int round = 0; round < 200; ++round) {
        std::vector<double> times_s;
        double now_s = 1'000.0;
        for (int i = 0; i < 100; ++i) {
            now_s += 0.1;
            const auto dice = random() % 12;
            if (dice == 0) now_s += static_cast<double>(random() % 9000) - 4500.0;
            times_s.push_back(dice == 1 ? static_cast<double>(random()) : now_s);
        }
        const Line found = through(times_s);
        EXPECT_EQ(found.went_on.size() + found.left_out.size(), times_s.size());
        std::vector<double> left;
        std::size_t next = 0;
        for (std::size_t i = 0; i < times_s.size(); ++i) {
            if (next < found.left_out.size() && found.left_out[next] == i) {
                ++next;
            } else {
                left.push_back(times_s[i]);
            }
        }
        EXPECT_EQ(found.went_on, left);
        EXPECT_LE(found.most_waiting, StampJudge::kRun + 1);
    }
}

}  // namespace
}  // namespace hitos
