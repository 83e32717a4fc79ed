// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw_bar.hpp"

#include <QButtonGroup>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <array>

#include "draw_tool.hpp"
#include "look/named.hpp"
#include "look/parameter_text.hpp"
#include "look/steady_label.hpp"
#include "numbers_strip.hpp"
#include "world_draft.hpp"
#include "world_view.hpp"

namespace hitos::window {
namespace {

struct ModeInfo {
    DrawMode mode = DrawMode::select;
    const char* name = "";
    const char* label = "";
    const char* hint = "";
};

constexpr auto kModes = std::to_array<ModeInfo>({
    {DrawMode::select, "select", QT_TRANSLATE_NOOP("DrawBar", "Select"),
     QT_TRANSLATE_NOOP(
         "DrawBar",
         "Click what is to be changed; a double click takes the whole of it. Drag it, "
         "move it by Ctrl and the arrow keys, type its numbers, or delete it.")},
    {DrawMode::wall, "wall", QT_TRANSLATE_NOOP("DrawBar", "Wall"),
     QT_TRANSLATE_NOOP("DrawBar",
                       "Click point after point; a double click or Escape ends the wall, a click "
                       "on its beginning closes it. Type a length, Tab, a direction, Return.")},
    {DrawMode::room, "room", QT_TRANSLATE_NOOP("DrawBar", "Room"),
     QT_TRANSLATE_NOOP("DrawBar", "Click two opposite corners.")},
    {DrawMode::door, "door", QT_TRANSLATE_NOOP("DrawBar", "Door"),
     QT_TRANSLATE_NOOP("DrawBar",
                       "Click both sides of the door on a wall, which gets a gap there.")},
    {DrawMode::box, "box", QT_TRANSLATE_NOOP("DrawBar", "Box"),
     QT_TRANSLATE_NOOP("DrawBar", "Click the middle of the box.")},
    {DrawMode::person, "person", QT_TRANSLATE_NOOP("DrawBar", "Person"),
     QT_TRANSLATE_NOOP("DrawBar",
                       "Click the way point after point; a double click or Escape ends it, a click "
                       "on its beginning makes it a round.")},
    {DrawMode::way_point, "way_point", QT_TRANSLATE_NOOP("DrawBar", "Way points"),
     QT_TRANSLATE_NOOP("DrawBar", "Click where the tour is to lead next.")},
    {DrawMode::start, "start", QT_TRANSLATE_NOOP("DrawBar", "Start"),
     QT_TRANSLATE_NOOP("DrawBar",
                       "Click where the robot starts, then where it looks; Escape leaves "
                       "its heading as it is.")},
    {DrawMode::measure, "measure", QT_TRANSLATE_NOOP("DrawBar", "Measure"),
     QT_TRANSLATE_NOOP("DrawBar", "Click two points.")},
});

}  // namespace

DrawBar::DrawBar(WorldDraft& draft, DrawTool& tool, WorldView& view, QWidget* parent)
    : QWidget(parent), draft_(draft), tool_(tool), view_(view) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    auto* tools = new QHBoxLayout;
    column->addLayout(tools);
    make_modes();
    for (QToolButton* button : modes_) tools->addWidget(button);
    tools->addStretch(1);
    auto* name = new QLabel(tr("Grid"), this);
    tools->addWidget(name);
    make_grid();
    name->setBuddy(grid_);
    tools->addWidget(grid_);
    auto* words = new QHBoxLayout;
    column->addLayout(words);
    numbers_ = new NumbersStrip(this);
    words->addWidget(numbers_);
    hint_ = named(new QLabel(this), "draw_hint");
    hint_->setProperty("role", "muted");
    words->addWidget(keep_lines(*hint_, 2), 1);
    connect_numbers();
    connect(&tool_, &DrawTool::mode_changed, this, &DrawBar::show_mode);
    connect(&tool_, &DrawTool::mode_changed, this, &DrawBar::show_numbers);
    connect(&tool_, &DrawTool::chosen_changed, this, &DrawBar::show_numbers);
    connect(&tool_, &DrawTool::pending_changed, this, &DrawBar::show_numbers);
    show_mode();
    show_numbers();
}

void DrawBar::make_modes() {
    auto* group = new QButtonGroup(this);
    int number = 0;
    for (const ModeInfo& info : kModes) {
        auto* button = named(new QToolButton(this), QString("draw_") + info.name);
        button->setText(translated("DrawBar", info.label));
        button->setProperty("role", "view");
        button->setCheckable(true);
        const QKeySequence key(QStringLiteral("Ctrl+%1").arg(++number));
        button->setToolTip(translated("DrawBar", info.hint) + " (" +
                           key.toString(QKeySequence::NativeText) + ')');
        button->setShortcut(key);
        group->addButton(button);
        modes_.push_back(button);
        connect(button, &QToolButton::clicked, this, [this, mode = info.mode] {
            tool_.set_mode(mode);
            view_.setFocus();
        });
    }
}

void DrawBar::make_grid() {
    constexpr double kStep = 0.05;
    grid_ = named(new QDoubleSpinBox(this), "draw_grid");
    grid_->setRange(0.0, 10.0);
    grid_->setSingleStep(kStep);
    grid_->setSuffix(tr(" m"));
    grid_->setSpecialValueText(tr("none"));
    grid_->setValue(tool_.grid());
    grid_->setToolTip(
        tr("Points are drawn on multiples of it, unless ends, walls or right angles "
           "are nearer; with Shift a point is where the cursor is"));
    connect(grid_, &QDoubleSpinBox::valueChanged, &tool_, &DrawTool::set_grid);
}

void DrawBar::connect_numbers() {
    connect(&tool_, &DrawTool::number_begun, numbers_, &NumbersStrip::begin);
    connect(numbers_, &NumbersStrip::edited, this, [this] {
        tool_.type({numbers_->typed(0), numbers_->typed(1)});
    });
    connect(numbers_, &NumbersStrip::finished, this, [this] {
        view_.setFocus();
        tool_.place_typed();
    });
    connect(numbers_, &NumbersStrip::left, this, [this] {
        tool_.type({});
        view_.setFocus();
    });
    connect(numbers_, &NumbersStrip::entered, this, [this](std::size_t place, double value) {
        if (!tool_.chosen()) return;
        const WorldItem item = *tool_.chosen();
        draft_.change([&](WorldText& text) { set_number(text, item, place, value); });
        show_numbers();  // as they are now, whether it could be or not
    });
}

void DrawBar::show_mode() {
    for (std::size_t i = 0; i < kModes.size(); ++i) {
        if (kModes[i].mode != tool_.mode()) continue;
        modes_[i]->setChecked(true);
        hint_->setText(translated("DrawBar", kModes[i].hint));
    }
}

void DrawBar::show_numbers() {
    const bool pieces = tool_.mode() == DrawMode::wall || tool_.mode() == DrawMode::person ||
                        tool_.mode() == DrawMode::door || tool_.mode() == DrawMode::start;
    if (pieces && !tool_.pending().empty()) {
        numbers_->ask_for({{HITOS_TEXT("WorldItem", "length"), "m", 0.0},
                           {HITOS_TEXT("WorldItem", "direction"), "°", 0.0}});
    } else if (tool_.chosen()) {
        numbers_->show_numbers(numbers_of(draft_.text(), *tool_.chosen()));
    } else {
        numbers_->show_numbers({});
    }
}

}  // namespace hitos::window
