// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/capture/joined_tour.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/capture/recorded_tour.hpp"

namespace hitos {
namespace {

/// Five scans and ten readings a scan apart from `begin_s` on, line by line.
std::unique_ptr<TourReader> tour_from(double begin_s, std::uint64_t skipped) {
    auto tour = std::make_shared<RecordedTour>();
    for (int i = 0; i < 5; ++i) {
        Scan scan;
        scan.time_s = begin_s + i;
        scan.line = 3 * static_cast<std::uint64_t>(i) + 3;
        tour->scans.items.push_back(scan);
    }
    for (int i = 0; i < 10; ++i) {
        const std::uint64_t line = static_cast<std::uint64_t>(i) + 1;
        tour->odometry.items.push_back({begin_s - 0.2 + 0.5 * i, {0.1 * i, 0.0, 0.0}, line});
    }
    ReadReport report;
    report.skipped = skipped;
    report.examples.assign(skipped, {7, verbatim("bad")});
    tour->scans.notes.push_back({6, report});
    return std::make_unique<RecordedReader>(tour);
}

struct Both {
    std::vector<Scan> scans;
    std::vector<Odometria> odometry;
};

Both read_all(TourReader& tour, bool odometry_first) {
    Both read;
    const auto take = [](auto&& next, auto& items) {
        while (auto item = next()) items.push_back(*item);
    };
    const auto scans = [&] { take([&] { return tour.next_scan(); }, read.scans); };
    if (!odometry_first) scans();
    take([&] { return tour.next_odometry(); }, read.odometry);
    if (odometry_first) scans();
    return read;
}

TEST(JoinedTour, PutsTheSecondTourBehindTheFirst) {
    for (const bool odometry_first : {false, true}) {
        // The first is over at 104.3 s, by its odometry, the second begins at 2.8 s.
        const auto tour = make_joined_tour({tour_from(100.0, 2)}, tour_from(3.0, 1));
        const Both read = read_all(*tour, odometry_first);
        ASSERT_EQ(read.scans.size(), 10U);
        ASSERT_EQ(read.odometry.size(), 20U);
        for (std::size_t i = 0; i < 10; ++i)
            EXPECT_EQ(read.scans[i].begins_tour.has_value(), i == 5);
        EXPECT_EQ(read.scans[4].time_s, 104.0);
        EXPECT_EQ(read.scans[5].time_s, 105.0) << "whole seconds later";
        EXPECT_NEAR(read.odometry[10].time_s, 104.8, 1e-9);
        EXPECT_EQ(read.odometry[11].twist, Twist({0.1, 0.0, 0.0}));
        // Lines go on too: readings up to a scan's line are those before it.
        EXPECT_EQ(read.scans[5].line, 15U + 3U);
        EXPECT_EQ(read.odometry[10].line, 15U + 1U);
        EXPECT_EQ(tour->report().skipped, 3U);
        EXPECT_EQ(tour->report().examples.size(), 3U);

        tour->restart();
        const Both again = read_all(*tour, !odometry_first);
        EXPECT_EQ(again.scans, read.scans);
        EXPECT_EQ(again.odometry, read.odometry);
        EXPECT_EQ(read_all(*tour->reopen(), odometry_first).scans, read.scans);
    }
}

/// Scans whose clock differs from the odometry's keep their stamps' order too.
TEST(JoinedTour, PutsDelayedScansBehindByTheirStampsToo) {
    const auto delayed = [](double begin_s) {
        auto tour = std::make_shared<RecordedTour>();
        for (int i = 0; i < 3; ++i) {
            Scan scan;
            scan.delay_s = 50.0;
            scan.time_s = begin_s + i + scan.delay_s;
            scan.line = 2 * static_cast<std::uint64_t>(i) + 2;
            tour->scans.items.push_back(scan);
            tour->odometry.items.push_back({scan.time_s - 0.1, {0.1, 0.0, 0.0}, scan.line - 1});
        }
        return std::make_unique<RecordedReader>(tour);
    };
    const auto tour = make_joined_tour({tour_from(100.0, 0)}, delayed(60.0));
    const Both read = read_all(*tour, false);
    ASSERT_EQ(read.scans.size(), 8U);
    for (std::size_t i = 1; i < read.scans.size(); ++i) {
        EXPECT_GT(read.scans[i].stamp_s(), read.scans[i - 1].stamp_s());
        EXPECT_GT(read.scans[i].time_s, read.scans[i - 1].time_s);
    }
    EXPECT_EQ(read.scans[5].begins_tour->lines_before, 15U);
    EXPECT_EQ(read.odometry[10].lines_before, 15U);
    EXPECT_EQ(read.odometry[11].lines_before, 0U);
}

TEST(JoinedTour, LeavesStampsThatGoOnAsTheyAre) {
    const auto tour = make_joined_tour({tour_from(100.0, 0)}, tour_from(1000.5, 0));
    const Both read = read_all(*tour, false);
    EXPECT_EQ(read.scans[5].time_s, 1000.5);
    EXPECT_EQ(read.scans[5].stamp_s(), 1000.5);
}

TEST(JoinedTour, OfThreeToursTheLastTwoBegin) {
    const TourBegin begin{true, Pose{1, 2, 3}};
    const auto tour = make_joined_tour(
        {make_joined_tour({tour_from(1, 0)}, tour_from(2, 0), begin)}, tour_from(3, 0));
    const Both read = read_all(*tour, true);
    ASSERT_EQ(read.scans.size(), 15U);
    for (std::size_t i = 0; i < 15; ++i) {
        EXPECT_EQ(read.scans[i].begins_tour.has_value(), i == 5 || i == 10) << i;
        if (i == 0) continue;
        EXPECT_GT(read.scans[i].time_s, read.scans[i - 1].time_s);
    }
    ASSERT_TRUE(read.scans[5].begins_tour && read.scans[10].begins_tour);
    EXPECT_EQ(read.scans[5].begins_tour->hold, begin.hold);
    EXPECT_EQ(read.scans[5].begins_tour->start, begin.start);
    EXPECT_EQ(read.scans[5].begins_tour->lines_before, 15U);
    EXPECT_EQ(read.scans[10].begins_tour->start, std::nullopt);
    EXPECT_EQ(read.scans[10].begins_tour->lines_before, 30U);
}

TEST(JoinedTour, RefusesAFirstTourThatIsAnotherAndASecondWithoutScans) {
    const std::vector<double> stamps{1.0, 2.0, 3.0, 4.0, 5.0};
    const auto joined = [](std::vector<double> of_run) {
        return make_joined_tour({tour_from(1, 0), "run", std::move(of_run)}, tour_from(9, 0));
    };
    EXPECT_EQ(read_all(*joined(stamps), true).scans.size(), 10U);
    EXPECT_THROW(read_all(*joined({1.0, 2.0, 3.0, 4.0}), true), FileError);
    EXPECT_THROW(read_all(*joined({1.0, 2.0, 3.0, 4.0, 5.0, 6.0}), true), FileError);
    EXPECT_THROW(read_all(*joined({1.0, 2.0, 3.01, 4.0, 5.0}), true), FileError);
    const auto empty = make_joined_tour(
        {tour_from(1, 0)}, std::make_unique<RecordedReader>(std::make_shared<RecordedTour>()));
    EXPECT_THROW(read_all(*empty, true), FormatError);
}

TEST(JoinedTour, StartsAtAPoseOrAnywhere) {
    EXPECT_FALSE(start_of(" "));
    EXPECT_EQ(start_of("1, -2.5,90").value(), Pose({1.0, -2.5, 90.0 * kRadiansPerDegree}));
    for (const char* wrong : {"1,2", "1,2,3,4", "1,2,x", "1,2,nan", "1e9,0,0", "here"})
        EXPECT_THROW(static_cast<void>(start_of(wrong)), ConfigError) << wrong;
}

}  // namespace
}  // namespace hitos
