#include "hitos/registration/pose_graph.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "hitos/registration/normal_equations.hpp"
#include "hitos/registration/pose_algebra.hpp"

namespace hitos {

EdgeError edge_error(const PoseEdge& edge, const Pose& from, const Pose& to) {
    const double c = std::cos(from.theta);
    const double s = std::sin(from.theta);
    const double dx = to.x - from.x;
    const double dy = to.y - from.y;
    const double ahead = c * dx + s * dy;
    const double left = -s * dx + c * dy;
    EdgeError error;
    error.value << ahead - edge.z.x, left - edge.z.y,
        wrap_angle(to.theta - from.theta - edge.z.theta);
    error.by_to << c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0;
    error.by_from << -c, -s, left, s, -c, -ahead, 0.0, 0.0, -1.0;
    return error;
}

double solve(std::vector<KeyPose>& keys, std::span<const PoseEdge> edges,
             const GraphSolution& how) {
    // A key is held by 1/(0.1 mm)^2; the least information keeps the equations regular where
    // nothing says anything, and is next to none.
    constexpr double kHeld = 1e8;
    constexpr double kRegular = 1e-6;
    constexpr double kStill = 1e-3;  // [m]
    if (keys.size() < 2 || edges.empty()) return 0.0;

    NormalEquations equations;
    for (std::size_t i = 0; i < keys.size(); ++i) equations.add_variable(3);
    const std::vector<KeyPose> before = keys;
    for (int iteration = 0; iteration < how.iterations; ++iteration) {
        equations.begin();
        equations.hold(0, kHeld);
        for (std::size_t i = 1; i < keys.size(); ++i) equations.hold(i, kRegular);
        for (const PoseEdge& edge : edges) {
            const EdgeError error = edge_error(edge, keys[edge.from].pose, keys[edge.to].pose);
            const double d2 = error.value.dot(edge.information * error.value);
            const Eigen::Matrix3d weight =
                (how.robust ? robust_weight(d2) : 1.0) * edge.information;
            equations.add(edge.from, error.by_from, edge.to, error.by_to, weight, error.value);
        }
        if (!equations.solve()) break;
        double greatest = 0.0;
        for (std::size_t i = 0; i < keys.size(); ++i) {
            const auto step = equations.step(i);
            keys[i].pose = shifted(keys[i].pose, step);
            greatest = std::max(greatest, std::abs(step(0)) + std::abs(step(1)));
        }
        if (greatest < kStill) break;
    }
    double moved = 0.0;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        moved = std::max(moved, std::hypot(keys[i].pose.x - before[i].pose.x,
                                           keys[i].pose.y - before[i].pose.y));
    }
    return moved;
}

}  // namespace hitos
