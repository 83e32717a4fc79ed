// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawn_walls.hpp"

#include <QApplication>
#include <QFileInfo>
#include <QLineF>
#include <QStringList>
#include <exception>
#include <string>

#include "hitos/registration/graph_edit.hpp"
#include "hitos/workbench/world_import.hpp"
#include "look/words_of.hpp"
#include "session/background.hpp"
#include "views/canvas_paint.hpp"

namespace hitos::window {

bool is_dxf(const QString& path) {
    try {
        return wall_source(path.toStdString()) == WallSource::drawing;
    } catch (const std::exception&) {  // which reading it tells
        return false;
    }
}

DrawnWalls read_drawn_walls(const QString& path, double unit_m) {
    const std::string file = path.toStdString();
    DrawnWalls read;
    ImportReport report;
    QString problem;
    QApplication::setOverrideCursor(Qt::WaitCursor);
    try {
        ImportOptions options;
        if (unit_m > 0.0 && is_dxf(path)) options.unit_m = unit_m;
        for (const Polyline& line :
             in_background([&] { return walls_as_drawn(file, options, &report); })) {
            for (std::size_t i = 0; i < line.size(); ++i) {
                read.walls.places.push_back(point_of(line[i]));
                if (i > 0 && distance(line[i - 1], line[i]) >= kShortestWall)
                    read.walls.walls.emplace_back(point_of(line[i - 1]), point_of(line[i]));
            }
        }
    } catch (const std::exception& error) {
        problem = words_of(error);
    }
    QApplication::restoreOverrideCursor();
    QStringList words{problem.isEmpty() ? QFileInfo(path).fileName() : problem};
    for (const Message& warning : report.warnings) words << words_of(warning);
    read.well = problem.isEmpty() && words.size() == 1;
    read.words = words.join("; ");
    return read;
}

}  // namespace hitos::window
