// SPDX-License-Identifier: GPL-3.0-or-later
#include "map_window.hpp"

#include <QPushButton>
#include <cmath>

#include "look/words_of.hpp"
#include "ui_map_window.h"
#include "view_settings.hpp"

namespace hitos::window {

MapWindow::MapWindow(const QString& title, Show show, const ViewSettings& settings, QWidget* parent)
    : QDialog(parent, Qt::Window), ui_(std::make_unique<Ui::MapWindow>()), show_(show) {
    ui_->setupUi(this);
    setWindowTitle(title);
    setAttribute(Qt::WA_DeleteOnClose);
    ui_->view->set_layers(settings.layers());
    connect(&settings, &ViewSettings::layers_changed, ui_->view, &GridView::set_layers);
    ui_->layers->setMenu(settings.layers_menu());
    connect(ui_->view, &CanvasView::hovered_at, this,
            [this](QPointF world_m) { ui_->place->setText(place_words(world_m)); });
    connect(ui_->view, &CanvasView::left, ui_->place, &QLabel::clear);
    connect(ui_->stop, &QPushButton::clicked, &builder_, &MapBuilder::stop);
    connect(ui_->close, &QPushButton::clicked, this, &QDialog::close);
    connect(ui_->picture, &QPushButton::clicked, this, [this] { emit picture_wanted(ui_->view); });
    connect(ui_->view, &CanvasView::picture_wanted, this,
            [this] { emit picture_wanted(ui_->view); });
    connect(&builder_, &MapBuilder::changed, this, &MapWindow::refresh);
    connect(&builder_, &MapBuilder::finished, this, &MapWindow::finish);
    ui_->verdict->setText(tr("Drawing the map…"));
    ui_->picture->setEnabled(false);
}

MapWindow::~MapWindow() = default;

GridView& MapWindow::view() const {
    return *ui_->view;
}

void MapWindow::refresh() {
    const MapBuilder::State& state = builder_.state();
    ui_->progress->setValue(static_cast<int>(std::lround(state.progress * 1000.0)));
    if (show_ == Show::growth || !state.running) ui_->view->set_grid(state.tiles, state.path);
}

void MapWindow::finish() {
    const MapBuilder::State& state = builder_.state();
    ui_->stop->setEnabled(false);
    ui_->progress->hide();
    ui_->picture->setEnabled(!state.tiles.empty());
    if (!state.error.isEmpty()) {
        ui_->verdict->setText(state.error);
    } else if (state.stopped) {
        ui_->verdict->setText(counted_words(state.path.size(), tr("Stopped after 1 scan"),
                                            tr("Stopped after %1 scans")));
    } else {
        ui_->verdict->setText(
            counted_words(state.path.size(), tr("Map of 1 scan"), tr("Map of %1 scans")));
    }
    if (state.left_out > 0) {
        ui_->verdict->setText(ui_->verdict->text() + ", " +
                              counted_words(state.left_out,
                                            tr("1 of them reaches beyond what a grid can hold"),
                                            tr("%1 of them reach beyond what a grid can hold")));
    }
}

}  // namespace hitos::window
