// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/capture/tour_examination.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hitos/base/median.hpp"
#include "hitos/capture/scan_clock.hpp"
#include "seen_from.hpp"

namespace hitos {
namespace {

constexpr std::size_t kMostPairs = 512;       // then every second one goes
constexpr std::size_t kMostKnots = 1U << 18;  // likewise of the path
constexpr std::size_t kMostSamples = 4096;
constexpr double kPairWay = 0.4;  // between the scans of a pair, a radian counted as a metre
constexpr double kPairSeconds = 3.0;

/// Every second of them.
void thin(auto& values) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < values.size(); i += 2) {
        if (kept != i) values[kept] = std::move(values[i]);
        ++kept;
    }
    values.resize(kept);
}

double distance_of(const Twist& twist, double seconds) {
    return std::hypot(twist.v, twist.v_lateral) * seconds;
}

}  // namespace

/// Of a map's tour it was said when that was mapped, and nothing joins the two: the one behind it
/// is examined by itself, from where both its sequences have begun.
void TourExamination::begin_next(bool& begun, std::uint64_t lines_before) {
    if (next_.empty()) next_.emplace_back(read_);
    next_.front().lines_before_ = lines_before;
    begun = true;
    if (!scans_of_next_ || !odometry_of_next_) return;
    TourExamination next = std::move(next_.front());
    *this = std::move(next);
}

void TourExamination::note(const Odometria& odometry) {
    if (odometry.lines_before > lines_before_ && !odometry_of_next_)
        begin_next(odometry_of_next_, odometry.lines_before);
    if (odometry_of_next_) return next_.front().note(odometry);
    if (readings_ == 0) last_.time_s = odometry.time_s;
    if (readings_ > 0 && odometry.time_s <= last_.time_s) return;
    const double seconds = odometry.time_s - last_.time_s;
    const double way = distance_of(odometry.twist, seconds);
    last_.pose = compose(last_.pose, displacement(odometry.twist, seconds));
    last_.time_s = odometry.time_s;
    speed_ = std::hypot(odometry.twist.v, odometry.twist.v_lateral) + std::abs(odometry.twist.w);
    way_m_ += way;
    const double direction = std::atan2(odometry.twist.v_lateral, odometry.twist.v);
    along_m_ += way * std::cos(2.0 * direction);
    across_m_ += way * std::sin(2.0 * direction);
    turned_rad_ += std::abs(odometry.twist.w) * seconds;
    heading_rad_ += odometry.twist.w * seconds;
    // What the fastest robots of this kind do not reach, over more than a hand's breadth.
    constexpr double kGreatestSpeed = 15.0;
    constexpr double kLeap = 1.0;
    if (way > kLeap && way > kGreatestSpeed * seconds) {
        ++leaps_;
        if (way > longest_step_m_) longest_step_line_ = odometry.line - lines_before_;
        longest_step_m_ = std::max(longest_step_m_, way);
    }
    // What the reader puts a millisecond behind the one before says nothing of a speed.
    constexpr double kNoTime = 1.5e-3;
    if (readings_ > 0 && seconds < kNoTime) {
        ++of_no_time_;
        way_in_no_time_m_ += way;
    } else if (seconds > 0.0) {
        // Of readings that came together a speed is that of all.
        constexpr double kTogether = 0.05;
        speed_way_m_ += way;
        speed_s_ += seconds;
        if (speed_s_ >= kTogether) {
            if (speed_way_m_ > 0.0 && speeds_.size() < kMostSamples)
                speeds_.push_back(static_cast<float>(speed_way_m_ / speed_s_));
            speed_way_m_ = speed_s_ = 0.0;
        }
    }
    if (readings_++ % path_stride_ != 0) return;
    path_.push_back(last_);
    headings_.push_back(heading_rad_);
    if (path_.size() < kMostKnots) return;
    thin(path_);
    thin(headings_);
    path_stride_ *= 2;
}

std::size_t TourExamination::View::bin_of(double direction_rad) const {
    const auto last_bin = static_cast<double>(ranges.size() - 1);
    return static_cast<std::size_t>(nearest_bin(direction_rad, first_rad, step_rad, last_bin));
}

TourExamination::View TourExamination::view_of(const Scan& scan) const {
    constexpr double kStepWhereUnknown = kRadiansPerDegree;
    constexpr double kFinestStep = 1e-3;      // however many rays there are,
    constexpr std::size_t kMostPoints = 192;  // some hundred pairs make a mean of thousands
    const double step = std::abs(scan.fan.step_rad());
    const bool known = scan.fan.count > 1 && step > 0.0 && step < 0.2;
    const std::size_t every = scan.points.size() / kMostPoints + 1;
    View view;
    view.time_s = scan.time_s;
    view.pose_robot_laser = scan.fan.pose_robot_laser;
    view.first_rad = std::min(scan.fan.min_angle_rad, scan.fan.max_angle_rad);
    view.step_rad = known ? std::ceil(kFinestStep / step) * step : kStepWhereUnknown;
    view.span_rad = std::abs(scan.fan.max_angle_rad - scan.fan.min_angle_rad);
    view.ranges.assign(static_cast<std::size_t>(std::lround(2.0 * kPi / view.step_rad)) + 1, 0.0F);
    const Pose pose_laser_robot = inverse(scan.fan.pose_robot_laser);
    std::size_t count = 0;
    for (const Point2& point : scan.points) {
        const Point2 seen = transform(pose_laser_robot, point);
        const double range = std::hypot(seen.x, seen.y);
        const double direction = std::atan2(seen.y, seen.x);
        if (!std::isfinite(range) || !std::isfinite(direction)) continue;
        if (count++ % every == 0) {
            const auto told = static_cast<float>(direction);
            const elementary::SineCosine towards =
                elementary::sine_cosine(static_cast<double>(told));
            view.directions.push_back(told);
            view.distances.push_back(static_cast<float>(range));
            view.cosines.push_back(towards.cosine);
            view.sines.push_back(towards.sine);
        }
        float& bin = view.ranges[view.bin_of(direction)];
        if (bin == 0.0F || bin > static_cast<float>(range)) bin = static_cast<float>(range);
    }
    return view;
}

void TourExamination::note(const Scan& scan) {
    if (scan.begins_tour && scan.begins_tour->lines_before > lines_before_ && !scans_of_next_)
        begin_next(scans_of_next_, scan.begins_tour->lines_before);
    if (scans_of_next_) return next_.front().note(scan);
    note_leap(scan);
    if (scans_ > 0 && scan.time_s <= last_scan_s_) {
        // A tour that is read again has the same lines again.
        if (scan.time_s == last_scan_s_ && scan.line > last_scan_line_) ++scans_of_one_time_;
        last_scan_line_ = std::max(last_scan_line_, scan.line);
        return;
    }
    last_scan_line_ = scan.line;
    note_pause(scan);
    note_self(scan);
    note_neighbours(scan);
    constexpr double kMoves = 5e-3;   // [m], [rad]: less may look the same
    constexpr double kStillSo = 0.5;  // [s]
    const double odometer = way_m_ + turned_rad_;
    // Between two scans there need not be a reading.
    const double since_s = scan.time_s - last_scan_s_;
    const bool goes_on = std::abs(scan.time_s - last_.time_s) < kStillSo && since_s < kStillSo;
    const double moved = std::max(odometer - scan_way_, goes_on ? speed_ * since_s : 0.0);
    if (scans_ == 0) {
        fan_ = scan.fan;
        first_scan_s_ = scan.time_s;
    }
    last_scan_s_ = scan.time_s;
    if (scan.empty()) ++empty_scans_;
    if (scans_ > 0 && moved > kMoves) {
        ++moved_scans_;
        if (!scan.points.empty() && scan.points == last_points_) {
            constexpr double kFarForOneView = 1.0;
            ++same_scans_;
            if (same_run_++ == 0) same_run_begin_ = scan_way_;
            if (odometer - same_run_begin_ > kFarForOneView) {
                longest_same_run_ = std::max(longest_same_run_, same_run_);
            }
        } else {
            same_run_ = 0;
        }
    }
    ++scans_;
    scan_way_ = odometer;
    last_points_ = scan.points;
    last_fan_ = scan.fan;
    constexpr std::uint32_t kMostCounted = 10'000;
    if (scan.fan.count <= kMostCounted) {
        seen_rays_.resize(std::max<std::size_t>(seen_rays_.size(), scan.fan.count));
        for (const std::uint32_t ray : scan.rays) {
            if (ray < seen_rays_.size()) ++seen_rays_[ray];
        }
    }
    if (std::abs(scan.last_s - scan.first_s) > std::abs(last_ray_s_ - first_ray_s_)) {
        first_ray_s_ = scan.first_s;
        last_ray_s_ = scan.last_s;
    }
    constexpr std::uint64_t kEvery = 8;  // beyond the first thousands
    if (!scan.points.empty() && (medians_.size() < kMostSamples || scans_ % kEvery == 0)) {
        std::vector<float> ranges;
        ranges.reserve(scan.points.size());
        const Point2 mounting{scan.fan.pose_robot_laser.x, scan.fan.pose_robot_laser.y};
        const bool by_ray = scan.rays.size() == scan.points.size();
        // What a robot at rest sees again is no more often there.
        const bool moves = moved > kMoves || readings_ == 0;
        for (std::size_t i = 0; i < scan.points.size(); ++i) {
            const double range = distance(mounting, scan.points[i]);
            ranges.push_back(static_cast<float>(range));
            if (moves) greatest_.note(range, by_ray ? scan.rays[i] : i);
        }
        if (moves) sampled_ += scan.points.size();
        if (medians_.size() < kMostSamples) medians_.push_back(median(std::move(ranges)));
    }
    keep(scan);
}

void TourExamination::note_leap(const Scan& scan) {
    if (scans_ > 0 && scan.line <= last_scan_line_) return;  // read again
    const double by_s = scan.time_s - last_stamp_s_;
    const StampLeap newest{last_stamp_s_, by_s, elapsed_s_};
    if (scans_ > 0) elapsed_s_ += ScanClock::step_s(last_stamp_s_, scan.time_s);
    last_stamp_s_ = scan.time_s;
    if (scans_ == 0 || (by_s > 0.0 && by_s < kLeastLeap)) return;
    stamp_leaps_.push_back(newest);
    if (stamp_leaps_.size() <= kMostLeaps) return;
    stamp_leaps_.erase(std::ranges::min_element(
        stamp_leaps_, {}, [](const StampLeap& leap) { return std::abs(leap.by_s); }));
}

/// What is as near as before although the robot turned is a part of it. By direction, as some
/// lasers' fans tremble by some rays.
void TourExamination::note_self(const Scan& scan) {
    constexpr double kTurn = 0.1;  // a wall beside the robot keeps its distance where it does not
    constexpr float kOwnSize = 1.0F;  // no robot of this kind is larger
    constexpr float kSame = 0.03F;
    constexpr float kStuck = 0.001F;  // of a wall no reading is the same
    constexpr float kNewest = 0.25F;
    constexpr std::size_t kMostRays = 100'000;
    const double step = std::abs(scan.fan.step_rad());
    if (scan.rays.size() != scan.points.size() || !(step > 2.0 * kPi / kMostRays)) return;
    const bool first = directions_.empty();
    if (!first && std::abs(heading_rad_ - heading_noted_rad_) < kTurn) return;
    if (first) directions_.resize(static_cast<std::size_t>(std::ceil(2.0 * kPi / step)) + 1);
    const std::size_t bins = directions_.size();
    std::vector<float> ranges(bins, 0.0F);
    const Point2 laser{scan.fan.pose_robot_laser.x, scan.fan.pose_robot_laser.y};
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
        const double range = distance(laser, scan.points[i]);
        const double turns = wrap_angle(scan.fan.angle_rad(scan.rays[i])) / (2.0 * kPi) + 0.5;
        const auto bin =
            static_cast<std::size_t>(std::lround(turns * static_cast<double>(bins - 1)));
        ranges[bin % bins] = static_cast<float>(range);
    }
    if (!first) ++turns_;
    for (std::size_t i = 0; i < bins; ++i) {
        if (!(ranges[i] > 0.0F)) continue;
        Direction& known = directions_[i];
        if (ranges[i] >= kOwnSize) {
            if (std::abs(ranges[i] - known.far_m) < kStuck) ++known.stuck;
            known.far_m = ranges[i];
            continue;
        }
        const bool same = known.near_m > 0.0F && std::abs(ranges[i] - known.near_m) < kSame;
        if (same) ++known.near;
        known.near_m = same ? std::lerp(known.near_m, ranges[i], kNewest) : ranges[i];
    }
    heading_noted_rad_ = heading_rad_;
}

void TourExamination::keep(const Scan& scan) {
    const double odometer = way_m_ + turned_rad_;
    const bool due = open_ && (odometer - open_way_ >= kPairWay ||
                               std::abs(scan.time_s - open_->time_s) >= kPairSeconds);
    if (open_ && !due) return;
    View view = view_of(scan);
    if (due) note_still({*open_, view}, odometer);
    if (due && offered_++ % pair_stride_ == 0) {
        pairs_.push_back({std::move(*open_), view});
        if (pairs_.size() == kMostPairs) {
            thin(pairs_);
            pair_stride_ *= 2;
        }
    }
    open_.reset();
    if (scan.points.empty()) return;
    open_ = std::move(view);
    open_way_ = odometer;
}

}  // namespace hitos
