// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameter_table.hpp"

#include <algorithm>
#include <iterator>

#include "grid/grid_parameters.hpp"
#include "hitos/base/error.hpp"
#include "hitos/capture/log_format.hpp"
#include "hitos/features/extraction_parameters.hpp"
#include "hitos/features/line_methods.hpp"
#include "hitos/registration/registration_parameters.hpp"
#include "hitos/slam/filter_parameters.hpp"
#include "hitos/slam/filters.hpp"
#include "hitos/slam/proposal.hpp"
#include "hitos/slam/resampler.hpp"
#include "hitos/slam/robot.hpp"

namespace hitos {
namespace {

using namespace declare;
using Config = Configuracion;
using Table = std::vector<ConfigParameter>;

std::vector<ParameterChoice> format_choices() {
    std::vector<ParameterChoice> choices = declare::choices_of(log_formats());
    choices.insert(choices.begin(),
                   {std::string(kAutoFormat), HITOS_TEXT("ParameterChoice", "Automatic")});
    return choices;
}

ConfigParameter& at(Table& table, std::string_view key) {
    return *std::ranges::find(table, key, &ConfigParameter::key);
}

ConfigParameter::Condition of_world() {
    return {"source.file", "a world (.toml)",
            [](const Config& configuration) { return is_world_file(configuration.source.file); }};
}

ConfigParameter::Condition of_log() {
    return {"source.file", "a log or ROS recording, no world",
            [](const Config& configuration) { return !is_world_file(configuration.source.file); }};
}

ConfigParameter::Condition with_map() {
    return {"source.map", "the results of a run",
            [](const Config& configuration) { return !configuration.source.map.empty(); }};
}

/// What of a log is wrong or not said, and is put right.
Table mended_source_entries() {
    return {
        text<&Config::source, &SourceParams::read, &ReadOptions::laser_pose>(
            {"source.laser_pose", HITOS_TEXT("ParameterLabel", "Laser's place"),
             HITOS_TEXT("Parameter",
                        "Where the laser sits on the robot, whatever the log says: x,y,degrees "
                        "(metres ahead, metres to the left, turn to the left), with ,upside-down "
                        "behind it where it does; empty takes what the log says.")},
            {of_log()}),
        text<&Config::source, &SourceParams::read, &ReadOptions::same_frames>(
            {"source.same_frames", HITOS_TEXT("ParameterLabel", "Frames that are one"),
             HITOS_TEXT("Parameter",
                        "Frames of a ROS recording that are one under two names, as "
                        "base_footprint=base_link; several with commas between them.")},
            {of_log()}),
        real<&Config::source, &SourceParams::read, &ReadOptions::min_range_m>(
            {"source.min_range", "m", 0, 1000, HITOS_TEXT("ParameterLabel", "Minimum range"),
             HITOS_TEXT("Parameter",
                        "Nearer readings are no points, so a higher value leaves out more of what "
                        "may be the robot itself.")}),
        real<&Config::source, &SourceParams::read, &ReadOptions::ray_time_s>(
            {"source.ray_time", "s", -1, 1, HITOS_TEXT("ParameterLabel", "Time of a ray"),
             HITOS_TEXT(
                 "Parameter",
                 "Time from one ray of a scan to the next, by which rays are moved as the robot "
                 "drives on; a higher value moves them further; 0 takes what the log says.")},
            {of_log()}),
        real<&Config::source, &SourceParams::read, &ReadOptions::range_scale>(
            {"source.range_scale", "", 1e-6, 1e6, HITOS_TEXT("ParameterLabel", "Range scale"),
             HITOS_TEXT("Parameter",
                        "The laser's readings, and the greatest range that the log says, are taken "
                        "that many times as long, as 0.001 where they are millimetres; a higher "
                        "value lengthens them.")},
            {of_log()}),
        real<&Config::source, &SourceParams::read, &ReadOptions::range_offset_m>(
            {"source.range_offset", "m", -100, 100, HITOS_TEXT("ParameterLabel", "Range offset"),
             HITOS_TEXT("Parameter",
                        "Added to each of the laser's readings, where all of them are too short or "
                        "too long by that; a higher value puts walls further away. Logs of points "
                        "have none.")},
            {of_log()}),
        real<&Config::source, &SourceParams::read, &ReadOptions::fan_scale>(
            {"source.fan_scale", "", 1e-3, 1e3, HITOS_TEXT("ParameterLabel", "Fan scale"),
             HITOS_TEXT("Parameter",
                        "The angles of a scan's rays, from where the laser looks, are taken that "
                        "many times as wide, as 0.0174533 where they are in degrees; a higher "
                        "value widens them. Logs of points have none.")},
            {of_log()}),
        real<&Config::source, &SourceParams::read, &ReadOptions::odometry_scale>(
            {"source.odometry_scale", "", 1e-6, 1e6, HITOS_TEXT("ParameterLabel", "Odometry scale"),
             HITOS_TEXT("Parameter",
                        "The odometry's way is taken that many times as long; a higher value "
                        "lengthens it.")}),
        real<&Config::source, &SourceParams::read, &ReadOptions::odometry_turns>(
            {"source.odometry_turns", "", -1e4, 1e4, HITOS_TEXT("ParameterLabel", "Scale of turns"),
             HITOS_TEXT("Parameter",
                        "The odometry's turns are taken that many times as wide; a higher value "
                        "widens them, a negative one turns right what it says is left.")}),
        text<&Config::source, &SourceParams::read, &ReadOptions::odometry_axes>(
            {"source.odometry_axes", HITOS_TEXT("ParameterLabel", "Axes of the odometry"),
             HITOS_TEXT("Parameter",
                        "What logged poses have in the place of x, y and heading: axes in another "
                        "order or negative, and theta or, in degrees, degrees, with an angle that "
                        "is added, as in y,x,theta or x,y,90-theta; empty takes x,y,theta.")},
            {of_log()}),
        choice<&Config::source, &SourceParams::read, &ReadOptions::mend>(
            {"source.mend", HITOS_TEXT("ParameterLabel", "Mend"),
             HITOS_TEXT("Parameter",
                        "Whether what is known to be wrong is mended: rays that were measured one "
                        "after the other are moved by the odometry to one time (rays); besides, "
                        "leaps of the odometry that no robot makes are bridged, stamps of too few "
                        "digits give way to the logger's times, and where there is no odometry the "
                        "scans say how the robot moved (on).")},
            {{"off", HITOS_TEXT("ParameterChoice", "Off")},
             {"rays", HITOS_TEXT("ParameterChoice", "Rays only")},
             {"on", HITOS_TEXT("ParameterChoice", "On")}}),
    };
}

Table source_entries() {
    return {
        text<&Config::source, &SourceParams::file>(
            {"source.file", HITOS_TEXT("ParameterLabel", "Log"),
             HITOS_TEXT("Parameter",
                        "Path of the log or ROS recording to read; empty where none is chosen."),
             "source"}),
        choice<&Config::source, &SourceParams::format>(
            {"source.format", HITOS_TEXT("ParameterLabel", "Format"),
             HITOS_TEXT("Parameter", "Format of the log; auto finds it from its beginning."),
             "source"},
            format_choices()),
        real<&Config::source, &SourceParams::read, &ReadOptions::max_range_m>(
            {"source.max_range", "m", 0, 1000, HITOS_TEXT("ParameterLabel", "Maximum range"),
             HITOS_TEXT("Parameter",
                        "Readings at or beyond this range are no points, so a higher value keeps "
                        "more far readings; 0 takes what the log says.")}),
        choice<&Config::source, &SourceParams::read, &ReadOptions::odometry>(
            {"source.odometry", HITOS_TEXT("ParameterLabel", "Odometry from"),
             HITOS_TEXT(
                 "Parameter",
                 "Whether controls come from the differences of the logged poses, are the logged v "
                 "and omega, or come from the scans alone, as where a log has no odometry."),
             "source"},
            {{"poses", HITOS_TEXT("ParameterChoice", "Logged poses")},
             {"velocities", HITOS_TEXT("ParameterChoice", "Logged velocities")},
             {"scans", HITOS_TEXT("ParameterChoice", "Scans")}}),
        text<&Config::source, &SourceParams::read, &ReadOptions::scan_topic>(
            {"source.scan_topic", HITOS_TEXT("ParameterLabel", "Laser topic"),
             HITOS_TEXT("Parameter",
                        "Topic of the laser in a ROS recording with several: one, some with commas "
                        "between them, or all. Lasers that see from one place become one; empty "
                        "takes the only one.")},
            {of_log()}),
        text<&Config::source, &SourceParams::read, &ReadOptions::odom_topic>(
            {"source.odom_topic", HITOS_TEXT("ParameterLabel", "Odometry topic"),
             HITOS_TEXT("Parameter",
                        "Topic of the odometry in a ROS recording with several, or tf for its "
                        "transforms; empty takes the only one, else the transforms.")},
            {of_log()}),
        choice<&Config::source, &SourceParams::read, &ReadOptions::leave_out_early_scans>(
            {"source.early_scans", HITOS_TEXT("ParameterLabel", "Scans before the odometry"),
             HITOS_TEXT("Parameter",
                        "What becomes of scans before the first odometry reading: they are used as "
                        "if the robot had stood still until then, or left out. Both are counted.")},
            {{"keep", HITOS_TEXT("ParameterChoice", "Keep, robot at rest")},
             {"leave_out", HITOS_TEXT("ParameterChoice", "Leave out")}}),
        real<&Config::source, &SourceParams::read, &ReadOptions::scan_delay_s>(
            {"source.scan_delay", "s", -1e10, 1e10, HITOS_TEXT("ParameterLabel", "Scan delay"),
             HITOS_TEXT("Parameter",
                        "Added to the times of the scans, where the laser's clock is not the "
                        "odometry's; hitos-cli check says by how much they differ. A higher value "
                        "pairs scans with later odometry.")}),
        text<&Config::source, &SourceParams::read, &ReadOptions::scan_clock>(
            {"source.scan_clock", HITOS_TEXT("ParameterLabel", "Clock of the scans"),
             HITOS_TEXT("Parameter",
                        "Added to the scans' times besides, where the laser's clock runs at "
                        "another speed or was set: seconds@second of the tour, as in "
                        "0@0,-1.39@680, evenly in between; two points of one second are a leap; "
                        "empty adds nothing.")},
            {of_log()}),
        integer<&Config::source, &SourceParams::read, &ReadOptions::opening_bytes>(
            {"source.opening", "B", 0, 0x1p63, HITOS_TEXT("ParameterLabel", "Opening"),
             HITOS_TEXT("Parameter",
                        "Of a log that came in live: by how many of its first bytes was decided "
                        "what has to be before the first scan, and its messages are taken as they "
                        "were received; so it gives what the live run gave. 0: by all of it, in "
                        "the order of its stamps.")},
            {of_log()}),
    };
}

/// What of a world is run as another.
Table world_source_entries() {
    return {
        integer<&Config::source, &SourceParams::tour_seed>(
            {"source.tour_seed", "", 0, 0x1p63, HITOS_TEXT("ParameterLabel", "Tour seed"),
             HITOS_TEXT(
                 "Parameter",
                 "Seed of the noise of a world's laser and odometry, so that runs with other seeds "
                 "drive the same tour; 0 takes what the world says, else the run's seed.")},
            {of_world()}),
        text<&Config::source, &SourceParams::map>(
            {"source.map", HITOS_TEXT("ParameterLabel", "Map to go on with"),
             HITOS_TEXT("Parameter",
                        "Folder with the results of a run, whose tour comes before this one: the "
                        "robot, which may begin anywhere in that map, is found in it, and the map "
                        "goes on; empty begins a new one.")}),
        choice<&Config::source, &SourceParams::hold>(
            {"source.hold", HITOS_TEXT("ParameterLabel", "Hold the map"),
             HITOS_TEXT("Parameter",
                        "Whether the map of the tour before (source.map) stays as it is: the robot "
                        "is found in it and followed, and nothing is added.")},
            off_on(), {with_map()}),
        text<&Config::source, &SourceParams::start>(
            {"source.start", HITOS_TEXT("ParameterLabel", "Start in the map"),
             HITOS_TEXT("Parameter",
                        "Where in the map of the tour before (source.map) this one begins, as "
                        "x,y,degrees, give or take 3 m and 30 degrees, where places look alike; "
                        "empty looks for it everywhere.")},
            {with_map()}),
        text<&Config::source, &SourceParams::world_set>(
            {"source.world_set", HITOS_TEXT("ParameterLabel", "World values"),
             HITOS_TEXT(
                 "Parameter",
                 "Changes of a world's values, with spaces between them, e.g. laser.sigma=0.003 "
                 "tour.laps=2; hitos-cli simulate --help lists the keys.")},
            {of_world()}),
    };
}

Table run_entries() {
    return {
        integer<&Config::run, &RunParams::seed>(
            {"run.seed", "", 0, 0x1p63, HITOS_TEXT("ParameterLabel", "Seed"),
             HITOS_TEXT("Parameter",
                        "Seed of all random numbers; the same seed gives the same result to the "
                        "last bit."),
             "filter"}),
        integer<&Config::run, &RunParams::threads>(
            {"run.threads", "", 0, 256, HITOS_TEXT("ParameterLabel", "Threads"),
             HITOS_TEXT("Parameter",
                        "Number of threads, which changes the time and never the result; 0 uses as "
                        "many as the machine has.")}),
    };
}

template <class Part>
void add_lifted(Table& table, std::span<const Parameter<Part>> parameters, Part Config::*part) {
    for (const Parameter<Part>& parameter : parameters) table.push_back(lifted(parameter, part));
}

/// Where a parameter of one layer decides about those of another.
void join_layers(Table& table) {
    for (const char* key : {"observation.var_rho", "observation.var_theta"}) {
        at(table, key).conditions.push_back(where(at(table, "observation.covariance"), {"fixed"}));
    }
    for (ConfigParameter& parameter : table) {
        if (parameter.table() != "registration") continue;
        parameter.conditions.insert(
            parameter.conditions.begin(),
            {"motion.model", "registered, or filter.algorithm is graph-slam",
             [](const Config& c) { return needs_registration(c.filter); }});
    }
}

/// What an entry says it reads must be there: a misspelt key would never turn grey.
template <class Entry>
void require_known(const Table& table, const Registry<Entry>& registry) {
    for (const Entry& entry : registry.entries()) {
        for (const std::string& key : entry.reads) {
            if (look_up(std::span<const ConfigParameter>(table), key) != nullptr) continue;
            throw ConfigError(
                entry.word,
                HITOS_TEXT("Errors", "says that it reads %1, but there is no such parameter"), key);
        }
    }
}

/// The place of the table of a file among those of all groups.
std::size_t rank(std::string_view table) {
    const std::vector<std::string_view>& group = group_of(table).tables;
    std::size_t place = static_cast<std::size_t>(std::ranges::find(group, table) - group.begin());
    for (const ParameterGroupFacts& before : parameter_groups()) {
        if (&before == &group_of(table)) break;
        place += before.tables.size();
    }
    return place;
}

}  // namespace

std::vector<ConfigParameter> make_parameter_table() {
    Table table = together({source_entries(), mended_source_entries(), world_source_entries()});
    add_lifted(table, filter_parameters(), &Config::filter);
    add_lifted(table, registration_parameters(), &Config::registration);
    add_lifted(table, extraction_parameters(), &Config::extraction);
    add_lifted(table, grid_parameters(), &Config::grid);
    std::ranges::copy(run_entries(), std::back_inserter(table));
    join_layers(table);
    require_known(table, slam_algorithms());
    require_known(table, proposals());
    require_known(table, motion_models());
    require_known(table, resampling_methods());
    require_known(table, line_methods());
    std::ranges::stable_sort(table, {}, [](const ConfigParameter& p) { return rank(p.table()); });
    return table;
}

}  // namespace hitos
