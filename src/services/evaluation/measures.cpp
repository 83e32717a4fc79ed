// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/evaluation/measures.hpp"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "nearest_landmark.hpp"
#include "reference_doubts.hpp"
#include "stamp_pairs.hpp"

namespace hitos {
namespace {

/// A landmark, by index, and the nearest reference landmark of its kind.
struct MapPair {
    std::size_t landmark = 0;
    std::size_t reference = 0;
    double distance_m = 0.0;
};

bool same_pairs(std::span<const MapPair> a, std::span<const MapPair> b) {
    return std::ranges::equal(a, b, [](const MapPair& p, const MapPair& q) {
        return p.landmark == q.landmark && p.reference == q.reference;
    });
}

std::vector<MapPair> nearest_pairs(const LandmarkMap& map, const LandmarkMap& reference) {
    const NearestLandmark nearest(reference);
    const bool identities = have_identities(map, reference);
    std::vector<MapPair> pairs;
    for (std::size_t i = 0; i < map.size(); ++i) {
        const std::optional<std::size_t> j = nearest.of(map[i], identities);
        if (j) pairs.push_back({i, *j, distance(map[i].point(), reference[*j].point())});
    }
    return pairs;
}

std::optional<MapError> error_of(std::span<const MapPair> pairs, const LandmarkMap& map,
                                 const LandmarkMap& reference) {
    if (pairs.empty()) return std::nullopt;
    MapError error;
    error.landmarks = static_cast<int>(pairs.size());
    error.without_reference = static_cast<int>(map.size() - pairs.size());
    error.reference_landmarks = static_cast<int>(reference.size());
    std::vector<char> found(reference.size(), 0);
    const bool identities = have_identities(map, reference);
    double sum = 0.0;
    for (const MapPair& pair : pairs) {
        ++(map[pair.landmark].kind() == FeatureKind::line ? error.lines : error.corners);
        if (identities || pair.distance_m <= kSameLandmark) found[pair.reference] = 1;
        sum += pair.distance_m;
        error.maximum_m = std::max(error.maximum_m, pair.distance_m);
    }
    error.mean_m = sum / error.landmarks;
    error.reference_found = static_cast<int>(std::ranges::count(found, 1));
    return error;
}

LandmarkMap moved(const LandmarkMap& map, const Pose& pose) {
    LandmarkMap out;
    out.reserve(map.size());
    for (const ICaracteristica& landmark : map) out.push_back(transform(pose, landmark));
    return out;
}

using Jacobian = Eigen::Matrix<double, 2, 3>;

/// The point of a landmark moved by `pose`, and its derivative by (x, y, theta).
std::pair<Eigen::Vector2d, Jacobian> moved_point(const ICaracteristica& landmark,
                                                 const Pose& pose) {
    Jacobian jacobian;
    if (const auto* recta = std::get_if<Recta>(&landmark.value)) {
        // The foot rho' n, with n the moved normal and rho' = rho + (x, y) n, whatever its sign.
        const double theta = recta->theta + pose.theta;
        const Eigen::Vector2d n(std::cos(theta), std::sin(theta));
        const Eigen::Vector2d across(-n.y(), n.x());
        const Eigen::Vector2d shift(pose.x, pose.y);
        const double rho = recta->rho + shift.dot(n);
        jacobian.leftCols<2>() = n * n.transpose();
        jacobian.col(2) = shift.dot(across) * n + rho * across;
        return {rho * n, jacobian};
    }
    const auto& esquina = std::get<Esquina>(landmark.value);
    const double c = std::cos(pose.theta);
    const double s = std::sin(pose.theta);
    const Eigen::Vector2d turned(c * esquina.x - s * esquina.y, s * esquina.x + c * esquina.y);
    jacobian << 1.0, 0.0, -turned.y(), 0.0, 1.0, turned.x();
    return {turned + Eigen::Vector2d(pose.x, pose.y), jacobian};
}

/// Fits the rigid motion to fixed pairs by Gauss-Newton steps that only go downhill.
class PairFit {
  public:
    PairFit(const LandmarkMap& map, const LandmarkMap& reference, std::span<const MapPair> pairs)
        : map_(map), pairs_(pairs) {
        for (const MapPair& pair : pairs) {
            const Point2 point = reference[pair.reference].point();
            targets_.emplace_back(point.x, point.y);
        }
    }

    double cost(const Pose& pose) const {
        double sum = 0.0;
        for (std::size_t i = 0; i < pairs_.size(); ++i) {
            sum += (moved_point(map_[pairs_[i].landmark], pose).first - targets_[i]).squaredNorm();
        }
        return sum;
    }

    Pose from(Pose pose) const {
        constexpr int kMostSteps = 50;
        double best = cost(pose);
        for (int i = 0; i < kMostSteps; ++i) {
            const Eigen::Vector3d full = step(pose);
            bool better = false;
            for (double part = 1.0; part > 1e-6 && !better; part /= 2.0) {
                const Pose tried{pose.x + part * full.x(), pose.y + part * full.y(),
                                 wrap_angle(pose.theta + part * full.z())};
                const double its_cost = cost(tried);
                if (its_cost < best) {
                    best = its_cost;
                    pose = tried;
                    better = true;
                }
            }
            if (!better) break;
        }
        return pose;
    }

  private:
    /// The Gauss-Newton step, without the directions that the pairs do not fix.
    Eigen::Vector3d step(const Pose& pose) const {
        constexpr double kUnfixed = 1e-12;  // of the greatest eigenvalue
        Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
        Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
        for (std::size_t i = 0; i < pairs_.size(); ++i) {
            const auto [point, jacobian] = moved_point(map_[pairs_[i].landmark], pose);
            normal += jacobian.transpose() * jacobian;
            gradient += jacobian.transpose() * (point - targets_[i]);
        }
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(normal);
        const Eigen::Vector3d& values = solver.eigenvalues();  // ascending
        Eigen::Vector3d result = Eigen::Vector3d::Zero();
        for (Eigen::Index k = 0; k < 3; ++k) {
            if (!(values[k] > kUnfixed * values[2])) continue;
            const Eigen::Vector3d direction = solver.eigenvectors().col(k);
            result -= direction * (direction.dot(gradient) / values[k]);
        }
        return result;
    }

    const LandmarkMap& map_;
    std::span<const MapPair> pairs_;
    std::vector<Eigen::Vector2d> targets_;
};

/// The rigid motion that takes points, one a column, nearest to their partners (Umeyama, 1991).
Pose rigid_alignment(const Eigen::MatrixXd& points, const Eigen::MatrixXd& partners) {
    constexpr double kSamePlace = 1e-9;  // [m] positions this near fix no rotation
    const Eigen::Vector2d mean = points.rowwise().mean();
    const Eigen::Vector2d partner_mean = partners.rowwise().mean();
    const double spread = (points.colwise() - mean).squaredNorm();
    const double partner_spread = (partners.colwise() - partner_mean).squaredNorm();
    const double least = static_cast<double>(points.cols()) * kSamePlace * kSamePlace;
    // What overflows fixes no rotation either, and the decomposition cannot take it.
    if (spread <= least || !std::isfinite(spread) || !std::isfinite(partner_spread)) {
        const Eigen::Vector2d shift = partner_mean - mean;
        return {shift.x(), shift.y(), 0.0};
    }
    const Eigen::Matrix3d motion = Eigen::umeyama(points, partners, false);
    return {motion(0, 2), motion(1, 2), wrap_angle(std::atan2(motion(1, 0), motion(0, 0)))};
}

/// That of the points of namesakes; none where there are none.
Pose alignment_of(std::span<const MapPair> pairs, const LandmarkMap& map,
                  const LandmarkMap& reference) {
    std::vector<std::pair<Point2, Point2>> named;
    for (const MapPair& pair : pairs) {
        if (map[pair.landmark].identity < 0) continue;
        named.emplace_back(map[pair.landmark].point(), reference[pair.reference].point());
    }
    if (named.empty()) return {};
    const auto count = static_cast<Eigen::Index>(named.size());
    Eigen::MatrixXd points(2, count);
    Eigen::MatrixXd partners(2, count);
    for (Eigen::Index k = 0; k < count; ++k) {
        const auto& [own, there] = named[static_cast<std::size_t>(k)];
        points.col(k) << own.x, own.y;
        partners.col(k) << there.x, there.y;
    }
    return rigid_alignment(points, partners);
}

}  // namespace

bool have_identities(const LandmarkMap& map, const LandmarkMap& reference) {
    const auto said = [](const ICaracteristica& landmark) { return landmark.identity >= 0; };
    return std::ranges::any_of(map, said) && std::ranges::any_of(reference, said);
}

std::optional<MapError> map_error(const LandmarkMap& map, const LandmarkMap& reference) {
    return error_of(nearest_pairs(map, reference), map, reference);
}

std::optional<AlignedMapError> aligned_map_error(const LandmarkMap& map,
                                                 const LandmarkMap& reference) {
    // Every round lowers the sum of squares, so that it ends; the limit is for rounding alone.
    constexpr int kMostRounds = 200;
    std::vector<MapPair> pairs = nearest_pairs(map, reference);
    if (pairs.empty()) return std::nullopt;
    // Who says which landmark is which need not be near it to begin with.
    Pose pose;
    if (have_identities(map, reference)) pose = alignment_of(pairs, map, reference);
    for (int round = 0; round < kMostRounds; ++round) {
        pose = PairFit(map, reference, pairs).from(pose);
        std::vector<MapPair> next = nearest_pairs(moved(map, pose), reference);
        const bool settled = same_pairs(next, pairs);
        pairs = std::move(next);
        if (settled) break;
    }
    const AlignedMapError aligned{pose, *error_of(pairs, map, reference)};
    // Squares were lowered, of pairs that a wrong reference leaves far apart; the mean may not be.
    const auto there = map_error(map, reference);
    if (there && there->mean_m < aligned.error.mean_m) return AlignedMapError{Pose{}, *there};
    return aligned;
}

std::optional<TrajectoryError> trajectory_error(const Trajectory& estimate,
                                                const Trajectory& reference, double tolerance_s) {
    const auto pairs = matched_by_stamp(estimate, reference, tolerance_s);
    if (pairs.empty()) return std::nullopt;
    const auto count = static_cast<Eigen::Index>(pairs.size());
    Eigen::MatrixXd points(2, count);
    Eigen::MatrixXd partners(2, count);
    for (Eigen::Index k = 0; k < count; ++k) {
        const auto& [i, there] = pairs[static_cast<std::size_t>(k)];
        const Pose& own = estimate[i].pose;
        points.col(k) << own.x, own.y;
        partners.col(k) << there.x, there.y;
    }
    TrajectoryError error;
    error.poses = static_cast<int>(pairs.size());
    error.pose_reference_estimate = rigid_alignment(points, partners);
    double squares = 0.0;
    double heading_squares = 0.0;
    for (const auto& [i, there] : pairs) {
        const Pose own = compose(error.pose_reference_estimate, estimate[i].pose);
        const double away = std::hypot(own.x - there.x, own.y - there.y);
        squares += away * away;
        error.mean_m += away / error.poses;
        error.maximum_m = std::max(error.maximum_m, away);
        const double turn = wrap_angle(own.theta - there.theta);
        heading_squares += turn * turn;
    }
    error.rmse_m = std::sqrt(squares / error.poses);
    if (fit_of_headings(estimate, pairs).told())
        error.heading_rmse_rad = std::sqrt(heading_squares / error.poses);
    return error;
}

}  // namespace hitos
