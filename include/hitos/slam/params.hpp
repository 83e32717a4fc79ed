// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of the filters, one struct per part; SPEC §5.
#pragma once

#include <string>

namespace hitos {

/// What the numbers of constant noise are.
enum class MotionUnit {
    sigma,    ///< standard deviations [m, m, rad]
    variance  ///< variances [m^2, m^2, rad^2], as the thesis calls its own
};

/// Noise is drawn once per filter step (between two scans), never at the first scan and never
/// where the controls are zero. The thesis calls its numbers variances; read as standard
/// deviations they give its results (docs/algorithm.md), so sigmas they are here unless `unit` says
/// otherwise.
struct MotionParams {
    std::string model = "odometry";        ///< a word of motion_models()
    double sigma_x_m = 0.008;              ///< world x, per step
    double sigma_y_m = 0.008;              ///< world y, per step
    double sigma_theta_rad = 0.008;        ///< heading, per step
    double var_along_m2_per_m = 0.005;     ///< proportional: along the motion, per metre
    double var_across_m2_per_m = 0.002;    ///< proportional: across it, per metre
    double var_theta_rad2_per_rad = 0.02;  ///< proportional: heading, per radian turned
    double var_theta_rad2_per_m = 0.002;   ///< proportional: heading, per metre
    MotionUnit unit = MotionUnit::sigma;   ///< what the three sigmas are
    double ratio_x = 0.1;                  ///< increments: sigma of the step ahead, m per m of it
    double ratio_y = 0.1;                  ///< increments: of the step sideways
    double ratio_theta = 0.1;              ///< increments: of the turn, rad per rad
    double registered_memory_m = 3.0;  ///< registered: way after which 1/e of a deviation is left
    double registered_share = 0.1;     ///< registered: of the step's covariance in its spread
    double registered_sigma_m = 0.01;  ///< registered: and of the position besides
    double registered_heading_rad = 0.002;  ///< registered: and of the heading
};

/// Variances of an observed line (rho, theta); a corner's range and bearing use the same two.
struct ObservationParams {
    double var_rho_m2 = 0.04;
    double var_theta_rad2 = 0.00122;
};

enum class AssociationMethod {
    maximum_likelihood,  ///< [T table 5.1]
    gated_nearest,       ///< nearest by Mahalanobis distance inside a chi-square gate [T 5.3]
    joint_compatibility  ///< all observations of a scan together (Neira and Tardos, 2001)
};

/// What happens with an observation that could belong to several landmarks. In every case but
/// `off` it changes no landmark [T 5.4.2].
enum class AmbiguityRule {
    keep_likelihood,  ///< the weight keeps the best likelihood
    neutral,          ///< the weight does not change
    new_landmark,     ///< the weight is multiplied with p0
    off               ///< there is no ambiguity: the best landmark takes the observation
};

/// How features and landmarks are paired.
struct AssociationParams {
    AssociationMethod method = AssociationMethod::maximum_likelihood;
    double p0 = 0.005;                ///< likelihood of a new landmark
    double gate_probability = 0.95;   ///< of the chi-square gate with 2 degrees of freedom
    double new_probability = 0.9999;  ///< EKF-SLAM: of the gate outside which a landmark is new
    AmbiguityRule ambiguity = AmbiguityRule::keep_likelihood;
    double ambiguity_ratio = 0.1;     ///< second best over best from which both are plausible
    double joint_probability = 0.95;  ///< joint compatibility: of the gate of all pairings
    bool segments = false;            ///< a line is found only beside where it was seen
    double segment_margin_m = 0.5;    ///< and that far beyond its ends
    bool exclusive = false;           ///< a landmark takes one observation of a scan
    bool known = true;                ///< what says which landmark it is, is believed
    bool hypotheses = false;          ///< particles choose among the landmarks of an ambiguous one
};

/// Which landmarks a map keeps.
struct LandmarkParams {
    bool vanish = false;        ///< landmarks that the scans look through go
    double hit = 0.8;           ///< log-odds of existence that being found adds
    double miss = -0.4;         ///< and being looked through
    double limit = 4.0;         ///< greatest log-odds; below 0 a landmark goes
    int probation = 0;          ///< sightings that make a landmark part of the map; 0: none asked
    int probation_scans = 100;  ///< scans in which they have to come
};

enum class ResamplingRule { always, neff };

/// When and how particles are drawn anew.
struct ResamplingParams {
    ResamplingRule rule = ResamplingRule::always;
    double neff_threshold = 50.0;         ///< effective particles below which `neff` resamples
    std::string method = "low-variance";  ///< a word of resampling_methods()
};

/// Parameters of all algorithms; each one reads those that concern it.
struct FilterParams {
    std::string algorithm = "fastslam";  ///< a word of slam_algorithms()
    int particles = 100;
    std::string proposal = "motion";  ///< a word of proposals(): where particles draw their poses
    MotionParams motion;
    ObservationParams observation;
    AssociationParams association;
    LandmarkParams landmarks;
    ResamplingParams resampling;
};

}  // namespace hitos
