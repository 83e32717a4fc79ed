// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the odometry went on after a pause where it was before.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hitos/capture/tour_examination.hpp"
#include "remedies.hpp"
#include "scan_climb.hpp"

namespace hitos {
namespace {

constexpr TourExamination::Hypothesis kAsTold{};

double motion_between(const Pose& a, const Pose& b) {
    const Pose step = between(a, b);
    return std::hypot(step.x, step.y) + std::abs(wrap_angle(step.theta));
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

bool TourExamination::goes_in_one_step(double begin_s, double end_s, double way) const {
    constexpr double kMost = 0.5;
    auto at = std::ranges::upper_bound(path_, begin_s, {}, &StampedPose::time_s);
    if (at == path_.begin()) return false;
    double longest = 0.0;
    for (; at != path_.end(); ++at) {
        longest = std::max(longest, motion_between((at - 1)->pose, at->pose));
        if (at->time_s >= end_s) break;
    }
    return longest >= kMost * way;
}

/// Where nothing was seen for long, and what is seen then does not lie where the odometry puts it.
std::optional<TourFinding> TourExamination::unseen_way(const Pause& pause, const Pose& step) const {
    constexpr double kShortest = 5.0;    // [s]
    constexpr double kPeriods = 10.0;    // from scan to scan
    constexpr double kFar = 3.0;         // a way of which something is to be seen [m], [rad]
    constexpr double kByChance = 0.3;    // what share of points fits elsewhere,
    constexpr double kAtBest = 0.4;      // and somewhere near that
    constexpr double kHardlySeen = 0.5;  // of a way driven: what is behind a corner fits nothing
    if (pause.seconds() < std::max(kShortest, kPeriods * period_s())) return {};
    const auto fit_of = [&](const Pose& other) {
        return agreement(pause.scans, other, kAsTold, {}).value_or(0.0);
    };
    const double told = fit_of(step);
    const bool far = motion_between({}, step) > kFar;
    const std::string seconds = fmt::format("{:.0f}", pause.seconds());
    const std::string metres = fmt::format("{:.1f}", std::hypot(step.x, step.y));
    if (far && told < kHardlySeen) {
        return TourFinding{
            TourFinding::Kind::unfit_odometry, told,
            message(HITOS_TEXT("Errors",
                               "for %1 s there is no scan (line %2), while the robot drives to %3 "
                               "m from where it was: how the map goes on there is the odometry's "
                               "word alone"),
                    seconds, pause.line, metres)};
    }
    if (far || told >= kByChance || fit_of(nearest_fit(fit_of, step)) >= kAtBest ||
        fit_of(nearest_fit(fit_of, {})) >= kAtBest) {
        return {};
    }
    return TourFinding{
        TourFinding::Kind::unfit_odometry,
        told,
        message(HITOS_TEXT("Errors",
                           "for %1 s there is no scan, and what is seen then (line %2) is not what "
                           "was seen before, though by the odometry it is %3 m from there: %4 % of "
                           "its points fit; the map goes on at a wrong place until that is "
                           "recognised"),
                seconds, pause.line, metres, std::lround(100.0 * told)),
        {{message(HITOS_TEXT("Errors",
                             "if the robot was carried, cut the log at that line, and map the "
                             "second part with the map of the first"))}}};
}

/// Where the odometry says another place, and what is seen the same one.
std::optional<TourFinding> TourExamination::begun_anew(const Pause& pause, const Pose& step) const {
    constexpr double kMoved = 1.0;       // by the odometry: less is no leap [m], [rad]
    constexpr double kOnePlace = 0.8;    // what share of points lies where the robot stood
    constexpr double kFarBetter = 0.3;   // than where the odometry puts it
    constexpr double kHint = 0.2;        // of that, as if it had not moved at all
    constexpr double kPassedOver = 0.6;  // how far it may have moved all the same
    if (motion_between({}, step) < kMoved) return {};
    const auto fit_of = [&](const Pose& other) {
        return agreement(pause.scans, other, kAsTold, {}).value_or(0.0);
    };
    const double told = fit_of(step);
    if (told + kFarBetter > 1.0 || fit_of({}) < kHint) return {};
    const Pose stood = nearest_fit(fit_of, {});
    const double fits = fit_of(stood);
    if (fits < std::max(kOnePlace, told + kFarBetter) || motion_between({}, stood) > kPassedOver ||
        motion_between(stood, step) < kMoved) {
        return {};
    }
    if (!goes_in_one_step(pause.scans.first.time_s, pause.scans.second.time_s,
                          motion_between(stood, step))) {
        return {};
    }
    const Pose off = between(stood, step);
    return TourFinding{
        TourFinding::Kind::leaping_odometry,
        std::hypot(off.x, off.y),
        message(HITOS_TEXT("Errors",
                           "after a pause of %1 s the odometry is %2 m and %3 degrees off "
                           "(line %4), as where a driver begins anew: the scans before and "
                           "after it are of one place (%5 % of their points fit so, %6 % as "
                           "the odometry says); the map falls in pieces there"),
                std::lround(pause.seconds()), fmt::format("{:.1f}", std::hypot(off.x, off.y)),
                std::lround(off.theta * kDegreesPerRadian), pause.line, std::lround(100.0 * fits),
                std::lround(100.0 * told)),
        {map_with_registration()}};
}

void TourExamination::doubt_pauses(std::vector<TourFinding>& found) const {
    for (const Pause& pause : pauses_) {
        const std::optional<Pose> first = pose_at(pause.scans.first.time_s);
        const std::optional<Pose> second = pose_at(pause.scans.second.time_s);
        if (!first || !second) continue;
        const Pose step = between(*first, *second);
        std::optional<TourFinding> finding = begun_anew(pause, step);
        if (!finding) finding = unseen_way(pause, step);
        if (finding) found.push_back(*std::move(finding));
    }
}

}  // namespace hitos
