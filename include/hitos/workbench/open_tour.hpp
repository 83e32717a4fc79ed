// The one place that decides what a source is, a log or a world to simulate, and what is known of
// it.
#pragma once

#include <memory>

#include "hitos/capture/tour_reader.hpp"
#include "hitos/services/configuration/configuracion.hpp"
#include "hitos/services/run/results.hpp"

namespace hitos {

/// A world file (.toml) is simulated, seed and noise as it says; anything else is a log. Throws
/// what open_source() and read_world() throw, and ConfigError where a world is to be read in the
/// format of a log.
std::unique_ptr<TourReader> open_tour(const SourceParams& source);

/// Puts the truth that the tour knows where the references name nothing else: its path, and its
/// walls for pictures.
void add_truth(References& references, const std::optional<Truth>& truth);

}  // namespace hitos
