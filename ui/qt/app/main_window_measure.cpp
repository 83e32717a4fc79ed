// SPDX-License-Identifier: GPL-3.0-or-later
// Measuring in the views: its parts, put together.

#include <QDockWidget>

#include "actions/result_actions.hpp"
#include "look/docks.hpp"
#include "look/icons.hpp"
#include "main_window.hpp"
#include "measure/measure_tool.hpp"
#include "measure/measurement_table.hpp"
#include "status_line.hpp"
#include "ui_main_window.h"
#include "views/grid_view.hpp"

namespace hitos::window {

void MainWindow::set_up_measuring(const DockPlace& place) {
    ui_->action_measure->setIcon(icon(Glyph::distance));
    ui_->action_measure_angle->setIcon(icon(Glyph::angle));
    ui_->grid_measure->setDefaultAction(ui_->action_measure);
    measurements_ = new Measurements(session_, this);
    measure_ =
        new MeasureTool(*measurements_, ui_->action_measure, ui_->action_measure_angle, this);
    auto* table = new MeasurementTable(*measurements_, files_, prompts_,
                                       {ui_->action_measure, ui_->action_measure_angle}, this);
    measurement_table_ = table;
    QDockWidget* dock = add_dock(place, table, tr("Measurements"), "measurements_dock",
                                 QKeySequence("Ctrl+Shift+M"));
    connect(table, &MeasurementTable::shown, measure_, &MeasureTool::set_shown);
    connect(table, &MeasurementTable::notice, status_, &StatusLine::notice);
    connect(measure_, &MeasureTool::notice, status_, &StatusLine::notice);
    connect(measure_, &ViewTool::switched, dock, [this, dock] {
        if (!measure_->takes_clicks()) return;
        dock->show();
        dock->raise();
    });
    ui_->scan_view->set_tool(*measure_);
    ui_->grid_view->set_tool(*measure_);
    connect(results_, &ResultActions::opened, measure_, [this](QWidget* map) {
        map->addActions({ui_->action_measure, ui_->action_measure_angle});
        map->findChild<GridView*>()->set_tool(*measure_);
    });
}

void MainWindow::open_distances(const QString& path) {
    auto* dock = qobject_cast<QDockWidget*>(measurement_table_->parentWidget());
    dock->show();
    dock->raise();
    measurement_table_->open(path);
}

}  // namespace hitos::window
