// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/registration/scan_odometry.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "hitos/base/median.hpp"
#include "hitos/capture/derived_tour.hpp"
#include "hitos/registration/registration.hpp"

namespace hitos {
namespace {

/// Below it a walking person turns further between two scans than a search from there finds.
constexpr double kQuickEnough = 8.0;  // scans a second

/// Between the first scans, the median [s].
double interval_of(const std::unique_ptr<TourReader>& reader) {
    constexpr std::size_t kAsked = 20;
    std::vector<double> intervals;
    std::optional<double> last_s;
    while (intervals.size() < kAsked) {
        const std::optional<Scan> scan = reader->next_scan();
        if (!scan) break;
        if (last_s && scan->time_s > *last_s) intervals.push_back(scan->time_s - *last_s);
        last_s = scan->time_s;
    }
    return median(std::move(intervals));
}

/// That the robot goes on as before is wrong by what it speeds up and turns more meanwhile, which
/// grows with the square of the interval: at ten scans a second by half of what wheels are.
RegistrationParams without_odometry(double interval_s) {
    constexpr double kPerSquareSecond = 50.0;
    // The end of a corridor is a few points: with the weight that they have beside wheels they are
    // followed too late, and the robot swings about where it is.
    constexpr double kPointSigma = 0.05;
    RegistrationParams params;
    params.point_sigma_m = kPointSigma;
    params.loops = false;
    params.final_passes = 0;
    params.calibrate = false;  // nothing is driven
    params.odometry_scale = std::clamp(kPerSquareSecond * interval_s * interval_s, 0.25, 3.0);
    return params;
}

class ScanOdometry final : public DerivedTour {
  public:
    ScanOdometry(std::unique_ptr<TourReader> tour, double interval_s)
        : DerivedTour(std::move(tour)),
          ahead_(this->tour().reopen()),
          interval_s_(interval_s),
          registration_(without_odometry(interval_s)) {}

    std::optional<Odometria> next_odometry() override;
    void restart() override { *this = ScanOdometry(tour().reopen(), interval_s_); }
    std::unique_ptr<TourReader> reopen() const override {
        return std::make_unique<ScanOdometry>(tour().reopen(), interval_s_);
    }
    std::vector<TourFinding> findings() const override;

  private:
    void note(const Pose& step, double seconds);

    std::unique_ptr<TourReader> ahead_;  // whose scans are matched
    double interval_s_;
    Registration registration_;
    std::optional<double> first_s_;
    double last_s_ = 0.0;
    Twist twist_;  // of the last step
    std::uint64_t scans_ = 0;
    std::uint64_t far_ = 0;  // of those, the ones far from the one before
};

std::optional<Odometria> ScanOdometry::next_odometry() {
    for (;;) {
        const std::optional<Scan> scan = ahead_->next_scan();
        if (!scan) return std::nullopt;
        if (first_s_ && !(scan->time_s > last_s_)) continue;  // no time to have moved in
        const double seconds = first_s_ ? scan->time_s - last_s_ : 0.0;
        // A robot that is said to stand is not matched, and would stand for ever. Through a pause
        // it does not go on as before.
        constexpr double kAsGoodAsNone = 1e-9;
        constexpr double kGoesOn = 1.0;  // [s]
        Control control{twist_, std::min(seconds, kGoesOn)};
        if (control.twist == Twist{}) control.twist.v = kAsGoodAsNone;
        const RegisteredStep step =
            registration_.add(*scan, first_s_ ? std::span(&control, 1) : std::span<Control>());
        if (!first_s_) first_s_ = scan->time_s;
        last_s_ = scan->time_s;
        ++scans_;
        if (seconds > 0.0) note(between(step.before, step.pose), seconds);
        return Odometria{scan->time_s, twist_, scan->line};
    }
}

void ScanOdometry::note(const Pose& step, double seconds) {
    constexpr double kFar = 0.15;  // [m], [rad]
    twist_ = twist_between(step, seconds);
    if (std::hypot(step.x, step.y) > kFar || std::abs(wrap_angle(step.theta)) > kFar) ++far_;
}

std::vector<TourFinding> ScanOdometry::findings() const {
    constexpr std::uint64_t kOneFarIn = 20;
    std::vector<TourFinding> found = tour().findings();
    if (scans_ < 2) return found;
    // Where there is odometry that is not used, the log's own reader has told the way back.
    const auto told = std::ranges::find(found, TourFinding::Kind::no_odometry, &TourFinding::kind);
    const std::vector<Remedy> known = told == found.end() ? std::vector<Remedy>{} : told->remedies;
    const double rate = static_cast<double>(scans_ - 1) / (last_s_ - *first_s_);
    const double rounded = std::round(rate * 10.0) / 10.0;
    const auto note = [&](Message what, Message remedy) {
        found.push_back({TourFinding::Kind::no_odometry, static_cast<double>(scans_),
                         std::move(what),
                         known.empty() ? std::vector<Remedy>{{std::move(remedy)}} : known});
    };
    // What counts is how much two scans see in common.
    if (rate > kQuickEnough || far_ * kOneFarIn < scans_) {
        note(message(HITOS_TEXT(
                         "Errors",
                         "how the robot moved is taken from the scans alone (%1 a second), which "
                         "cannot tell it where they see the same all along, as in a corridor"),
                     rounded),
             marked(HITOS_TEXT("Errors",
                               "record the odometry too where there is some: of ROS its topic, or "
                               "/tf together with /tf_static")));
    } else {
        note(message(HITOS_TEXT("Errors",
                                "how the robot moved is taken from the scans alone, which at %1 a "
                                "second lie so far apart that they may be matched wrongly"),
                     rounded),
             marked(HITOS_TEXT("Errors",
                               "record 10 scans a second, or drive slowly, or record the odometry "
                               "too: of ROS its topic, or /tf together with /tf_static")));
    }
    return found;
}

}  // namespace

std::unique_ptr<TourReader> make_scan_odometry(std::unique_ptr<TourReader> tour,
                                               std::unique_ptr<TourReader> beginning) {
    const double interval_s = interval_of(beginning ? std::move(beginning) : tour->reopen());
    return std::make_unique<ScanOdometry>(std::move(tour), interval_s);
}

bool is_scan_odometry(const TourReader& tour) {
    return dynamic_cast<const ScanOdometry*>(&tour) != nullptr;
}

}  // namespace hitos
