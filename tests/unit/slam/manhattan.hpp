// SPDX-License-Identifier: GPL-3.0-or-later
// Made worlds of streets at right angles (as Olson, 2008): graphs of which the truth is known.
#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "hitos/base/geometry.hpp"
#include "hitos/base/random_stream.hpp"
#include "hitos/features/caracteristica.hpp"
#include "hitos/slam/planar_graph.hpp"

namespace hitos::test {

struct Manhattan {
    int poses = 3500;
    double half_m = 20.0;  ///< of the town's side
    double sigma_m = 0.05;
    double sigma_rad = 0.02;
    int points = 0;
    int lines = 0;
    std::uint64_t seed = 1;
};

/// A robot that drives from crossing to crossing, a metre each, and knows places where it was
/// before; poses stand where its odometry alone has them, landmarks where they are first seen.
class ManhattanWorld {
  public:
    explicit ManhattanWorld(const Manhattan& how)
        : how_(how), random_(how.seed, RandomPurpose::odometry_noise, 0, 0) {
        drive();
        see_points();
        see_lines();
    }

    PlanarGraph graph;
    std::vector<Pose> truth;

  private:
    double noise(double sigma) { return sigma * random_.normal_pair()[0]; }
    bool coin() { return random_.uniform() < 0.5; }

    Pose noisy(const Pose& pose) {
        return {pose.x + noise(how_.sigma_m), pose.y + noise(how_.sigma_m),
                wrap_angle(pose.theta + noise(how_.sigma_rad))};
    }

    std::uint32_t add_vertex(PlanarVertex::Kind kind, const Eigen::Vector3d& at) {
        PlanarVertex& vertex = graph.vertices.emplace_back();
        vertex.kind = kind;
        vertex.id = graph.vertices.size() - 1;
        vertex.at = at;
        return static_cast<std::uint32_t>(vertex.id);
    }

    void add_edge(PlanarEdge::Kind kind, std::uint32_t from, std::uint32_t to,
                  const Eigen::Vector3d& z, const Eigen::Vector3d& sigmas) {
        PlanarEdge& edge = graph.edges.emplace_back();
        edge.kind = kind;
        edge.from = from;
        edge.to = to;
        edge.z = z;
        edge.information.diagonal() = sigmas.cwiseAbs2().cwiseInverse();
    }

    Pose add_step(std::uint32_t from, std::uint32_t to) {
        const Pose z = noisy(between(truth[from], truth[to]));
        add_edge(PlanarEdge::Kind::step, from, to, {z.x, z.y, z.theta},
                 {how_.sigma_m, how_.sigma_m, how_.sigma_rad});
        return z;
    }

    void drive() {
        std::map<std::pair<long, long>, std::vector<std::uint32_t>> been;
        for (int k = 0; k < how_.poses; ++k) {
            const auto i = static_cast<std::uint32_t>(k);
            truth.push_back(i == 0 ? Pose{} : next(truth.back()));
            Pose start = truth.front();
            if (i > 0) start = compose(graph.vertices.back().pose(), add_step(i - 1, i));
            add_vertex(PlanarVertex::Kind::pose, {start.x, start.y, start.theta});
            auto& here = been[{std::lround(truth[i].x), std::lround(truth[i].y)}];
            if (!here.empty() && i - here.back() > 5) add_step(here.back(), i);
            here.push_back(i);
        }
        graph.vertices.front().fixed = true;
    }

    Pose next(const Pose& from) {
        const bool turn = random_.uniform() < 0.3;
        Pose pose =
            compose(from, {1.0, 0.0, turn ? std::copysign(kPi / 2.0, coin() ? 1 : -1) : 0.0});
        while (leaves(pose)) pose.theta = wrap_angle(pose.theta + kPi / 2.0);
        return pose;
    }
    bool leaves(const Pose& pose) const {
        const Pose ahead = compose(pose, {1.0, 0.0, 0.0});
        return std::abs(ahead.x) > how_.half_m || std::abs(ahead.y) > how_.half_m;
    }

    double anywhere() { return how_.half_m * (2.0 * random_.uniform() - 1.0); }

    void see_points() {
        constexpr double kRange = 4.0;
        for (int i = 0; i < how_.points; ++i) {
            const Point2 point{anywhere(), anywhere()};
            std::uint32_t vertex = 0;
            for (std::uint32_t k = 0; k < truth.size(); ++k) {
                Point2 z = transform(inverse(truth[k]), point);
                if (std::hypot(z.x, z.y) > kRange) continue;
                z = {z.x + noise(how_.sigma_m), z.y + noise(how_.sigma_m)};
                if (vertex == 0) {
                    const Point2 start = transform(graph.vertices[k].pose(), z);
                    vertex = add_vertex(PlanarVertex::Kind::point, {start.x, start.y, 0.0});
                }
                add_edge(PlanarEdge::Kind::point, k, vertex, {z.x, z.y, 0.0},
                         Eigen::Vector3d::Constant(how_.sigma_m));
            }
        }
    }

    void see_lines() {
        constexpr double kRange = 2.0;
        for (int i = 0; i < how_.lines; ++i) {
            const Recta line{how_.half_m * random_.uniform(), coin() ? 0.0 : kPi / 2.0};
            std::uint32_t vertex = 0;
            for (std::uint32_t k = 0; k < truth.size(); ++k) {
                const double rho = -signed_distance(line, {truth[k].x, truth[k].y});
                if (std::abs(rho) > kRange) continue;
                const Eigen::Vector3d z(
                    wrap_angle(line.theta - truth[k].theta + noise(how_.sigma_rad)),
                    rho + noise(how_.sigma_m), 0.0);
                if (vertex == 0) {
                    const Pose at = graph.vertices[k].pose();
                    const double theta = wrap_angle(z(0) + at.theta);
                    vertex = add_vertex(
                        PlanarVertex::Kind::line,
                        {theta, z(1) + at.x * std::cos(theta) + at.y * std::sin(theta), 0.0});
                }
                add_edge(PlanarEdge::Kind::line, k, vertex, z, {how_.sigma_rad, how_.sigma_m, 1.0});
            }
        }
    }

    Manhattan how_;
    RandomStream random_;
};

}  // namespace hitos::test
