// SPDX-License-Identifier: GPL-3.0-or-later
// Two tours as one, the second of which begins anywhere in what the first has seen.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hitos/capture/tour_reader.hpp"

namespace hitos {

/// The pose of a text "x,y,degrees"; nothing where it is empty. Throws ConfigError of source.start
/// where it is none.
std::optional<Pose> start_of(const std::string& text);

/// A tour that another one is to begin in the map of.
struct FirstTour {
    std::unique_ptr<TourReader> reader;
    std::string results = {};           ///< the folder of its run, for messages
    std::vector<double> stamps_s = {};  ///< of the scans that its run had; empty: any
};

/// The first tour's scans and odometry, then the second's, whose first scan says how it begins
/// (Scan::begins_tour). Stamps go on: where the second's begin before the first's are over, all of
/// them are put later by whole seconds. Messages name the second tour, findings are its own, and no
/// truth is known. Reading throws FileError where the first tour's scans are not of the times of
/// its run's, and FormatError where the second has none.
std::unique_ptr<TourReader> make_joined_tour(FirstTour first, std::unique_ptr<TourReader> second,
                                             TourBegin begin = {});

}  // namespace hitos
