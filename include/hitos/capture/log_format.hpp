// SPDX-License-Identifier: GPL-3.0-or-later
// The table of log formats: all that tells one format from another.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hitos/base/message.hpp"
#include "hitos/base/registry.hpp"
#include "hitos/capture/tour_finding.hpp"

namespace hitos {

class Conversor;
class Fuente;
class LogWriter;
struct ReadOptions;

/// What a line is to the two cursors. `other` is a line of the format that neither needs; `damaged`
/// is none that the format knows.
enum class LineKind { scan, odometry, both, other, damaged };

/// What a topic gives a tour.
enum class TopicUse { none, scans, odometry, transforms };

/// A topic of a ROS recording, as it names itself: any bytes.
struct RecordedTopic {
    std::string name;
    std::string type;  ///< by ROS 1's names: "sensor_msgs/LaserScan"
    std::uint64_t messages = 0;
    TopicUse use = TopicUse::none;
    std::string frame = {};  ///< of its first scan or odometry; empty where it has none
    /// Of transforms: each frame, and the one that it is placed in.
    std::vector<std::pair<std::string, std::string>> frames = {};
};

/// One format: of text, or of recordings that know how to open themselves. Lines of text come
/// trimmed and are not empty; comments begin with `#`.
struct LogFormat : RegistryEntry {
    /// Of its files, for dialogs: "*.log *.clf". Gzip files need none.
    std::string endings = "*.log";
    /// Whether a line, or a comment, is one of this format: the signature by which a log's format
    /// is found. What other formats write must not be claimed.
    bool (*claims)(std::string_view text) = nullptr;
    /// Which cursors want the line; told no comments. Pure text look-up, no parsing of numbers.
    LineKind (*classify)(std::string_view text) = nullptr;
    /// The converter of the format's lines. May read ahead through fuente.reopen().
    std::unique_ptr<Conversor> (*make_conversor)(const Fuente& fuente,
                                                 const ReadOptions& options) = nullptr;
    /// The writer; null: Hitos only reads the format.
    std::unique_ptr<LogWriter> (*make_writer)(const std::filesystem::path& path) = nullptr;

    using Begins = bool(std::string_view beginning);
    using Open = std::unique_ptr<Fuente>(const std::filesystem::path& path, const LogFormat& format,
                                         const ReadOptions& options);
    using Topics = std::vector<RecordedTopic>(const std::filesystem::path& path);
    /// Of recordings: whether these are the first 16 bytes of such a file.
    Begins* begins = nullptr;
    /// Of recordings: the source, whose lines the converter understands; null: read as text.
    Open* open = nullptr;
    /// Of recordings: what they hold; takes a pass over all of it.
    Topics* topics = nullptr;
    bool folders = false;    ///< of recordings: whether folders are some too
    bool may_grow = true;    ///< whether it can be read while it is being written
    bool ray_times = false;  ///< whether its writer says when each ray was measured
    /// Whether robots write it; what simulators write may be replayed as the thesis did.
    bool of_robots = false;
    bool landmarks = false;  ///< whether it has words for landmarks that a sensor told
    using Files = std::vector<std::filesystem::path>(const std::filesystem::path& path);
    /// Of text in several files: those of scans and of odometry, then what else is read, of the
    /// path of either of the first two; nothing of another path. Null: all is in one file.
    Files* files = nullptr;
    using Doubts = std::vector<TourFinding>(const Fuente& fuente, const ReadOptions& options);
    /// Of text: what there is to doubt that the normalised records no longer show; null: nothing.
    Doubts* doubts = nullptr;
};

/// The formats that this program knows; `source.format` chooses one, or "auto".
Registry<LogFormat>& log_formats();

/// "auto, player, radish, normalized or carmen"
std::string log_format_choices();

/// "*.log *.clf": those of all formats, each once.
std::string log_endings();

/// "player, radish, normalized, carmen or mcap": those that can be written.
std::string writable_formats();

/// The word itself where it is "auto" or a format's. Throws ConfigError, under the name of the
/// option, that lists what it can be.
std::string checked_log_format(std::string_view word, const std::string& option);

/// The same for formats that can be written; "auto" is none.
std::string checked_target_format(std::string_view word, const std::string& option);

/// In which format to write a file of this name: where a single format that can be written has its
/// ending (.gz aside), in that one ("tour.mcap"), else in the `wished` one ("tour.log").
std::string format_by_ending(const std::filesystem::path& path, std::string_view wished);

}  // namespace hitos
