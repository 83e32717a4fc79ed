// What a data source holds, be it a log or a world to simulate.
#pragma once

#include "hitos/capture/log_summary.hpp"
#include "hitos/services/configuration/configuracion.hpp"

namespace hitos::window {

/// inspect_log() for logs; the same counts of the tour that a world describes. Throws what
/// inspect_log() and open_tour() throw.
LogSummary inspect_source(const SourceParams& source, const InspectProgress& progress);

}  // namespace hitos::window
