// SPDX-License-Identifier: GPL-3.0-or-later
// What of a recording is read for a tour, and what there is to doubt about that.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "hitos/capture/tour_reader.hpp"
#include "ros/survey.hpp"

namespace hitos {

/// The topics of a tour.
struct TourTopics {
    std::vector<std::string> scans;       ///< names, in the order of the recording
    std::string odometry;                 ///< empty: from transforms, or none
    std::string robot_frame;              ///< scans are handed out in it
    std::string odometry_frame;           ///< with transforms to it; empty where there are none
    std::vector<std::string> transforms;  ///< names: those that are a laser's
    FrameTree frames;                     ///< of the first laser, as they are at the beginning
    std::map<std::string, FrameChoice> of_laser;  ///< by topic: its own transforms
    std::vector<TourFinding> findings;            ///< what there is to doubt about this choice
};

/// What the options say; else the only topic of its kind. Throws ConfigError, under the key of the
/// parameter, where there are several or another one is named, or the lasers are on several robots,
/// and FormatError where there is no
/// laser or where the transforms of its place contradict each other.
TourTopics choose_topics(const RecordingSurvey& survey, const ReadOptions& options,
                         const std::filesystem::path& path);

}  // namespace hitos
