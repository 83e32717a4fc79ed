// SPDX-License-Identifier: GPL-3.0-or-later
// What of a run it is judged by.
#pragma once

#include "hitos/services/configuration/configuracion.hpp"
#include "hitos/services/files/trajectory_file.hpp"

namespace hitos {

class Registration;
class TourReader;

/// As it is now, while the run lives.
struct RunEvidence {
    const Configuracion& configuration;
    const TourReader& reader;
    const Trajectory& odometry;        ///< the pose by odometry alone at every scan so far
    const Registration* registration;  ///< null where the run has none
};

}  // namespace hitos
