// SPDX-License-Identifier: GPL-3.0-or-later
// What one has at hand while a world is drawn: tools, grid, numbers.
#pragma once

#include <QWidget>
#include <vector>

class QDoubleSpinBox;
class QLabel;
class QToolButton;

namespace hitos::window {

class DrawTool;
class NumbersStrip;
class WorldDraft;
class WorldView;

class DrawBar final : public QWidget {
    Q_OBJECT

  public:
    DrawBar(WorldDraft& draft, DrawTool& tool, WorldView& view, QWidget* parent);

  private:
    void make_modes();
    void make_grid();
    void connect_numbers();
    void show_mode();
    void show_numbers();

    WorldDraft& draft_;
    DrawTool& tool_;
    WorldView& view_;
    std::vector<QToolButton*> modes_;  ///< in the order of kModes
    QDoubleSpinBox* grid_ = nullptr;
    NumbersStrip* numbers_ = nullptr;
    QLabel* hint_ = nullptr;
};

}  // namespace hitos::window
