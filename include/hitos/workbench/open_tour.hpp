// The one place that decides what a source's file is: a log, or a world to simulate.
#pragma once

#include <memory>

#include "hitos/capture/fuente.hpp"
#include "hitos/services/configuration/configuracion.hpp"

namespace hitos {

/// A world file (.toml) is simulated, seed and noise as it says; anything else is a log. Throws
/// what open_source() and read_world() throw, and ConfigError where a world is to be read in
/// another format than normalized.
std::unique_ptr<Fuente> open_tour(const SourceParams& source);

}  // namespace hitos
