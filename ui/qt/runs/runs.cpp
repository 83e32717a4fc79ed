// SPDX-License-Identifier: GPL-3.0-or-later
#include "runs.hpp"

#include <QDockWidget>

#include "runs_panel.hpp"

namespace hitos::window {
namespace {

constexpr auto kFiguresKey = "compare/figures";

}  // namespace

Runs::Runs(Session& session, UserFiles& files, Prompts& prompts, const ViewSettings& settings,
           const DockPlace& place)
    : QObject(place.window),
      files_(files),
      settings_(settings),
      window_(place.window),
      list_(new RunList(session, this)),
      panel_(new RunsPanel(session, *list_, files, prompts, place.window)),
      dock_(add_dock(place, panel_, tr("Runs"), "runs_dock", QKeySequence("Ctrl+Shift+K"))) {
    connect(panel_, &RunsPanel::comparison_wanted, this, &Runs::compare);
    connect(panel_, &RunsPanel::results_wanted, this, &Runs::ask);
}

QAction* Runs::list_action() const {
    return dock_->toggleViewAction();
}

bool Runs::open(const QString& folder) {
    dock_->show();
    dock_->raise();
    const std::optional<ListedRun> opened = panel_->open_folder(folder);
    if (opened) compare({*opened});
    return opened.has_value();
}

void Runs::ask() {
    if (const QString folder = panel_->ask_folder(); !folder.isEmpty()) open(folder);
}

void Runs::compare(const std::vector<ListedRun>& runs) {
    if (!comparison_) {
        comparison_ = new CompareWindow(*list_, settings_, window_);
        comparison_->setAttribute(Qt::WA_DeleteOnClose);
        connect(comparison_, &CompareWindow::picture_wanted, this, &Runs::picture_wanted);
        comparison_->show_figures(files_.settings().value(kFiguresKey).toBool());
        connect(comparison_, &CompareWindow::figures_shown, this,
                [this](bool on) { files_.settings().setValue(kFiguresKey, on); });
        emit opened(comparison_);
    }
    comparison_->show();
    comparison_->compare(runs);
    comparison_->raise();
    comparison_->activateWindow();
}

}  // namespace hitos::window
