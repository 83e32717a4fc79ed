// SPDX-License-Identifier: GPL-3.0-or-later
#include "graph_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "hitos/services/drawing/graph_shape.hpp"
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

/// The legend's rows, told layer by layer.
class GraphFigure {
  public:
    GraphFigure(const std::string& title, const GraphShape& shape, std::size_t vertices)
        : shape_(shape) {
        drawing_.title = title;
        place(vertices);
    }

    VectorDrawing draw() {
        draw_edges();
        draw_landmarks();
        draw_fixed();
        draw_scale();
        drawing_.height = row_ + kPageMargin;
        return std::move(drawing_);
    }

  private:
    Point2 at(const Point2& place) const { return placement_.at(place); }
    std::vector<DrawnLine> drawn(const std::vector<GraphShape::Segment>& segments) const {
        std::vector<DrawnLine> lines;
        lines.reserve(segments.size());
        for (const GraphShape::Segment& one : segments) lines.push_back({at(one[0]), at(one[1])});
        return lines;
    }

    void place(std::size_t vertices) {
        const Bounds& world = shape_.bounds;
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
        weight_ = std::clamp(20.0 / std::sqrt(static_cast<double>(vertices)), 0.35, 1.0);
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

    void draw_edges() {
        DrawnLayer path{"path", line_style(kPathBlue, 0.45 * weight_)};
        DrawnLayer loops{"edges", line_style(kLoopGrey, 0.3 * weight_)};
        DrawnLayer worst{"greatest-errors", line_style(kWorstRed, 0.6)};
        path.lines = drawn(shape_.path);
        loops.lines = drawn(shape_.loops);
        worst.lines = drawn(shape_.marked);
        for (const DrawnLine& line : worst.lines) {  // the shortest are seen too
            worst.ellipses.push_back(disc(line.front(), 0.8));
            worst.ellipses.push_back(disc(line.back(), 0.8));
        }
        const std::size_t marked = shape_.marked.size();
        add(std::move(loops), "other edges between poses");
        add(std::move(path), "path, by the poses' ids");
        const std::string words = fmt::format("the {} edges of the greatest errors", marked);
        add(std::move(worst), marked == 1 ? "the edge of the greatest error" : words);
    }

    void draw_landmarks() {
        DrawnLayer lines{"lines", line_style(kBlack, 0.5)};
        DrawnLayer points{"points", {.fill = kPointGreen}};
        lines.lines = drawn(shape_.lines);
        for (const Point2& point : shape_.points)
            points.ellipses.push_back(disc(at(point), 0.4 + 0.4 * weight_));
        add(std::move(lines), "lines");
        add(std::move(points), "points");
    }

    void draw_fixed() {
        DrawnLayer fixed{"fixed", {kWhite, kBlack, 0.35}};
        for (const Point2& point : shape_.fixed) fixed.ellipses.push_back(disc(at(point), 1.0));
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

    const GraphShape& shape_;
    VectorDrawing drawing_;
    Placement placement_;
    double row_ = 0.0;     ///< the legend's next base line
    double weight_ = 1.0;  ///< of lines
};

}  // namespace

VectorDrawing graph_figure(const std::string& title, const PlanarGraph& graph,
                           std::span<const std::size_t> marked) {
    const GraphShape shape = graph_shape(graph.vertices, graph.edges, marked);
    return GraphFigure(title, shape, graph.vertices.size()).draw();
}

}  // namespace hitos
