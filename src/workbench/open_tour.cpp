// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/workbench/open_tour.hpp"

#include <algorithm>
#include <span>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/capture/archivo.hpp"
#include "hitos/capture/joined_tour.hpp"
#include "hitos/registration/scan_odometry.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/files/trajectory_file.hpp"
#include "hitos/services/results/kept_run.hpp"
#include "hitos/services/run/open_source.hpp"
#include "hitos/simulation/drive/simulated_tour_reader.hpp"
#include "hitos/workbench/benchmark.hpp"

namespace hitos {

World open_world(const SourceParams& source, std::uint64_t run_seed) {
    World world = read_world(source.file);
    std::istringstream changes(source.world_set);
    for (std::string change; changes >> change;) set_world_value(world, change);
    if (source.tour_seed != 0) world.seed = source.tour_seed;
    // 0 says "not chosen" in a world; a run's seed of 0 is one like any other.
    constexpr std::uint64_t kOfZero = ~std::uint64_t{0};
    if (world.seed == 0) world.seed = run_seed != 0 ? run_seed : kOfZero;
    return world;
}

namespace {

/// Of a chain of maps, each of which goes on with another one.
constexpr int kMostMaps = 20;

ConfigError endless(const std::string& folder) {
    return {"source.map",
            message(HITOS_TEXT("Errors",
                               "%1 is the end of a chain of more than %2 maps, or of a circle of "
                               "them"),
                    folder, kMostMaps)};
}

struct Map {
    std::string folder;
    Configuracion configuration;  // of the run that made it
};

std::filesystem::path configuration_file(const std::string& folder) {
    return std::filesystem::path(folder) / "config.cfg";
}

/// Of the run that has written a folder of results.
Configuracion configuration_in(const std::string& folder) {
    std::error_code ignored;
    if (!std::filesystem::exists(configuration_file(folder), ignored)) {
        throw FileError(folder, HITOS_TEXT("Errors",
                                           "holds no results of a run (no config.cfg); "
                                           "expected the folder that a run of the first tour "
                                           "has written"));
    }
    expect_results_unchanged(folder);
    return ArchivoConfiguracion::read(configuration_file(folder));
}

/// Whether a run held another one's map, which then is what its folder stands for.
bool held_another(const SourceParams& source) {
    return source.hold && !source.map.empty();
}

/// The map that a folder of results stands for.
Map map_in(std::string folder) {
    for (int maps = 0; maps < kMostMaps; ++maps) {
        Map map{folder, configuration_in(folder)};
        if (!held_another(map.configuration.source)) return map;
        folder = map.configuration.source.map;
    }
    throw endless(folder);
}

std::unique_ptr<TourReader> open_one(const SourceParams& source, std::uint64_t run_seed) {
    if (!is_world_file(source.file)) return open_source(source);
    // Older configurations name the format in which worlds used to be read.
    if (source.format != kAutoFormat && source.format != "normalized") {
        throw ConfigError(
            "source.format",
            HITOS_TEXT("Errors", "found \"%1\" for the world %2, expected auto: it is no log"),
            source.format, source.file);
    }
    auto reader = std::make_unique<SimulatedTourReader>(
        std::make_shared<const SimulatedTour>(open_world(source, run_seed)), source.read);
    if (source.read.odometry != OdometryFrom::scans) return reader;
    return make_scan_odometry(std::move(reader));
}

/// When the scans of the tour of a folder of results were made.
std::vector<double> stamps_of(const std::string& folder) {
    std::vector<double> stamps;
    for (const StampedPose& pose :
         read_trajectory(std::filesystem::path(folder) / "trajectory.tum"))
        stamps.push_back(pose.time_s);
    return stamps;
}

std::unique_ptr<TourReader> open_behind(const SourceParams& source, std::uint64_t run_seed,
                                        int maps) {
    if (source.map.empty()) return open_one(source, run_seed);
    if (maps == kMostMaps) throw endless(source.map);
    const auto [folder, before] = map_in(source.map);
    return make_joined_tour(
        {open_behind(before.source, before.run.seed, maps + 1), folder, stamps_of(folder)},
        open_one(source, run_seed), {source.hold, start_of(source.start)});
}

/// Whether both sources are the same tour, however it is read.
bool same_tour(const SourceParams& a, std::uint64_t seed_a, const SourceParams& b,
               std::uint64_t seed_b) {
    const bool world = is_world_file(a.file);
    if (world != is_world_file(b.file)) return false;
    if (world &&
        (a.world_set != b.world_set || open_world(a, seed_a).seed != open_world(b, seed_b).seed)) {
        return false;
    }
    std::error_code ignored;
    return std::filesystem::equivalent(a.file, b.file, ignored) ||
           digest_of_tour(a.file) == digest_of_tour(b.file);
}

}  // namespace

Message doubt_of_going_on(const SourceParams& source, std::uint64_t run_seed) {
    std::string folder = source.map;
    try {
        for (int maps = 0; !folder.empty() && maps < kMostMaps; ++maps) {
            const Map map = map_in(folder);
            const Configuracion& before = map.configuration;
            if (same_tour(before.source, before.run.seed, source, run_seed)) {
                return message(
                    HITOS_TEXT("Errors",
                               "This is the tour that the map of %1 was made of: laid on itself "
                               "it brings the map nothing new, and that it fits tells nothing."),
                    map.folder);
            }
            folder = before.source.map;
        }
    } catch (const Error&) {  // whoever opens it is told
    }
    return {};
}

Configuracion configuration_to_go_on(const std::string& map) {
    Configuracion configuration = map_in(map).configuration;
    const ReadOptions read = for_another_recording(configuration.source.read);
    configuration.source = {};
    configuration.source.read = read;
    return configuration;
}

std::unique_ptr<TourReader> open_tour(const SourceParams& source, std::uint64_t run_seed) {
    return open_behind(source, run_seed, 0);
}

std::vector<GraphEdit> changes_of_map(const Configuracion& configuration) {
    if (configuration.source.map.empty()) return {};
    const Map map = map_in(configuration.source.map);
    const std::string& before = map.configuration.registration.edits;
    if (configuration.registration.edits == before) return {};
    const std::uint64_t scans = stamps_of(map.folder).size();
    const std::vector<GraphEdit> of_map = parse_graph_edits(before);
    const std::vector<GraphEdit> now = parse_graph_edits(configuration.registration.edits);
    std::vector<GraphEdit> changed;
    const auto take_new = [&](const std::vector<GraphEdit>& of, const std::vector<GraphEdit>& to) {
        for (const GraphEdit& edit : of) {
            if (!has_change(to, edit) && std::max(edit.scan.scan, edit.earlier.scan) < scans)
                changed.push_back(edit);
        }
    };
    take_new(now, of_map);
    take_new(of_map, now);
    return changed;
}

void check_held_map(const Configuracion& configuration) {
    if (!configuration.source.hold) return;
    const std::vector<GraphEdit> changed = changes_of_map(configuration);
    if (changed.empty()) return;
    throw ConfigError(
        kGraphEditsKey,
        HITOS_TEXT("Errors",
                   "\"%1\" is of the map of %2, which stays as it is (source.hold): change it in "
                   "that map's own run, or go on with the map without holding it"),
        text_of(std::span(changed).first(1)), configuration.source.map);
}

std::unique_ptr<TourReader> open_tour(const Configuracion& configuration) {
    check_held_map(configuration);
    return open_tour(configuration.source, configuration.run.seed);
}

std::vector<std::filesystem::path> tour_files(const std::string& file) {
    if (!is_world_file(file)) return log_files(file);
    std::vector<std::filesystem::path> files{file};
    try {
        if (World world = read_world(file); !world.drawing.empty()) {
            files.push_back(std::move(world.drawing));
        }
    } catch (const Error&) {  // whoever opens it is told
    }
    return files;
}

std::vector<std::filesystem::path> tour_files(const SourceParams& source) {
    std::vector<std::filesystem::path> files = tour_files(source.file);
    std::string folder = source.map;
    for (int maps = 0; !folder.empty() && maps < kMostMaps; ++maps) {
        const SourceParams before = configuration_in(folder).source;
        files.push_back(configuration_file(folder));
        if (!held_another(before)) {  // else its own tour is not in the map
            for (std::filesystem::path& log : tour_files(before.file))
                files.push_back(std::move(log));
        }
        folder = before.map;
    }
    return files;
}

void add_truth(References& references, const std::optional<Truth>& truth) {
    if (!truth) return;
    if (references.walls.empty()) references.walls = truth->walls;
    if (!references.trajectory) references.trajectory = truth->path;
}

}  // namespace hitos
