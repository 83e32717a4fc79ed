// Single values that a user asks for, over a configuration.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hitos/services/configuration/configuracion.hpp"

namespace hitos {

/// --set, --world-set, --seed, --tour-seed and --threads.
struct ValueChoices {
    std::vector<std::string> assignments;  ///< "key=value"
    std::optional<std::uint64_t> seed = {};
    std::optional<int> threads = {};
    std::optional<std::uint64_t> tour_seed = {};
    std::vector<std::string> world_assignments = {};  ///< "key=value", of a world's values
};

/// The assignments over the configuration, in order, then the others; those of a world are put
/// behind what source.world_set says already. All checked. Throws ConfigError.
void choose_values(Configuracion& configuration, const ValueChoices& choices);

}  // namespace hitos
