// SPDX-License-Identifier: GPL-3.0-or-later
// What every layer above asks for scans and odometry, wherever they come from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/base/message.hpp"
#include "hitos/capture/scan.hpp"
#include "hitos/capture/tour_finding.hpp"

namespace hitos {

class FileGrowth;

/// What was read, and what was left out of a log and why.
struct ReadReport {
    /// A line that was left out, and why.
    struct Skip {
        std::uint64_t line = 0;
        Message reason;
    };
    static constexpr std::size_t kExamples = 20;

    std::uint64_t scans = 0;
    std::uint64_t odometry = 0;
    std::uint64_t duplicate_scans = 0;   ///< same stamp and same ranges as the scan before
    std::uint64_t stamps_backwards = 0;  ///< readings whose stamp did not advance
    /// Before the first odometry reading, where there is one: handed out all the same, as if the
    /// robot had stood still until then.
    std::uint64_t early_scans = 0;
    std::uint64_t early_scans_left_out = 0;  ///< those, by ReadOptions::leave_out_early_scans
    std::uint64_t skipped = 0;               ///< damaged lines, each counted once
    std::vector<Skip> examples;              ///< the first kExamples damaged lines, by line
    bool of_recording = false;               ///< what is called a line here is a message of ROS

    /// "line 17", or "message 17"
    Message place(std::uint64_t line) const;
    /// "line 17: …"
    Message placed(const Skip& skip) const;
};

/// What becomes odometry readings.
enum class OdometryFrom : std::uint8_t {
    poses,       ///< the twists that reproduce the logged poses
    velocities,  ///< the logged v and w, where there are some
    scans        ///< what the scans say by themselves, whatever the log does
};

/// What is known to be wrong and is mended.
enum class Mend : std::uint8_t {
    nothing,
    rays,  ///< those measured one after the other are moved, by the odometry, to where they would
           ///< lie had all been measured at the scan's time
    all    ///< besides, a leap of the odometry that no robot makes becomes a step like the one
           ///< before it, stamps of too few digits give way to a logger's times, and where there is
           ///< no odometry at all the scans say how the robot moved
};

/// What a reader may be told beside where to read.
struct ReadOptions {
    /// Readings at or beyond it are no points [m]. 0: what the log says; where it says nothing,
    /// the code for "no return" that its first scans repeat, less 0.1 m; else 49.9 (above it lie
    /// the codes of SICK scanners).
    double max_range_m = 0.0;
    OdometryFrom odometry = OdometryFrom::poses;
    /// Of a ROS recording with several lasers: the topic, topics with commas between them, or
    /// "all". Lasers that see from one place are one sensor.
    std::string scan_topic = {};
    /// Of a ROS recording with several odometries: the topic, or "tf" for the transforms.
    std::string odom_topic = {};
    /// Leave out the scans before the first odometry reading: how the robot moved from one to the
    /// next is not known.
    bool leave_out_early_scans = false;
    /// Added to the scans' times [s], where the laser's clock is not the odometry's. Scans whose
    /// line carries odometry then go by their times like all others.
    double scan_delay_s = 0.0;
    /// Added besides where that clock does not stay as it is: ScanClock's text.
    std::string scan_clock = {};
    /// Where the laser sits on the robot, whatever the log says: "x,y,degrees", with
    /// ",upside-down" behind it where it does. Empty: as the log says.
    std::string laser_pose = {};
    /// Frames of a ROS recording that are one: "base_footprint=base_link", several with commas
    /// between them.
    std::string same_frames = {};
    /// Nearer readings are no points [m]: the robot's own parts.
    double min_range_m = 0.0;
    /// From one ray to the next [s]. 0: as the log says, else all rays are of one time.
    double ray_time_s = 0.0;
    /// By this readings are multiplied, and the greatest range that the log says, to be metres.
    double range_scale = 1.0;
    /// Added to each reading [m].
    double range_offset_m = 0.0;
    /// By this the rays' angles, from where the laser looks, are wider than the log says.
    double fan_scale = 1.0;
    /// By this the odometry's way is longer than it says.
    double odometry_scale = 1.0;
    /// By this its turns are wider than it says; negative: it counts them to the right.
    double odometry_turns = 1.0;
    /// What its poses have in the place of x, y and heading: "y,x,theta", "x,y,90-theta",
    /// "x,y,degrees". Empty: those.
    std::string odometry_axes = {};
    Mend mend = Mend::all;
    /// Where not 0, the log is read as it came in live: what has to be decided before the first
    /// scan (topics, the code for "no return", whether there is odometry) by so many of its first
    /// bytes, and messages of a recording are handed out as they were received.
    std::uint64_t opening_bytes = 0;
    /// Of a log that is being written still: whoever reads it waits for more. Null: it is whole.
    std::shared_ptr<FileGrowth> growth = {};
    friend bool operator==(const ReadOptions&, const ReadOptions&) = default;
};

/// For another recording: what was said of this one alone, its topics, clocks, mounting, units,
/// which of its odometry is right, is not said of that one.
inline ReadOptions for_another_recording(const ReadOptions& read) {
    ReadOptions other;
    other.leave_out_early_scans = read.leave_out_early_scans;
    other.mend = read.mend;
    return other;
}

/// The word that asks for detection from the content; no format may have it.
inline constexpr std::string_view kAutoFormat = "auto";

/// What a simulated tour is read from.
inline constexpr const char* kWorldFormat = "world";

/// Whether the name ends in .toml: a world to simulate, not a log.
bool is_world_file(const std::filesystem::path& path);

/// What is known to be true of a tour, in the frame of its start: the robot's pose at the first
/// scan is (0, 0, 0).
struct Truth {
    Trajectory path;  ///< the pose at every scan
    Walls walls;
    std::uint64_t seed = 0;  ///< of the noise of its laser and its odometry
};

/// A tour that is read once, from its beginning to its end: scans and odometry in two sequences
/// that are independent of each other. Logs are read by Procesador, worlds by
/// SimulatedTourReader; other readers change what a reader gives (odometry noise).
class TourReader {
  public:
    virtual ~TourReader() = default;

    /// The next scan; nothing at the end. Throws FileError where the medium fails.
    virtual std::optional<Scan> next_scan() = 0;
    /// The next odometry reading; nothing at the end.
    virtual std::optional<Odometria> next_odometry() = 0;

    /// Back to the beginning, with a fresh report. A failure leaves the reader where it was.
    virtual void restart() = 0;
    /// An equal reader at its beginning, independent of this one.
    virtual std::unique_ptr<TourReader> reopen() const = 0;

    /// What was read so far.
    virtual const ReadReport& report() const = 0;
    /// How far the scans have come, 0 … 1; nothing where it cannot be known.
    virtual std::optional<double> progress() const = 0;
    /// What to call the tour in messages: a path.
    virtual std::string name() const = 0;
    /// The word of the log's format, or kWorldFormat.
    virtual std::string format() const = 0;
    /// How it is read.
    virtual ReadOptions options() const = 0;
    /// What there is to doubt about how the tour is read, as far as it has been.
    virtual std::vector<TourFinding> findings() const { return {}; }
    /// The truth, where the tour knows it: a simulated one does.
    virtual std::optional<Truth> truth() const { return std::nullopt; }
};

}  // namespace hitos
