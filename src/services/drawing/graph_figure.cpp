// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/drawing/graph_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "hitos/features/caracteristica.hpp"
#include "hitos/services/drawing/scale_bar.hpp"

namespace hitos {
namespace {

// Of the paper [mm].
constexpr double kPageWidth = 160.0;
constexpr double kHighestFrame = 200.0;
constexpr double kLowestFrame = 30.0;
constexpr double kPageMargin = 5.0;
constexpr double kLetters = 3.0;
constexpr double kLegendRow = 4.6;
constexpr double kSampleWidth = 8.0;

// Told apart by the colour-blind too (Okabe and Ito).
constexpr Colour kPathBlue{0, 114, 178};
constexpr Colour kLoopGrey{150, 150, 150};
constexpr Colour kWorstRed{213, 94, 0};
constexpr Colour kPointGreen{0, 158, 115};

/// Where the poses come in the order of their ids.
std::vector<std::size_t> ranks_of(const PlanarGraph& graph) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < graph.vertices.size(); ++i) {
        if (graph.vertices[i].kind == PlanarVertex::Kind::pose) order.push_back(i);
    }
    std::ranges::sort(order, {}, [&](std::size_t i) { return graph.vertices[i].id; });
    std::vector<std::size_t> ranks(graph.vertices.size(), 0);
    for (std::size_t k = 0; k < order.size(); ++k) ranks[order[k]] = k;
    return ranks;
}

/// A line landmark from the first to the last of the poses that see it.
struct SeenLine {
    double low = 0.0;
    double high = 0.0;
    bool seen = false;
};

/// The legend's rows, told layer by layer.
class GraphFigure {
  public:
    GraphFigure(const std::string& title, const PlanarGraph& graph) : graph_(graph) {
        drawing_.title = title;
        place();
    }

    VectorDrawing draw(std::span<const std::size_t> marked) {
        draw_edges(marked);
        draw_landmarks();
        draw_fixed();
        draw_scale();
        drawing_.height = row_ + kPageMargin;
        return std::move(drawing_);
    }

  private:
    Point2 at(std::size_t vertex) const { return placement_.at(graph_.vertices[vertex].point()); }

    void place() {
        Bounds world;
        for (const PlanarVertex& vertex : graph_.vertices) {
            if (vertex.kind != PlanarVertex::Kind::line) world.hold(vertex.point());
        }
        for (const PlanarEdge& edge : graph_.edges) {
            if (edge.kind == PlanarEdge::Kind::line) world.hold(before(edge));
        }
        constexpr double kLeast = 1.0;  // [m]
        const double wide = std::max(world.high.x - world.low.x, kLeast);
        const double high = std::max(world.high.y - world.low.y, kLeast);
        const double inside = kPageWidth - 2.0 * kPageMargin;
        const double per_m = std::min(inside / wide, (kHighestFrame - 2.0 * kPageMargin) / high);
        const double height = std::max(high * per_m, kLowestFrame);
        placement_ = {{(world.low.x + world.high.x) / 2.0, (world.low.y + world.high.y) / 2.0},
                      {kPageWidth / 2.0, kPageMargin + height / 2.0},
                      per_m};
        drawing_.width = kPageWidth;
        drawing_.frame = {{0.0, 0.0}, {kPageWidth, height + 2.0 * kPageMargin}, false};
        row_ = drawing_.frame.high.y + kLegendRow;
        // Where poses lie close, thin lines are told apart.
        weight_ =
            std::clamp(20.0 / std::sqrt(static_cast<double>(graph_.vertices.size())), 0.35, 1.0);
    }

    /// A layer with a row of the legend; none where it has nothing to show.
    void add(DrawnLayer layer, const std::string& words) {
        if (layer.lines.empty() && layer.ellipses.empty()) return;
        layer.clipped = true;
        DrawnLayer sample{"legend-" + layer.name, layer.style};
        const double middle = row_ - kLetters / 3.0;
        if (layer.lines.empty()) {
            sample.ellipses = {disc({kPageMargin + kSampleWidth / 2.0, middle}, 0.8)};
        } else {
            sample.lines = {{{kPageMargin, middle}, {kPageMargin + kSampleWidth, middle}}};
        }
        drawing_.layers.push_back(std::move(layer));
        drawing_.layers.push_back(std::move(sample));
        DrawnLayer text{"words", word_style(kBlack, kLetters)};
        text.texts = {{{kPageMargin + kSampleWidth + 2.0, row_}, words}};
        drawing_.layers.push_back(std::move(text));
        row_ += kLegendRow;
    }

    void draw_edges(std::span<const std::size_t> marked) {
        const std::vector<std::size_t> ranks = ranks_of(graph_);
        DrawnLayer path{"path", line_style(kPathBlue, 0.45 * weight_)};
        DrawnLayer loops{"edges", line_style(kLoopGrey, 0.3 * weight_)};
        DrawnLayer worst{"greatest-errors", line_style(kWorstRed, 0.6)};
        for (const PlanarEdge& edge : graph_.edges) {
            if (edge.kind != PlanarEdge::Kind::step) continue;
            const auto [first, second] = std::minmax(ranks[edge.from], ranks[edge.to]);
            (second - first == 1 ? path : loops).lines.push_back({at(edge.from), at(edge.to)});
        }
        for (const std::size_t i : marked) {
            const PlanarEdge& edge = graph_.edges[i];
            if (edge.kind == PlanarEdge::Kind::line) {
                worst.lines.push_back({at(edge.from), placement_.at(before(edge))});
            } else if (edge.prior()) {
                worst.lines.push_back({placement_.at({edge.z(0), edge.z(1)}), at(edge.to)});
            } else {
                worst.lines.push_back({at(edge.from), at(edge.to)});
            }
            // The shortest are seen too.
            worst.ellipses.push_back(disc(worst.lines.back().front(), 0.8));
            worst.ellipses.push_back(disc(worst.lines.back().back(), 0.8));
        }
        add(std::move(loops), "other edges between poses");
        add(std::move(path), "path, by the poses' ids");
        const std::string words = fmt::format("the {} edges of the greatest errors", marked.size());
        add(std::move(worst), marked.size() == 1 ? "the edge of the greatest error" : words);
    }

    void draw_landmarks() {
        std::vector<SeenLine> seen(graph_.vertices.size());
        for (const PlanarEdge& edge : graph_.edges) {
            if (edge.kind != PlanarEdge::Kind::line) continue;
            const double along = line_of(edge.to).along(graph_.vertices[edge.from].point());
            SeenLine& line = seen[edge.to];
            line = {line.seen ? std::min(line.low, along) : along,
                    line.seen ? std::max(line.high, along) : along, true};
        }
        DrawnLayer lines{"lines", line_style(kBlack, 0.5)};
        DrawnLayer points{"points", {.fill = kPointGreen}};
        for (std::size_t i = 0; i < graph_.vertices.size(); ++i) {
            if (graph_.vertices[i].kind == PlanarVertex::Kind::point) {
                points.ellipses.push_back(disc(at(i), 0.4 + 0.4 * weight_));
            } else if (seen[i].seen) {
                const PreparedRecta line = line_of(i);
                lines.lines.push_back(
                    {placement_.at(line.at(seen[i].low)), placement_.at(line.at(seen[i].high))});
            }
        }
        add(std::move(lines), "lines");
        add(std::move(points), "points");
    }
    /// Of a line, what lies before the pose that sees it.
    Point2 before(const PlanarEdge& edge) const {
        const PreparedRecta line = line_of(edge.to);
        return line.at(line.along(graph_.vertices[edge.from].point()));
    }
    PreparedRecta line_of(std::size_t vertex) const {
        const Eigen::Vector3d& value = graph_.vertices[vertex].at;
        return PreparedRecta(Recta{value(1), value(0)});
    }

    void draw_fixed() {
        DrawnLayer fixed{"fixed", {kWhite, kBlack, 0.35}};
        for (std::size_t i = 0; i < graph_.vertices.size(); ++i) {
            const PlanarVertex& vertex = graph_.vertices[i];
            if (vertex.fixed && vertex.kind != PlanarVertex::Kind::line) {
                fixed.ellipses.push_back(disc(at(i), 1.0));
            }
        }
        add(std::move(fixed), "fixed");
    }

    void draw_scale() {
        const double length = round_length(40.0 / placement_.per_m);
        const double right = kPageWidth - kPageMargin;
        const double left = right - length * placement_.per_m;
        const double y = drawing_.frame.high.y + kLegendRow + 2.0;
        DrawnLayer bar{"scale-bar", line_style(kBlack, 0.4)};
        bar.lines = {{{left, y - 1.0}, {left, y}, {right, y}, {right, y - 1.0}}};
        DrawnLayer text{"scale", word_style(kBlack, kLetters)};
        text.texts = {{{right, y - 1.8}, fmt::format("{:g} m", length), Anchor::end}};
        drawing_.layers.push_back(std::move(bar));
        drawing_.layers.push_back(std::move(text));
        row_ = std::max(row_, y);
    }

    const PlanarGraph& graph_;
    VectorDrawing drawing_;
    Placement placement_;
    double row_ = 0.0;     ///< the legend's next base line
    double weight_ = 1.0;  ///< of lines
};

}  // namespace

VectorDrawing graph_figure(const std::string& title, const PlanarGraph& graph,
                           std::span<const std::size_t> marked) {
    return GraphFigure(title, graph).draw(marked);
}

}  // namespace hitos
