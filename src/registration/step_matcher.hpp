// SPDX-License-Identifier: GPL-3.0-or-later
// One scan placed on the local map, from several starts where one is not enough.
#pragma once

#include <span>
#include <utility>

#include "hitos/registration/registration_params.hpp"
#include "scan_matcher.hpp"

namespace hitos {

/// Where a scan was placed.
struct MatchedStep {
    Pose pose;             ///< the odometry's where the scan fitted nothing
    double score = 0.0;    ///< less a little for what departs from the odometry
    bool matched = false;  ///< enough points, and a score that is no accident
    Linearization fine;    ///< at `pose`, in the fine stage
};

/// Matches steps: from the odometry's pose; where that fits badly, also turned; where nothing fits,
/// from where the scan correlates best with the map.
class StepMatcher {
  public:
    StepMatcher(RegistrationParams params, const ScanMatcher& matcher)
        : params_(std::move(params)), matcher_(matcher) {}

    /// `sigmas` are the odometry's: position [m], heading [rad].
    MatchedStep match(std::span<const SurfacePoint> scan, const PointMap& map,
                      const PosePrior& odometry, const Eigen::Vector2d& sigmas) const;

  private:
    struct Start {
        Pose pose;
        double score;
    };
    double score(std::span<const SurfacePoint> scan, const PointMap& map, const Pose& pose,
                 const Pose& odometry) const;
    /// From the odometry's pose turned to either side.
    void try_turned(std::span<const SurfacePoint> scan, const PointMap& map,
                    const PosePrior& odometry, Start& best) const;
    void search(std::span<const SurfacePoint> scan, const PointMap& map, const PosePrior& odometry,
                const Eigen::Vector2d& sigmas, Start& best) const;

    RegistrationParams params_;
    ScanMatcher matcher_;
};

}  // namespace hitos
