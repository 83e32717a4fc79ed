// SPDX-License-Identifier: GPL-3.0-or-later
// Where a drawing's walls come to stand, and how large they are.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hitos/simulation/drawings/dxf_walls.hpp"

namespace hitos::dxf {

struct Wall {
    std::vector<Point2> points;  ///< [m]
    std::string type;            ///< of the entity
    std::string layer;
};

struct Unit {
    double metres = 1.0;
    bool known = false;  ///< else it is taken for granted
    Message note;
};

/// `asked` [m] goes before what the drawing says ($INSUNITS).
Unit unit_of(std::optional<int> insunits, std::optional<double> asked);

/// Rounds the walls, brings those of a drawing that lies farther than `far_m` [m] from its origin
/// there, leaves out what then still is out of a world's reach, and tells unit, size and all that.
void place(std::vector<Wall> walls, const Unit& unit, double far_m, DxfWalls& result);

}  // namespace hitos::dxf
