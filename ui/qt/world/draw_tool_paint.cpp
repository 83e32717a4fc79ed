// SPDX-License-Identifier: GPL-3.0-or-later
// What the drawing tool draws over the world.
#include <cmath>

#include "draw_tool.hpp"
#include "views/canvas_paint.hpp"
#include "world_draft.hpp"

namespace hitos::window {
namespace {

void draw_line(QPainter& painter, const Scene& scene, const std::vector<Point2>& line) {
    QPolygonF pixels;
    for (const Point2& point : line) pixels.append(scene.to_screen.map(point_of(point)));
    painter.drawPolyline(pixels);
}

void draw_handle(QPainter& painter, const Scene& scene, const Point2& point, bool filled) {
    constexpr double kHalf = 4.0;
    const QPointF at = scene.to_screen.map(point_of(point));
    painter.setPen(thin_pen(scene.colours.accent, 1.6));
    painter.setBrush(filled ? QBrush(scene.colours.accent) : QBrush(Qt::NoBrush));
    painter.drawRect(QRectF(at.x() - kHalf, at.y() - kHalf, 2.0 * kHalf, 2.0 * kHalf));
}

}  // namespace

QString DrawTool::words_of_piece(const Point2& from, const Point2& to) const {
    const double heading = std::atan2(to.y - from.y, to.x - from.x) * kDegreesPerRadian;
    if (mode_ == DrawMode::room) {
        return tr("%1 × %2 m")
            .arg(std::abs(to.x - from.x), 0, 'f', 2)
            .arg(std::abs(to.y - from.y), 0, 'f', 2);
    }
    return tr("%1 m, %2°").arg(distance(from, to), 0, 'f', 3).arg(heading, 0, 'f', 1);
}

void DrawTool::paint(QPainter& painter, const Scene& scene) const {
    if (!active_) return;
    paint_chosen(painter, scene);
    paint_pending(painter, scene);
}

void DrawTool::paint_chosen(QPainter& painter, const Scene& scene) const {
    if (!chosen_) return;
    const WorldItem whole = whole_of(draft_.text(), *chosen_);
    Polyline line = outline_of(draft_.text(), whole);
    const bool box = chosen_->kind == ItemKind::box;
    const std::size_t first = box ? 0 : chosen_->first;
    const std::size_t last = box ? line.size() - 1 : chosen_->last;
    const bool closed = line.size() > 2 && line.front() == line.back();
    for (std::size_t i = first; i <= last && i < line.size(); ++i) {
        line[i] = {line[i].x + dragged_by_.x, line[i].y + dragged_by_.y};
    }
    if (closed && !box && first == 0) line.back() = line.front();
    if (closed && !box && last + 1 == line.size()) line.front() = line.back();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(thin_pen(faded(scene.colours.accent, 110), 2.0));
    draw_line(painter, scene, line);
    painter.setPen(thin_pen(scene.colours.accent, 3.0));
    const auto at = [&](std::size_t i) { return line.begin() + static_cast<std::ptrdiff_t>(i); };
    draw_line(painter, scene, {at(first), at(last + 1)});
    for (std::size_t i = 0; i < line.size() && !box; ++i) {
        draw_handle(painter, scene, line[i], i >= first && i <= last);
    }
}

void DrawTool::paint_pending(QPainter& painter, const Scene& scene) const {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(thin_pen(scene.colours.accent, 2.4));
    draw_line(painter, scene, pending_);
    if (mode_ == DrawMode::measure && pending_.size() == 2) {
        const QPointF at = scene.to_screen.map(point_of(pending_[1]));
        draw_chip(painter, scene, at + QPointF(12.0, 12.0),
                  {words_of_piece(pending_[0], pending_[1])});
        return;
    }
    if (!cursor_ || mode_ == DrawMode::select) return;
    const Point2 to = target(*cursor_);
    const QPointF at = scene.to_screen.map(point_of(to));
    if (!pending_.empty()) {
        painter.setPen(thin_pen(scene.colours.accent, 1.6, Qt::DashLine));
        draw_line(painter, scene,
                  mode_ == DrawMode::room ? rectangle(pending_.back(), to)
                                          : Polyline{pending_.back(), to});
    }
    const bool near = shown_ && (shown_->to == SnappedTo::end || shown_->to == SnappedTo::wall);
    near ? draw_handle(painter, scene, to, shown_->to == SnappedTo::end)
         : draw_cross(painter, at, scene.colours.accent);
    const QString words =
        pending_.empty() ? place_words(point_of(to)) : words_of_piece(pending_.back(), to);
    draw_chip(painter, scene, at + QPointF(14.0, 14.0), {words});
}

}  // namespace hitos::window
