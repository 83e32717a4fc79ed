// SPDX-License-Identifier: GPL-3.0-or-later
#include "tour_writer.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "hitos/base/error.hpp"

namespace hitos {
namespace {

/// A zero loses its sign, which means nothing and would stand in the file.
Twist without_minus(Twist twist) {
    for (double* value : {&twist.v, &twist.v_lateral, &twist.w}) *value += 0.0;
    return twist;
}

}  // namespace

void TourWriter::write(const Scan& scan) {
    if (!scan.landmarks.empty() && !says_landmarks()) {
        throw FormatError(path_.string(), 0,
                          HITOS_TEXT("Errors",
                                     "the landmarks of line %1 (time %2) cannot be written as "
                                     "readings of a laser; write them in the normalized format"),
                          scan.line, std::to_string(scan.time_s));
    }
    pending_.push_back({scan.time_s, scan.carries_odometry ? scan.line : 0, prepare(scan)});
}

void TourWriter::write(const Scan& scan, const Odometria* next) {
    write(scan);
    next != nullptr ? put_before(*next) : put_rest();
}

/// The scans that come before the reading.
void TourWriter::put_before(const Odometria& reading) {
    const double begin_s = has_reading_ ? last_.time_s : reading.time_s;
    const Pose begin = pose_odom_robot_;
    while (!pending_.empty()) {
        const Pending& scan = pending_.front();
        if (scan.line > 0) {
            if (scan.line >= reading.line) break;
            // Its own reading repeated the one before and was left out.
            put_pending(has_reading_ ? std::max(scan.time_s, last_.time_s) : scan.time_s,
                        pose_odom_robot_);
            continue;
        }
        if (scan.time_s >= reading.time_s) break;
        const bool overtaken = has_reading_ && scan.time_s < last_.time_s;
        put_pending(scan.time_s, overtaken ? pose_at(scan.time_s, last_, last_begin_s_, begin)
                                 : has_reading_
                                     ? compose(begin, displacement(without_minus(reading.twist),
                                                                   scan.time_s - begin_s))
                                     : Pose{});
    }
}

void TourWriter::write(const Odometria& given) {
    Odometria odometry = given;
    odometry.twist = without_minus(given.twist);
    put_before(odometry);
    // Then the reading, and the scans at its time.
    const double begin_s = has_reading_ ? last_.time_s : odometry.time_s;
    const Pose end = has_reading_ ? compose(pose_odom_robot_,
                                            displacement(odometry.twist, odometry.time_s - begin_s))
                                  : Pose{};
    last_ = odometry;
    last_begin_s_ = begin_s;
    pose_odom_robot_ = end;
    has_reading_ = true;
    if (!std::exchange(has_head_, true)) put_head(out_);
    put_odometry(out_, odometry, end);
    while (!pending_.empty()) {
        const Pending& scan = pending_.front();
        const bool own = scan.line > 0 && scan.line == odometry.line;
        const bool same_time = scan.line == 0 && scan.time_s == odometry.time_s;
        if (!own && !same_time) break;
        put_pending(odometry.time_s, end);
    }
    flush();
}

/// The pose at a time inside the newest reading's interval, seen back from its end.
Pose TourWriter::pose_at(double time_s, const Odometria& reading, double begin_s,
                         const Pose& pose) const {
    const double back_s = std::max(time_s, begin_s) - reading.time_s;
    return compose(pose, displacement(reading.twist, back_s));
}

void TourWriter::put_pending(double time_s, const Pose& pose_odom_robot) {
    if (!std::exchange(has_head_, true)) put_head(out_);
    put_scan(out_, pending_.front().prepared, time_s, pose_odom_robot);
    pending_.pop_front();
    flush();
}

void TourWriter::flush() {
    constexpr std::size_t kHeld = std::size_t{1} << 16;
    if (out_.size() < kHeld) return;
    file_.write(out_);
    out_.clear();
}

/// The scans that no reading follows.
void TourWriter::put_rest() {
    while (!pending_.empty()) {
        const double time_s = pending_.front().time_s;
        const bool own = pending_.front().line > 0;
        put_pending(own && has_reading_ ? std::max(time_s, last_.time_s) : time_s,
                    pose_odom_robot_);
    }
}

void TourWriter::finish() {
    put_rest();
    if (!std::exchange(has_head_, true)) put_head(out_);
    put_tail(out_);
    file_.write(out_);
    out_.clear();
    file_.commit();
}

double writable_range(double range_m, double max_range_m) {
    constexpr double kUnit = 1e-4;
    return std::clamp(range_m, kUnit, std::max(kUnit, max_range_m - kUnit));
}

}  // namespace hitos
