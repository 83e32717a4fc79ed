#include "tour_writer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hitos {

void TourWriter::write(const Scan& scan) {
    pending_.push_back({scan.time_s, scan.carries_odometry ? scan.line : 0, prepare(scan)});
}

void TourWriter::write(const Odometria& given) {
    Odometria odometry = given;
    // A zero loses its sign, which means nothing and would stand in the file.
    for (double* value : {&odometry.twist.v, &odometry.twist.v_lateral, &odometry.twist.w}) {
        *value += 0.0;
    }
    const double begin_s = has_reading_ ? last_.time_s : odometry.time_s;
    const Pose begin = pose_odom_robot_;
    const Pose end = has_reading_
                         ? compose(begin, displacement(odometry.twist, odometry.time_s - begin_s))
                         : Pose{};
    // First the scans before the reading ...
    while (!pending_.empty()) {
        const Pending& scan = pending_.front();
        if (scan.line > 0) {
            if (scan.line >= odometry.line) break;
            // Its own reading repeated the one before and was left out.
            put_pending(has_reading_ ? std::max(scan.time_s, last_.time_s) : scan.time_s,
                        pose_odom_robot_);
            continue;
        }
        if (scan.time_s >= odometry.time_s) break;
        const bool overtaken = has_reading_ && scan.time_s < last_.time_s;
        put_pending(scan.time_s,
                    overtaken ? pose_at(scan.time_s, last_, last_begin_s_, begin)
                    : has_reading_
                        ? compose(begin, displacement(odometry.twist, scan.time_s - begin_s))
                        : Pose{});
    }
    // ... then the reading, and the scans at its time.
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

void TourWriter::finish() {
    while (!pending_.empty()) {
        const double time_s = pending_.front().time_s;
        const bool own = pending_.front().line > 0;
        put_pending(own && has_reading_ ? std::max(time_s, last_.time_s) : time_s,
                    pose_odom_robot_);
    }
    if (!std::exchange(has_head_, true)) put_head(out_);
    file_.write(out_);
    out_.clear();
    file_.commit();
}

double writable_range(double range_m, double max_range_m) {
    constexpr double kUnit = 1e-4;
    return std::clamp(range_m, kUnit, std::max(kUnit, max_range_m - kUnit));
}

}  // namespace hitos
