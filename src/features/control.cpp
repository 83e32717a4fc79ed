// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/features/control.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hitos {

DrivenWay driven_way(std::span<const Control> controls) {
    DrivenWay sum;
    for (const Control& control : controls) {
        sum.pose_start_end =
            compose(sum.pose_start_end, displacement(control.twist, control.duration_s));
        sum.path_m += std::hypot(control.twist.v, control.twist.v_lateral) * control.duration_s;
        sum.turned_rad += std::abs(control.twist.w) * control.duration_s;
    }
    return sum;
}

void ControlTrack::take(double until_s, std::vector<Control>& out) {
    // No reading is asked for that is not needed: who comes in live may not have come yet.
    while (!(started_ && used_until_s_ >= until_s) && (pending_ || (pending_ = next_()))) {
        const Odometria& reading = *pending_;
        if (!started_) {
            started_ = true;  // the first reading only sets the clock
            used_until_s_ = reading.time_s;
            pending_.reset();
            continue;
        }
        const double end_s = std::min(until_s, reading.time_s);
        if (end_s > used_until_s_) out.push_back({reading.twist, end_s - used_until_s_});
        used_until_s_ = std::max(used_until_s_, end_s);
        if (reading.time_s > until_s) return;  // the rest belongs to the next scan
        pending_.reset();
    }
}

void ControlTrack::controls_until(const Scan& scan, std::vector<Control>& out) {
    out.clear();
    if (!scan.carries_odometry) {
        take(scan.time_s, out);
        return;
    }
    while (used_line_ < scan.line && (pending_ || (pending_ = next_())) &&
           pending_->line <= scan.line) {
        const std::uint64_t line = pending_->line;
        take(pending_->time_s, out);
        if (pending_ && pending_->time_s <= used_until_s_) pending_.reset();  // nothing is left
        if (!pending_) used_line_ = line;
    }
}

void OdometryPath::add(double time_s, std::span<const Control> controls, bool begins) {
    for (const Control& control : controls) {
        pose_ = compose(pose_, displacement(control.twist, control.duration_s));
    }
    trajectory_.push_back({time_s, pose_, begins});
}

}  // namespace hitos
