// SPDX-License-Identifier: GPL-3.0-or-later
// Where the vertices of a graph are by its edges alone.
#include <cstdint>
#include <queue>
#include <vector>

#include "planar_error.hpp"

namespace hitos {
namespace {

/// Where an edge of a pose has what it joins to it.
Eigen::Vector3d led_to(const Pose& from, const PlanarEdge& edge, bool back) {
    const Pose z{edge.z(0), edge.z(1), edge.z(2)};
    if (edge.kind == PlanarEdge::Kind::step) {
        const Pose to = compose(from, back ? inverse(z) : z);
        return {to.x, to.y, to.theta};
    }
    if (edge.kind == PlanarEdge::Kind::point) {
        const Point2 point = transform(from, Point2{z.x, z.y});
        return {point.x, point.y, 0.0};
    }
    const Recta line = SensorRecta::inverse(from, {edge.z(1), edge.z(0)});
    return {wrap_angle(line.theta), line.rho, 0.0};
}

}  // namespace

std::vector<PlanarVertex> along_edges(const PlanarGraph& graph,
                                      const std::vector<std::uint32_t>& roots) {
    std::vector<std::vector<std::uint32_t>> edges_of(graph.vertices.size());
    for (std::uint32_t i = 0; i < graph.edges.size(); ++i) {
        if (graph.edges[i].prior()) continue;
        edges_of[graph.edges[i].from].push_back(i);
        if (graph.edges[i].kind == PlanarEdge::Kind::step) {
            edges_of[graph.edges[i].to].push_back(i);
        }
    }
    std::vector<PlanarVertex> vertices = graph.vertices;
    std::vector<char> placed(vertices.size(), 0);
    std::queue<std::uint32_t> next;
    for (const std::uint32_t root : roots) {
        placed[root] = 1;
        next.push(root);
    }
    for (; !next.empty(); next.pop()) {
        const std::uint32_t from = next.front();
        for (const std::uint32_t i : edges_of[from]) {
            const PlanarEdge& edge = graph.edges[i];
            const bool back = edge.to == from;
            const std::uint32_t to = back ? edge.from : edge.to;
            if (placed[to] != 0) continue;
            placed[to] = 1;
            vertices[to].at = led_to(vertices[from].pose(), edge, back);
            next.push(to);
        }
    }
    return vertices;
}

}  // namespace hitos
