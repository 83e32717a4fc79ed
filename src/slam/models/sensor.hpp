// SPDX-License-Identifier: GPL-3.0-or-later
// What the kinds of landmarks have in common [T 7.4.2, 9.2.4].
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "hitos/features/caracteristica.hpp"
#include "hitos/features/observation.hpp"
#include "landmark_index.hpp"
#include "lanes.hpp"

namespace hitos {

using Vector2 = Eigen::Vector2d;
using Matrix2 = Eigen::Matrix2d;
using Matrix23 = Eigen::Matrix<double, 2, 3>;
using Matrix3 = Eigen::Matrix3d;

/// What a landmark, or an observation, has for an identity that is not known.
inline constexpr std::int32_t kNameless = LandmarkSighting::kNameless;

/// Whether both may be one by what is known of their identities.
inline bool may_be_one(std::int32_t a, std::int32_t b) {
    return a == b || a == kNameless || b == kNameless;
}

/// An observed feature: z and its covariance R, (rho, theta) [m, rad] of a line, (range, bearing)
/// [m, rad] of a corner, in the robot frame.
struct Measurement {
    Vector2 z;
    Matrix2 r;
    std::int32_t identity = kNameless;  ///< the landmark that it is of, where that is known
};

/// What an observation says against the prediction: z - h, with the angle wrapped, and
/// dh/d(landmark).
struct Innovation {
    Vector2 nu;
    Matrix2 jacobian;
};

/// z - h with both Jacobians of h, by the pose (x, y, theta) and by the landmark, on the side from
/// which the landmark was seen.
struct JointInnovation {
    Vector2 nu;
    Matrix23 by_pose;
    Matrix2 by_landmark;
};

/// A landmark's estimate: mean and covariance, in world coordinates.
template <class S>
struct LandmarkEstimate {
    typename S::Landmark mean;
    Matrix2 covariance;
};

/// Between which points of the robot's frame a feature was seen, where that is known: the feet of a
/// line's outermost supporting points.
struct SeenReach {
    bool known = false;
    bool sided = false;  ///< whether it matters from which side
    Point2 from;
    Point2 to;
};

/// A measurement, the same for all particles.
struct SeenFeature {
    Measurement measured;
    double slack = 0.0;  ///< squared Mahalanobis distance from which no landmark can be it
    SeenReach reach = {};
    double cosine = 1.0;  ///< of its angle
    double sine = 0.0;
};

/// Where on a landmark something was seen: of a line the places along it [m], from its foot
/// (PreparedRecta::along()), the whole line where nothing is known; and from which side: 1 from
/// where its normal comes, -1 from where it goes to, 0 where that does not matter. Corners have
/// none.
struct Extent {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    double side = 0.0;

    double middle() const { return 0.5 * (low + high); }
    double length() const { return high - low; }
    /// Both and what lies between.
    Extent joined(const Extent& other) const {
        return {std::min(low, other.low), std::max(high, other.high),
                side == other.side ? side : 0.0};
    }
    /// How far apart the two are [m]; 0 or less where they overlap.
    double gap(const Extent& other) const {
        return std::max(low, other.low) - std::min(high, other.high);
    }
    bool opposite(const Extent& other) const { return side * other.side < 0.0; }
};

/// What is kept of a landmark beside its estimate.
struct LandmarkRecord {
    std::int32_t observations = 0;
    std::uint32_t last_seen = 0;   ///< scan that saw it last
    std::uint32_t first_seen = 0;  ///< scan that saw it first
    float existence = 0.0F;        ///< log-odds, where landmarks may vanish
    std::int32_t identity = kNameless;
};

/// One landmark minus another, angles wrapped, once the other has been brought to the side of the
/// first: its first component times `sign`.
struct LandmarkDifference {
    Vector2 nu;
    double sign = 1.0;

    /// Covariance of the other on the first one's side.
    Matrix2 turned(Matrix2 covariance) const {
        covariance(0, 1) *= sign;
        covariance(1, 0) *= sign;
        return covariance;
    }
};

/// A measurement prepared for a particle: with its direction in the world, for the quick rejection.
struct PreparedObservation {
    const SeenFeature& seen;
    double cos_world = 1.0;  ///< of the line's normal, or of the corner's bearing, in the world
    double sin_world = 0.0;
};

inline LanePose lane_of(const Pose& pose) {
    return {pose.x, pose.y, pose.theta};
}
inline LaneObservation lane_of(const Measurement& measured) {
    return {measured.z(0), measured.z(1), measured.r(0, 0), measured.r(0, 1), measured.r(1, 1)};
}
inline NearQuery near_query(const PreparedObservation& observed) {
    const Matrix2& r = observed.seen.measured.r;
    return {observed.seen.measured.z(0), observed.cos_world, observed.sin_world, r(0, 0), r(1, 1),
            observed.seen.slack};
}

/// A kind of landmark of two dimensions: its observation model, what an Observation holds of it,
/// and the columns in which FastSLAM's maps keep it. A new kind is one such type and an entry in
/// LandmarkKinds.
template <class S>
concept Sensor = requires(const Pose& pose, const Vector2& z, const typename S::Landmark& landmark,
                          typename S::Landmark& writable, const Observation& observation,
                          const Matrix2& fixed, std::size_t i, const Extent& extent,
                          const SeenReach& reach) {
    { S::kKind } -> std::convertible_to<FeatureKind>;
    { S::kExtended } -> std::convertible_to<bool>;  // whether its columns end with an extent
    { S::measurement(landmark) } -> std::convertible_to<Vector2>;
    { S::count(observation) } -> std::same_as<std::size_t>;
    { S::observed(observation, i, fixed) } -> std::same_as<Measurement>;
    { S::reach(observation, i) } -> std::same_as<SeenReach>;
    { S::placed(reach, pose, landmark) } -> std::same_as<Extent>;
    { S::carried(extent, landmark, landmark) } -> std::same_as<Extent>;
    { S::moved(pose, landmark) } -> std::same_as<typename S::Landmark>;
    { S::moved(pose, landmark, extent) } -> std::same_as<Extent>;
    { S::moved_jacobian(pose, landmark) } -> std::convertible_to<Matrix2>;
    { S::difference(landmark, landmark) } -> std::same_as<LandmarkDifference>;
    { S::same(landmark, extent, landmark, extent, fixed) } -> std::same_as<bool>;
    {
        S::differ(S::glance(landmark, extent, fixed), S::glance(landmark, extent, fixed))
        } -> std::same_as<bool>;
    { S::tolerance(landmark, extent, extent) } -> std::convertible_to<Matrix2>;
    { S::predict(pose, landmark) } -> std::convertible_to<Vector2>;
    { S::jacobian(pose, landmark) } -> std::convertible_to<Matrix2>;
    { S::pose_jacobian(pose, landmark) } -> std::convertible_to<Matrix23>;
    { S::innovation(z, pose, landmark) } -> std::same_as<Innovation>;
    { S::joint_innovation(z, pose, landmark) } -> std::same_as<JointInnovation>;
    { S::greatest_variances(Matrix3()) } -> std::convertible_to<Vector2>;
    { S::inverse(pose, z) } -> std::same_as<typename S::Landmark>;
    { S::inverse_jacobian(pose, z) } -> std::convertible_to<Matrix2>;
    { S::inverse_pose_jacobian(pose, z) } -> std::convertible_to<Matrix23>;
    { S::normalize(writable) } -> std::same_as<double>;
    { S::from_state(z) } -> std::same_as<typename S::Landmark>;
    { S::to_state(landmark) } -> std::convertible_to<Vector2>;
    typename S::Lane;
    typename S::Columns;
}
&&requires(const typename S::Lane& lane, const NearQuery& query, const LanePose& pose,
           const NearReach& reach) {
    { S::index_point(lane) } -> std::same_as<IndexPoint>;
    { S::region(query, pose, reach) } -> std::same_as<NearRegion>;
};

}  // namespace hitos
