// SPDX-License-Identifier: GPL-3.0-or-later
// From odometry readings to the controls between two scans [T fig 9.11].
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "hitos/capture/scan.hpp"

namespace hitos {

/// A twist and the time it was held.
struct Control {
    Twist twist;  ///< m/s, m/s, rad/s
    double duration_s = 0.0;
    friend bool operator==(const Control&, const Control&) = default;
};

/// What controls amount to.
struct DrivenWay {
    Pose pose_start_end;      ///< displacement in the robot frame at the start
    double path_m = 0.0;      ///< length of the path driven
    double turned_rad = 0.0;  ///< sum of absolute turns
    bool moved() const { return path_m > 0.0 || turned_rad > 0.0; }
};

/// Sums the controls by [T eq 7.17] (its straight-line limit included).
DrivenWay driven_way(std::span<const Control> controls);

/// Cuts the stream of odometry readings at the scans' times: the reading that spans a scan is
/// divided in proportion to time [T fig 9.11]. A scan whose line carries its own odometry takes
/// every reading up to that line, whole. Scans older than readings already used get no control.
class ControlTrack {
  public:
    using NextReading = std::function<std::optional<Odometria>()>;

    explicit ControlTrack(NextReading next) : next_(std::move(next)) {}

    /// Replaces `out` with the controls from the scan before to this one, in order.
    void controls_until(const Scan& scan, std::vector<Control>& out);

  private:
    void take(double until_s, std::vector<Control>& out);

    NextReading next_;
    std::optional<Odometria> pending_;  ///< read, not yet wholly used
    bool started_ = false;
    double used_until_s_ = 0.0;    ///< motion is accounted for up to this time
    std::uint64_t used_line_ = 0;  ///< of the last reading that is wholly used
};

/// The pose by odometry alone at every scan, from (0, 0, 0) at the first reading.
class OdometryPath {
  public:
    /// The scan's stamp and the controls up to it from the scan before; `begins` as StampedPose's.
    void add(double time_s, std::span<const Control> controls, bool begins = false);
    const Trajectory& trajectory() const { return trajectory_; }

  private:
    Pose pose_;
    Trajectory trajectory_;
};

}  // namespace hitos
