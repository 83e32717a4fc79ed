// SPDX-License-Identifier: GPL-3.0-or-later
// Runs to compare, studies of many and tours to drive, and what the window does with them.

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QTimer>
#include <algorithm>

#include "actions/configuration_actions.hpp"
#include "actions/result_actions.hpp"
#include "dialogs/connect_dialog.hpp"
#include "dialogs/study_dialog.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "inspect/graph_window.hpp"
#include "look/screen_fit.hpp"
#include "main_window.hpp"
#include "runs/compare_window.hpp"
#include "runs/run_keeper.hpp"
#include "runs/runs.hpp"
#include "runs/runs_panel.hpp"
#include "status_line.hpp"
#include "ui_main_window.h"
#include "views/grid_view.hpp"
#include "views/view_settings.hpp"
#include "workers/connection.hpp"
#include "world/world_view.hpp"
#include "world/world_window.hpp"

namespace hitos::window {
namespace {

/// The name of the log that results are of, else that of their folder.
QString log_in(const QString& folder) {
    try {
        const Configuracion configuration =
            ArchivoConfiguracion::read(folder.toStdString() + "/config.cfg");
        return QFileInfo(QString::fromStdString(configuration.source.file)).fileName();
    } catch (const std::exception&) {
        return QFileInfo(folder).fileName();
    }
}

}  // namespace

void MainWindow::tell_left_runs() {
    // One after the other: what is not told of stays for the next start.
    for (QString folder; !(folder = RunKeeper::take_left()).isEmpty();) {
        const QFileInfo written(folder + "/summary.json");
        const bool look = prompts_.confirm(
            this, {tr("Run kept"), tr("Look at the run of %1 that was kept?").arg(log_in(folder)),
                   tr("Hitos was ended from outside after this long run, which was over on %1. "
                      "With Cancel it stays where it is, for File → Open results. Its results are "
                      "in %2.")
                       .arg(QLocale().toString(written.lastModified(), QLocale::ShortFormat),
                            QDir::toNativeSeparators(folder)),
                   tr("Look")});
        if (look) runs_->open(folder);
    }
}

/// Results that are being written are waited for, where the user wants to.
bool MainWindow::may_close_now() {
    if (!results_->writing()) return true;
    if (!prompts_.confirm(
            this, {tr("Results are being written"), tr("Close when all results are written?"),
                   tr("Until then the window stays open."), tr("Close then")})) {
        return false;
    }
    close_when_written_ = results_->writing();
    return !close_when_written_;
}

void MainWindow::connect_runs() {
    connect(configuration_, &ConfigurationActions::results_named, runs_, &Runs::open);
    connect(configuration_, &ConfigurationActions::graph_named, this,
            [this](const QString& path) { open_graph(path); });
    connect(ui_->action_open_graph, &QAction::triggered, this, &MainWindow::ask_for_graph);
    connect(&runs_->panel(), &RunsPanel::configuration_wanted, configuration_,
            &ConfigurationActions::use_again);
    connect(&runs_->panel(), &RunsPanel::traces_changed, ui_->grid_view, &GridView::set_traces);
    ui_->menu_run->insertAction(ui_->action_study, runs_->list_action());
    connect(ui_->action_open_results, &QAction::triggered, runs_, &Runs::ask);
    connect(ui_->action_connect, &QAction::triggered, this, [this] { open_connection(); });
    connect(ui_->action_drive, &QAction::triggered, this, [this] { open_world_window(); });
    connect(ui_->action_compare, &QAction::triggered, runs_,
            [this] { runs_->compare(runs_->panel().chosen()); });
    connect(runs_, &Runs::picture_wanted, results_, &ResultActions::save_figure);
    connect(runs_, &Runs::opened, this,
            [this](QWidget* window) { window->addActions(ui_->menu_run->actions()); });
}

StudyDialog& MainWindow::open_study() {
    if (study_ == nullptr) {
        study_ = new StudyDialog(session_, files_, prompts_, this);
        place_beside_parent(*study_, kBeside);
        connect(study_, &StudyDialog::run_wanted, configuration_,
                &ConfigurationActions::look_at_run);
        connect(study_, &StudyDialog::values_wanted, configuration_,
                [this](const Configuracion& configuration, const QString& values) {
                    const Configuracion before = session_.configuration();
                    if (!configuration_->use_again(configuration)) return;
                    const bool same = same_configuration(session_.configuration(), before);
                    status_->notice((same ? tr("As in the study already: %1")
                                          : tr("Set as in the study: %1. Undo takes it back"))
                                        .arg(values));
                });
        connect(study_, &StudyDialog::run_wanted, this, &MainWindow::come_forward);
        connect(study_, &StudyDialog::values_wanted, this, &MainWindow::come_forward);
    }
    if (study_->isVisible()) study_->raise();
    study_->show();
    study_->activateWindow();
    return *study_;
}

ConnectDialog& MainWindow::open_connection() {
    if (connect_ == nullptr) {
        connection_ = new Connection(session_, this);
        connect_ = new ConnectDialog(*connection_, session_, files_, prompts_, this);
        place_beside_parent(*connect_, kBeside);
        connect(connection_, &Connection::opened, configuration_,
                [this](const SourceParams& source, const std::shared_ptr<IncomingTour>& tour) {
                    if (!guard_.may_discard() || !configuration_->map_incoming(source, tour))
                        return connection_->end();
                    connect_->hide();  // the map is what is looked at
                });
        connect(connection_, &Connection::changed, status_, &StatusLine::refresh);
        connect(connection_, &Connection::said, status_, &StatusLine::notice);
    }
    connect_->show();
    connect_->raise();
    connect_->activateWindow();
    return *connect_;
}

void MainWindow::come_forward() {
    const auto come = [this] {
        raise();
        activateWindow();
    };
    come();
    // The window that was clicked in has events of its own under way, which would take it back.
    QTimer::singleShot(0, this, come);
}

WorldWindow& MainWindow::open_world_window() {
    if (world_ == nullptr) {
        world_ = new WorldWindow(session_, files_, prompts_, guard_, this);
        connect(world_, &WorldWindow::notice, status_, &StatusLine::notice);
        connect(world_, &WorldWindow::run_wanted, configuration_, [this](const QString& path) {
            if (!configuration_->open(path)) return;
            session_.run();
            come_forward();
        });
        connect(view_settings_, &ViewSettings::layers_changed, &world_->view(),
                &WorldView::set_layers);
        world_->view().set_layers(view_settings_->layers());
    }
    world_->show();
    world_->raise();
    world_->activateWindow();
    return *world_;
}

GraphWindow& MainWindow::open_graph(const QString& path) {
    auto* graph = new GraphWindow(path, files_, prompts_, this);
    connect(graph, &GraphWindow::notice, status_, &StatusLine::notice);
    connect(graph, &GraphWindow::picture_wanted, results_, &ResultActions::save_figure);
    place_beside_parent(*graph, kBeside);
    graph->show();
    graph->activateWindow();
    return *graph;
}

void MainWindow::ask_for_graph() {
    const QString path =
        prompts_.open_file(this, {tr("Open graph"),
                                  files_.folder_to_open("graph"),
                                  tr("Graphs of poses (*.g2o *.g2o.gz);;All files (*)"),
                                  {}});
    if (!path.isEmpty()) open_graph(path);
}

bool MainWindow::graphs_may_end() const {
    return std::ranges::all_of(findChildren<GraphWindow*>(),
                               [](GraphWindow* graph) { return graph->may_end(); });
}

}  // namespace hitos::window
