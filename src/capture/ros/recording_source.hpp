// SPDX-License-Identifier: GPL-3.0-or-later
// A ROS recording as a source of scans and odometry.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "hitos/base/geometry.hpp"
#include "hitos/capture/conversor.hpp"
#include "hitos/capture/fuente.hpp"
#include "hitos/capture/held_damage.hpp"
#include "hitos/capture/log_format.hpp"
#include "hitos/capture/stamp_line.hpp"
#include "hitos/capture/tour_reader.hpp"
#include "ros/laser_fan.hpp"
#include "ros/odd_turns.hpp"
#include "ros/range_limits.hpp"
#include "ros/stamp_queue.hpp"
#include "ros/topic_choice.hpp"
#include "ros/turn_parts.hpp"

namespace hitos {

/// Found out once for all sources of one recording.
struct RecordingPlan {
    std::filesystem::path path;
    const LogFormat& format;
    OpenRecording* open;
    TourTopics topics;
    ReadOptions options;
    // How far messages may be out of order. What came in live is not held back for it.
    std::size_t scans_held = 0;
    std::size_t readings_held = 0;
};

/// Surveys the recording and chooses its topics. Throws what survey_recording() and choose_topics()
/// throw.
std::shared_ptr<const RecordingPlan> plan_recording(const std::filesystem::path& path,
                                                    const LogFormat& format, OpenRecording* open,
                                                    const ReadOptions& options);

/// Its lines are bytes that make_recording_conversor() understands: scans in the robot's frame and
/// odometry in the plane, each sequence in the order of header.stamp as far as a window of messages
/// sees. Their numbers are those of the messages. Each cursor reads the recording for itself, so
/// that memory does not grow with it; what is damaged is told to the scan cursor's owner.
///
/// * Scans come from one or more lasers; those of one place and time are one scan.
/// * Messages of a laser that hold neighbouring parts of a turn are joined to turns.
/// * Odometry comes from a topic, or from the transforms to the odometry's frame.
/// * A laser that no transform mentions, in a recording without any, sits in the robot's origin.
class RecordingSource final : public Fuente {
  public:
    enum class Part : std::uint8_t { whole, opening };
    explicit RecordingSource(std::shared_ptr<const RecordingPlan> plan, Part part = Part::whole);
    ~RecordingSource() override;
    RecordingSource(const RecordingSource&) = delete;
    RecordingSource& operator=(const RecordingSource&) = delete;

    const LogFormat& format() const override { return plan_->format; }
    std::optional<RawLine> read_scan_line() override;
    std::optional<RawLine> read_odometry_line() override;
    std::optional<double> progress() const override;
    std::string name() const override { return plan_->path.string(); }
    std::optional<std::pair<std::uint64_t, Message>> take_damage() override {
        return damage_.take();
    }
    std::vector<TourFinding> findings() const override;
    std::unique_ptr<Fuente> reopen() const override;
    std::unique_ptr<Fuente> opening() const override;
    /// The most messages that were one scan.
    std::size_t most_joined() const { return most_joined_; }

  private:
    struct Cursor;
    struct Reading {
        std::int64_t stamp_ns = 0;
        std::uint64_t number = 0;
        Pose pose_odom_robot;
        std::optional<Twist> twist;
    };
    std::optional<RecordedMessage> next(Cursor& cursor);
    void take_in_scans(const RecordedMessage& found);
    /// What has gone on of a laser, and of the odometry, into their order.
    void hold_scans(StampLine<MountedScan>& of_laser);
    void hold_readings();
    MountedScan scan_of(const RecordedMessage& found) const;
    void take_in_odometry(const RecordedMessage& found);

    std::shared_ptr<const RecordingPlan> plan_;
    Part part_;
    std::size_t most_joined_ = 0;
    std::unique_ptr<Cursor> scans_;
    std::unique_ptr<Cursor> odometry_;
    std::map<std::string, FrameTree> frames_;                       ///< by the laser's topic
    std::map<const Topic*, StampLine<MountedScan>> arrived_scans_;  ///< of each laser
    StampQueue<MountedScan> held_scans_;
    TurnParts parts_;
    RangeLimits limits_;
    OddTurns odd_odometry_;
    OddTurns odd_transforms_;
    StampLine<Reading> arrived_readings_;
    StampQueue<Reading> held_readings_;
    std::string scan_text_;
    std::string odometry_text_;
    HeldDamage damage_;
};

/// Of such a source's lines.
std::unique_ptr<Conversor> make_recording_conversor(const Fuente& fuente,
                                                    const ReadOptions& options);
/// What there is to doubt about its ranges.
std::vector<TourFinding> recording_doubts(const Fuente& fuente, const ReadOptions& options);

}  // namespace hitos
