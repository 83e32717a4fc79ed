// SPDX-License-Identifier: GPL-3.0-or-later
// Simulated tours with what registration would say of them, for the tests of graph-slam.
#pragma once

#include <Eigen/LU>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "graph/graph_slam.hpp"
#include "hitos/registration/pose_graph_solver.hpp"
#include "hitos/registration/registered_step.hpp"

namespace hitos {

/// A wall by its ends, seen from the side on which a walker from a to b has his right hand.
struct SimWall {
    Point2 a, b;
};

/// What a scan of a wall or corner is wrong by.
struct SimNoise {
    double odometry = 1.0;  ///< times the sigmas below; 0: exact
    double features = 1.0;
    double sigma_m = 0.02;  ///< of a step
    double sigma_rad = 0.005;
    Matrix2 r = (Matrix2() << 4e-4, 0.0, 0.0, 1e-4).finished();
};

/// Takes the place of Registration: odometry places the scans, edges are odometry's, with honest
/// information, until a loop is closed. Every `scans_per_key`-th scan is a key.
class SimRegistration {
  public:
    SimRegistration(SimNoise noise, unsigned seed, int scans_per_key = 1)
        : noise_(std::move(noise)), engine_(seed), scans_per_key_(scans_per_key) {}

    RegisteredStep add(const Pose& truth) {
        RegisteredStep step;
        step.scan = truth_.size();
        if (!truth_.empty()) {
            const Pose exact = between(truth_.back(), truth);
            const double n = noise_.odometry;
            const Pose z{exact.x + n * noise_.sigma_m * normal(),
                         exact.y + n * noise_.sigma_m * normal(),
                         exact.theta + n * noise_.sigma_rad * normal()};
            step.before = path_.back();
            step.pose = compose(path_.back(), z);
            step.covariance = covariance();
            step.path_m = std::hypot(z.x, z.y);
            step.turned_rad = std::abs(z.theta);
            since_key_ = compose(since_key_, z);
            ++scans_since_key_;
        }
        truth_.push_back(truth);
        path_.push_back(step.pose);
        step.key = step.scan % static_cast<std::uint64_t>(scans_per_key_) == 0;
        if (step.key) {
            keys_.push_back({step.pose, step.scan});
            const auto key = static_cast<std::uint32_t>(keys_.size() - 1);
            if (key > 0) {
                edges_.push_back({key - 1, key, since_key_,
                                  (scans_since_key_ * covariance()).inverse(), EdgeKind::odometry});
            }
            since_key_ = {};
            scans_since_key_ = 0.0;
        }
        step.keys = keys_;
        step.edges = edges_;
        return step;
    }

    /// Ties the newest key to an earlier one, solves the graph and says what that moved.
    PathCorrection close(std::uint32_t earlier) {
        const auto newest = static_cast<std::uint32_t>(keys_.size() - 1);
        const Pose exact = between(truth_[keys_[earlier].scan], truth_[keys_[newest].scan]);
        const double n = noise_.odometry;
        edges_.push_back(
            {earlier,
             newest,
             {exact.x + n * noise_.sigma_m * normal(), exact.y + n * noise_.sigma_m * normal(),
              exact.theta + n * noise_.sigma_rad * normal()},
             covariance().inverse(),
             EdgeKind::loop});
        const std::vector<KeyPose> before = keys_;
        solve(keys_, edges_, {20, true});
        by_scan_.clear();
        for (std::size_t scan = 0, key = 0; scan < path_.size(); ++scan) {
            while (key + 1 < keys_.size() && keys_[key + 1].scan <= scan) ++key;
            const Pose motion = compose(keys_[key].pose, inverse(before[key].pose));
            by_scan_.push_back(motion);
            path_[scan] = compose(motion, path_[scan]);
        }
        return {by_scan_, keys_, edges_};
    }
    /// Takes the edges between the keys before one and the others away, as where it turns out that
    /// the robot was carried, and the three before; the newest key's stay.
    void cut(std::uint32_t begin) {
        std::erase_if(edges_, [begin](const PoseEdge& edge) {
            return edge.to <= begin && begin < edge.to + 4;
        });
    }
    PathCorrection correction() {
        by_scan_.assign(path_.size(), {});
        return {by_scan_, keys_, edges_};
    }
    const std::vector<KeyPose>& keys() const { return keys_; }
    const std::vector<PoseEdge>& edges() const { return edges_; }
    const std::vector<Pose>& path() const { return path_; }

  private:
    Matrix3 covariance() const {
        const double m = noise_.sigma_m * noise_.sigma_m;
        return Eigen::Vector3d(m, m, noise_.sigma_rad * noise_.sigma_rad).asDiagonal();
    }
    double normal() { return normal_(engine_); }

    SimNoise noise_;
    std::mt19937 engine_;
    std::normal_distribution<double> normal_;
    int scans_per_key_;
    std::vector<Pose> truth_;
    std::vector<Pose> path_;
    std::vector<KeyPose> keys_;
    std::vector<PoseEdge> edges_;
    std::vector<Pose> by_scan_;
    Pose since_key_;
    double scans_since_key_ = 0.0;
};

/// Walls as a scan shows them: each as one line over the part within range, and the corners.
class SimScanner {
  public:
    SimScanner(std::vector<SimWall> walls, std::vector<Esquina> corners, SimNoise noise,
               unsigned seed)
        : walls_(std::move(walls)),
          corners_(std::move(corners)),
          noise_(std::move(noise)),
          engine_(seed) {}

    Observation look(const Pose& pose, double range_m = 6.0) {
        Observation seen;
        const Pose world_to_robot = inverse(pose);
        for (const SimWall& wall : walls_) {
            const double length = std::hypot(wall.b.x - wall.a.x, wall.b.y - wall.a.y);
            const double tx = (wall.b.x - wall.a.x) / length;
            const double ty = (wall.b.y - wall.a.y) / length;
            const double away = tx * (pose.y - wall.a.y) - ty * (pose.x - wall.a.x);
            if (away > -0.05 || away < -range_m) continue;  // behind, or far
            const double foot = tx * (pose.x - wall.a.x) + ty * (pose.y - wall.a.y);
            const double reach = std::sqrt(range_m * range_m - away * away);
            const double low = std::max(0.0, foot - reach);
            const double high = std::min(length, foot + reach);
            if (high - low < 0.5) continue;
            Recta line =
                line_through(transform(world_to_robot, wall.a), transform(world_to_robot, wall.b));
            line.rho += noise_.features * std::sqrt(noise_.r(0, 0)) * normal_(engine_);
            line.theta += noise_.features * std::sqrt(noise_.r(1, 1)) * normal_(engine_);
            const auto first = static_cast<std::uint32_t>(seen.support.size());
            for (const double t : {low, 0.5 * (low + high), high}) {
                seen.support.push_back(
                    transform(world_to_robot, Point2{wall.a.x + t * tx, wall.a.y + t * ty}));
            }
            seen.lines.push_back({normalized(line), first, 3});
        }
        for (const Esquina& corner : corners_) {
            const Esquina local = transform(world_to_robot, corner);
            Vector2 z = SensorEsquina::measurement(local);
            if (z(0) > range_m || z(0) < 0.3) continue;
            z(0) += noise_.features * std::sqrt(noise_.r(0, 0)) * normal_(engine_);
            z(1) += noise_.features * std::sqrt(noise_.r(1, 1)) * normal_(engine_);
            seen.corners.push_back(SensorEsquina::inverse({}, z));
        }
        return seen;
    }

  private:
    std::vector<SimWall> walls_;
    std::vector<Esquina> corners_;
    SimNoise noise_;
    std::mt19937 engine_;
    std::normal_distribution<double> normal_;
};

/// The inside of a rectangular building and the outside of its core: a corridor all round.
inline std::vector<SimWall> corridor_walls() {
    return {{{0, 12}, {20, 12}}, {{20, 12}, {20, 0}}, {{20, 0}, {0, 0}}, {{0, 0}, {0, 12}},
            {{17, 9}, {3, 9}},   {{17, 3}, {17, 9}},  {{3, 3}, {17, 3}}, {{3, 9}, {3, 3}}};
}
inline std::vector<Esquina> corridor_corners() {
    return {{0, 0}, {20, 0}, {20, 12}, {0, 12}, {3, 3}, {17, 3}, {17, 9}, {3, 9}};
}

/// Poses `step_m` apart once round the corridor, and `more` steps of the way again.
inline std::vector<Pose> corridor_path(double step_m, int more) {
    const std::vector<Point2> stops{{1.5, 1.5}, {18.5, 1.5}, {18.5, 10.5}, {1.5, 10.5}};
    std::vector<Pose> path;
    for (std::size_t side = 0; side < 5; ++side) {
        const Point2 a = stops[side % 4];
        const Point2 b = stops[(side + 1) % 4];
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        const double heading = std::atan2(b.y - a.y, b.x - a.x);
        for (int i = 0; i * step_m < length - 1e-9; ++i) {
            if (side == 4 && i > more) return path;
            const double t = i * step_m / length;
            path.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), heading});
        }
    }
    return path;
}

/// Poses as seen from the first of them, which is where the world of a run begins.
inline std::vector<Pose> from_first(std::vector<Pose> path) {
    const Pose first = path.front();
    for (Pose& pose : path) pose = between(first, pose);
    return path;
}

/// A run of graph-slam over a path.
struct GraphRun {
    SimRegistration registration;
    SimScanner scanner;
    GraphSlam filter;

    GraphRun(const FilterParams& params, const SimNoise& noise, unsigned seed,
             std::vector<SimWall> walls, std::vector<Esquina> corners, int scans_per_key = 1)
        : registration(noise, seed, scans_per_key),
          scanner(std::move(walls), std::move(corners), noise, seed + 1000),
          filter(params) {}

    void step(const Pose& truth) {
        const Scan scan;
        const Observation seen = scanner.look(truth);
        const RegisteredStep registered = registration.add(truth);
        filter.step({scan, {}, seen, &registered});
    }
    void drive(const std::vector<Pose>& path) {
        for (const Pose& pose : path) step(pose);
    }
};

inline FilterParams graph_params(const SimNoise& noise = {}) {
    FilterParams params;
    params.algorithm = "graph-slam";
    params.observation = {noise.r(0, 0), noise.r(1, 1)};
    return params;
}

}  // namespace hitos
