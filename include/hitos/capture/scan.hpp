// SPDX-License-Identifier: GPL-3.0-or-later
// One laser scan and one odometry reading, as every layer above sees them [T fig 9.2].
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "hitos/base/geometry.hpp"

namespace hitos {

/// The fan of rays a scanner sweeps: ray i of `count` lies at
/// min_angle + i (max_angle - min_angle) / (count - 1), whatever resolution the log states. It
/// sweeps clockwise where max_angle is the lesser one.
struct Fan {
    double min_angle_rad = 0.0;
    double max_angle_rad = 0.0;
    std::uint32_t count = 0;
    double max_range_m = 0.0;  ///< 0 where the log does not say
    Pose pose_robot_laser;     ///< mounting of the laser; identity where the log does not say
    bool upside_down = false;  ///< its rays are those of a laser that sits so, turned over already

    /// From one ray to the next; 0 where there is one ray only.
    double step_rad() const {
        return count > 1 ? (max_angle_rad - min_angle_rad) / (count - 1) : 0.0;
    }
    /// Of a ray, in the laser's frame.
    double angle_rad(std::size_t ray) const {
        return min_angle_rad + static_cast<double>(ray) * step_rad();
    }
    /// Whether it covers one whole turn, so that its last ray is the neighbour of its first. Half a
    /// step is left to logs that round their angles, or have a first and a last ray that are one.
    bool closed() const {
        const double step = std::abs(step_rad());
        return count > 2 && std::abs(std::abs(max_angle_rad - min_angle_rad) + 0.5 * step -
                                     2.0 * kPi) <= step * (1.0 + 1e-9);
    }
    friend bool operator==(const Fan&, const Fan&) = default;
};

/// That another tour comes before, in whose map this one begins anywhere.
struct TourBegin {
    bool hold = false;               ///< that map stays as it is
    std::optional<Pose> start;       ///< where about in it the robot begins, as somebody says
    std::uint64_t lines_before = 0;  ///< of the log of that tour: its own come on top of them
    friend bool operator==(const TourBegin&, const TourBegin&) = default;
};

/// A landmark as a sensor reports it that tells landmarks from the rest by itself: a beacon, a post
/// with a code. In the robot frame, like points.
struct LandmarkSighting {
    static constexpr std::int32_t kNameless = -1;

    double range_m = 0.0;
    double bearing_rad = 0.0;
    std::int32_t identity = kNameless;  ///< which landmark it is, from 0, where the sensor tells

    Point2 point() const {
        return {range_m * std::cos(bearing_rad), range_m * std::sin(bearing_rad)};
    }
    friend bool operator==(const LandmarkSighting&, const LandmarkSighting&) = default;
};

/// Tells a scan from those of other logs, whatever is made of it: of its line, or of what a
/// simulated one sees. 0: not known. Two scans may be equal that were written otherwise.
struct ScanMark {
    std::uint32_t value = 0;
    friend bool operator==(const ScanMark& /*a*/, const ScanMark& /*b*/) { return true; }
};

/// One scan: the points that were hit, in the ROBOT frame [m] (the sensor frame moved by the
/// mounting pose where the log gives one), in ray order. Rays without a usable reading leave no
/// point but end a run of neighbours.
struct Scan {
    double time_s = 0.0;                    ///< by the odometry's clock
    std::vector<Point2> points;             ///< robot frame, ray order
    std::vector<std::uint32_t> run_starts;  ///< index of the first point of each run of neighbours
    std::vector<std::uint32_t> rays;        ///< ray number of each point; empty: unknown
    std::vector<LandmarkSighting> landmarks;  ///< that a sensor told by themselves
    std::vector<float> times_s;  ///< of each point, from time_s on; empty: all of one time
    float first_s = 0.0F;        ///< when its first point was measured, and its last, from
    float last_s = 0.0F;         ///< time_s on, where they were moved to where they lay then
    Fan fan;                     ///< count == 0: unknown (normalised logs)
    std::uint64_t line = 0;      ///< 1-based line of the log
    ScanMark mark;
    bool carries_odometry = false;         ///< the same line is an odometry reading too
    std::optional<TourBegin> begins_tour;  ///< where another tour came before
    double delay_s = 0.0;  ///< what was added to the logged stamp (source.scan_delay)

    /// As logged, by the laser's clock: what paths are stamped with.
    double stamp_s() const { return time_s - delay_s; }
    bool empty() const { return points.empty() && landmarks.empty(); }
    /// Index behind the last point of a run.
    std::uint32_t run_end(std::size_t run) const {
        return run + 1 < run_starts.size() ? run_starts[run + 1]
                                           : static_cast<std::uint32_t>(points.size());
    }
    friend bool operator==(const Scan&, const Scan&) = default;
};

/// One odometry reading: the twist held since the previous reading up to this one's time
/// [T fig 9.11]. The first reading of a log only sets the clock (its twist is zero).
struct Odometria {
    double time_s = 0.0;  ///< strictly increasing from reading to reading
    Twist twist;          ///< m/s, m/s, rad/s
    std::uint64_t line = 0;
    /// Of the first one of a tour behind another: as TourBegin has it; else 0.
    std::uint64_t lines_before = 0;
    friend bool operator==(const Odometria&, const Odometria&) = default;
};

}  // namespace hitos
