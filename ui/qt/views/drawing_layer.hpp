// SPDX-License-Identifier: GPL-3.0-or-later
// The drawing that a map is anchored to, where it lies on it.
#pragma once

#include <QLineF>
#include <optional>
#include <vector>

#include "hitos/registration/laid_drawing.hpp"
#include "view_tool.hpp"

class QPainter;

namespace hitos::window {

class DrawingLayer {
  public:
    /// In the drawing's own frame [m].
    void set_walls(std::vector<QLineF> walls);
    /// Where the anchors have it; it is drawn where that is firm.
    void lay(const std::optional<LaidDrawing>& drawing);

    bool empty() const { return laid_.empty(); }
    void paint(QPainter& painter, const Scene& scene, const QColor& colour) const;

  private:
    void place();

    std::vector<QLineF> walls_;
    std::optional<LaidDrawing> drawing_;
    std::vector<QLineF> laid_;  ///< in the world's frame
};

}  // namespace hitos::window
