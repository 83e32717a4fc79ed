// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the odometry went on after a pause where it was before.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hitos/capture/tour_examination.hpp"
#include "remedies.hpp"

namespace hitos {
namespace {

constexpr TourExamination::Hypothesis kAsTold{};

double motion_between(const Pose& a, const Pose& b) {
    const Pose step = between(a, b);
    return std::hypot(step.x, step.y) + std::abs(wrap_angle(step.theta));
}

/// Climbs from where the robot has not moved to where `agreement` of a step is highest.
template <class Agreement>
Pose nearest_fit(const Agreement& agreement) {
    Pose best;
    double highest = agreement(best);
    constexpr double kCoarsest = 0.2;  // [m], [rad / 2]
    constexpr double kFinest = 0.02;
    double step = kCoarsest;
    while (step > kFinest) {
        const Pose from = best;
        for (const double to : {-step, step}) {
            for (const Pose& way : {Pose{to, 0, 0}, Pose{0, to, 0}, Pose{0, 0, to / 2.0}}) {
                const Pose next{from.x + way.x, from.y + way.y, from.theta + way.theta};
                const double found = agreement(next);
                if (found <= highest) continue;
                highest = found;
                best = next;
            }
        }
        if (best == from) step /= 2.0;
    }
    return best;
}

}  // namespace

/// Called before the scan is noted.
void TourExamination::note_pause(const Scan& scan) {
    constexpr double kShortest = 2.0;  // [s]
    constexpr std::size_t kMostPauses = 16;
    if (last_points_.empty() || scan.points.empty()) return;
    const double seconds = scan.time_s - last_scan_s_;
    if (seconds < kShortest) return;
    if (pauses_.size() == kMostPauses) {
        const auto shortest = std::ranges::min_element(pauses_, {}, &Pause::seconds);
        if (shortest->seconds() >= seconds) return;
        pauses_.erase(shortest);
    }
    Scan before;
    before.time_s = last_scan_s_;
    before.fan = last_fan_;
    before.points = last_points_;
    pauses_.push_back({{view_of(before), view_of(scan)}, scan.line - lines_before_});
}

void TourExamination::doubt_pauses(std::vector<TourFinding>& found) const {
    constexpr double kMoved = 1.0;       // by the odometry: less is no leap [m], [rad]
    constexpr double kOnePlace = 0.8;    // what share of points lies where the robot stood
    constexpr double kFarBetter = 0.3;   // than where the odometry puts it
    constexpr double kHint = 0.2;        // of that, as if it had not moved at all
    constexpr double kPassedOver = 0.6;  // how far it may have moved all the same
    for (const Pause& pause : pauses_) {
        const std::optional<Pose> first = pose_at(pause.scans.first.time_s);
        const std::optional<Pose> second = pose_at(pause.scans.second.time_s);
        if (!first || !second) continue;
        const Pose step = between(*first, *second);
        if (motion_between({}, step) < kMoved) continue;
        const auto fit_of = [&](const Pose& other) {
            return agreement(pause.scans, other, kAsTold, {}).value_or(0.0);
        };
        const double told = fit_of(step);
        if (told + kFarBetter > 1.0 || fit_of({}) < kHint) continue;
        const Pose stood = nearest_fit(fit_of);
        const double fits = fit_of(stood);
        if (fits < std::max(kOnePlace, told + kFarBetter) ||
            motion_between({}, stood) > kPassedOver || motion_between(stood, step) < kMoved) {
            continue;
        }
        const Pose off = between(stood, step);
        found.push_back(
            {TourFinding::Kind::leaping_odometry,
             std::hypot(off.x, off.y),
             message(HITOS_TEXT("Errors",
                                "after a pause of %1 s the odometry is %2 m and %3 degrees off "
                                "(line %4), as where a driver begins anew: the scans before and "
                                "after it are of one place (%5 % of their points fit so, %6 % as "
                                "the odometry says); the map falls in pieces there"),
                     std::lround(pause.seconds()), fmt::format("{:.1f}", std::hypot(off.x, off.y)),
                     std::lround(off.theta * kDegreesPerRadian), pause.line,
                     std::lround(100.0 * fits), std::lround(100.0 * told)),
             {map_with_registration()}});
    }
}

}  // namespace hitos
