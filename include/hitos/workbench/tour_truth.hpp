// What is true of a simulated tour, as the services take it.
#pragma once

#include "hitos/capture/fuente.hpp"
#include "hitos/services/maps/paths_picture.hpp"
#include "hitos/services/maps/trajectory_file.hpp"
#include "hitos/simulation/simulated_tour.hpp"

namespace hitos {

/// The true pose at every scan, in the frame of the start.
Trajectory true_trajectory(const SimulatedTour& tour);

/// The walls in the frame of the start.
Walls true_walls(const SimulatedTour& tour);

/// The tour behind a source that open_tour() made from a world; null for a log.
const SimulatedTour* simulated_tour(const Fuente& fuente);

}  // namespace hitos
