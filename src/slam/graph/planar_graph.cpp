// SPDX-License-Identifier: GPL-3.0-or-later
// The errors of edges are those of g2o's types slam2d and slam2d_addons, for which chi square is
// the same number.
#include "hitos/slam/planar_graph.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "planar_error.hpp"

namespace hitos {

std::size_t PlanarGraph::count(PlanarVertex::Kind kind) const {
    return static_cast<std::size_t>(std::ranges::count(vertices, kind, &PlanarVertex::kind));
}

std::size_t PlanarGraph::count(PlanarEdge::Kind kind) const {
    return static_cast<std::size_t>(std::ranges::count(edges, kind, &PlanarEdge::kind));
}

PlanarError planar_error(const PlanarGraph& graph, const PlanarEdge& edge) {
    using Kind = PlanarEdge::Kind;
    const PlanarVertex& from = graph.vertices[edge.from];
    const PlanarVertex& to = graph.vertices[edge.to];
    PlanarError error;
    error.information = edge.information.topLeftCorner(edge.size(), edge.size());
    switch (edge.kind) {
        case Kind::step:
        case Kind::pose_prior: {
            const PoseEdge step{0, 0, {edge.z(0), edge.z(1), edge.z(2)}};
            const EdgeError seen = edge_error(step, edge.prior() ? Pose{} : from.pose(), to.pose());
            error.value = seen.value;
            error.by_from = seen.by_from;
            error.by_to = seen.by_to;
            // The error there is in the axes of `from`.
            error.information = turned(edge.information, edge.z(2));
            break;
        }
        case Kind::point: {
            const Matrix2 turn = turn_of(-from.at(2)).topLeftCorner<2, 2>();
            const Vector2 seen = turn * (to.at - from.at).head<2>();
            error.value = seen - edge.z.head<2>();
            error.by_from.resize(2, 3);
            error.by_from << -turn, Vector2(seen(1), -seen(0));
            error.by_to = turn;
            break;
        }
        case Kind::line: {
            const Recta line{to.at(1), to.at(0)};
            const PreparedRecta prepared(line);
            error.value = Vector2(wrap_angle(line.theta - from.at(2) - edge.z(0)),
                                  -prepared.signed_distance(from.point()) - edge.z(1));
            error.by_from = SensorRecta::pose_jacobian(from.pose(), line).colwise().reverse();
            error.by_to.resize(2, 2);  // by (theta, rho)
            error.by_to << 1.0, 0.0, -prepared.along(from.point()), 1.0;
            break;
        }
        case Kind::position_prior:
        case Kind::point_prior:
            error.value = (to.at - edge.z).head<2>();
            error.by_to = Eigen::MatrixXd::Identity(2, edge.kind == Kind::point_prior ? 2 : 3);
            break;
    }
    return error;
}

double mahalanobis_squared(const PlanarGraph& graph, const PlanarEdge& edge) {
    return mahalanobis_squared(planar_error(graph, edge));
}

double chi_square(const PlanarGraph& graph) {
    double sum = 0.0;
    for (const PlanarEdge& edge : graph.edges) sum += mahalanobis_squared(graph, edge);
    return sum;
}

std::vector<std::size_t> worst_edges(const PlanarGraph& graph, std::size_t most) {
    std::vector<double> errors;
    for (const PlanarEdge& edge : graph.edges) errors.push_back(mahalanobis_squared(graph, edge));
    std::vector<std::size_t> order(errors.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    most = std::min(most, order.size());
    const auto middle = order.begin() + static_cast<std::ptrdiff_t>(most);
    std::partial_sort(order.begin(), middle, order.end(), [&](std::size_t a, std::size_t b) {
        return std::pair(-errors[a], a) < std::pair(-errors[b], b);
    });
    order.resize(most);
    return order;
}

}  // namespace hitos
