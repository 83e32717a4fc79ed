// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/simulation/drive/driven_path.hpp"

#include <algorithm>
#include <cmath>

namespace hitos {

void DrivenPath::Motion::append(const Twist& twist, double period_s) {
    twists.push_back(twist);
    poses.push_back(compose(poses.back(), displacement(twist, period_s)));
}

void DrivenPath::append(const Twist& twist, const Twist& wheels) {
    if (!wheels_ && wheels != twist) wheels_ = motion_;
    motion_.append(twist, 1.0 / rate_hz_);
    if (wheels_) wheels_->append(wheels, 1.0 / rate_hz_);
}

void DrivenPath::displace(const Pose& by) {
    if (!wheels_) wheels_ = motion_;
    motion_.poses.back() = compose(motion_.poses.back(), by);
}

double DrivenPath::length_m() const {
    double length = 0.0;
    for (const Twist& twist : twists()) length += std::abs(twist.v) / rate_hz_;
    return length;
}

DrivenPath::Place DrivenPath::place_of(double time_s) const {
    // A time that is a multiple of the period but for rounding is that multiple.
    constexpr double kRounding = 1e-9;
    const double periods = std::max(0.0, time_s * rate_hz_);
    const double whole = std::floor(periods + kRounding);
    if (whole >= static_cast<double>(twists().size())) return {twists().size(), 0.0};
    return {static_cast<std::size_t>(whole), std::max(0.0, periods - whole) / rate_hz_};
}

Pose DrivenPath::pose_of(const Motion& motion, const Place& place) {
    if (place.since_s == 0.0) return motion.poses[place.step];
    return compose(motion.poses[place.step],
                   displacement(motion.twists[place.step], place.since_s));
}

Pose DrivenPath::pose_at(double time_s) const {
    return pose_of(motion_, place_of(time_s));
}

Twist DrivenPath::twist_between_times(double from_s, double to_s) const {
    const Motion& said = wheels_ ? *wheels_ : motion_;
    const Place from = place_of(from_s);
    const Place to = place_of(to_s);
    const bool one = from.step == to.step || (to.step == from.step + 1 && to.since_s == 0.0);
    if (one && from.step < said.twists.size()) return said.twists[from.step];
    return twist_between(between(pose_of(said, from), pose_of(said, to)), to_s - from_s);
}

}  // namespace hitos
