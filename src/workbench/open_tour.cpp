#include "hitos/workbench/open_tour.hpp"

#include <sstream>
#include <string>
#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/capture/archivo.hpp"
#include "hitos/registration/scan_odometry.hpp"
#include "hitos/services/run/open_source.hpp"
#include "hitos/simulation/drive/simulated_tour_reader.hpp"

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

std::unique_ptr<TourReader> open_tour(const SourceParams& source, std::uint64_t run_seed) {
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

std::unique_ptr<TourReader> open_tour(const Configuracion& configuration) {
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

void add_truth(References& references, const std::optional<Truth>& truth) {
    if (!truth) return;
    if (references.walls.empty()) references.walls = truth->walls;
    if (!references.trajectory) references.trajectory = truth->path;
}

}  // namespace hitos
