// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/drawing/graph_shape.hpp"

#include <algorithm>
#include <utility>

#include "hitos/features/caracteristica.hpp"

namespace hitos {
namespace {

/// Where the poses come in the order of their ids.
std::vector<std::size_t> ranks_of(std::span<const PlanarVertex> vertices) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        if (vertices[i].kind == PlanarVertex::Kind::pose) order.push_back(i);
    }
    std::ranges::sort(order, {}, [&](std::size_t i) { return vertices[i].id; });
    std::vector<std::size_t> ranks(vertices.size(), 0);
    for (std::size_t k = 0; k < order.size(); ++k) ranks[order[k]] = k;
    return ranks;
}

/// A line landmark from the first to the last of the poses that see it.
struct SeenLine {
    double low = 0.0;
    double high = 0.0;
    bool seen = false;
};

class GraphShaper {
  public:
    GraphShaper(std::span<const PlanarVertex> vertices, std::span<const PlanarEdge> edges)
        : vertices_(vertices), edges_(edges), seen_(vertices.size()) {}

    GraphShape shape(std::span<const std::size_t> marked) {
        add_edges();
        add_vertices();
        shape_.marked.reserve(marked.size());
        for (const std::size_t i : marked) shape_.marked.push_back(segment(edges_[i]));
        return std::move(shape_);
    }

  private:
    Point2 at(std::size_t vertex) const { return vertices_[vertex].point(); }
    PreparedRecta line_of(std::size_t vertex) const {
        const Eigen::Vector3d& value = vertices_[vertex].at;
        return PreparedRecta(Recta{value(1), value(0)});
    }
    /// Of a line, what lies before the pose that sees it.
    Point2 before(const PlanarEdge& edge) const {
        const PreparedRecta line = line_of(edge.to);
        return line.at(line.along(at(edge.from)));
    }
    GraphShape::Segment segment(const PlanarEdge& edge) const {
        if (edge.kind == PlanarEdge::Kind::line) return {at(edge.from), before(edge)};
        if (edge.prior()) return {Point2{edge.z(0), edge.z(1)}, at(edge.to)};
        return {at(edge.from), at(edge.to)};
    }

    void add_edges() {
        using Kind = PlanarEdge::Kind;
        const std::vector<std::size_t> ranks = ranks_of(vertices_);
        for (const PlanarEdge& edge : edges_) {
            const GraphShape::Segment one = segment(edge);
            if (edge.kind == Kind::step) {
                const auto [first, second] = std::minmax(ranks[edge.from], ranks[edge.to]);
                (second - first == 1 ? shape_.path : shape_.loops).push_back(one);
            } else if (edge.prior()) {
                shape_.priors.push_back(one);
            } else {
                shape_.sightings.push_back(one);
            }
            if (edge.kind != Kind::line) continue;
            shape_.bounds.hold(one[1]);
            const double along = line_of(edge.to).along(at(edge.from));
            SeenLine& line = seen_[edge.to];
            line = {line.seen ? std::min(line.low, along) : along,
                    line.seen ? std::max(line.high, along) : along, true};
        }
    }

    void add_vertices() {
        for (std::size_t i = 0; i < vertices_.size(); ++i) {
            const PlanarVertex& vertex = vertices_[i];
            if (vertex.kind == PlanarVertex::Kind::line) {
                if (!seen_[i].seen) continue;
                const PreparedRecta line = line_of(i);
                shape_.lines.push_back({line.at(seen_[i].low), line.at(seen_[i].high)});
                continue;
            }
            shape_.bounds.hold(at(i));
            if (vertex.kind == PlanarVertex::Kind::point) shape_.points.push_back(at(i));
            if (vertex.fixed) shape_.fixed.push_back(at(i));
        }
    }

    std::span<const PlanarVertex> vertices_;
    std::span<const PlanarEdge> edges_;
    std::vector<SeenLine> seen_;  // by vertex
    GraphShape shape_;
};

}  // namespace

GraphShape graph_shape(std::span<const PlanarVertex> vertices, std::span<const PlanarEdge> edges,
                       std::span<const std::size_t> marked) {
    return GraphShaper(vertices, edges).shape(marked);
}

}  // namespace hitos
