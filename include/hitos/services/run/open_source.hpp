// The log that a configuration names, as a reader.
#pragma once

#include <memory>

#include "hitos/capture/tour_reader.hpp"
#include "hitos/services/configuration/configuracion.hpp"

namespace hitos {

/// Throws as open_log does, and ConfigError where no file is named.
std::unique_ptr<TourReader> open_source(const SourceParams& source);

}  // namespace hitos
