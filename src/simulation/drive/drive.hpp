// SPDX-License-Identifier: GPL-3.0-or-later
// A world's tour with all that was true of it, for those who make scans of it.
#pragma once

#include "robot_motion.hpp"

namespace hitos {

/// As drive(); the world has to stay as long as what is returned is driven on.
RobotMotion driven(const World& world);

/// Throws ConfigError for more control periods than a tour may have.
void check_steps(std::size_t steps);

}  // namespace hitos
