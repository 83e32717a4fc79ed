// Observation models of the laser: lines and corners as the robot sees them [T 7.4.2].
//
// The printed Jacobians [T eq 7.22, 7.26] and inverses [T eq 7.23, 7.27] contain errors; the ones
// here are derived in docs/algorithm.md and tested against numerical differentiation.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <concepts>

#include "hitos/features/caracteristica.hpp"

namespace hitos {

using Vector2 = Eigen::Vector2d;
using Matrix2 = Eigen::Matrix2d;
using Matrix23 = Eigen::Matrix<double, 2, 3>;
using Matrix3 = Eigen::Matrix3d;

/// What an observation says against the prediction: z - h, with the angle wrapped, and
/// dh/d(landmark).
struct Innovation {
    Vector2 nu;
    Matrix2 jacobian;
};

/// Lines: z = (rho' [m], theta' [rad]) in the robot frame,
/// h = (rho - x cos theta - y sin theta, theta - theta_r) [T eq 7.25].
struct SensorRecta {
    using Landmark = Recta;
    static constexpr FeatureKind kKind = FeatureKind::line;

    static Vector2 measurement(const Recta& observed) { return {observed.rho, observed.theta}; }

    /// h, as it comes: rho may be negative and the angle unwrapped.
    static Vector2 predict(const Pose& pose, const Recta& landmark) {
        return {
            landmark.rho - pose.x * std::cos(landmark.theta) - pose.y * std::sin(landmark.theta),
            landmark.theta - pose.theta};
    }

    /// dh/d(rho, theta) = [1, x sin theta - y cos theta; 0, 1].
    static Matrix2 jacobian(const Pose& pose, const Recta& landmark) {
        Matrix2 h;
        h << 1.0, pose.x * std::sin(landmark.theta) - pose.y * std::cos(landmark.theta), 0.0, 1.0;
        return h;
    }

    /// dh/d(x, y, theta_r).
    static Matrix23 pose_jacobian(const Pose& /*pose*/, const Recta& landmark) {
        Matrix23 h;
        h << -std::cos(landmark.theta), -std::sin(landmark.theta), 0.0, 0.0, 0.0, -1.0;
        return h;
    }

    /// Where observed and predicted normal differ by more than pi/2 the prediction is flipped,
    /// (rho, theta) -> (-rho, theta + pi), and its Jacobian's first row with it: a wall seen from
    /// its other side is the same line.
    static Innovation innovation(const Vector2& z, const Pose& pose, const Recta& landmark) {
        return innovation(z, pose, landmark, std::cos(landmark.theta), std::sin(landmark.theta));
    }

    /// The same with the cosine and sine of the landmark's theta at hand.
    static Innovation innovation(const Vector2& z, const Pose& pose, const Recta& landmark,
                                 double c, double s) {
        const double h_rho = landmark.rho - pose.x * c - pose.y * s;
        const double lever = pose.x * s - pose.y * c;
        const double turn = wrap_angle(z(1) - landmark.theta + pose.theta);
        Innovation result;
        if (std::abs(turn) > kPi / 2.0) {
            result.nu << z(0) + h_rho, turn - std::copysign(kPi, turn);
            result.jacobian << -1.0, -lever, 0.0, 1.0;
        } else {
            result.nu << z(0) - h_rho, turn;
            result.jacobian << 1.0, lever, 0.0, 1.0;
        }
        return result;
    }

    /// The landmark that gives z from the pose, theta = theta' + theta_r,
    /// rho = rho' + x cos theta + y sin theta, before it is brought to normal form.
    static Recta inverse(const Pose& pose, const Vector2& z) {
        const double theta = z(1) + pose.theta;
        return {z(0) + pose.x * std::cos(theta) + pose.y * std::sin(theta), theta};
    }

    /// d(inverse)/dz.
    static Matrix2 inverse_jacobian(const Pose& pose, const Vector2& z) {
        const double theta = z(1) + pose.theta;
        Matrix2 g;
        g << 1.0, pose.y * std::cos(theta) - pose.x * std::sin(theta), 0.0, 1.0;
        return g;
    }

    /// d(inverse)/d(x, y, theta_r).
    static Matrix23 inverse_pose_jacobian(const Pose& pose, const Vector2& z) {
        const double theta = z(1) + pose.theta;
        Matrix23 g;
        g << std::cos(theta), std::sin(theta), pose.y * std::cos(theta) - pose.x * std::sin(theta),
            0.0, 0.0, 1.0;
        return g;
    }

    /// Brings a line and its covariance to normal form; returns the sign that rho took (-1 where
    /// the line was flipped), which its row and column of a larger covariance take too.
    static double normalize(Recta& landmark, Matrix2& covariance) {
        const double sign = landmark.rho < 0.0 ? -1.0 : 1.0;
        landmark = normalized(landmark);
        covariance(0, 1) *= sign;
        covariance(1, 0) *= sign;
        return sign;
    }

    static Recta from_state(const Vector2& state) { return {state(0), state(1)}; }
    static Vector2 to_state(const Recta& landmark) { return {landmark.rho, landmark.theta}; }
};

/// Corners: z = (range [m], bearing [rad]) [T eq 7.21]. A corner nearer than 1 mm to the robot
/// counts as 1 mm away: its bearing means nothing.
struct SensorEsquina {
    using Landmark = Esquina;
    static constexpr FeatureKind kKind = FeatureKind::corner;
    static constexpr double kNearest = 1e-3;

    static Vector2 measurement(const Esquina& observed) {
        return {std::hypot(observed.x, observed.y), std::atan2(observed.y, observed.x)};
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

    static double normalize(Esquina& /*landmark*/, Matrix2& /*covariance*/) { return 1.0; }
    static Esquina from_state(const Vector2& state) { return {state(0), state(1)}; }
    static Vector2 to_state(const Esquina& landmark) { return {landmark.x, landmark.y}; }
};

/// What a filter needs of an observation model of two dimensions. A new kind of landmark is one
/// such type and an entry in the filters' type lists.
template <class S>
concept Sensor = requires(const Pose& pose, const Vector2& z, const typename S::Landmark& landmark,
                          typename S::Landmark& writable, Matrix2& covariance) {
    { S::measurement(landmark) } -> std::convertible_to<Vector2>;
    { S::predict(pose, landmark) } -> std::convertible_to<Vector2>;
    { S::jacobian(pose, landmark) } -> std::convertible_to<Matrix2>;
    { S::pose_jacobian(pose, landmark) } -> std::convertible_to<Matrix23>;
    { S::innovation(z, pose, landmark) } -> std::same_as<Innovation>;
    { S::inverse(pose, z) } -> std::same_as<typename S::Landmark>;
    { S::inverse_jacobian(pose, z) } -> std::convertible_to<Matrix2>;
    { S::inverse_pose_jacobian(pose, z) } -> std::convertible_to<Matrix23>;
    { S::normalize(writable, covariance) } -> std::same_as<double>;
};
static_assert(Sensor<SensorRecta> && Sensor<SensorEsquina>);

/// z - h with both Jacobians of h, by the pose (x, y, theta) and by the landmark, on the side from
/// which the landmark was seen.
struct JointInnovation {
    Vector2 nu;
    Matrix23 by_pose;
    Matrix2 by_landmark;
};

/// Where a line's prediction is flipped the first row of the pose's Jacobian turns its sign too.
template <Sensor S>
JointInnovation joint_innovation(const Vector2& z, const Pose& pose,
                                 const typename S::Landmark& landmark) {
    const Innovation seen = S::innovation(z, pose, landmark);
    JointInnovation joint{seen.nu, S::pose_jacobian(pose, landmark), seen.jacobian};
    if constexpr (S::kKind == FeatureKind::line) {
        if (seen.jacobian(0, 0) < 0.0) joint.by_pose.row(0) *= -1.0;
    }
    return joint;
}

}  // namespace hitos
