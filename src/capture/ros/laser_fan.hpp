// SPDX-License-Identifier: GPL-3.0-or-later
// A laser message as a fan in the robot's frame, and two of them as one.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hitos/capture/scan.hpp"
#include "ros/messages.hpp"
#include "walls_beyond.hpp"

namespace hitos {

/// A scan that knows where its laser sits. Rays go counterclockwise, seen from above.
struct MountedScan {
    std::int64_t stamp_ns = 0;
    std::uint64_t number = 0;       ///< of its message
    const Topic* device = nullptr;  ///< tells one laser from another
    bool clockwise = false;         ///< how its rays were measured
    Fan fan;
    std::vector<float> ranges_m;  ///< NaN where the message holds no usable reading
    /// Of each ray, from the stamp on [s]; empty where all are of one time.
    std::vector<float> ray_times_s;
    /// Of the message: how many readings it has, and how many of them below its least range.
    std::uint32_t readings = 0;
    std::uint32_t too_near = 0;
    double least_range_m = 0.0;
    WallsBeyond walls_beyond;     ///< its greatest range
    bool swapped_limits = false;  ///< the least range and the greatest, which were put right
};

/// `robot_laser` is the mounting; it may be upside down. Throws FormatError where it is tilted out
/// of the plane by more than 3°, and where the angles step by 0.
MountedScan mounted_scan(const LaserScanMessage& message, const Transform& robot_laser);

/// Both as one fan: where they see from one place (to 1 mm) at one time (to 1 ms) by equal steps,
/// one's rays falling between or onto the other's, and do not reach round more than a circle. Of
/// two readings on one ray the nearer counts. Nothing where they are no one fan.
std::optional<MountedScan> merged(const MountedScan& a, const MountedScan& b);

/// Both as one fan where `next` goes on where `scan` ends, in the order in which they are measured,
/// or a tenth of a turn further, and both together are no more than a turn: messages of one laser
/// that hold parts of a turn, one after the other. Rays between them have no reading. Nothing where
/// they are no such parts.
std::optional<MountedScan> joined(const MountedScan& scan, const MountedScan& next);

}  // namespace hitos
