// SPDX-License-Identifier: GPL-3.0-or-later
#include "ros/recording_source.hpp"

#include <algorithm>
#include <iterator>

#include "hitos/base/error.hpp"
#include "read_extent.hpp"
#include "ros/recording_lines.hpp"
#include "stamp_doubts.hpp"

namespace hitos {
namespace {

// How far receipt may be out of order. Recorders write what several sources send in bundles; 64
// scans are 5 s of a fast laser and more of a slow one.
constexpr std::size_t kScansHeld = 64;
constexpr std::size_t kScanBytesHeld = std::size_t{32} << 20;
constexpr std::size_t kReadingsHeld = 512;

}  // namespace

struct RecordingSource::Cursor {
    Cursor(const RecordingPlan& plan, const FileExtent& extent, Topics::Wanted wanted)
        : topics(std::move(wanted)), recording(plan.open(plan.path, {topics, true, extent})) {}
    Topics topics;
    std::unique_ptr<Recording> recording;
    bool ended = false;
};

std::shared_ptr<const RecordingPlan> plan_recording(const std::filesystem::path& path,
                                                    const LogFormat& format, OpenRecording* open,
                                                    const ReadOptions& options) {
    const bool live = options.opening_bytes > 0;
    const RecordingSurvey survey = survey_recording(path, open, opening_extent(options));
    auto plan = std::make_shared<RecordingPlan>(RecordingPlan{path, format, open,
                                                              choose_topics(survey, options, path),
                                                              options, kScansHeld, kReadingsHeld});
    if (!live) return plan;
    // A scan in several messages is known to be whole when the next one comes.
    RecordingSource opening(plan, RecordingSource::Part::opening);
    while (opening.read_scan_line()) {
    }
    plan->scans_held = opening.most_joined() > 1 ? opening.most_joined() : 0;
    plan->readings_held = 0;
    return plan;
}

RecordingSource::RecordingSource(std::shared_ptr<const RecordingPlan> plan, Part part)
    : plan_(std::move(plan)),
      part_(part),
      held_scans_(plan_->scans_held, kScanBytesHeld),
      held_readings_(plan_->readings_held, kScanBytesHeld) {
    const TourTopics& topics = plan_->topics;
    for (const auto& [laser, own] : topics.of_laser) frames_.emplace(laser, own.frames);
    const auto is_chosen = [topics](const Topic& topic) {
        return is_transforms(topic) && std::ranges::count(topics.transforms, topic.name) > 0;
    };
    const auto is_reading = [topics, is_chosen](const Topic& topic) {
        if (!topics.odometry.empty()) return is_odometry(topic) && topic.name == topics.odometry;
        return !topics.odometry_frame.empty() && is_chosen(topic);
    };
    // The scan cursor passes over odometry too, and so finds what is damaged in it.
    const auto is_any = [topics, is_chosen, is_reading](const Topic& topic) {
        return is_chosen(topic) || is_reading(topic) ||
               (is_laser(topic) && std::ranges::count(topics.scans, topic.name) > 0);
    };
    const ReadOptions& options = plan_->options;
    const FileExtent extent =
        part == Part::opening ? opening_extent(options) : whole_extent(options);
    scans_ = std::make_unique<Cursor>(*plan_, extent, is_any);
    odometry_ = std::make_unique<Cursor>(*plan_, extent, is_reading);
    // Where there is none, nobody waits for any.
    odometry_->ended = topics.odometry.empty() && topics.odometry_frame.empty();
}

RecordingSource::~RecordingSource() = default;

std::unique_ptr<Fuente> RecordingSource::reopen() const {
    return std::make_unique<RecordingSource>(plan_, part_);
}

std::unique_ptr<Fuente> RecordingSource::opening() const {
    if (plan_->options.opening_bytes == 0) return reopen();
    return std::make_unique<RecordingSource>(plan_, Part::opening);
}

std::optional<RecordedMessage> RecordingSource::next(Cursor& cursor) {
    std::optional<RecordedMessage> found = cursor.recording->next();
    const std::shared_ptr<FileGrowth>& growth = plan_->options.growth;
    if (!found || part_ != Part::whole || growth == nullptr || &cursor != scans_.get())
        return found;
    if (is_laser(*found->topic)) growth->note_taken(cursor.recording->position());
    growth->note_passed(cursor.recording->position());
    return found;
}

std::vector<TourFinding> RecordingSource::findings() const {
    std::vector<TourFinding> found = plan_->topics.findings;
    parts_.tell(found);
    limits_.tell(plan_->options, found);
    odd_odometry_.tell_odometry(found);
    odd_transforms_.tell_transforms(found);
    BrokenStamps of_scans;
    for (const auto& [laser, arrived] : arrived_scans_) of_scans = of_scans + arrived.broken();
    doubt_broken_stamps(of_scans, arrived_readings_.broken(), found);
    if (std::ranges::count(found, TourFinding::Kind::blind_laser, &TourFinding::kind) == 0) {
        std::ranges::move(recording_doubts(*this, plan_->options), std::back_inserter(found));
    }
    return found;
}

std::optional<double> RecordingSource::progress() const {
    if (plan_->options.growth && !plan_->options.growth->ended()) return std::nullopt;
    return scans_->recording->progress();
}

std::optional<RawLine> RecordingSource::read_scan_line() {
    for (;;) {
        if (std::optional<MountedScan> scan = held_scans_.pop(scans_->ended)) {
            // What belongs to it: the other parts of its turn, and what other lasers saw at that
            // time from that place.
            std::size_t parts = 1;
            while (const MountedScan* next = held_scans_.earliest()) {
                std::optional<MountedScan> both =
                    next->device == scan->device ? joined(*scan, *next) : merged(*scan, *next);
                if (!both) break;
                held_scans_.pop(true);
                scan = std::move(both);
                ++parts;
            }
            most_joined_ = std::max(most_joined_, parts);
            if (scan->device) parts_.note(*scan, scan->device->name);
            put_line(scan_text_, *scan);
            return RawLine{scan_text_, scan->number};
        }
        if (scans_->ended) return std::nullopt;
        const std::optional<RecordedMessage> found = next(*scans_);
        while (std::optional<RecordingProblem> problem = scans_->recording->take_problem()) {
            damage_.note(problem->number, std::move(problem->reason));
        }
        if (!found) {
            scans_->ended = true;
            for (auto& [laser, arrived] : arrived_scans_) {
                arrived.end();
                hold_scans(arrived);
            }
            continue;
        }
        try {
            take_in_scans(*found);
        } catch (const FormatError& error) {
            damage_.note(found->number, message("%1: %2", found->topic->name, error.problem()));
        }
    }
}

void RecordingSource::take_in_scans(const RecordedMessage& found) {
    const Encoding encoding = encoding_of(found.topic->encoding);
    const Told told = [&](const Message& problem) {
        damage_.note(found.number, message("%1: %2", found.topic->name, problem));
    };
    if (is_transforms(*found.topic)) {
        const auto transforms = decode_transforms(found.bytes, encoding, told);
        for (const StampedTransform& one : transforms)
            odd_transforms_.note(one.transform, found.number);
        for (const auto& [laser, own] : plan_->topics.of_laser) {
            if (std::ranges::count(own.topics, found.topic->name) > 0) {
                frames_.at(laser).hold(transforms);
            }
        }
    } else if (is_odometry(*found.topic)) {
        const OdometryMessage odometry = decode_odometry(found.bytes, encoding, told);
        odd_odometry_.note(odometry.pose, found.number);
        if (odometry.twist) odd_odometry_.note_twist();
    } else {
        MountedScan scan = scan_of(found);
        limits_.note(scan, found.topic->name);
        StampLine<MountedScan>& arrived = arrived_scans_[found.topic];
        const double time_s = seconds_of(scan.stamp_ns);
        arrived.add(time_s, found.number, std::move(scan));
        hold_scans(arrived);
    }
}

void RecordingSource::hold_scans(StampLine<MountedScan>& of_laser) {
    const auto left_out = [this](std::uint64_t number, Message reason) {
        damage_.note(number, std::move(reason));
    };
    while (std::optional<MountedScan> scan = of_laser.take(left_out)) {
        const std::size_t bytes = sizeof *scan + scan->ranges_m.size() * sizeof(float);
        held_scans_.push(*std::move(scan), bytes, of_laser.returns());
    }
}

MountedScan RecordingSource::scan_of(const RecordedMessage& found) const {
    const LaserScanMessage scan = decode_laser_scan(found.bytes, encoding_of(found.topic->encoding),
                                                    is_multi_echo(*found.topic));
    const std::string& robot = plan_->topics.robot_frame;
    std::optional<Transform> robot_laser =
        frames_.at(found.topic->name).between(robot, scan.header.frame);
    // Where the options say it, the converter puts it there; where nothing does, it is doubted.
    if (!plan_->options.laser_pose.empty() || plan_->topics.frames.empty()) {
        robot_laser = Transform{};
    }
    if (!robot_laser) {
        throw FormatError(
            {}, 0,
            HITOS_TEXT(
                "Errors",
                "no transform leads from the laser's frame \"%1\" to the robot's frame \"%2\", so "
                "where the laser sits is not known; say where (--laser-pose x,y,degrees), or which "
                "frames are one (--same-frames %2=NAME), or choose another laser (--scan-topic)"),
            scan.header.frame, robot);
    }
    MountedScan mounted = mounted_scan(scan, *robot_laser);
    mounted.number = found.number;
    mounted.device = found.topic;
    return mounted;
}

std::optional<RawLine> RecordingSource::read_odometry_line() {
    for (;;) {
        if (const std::optional<Reading> reading = held_readings_.pop(odometry_->ended)) {
            put_line(odometry_text_,
                     OdometryLine{seconds_of(reading->stamp_ns), reading->pose_odom_robot,
                                  reading->twist.value_or(Twist{}), reading->twist.has_value()});
            return RawLine{odometry_text_, reading->number};
        }
        if (odometry_->ended) return std::nullopt;
        const std::optional<RecordedMessage> found = next(*odometry_);
        // The scan cursor meets the same problems and tells them.
        while (odometry_->recording->take_problem()) {
        }
        if (!found) {
            odometry_->ended = true;
            arrived_readings_.end();
            hold_readings();
            continue;
        }
        try {
            take_in_odometry(*found);
        } catch (const FormatError&) {
            continue;
        }
    }
}

void RecordingSource::hold_readings() {
    const auto left_out = [this](std::uint64_t number, Message reason) {
        damage_.note(number, std::move(reason));
    };
    while (const std::optional<Reading> reading = arrived_readings_.take(left_out)) {
        held_readings_.push(*reading, sizeof(Reading), arrived_readings_.returns());
    }
}

void RecordingSource::take_in_odometry(const RecordedMessage& found) {
    const Encoding encoding = encoding_of(found.topic->encoding);
    const auto hold = [&](std::int64_t stamp_ns, const Pose& pose, std::optional<Twist> twist) {
        arrived_readings_.add(seconds_of(stamp_ns), found.number,
                              {stamp_ns, found.number, pose, twist});
        hold_readings();
    };
    if (!is_transforms(*found.topic)) {
        const OdometryMessage odometry = decode_odometry(found.bytes, encoding);
        hold(odometry.header.stamp_ns, odometry.pose.plane(), odometry.twist);
        return;
    }
    const TourTopics& topics = plan_->topics;
    for (const StampedTransform& told : decode_transforms(found.bytes, encoding)) {
        if (told.header.frame != topics.odometry_frame) continue;
        if (told.child_frame != topics.robot_frame) continue;
        hold(told.header.stamp_ns, told.transform.plane(), std::nullopt);
    }
}

}  // namespace hitos
