// SPDX-License-Identifier: GPL-3.0-or-later
#include "ros/survey.hpp"

#include <utility>

#include "hitos/base/error.hpp"

namespace hitos {
namespace {

bool is_readable(const Topic& topic) {
    return encoding_of(topic.encoding) != Encoding::other;
}

}  // namespace

bool is_laser(const Topic& topic) {
    return (topic.type == kLaserScanType || topic.type == kMultiEchoType) && is_readable(topic);
}

bool is_multi_echo(const Topic& topic) {
    return topic.type == kMultiEchoType;
}

bool is_odometry(const Topic& topic) {
    return topic.type == kOdometryType && is_readable(topic);
}

bool is_transforms(const Topic& topic) {
    return is_transforms_type(topic.type) && is_readable(topic);
}

TopicUse use_of(const Topic& topic) {
    if (is_laser(topic)) return TopicUse::scans;
    if (is_odometry(topic)) return TopicUse::odometry;
    return is_transforms(topic) ? TopicUse::transforms : TopicUse::none;
}

RecordingSurvey survey_recording(const std::filesystem::path& path, OpenRecording* open,
                                 const FileExtent& extent) {
    constexpr std::size_t kReceipts = 256;  // of each topic: its clock is told by any of them
    RecordingSurvey survey;
    Topics topics([](const Topic& topic) { return use_of(topic) != TopicUse::none; });
    const std::unique_ptr<Recording> recording = open(path, {topics, false, extent});
    const auto next = [&] {
        std::optional<RecordedMessage> found = recording->next();
        while (std::optional<RecordingProblem> problem = recording->take_problem()) {
            if (survey.first_problem.empty()) survey.first_problem = std::move(problem->reason);
        }
        return found;
    };
    while (const std::optional<RecordedMessage> found = next()) {
        Topic& topic = *found->topic;
        const Encoding encoding = encoding_of(topic.encoding);
        try {
            if (is_transforms(topic)) {
                FrameTree told;
                TopicFrames& frames = survey.frames[topic.name];
                const auto transforms = decode_transforms(found->bytes, encoding);
                told.hold(transforms);
                for (const StampedTransform& one : transforms) {
                    const bool fixed = topic.name.ends_with("tf_static");
                    if (fixed && told.differs(frames.frames, one.child_frame)) {
                        frames.changed.insert(one.child_frame);
                    }
                }
                frames.frames.complete(told);
                for (const StampedTransform& one : transforms) frames.publishers.note(one);
                continue;
            }
            // As numbers of 64 bits any two times of a damaged file may be too far apart.
            const double stamp_s = seconds_of(stamp_in(found->bytes, encoding));
            std::vector<RecordingSurvey::Receipt>& receipts = survey.receipts[topic.name];
            receipts.push_back({found->log_time_ns, seconds_of(found->log_time_ns) - stamp_s});
            // Of the rest the first sound message is enough.
            if (is_laser(topic)) {
                if (!survey.laser_frames.contains(topic.name)) {
                    survey.laser_frames.emplace(
                        topic.name, decode_laser_scan(found->bytes, encoding, is_multi_echo(topic))
                                        .header.frame);
                }
            } else if (!survey.robot_frames.contains(topic.name)) {
                survey.robot_frames.emplace(topic.name,
                                            decode_odometry(found->bytes, encoding).child_frame);
            }
            if (receipts.size() >= kReceipts) topic.wanted = false;
        } catch (const FormatError&) {
            continue;  // counted when it is read in earnest
        }
    }
    survey.topics = topics.all();
    return survey;
}

}  // namespace hitos
