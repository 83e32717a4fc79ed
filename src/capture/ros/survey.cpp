#include "ros/survey.hpp"

#include <algorithm>
#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/capture/archivo.hpp"

namespace hitos {
namespace {

bool is_readable(const Topic& topic) {
    return encoding_of(topic.encoding) != Encoding::other;
}

/// "/scan (292), /rear (17)": names of topics and how many messages they have.
std::string listed(const std::vector<const Topic*>& topics) {
    constexpr std::size_t kMost = 20;
    std::string list;
    for (std::size_t i = 0; i < std::min(kMost, topics.size()); ++i) {
        list += (list.empty() ? "" : ", ") + topics[i]->name + " (" +
                std::to_string(topics[i]->messages) + ")";
    }
    return topics.size() > kMost ? list + ", …" : list;
}

std::vector<const Topic*> with_messages(const RecordingSurvey& survey, bool (*is)(const Topic&)) {
    std::vector<const Topic*> found;
    for (const Topic& topic : survey.topics) {
        if (topic.messages > 0 && is(topic)) found.push_back(&topic);
    }
    return found;
}

bool is_any(const Topic& /*topic*/) {
    return true;
}

/// Separated by commas.
std::vector<std::string_view> names_in(std::string_view text) {
    std::vector<std::string_view> names;
    while (!text.empty()) {
        const std::size_t comma = std::min(text.find(','), text.size());
        if (const auto name = input::trimmed(text.substr(0, comma)); !name.empty()) {
            names.push_back(name);
        }
        text.remove_prefix(std::min(comma + 1, text.size()));
    }
    return names;
}

/// With or without the slash that every topic begins with.
bool has_name(const Topic& topic, std::string_view name) {
    std::string_view own = topic.name;
    if (own.starts_with('/')) own.remove_prefix(1);
    if (name.starts_with('/')) name.remove_prefix(1);
    return own == name;
}

const Topic& named(const std::vector<const Topic*>& topics, std::string_view name, const char* key,
                   const std::filesystem::path& path) {
    const auto found =
        std::ranges::find_if(topics, [&](const Topic* topic) { return has_name(*topic, name); });
    if (found != topics.end()) return **found;
    throw ConfigError(
        key, message(HITOS_TEXT("Errors", "found \"%1\", expected one of the topics of %2: %3"),
                     name, path.string(), listed(topics)));
}

void choose_scans(const RecordingSurvey& survey, const ReadOptions& options,
                  const std::filesystem::path& path, TourTopics& chosen) {
    const std::vector<const Topic*> lasers = with_messages(survey, is_laser);
    const std::vector<const Topic*> all_topics = with_messages(survey, is_any);
    const std::string list = all_topics.empty() ? "-" : listed(all_topics);
    if (lasers.empty() && !survey.first_problem.empty()) {
        throw FormatError(
            path.string(), 0,
            message(HITOS_TEXT("Errors",
                               "no laser scans (messages sensor_msgs/LaserScan) can be read in it, "
                               "as some of it cannot: %1; the topics that can are: %2"),
                    survey.first_problem, list));
    }
    if (lasers.empty()) {
        throw FormatError(
            path.string(), 0,
            message(HITOS_TEXT("Errors",
                               "holds no laser scans (messages sensor_msgs/LaserScan); its topics "
                               "are: %1"),
                    list));
    }
    const std::vector<std::string_view> names = names_in(options.scan_topic);
    if (names.empty() && lasers.size() > 1) {
        throw ConfigError(
            kScanTopicKey,
            message(
                HITOS_TEXT("Errors",
                           "found %1 laser topics in %2: %3; choose one (--scan-topic), several "
                           "with commas between them, or \"all\""),
                lasers.size(), path.string(), listed(lasers)));
    }
    const bool all = names.empty() || (names.size() == 1 && names.front() == "all");
    for (const Topic* laser : lasers) {
        const bool wanted = all || std::ranges::any_of(names, [&](std::string_view name) {
                                return has_name(*laser, name);
                            });
        if (wanted) chosen.scans.push_back(laser->name);
    }
    if (all) return;
    for (const std::string_view name : names) named(lasers, name, kScanTopicKey, path);
}

}  // namespace

bool is_laser(const Topic& topic) {
    return topic.type == kLaserScanType && is_readable(topic);
}

bool is_odometry(const Topic& topic) {
    return topic.type == kOdometryType && is_readable(topic);
}

bool is_transforms(const Topic& topic) {
    return is_transforms_type(topic.type) && is_readable(topic);
}

RecordingSurvey survey_recording(const std::filesystem::path& path, OpenRecording* open) {
    RecordingSurvey survey;
    Topics topics([](const Topic& topic) {
        return is_laser(topic) || is_odometry(topic) || is_transforms(topic);
    });
    const std::unique_ptr<Recording> recording = open(path, {topics});
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
                told.hold(decode_transforms(found->bytes, encoding));
                survey.frames.complete(told);
                continue;
            }
            // Of the others the first sound message is enough.
            if (is_laser(topic)) {
                survey.laser_frames.emplace(topic.name,
                                            decode_laser_scan(found->bytes, encoding).header.frame);
            } else {
                survey.robot_frames.emplace(topic.name,
                                            decode_odometry(found->bytes, encoding).child_frame);
            }
            topic.wanted = false;
        } catch (const FormatError&) {
            continue;  // counted when it is read in earnest
        }
    }
    survey.topics = topics.all();
    return survey;
}

TourTopics choose_topics(const RecordingSurvey& survey, const ReadOptions& options,
                         const std::filesystem::path& path) {
    TourTopics chosen;
    choose_scans(survey, options, path, chosen);
    const auto laser = survey.laser_frames.find(chosen.scans.front());
    const std::string laser_frame = laser == survey.laser_frames.end() ? "" : laser->second;
    const auto [above, odometry_frame] = survey.frames.robot_above(laser_frame);
    chosen.robot_frame = above;
    chosen.odometry_frame = odometry_frame;

    const std::vector<const Topic*> odometries = with_messages(survey, is_odometry);
    const std::string_view name = input::trimmed(options.odom_topic);
    if (name == "tf" || name == "/tf") {
        if (!odometry_frame.empty()) return chosen;
        throw ConfigError(
            kOdomTopicKey,
            message(HITOS_TEXT("Errors",
                               "found \"%1\", but no transform in %2 leads from a frame "
                               "\"odom\" to the laser's frame \"%3\""),
                    name, path.string(), laser_frame));
    }
    if (name.empty() && odometries.empty()) return chosen;
    if (name.empty() && odometries.size() > 1) {
        throw ConfigError(
            kOdomTopicKey,
            message(HITOS_TEXT("Errors",
                               "found %1 odometry topics in %2: %3; choose one (--odom-topic), or "
                               "\"tf\" for the transforms"),
                    odometries.size(), path.string(), listed(odometries)));
    }
    chosen.odometry =
        (name.empty() ? *odometries.front() : named(odometries, name, kOdomTopicKey, path)).name;
    chosen.odometry_frame.clear();
    const auto robot = survey.robot_frames.find(chosen.odometry);
    // Some drivers leave the name out; then it is what the transforms say.
    if (robot != survey.robot_frames.end() && !robot->second.empty()) {
        chosen.robot_frame = robot->second;
    }
    return chosen;
}

}  // namespace hitos
