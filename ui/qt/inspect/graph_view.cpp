// SPDX-License-Identifier: GPL-3.0-or-later
#include "graph_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "views/canvas_paint.hpp"

namespace hitos::window {
namespace {

using Segments = std::span<const GraphShape::Segment>;

void draw_segments(QPainter& painter, const Scene& scene, Segments segments, const QColor& colour,
                   double width = 1.0) {
    SeenLines lines(scene);
    for (const auto& [from, to] : segments) lines.add(QLineF(point_of(from), point_of(to)));
    lines.draw(painter, colour, width);
}

void draw_ends(QPainter& painter, const Scene& scene, const GraphShape::Segment& segment,
               const QColor& colour) {
    for (const Point2& end : segment)
        draw_disc(painter, scene.to_screen.map(point_of(end)), 3.0, colour);
}

void draw_points(QPainter& painter, const Scene& scene, const std::vector<Point2>& points,
                 const QPen& pen, const QColor& fill, double radius) {
    const QRectF sight = QRectF(QPointF(), scene.size).adjusted(-radius, -radius, radius, radius);
    painter.setPen(pen);
    painter.setBrush(fill);
    for (const Point2& point : points) {
        const QPointF pixel = scene.to_screen.map(point_of(point));
        if (sight.contains(pixel)) painter.drawEllipse(pixel, radius, radius);
    }
}

}  // namespace

GraphView::GraphView(QWidget* parent) : CanvasView(parent) {
    setAccessibleName(tr("Graph"));
}

void GraphView::set_graph(std::shared_ptr<const ShownGraph> graph) {
    graph_ = std::move(graph);
    marked_ = marked_edges(graph_->solved).size();
    content_changed(std::nullopt);
}

void GraphView::show_before(bool on) {
    before_ = on;
    content_changed(std::nullopt);
}

void GraphView::choose(Chosen chosen) {
    chosen_ = std::move(chosen);
    update();
}

std::span<const PlanarVertex> GraphView::vertices() const {
    return before_ ? graph_->file->graph.vertices : graph_->solved.graph.vertices;
}

Point2 GraphView::place_of(std::uint32_t vertex) const {
    return vertices()[vertex].point();
}

QRectF GraphView::content() const {
    if (!graph_) return {};
    const Bounds& bounds = shape().bounds;
    constexpr double kLeast = 1.0;  // [m]
    const QRectF box(point_of(bounds.low), point_of(bounds.high));
    const double more_x = std::max(0.0, kLeast - box.width()) / 2.0;
    const double more_y = std::max(0.0, kLeast - box.height()) / 2.0;
    return box.adjusted(-more_x, -more_y, more_x, more_y);
}

double GraphView::band_above(const QSizeF& size) const {
    return legend(colours(), size.width()).height();
}

void GraphView::paint_scene(QPainter& painter, const Scene& scene) const {
    if (!graph_) return;
    const GraphShape& shown = shape();
    const Colours& c = scene.colours;
    draw_metre_grid(painter, scene);
    draw_segments(painter, scene, shown.sightings, faded(c.observed, 110));
    draw_segments(painter, scene, shown.loops, c.ignored);
    draw_segments(painter, scene, shown.path, c.landmark, 1.4);
    draw_segments(painter, scene, shown.lines, c.observed, 1.8);
    draw_segments(painter, scene, shown.priors, c.association, 1.4);
    draw_points(painter, scene, shown.points, thin_pen(Qt::white), c.observed, 3.0);
    draw_points(painter, scene, shown.fixed, thin_pen(c.text, 1.6), c.canvas, 4.0);
    draw_segments(painter, scene, marked(), c.danger, 2.0);
    for (const GraphShape::Segment& edge : marked()) draw_ends(painter, scene, edge, c.danger);
    paint_chosen(painter, scene);
    if (scene.scale_bar) draw_scale_bar(painter, scene);
    if (scene.chrome) legend(c, scene.size.width()).paint(painter, scene);
}

void GraphView::paint_chosen(QPainter& painter, const Scene& scene) const {
    const QColor& colour = scene.colours.highlight;
    if (chosen_.edge) {
        const auto place = std::ranges::find(graph_->solved.worst, *chosen_.edge);
        const PlanarEdge& edge = graph_->solved.graph.edges[*chosen_.edge];
        const GraphShape::Segment segment =
            place != graph_->solved.worst.end()
                ? shape().marked[static_cast<std::size_t>(place - graph_->solved.worst.begin())]
                : GraphShape::Segment{place_of(edge.from), place_of(edge.to)};
        draw_segments(painter, scene, {&segment, 1}, colour, 3.0);
        draw_ends(painter, scene, segment, colour);
    }
    for (const auto& [vertex, name] : chosen_.poses) {
        const QPointF pixel = scene.to_screen.map(point_of(place_of(vertex)));
        draw_disc(painter, pixel, 4.5, colour);
        draw_chip(painter, scene, pixel + QPointF(7.0, -26.0), {name});
    }
}

/// Of what there is.
LegendStrip GraphView::legend(const Colours& c, double width) const {
    const GraphShape& shown = shape();
    std::vector<LegendStrip::Entry> entries;
    const auto add = [&](bool there, const QString& words, const QColor& colour) {
        if (there) entries.push_back({words, colour});
    };
    add(!shown.path.empty(), tr("path, by the poses' ids"), c.landmark);
    add(!shown.loops.empty(), tr("other edges between poses"), c.ignored);
    add(!shown.sightings.empty(), tr("landmarks seen"), faded(c.observed, 110));
    add(!shown.points.empty() || !shown.lines.empty(), tr("landmarks"), c.observed);
    add(!shown.priors.empty(), tr("known places"), c.association);
    add(!shown.fixed.empty(), tr("fixed"), c.text);
    add(!marked().empty(), tr("greatest errors"), c.danger);
    return {std::move(entries), font(), width};
}

/// On a pose, else on an edge between a pose and what it sees, else near a pose.
void GraphView::click(const QPointF& point) {
    if (!graph_) return;
    std::optional<std::uint32_t> pose;
    std::optional<std::size_t> edge;
    const double reach = tolerance_m();
    double to_pose = reach;
    double to_edge = reach;
    const std::span<const PlanarVertex> all = vertices();
    for (std::uint32_t i = 0; i < all.size(); ++i) {
        if (all[i].kind != PlanarVertex::Kind::pose) continue;
        const double away = std::hypot(all[i].at(0) - point.x(), all[i].at(1) - point.y());
        if (away >= to_pose) continue;
        to_pose = away;
        pose = i;
    }
    const std::vector<PlanarEdge>& edges = graph_->solved.graph.edges;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (edges[i].kind > PlanarEdge::Kind::point) continue;
        const QLineF line(point_of(place_of(edges[i].from)), point_of(place_of(edges[i].to)));
        const double away = distance_to(line, point);
        if (away >= to_edge) continue;
        to_edge = away;
        edge = i;
    }
    if (pose && (!edge || to_pose < reach / 2.0)) {
        emit pose_clicked(*pose);
    } else if (edge) {
        emit edge_clicked(*edge);
    }
}

QString GraphView::empty_text() const {
    return tr("The graph is being read…");
}

}  // namespace hitos::window
