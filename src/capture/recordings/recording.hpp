// SPDX-License-Identifier: GPL-3.0-or-later
// Messages of a ROS recording, whatever holds them.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "hitos/base/message.hpp"
#include "hitos/capture/held_damage.hpp"
#include "regular_file.hpp"

namespace hitos {

/// A greater message is passed over and reported: a laser of a million rays has 8 MB.
inline constexpr std::uint64_t kLargestMessage = std::uint64_t{16} << 20;
/// A name, a type or another word of a recording.
inline constexpr std::uint64_t kLongestWord = 4096;
/// What one chunk may unpack to.
inline constexpr std::uint64_t kLargestChunk = std::uint64_t{512} << 20;
/// More topics are damage.
inline constexpr std::size_t kMostTopics = 4096;

/// How the bytes of a message stand for its fields.
enum class Encoding { ros1, cdr, other };

Encoding encoding_of(std::string_view word);

struct Topic {
    std::string name;
    std::string type;      ///< by ROS 1's names: "sensor_msgs/LaserScan"
    std::string encoding;  ///< the recording's word
    std::uint64_t messages = 0;
    bool wanted = false;
};

/// The topics that a recording has told so far. A place of a topic does not change.
class Topics {
  public:
    using Wanted = std::function<bool(const Topic&)>;
    explicit Topics(Wanted wanted) : wanted_(std::move(wanted)) {}

    /// The topic of this name, type and encoding, which is new where there was none. ROS 2's type
    /// names lose their "/msg". Throws FormatError beyond kMostTopics.
    Topic& of(std::string name, std::string type, std::string encoding);
    /// Counts a message; its number, from 1.
    std::uint64_t count(Topic& topic);
    const std::deque<Topic>& all() const { return topics_; }
    /// The number of something that cannot be read: one of its own, so that no message has it.
    std::uint64_t count_damage() { return ++messages_; }

  private:
    Wanted wanted_;
    std::deque<Topic> topics_;
    std::map<std::tuple<std::string, std::string, std::string>, Topic*> known_;
    std::uint64_t messages_ = 0;
};

/// One message; `bytes` are valid until the next one is asked for.
struct RecordedMessage {
    Topic* topic = nullptr;
    std::uint64_t number = 0;      ///< among all messages of the recording, from 1
    std::int64_t log_time_ns = 0;  ///< when it was received
    std::string_view bytes;
};

/// What cannot be read of a recording.
struct RecordingProblem {
    std::uint64_t number = 0;  ///< counted as a message
    Message reason;
};

/// A recording's messages from front to back, as they stand in the file; those of topics that are
/// not wanted are counted and not handed out. Damage ends what it is in: a record, a chunk, or the
/// file where no record is found behind it; and is told. Memory does not grow with the file.
class Recording {
  public:
    virtual ~Recording() = default;
    /// The next message of a wanted topic; nothing at the end. Throws FileError where the medium
    /// fails.
    virtual std::optional<RecordedMessage> next() = 0;
    /// How much of it has been passed, 0 … 1.
    virtual double progress() const = 0;
    /// The byte of the file behind all that the last message needs.
    virtual std::uint64_t position() const { return 0; }
    /// A problem that has not been told yet. Beyond some they are only counted: the last one stands
    /// for those.
    std::optional<RecordingProblem> take_problem();

  protected:
    void note(std::uint64_t number, Message reason);

  private:
    HeldDamage problems_;
};

/// How to read; shared by the files of one recording.
struct RecordingUse {
    Topics& topics;  ///< must live longer
    /// Whether checksums are compared, where there are some: with and without, what comes behind a
    /// wrong one has other numbers.
    bool check_contents = false;
    FileExtent extent = {};  ///< of a file that can be read while it is written
};

std::unique_ptr<Recording> open_bag(const std::filesystem::path& path, RecordingUse use);
std::unique_ptr<Recording> open_mcap(const std::filesystem::path& path, RecordingUse use);
std::unique_ptr<Recording> open_db3(const std::filesystem::path& path, RecordingUse use);
std::unique_ptr<Recording> open_rosbag2_folder(const std::filesystem::path& path, RecordingUse use);

/// Whether these are the first bytes of such a file.
bool begins_bag(std::string_view beginning);
bool begins_mcap(std::string_view beginning);
bool begins_db3(std::string_view beginning);

inline constexpr const char* kRosbag2Metadata = "metadata.yaml";

/// The files of a rosbag2 folder (or of that of its metadata.yaml) in their order: those that
/// metadata.yaml lists; without it, as after a recording that was broken off, all *.mcap or *.db3
/// by their numbers, and those of them that are compressed as a whole. Throws FileError where there
/// are none, FormatError where they are not in the folder or compressed.
std::vector<std::filesystem::path> rosbag2_files(const std::filesystem::path& path);

/// Whether a recording's files are in the folder, be they damaged or of a kind that is not read.
bool is_rosbag2_folder(const std::filesystem::path& folder);

}  // namespace hitos
