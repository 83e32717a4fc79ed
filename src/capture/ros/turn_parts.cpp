// SPDX-License-Identifier: GPL-3.0-or-later
#include "ros/turn_parts.hpp"

#include <fmt/format.h>

#include <cmath>

namespace hitos {
namespace {

bool is_turn(const Fan& fan) {
    constexpr double kMostMissing = 0.1;
    return fan.max_angle_rad - fan.min_angle_rad > (1.0 - kMostMissing) * 2.0 * kPi;
}

}  // namespace

void TurnParts::note(const MountedScan& scan, const std::string& topic) {
    constexpr double kOther = 5.0 * kRadiansPerDegree;  // some lasers' fans tremble by some rays
    const Fan& fan = scan.fan;
    Laser& laser = lasers_[topic];
    const bool other = std::abs(wrap_angle(fan.min_angle_rad - laser.last.min_angle_rad)) > kOther;
    if (laser.scans++ > 0 && other && !is_turn(fan) && !is_turn(laser.last)) {
        ++laser.parts;
        laser.apart_rad = scan.clockwise ? wrap_angle(laser.last.min_angle_rad - fan.max_angle_rad)
                                         : wrap_angle(fan.min_angle_rad - laser.last.max_angle_rad);
    }
    laser.last = fan;
}

void TurnParts::tell(std::vector<TourFinding>& found) const {
    for (const auto& [topic, laser] : lasers_) {
        if (2 * laser.parts <= laser.scans) continue;
        found.push_back(
            {TourFinding::Kind::parts_of_a_turn,
             static_cast<double>(laser.parts),
             message(HITOS_TEXT("Errors",
                                "%1 of %2 scans of %3 are parts of a turn that do not go on where "
                                "the one before ends (the last ones are %4 degrees apart), so that "
                                "each is taken as a scan of its own, which shows little"),
                     laser.parts, laser.scans, topic,
                     fmt::format("{:.0f}", laser.apart_rad * kDegreesPerRadian)),
             {{marked(HITOS_TEXT(
                 "Errors",
                 "record all messages of the laser, or let its driver send whole turns"))}}});
    }
}

}  // namespace hitos
