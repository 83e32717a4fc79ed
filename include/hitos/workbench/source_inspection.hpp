// What a data source holds, be it a log or a world to simulate.
#pragma once

#include <string>
#include <vector>

#include "hitos/capture/tour_summary.hpp"
#include "hitos/services/configuration/configuracion.hpp"

namespace hitos {

struct SourceInspection {
    TourSummary tour;
    std::vector<Message> first_lines;  ///< of its file
};

/// Reads the whole source. Throws what open_tour() and inspect_tour() throw.
SourceInspection inspect_source(const SourceParams& source, const InspectProgress& progress = {});

}  // namespace hitos
