// SPDX-License-Identifier: GPL-3.0-or-later
// What the converters of range readings have in common: which readings are points, and where.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "fields.hpp"
#include "hitos/base/error.hpp"
#include "hitos/capture/conversor.hpp"
#include "laser_pose.hpp"

namespace hitos {

/// Readings from here on are no points where nothing better is known: scanners of SICK say "no
/// return" with 50.00, 81.83 or 81.91 m.
inline constexpr double kAssumedLimit = 49.9;

/// A code for "no return" may be written a little smaller than it is.
inline constexpr double kNoReturnMargin = 0.1;

/// A converter whose lines hold ranges. Derived kinds parse a line into readings; this class makes
/// the scan.
class RangeConversor : public Conversor {
  public:
    /// Throws ConfigError where the options' place of the laser is none.
    explicit RangeConversor(ReadOptions options);

    std::optional<Scan> scan(const RawLine& line) final;

    /// The readings of one line. With a bearing each, `fan` only describes them.
    struct Readings {
        double time_s = 0.0;
        Fan fan;
        /// The log's writer marks a missing return with exactly fan.max_range_m.
        bool max_is_exact = false;
        bool carries_odometry = false;
        std::vector<double> ranges_m;
        std::vector<double> bearings_rad;  ///< in the laser's frame; empty: as the fan says
        std::vector<float> ray_times_s;    ///< from time_s on; empty: all of one time
        void clear();
    };

    /// Parses a line; false for metadata and for what another device says. Throws FormatError.
    virtual bool parse_scan(const RawLine& line, Readings& out) = 0;

    /// The same, put right as the options say.
    bool read(const RawLine& line, Readings& out);

    /// Readings from `value` less a margin on are no points, where the log does not say it better.
    void set_no_return(std::optional<double> value) { no_return_m_ = value; }

    /// Throws FormatError where a scan's rays, as the line tells them, go round more than twice, as
    /// of no laser.
    void refuse_turns(const Fan& fan) const;

    /// From here on they are no points [m].
    double limit(const Readings& readings) const;

  private:
    void mount(Readings& readings) const;
    void point_along(const Fan& fan);
    void point_along(const Pose& pose_robot_laser, const std::vector<double>& bearings_rad);

    ReadOptions options_;
    std::optional<LaserPose> laser_pose_;  // of the options
    std::optional<double> no_return_m_;
    Readings readings_;
    Fan directions_fan_;              // the fan that directions_ were computed for
    std::vector<Point2> directions_;  // robot frame, unit length
};

/// Describes bearings by a fan where they are regular to 1e-4 rad, else by one of count 0.
Fan fan_of_bearings(const std::vector<double>& bearings_rad);

/// The value by which the log's first scans say "no return": their greatest reading, where it is
/// repeated as no real distance would be. Nothing where there is none, or where the log states it.
std::optional<double> find_no_return(const Fuente& fuente, RangeConversor& scratch);

/// The readings of the log's first scans; lines that are damaged, or hold none, are passed
/// over. Ends early where `take(readings)` says false.
template <class Take>
void look_at_readings(const Fuente& fuente, RangeConversor& conversor, Take take) {
    constexpr int kScans = 50;
    constexpr int kLines = 2000;
    const std::unique_ptr<Fuente> ahead = fuente.opening();
    RangeConversor::Readings readings;
    int scans = 0;
    for (int lines = 0; lines < kLines && scans < kScans; ++lines) {
        const std::optional<RawLine> line = ahead->read_scan_line();
        if (!line) return;
        readings.clear();
        try {
            if (!conversor.read(*line, readings)) continue;
        } catch (const FormatError&) {
            continue;  // counted when the line is read in earnest
        }
        ++scans;
        if (!take(readings)) return;
    }
}

/// Whether the log's first scans say that its readings are in another unit than metres: nearly all
/// lie beyond the limit, and far, and they are no code for "no return". The conversor is used up.
std::optional<TourFinding> doubt_units(const Fuente& fuente, const ReadOptions& options,
                                       RangeConversor& conversor);

}  // namespace hitos
