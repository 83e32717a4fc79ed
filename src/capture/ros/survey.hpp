// SPDX-License-Identifier: GPL-3.0-or-later
// What a recording holds for a tour.
#pragma once

#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "hitos/capture/log_format.hpp"
#include "recordings/recording.hpp"
#include "ros/frame_choice.hpp"

namespace hitos {

using OpenRecording = std::unique_ptr<Recording>(const std::filesystem::path&, RecordingUse);

struct RecordingSurvey {
    std::deque<Topic> topics;
    std::map<std::string, TopicFrames> frames;        ///< by topic
    std::map<std::string, std::string> laser_frames;  ///< of the first scan, by topic
    std::map<std::string, std::string> robot_frames;  ///< of the first odometry, by topic
    struct Receipt {
        std::int64_t received_ns = 0;
        double lag_s = 0.0;  ///< by which it was received later than it is stamped
    };
    std::map<std::string, std::vector<Receipt>> receipts;  ///< of the first sound ones, by topic
    Message first_problem;  ///< why some of it could not be read; empty where all could
};

/// Reads through the recording, or so much of it, once. What is damaged is left out; who reads the
/// tour is told all of it.
RecordingSurvey survey_recording(const std::filesystem::path& path, OpenRecording* open,
                                 const FileExtent& extent = {});

bool is_laser(const Topic& topic);
bool is_multi_echo(const Topic& topic);
bool is_odometry(const Topic& topic);
bool is_transforms(const Topic& topic);
TopicUse use_of(const Topic& topic);

}  // namespace hitos
