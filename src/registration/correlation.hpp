// SPDX-License-Identifier: GPL-3.0-or-later
// Where in a window a set of points correlates best with a map, whatever the start.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "correlation_map.hpp"
#include "hitos/base/geometry.hpp"
#include "square_lattice.hpp"
#include "surface_points.hpp"

namespace hitos {

/// Half sizes of the window about a pose.
struct SearchWindow {
    double position_m;
    double heading_rad;
};

struct Correlation {
    Pose pose;
    double score;  ///< mean value of the map under the points, 0 … 1
};

/// The pose in the window about `centre` with the greatest score, if that is `least_score` at
/// least. Best first with bounds: the result is that of trying every cell and angle. Null too where
/// 20 000 places were opened without an end.
std::optional<Correlation> correlate(std::span<const SurfacePoint> points,
                                     const CorrelationMap& map, const Pose& centre,
                                     const SearchWindow& window, double least_score);

/// What best_places() looks for.
struct PlacesWanted {
    double within_m = 3.0;     ///< of one of the positions where the robot may be
    double least_score = 0.6;  ///< of every place
    double share = 0.8;        ///< of the best one's score
    std::size_t most = 6;      ///< places
};

struct BestPlaces {
    std::vector<Correlation> places;  ///< each 2 m or 0.5 rad from every other one, best first
    bool all = true;  ///< false where 200 000 squares were opened without an end: some are missing
};

/// The places about `positions`, at any heading, that correlate best; of up to
/// SquareLattice::kMostCells points, with the map's lattice.
BestPlaces best_places(std::span<const SurfacePoint> points, const CorrelationMap& map,
                       const SquareLattice& lattice, std::span<const Point2> positions,
                       const PlacesWanted& wanted);

}  // namespace hitos
