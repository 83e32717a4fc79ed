// SPDX-License-Identifier: GPL-3.0-or-later
// What an entity of a DXF drawing looks like: lines in space, curves as chords.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "dxf_entities.hpp"

namespace hitos::dxf {

using Curve = std::vector<Eigen::Vector3d>;

/// Of all walls of a drawing, as often as they are drawn: what a world of them can be made of in
/// seconds. A shape that passes it need not be whole.
inline constexpr std::size_t kMostPoints = 400'000;

/// The axes of the coordinate system that an entity's extrusion stands for, in the columns
/// (the "arbitrary axis algorithm" of the DXF reference).
Eigen::Matrix3d axes_of(const Eigen::Vector3d& extrusion);

/// Whether this kind of entity is drawn by curves_of().
bool has_shape(std::string_view type);

struct Shape {
    std::vector<Curve> curves;
    bool readable = true;  ///< else something that it needs is not there
    bool curved = false;   ///< chords stand for curves
    bool wide = false;     ///< a polyline with a width, of which the middle is taken
    bool fill = false;     ///< a HATCH with a pattern, which shows no more than a surface
};

/// The shape of an entity in the coordinates of the drawing or of the block that holds it.
/// `vertices` are those of a POLYLINE. Chords lie at most `chord` [drawing units] from their
/// curves. Throws FormatError for a number that is none.
Shape shape_of(const Drawing& drawing, const Entity& entity, std::span<const Entity> vertices,
               double chord);

}  // namespace hitos::dxf
