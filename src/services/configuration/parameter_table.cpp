#include "parameter_table.hpp"

#include <algorithm>

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

/// What of a log is wrong or not said, and is put right.
void add_mended_source(Table& table) {
    table.push_back(text<&Config::source, &SourceParams::read, &ReadOptions::laser_pose>(
        {.key = "source.laser_pose",
         .description =
             HITOS_TEXT("Parameter",
                        "Where the laser sits on the robot, whatever the log says: x,y,degrees "
                        "(metres ahead, metres to the left, turn to the left), with ,upside-down "
                        "behind it where it does; empty takes what the log says."),
         .label = HITOS_TEXT("ParameterLabel", "Laser's place")}));
    table.push_back(text<&Config::source, &SourceParams::read, &ReadOptions::same_frames>(
        {.key = "source.same_frames",
         .description = HITOS_TEXT("Parameter",
                                   "Frames of a ROS recording that are one under two names, as "
                                   "base_footprint=base_link; several with commas between them."),
         .label = HITOS_TEXT("ParameterLabel", "Frames that are one")}));
    table.push_back(real<&Config::source, &SourceParams::read, &ReadOptions::min_range_m>(
        {.key = "source.min_range",
         .unit = "m",
         .minimum = 0.0,
         .maximum = 1000.0,
         .description = HITOS_TEXT("Parameter",
                                   "Nearer readings are no points, so a higher value leaves out "
                                   "more of what may be the robot itself."),
         .label = HITOS_TEXT("ParameterLabel", "Minimum range")}));
    table.push_back(real<&Config::source, &SourceParams::read, &ReadOptions::ray_time_s>(
        {.key = "source.ray_time",
         .unit = "s",
         .minimum = -1.0,
         .maximum = 1.0,
         .description = HITOS_TEXT(
             "Parameter",
             "Time from one ray of a scan to the next, by which rays are moved as the robot drives "
             "on; a higher value moves them further; 0 takes what the log says."),
         .label = HITOS_TEXT("ParameterLabel", "Time of a ray")}));
    table.push_back(real<&Config::source, &SourceParams::read, &ReadOptions::odometry_scale>(
        {.key = "source.odometry_scale",
         .minimum = 0.001,
         .maximum = 1000.0,
         .description = HITOS_TEXT(
             "Parameter",
             "The odometry's way is taken that many times as long; a higher value lengthens it."),
         .label = HITOS_TEXT("ParameterLabel", "Odometry scale")}));
    table.push_back(choice<&Config::source, &SourceParams::read, &ReadOptions::mend>(
        {.key = "source.mend",
         .description = HITOS_TEXT(
             "Parameter",
             "Whether what is known to be wrong is mended: rays that were measured one after the "
             "other are moved by the odometry to one time (rays); besides, leaps of the odometry "
             "that no robot makes are bridged, stamps of too few digits give way to the logger's "
             "times, and where there is no odometry the scans say how the robot moved (on)."),
         .label = HITOS_TEXT("ParameterLabel", "Mend"),
         .choices = {{"off", HITOS_TEXT("ParameterChoice", "Off")},
                     {"rays", HITOS_TEXT("ParameterChoice", "Rays only")},
                     {"on", HITOS_TEXT("ParameterChoice", "On")}}}));
}

void add_source(Table& table) {
    table.push_back(text<&Config::source, &SourceParams::file>(
        {.key = "source.file",
         .description = HITOS_TEXT(
             "Parameter", "Path of the log or ROS recording to read; empty where none is chosen."),
         .label = HITOS_TEXT("ParameterLabel", "Log"),
         .card = "source"}));
    table.push_back(choice<&Config::source, &SourceParams::format>(
        {.key = "source.format",
         .description =
             HITOS_TEXT("Parameter", "Format of the log; auto finds it from its beginning."),
         .label = HITOS_TEXT("ParameterLabel", "Format"),
         .card = "source",
         .choices = format_choices()}));
    table.push_back(real<&Config::source, &SourceParams::read, &ReadOptions::max_range_m>(
        {.key = "source.max_range",
         .unit = "m",
         .minimum = 0.0,
         .maximum = 1000.0,
         .description = HITOS_TEXT("Parameter",
                                   "Readings at or beyond this range are no points, so a higher "
                                   "value keeps more far readings; 0 takes what the log says."),
         .label = HITOS_TEXT("ParameterLabel", "Maximum range")}));
    table.push_back(choice<&Config::source, &SourceParams::read, &ReadOptions::odometry>(
        {.key = "source.odometry",
         .description = HITOS_TEXT(
             "Parameter",
             "Whether controls come from the differences of the logged poses, are the logged v and "
             "omega, or come from the scans alone, as where a log has no odometry."),
         .label = HITOS_TEXT("ParameterLabel", "Odometry from"),
         .card = "source",
         .choices = {{"poses", HITOS_TEXT("ParameterChoice", "Logged poses")},
                     {"velocities", HITOS_TEXT("ParameterChoice", "Logged velocities")},
                     {"scans", HITOS_TEXT("ParameterChoice", "Scans")}}}));
    table.push_back(text<&Config::source, &SourceParams::read, &ReadOptions::scan_topic>(
        {.key = "source.scan_topic",
         .description = HITOS_TEXT(
             "Parameter",
             "Topic of the laser in a ROS recording with several: one, some with commas between "
             "them, or all. Lasers that see from one place become one; empty takes the only one."),
         .label = HITOS_TEXT("ParameterLabel", "Laser topic")}));
    table.push_back(text<&Config::source, &SourceParams::read, &ReadOptions::odom_topic>(
        {.key = "source.odom_topic",
         .description =
             HITOS_TEXT("Parameter",
                        "Topic of the odometry in a ROS recording with several, or tf for its "
                        "transforms; empty takes the only one, else the transforms."),
         .label = HITOS_TEXT("ParameterLabel", "Odometry topic")}));
    table.push_back(
        choice<&Config::source, &SourceParams::read, &ReadOptions::leave_out_early_scans>(
            {.key = "source.early_scans",
             .description = HITOS_TEXT(
                 "Parameter",
                 "What becomes of scans before the first odometry reading: they are used as if the "
                 "robot had stood still until then, or left out. Both are counted."),
             .label = HITOS_TEXT("ParameterLabel", "Scans before the odometry"),
             .choices = {{"keep", HITOS_TEXT("ParameterChoice", "Keep, robot at rest")},
                         {"leave_out", HITOS_TEXT("ParameterChoice", "Leave out")}}}));
    table.push_back(real<&Config::source, &SourceParams::read, &ReadOptions::scan_delay_s>(
        {.key = "source.scan_delay",
         .unit = "s",
         .minimum = -1e10,
         .maximum = 1e10,
         .description = HITOS_TEXT("Parameter",
                                   "Added to the times of the scans, where the laser's clock is "
                                   "not the odometry's; hitos-cli check says by how much they "
                                   "differ. A higher value pairs scans with later odometry."),
         .label = HITOS_TEXT("ParameterLabel", "Scan delay")}));
    add_mended_source(table);
    const ConfigParameter::Condition world{
        "source.file", "a world (.toml)",
        [](const Config& configuration) { return is_world_file(configuration.source.file); }};
    const ConfigParameter::Condition log{
        "source.file", "a log or ROS recording, no world",
        [](const Config& configuration) { return !is_world_file(configuration.source.file); }};
    for (const char* key : {"source.scan_topic", "source.odom_topic", "source.laser_pose",
                            "source.same_frames", "source.ray_time"}) {
        at(table, key).conditions.push_back(log);
    }
    table.push_back(used(
        integer<&Config::source, &SourceParams::tour_seed>(
            {.key = "source.tour_seed",
             .minimum = 0.0,
             .maximum = 0x1p63,
             .description = HITOS_TEXT(
                 "Parameter",
                 "Seed of the noise of a world's laser and odometry, so that runs with other seeds "
                 "drive the same tour; 0 takes what the world says, else the run's seed."),
             .label = HITOS_TEXT("ParameterLabel", "Tour seed")}),
        {world}));
    table.push_back(
        used(text<&Config::source, &SourceParams::world_set>(
                 {.key = "source.world_set",
                  .description = HITOS_TEXT(
                      "Parameter",
                      "Changes of a world's values, with spaces between them, e.g. "
                      "laser.sigma=0.003 tour.laps=2; hitos-cli simulate --help lists the keys."),
                  .label = HITOS_TEXT("ParameterLabel", "World values")}),
             {world}));
}

void add_run(Table& table) {
    table.push_back(integer<&Config::run, &RunParams::seed>(
        {.key = "run.seed",
         .minimum = 0.0,
         .maximum = 0x1p63,
         .description = HITOS_TEXT(
             "Parameter",
             "Seed of all random numbers; the same seed gives the same result to the last bit."),
         .label = HITOS_TEXT("ParameterLabel", "Seed"),
         .card = "filter"}));
    table.push_back(integer<&Config::run, &RunParams::threads>(
        {.key = "run.threads",
         .minimum = 0.0,
         .maximum = 256.0,
         .description = HITOS_TEXT("Parameter",
                                   "Number of threads, which changes the time and never the "
                                   "result; 0 uses as many as the machine has."),
         .label = HITOS_TEXT("ParameterLabel", "Threads")}));
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
    Table table;
    add_source(table);
    add_lifted(table, filter_parameters(), &Config::filter);
    add_lifted(table, registration_parameters(), &Config::registration);
    add_lifted(table, extraction_parameters(), &Config::extraction);
    add_lifted(table, grid_parameters(), &Config::grid);
    add_run(table);
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
