// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a whole tour once and says what it holds.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "hitos/base/message.hpp"
#include "hitos/capture/tour_examination.hpp"
#include "hitos/capture/tour_reader.hpp"

namespace hitos {

struct RecordedTopic;

/// Counts of a whole tour, for dialogs and summaries.
struct TourSummary {
    std::string format;  ///< as TourReader::format()
    ReadReport report;
    std::uint64_t scans_of_map = 0;  ///< of them, where it goes on with a map
    double first_stamp_s = 0.0;
    double duration_s = 0.0;            ///< first to last stamp, without pauses between tours
    double distance_m = 0.0;            ///< length of the odometry's path
    Fan fan;                            ///< of the first scan
    std::uint64_t points = 0;           ///< of a laser
    std::uint64_t sightings = 0;        ///< of landmarks that a sensor told by themselves
    std::uint64_t nameless = 0;         ///< of these, without an identity
    std::set<std::int32_t> identities;  ///< of the others
    bool complete = true;               ///< false where the caller stopped the reading
    std::vector<TourFinding> findings;  ///< what there is to doubt, of a complete one
};

/// Told now and then how far the reading is, 0 … 1; false stops it.
using InspectProgress = std::function<bool(double)>;

/// Reads the tour from where it stands to its end. Throws FormatError where not one scan or
/// odometry reading can be read.
TourSummary inspect_tour(TourReader& reader, const InspectProgress& progress = {});

/// "/scan  sensor_msgs/LaserScan  292": a line for each topic, 200 at the most.
std::vector<Message> lines_of(const std::vector<RecordedTopic>& topics);

/// The topics of a ROS recording; none of another file. Throws FileError, and FormatError where a
/// recording cannot be read.
std::vector<RecordedTopic> topics_of(const std::filesystem::path& path);

/// The first lines of a text file, plain or gzip, each cut to 200 bytes; what is no text is said in
/// words; of a recording its topics. Throws what topics_of() throws.
std::vector<Message> first_lines_of(const std::filesystem::path& path);

}  // namespace hitos
