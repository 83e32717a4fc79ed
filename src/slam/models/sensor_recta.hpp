// SPDX-License-Identifier: GPL-3.0-or-later
// Lines as the robot sees them [T 7.4.2].
//
// The printed Jacobian [T eq 7.26] and inverse [T eq 7.27] contain errors; the ones here are
// derived in docs/algorithm.md and tested against numerical differentiation.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "landmark_columns.hpp"

namespace hitos {

class LineColumns;

/// What the filter reckons with of a line. Cosine and sine of theta are kept beside it: it asks for
/// them at every step, and they change only when the landmark does.
struct LineLane {
    static constexpr std::size_t kSize = 7;
    double rho;
    double theta;
    LaneCovariance p;
    double cosine;
    double sine;

    static LineLane of(const Recta& mean, const LaneCovariance& covariance) {
        const auto [sine, cosine] = elementary::sine_cosine(mean.theta);
        return {mean.rho, mean.theta, covariance, cosine, sine};
    }
    HITOS_INLINE static LineLane load(const double* from, std::size_t stride) {
        return {from[0], from[stride], LaneCovariance::load(from, stride), from[5 * stride],
                from[6 * stride]};
    }
    HITOS_INLINE void store(double* to, std::size_t stride) const {
        to[0] = rho;
        to[stride] = theta;
        p.store(to, stride);
        to[5 * stride] = cosine;
        to[6 * stride] = sine;
    }
};

/// Lines: z = (rho' [m], theta' [rad]) in the robot frame,
/// h = (rho - x cos theta - y sin theta, theta - theta_r) [T eq 7.25].
struct SensorRecta {
    using Landmark = Recta;
    using Lane = LineLane;
    using Columns = LineColumns;
    static constexpr FeatureKind kKind = FeatureKind::line;
    static constexpr bool kExtended = true;

    static Vector2 measurement(const Recta& observed) { return {observed.rho, observed.theta}; }

    static std::size_t count(const Observation& observation) { return observation.lines.size(); }
    /// R is the line's own covariance where the observation has it, else `fixed`.
    static Measurement observed(const Observation& observation, std::size_t i,
                                const Matrix2& fixed) {
        return {measurement(observation.lines[i].recta),
                observation.line_covariances.empty() ? fixed : observation.line_covariances[i]};
    }

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
        const double c = std::cos(landmark.theta);
        const double s = std::sin(landmark.theta);
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

    /// The same in lanes.
    HITOS_INLINE static LaneInnovation innovation(const LineLane& line, const LanePose& pose,
                                                  const LaneObservation& seen) {
        const double h_rho = line.rho - pose.x * line.cosine - pose.y * line.sine;
        const double lever = pose.x * line.sine - pose.y * line.cosine;
        const double turn = elementary::wrap(seen.z1 - line.theta + pose.theta);
        const double half = turn < 0.0 ? -kPi : kPi;
        const bool flipped = (turn > kPi / 2.0) | (turn < -kPi / 2.0);
        const double side = flipped ? -1.0 : 1.0;
        return innovation_of(seen.z0 - side * h_rho, flipped ? turn - half : turn, side,
                             side * lever, 0.0, 1.0, line.p, seen);
    }
    /// The line seen again.
    HITOS_INLINE static LineLane updated(LineLane line, const LanePose& pose,
                                         const LaneObservation& seen) {
        correct(line.rho, line.theta, line.p, innovation(line, pose, seen));
        const bool turned = line.rho < 0.0;
        line.rho = turned ? -line.rho : line.rho;
        line.p.p01 = turned ? -line.p.p01 : line.p.p01;
        line.theta = elementary::wrap(turned ? line.theta + kPi : line.theta);
        const auto [sine, cosine] = elementary::sine_cosine(line.theta);
        line.cosine = cosine;
        line.sine = sine;
        return line;
    }
    /// Quick rejection: above 0 where the line may be what was observed. The squared Mahalanobis
    /// distance of both components is at least that of either alone, nu_i^2 / Q_ii, and
    /// |sin a| <= |a|; so a landmark that fails here cannot pass the exact test.
    HITOS_INLINE static double margin(const LineLane& line, const LanePose& pose,
                                      const NearQuery& seen) {
        const double sin_turn = line.sine * seen.cos_world - line.cosine * seen.sin_world;
        const double cos_turn = line.cosine * seen.cos_world + line.sine * seen.sin_world;
        const double h_rho = line.rho - pose.x * line.cosine - pose.y * line.sine;
        const double nu = seen.z0 - std::copysign(1.0, cos_turn) * h_rho;
        const double lever = pose.x * line.sine - pose.y * line.cosine;
        const double q00 = line.p.p00 + lever * (2.0 * line.p.p01 + lever * line.p.p11) + seen.r00;
        const double q11 = line.p.p11 + seen.r11;
        const double by_rho = seen.slack * q00 - nu * nu;
        const double by_angle = seen.slack * q11 - sin_turn * sin_turn;
        // At a right angle rounding may choose the other side than the exact test: let it through.
        const double rho = cos_turn * cos_turn < 1e-18 ? 1.0 : by_rho;
        return by_angle > 0.0 ? rho : -1.0;  // of what is no number neither is above 0
    }

    /// The index has lines where the perpendicular from the world's origin meets them: that is the
    /// same from both sides, and has no angle that jumps.
    static IndexPoint index_point(const LineLane& line) {
        const double by_rho = 1.001 * std::sqrt(std::max(line.p.p00, 0.0));
        const double by_theta = 1.001 * std::sqrt(std::max(line.p.p11, 0.0));
        return {line.rho * line.cosine, line.rho * line.sine, by_rho,
                by_theta < kSurest ? by_theta : std::numeric_limits<double>::infinity(),
                0.1 + by_rho + std::abs(line.rho) * (by_theta + 2e-6)};
    }
    /// Around that foot of the line that the observation names, (rho, phi) in the world. By
    /// margin()'s tests, a landmark of standard deviations sigma_rho and sigma_theta is turned from
    /// it, on whichever side, by |sin t| < D = s (sigma_theta + sigma_z1), |t| <= pi/2, and its
    /// distance from the robot, at p, is other than z0 by at most s (sigma_rho + |p| sigma_theta +
    /// sigma_z0). Normals are |n - n'| <= sqrt(2) |sin t| apart, so feet at most that distance and
    /// (|p| + |rho|) sqrt(2) D. Where D may reach 1 nothing is rejected; for lines of an endless
    /// spread the factor must not be 0.
    static NearRegion region(const NearQuery& seen, const LanePose& pose, const NearReach& reach) {
        constexpr double kRoot2 = 1.4143;
        const double rho = seen.z0 + pose.x * seen.cos_world + pose.y * seen.sin_world;
        const double far = std::sqrt(pose.x * pose.x + pose.y * pose.y);
        const double arm = kRoot2 * (far + std::abs(rho));
        const bool turns = reach.distance * kSurest + reach.z1 > 0.99;
        return {rho * seen.cos_world, rho * seen.sin_world,
                turns ? std::numeric_limits<double>::infinity() : reach.z0 + arm * reach.z1,
                reach.distance, reach.distance * (far + arm) + 1e-6};
    }

    /// Where the prediction is flipped the first row of the pose's Jacobian turns its sign too.
    static JointInnovation joint_innovation(const Vector2& z, const Pose& pose,
                                            const Recta& landmark) {
        const Innovation seen = innovation(z, pose, landmark);
        JointInnovation joint{seen.nu, pose_jacobian(pose, landmark), seen.jacobian};
        if (seen.jacobian(0, 0) < 0.0) joint.by_pose.row(0) *= -1.0;
        return joint;
    }

    /// The greatest variances that a pose of that covariance gives the components of any line's z.
    static Vector2 greatest_variances(const Matrix3& pose_covariance) {
        return {pose_covariance(0, 0) + pose_covariance(1, 1), pose_covariance(2, 2)};
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

    /// Brings a line to normal form; returns the sign that rho took (-1 where the line was
    /// flipped), which its row and column of every covariance take too.
    static double normalize(Recta& landmark) {
        const double sign = landmark.rho < 0.0 ? -1.0 : 1.0;
        landmark = normalized(landmark);
        return sign;
    }

    static Recta from_state(const Vector2& state) { return {state(0), state(1)}; }
    static Vector2 to_state(const Recta& landmark) { return {landmark.rho, landmark.theta}; }

    static SeenReach reach(const Observation& observation, std::size_t i) {
        const DetectedLine& line = observation.lines[i];
        const std::span<const Point2> points = observation.support_of(line);
        if (points.empty()) return {};
        const PreparedRecta prepared(line.recta);
        double low = prepared.along(points.front());
        double high = low;
        for (const Point2& point : points) {
            low = std::min(low, prepared.along(point));
            high = std::max(high, prepared.along(point));
        }
        return {true, false, prepared.at(low), prepared.at(high)};
    }
    /// Where on the landmark that is, seen from the pose: a point x, y of the robot's frame lies
    /// u.p + x u.e_x + y u.e_y along the line of direction u.
    HITOS_INLINE static Extent placed(SeenReach reach, const LanePose& pose, const LineLane& line) {
        const auto [sine, cosine] = elementary::sine_cosine(pose.theta);
        const double origin = pose.y * line.cosine - pose.x * line.sine;
        const double ahead = sine * line.cosine - cosine * line.sine;
        const double left = cosine * line.cosine + sine * line.sine;
        const double a = origin + ahead * reach.from.x + left * reach.from.y;
        const double b = origin + ahead * reach.to.x + left * reach.to.y;
        const double behind = pose.x * line.cosine + pose.y * line.sine - line.rho;
        const double side = behind > 0.0 ? -1.0 : 1.0;
        Extent seen;  // endless
        seen.low = reach.known ? (a < b ? a : b) : seen.low;
        seen.high = reach.known ? (a < b ? b : a) : seen.high;
        seen.side = reach.sided ? side : 0.0;
        return seen;
    }
    static Extent placed(const SeenReach& reach, const Pose& pose, const Recta& landmark) {
        return placed(reach, lane_of(pose), LineLane::of(landmark, {}));
    }
    /// The stretch of `from` as places along `to`. A point rho n + t u of the first has
    /// rho n.u' + t u.u' along the second, whose foot, and maybe direction, is another.
    HITOS_INLINE static Extent carried(Extent extent, const LineLane& from, const LineLane& to) {
        const double shift = from.rho * (from.sine * to.cosine - from.cosine * to.sine);
        const double along = from.cosine * to.cosine + from.sine * to.sine;
        const double a = shift + along * extent.low;
        const double b = shift + along * extent.high;
        return {a < b ? a : b, a < b ? b : a, along < 0.0 ? -extent.side : extent.side};
    }
    static Extent carried(const Extent& extent, const Recta& from, const Recta& to) {
        return carried(extent, LineLane::of(from, {}), LineLane::of(to, {}));
    }

    /// The line moved by a rigid motion of the world, before it is brought to normal form: what the
    /// inverse model does, which takes a line from the robot's frame to the world's.
    static Recta moved(const Pose& motion, const Recta& landmark) {
        return inverse(motion, measurement(landmark));
    }
    static Matrix2 moved_jacobian(const Pose& motion, const Recta& landmark) {
        return inverse_jacobian(motion, measurement(landmark));
    }
    /// Where its extent is then, along the line as moved() gives it: t + g.u'.
    static Extent moved(const Pose& motion, const Recta& landmark, const Extent& extent) {
        const double theta = landmark.theta + motion.theta;
        const double shift = motion.y * std::cos(theta) - motion.x * std::sin(theta);
        return {extent.low + shift, extent.high + shift, extent.side};
    }

    static LandmarkDifference difference(const Recta& a, const Recta& b) {
        const double angle = wrap_angle(a.theta - b.theta);
        if (std::abs(angle) <= kPi / 2.0) return {{a.rho - b.rho, angle}, 1.0};
        return {{a.rho + b.rho, angle - std::copysign(kPi, angle)}, -1.0};
    }
    /// Pieces of one wall, once a correction has laid one passage upon another: nearly parallel, by
    /// distance and angle within what a corrected path leaves, and hardly a gap between them.
    /// `covariance` is that of their difference.
    static bool same(const Recta& a, const Extent& extent_a, const Recta& b, const Extent& extent_b,
                     const Matrix2& covariance) {
        const LandmarkDifference apart = difference(a, b);
        if (std::abs(apart.nu(1)) >= kTurn) return false;
        const Extent b_on_a = carried(extent_b, b, a);
        if (extent_a.gap(b_on_a) >= kGap || extent_a.opposite(b_on_a)) return false;
        const Matrix2 s = covariance + tolerance(a, extent_a, b_on_a);
        const double d2 = s(1, 1) * apart.nu(0) * apart.nu(0) -
                          2.0 * s(0, 1) * apart.nu(0) * apart.nu(1) +
                          s(0, 0) * apart.nu(1) * apart.nu(1);
        return d2 < kFarthest2 * s.determinant();
    }
    /// What of a line tells at a glance that it is not the same() as another: most pairs are not.
    struct Glance {
        double rho;
        double cosine;
        double sine;
        double variance;  ///< of rho, with what tolerance() may add to it
    };
    static Glance glance(const Recta& line, const Extent& extent, const Matrix2& covariance) {
        // They share no place further out than this.
        const double place = std::max(std::abs(extent.low), std::abs(extent.high)) + 0.5 * kGap;
        return {line.rho, std::cos(line.theta), std::sin(line.theta),
                covariance(0, 0) + tolerance(place)(0, 0)};
    }
    /// Never of two that are the same.
    static bool differ(const Glance& a, const Glance& b) {
        if (std::abs(a.sine * b.cosine - a.cosine * b.sine) >= kTurn) return true;
        const bool turned = a.cosine * b.cosine + a.sine * b.sine < 0.0;
        const double apart = turned ? a.rho + b.rho : a.rho - b.rho;
        return apart * apart >= kFarthest2 * (a.variance + b.variance);
    }
    /// What a corrected path leaves, 0.05 m and 0.02 rad at the middle of what both extents share:
    /// a turn about a place t along the line changes rho by t times the turn.
    static Matrix2 tolerance(const Recta& /*a*/, const Extent& extent_a, const Extent& b_on_a) {
        const double middle =
            0.5 * (std::max(extent_a.low, b_on_a.low) + std::min(extent_a.high, b_on_a.high));
        return tolerance(std::isfinite(middle) ? middle : 0.0);
    }

  private:
    static constexpr double kSurest = 0.1;  // sigma_theta of lines that the index tells apart

    // Of lines that are the same: squared Mahalanobis distance, angle and gap between them.
    static constexpr double kFarthest2 = 6.0;
    static constexpr double kTurn = 0.1;
    static constexpr double kGap = 0.5;

    static Matrix2 tolerance(double t) {
        constexpr double kDistance2 = 0.05 * 0.05;
        constexpr double kAngle2 = 0.02 * 0.02;
        Matrix2 tolerated;
        tolerated << kDistance2 + t * t * kAngle2, t * kAngle2, t * kAngle2, kAngle2;
        return tolerated;
    }
};

/// Lines of one map, with their extents, where the filter heeds them.
class LineColumns : public LandmarkColumns<SensorRecta, 5> {
  public:
    static constexpr int kLow = kExtra + 2;
    static constexpr int kHigh = kExtra + 3;
    static constexpr int kSide = kExtra + 4;
    using LandmarkColumns::LandmarkColumns;

    Extent extent(std::size_t i) const {
        return {value(kLow, i), value(kHigh, i), value(kSide, i)};
    }
    void set_extent(std::size_t i, const Extent& extent) {
        Leaf& leaf = own_leaf_of(i);
        leaf.column(kLow)[i % kLeaf] = extent.low;
        leaf.column(kHigh)[i % kLeaf] = extent.high;
        leaf.column(kSide)[i % kLeaf] = extent.side;
    }
};

static_assert(Sensor<SensorRecta>);

}  // namespace hitos
