// SPDX-License-Identifier: GPL-3.0-or-later
// Other runs over a grid, and what their colours stand for.
#pragma once

#include <vector>

#include "figure.hpp"
#include "landmark_painter.hpp"

namespace hitos::window {

/// What of another run is drawn over a grid, all in the world's frame.
struct RunTrace {
    QString name;
    QColor colour;
    std::vector<QPointF> path;
    MarkedMap landmarks;  ///< may have none
    /// How far each point of the path is off [m], where it is coloured by that; not a number where
    /// it is not known.
    std::vector<double> errors_m = {};
    double greatest_m = 0.0;               ///< end of the scale of colours
    std::vector<std::size_t> begins = {};  ///< points of the path to which no way leads
    Qt::PenStyle line = Qt::SolidLine;
};

/// The path in its colour, and on it how far it is off.
void draw_errors(QPainter& painter, const Scene& scene, const RunTrace& trace);
/// What each colour stands for, in the corner where it covers least of them and of the landmarks.
void draw_legend(QPainter& painter, const Scene& scene, const std::vector<RunTrace>& traces,
                 const MarkedMap& landmarks);
/// The same for the legend of a figure.
std::vector<FigureEntry> entries_of(const std::vector<RunTrace>& traces);

}  // namespace hitos::window
