// SPDX-License-Identifier: GPL-3.0-or-later
// How well the scans of a tour lie on each other where the odometry, read one way or another,
// puts them.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "hitos/capture/tour_examination.hpp"
#include "hypothesis_search.hpp"
#include "seen_from.hpp"
#include "turned_step.hpp"

namespace hitos {

std::optional<Pose> TourExamination::pose_at(double time_s, double turn_scale) const {
    if (path_.empty() || time_s < path_.front().time_s || time_s > path_.back().time_s) return {};
    const auto after = std::ranges::lower_bound(path_, time_s, {}, &StampedPose::time_s);
    if (after == path_.begin()) return after->pose;
    const StampedPose& a = *(after - 1);
    const double share = (time_s - a.time_s) / (after->time_s - a.time_s);
    const Pose step = between(a.pose, after->pose);
    Pose pose = compose(a.pose, {share * step.x, share * step.y, share * step.theta});
    if (turn_scale != 1.0) {
        const auto place = static_cast<std::size_t>(after - path_.begin());
        pose.theta = turn_scale * std::lerp(headings_[place - 1], headings_[place], share);
    }
    return pose;
}

double TourExamination::period_s() const {
    double seconds = last_scan_s_ - first_scan_s_;
    for (const StampLeap& leap : stamp_leaps_) seconds -= leap.by_s;
    const double steps = static_cast<double>(scans_) - 1.0;
    return seconds / std::max(1.0, steps - static_cast<double>(stamp_leaps_.size()));
}

double TourExamination::undone_s(unsigned leaps, double stamp_s) const {
    if (leaps == 0) return 0.0;
    const double period = period_s();
    double sum = 0.0;
    for (std::size_t i = 0; i < stamp_leaps_.size(); ++i) {
        const bool undone = ((leaps >> i) & 1U) != 0;
        if (undone && stamp_s > stamp_leaps_[i].after_s) sum += period - stamp_leaps_[i].by_s;
    }
    return sum;
}

/// How the robot moved between the scans of a pair.
std::optional<Pose> TourExamination::step_of(const Pair& pair, const Hypothesis& hypothesis) const {
    const auto odometry_at = [&](double time_s) {
        const double set_by_s = (time_s < hypothesis.set_at_s ? 0.0 : hypothesis.set_by_s) +
                                undone_s(hypothesis.undone_leaps, time_s);
        return pose_at(
            time_s + hypothesis.delay_s + set_by_s + hypothesis.gained * (time_s - first_scan_s_),
            hypothesis.turn_scale);
    };
    const std::optional<Pose> first = odometry_at(pair.first.time_s);
    const std::optional<Pose> second = odometry_at(pair.second.time_s);
    if (!first || !second) return {};
    Pose step = between(*first, *second);
    step.x *= hypothesis.scale;
    step.y *= hypothesis.scale;
    const double drift = hypothesis.drift_rad_s * (pair.second.time_s - pair.first.time_s) +
                         hypothesis.drift_rad_m * std::hypot(step.x, step.y);
    if (hypothesis.pair_turn_scale == 1.0 && drift == 0.0) return step;
    return with_turn(step, hypothesis.pair_turn_scale * step.theta + drift);
}

std::optional<double> TourExamination::agreement(const Pair& pair,
                                                 const Hypothesis& hypothesis) const {
    const std::optional<Pose> step = step_of(pair, hypothesis);
    if (!step) return {};
    if (hypothesis.first_ray_s == 0.0 && hypothesis.last_ray_s == 0.0)
        return agreement(pair, *step, hypothesis, {});
    const std::optional<Speeds> speeds = speeds_of(pair, hypothesis);
    return speeds ? agreement(pair, *step, hypothesis, *speeds) : std::nullopt;
}

std::optional<TourExamination::Speeds> TourExamination::speeds_of(
    const Pair& pair, const Hypothesis& hypothesis) const {
    constexpr double kAround = 0.1;  // [s]
    const auto speed_at = [&](double time_s) -> std::optional<double> {
        const std::optional<Pose> before = pose_at(time_s + hypothesis.delay_s - kAround);
        const std::optional<Pose> after = pose_at(time_s + hypothesis.delay_s + kAround);
        if (!before || !after) return {};
        return wrap_angle(after->theta - before->theta) / (2.0 * kAround);
    };
    const std::optional<double> first = speed_at(pair.first.time_s);
    const std::optional<double> second = speed_at(pair.second.time_s);
    if (!first || !second) return {};
    return Speeds{*first, *second};
}

std::optional<double> TourExamination::agreement(const Pair& pair, const Pose& step,
                                                 const Hypothesis& hypothesis,
                                                 const Speeds& speeds) {
    constexpr int kLeastPoints = 10;
    const auto fan_of = [&](const View& view, double speed) {
        if (speed == 0.0 || view.span_rad == 0.0) {
            return Rays{hypothesis.fan_middle_rad, hypothesis.fan_scale, 0.0};
        }
        const double first = hypothesis.first_ray_s * speed;
        const double last = hypothesis.last_ray_s * speed;
        return Rays{view.first_rad + view.span_rad / 2.0, 1.0 + (last - first) / view.span_rad,
                    (first + last) / 2.0};
    };
    const auto mounted = [&](Pose laser) {
        laser.theta += hypothesis.turn_rad;
        laser.x += hypothesis.shift.x;
        laser.y += hypothesis.shift.y;
        return laser;
    };
    const SeenFrom seen_from{pair.first.first_rad,
                             pair.first.step_rad,
                             pair.first.ranges,
                             fan_of(pair.first, speeds.first),
                             fan_of(pair.second, speeds.second),
                             hypothesis.mirrored ? -1.0 : 1.0,
                             hypothesis.range_offset_m,
                             between(mounted(pair.first.pose_robot_laser),
                                     compose(step, mounted(pair.second.pose_robot_laser))),
                             hypothesis.near_m,
                             hypothesis.near_per_range};
    const View& later = pair.second;
    const SeenFrom::Count count = seen_from.count(
        {later.directions, later.distances.data(), later.cosines.data(), later.sines.data()});
    if (count.asked < kLeastPoints) return {};
    return static_cast<double>(count.lie) / count.asked;
}

TourExamination::Pairs TourExamination::some_pairs(std::size_t asked) const {
    Pairs some;
    if (asked == 0) return some;
    const std::size_t every = std::max<std::size_t>(pairs_.size() / asked, 1);
    for (std::size_t i = 0; i < pairs_.size(); i += every) some.push_back(&pairs_[i]);
    return some;
}

TourExamination::Pairs TourExamination::of_odometry(const Pairs& pairs,
                                                    const Hypothesis& hypothesis) const {
    Pairs some;
    std::ranges::copy_if(pairs, std::back_inserter(some),
                         [&](const Pair* pair) { return step_of(*pair, hypothesis).has_value(); });
    return some;
}

std::optional<double> TourExamination::agreement(const Pairs& asked, const Hypothesis& hypothesis,
                                                 double least) const {
    constexpr std::size_t kLeastPairs = 10;
    constexpr double kRounding = 1e-9;
    double sum = 0.0;
    std::size_t pairs = 0;
    std::size_t left = asked.size();
    for (const Pair* pair : asked) {
        const std::optional<double> one = agreement(*pair, hypothesis);
        --left;
        if (!one) continue;
        sum += *one;
        ++pairs;
        // Most hypotheses are far off, and would be if all that is left fitted.
        const double most = sum + static_cast<double>(left);
        if (most < (least - kRounding) * static_cast<double>(pairs + left)) return {};
    }
    // Few of them fit anywhere, by chance.
    if (pairs < std::max(kLeastPairs, asked.size() / 2)) return {};
    return sum / static_cast<double>(pairs);
}

std::optional<double> TourExamination::agreement(const Hypothesis& hypothesis) const {
    return agreement(some_pairs(pairs_.size()), hypothesis);
}

double TourExamination::way_shown(double range_scale, double fan_scale, double least) const {
    constexpr std::size_t kAsked = 128;
    const Point2 laser{fan_.pose_robot_laser.x, fan_.pose_robot_laser.y};
    // In the readings' unit: so much longer is the way, and so much farther off sits the laser.
    const double longer = 1.0 / range_scale;
    Hypothesis hypothesis = closely();
    hypothesis.near_m *= longer;
    hypothesis.scale = longer;
    hypothesis.fan_scale = fan_scale;
    hypothesis.fan_middle_rad = wrap_angle((fan_.min_angle_rad + fan_.max_angle_rad) / 2.0);
    hypothesis.shift = {(longer - 1.0) * laser.x, (longer - 1.0) * laser.y};
    const Pairs pairs = some_pairs(kAsked);
    const double fits = agreement(pairs, hypothesis).value_or(0.0);
    hypothesis.scale = 0.0;
    return fits < least ? 0.0 : fits - agreement(pairs, hypothesis).value_or(fits);
}

}  // namespace hitos
