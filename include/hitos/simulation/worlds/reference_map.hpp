// SPDX-License-Identifier: GPL-3.0-or-later
// The landmarks that a perfect map of a world holds.
#pragma once

#include "hitos/features/caracteristica.hpp"
#include "hitos/simulation/worlds/world.hpp"

namespace hitos {

/// Every infinite line on which a wall lies, once, and every point that walls of two directions
/// share: where they end together, where one ends on another, where they cross. In the frame of
/// the tour's start, which is where a SLAM run begins; lines before corners, each in the order of
/// the walls, then the middles of trees and posts that a laser sees; of a world with landmarks that
/// a sensor tells by themselves these and nothing else. `observations` and covariances are zero.
LandmarkMap reference_map(const World& world);

}  // namespace hitos
