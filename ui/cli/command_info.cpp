// SPDX-License-Identifier: GPL-3.0-or-later
// hitos-cli info and check: what a log, a recording or a world holds, as the window's source dialog
// says it, and what of it looks wrong.

#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <string>

#include "commands.hpp"
#include "damage.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/plural.hpp"
#include "hitos/base/process.hpp"
#include "hitos/capture/log_format.hpp"
#include "hitos/services/results/results.hpp"
#include "hitos/workbench/benchmark.hpp"
#include "hitos/workbench/open_tour.hpp"
#include "hitos/workbench/shipped_data.hpp"
#include "hitos/workbench/source_inspection.hpp"
#include "options.hpp"
#include "progress_line.hpp"
#include "report.hpp"

namespace hitos::cli {
namespace {

struct InfoOptions {
    ConfigurationOptions configuration;
    std::string log;
    SourceOptions source;
    bool json = false;
};

double per_second(std::uint64_t count, double seconds) {
    return seconds > 0.0 ? static_cast<double>(count) / seconds : 0.0;
}

void tell_laser(const Fan& fan, Report& report) {
    if (fan.count == 0) {
        report.say("laser: the log gives points, not rays\n");
        return;
    }
    report.say("laser: {} rays from {:.2f} to {:.2f} degrees", fan.count,
               fan.min_angle_rad * kDegreesPerRadian, fan.max_angle_rad * kDegreesPerRadian);
    if (fan.max_range_m > 0.0) report.say(", up to {:g} m", fan.max_range_m);
    const Pose& mounting = fan.pose_robot_laser;
    report.say("; on the robot at ({:.3f}, {:.3f}) m, {:.2f} degrees\n", mounting.x, mounting.y,
               mounting.theta * kDegreesPerRadian);
    report.object()["laser"] = {{"rays", fan.count},
                                {"first_angle_rad", fan.min_angle_rad},
                                {"last_angle_rad", fan.max_angle_rad},
                                {"max_range_m", fan.max_range_m},
                                {"pose_robot_laser", {mounting.x, mounting.y, mounting.theta}}};
}

void tell_landmarks(const TourSummary& tour, Report& report) {
    if (tour.sightings == 0) return;
    report.say("landmarks: {} sightings, of {} with a name, and {} without\n", tour.sightings,
               tour.identities.size(), tour.nameless);
    report.object()["landmarks"] = {{"sightings", tour.sightings},
                                    {"identities", tour.identities.size()},
                                    {"nameless", tour.nameless}};
}

void tell_first_lines(const SourceInspection& found, Report& report) {
    report.say("{}:\n", found.topics.empty() ? "it begins with" : "its topics and their messages");
    report.object()["first_lines"] = nlohmann::ordered_json::array();
    for (const Message& line : found.first_lines) {
        report.say("  {}\n", line.english());
        report.object()["first_lines"].push_back(line.english());
    }
    if (found.topics.empty()) return;
    report.object()["topics"] = nlohmann::ordered_json::array();
    for (const RecordedTopic& topic : found.topics) {
        report.object()["topics"].push_back(
            {{"name", topic.name}, {"type", topic.type}, {"messages", topic.messages}});
    }
}

/// As plans of benchmarks name it; what comes through a pipe is gone.
void tell_digest(const std::string& source, Report& report) {
    std::error_code ignored;
    const auto type = std::filesystem::status(source, ignored).type();
    if (type != std::filesystem::file_type::regular &&
        type != std::filesystem::file_type::directory) {
        return;
    }
    const std::string digest = digest_of_tour(source);
    report.say("digest: {}\n", digest);
    report.object()["digest"] = digest;
}

/// Of a recording whose topics are still to be chosen.
void tell_choice(const std::string& source, const SourceInspection& found, Report& report) {
    report.say("{}: {}\n", on_one_line(source), found.tour.format);
    report.warn(found.choice.english());
    report.object() = {
        {"source", source}, {"format", found.tour.format}, {"choice", found.choice.english()}};
    tell_digest(source, report);
    tell_first_lines(found, report);
}

/// As of a run's results.
std::string scans_words(const TourSummary& tour) {
    std::string words = plural(tour.report.scans, "scan");
    if (tour.scans_of_map == 0) return words;
    return fmt::format("{}, {} of them the map's", words, tour.scans_of_map);
}

void tell(const std::string& source, const SourceInspection& found, Report& report) {
    const TourSummary& tour = found.tour;
    const double scan_rate = per_second(tour.report.scans, tour.duration_s);
    const double odometry_rate = per_second(tour.report.odometry, tour.duration_s);
    report.say("{}: {}\n", on_one_line(source), tour.format);
    report.say("{} ({:.1f}/s), {} ({:.1f}/s)\n", scans_words(tour), scan_rate,
               plural(tour.report.odometry, "odometry reading"), odometry_rate);
    report.say("{:.1f} s from {:.6f} s on, {:.1f} m by the odometry\n", tour.duration_s,
               tour.first_stamp_s, tour.distance_m);
    report.object() = {{"source", source},
                       {"format", tour.format},
                       {"scans", tour.report.scans},
                       {"scans_per_second", scan_rate},
                       {"odometry_per_second", odometry_rate},
                       {"first_stamp_s", tour.first_stamp_s},
                       {"duration_s", tour.duration_s},
                       {"odometry_distance_m", tour.distance_m}};
    if (tour.points > 0 || tour.sightings == 0) tell_laser(tour.fan, report);
    tell_landmarks(tour, report);
    report.say("{}", damage_text(tour.report));
    if (tour.report.scans == 0) report.warn("not one scan that can be read");
    report.object()["log"] = parsed_object(to_json(tour.report));
    tell_digest(source, report);
    tell_first_lines(found, report);
}

/// Returns how many findings there are.
std::size_t tell_findings(const TourSummary& tour, Report& report) {
    for (const TourFinding& finding : tour.findings) report.warn(sentence_of(finding).english());
    report.object()["findings"] = parsed_object(to_json(tour.findings));
    return tour.findings.size();
}

SourceInspection inspected(const InfoOptions& options, const std::string& source) {
    expect_used(options.configuration.values, options.source.topics, {source});
    Configuracion configuration = load(options.configuration, {});  // no preset is about the source
    configuration.source.file = source;
    options.source.choose(configuration.source);
    ProgressLine line("part");
    return inspect_source(configuration.source, [&line](double fraction) {
        constexpr double kParts = 100.0;
        line.show(static_cast<std::uint64_t>(fraction * kParts), fraction);
        return true;
    });
}

void info(const InfoOptions& options) {
    const std::string source = source_named(input_named(options.log, "log"));
    const SourceInspection found = inspected(options, source);
    Report report(options.json);
    found.choice.empty() ? tell(source, found, report) : tell_choice(source, found, report);
    tell_findings(found.tour, report);
    report.end();
}

/// Leaves with 1 where there is something to doubt, or damage.
void check_source(const InfoOptions& options) {
    const std::string source = source_named(input_named(options.log, "log"));
    const SourceInspection found = inspected(options, source);
    if (!found.choice.empty()) throw ConfigError("log", found.choice);
    Report report(options.json);
    report.say("{}: {}, {}, {}\n", on_one_line(source), found.tour.format, scans_words(found.tour),
               plural(found.tour.report.odometry, "odometry reading"));
    report.say("{}", damage_text(found.tour.report));
    report.object() = {{"source", source},
                       {"format", found.tour.format},
                       {"scans", found.tour.report.scans},
                       {"log", parsed_object(to_json(found.tour.report))}};
    if (found.tour.report.scans == 0) report.warn("not one scan that can be read");
    const ReadReport& read = found.tour.report;
    const bool damaged = read.skipped > 0 || read.stamps_backwards > 0;
    const bool doubtful = tell_findings(found.tour, report) > 0 || read.scans == 0;
    if (!doubtful) report.say("nothing {}looks wrong in it\n", damaged ? "else " : "");
    report.end();
    if (doubtful || damaged) throw CLI::RuntimeError(1);
}

CLI::App* add_inspection(CLI::App& program, const std::string& name, const std::string& purpose,
                         InfoOptions& options) {
    CLI::App* command = program.add_subcommand(name, purpose);
    command
        ->add_option("log", options.log,
                     "Log file, plain or .gz, ROS recording, world file or the name of a world; - "
                     "for standard input")
        ->required();
    add_source_options(*command, options.source);
    add_configuration_options(*command, options.configuration);
    add_report_option(*command, options.json);
    return command;
}

}  // namespace

void add_info(CLI::App& program) {
    auto options = std::make_shared<InfoOptions>();
    add_inspection(program, "info",
                   "Say what a log, a recording or a world holds, and what of it is damaged",
                   *options)
        ->callback([options] { info(*options); });
}

void add_check(CLI::App& program) {
    auto options = std::make_shared<InfoOptions>();
    add_inspection(program, "check",
                   "Doubt a log, a recording or a world: clocks, mounting, units; status 1 where "
                   "something looks wrong",
                   *options)
        ->callback([options] { check_source(*options); });
}

}  // namespace hitos::cli
