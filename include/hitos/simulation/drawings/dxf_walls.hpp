// SPDX-License-Identifier: GPL-3.0-or-later
// Walls from a DXF drawing.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "hitos/base/geometry.hpp"
#include "hitos/base/message.hpp"
#include "hitos/base/translatable.hpp"

namespace hitos {

/// What a drawing's unit may be asked for by.
struct DrawingUnit {
    const char* word;
    double metres;
    const char* name;
};
inline constexpr std::array<DrawingUnit, 5> kDrawingUnits = {
    {{"mm", 1e-3, HITOS_TEXT("DrawingUnit", "millimetres")},
     {"cm", 1e-2, HITOS_TEXT("DrawingUnit", "centimetres")},
     {"m", 1.0, HITOS_TEXT("DrawingUnit", "metres")},
     {"in", 0.0254, HITOS_TEXT("DrawingUnit", "inches")},
     {"ft", 0.3048, HITOS_TEXT("DrawingUnit", "feet")}}};

/// How a drawing is read.
struct DxfOptions {
    /// Only entities of these layers count, "WALLS" or "WALLS,COLUMNS", hidden or not; empty: all
    /// that are shown.
    std::string layer;
    /// Metres per drawing unit; nothing: as the drawing's $INSUNITS says, else 1.
    std::optional<double> unit_m;
    /// A drawing that lies wholly farther than this from its origin [m] is moved there, and one
    /// that has anything a thousand kilometres off; infinite: none is.
    double far_m = 1e6;
};

/// What a drawing shows, and what became of the rest of it.
struct DxfWalls {
    /// Open polylines [m], a closed one with its first point repeated, no point twice in a row.
    std::vector<std::vector<Point2>> walls;
    /// What was taken off the drawing's own coordinates [m], whole metres.
    Point2 moved;
    std::vector<std::string> layers;  ///< that the drawing has
    std::vector<Message> notes;       ///< what walls were made of, unit, what was left out and why
    std::vector<Message> warnings;    ///< where walls may be missing, or of another size
};

/// What the drawing shows from above, to the nanometre: lines, polylines, multilines and the
/// outlines of filled surfaces as they are, arcs and other curves as chords at most 5 mm off,
/// inserted blocks with what is in them. Sheets (paper space), layers that are off or frozen and
/// what is invisible are left out; text, dimensions, points and patterns are no walls. All of that
/// is counted in the notes, and named in the warnings where it may be walls that cannot be read.
/// Throws FileError, or FormatError where there is no wall, a number is none or there is more than
/// a world holds.
DxfWalls read_dxf_walls(const std::filesystem::path& path, const DxfOptions& options = {});

}  // namespace hitos
