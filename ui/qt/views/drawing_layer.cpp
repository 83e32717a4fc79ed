// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing_layer.hpp"

#include <utility>

#include "canvas_paint.hpp"

namespace hitos::window {

void DrawingLayer::set_walls(std::vector<QLineF> walls) {
    walls_ = std::move(walls);
    place();
}

void DrawingLayer::lay(const std::optional<LaidDrawing>& drawing) {
    if (drawing == drawing_) return;
    drawing_ = drawing;
    place();
}

void DrawingLayer::place() {
    laid_.clear();
    if (!drawing_ || !drawing_->firm) return;
    laid_.reserve(walls_.size());
    const auto laid = [&](const QPointF& at) {
        return point_of(transform(drawing_->pose, Point2{at.x(), at.y()}));
    };
    for (const QLineF& wall : walls_) laid_.emplace_back(laid(wall.p1()), laid(wall.p2()));
}

void DrawingLayer::paint(QPainter& painter, const Scene& scene, const QColor& colour) const {
    SeenLines lines(scene);
    for (const QLineF& wall : laid_) lines.add(wall);
    lines.draw(painter, colour, 1.4);
}

}  // namespace hitos::window
