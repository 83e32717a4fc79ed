// SPDX-License-Identifier: GPL-3.0-or-later
// What the source of a recording hands its converter as the text of a line.
#pragma once

#include <string>

#include "hitos/capture/conversor.hpp"
#include "ros/laser_fan.hpp"

namespace hitos {

/// Followed by the ranges as floats, and where `timed` by as many times of rays.
struct ScanLine {
    double time_s = 0.0;
    Fan fan;
    bool timed = false;
};

struct OdometryLine {
    double time_s = 0.0;
    Pose pose_odom_robot;
    Twist twist;
    bool has_twist = false;
};

void put_line(std::string& text, const MountedScan& scan);
void put_line(std::string& text, const OdometryLine& line);

}  // namespace hitos
