// What a recording holds for a tour, and what of it is read.
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "hitos/capture/tour_reader.hpp"
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

/// Reads through the recording once. What is damaged is left out; who reads the tour is told all of
/// it.
RecordingSurvey survey_recording(const std::filesystem::path& path, OpenRecording* open);

/// The topics of a tour.
struct TourTopics {
    std::vector<std::string> scans;       ///< names, in the order of the recording
    std::string odometry;                 ///< empty: from transforms, or none
    std::string robot_frame;              ///< scans are handed out in it
    std::string odometry_frame;           ///< with transforms to it; empty where there are none
    std::vector<std::string> transforms;  ///< names: those that are the laser's
    FrameTree frames;                     ///< as they are at the beginning
    std::vector<TourFinding> findings;    ///< what there is to doubt about this choice
};

/// What the options say; else the only topic of its kind. Throws ConfigError, under the key of the
/// parameter, where there are several or another one is named, and FormatError where there is no
/// laser or where the transforms of its place contradict each other.
TourTopics choose_topics(const RecordingSurvey& survey, const ReadOptions& options,
                         const std::filesystem::path& path);

bool is_laser(const Topic& topic);
bool is_multi_echo(const Topic& topic);
bool is_odometry(const Topic& topic);
bool is_transforms(const Topic& topic);

}  // namespace hitos
