// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of registration. Where each number comes from: docs/registration.md.
#pragma once

#include <string>

namespace hitos {

/// Standard deviations of an odometry step of length l [m] and turn r [rad]: along it
/// sqrt(fixed^2 + (per_m l)^2 + (per_rad r)^2), likewise across it and of the heading.
struct RegistrationParams {
    double range_m = 80.0;        ///< readings beyond it are left out
    int key_scans = 30;           ///< of the local map, newest ones
    double key_distance_m = 0.3;  ///< a scan that far from the last key is the next one
    double key_angle_rad = 0.3;   ///< or turned that far
    double point_sigma_m = 0.1;  ///< of a matched point, its share of the errors in common included
    double odometry_scale = 1.0;  ///< factor of all standard deviations of the odometry
    bool robust_prior = true;     ///< odometry that the scan contradicts loses weight
    bool search = true;           ///< correlative search where no start fits
    bool calibrate = true;        ///< learn what the laser sees beside the direction of travel
    bool loops = true;            ///< look for closed loops
    double loop_score = 0.6;      ///< least correlation of a loop
    int loops_agree = 3;          ///< searches in a row that must say the same
    int final_passes = 3;         ///< of the whole graph against all scans, at the tour's end
    std::string edits = {};       ///< what is changed by hand, as parse_graph_edits() takes it
};

}  // namespace hitos
