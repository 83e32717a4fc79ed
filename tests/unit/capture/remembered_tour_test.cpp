// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/capture/remembered_tour.hpp"

#include <gtest/gtest.h>

namespace hitos {
namespace {

/// Numbered scans and readings.
class Counted final : public TourReader {
  public:
    Counted(int scans, int readings) : scans_(scans), readings_(readings) {}
    std::optional<Scan> next_scan() override {
        if (scan_ == scans_) return std::nullopt;
        Scan scan;
        scan.time_s = ++scan_;
        scan.points.assign(100, {1.0, 2.0});
        return scan;
    }
    std::optional<Odometria> next_odometry() override {
        if (reading_ == readings_) return std::nullopt;
        return Odometria{static_cast<double>(++reading_), {}, 0};
    }
    void restart() override { scan_ = reading_ = 0; }
    std::unique_ptr<TourReader> reopen() const override {
        ++reopened_;
        return std::make_unique<Counted>(scans_, readings_);
    }
    const ReadReport& report() const override { return report_; }
    std::optional<double> progress() const override { return static_cast<double>(scan_) / scans_; }
    std::string name() const override { return "counted"; }
    std::string format() const override { return "test"; }
    ReadOptions options() const override { return {}; }
    int reopened() const { return reopened_; }
    void drive_on(int readings) { readings_ = readings; }

  private:
    int scans_;
    int readings_;
    int scan_ = 0;
    int reading_ = 0;
    mutable int reopened_ = 0;
    ReadReport report_ = [] {
        ReadReport report;
        report.skipped = 3;
        return report;
    }();
};

TEST(RememberedTour, GivesTheSameAgainFromAnyPlaceAndGoesOnBehindIt) {
    RememberedTour tour(std::make_unique<Counted>(20, 50));
    for (int i = 0; i < 5; ++i) tour.next_scan();
    for (int i = 0; i < 30; ++i) tour.next_odometry();
    const RememberedTour::Place place = tour.place();
    EXPECT_EQ(tour.next_scan()->time_s, 6.0);
    for (int i = 0; i < 10; ++i) tour.next_odometry();
    tour.go_to(place);
    EXPECT_EQ(tour.progress(), 5.0 / 20.0);
    EXPECT_EQ(tour.next_odometry()->time_s, 31.0);
    for (int i = 6; i <= 20; ++i) EXPECT_EQ(tour.next_scan()->time_s, i);
    EXPECT_FALSE(tour.next_scan());
    for (int i = 32; i <= 50; ++i) EXPECT_EQ(tour.next_odometry()->time_s, i);
    EXPECT_FALSE(tour.next_odometry());
    tour.go_to({});
    EXPECT_EQ(tour.next_scan()->time_s, 1.0);
    tour.restart();
    EXPECT_EQ(tour.next_scan()->time_s, 1.0);
    EXPECT_EQ(tour.next_odometry()->time_s, 1.0);
}

TEST(RememberedTour, IsReadAnewFromMemoryOnceItsEndIsKnown) {
    auto counted = std::make_unique<Counted>(20, 50);
    const Counted& source = *counted;
    RememberedTour tour(std::move(counted));
    while (tour.next_scan()) {
    }
    const auto early = tour.reopen();
    while (tour.next_odometry()) {
    }
    EXPECT_EQ(source.reopened(), 1);
    const auto first = tour.reopen();
    const auto second = first->reopen();
    tour.restart();  // what was given away stays
    for (TourReader* again : {early.get(), first.get(), second.get()}) {
        for (int i = 1; i <= 20; ++i) ASSERT_EQ(again->next_scan()->time_s, i);
        for (int i = 1; i <= 50; ++i) ASSERT_EQ(again->next_odometry()->time_s, i);
        EXPECT_FALSE(again->next_scan());
        EXPECT_FALSE(again->next_odometry());
        EXPECT_EQ(again->name(), "counted");
        EXPECT_EQ(again->format(), "test");
    }
    EXPECT_EQ(first->report().skipped, 3U);
    EXPECT_EQ(source.reopened(), 1);
}

/// A tour that is being driven has readings as far as it has come.
TEST(RememberedTour, AsksAgainForOdometryThatWasNotThereYet) {
    auto counted = std::make_unique<Counted>(3, 1);
    Counted& source = *counted;
    RememberedTour tour(std::move(counted));
    EXPECT_TRUE(tour.next_scan());
    EXPECT_TRUE(tour.next_odometry());
    EXPECT_FALSE(tour.next_odometry());
    source.drive_on(2);
    EXPECT_EQ(tour.next_odometry()->time_s, 2.0);
    while (tour.next_scan()) {
    }
    source.drive_on(3);
    EXPECT_EQ(tour.next_odometry()->time_s, 3.0);
    EXPECT_FALSE(tour.next_odometry());
    EXPECT_EQ(tour.reopen()->next_scan()->time_s, 1.0);
    EXPECT_EQ(source.reopened(), 0);
}

TEST(RememberedTour, ForgetsWhatIsTooMuchAndStillReadsOn) {
    RememberedTour tour(std::make_unique<Counted>(200, 10), 50'000);
    EXPECT_TRUE(tour.whole());
    for (int i = 1; i <= 200; ++i) ASSERT_EQ(tour.next_scan()->time_s, i);
    EXPECT_FALSE(tour.whole());
    EXPECT_FALSE(tour.next_scan());
    EXPECT_EQ(tour.next_odometry()->time_s, 1.0);
    tour.restart();
    EXPECT_TRUE(tour.whole());
    EXPECT_EQ(tour.next_scan()->time_s, 1.0);
}

}  // namespace
}  // namespace hitos
