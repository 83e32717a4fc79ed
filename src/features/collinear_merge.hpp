// SPDX-License-Identifier: GPL-3.0-or-later
// The merge of collinear pieces, the same for every method that finds lines [T table 4.4].
#pragma once

#include <array>
#include <span>
#include <vector>

#include "hitos/features/extraction_params.hpp"
#include "hitos/features/observation.hpp"

namespace hitos {

/// A stretch of wall: points on one line, in scan order, and the line fitted to them.
struct LinePiece {
    std::span<const Point2> points;
    Recta recta;
    bool merged = false;  ///< taken up by an earlier piece
};

/// Where a line's points begin and end: the first and the last of the scan, or, where the scan's
/// seam lies on the wall and makes those two neighbours, the outermost along the line.
std::array<Point2, 2> ends_of(std::span<const Point2> points, const Recta& line);

/// The line through the points, or through their ends, as `fit` says.
Recta fit_line(std::span<const Point2> points, const std::array<Point2, 2>& ends, LineFit fit);

/// Appends the lines that the pieces make to `out`: each piece takes up the later ones that are
/// collinear with it as it grows. The last piece may lie beside the first where the scan is
/// `closed`. The pieces' points lie outside `out`.
void merge_collinear(std::span<LinePiece> pieces, const CollinearParams& params, LineFit fit,
                     bool closed, Observation& out);

}  // namespace hitos
