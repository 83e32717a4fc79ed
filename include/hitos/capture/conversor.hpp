// From one raw format to the normalised record [T 9.2.2].
#pragma once

#include <memory>
#include <optional>

#include "hitos/capture/fuente.hpp"
#include "hitos/capture/scan.hpp"

namespace hitos {

/// Odometry as a log states it, before it becomes a twist held over an interval.
struct OdometryRecord {
    double time_s = 0.0;
    std::optional<Pose> pose_odom_robot;  ///< where the format logs poses
    std::optional<Twist> velocity;        ///< where the format logs velocities
    std::uint64_t line = 0;
};

/// Turns raw lines of one format into normalised records. A line of metadata updates the
/// converter and gives nothing. A damaged line throws FormatError with the field, what was found
/// and what was expected (path empty; the caller knows it).
class Conversor {
  public:
    virtual ~Conversor() = default;
    virtual std::optional<Scan> scan(const RawLine& line) = 0;
    virtual std::optional<OdometryRecord> odometry(const RawLine& line) = 0;
};

/// What a reader may be told beside the log.
struct ReadOptions {
    /// Readings at or beyond it are no points [m]. 0: what the log says; where it says nothing,
    /// the code for "no return" that its first scans repeat, less 0.1 m; else 49.9 (above it lie
    /// the codes of SICK scanners).
    double max_range_m = 0.0;
    /// Use the logged v, w where there are some, instead of the twists that reproduce the poses.
    bool logged_velocities = false;
};

/// The converter for the source's format. Reads ahead through a reopened copy of the source where
/// the format does not state the greatest range.
std::unique_ptr<Conversor> make_conversor(const Fuente& fuente, const ReadOptions& options);

}  // namespace hitos
