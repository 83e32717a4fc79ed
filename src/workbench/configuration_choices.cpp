// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/workbench/configuration_choices.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <span>
#include <string>
#include <system_error>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/capture/archivo.hpp"
#include "hitos/capture/scan_clock.hpp"
#include "hitos/registration/graph_edit.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/slam/filters.hpp"
#include "hitos/workbench/open_tour.hpp"

namespace hitos {
namespace {

/// The map is made of its run's own changes too. Those of a file come first, numbered as they are
/// there, and take the place of what they contradict.
void add_those_of_map(Configuracion& configuration) {
    if (configuration.source.map.empty()) return;
    std::vector<GraphEdit> all = parse_graph_edits(configuration.registration.edits);
    const std::string of_map = configuration_to_go_on(configuration.source.map).registration.edits;
    const std::size_t of_file = all.size();
    for (const GraphEdit& edit : parse_graph_edits(of_map)) {
        const auto other = [&](const GraphEdit& one) { return contradict(one, edit); };
        if (std::ranges::none_of(std::span(all).first(of_file), other)) all.push_back(edit);
    }
    configuration.registration.edits = text_of(all);
}

/// Also of one that cannot be read, as whoever opens it is told.
bool may_be_recording(const std::string& file) {
    if (is_world_file(file)) return false;
    try {
        return recording_format(file) != nullptr;
    } catch (const Error&) {
        return true;
    }
}

}  // namespace

void choose_values(Configuracion& configuration, const ValueChoices& choices) {
    for (const std::string& assignment : choices.assignments) {
        set_parameter(configuration, assignment);
    }
    const bool sets_edits = std::ranges::any_of(
        choices.assignments,
        [](const std::string& assignment) { return assignment.starts_with(kGraphEditsKey); });
    if (!choices.edits.empty()) {
        if (sets_edits) {
            throw ConfigError("--edits",
                              HITOS_TEXT("Errors",
                                         "--set %1 names other changes; give one of "
                                         "them"),
                              kGraphEditsKey);
        }
        configuration.registration.edits = ArchivoConfiguracion::read_edits(choices.edits);
    }
    if (!choices.map.empty()) {
        configuration.source.map =
            std::filesystem::absolute(choices.map).lexically_normal().string();
    }
    if (!choices.edits.empty()) add_those_of_map(configuration);
    for (const std::string& assignment : choices.world_assignments) {
        std::string& changes = configuration.source.world_set;
        if (!changes.empty()) changes += ' ';
        changes += assignment;
    }
    if (!choices.near.empty()) configuration.source.start = choices.near;
    if (choices.localise) configuration.source.hold = true;
    if (choices.tour_seed) {
        find_parameter("source.tour_seed").set(configuration, std::to_string(*choices.tour_seed));
    }
    if (choices.seed) {
        find_parameter("run.seed").set(configuration, std::to_string(*choices.seed));
    }
    if (choices.threads) {
        find_parameter("run.threads").set(configuration, std::to_string(*choices.threads));
    }
    check(configuration);
    // The same changes leave the same configuration, whoever names them.
    if (sets_edits || !choices.edits.empty())
        configuration.registration.edits =
            text_of(parse_graph_edits(configuration.registration.edits));
    if (!choices.edits.empty() && !needs_registration(configuration.filter)) {
        throw ConfigError("--edits",
                          HITOS_TEXT("Errors",
                                     "changes by hand are of the graph of key scans, and with "
                                     "these parameters there is none; try --preset recorded"));
    }
}

void take_up(const std::vector<SourceSetting>& settings, SourceParams& source) {
    Configuracion configuration;
    configuration.source = source;
    for (const auto& [key, value] : settings) find_parameter(key).set(configuration, value);
    source = configuration.source;
}

void TopicChoices::choose(SourceParams& source) const {
    if (!scan_topic.empty()) source.read.scan_topic = scan_topic;
    if (!odom_topic.empty()) source.read.odom_topic = odom_topic;
    if (!same_frames.empty()) source.read.same_frames = same_frames;
    if (!laser_pose.empty()) source.read.laser_pose = laser_pose;
    if (scan_delay.empty()) return;
    const bool of_clock = scan_delay.find('@') != std::string::npos;
    constexpr double kGreatest = 1e10;
    const std::optional<double> number = input::parse_number(scan_delay);
    if (of_clock) {
        static_cast<void>(ScanClock(scan_delay));  // throws
    } else if (!number || !(std::abs(*number) <= kGreatest)) {
        throw ConfigError("--scan-delay",
                          HITOS_TEXT("Errors",
                                     "found \"%1\", expected seconds, or seconds@second of the "
                                     "tour as in 0@0,-1.39@680, as check advises"),
                          scan_delay);
    }
    source.read.scan_delay_s = of_clock ? 0.0 : *number;
    source.read.scan_clock = of_clock ? scan_delay : "";
}

void expect_used(const ValueChoices& values, const TopicChoices& topics,
                 const std::vector<std::string>& sources) {
    const bool of_topics =
        !topics.scan_topic.empty() || !topics.odom_topic.empty() || !topics.same_frames.empty();
    if (!of_topics && values.world_assignments.empty() && !values.tour_seed) return;
    bool recording = false;
    bool world = false;
    for (const std::string& file : sources) {
        std::error_code ignored;
        const bool there = std::filesystem::exists(file, ignored);
        recording = recording || !there || may_be_recording(file);
        world = world || !there || is_world_file(file);
    }
    const std::string& first = sources.front();
    const auto expect = [](bool used, const char* option, bool given, const Message& problem) {
        if (given && !used) throw ConfigError(option, problem);
    };
    const Message of_recordings =
        message(HITOS_TEXT("Errors", "is of ROS recordings, and %1 is none; leave it out"), first);
    const Message of_worlds = message(
        HITOS_TEXT("Errors", "is of worlds, which are simulated, and %1 is none; leave it out"),
        first);
    expect(recording, "--scan-topic", !topics.scan_topic.empty(), of_recordings);
    expect(recording, "--odom-topic", !topics.odom_topic.empty(), of_recordings);
    expect(recording, "--same-frames", !topics.same_frames.empty(), of_recordings);
    expect(world, "--world-set", !values.world_assignments.empty(), of_worlds);
    expect(world, "--tour-seed", values.tour_seed.has_value(), of_worlds);
}

std::string complaint_of_seed(const std::string& text) {
    return text.starts_with('-') ? "found " + text + ", expected a whole number from 0 on" : "";
}

}  // namespace hitos
