// SPDX-License-Identifier: GPL-3.0-or-later
// The walls of a drawing's file, for who chooses among them.
#pragma once

#include <QPointF>
#include <QString>
#include <vector>

#include "wall_view.hpp"

namespace hitos::window {

/// What was read of a file that shows walls (walls_as_drawn()).
struct DrawnWalls {
    WallView::Walls walls;
    QString words;      ///< the file's name or what is wrong with it, and what there is to doubt
    bool well = false;  ///< nothing is wrong or doubted
};

bool is_dxf(const QString& path);
/// Beside the window, whose user waits. `unit_m` of a DXF drawing; 0: as it says itself.
DrawnWalls read_drawn_walls(const QString& path, double unit_m);

}  // namespace hitos::window
