// SPDX-License-Identifier: GPL-3.0-or-later
// Odometry noise in studies, the same from the window and from the command line.
#pragma once

#include "hitos/services/study/study.hpp"
#include "hitos/simulation/worlds/odometry_noise.hpp"

namespace hitos {

/// Lets every run of the study open its tour, log or world, with noise of its own, drawn with the
/// run's seed; level 0: without noise. Throws ConfigError for an impossible level.
void set_study_source(Study& study, double level, OdometryNoiseKind kind);

}  // namespace hitos
