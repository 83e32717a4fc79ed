// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/configuration/configuracion.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/capture/joined_tour.hpp"
#include "hitos/registration/graph_edit.hpp"
#include "hitos/slam/filter_parameters.hpp"
#include "hitos/slam/filters.hpp"
#include "json_input.hpp"
#include "parameter_table.hpp"

namespace hitos {

std::span<const ParameterGroupFacts> parameter_groups() {
    using Group = ParameterGroup;
    static const std::vector<ParameterGroupFacts> groups{
        {Group::source, HITOS_TEXT("ParameterGroup", "Data source"), {}, {"source"}},
        {Group::particle_filter, {}, "filter.algorithm", {"filter", "association", "landmarks"}},
        {Group::motion, HITOS_TEXT("ParameterGroup", "Motion model"), {}, {"motion"}},
        {Group::observation,
         HITOS_TEXT("ParameterGroup", "Observation model"),
         {},
         {"observation"}},
        {Group::split_merge, {}, "features.method", {"features", "split_merge", "ransac"}},
        {Group::resampling, HITOS_TEXT("ParameterGroup", "Resampling"), {}, {"resampling"}},
        {Group::registration, HITOS_TEXT("ParameterGroup", "Registration"), {}, {"registration"}},
        {Group::grid, HITOS_TEXT("ParameterGroup", "Grid map"), {}, {"grid"}},
        {Group::run, HITOS_TEXT("ParameterGroup", "Run"), {}, {"run"}},
    };
    return groups;
}

const ParameterGroupFacts& group_of(std::string_view table) {
    for (const ParameterGroupFacts& group : parameter_groups()) {
        if (std::ranges::find(group.tables, table) != group.tables.end()) return group;
    }
    throw ConfigError(std::string(table),
                      HITOS_TEXT("Errors", "no group of parameters has this table"));
}

std::span<const ConfigParameter> parameters() {
    static const std::vector<ConfigParameter> table = make_parameter_table();
    return table;
}

const ConfigParameter& find_parameter(std::string_view key) {
    return find_parameter(parameters(), key,
                          message(HITOS_TEXT("Errors", "init.cfg lists all of them")));
}

void set_parameter(Configuracion& configuration, std::string_view assignment) {
    const std::size_t sign = assignment.find('=');
    if (sign == std::string_view::npos) {
        throw ConfigError(std::string(assignment), HITOS_TEXT("Errors", "expected key=value"));
    }
    find_parameter(input::trimmed(assignment.substr(0, sign)))
        .set(configuration, assignment.substr(sign + 1));
}

namespace {

/// A second tour is found by registration alone.
void check_map(const Configuracion& configuration) {
    const FilterParams& filter = configuration.filter;
    const bool map = !configuration.source.map.empty();
    static_cast<void>(start_of(configuration.source.start));  // throws
    if (!is_utf8(configuration.source.map)) {
        throw ConfigError("source.map",
                          HITOS_TEXT("Errors",
                                     "the folder's name is not UTF-8, as a configuration has to "
                                     "be; rename it"));
    }
    if (map && !(needs_registration(filter) && configuration.registration.loops)) {
        throw ConfigError("source.map",
                          HITOS_TEXT("Errors",
                                     "only registration finds the robot in the map of another "
                                     "tour; use preset recorded, or %1 and registration.loops=on"),
                          "motion.model=registered");
    }
    if (map && configuration.source.hold && filter.algorithm == "graph-slam") {
        throw ConfigError("source.hold",
                          HITOS_TEXT("Errors",
                                     "graph-slam moves every landmark of its graph; use another "
                                     "filter.algorithm to hold a map"));
    }
}

}  // namespace

void check(const Configuracion& configuration) {
    check_all(parameters(), configuration);
    check(configuration.filter);
    static_cast<void>(parse_graph_edits(configuration.registration.edits));  // throws
    check_map(configuration);

    const GridParams& grid = configuration.grid;
    if (grid.log_odds_hit == 0.0 && grid.log_odds_miss == 0.0) {
        throw ConfigError("grid.hit", HITOS_TEXT("Errors",
                                                 "grid.hit and grid.miss both 0 draw nothing; give "
                                                 "at least one of them another value"));
    }
    if (grid.max_range_m > 0.0 && grid.max_range_m < grid.resolution_m) {
        throw ConfigError(
            "grid.max_range",
            HITOS_TEXT("Errors",
                       "%1 m is less than a cell (grid.resolution %2 m); 0 draws rays whole"),
            grid.max_range_m, grid.resolution_m);
    }
}

void forget_recording(SourceParams& source) {
    source.read = for_another_recording(source.read);
    source.map.clear();
    source.hold = false;
    source.start.clear();
}

void forget_recording(Configuracion& configuration) {
    forget_recording(configuration.source);
    configuration.registration.edits.clear();
}

}  // namespace hitos
