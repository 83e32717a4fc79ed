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
        return std::make_unique<Counted>(scans_, readings_);
    }
    const ReadReport& report() const override { return report_; }
    std::optional<double> progress() const override { return static_cast<double>(scan_) / scans_; }
    std::string name() const override { return "counted"; }
    std::string format() const override { return "test"; }

  private:
    int scans_;
    int readings_;
    int scan_ = 0;
    int reading_ = 0;
    ReadReport report_;
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
