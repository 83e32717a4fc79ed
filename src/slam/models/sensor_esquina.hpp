// SPDX-License-Identifier: GPL-3.0-or-later
// Corners as the robot sees them [T 7.4.2].
//
// The Jacobian is [T eq 7.22]; the printed inverse [T eq 7.23] contains an error. Both are tested
// against numerical differentiation.
#pragma once

#include <algorithm>
#include <cmath>

#include "landmark_columns.hpp"

namespace hitos {

class CornerColumns;

/// What the filter reckons with of a corner.
struct CornerLane {
    static constexpr std::size_t kSize = 5;
    double x;
    double y;
    LaneCovariance p;

    static CornerLane of(const Esquina& mean, const LaneCovariance& covariance) {
        return {mean.x, mean.y, covariance};
    }
    HITOS_INLINE static CornerLane load(const double* from, std::size_t stride) {
        return {from[0], from[stride], LaneCovariance::load(from, stride)};
    }
    HITOS_INLINE void store(double* to, std::size_t stride) const {
        to[0] = x;
        to[stride] = y;
        p.store(to, stride);
    }
};

/// Corners: z = (range [m], bearing [rad]) [T eq 7.21]. A corner nearer than 1 mm to the robot
/// counts as 1 mm away: its bearing means nothing.
struct SensorEsquina {
    using Landmark = Esquina;
    using Lane = CornerLane;
    using Columns = CornerColumns;
    static constexpr FeatureKind kKind = FeatureKind::corner;
    static constexpr bool kExtended = false;
    static constexpr double kNearest = 1e-3;

    static Vector2 measurement(const Esquina& observed) {
        return {std::hypot(observed.x, observed.y), std::atan2(observed.y, observed.x)};
    }

    static std::size_t count(const Observation& observation) { return observation.corners.size(); }
    /// R is that of the corner's own covariance where the observation has it, else `fixed`.
    static Measurement observed(const Observation& observation, std::size_t i,
                                const Matrix2& fixed) {
        const Esquina& corner = observation.corners[i];
        Measurement measured{measurement(corner), fixed, observation.identity(i)};
        // The bearing of a corner right at the robot means nothing.
        if (i < observation.corner_covariances.size() && measured.z(0) >= kNearest) {
            const Matrix2 j = jacobian({}, corner);  // of (range, bearing) by (x, y)
            measured.r = j * observation.corner_covariances[i] * j.transpose();
        }
        return measured;
    }

    static Vector2 predict(const Pose& pose, const Esquina& landmark) {
        const double dx = landmark.x - pose.x;
        const double dy = landmark.y - pose.y;
        return {std::sqrt(dx * dx + dy * dy), std::atan2(dy, dx) - pose.theta};
    }

    /// dh/d(mx, my) = [dx/r, dy/r; -dy/r^2, dx/r^2].
    static Matrix2 jacobian(const Pose& pose, const Esquina& landmark) {
        const double dx = landmark.x - pose.x;
        const double dy = landmark.y - pose.y;
        const double r = std::max(std::sqrt(dx * dx + dy * dy), kNearest);
        Matrix2 h;
        h << dx / r, dy / r, -dy / (r * r), dx / (r * r);
        return h;
    }

    static Matrix23 pose_jacobian(const Pose& pose, const Esquina& landmark) {
        const Matrix2 h = jacobian(pose, landmark);
        Matrix23 full;
        full << -h(0, 0), -h(0, 1), 0.0, -h(1, 0), -h(1, 1), -1.0;
        return full;
    }

    static Innovation innovation(const Vector2& z, const Pose& pose, const Esquina& landmark) {
        const Vector2 h = predict(pose, landmark);
        return {{z(0) - h(0), wrap_angle(z(1) - h(1))}, jacobian(pose, landmark)};
    }

    /// The same in lanes.
    HITOS_INLINE static LaneInnovation innovation(const CornerLane& corner, const LanePose& pose,
                                                  const LaneObservation& seen) {
        const double dx = corner.x - pose.x;
        const double dy = corner.y - pose.y;
        const double range = std::sqrt(dx * dx + dy * dy);
        const double held = range < kNearest ? kNearest : range;
        const double inverse = 1.0 / held;
        const double h00 = dx * inverse;
        const double h01 = dy * inverse;
        const double turn = elementary::wrap(seen.z1 - (elementary::angle_of(dy, dx) - pose.theta));
        return innovation_of(seen.z0 - range, turn, h00, h01, -h01 * inverse, h00 * inverse,
                             corner.p, seen);
    }
    /// The corner seen again.
    HITOS_INLINE static CornerLane updated(CornerLane corner, const LanePose& pose,
                                           const LaneObservation& seen) {
        correct(corner.x, corner.y, corner.p, innovation(corner, pose, seen));
        return corner;
    }
    /// As SensorRecta's, both sides of the tests by the range so that nothing is divided.
    HITOS_INLINE static double margin(const CornerLane& corner, const LanePose& pose,
                                      const NearQuery& seen) {
        constexpr double kNearest2 = kNearest * kNearest;
        const LaneCovariance& p = corner.p;
        const double dx = corner.x - pose.x;
        const double dy = corner.y - pose.y;
        const double range2 = dx * dx + dy * dy;
        const double held2 = range2 < kNearest2 ? kNearest2 : range2;
        const double nu = seen.z0 - std::sqrt(range2);
        const double q00 = dx * dx * p.p00 + 2.0 * dx * dy * p.p01 + dy * dy * p.p11;
        const double q11 = dy * dy * p.p00 - 2.0 * dx * dy * p.p01 + dx * dx * p.p11;
        const double cross = dy * seen.cos_world - dx * seen.sin_world;
        const double dot = dx * seen.cos_world + dy * seen.sin_world;
        // Behind the ray the angle is over pi/2: its square is above 1, the greatest of the sine.
        const double sine2 = dot < 0.0 ? range2 : cross * cross;
        const double by_range = seen.slack * (q00 + seen.r00 * held2) - nu * nu * held2;
        const double by_angle = seen.slack * (q11 + seen.r11 * held2 * held2) - sine2 * held2;
        return by_angle > 0.0 ? by_range : -1.0;
    }

    /// The index has corners where they are.
    static IndexPoint index_point(const CornerLane& corner) {
        // The greatest variance of any direction is at most their sum.
        const double spread = 1.001 * std::sqrt(std::max(corner.p.p00 + corner.p.p11, 0.0));
        return {corner.x, corner.y, spread, 0.0,
                0.1 + spread + 2e-6 * (std::abs(corner.x) + std::abs(corner.y))};
    }
    /// Around the place that the observation names. By margin()'s tests, a landmark of standard
    /// deviation sigma at a distance d and an angle t from the ray has |z0 - d| < a = s (sigma +
    /// sigma_z0), and d |sin t| < s (sigma + sigma_z1 d) where it is in front of the robot: then it
    /// is no farther from that place than a + sqrt(2) d |sin t|. Behind the robot, d < s sigma /
    /// sqrt(1 - (s sigma_z1)^2), and it is no farther than 2 d + a.
    static NearRegion region(const NearQuery& seen, const LanePose& pose, const NearReach& reach) {
        constexpr double kRoot2 = 1.4143;
        constexpr double kSurest = 0.7;  // of s sigma_z1: the root above is not below it then
        const double u = pose.x + seen.z0 * seen.cos_world;
        const double v = pose.y + seen.z0 * seen.sin_world;
        const double radius =
            reach.z1 < kSurest
                ? reach.z0 + kRoot2 * reach.z1 * (seen.z0 + reach.z0) + 3.0 * kNearest
                : std::numeric_limits<double>::infinity();
        return {u, v, radius, reach.distance * (1.0 + 2.0 / kSurest + kRoot2 * reach.z1), 0.0};
    }

    static JointInnovation joint_innovation(const Vector2& z, const Pose& pose,
                                            const Esquina& landmark) {
        const Innovation seen = innovation(z, pose, landmark);
        return {seen.nu, pose_jacobian(pose, landmark), seen.jacobian};
    }

    /// As SensorRecta's; the bearing of a corner at hand may be anything.
    static Vector2 greatest_variances(const Matrix3& pose_covariance) {
        return {pose_covariance(0, 0) + pose_covariance(1, 1),
                std::numeric_limits<double>::infinity()};
    }

    static Esquina inverse(const Pose& pose, const Vector2& z) {
        return {pose.x + z(0) * std::cos(z(1) + pose.theta),
                pose.y + z(0) * std::sin(z(1) + pose.theta)};
    }

    static Matrix2 inverse_jacobian(const Pose& pose, const Vector2& z) {
        const double c = std::cos(z(1) + pose.theta);
        const double s = std::sin(z(1) + pose.theta);
        Matrix2 g;
        g << c, -z(0) * s, s, z(0) * c;
        return g;
    }

    static Matrix23 inverse_pose_jacobian(const Pose& pose, const Vector2& z) {
        Matrix23 g;
        g << 1.0, 0.0, -z(0) * std::sin(z(1) + pose.theta), 0.0, 1.0,
            z(0) * std::cos(z(1) + pose.theta);
        return g;
    }

    static double normalize(Esquina& /*landmark*/) { return 1.0; }
    static Esquina from_state(const Vector2& state) { return {state(0), state(1)}; }
    static Vector2 to_state(const Esquina& landmark) { return {landmark.x, landmark.y}; }

    static SeenReach reach(const Observation& /*observation*/, std::size_t /*i*/) { return {}; }
    static Extent placed(const SeenReach& /*reach*/, const Pose& /*pose*/,
                         const Esquina& /*landmark*/) {
        return {};
    }
    static Extent carried(const Extent& extent, const Esquina& /*from*/, const Esquina& /*to*/) {
        return extent;
    }
    static Esquina moved(const Pose& motion, const Esquina& landmark) {
        return transform(motion, landmark);
    }
    static Matrix2 moved_jacobian(const Pose& motion, const Esquina& /*landmark*/) {
        Matrix2 turn;
        turn << std::cos(motion.theta), -std::sin(motion.theta), std::sin(motion.theta),
            std::cos(motion.theta);
        return turn;
    }
    static Extent moved(const Pose& /*motion*/, const Esquina& /*landmark*/, const Extent& extent) {
        return extent;
    }
    static LandmarkDifference difference(const Esquina& a, const Esquina& b) {
        return {{a.x - b.x, a.y - b.y}, 1.0};
    }
    /// As SensorRecta's: corners nearer to each other than any two that are told apart.
    static bool same(const Esquina& a, const Extent& /*extent_a*/, const Esquina& b,
                     const Extent& /*extent_b*/, const Matrix2& /*covariance*/) {
        return std::hypot(a.x - b.x, a.y - b.y) < kNear;
    }
    using Glance = Esquina;
    static Glance glance(const Esquina& corner, const Extent& /*extent*/,
                         const Matrix2& /*covariance*/) {
        return corner;
    }
    static bool differ(const Glance& a, const Glance& b) { return std::abs(a.x - b.x) >= kNear; }
    static Matrix2 tolerance(const Esquina& /*a*/, const Extent& /*extent_a*/,
                             const Extent& /*b_on_a*/) {
        constexpr double kDistance2 = 0.05 * 0.05;
        return kDistance2 * Matrix2::Identity();
    }

  private:
    static constexpr double kNear = 0.25;  // of corners that are the same [m]
};

/// Corners of one map.
class CornerColumns : public LandmarkColumns<SensorEsquina, 0> {
  public:
    using LandmarkColumns::LandmarkColumns;

    Extent extent(std::size_t /*i*/) const { return {}; }
    void set_extent(std::size_t /*i*/, const Extent& /*extent*/) {}
};

static_assert(Sensor<SensorEsquina>);

}  // namespace hitos
