// SPDX-License-Identifier: GPL-3.0-or-later
// What a data source holds, be it a log or a world to simulate.
#pragma once

#include <exception>
#include <string>
#include <vector>

#include "hitos/capture/log_format.hpp"
#include "hitos/capture/tour_summary.hpp"
#include "hitos/services/configuration/configuracion.hpp"

namespace hitos {

/// What a source holds, before it is run.
struct SourceInspection {
    TourSummary tour;
    std::vector<Message> first_lines;   ///< of its file
    std::vector<RecordedTopic> topics;  ///< of a ROS recording
    /// Of a recording with several lasers or odometries of which none is chosen: what to choose.
    /// The tour is empty then but for its format. Else empty.
    Message choice;
    Message doubt;  ///< doubt_of_going_on()
};

/// Whether a source was refused for topics that nobody has chosen yet, not for wrong ones.
bool asks_for_topics(const std::exception& error, const ReadOptions& read);

/// Reads the whole source. Throws what open_tour() and inspect_tour() throw, but for topics that
/// are still to be chosen.
SourceInspection inspect_source(const SourceParams& source, const InspectProgress& progress = {});

}  // namespace hitos
