// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/registration/laid_drawing.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <cstddef>

#include "hitos/registration/odometry_step.hpp"
#include "hitos/registration/pose_algebra.hpp"

namespace hitos {
namespace {

double heading_from(const Point2& a, const Point2& b) {
    return std::atan2(b.y - a.y, b.x - a.x);
}

/// Where an anchor's place lies in the world, as its key does.
Point2 seen_at(std::span<const KeyPose> keys, const PoseEdge& anchor) {
    return transform(keys[anchor.to].pose, anchor.at);
}

/// By the first wall, which knows directions, else by the two points that are farthest apart from
/// the first.
double first_heading(std::span<const KeyPose> keys, std::span<const PoseEdge> anchors) {
    for (const PoseEdge& anchor : anchors) {
        if (anchor.information(2, 2) > 0.0)
            return wrap_angle(keys[anchor.to].pose.theta - anchor.z.theta);
    }
    const PoseEdge& first = anchors.front();
    double farthest = 0.0;
    double heading = 0.0;
    for (const PoseEdge& anchor : anchors) {
        const double away = std::hypot(anchor.z.x - first.z.x, anchor.z.y - first.z.y);
        if (!(away > farthest)) continue;
        farthest = away;
        heading = wrap_angle(heading_from(seen_at(keys, first), seen_at(keys, anchor)) -
                             heading_from({first.z.x, first.z.y}, {anchor.z.x, anchor.z.y}));
    }
    return heading;
}

}  // namespace

std::optional<LaidDrawing> laid_drawing(std::span<const KeyPose> keys,
                                        std::span<const PoseEdge> edges) {
    constexpr int kMostSteps = 20;
    constexpr double kStill = 1e-10;   // [m, rad]
    constexpr double kRegular = 1e-6;  // [1/m^2, 1/rad^2], as the graph's
    std::vector<PoseEdge> anchors;
    for (const PoseEdge& edge : edges) {
        if (edge.kind == EdgeKind::anchor) anchors.push_back(edge);
    }
    if (anchors.empty()) return std::nullopt;
    Point2 origin{};
    const auto count_from = [&](const Point2& place) {
        origin = {origin.x + place.x, origin.y + place.y};
        for (PoseEdge& anchor : anchors) {
            anchor.z.x -= place.x;
            anchor.z.y -= place.y;
        }
    };
    // About the first anchor's place: coordinates of surveys are millions of metres.
    count_from({anchors.front().z.x, anchors.front().z.y});
    Point2 middle{};  // of where they were seen
    for (const PoseEdge& anchor : anchors) {
        const Point2 seen = seen_at(keys, anchor);
        middle.x += seen.x / static_cast<double>(anchors.size());
        middle.y += seen.y / static_cast<double>(anchors.size());
    }
    const Point2 at = seen_at(keys, anchors.front());
    Pose pose{at.x, at.y, first_heading(keys, anchors)};
    Eigen::Matrix3d h;
    const auto solve = [&] {
        for (int step = 0; step < kMostSteps; ++step) {
            h.setZero();
            Eigen::Vector3d b = Eigen::Vector3d::Zero();
            for (const PoseEdge& anchor : anchors) {
                const EdgeError error = edge_error(anchor, pose, keys[anchor.to].pose);
                h += error.by_from.transpose() * anchor.information * error.by_from;
                b += error.by_from.transpose() * (anchor.information * error.value);
            }
            const Eigen::Matrix3d regular = h + kRegular * Eigen::Matrix3d::Identity();
            const Eigen::Vector3d move = -regular.ldlt().solve(b);
            pose = shifted(pose, move);
            if (move.norm() < kStill) break;
        }
    };
    solve();
    // Again about what was seen: a wall may be drawn by two places far from there.
    const Point2 seen = transform(inverse(pose), middle);
    count_from(seen);
    pose = compose(pose, {seen.x, seen.y, 0.0});
    solve();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> known(h, Eigen::EigenvaluesOnly);
    return LaidDrawing{compose(pose, {-origin.x, -origin.y, 0.0}), known.eigenvalues()(0) > 1.0};
}

PoseEdge edge_from_first(const PoseEdge& anchor, const KeyPose& first, const LaidDrawing& drawing) {
    PoseEdge edge = anchor;
    const Pose seen = between(first.pose, drawing.pose);
    edge.kind = EdgeKind::fix;
    edge.from = 0;
    edge.z = compose(seen, anchor.z);
    edge.information = turned(anchor.information, seen.theta);
    return edge;
}

}  // namespace hitos
