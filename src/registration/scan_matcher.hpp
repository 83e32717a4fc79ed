// SPDX-License-Identifier: GPL-3.0-or-later
// A scan fitted to a map of points by what lies between them and by what was known before.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "hitos/base/geometry.hpp"
#include "point_map.hpp"

namespace hitos {

/// The sum of squares of a scan's distances from the map about a pose, to second order in the
/// pose's (x, y, theta) in the world's axes, the turn about the robot: H and b = H (pose - best).
struct Linearization {
    Eigen::Matrix3d h = Eigen::Matrix3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    int matches = 0;
};

/// What is known of a pose before the scan is looked at.
struct PosePrior {
    Pose mean;
    Eigen::Matrix3d information;  ///< of (x, y, theta) in the world's axes
    bool robust = true;           ///< loses weight where the scan contradicts it
};

/// How near points must be to be the same surface, and from which distance on they count half.
struct MatchStage {
    double radius_m;
    double half_weight_m;
    bool same_side;  ///< normals must not differ by more than 60 degrees
};

/// For the last steps, and for what is kept of a match.
inline constexpr MatchStage kFineStage{0.25, 0.05, true};

/// How well the scan lies on the map: the mean of exp(-d^2 / (2 (8 cm)^2)) over every `stride`-th
/// point, 0 for those with nothing within 0.3 m.
double match_score(std::span<const SurfacePoint> scan, const PointMap& map, const Pose& pose,
                   int stride);

/// Fits scans to a map: the greatest posterior under a Gaussian prior and independent errors of
/// `sigma_m` across the map's surfaces, which Cauchy's loss bounds (Censi, 2008, for the point to
/// line metric). sigma is wide on purpose: neighbouring rays err together.
class ScanMatcher {
  public:
    static constexpr int kMostSteps = 20;
    static constexpr int kWideSteps = 4;

    explicit ScanMatcher(double sigma_m) : information_(1.0 / (sigma_m * sigma_m)) {}

    /// Information of one match [1/m^2].
    double information() const { return information_; }

    /// Compares every `stride`-th point with its nearest in the map. `by_source`, where given,
    /// takes the same for each source of the map, whose places it must have; what is added to it is
    /// not scaled by the stride. Neither is scaled by information().
    Linearization linearize(std::span<const SurfacePoint> scan, const PointMap& map,
                            const Pose& pose, const MatchStage& stage, int stride = 1,
                            std::vector<Linearization>* by_source = nullptr) const;

    /// The pose from `start` on, in at most `iterations` Gauss-Newton steps, with nearer and nearer
    /// points. Stops where fewer than 15 points match. `first` is the step that it begins at: from
    /// kWideSteps on the points have to be near already.
    Pose fit(std::span<const SurfacePoint> scan, const PointMap& map, const Pose& start,
             const PosePrior& prior, int iterations = kMostSteps, int first = 0) const;

  private:
    double information_;
};

/// Fewest matches that say anything of a pose.
inline constexpr int kLeastMatches = 15;

}  // namespace hitos
