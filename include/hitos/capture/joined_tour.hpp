// Two tours as one, the second of which begins anywhere in what the first has seen.
#pragma once

#include <memory>

#include "hitos/capture/tour_reader.hpp"

namespace hitos {

/// The first tour's scans and odometry, then the second's, whose first scan says that it begins a
/// tour (Scan::begins_tour). Stamps go on: where the second's begin before the first's are over,
/// all of them are put later by whole seconds. Messages name the second tour, findings are of both,
/// and no truth is known.
std::unique_ptr<TourReader> make_joined_tour(std::unique_ptr<TourReader> first,
                                             std::unique_ptr<TourReader> second);

}  // namespace hitos
