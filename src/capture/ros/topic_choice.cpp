// SPDX-License-Identifier: GPL-3.0-or-later
#include "ros/topic_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <tuple>
#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/base/median.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/capture/archivo.hpp"
#include "remedies.hpp"

namespace hitos {
namespace {

/// "/scan (292), /rear (17)": names of topics and how many messages they have; `typed`: and what
/// messages those are.
std::string listed(const std::vector<const Topic*>& topics, bool typed = false) {
    constexpr std::size_t kMost = 20;
    std::string list;
    for (std::size_t i = 0; i < std::min(kMost, topics.size()); ++i) {
        list += (list.empty() ? "" : ", ") + topics[i]->name + " (" +
                (typed && !topics[i]->type.empty() ? topics[i]->type + ", " : "") +
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
    throw ConfigError(key,
                      HITOS_TEXT("Errors", "found \"%1\", expected one of the topics of %2: %3"),
                      name, path.string(), listed(topics));
}

/// What can be done where there are no scans, but what scans can be made of.
Message advice_for(const std::vector<const Topic*>& topics) {
    const auto holds = [&](std::string_view type) {
        return std::ranges::any_of(topics, [&](const Topic* topic) { return topic->type == type; });
    };
    if (holds("sensor_msgs/PointCloud2") || holds("sensor_msgs/PointCloud")) {
        return marked(HITOS_TEXT(
            "Errors",
            "; point clouds can be played into pointcloud_to_laserscan and its scans recorded"));
    }
    if (holds("sensor_msgs/Image")) {
        return marked(HITOS_TEXT(
            "Errors",
            "; depth images can be played into depthimage_to_laserscan and its scans recorded"));
    }
    return {};
}

void choose_scans(const RecordingSurvey& survey, const ReadOptions& options,
                  const std::filesystem::path& path, TourTopics& chosen) {
    const std::vector<const Topic*> lasers = with_messages(survey, is_laser);
    const std::vector<const Topic*> all_topics = with_messages(survey, is_any);
    const std::string list = all_topics.empty() ? "-" : listed(all_topics, true);
    if (lasers.empty() && !survey.first_problem.empty()) {
        throw FormatError(
            path.string(), 0,
            HITOS_TEXT("Errors",
                       "no laser scans (messages sensor_msgs/LaserScan) can be read in it, as some "
                       "of it cannot: %1; the topics that can are: %2"),
            survey.first_problem, list);
    }
    if (lasers.empty()) {
        throw FormatError(
            path.string(), 0,
            HITOS_TEXT(
                "Errors",
                "holds no laser scans (messages sensor_msgs/LaserScan); its topics are: %1%2"),
            list, advice_for(all_topics));
    }
    const std::vector<std::string_view> names = input::listed(options.scan_topic);
    if (names.empty() && lasers.size() > 1) {
        throw ConfigError(kScanTopicKey,
                          HITOS_TEXT("Errors",
                                     "found %1 laser topics in %2: %3; choose one (--scan-topic), "
                                     "several with commas between them, or \"all\""),
                          lasers.size(), path.string(), listed(lasers));
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

/// The topic that tells the odometry of a laser's namespace, the innermost one that has any; empty
/// where none has.
std::string odometry_of(const RecordingSurvey& survey, const std::string& laser) {
    std::string innermost;
    const auto consider = [&](const std::string& topic) {
        const std::string_view space = space_of(topic);
        if (laser.starts_with(space) &&
            (innermost.empty() || space.size() > space_of(innermost).size())) {
            innermost = topic;
        }
    };
    for (const Topic* topic : with_messages(survey, is_odometry)) consider(topic->name);
    for (const auto& [topic, said] : survey.frames) {
        if (!said.frames.below_odometry().empty()) consider(topic);
    }
    return innermost;
}

/// Lasers in two namespaces, each with an odometry of its own, are on two robots, unless one is
/// named that both lie in.
void refuse_two_robots(const RecordingSurvey& survey, const ReadOptions& options,
                       const std::filesystem::path& path, const std::vector<std::string>& lasers) {
    const std::string named_odometry(input::trimmed(options.odom_topic));
    const std::string_view named_space = space_of(named_odometry);
    const bool all_in_named =
        !named_space.empty() && std::ranges::all_of(lasers, [&](const std::string& laser) {
            return laser.starts_with(named_space);
        });
    if (all_in_named) return;
    const std::string& first = lasers.front();
    const std::string own = odometry_of(survey, first);
    for (const std::string& laser : lasers) {
        const std::string other = odometry_of(survey, laser);
        if (own.empty() || other.empty() || space_of(own).starts_with(space_of(other)) ||
            space_of(other).starts_with(space_of(own))) {
            continue;
        }
        throw ConfigError(
            kScanTopicKey,
            HITOS_TEXT("Errors",
                       "found lasers of two robots in %1: %2, whose odometry is in %3, and %4, "
                       "whose is in %5; choose those of one (--scan-topic)"),
            path.string(), first, own, laser, other);
    }
}

/// Where the odometry comes from; of transforms the robot's frame too.
void choose_odometry(const RecordingSurvey& survey, const ReadOptions& options,
                     const std::filesystem::path& path, const std::string& laser_frame,
                     TourTopics& chosen) {
    const std::vector<const Topic*> odometries = with_messages(survey, is_odometry);
    const std::string_view name = input::trimmed(options.odom_topic);
    const auto below = chosen.frames.below_odometry();
    const bool by_name = name == "tf" || name == "/tf";
    if (chosen.odometry_frame.empty() && below.size() == 1 && (by_name || odometries.empty())) {
        // The laser hangs on no robot, but a robot there is.
        chosen.robot_frame = below.front().first;
        chosen.odometry_frame = below.front().second;
    }
    if (by_name) {
        if (!chosen.odometry_frame.empty()) return;
        throw ConfigError(kOdomTopicKey,
                          HITOS_TEXT("Errors",
                                     "found \"%1\", but no transform in %2 leads from a frame "
                                     "\"odom\" to the laser's frame \"%3\""),
                          name, path.string(), laser_frame);
    }
    if (name.empty() && odometries.empty()) return;
    if (name.empty() && odometries.size() > 1) {
        throw ConfigError(kOdomTopicKey,
                          HITOS_TEXT("Errors",
                                     "found %1 odometry topics in %2: %3; choose one "
                                     "(--odom-topic), or \"tf\" for the transforms"),
                          odometries.size(), path.string(), listed(odometries));
    }
    const Topic& topic =
        name.empty() ? *odometries.front() : named(odometries, name, kOdomTopicKey, path);
    const auto robot = survey.robot_frames.find(topic.name);
    if (name.empty() && robot == survey.robot_frames.end() && !chosen.odometry_frame.empty()) {
        chosen.findings.push_back(
            {TourFinding::Kind::unread_odometry,
             static_cast<double>(topic.messages),
             message(HITOS_TEXT("Errors",
                                "no message of the odometry %1 can be read, so that the transforms "
                                "to \"%2\" are taken"),
                     topic.name, chosen.odometry_frame),
             {{message(HITOS_TEXT("Errors", "--odom-topic %1 says what is wrong with them"),
                       topic.name)}}});
        return;
    }
    chosen.odometry = topic.name;
    chosen.odometry_frame.clear();
    // Some drivers leave the name out; then it is what the transforms say.
    if (robot != survey.robot_frames.end() && !robot->second.empty()) {
        chosen.robot_frame = robot->second;
    }
}

/// Whether stamps of the scans are of another clock than those of the odometry.
void doubt_stamps(const RecordingSurvey& survey, const ReadOptions& read, TourTopics& chosen) {
    constexpr double kLeast = 1.0;                         // networks hold messages up that long
    if (!input::trimmed(read.scan_clock).empty()) return;  // somebody has looked at them
    const auto scan_receipts = survey.receipts.find(chosen.scans.front());
    const auto odometry_receipts = survey.receipts.find(chosen.odometry);
    if (scan_receipts == survey.receipts.end() || odometry_receipts == survey.receipts.end())
        return;
    // Clocks may be set while they are recorded: only what was received at one time is compared.
    const auto& a = scan_receipts->second;
    const auto& b = odometry_receipts->second;
    const auto received = [](const RecordingSurvey::Receipt& one) { return one.received_ns; };
    const std::int64_t begin = std::max(a.front().received_ns, b.front().received_ns);
    const std::int64_t end = std::min(std::ranges::max(a, {}, received).received_ns,
                                      std::ranges::max(b, {}, received).received_ns);
    const auto lag_of = [&](const std::vector<RecordingSurvey::Receipt>& receipts) {
        std::vector<double> lags;
        for (const auto& one : receipts) {
            if (one.received_ns >= begin && one.received_ns <= end) lags.push_back(one.lag_s);
        }
        return lags.empty() ? std::optional<double>{} : median(std::move(lags));
    };
    const std::optional<double> scans = lag_of(a);
    const std::optional<double> odometry = lag_of(b);
    if (!scans || !odometry) return;
    const double late_s = *scans - *odometry - read.scan_delay_s;
    if (std::abs(late_s) < kLeast) return;
    chosen.findings.push_back(
        {TourFinding::Kind::late_stamps,
         late_s,
         message(HITOS_TEXT("Errors",
                            "%1 was received %2 s after its stamps and %3 %4 s after its own: the "
                            "clocks of their computers differ"),
                 chosen.scans.front(), fmt::format("{:.2f}", *scans), chosen.odometry,
                 fmt::format("{:.2f}", *odometry)),
         {added_difference(WholeValues(read).later_by(late_s))},
         late_s});
}

using UsedFrames = std::set<std::pair<std::string, std::string>>;  // topic and frame

/// Whether what the transforms say is known, and from one sender.
void doubt_frames(const RecordingSurvey& survey, const ReadOptions& options,
                  const std::string& laser_frame, const UsedFrames& used, TourTopics& chosen) {
    if (chosen.frames.empty() && options.laser_pose.empty() && laser_frame != chosen.robot_frame) {
        chosen.findings.push_back(
            {TourFinding::Kind::assumed_mounting,
             static_cast<double>(chosen.scans.size()),
             message(HITOS_TEXT("Errors",
                                "no transform says where the laser \"%1\" sits on the robot "
                                "\"%2\"; it is taken to sit in its origin and look ahead, and "
                                "where it does not, the map is bent where the robot turns"),
                     laser_frame, chosen.robot_frame),
             {{marked(HITOS_TEXT("Errors", "say where it sits: --laser-pose x,y,degrees"))}}});
    }
    const std::string& laser = chosen.scans.front();
    const FrameChoice& own = chosen.of_laser.at(laser);
    if (own.of_others && !used.empty() && space_of(laser).size() > 1) {
        std::string topics;
        for (const std::string& topic : own.topics) topics += (topics.empty() ? "" : ", ") + topic;
        chosen.findings.push_back(
            {TourFinding::Kind::assumed_mounting,
             static_cast<double>(chosen.scans.size()),
             message(HITOS_TEXT(
                         "Errors",
                         "no transforms are of the namespace of %1, so that those of %2 are taken; "
                         "where that is another robot, the laser sits wrongly, and drives its way"),
                     laser, topics),
             {{marked(HITOS_TEXT("Errors",
                                 "say where it sits (--laser-pose x,y,degrees) and take a topic "
                                 "for the odometry (--odom-topic)"))}}});
    }
    for (const auto& [topic, frame] : used) {
        const std::uint64_t returns = survey.frames.at(topic).publishers.returns(frame);
        if (returns == 0) continue;
        chosen.findings.push_back(
            {TourFinding::Kind::two_publishers,
             static_cast<double>(returns),
             message(HITOS_TEXT("Errors",
                                "the frame \"%1\" goes to and fro between two places in %2, %3 "
                                "times: two programs say where it is"),
                     frame, topic, returns),
             {{marked(HITOS_TEXT("Errors",
                                 "take a topic for the odometry (--odom-topic), or say where the "
                                 "laser sits (--laser-pose), or record with one of them only"))}}});
    }
}

/// What of a laser's transforms matters: its place on the robot, and the robot's path.
std::vector<std::string> used_frames(const FrameChoice& choice, const ReadOptions& options,
                                     const std::string& laser_frame, const TourTopics& chosen) {
    std::vector<std::string> used;
    if (options.laser_pose.empty()) used = choice.frames.above(laser_frame, chosen.robot_frame);
    if (!chosen.odometry_frame.empty()) {
        std::ranges::move(choice.frames.above(chosen.robot_frame, chosen.odometry_frame),
                          std::back_inserter(used));
    }
    return used;
}

}  // namespace

TourTopics choose_topics(const RecordingSurvey& survey, const ReadOptions& options,
                         const std::filesystem::path& path) {
    TourTopics chosen;
    choose_scans(survey, options, path, chosen);
    refuse_two_robots(survey, options, path, chosen.scans);
    const auto frame_of = [&](const std::string& laser) {
        const auto found = survey.laser_frames.find(laser);
        return found == survey.laser_frames.end() ? std::string{} : found->second;
    };
    std::set<std::string> transforms;
    std::vector<std::string> lasers;
    for (const Topic* laser : with_messages(survey, is_laser)) lasers.push_back(laser->name);
    for (const std::string& laser : chosen.scans) {
        FrameChoice own = choose_frames(survey.frames, laser, lasers, options.same_frames);
        transforms.insert(own.topics.begin(), own.topics.end());
        chosen.of_laser.emplace(laser, std::move(own));
    }
    chosen.transforms.assign(transforms.begin(), transforms.end());
    chosen.frames = chosen.of_laser.at(chosen.scans.front()).frames;
    const std::string laser_frame = frame_of(chosen.scans.front());
    std::tie(chosen.robot_frame, chosen.odometry_frame) = chosen.frames.robot_above(laser_frame);
    choose_odometry(survey, options, path, laser_frame, chosen);
    UsedFrames used;
    for (const auto& [laser, own] : chosen.of_laser) {
        const std::vector<std::string> frames = used_frames(own, options, frame_of(laser), chosen);
        check_agreement(survey.frames, own, frames, path.string());
        for (const std::string& topic : own.topics) {
            for (const std::string& frame : frames) used.emplace(topic, frame);
        }
    }
    if (!options.laser_pose.empty() && chosen.scans.size() > 1) {
        throw ConfigError(
            kLaserPoseKey,
            HITOS_TEXT("Errors",
                       "found one place for %1 lasers; choose one of them (--scan-topic)"),
            chosen.scans.size());
    }
    doubt_stamps(survey, options, chosen);
    doubt_frames(survey, options, laser_frame, used, chosen);
    return chosen;
}

}  // namespace hitos
