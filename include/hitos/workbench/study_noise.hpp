// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn anew for every run of a study, the same from the window and from the command line.
#pragma once

#include "hitos/services/study/study.hpp"
#include "hitos/simulation/worlds/odometry_noise.hpp"

namespace hitos {

/// Lets every run of the study open its tour, log or world, with noise of its own, drawn with the
/// run's seed; level 0: without noise. Throws ConfigError for an impossible level.
void set_study_source(Study& study, double level, OdometryNoiseKind kind);

/// Lets the run of seed 1 have perturbed copy 1 of the log (make_perturbed_reader()), that of seed
/// 2 copy 2, behind the last one the first again; 0: none. After set_study_source().
void set_study_copies(Study& study, int copies);

}  // namespace hitos
