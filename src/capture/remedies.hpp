// SPDX-License-Identifier: GPL-3.0-or-later
// What mends what is found.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hitos/capture/odometry_axes.hpp"
#include "hitos/capture/scan_clock.hpp"
#include "hitos/capture/tour_finding.hpp"
#include "hitos/capture/tour_reader.hpp"
#include "laser_pose.hpp"

namespace hitos {

/// Whole values: what is found of a tour comes on top of how it was read.
class WholeValues {
  public:
    using Settings = std::vector<SourceSetting>;

    explicit WholeValues(const ReadOptions& read) : read_(&read) {}  ///< which outlives it

    Settings later_by(double seconds) const;
    Settings clock(const ScanClock& added) const;
    Settings range_scale(double times) const;
    Settings range_offset(double metres) const;
    Settings fan_scale(double times) const;
    Settings odometry_scale(double times) const;
    Settings odometry_turns(double times) const;
    Settings axes(const OdometryAxes& of_read) const;

  private:
    const ReadOptions* read_;
};

/// "-0.72"
std::string hundredths_of(double value);

/// What does not depend on how the tour was read.
std::vector<SourceSetting> set(std::string_view key, std::string value);
std::vector<SourceSetting> laser_at(const LaserPose& pose);

std::vector<SourceSetting> operator+(std::vector<SourceSetting> some,
                                     std::vector<SourceSetting> more);

Message say_so();
Message added_to_times();
Remedy added_difference(std::vector<SourceSetting> delay);
/// Readings that no such laser makes.
std::vector<Remedy> millimetres_or_centimetres(const ReadOptions& read);
/// Where the odometry does not say how the robot moved.
Remedy take_it_from_scans();
Remedy take_velocities();
Remedy take_poses();
Remedy map_with_registration();

}  // namespace hitos
