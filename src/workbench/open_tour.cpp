#include "hitos/workbench/open_tour.hpp"

#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/services/run/open_source.hpp"
#include "hitos/simulation/simulated_tour_reader.hpp"
#include "hitos/workbench/shipped_data.hpp"

namespace hitos {

std::unique_ptr<TourReader> open_tour(const SourceParams& source) {
    if (!is_world_file(source.file)) return open_source(source);
    // Older configurations name the format in which worlds used to be read.
    if (source.format != kAutoFormat && source.format != "normalized") {
        throw ConfigError("source.format", "found \"" + source.format + "\" for the world " +
                                               source.file + ", expected auto: it is no log");
    }
    return std::make_unique<SimulatedTourReader>(
        std::make_shared<const SimulatedTour>(read_world(source.file)), source.read);
}

void add_truth(References& references, const std::optional<Truth>& truth) {
    if (!truth) return;
    if (references.walls.empty()) references.walls = truth->walls;
    if (!references.trajectory) references.trajectory = truth->path;
}

}  // namespace hitos
