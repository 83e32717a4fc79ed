// SPDX-License-Identifier: GPL-3.0-or-later
// Layers, frame and appearance: the View menu, and what of it is remembered.
#pragma once

#include <QObject>
#include <array>

#include "layers.hpp"
#include "look/theme.hpp"
#include "look/user_files.hpp"

class QAction;
class QMenu;

namespace hitos::window {

class ViewSettings final : public QObject {
    Q_OBJECT

  public:
    /// Fills the two menus; `theme` is what the user asked for on the command line, if anything.
    ViewSettings(UserFiles& files, QMenu* layers_menu, QMenu* theme_menu, QObject* parent);

    /// With the switch of every layer.
    QMenu* layers_menu() const { return layers_menu_; }
    /// The switch of a layer, in the order of the table.
    QAction* layer_switch(std::size_t place) const { return switches_.at(place); }

    /// Those that are switched on and say something of what runs.
    const LayerSet& layers() const { return layers_; }
    /// Whether the algorithm has particles: without, some layers have nothing to show.
    void set_particles(bool particles);
    static Theme saved_theme(UserFiles& files);

  signals:
    void layers_changed(const hitos::window::LayerSet& layers);
    void theme_changed();

  private:
    void fill_layers(QMenu* menu);
    void fill_themes(QMenu* menu);
    void update_layers();
    void draw_signs();

    UserFiles& files_;
    QMenu* layers_menu_;
    std::array<QAction*, kLayers> switches_{};  // in the order of the table
    bool particles_ = true;
    LayerSet layers_;
};

}  // namespace hitos::window
