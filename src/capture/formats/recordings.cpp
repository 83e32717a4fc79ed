// SPDX-License-Identifier: GPL-3.0-or-later
// ROS recordings: bags, MCAP, rosbag2's SQLite files and its folders.
#include <map>

#include "formats.hpp"
#include "hitos/base/error.hpp"
#include "recordings/recording.hpp"
#include "ros/recording_source.hpp"

namespace hitos {
namespace {

template <OpenRecording* Open>
std::unique_ptr<Fuente> open_with(const std::filesystem::path& path, const LogFormat& format,
                                  const ReadOptions& options) {
    return std::make_unique<RecordingSource>(plan_recording(path, format, Open, options));
}

template <OpenRecording* Open>
std::vector<RecordedTopic> topics_with(const std::filesystem::path& path) {
    const RecordingSurvey survey = survey_recording(path, Open);
    const auto frame_in = [](const std::map<std::string, std::string>& frames,
                             const std::string& topic) {
        const auto found = frames.find(topic);
        return found == frames.end() ? std::string() : found->second;
    };
    std::vector<RecordedTopic> topics;
    for (const Topic& topic : survey.topics) {
        RecordedTopic& told = topics.emplace_back();
        told.name = topic.name;
        told.type = topic.type;
        told.messages = topic.messages;
        told.use = use_of(topic);
        if (told.use == TopicUse::scans) {
            told.frame = frame_in(survey.laser_frames, topic.name);
        } else if (told.use == TopicUse::odometry) {
            told.frame = frame_in(survey.robot_frames, topic.name);
        } else if (told.use == TopicUse::transforms) {
            const auto found = survey.frames.find(topic.name);
            if (found != survey.frames.end()) told.frames = found->second.frames.links();
        }
    }
    return topics;
}

bool nothing_claimed(std::string_view /*text*/) {
    return false;
}

LineKind nothing_known(std::string_view /*text*/) {
    return LineKind::damaged;
}

bool begins_metadata(std::string_view beginning) {
    return beginning.starts_with("rosbag2_bagfile_");
}

template <OpenRecording* Open>
LogFormat recording(RegistryEntry entry, const char* endings, LogFormat::Begins* begins,
                    bool folders = false) {
    LogFormat format = {std::move(entry),         endings, nothing_claimed, nothing_known,
                        make_recording_conversor, nullptr, begins,          open_with<Open>,
                        topics_with<Open>,        folders};
    format.of_robots = true;
    format.may_grow = false;
    return format;
}

}  // namespace

LogFormat rosbag_format() {
    return recording<open_bag>(
        {"rosbag", HITOS_TEXT("ParameterChoice", "ROS bag"), "bags of ROS 1"}, "*.bag", begins_bag);
}

LogFormat mcap_format() {
    LogFormat format =
        recording<open_mcap>({"mcap", HITOS_TEXT("ParameterChoice", "MCAP"), "recordings of ROS"},
                             "*.mcap", begins_mcap);
    format.may_grow = true;
    format.make_writer = make_mcap_writer;
    format.ray_times = true;
    return format;
}

LogFormat db3_format() {
    return recording<open_db3>({"db3", HITOS_TEXT("ParameterChoice", "ROS 2 SQLite"),
                                "recordings of ROS 2 in SQLite files"},
                               "*.db3 *.db3.zstd", begins_db3);
}

LogFormat rosbag2_format() {
    return recording<open_rosbag2_folder>(
        {"rosbag2", HITOS_TEXT("ParameterChoice", "ROS 2 folder"), "folders of ROS 2 recordings"},
        "metadata.yaml *.mcap.zstd", begins_metadata, true);
}

}  // namespace hitos
