// ROS recordings: bags, MCAP, rosbag2's SQLite files and its folders.
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

bool nothing_claimed(std::string_view /*text*/) {
    return false;
}

LineKind nothing_known(std::string_view /*text*/) {
    return LineKind::damaged;
}

LogFormat recording(RegistryEntry entry, const char* endings, LogFormat::Begins* begins,
                    LogFormat::Open* open) {
    return {std::move(entry),         endings, nothing_claimed, nothing_known,
            make_recording_conversor, nullptr, begins,          open};
}

}  // namespace

LogFormat rosbag_format() {
    return recording({"rosbag", HITOS_TEXT("ParameterChoice", "ROS bag"), "bags of ROS 1"}, "*.bag",
                     begins_bag, open_with<open_bag>);
}

LogFormat mcap_format() {
    return recording({"mcap", HITOS_TEXT("ParameterChoice", "MCAP"), "recordings of ROS"}, "*.mcap",
                     begins_mcap, open_with<open_mcap>);
}

LogFormat db3_format() {
    return recording({"db3", HITOS_TEXT("ParameterChoice", "ROS 2 SQLite"),
                      "recordings of ROS 2 in SQLite files"},
                     "*.db3", begins_db3, open_with<open_db3>);
}

LogFormat rosbag2_format() {
    return recording(
        {"rosbag2", HITOS_TEXT("ParameterChoice", "ROS 2 folder"), "folders of ROS 2 recordings"},
        "metadata.yaml", nullptr, open_with<open_rosbag2_folder>);
}

}  // namespace hitos
