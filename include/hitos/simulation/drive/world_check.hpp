// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a world can be driven: start, room and tour.
#pragma once

#include <optional>
#include <vector>

#include "hitos/base/message.hpp"
#include "hitos/simulation/worlds/world.hpp"

namespace hitos {

/// What is found of a world; doors are closed.
struct WorldCheck {
    double nearest_m = 0.0;   ///< from the start to the nearest wall; infinite without one
    bool start_free = false;  ///< nearest_m is the robot's radius or more
    /// Heading [rad, world frame] in which one sees out of the world from the start, the middle of
    /// the widest such opening; nothing where every ray ends at a wall.
    std::optional<double> way_out_rad;
    bool has_tour = false;
    Message tour_problem;  ///< of the first wall that it hits, say; empty: none, or no tour

    bool closed() const { return !way_out_rad; }
    /// Nothing speaks against it; that it has no tour does not.
    bool good() const { return start_free && closed() && tour_problem.empty(); }
};

/// Drives the tour, where there is one, and looks round from the start. Walls whose ends are up to
/// a millimetre short of each other are taken to meet.
WorldCheck check_world(const World& world);

/// The check in sentences, of start, room, what may be missing of a drawing, and last the tour.
std::vector<Message> sentences_of(const WorldCheck& check, const World& world);

}  // namespace hitos
