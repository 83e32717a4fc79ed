// SPDX-License-Identifier: GPL-3.0-or-later
// The table of a world file's keys that hold one value each.
#pragma once

#include <span>

#include "hitos/base/parameter.hpp"
#include "hitos/simulation/worlds/world.hpp"

namespace hitos {

/// A key of the world file that holds one value; --set takes the same keys.
using WorldKey = Parameter<World>;

/// All of them, in the order of docs/simulation.md.
std::span<const WorldKey> world_keys();

}  // namespace hitos
