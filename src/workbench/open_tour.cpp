#include "hitos/workbench/open_tour.hpp"

#include "hitos/base/error.hpp"
#include "hitos/services/run/algoritmo.hpp"
#include "hitos/simulation/fuente_simulada.hpp"
#include "hitos/workbench/shipped_data.hpp"

namespace hitos {

std::unique_ptr<Fuente> open_tour(const SourceParams& source) {
    if (!is_world_file(source.file)) return open_source(source);
    if (source.format != LogFormat::automatic && source.format != LogFormat::normalized) {
        throw ConfigError("source.format", "found \"" + std::string(to_string(source.format)) +
                                               "\" for the world " + source.file +
                                               ", expected auto or normalized");
    }
    return std::make_unique<FuenteSimulada>(
        std::make_shared<const SimulatedTour>(read_world(source.file)));
}

}  // namespace hitos
