// SPDX-License-Identifier: GPL-3.0-or-later
#include "view_panels.hpp"

#include <QAction>
#include <QEvent>
#include <QSettings>
#include <QSplitter>
#include <QToolButton>
#include <QWidget>
#include <utility>

namespace hitos::window {

ViewPanels::ViewPanels(QSplitter& splitter, const std::array<Panel, 2>& panels, QAction* alone,
                       QAction* stacked)
    : QObject(&splitter), splitter_(splitter), panels_(panels), alone_(alone), stacked_(stacked) {
    for (const Panel& one : panels_) {
        one.title->installEventFilter(this);
        one.panel->installEventFilter(this);
    }
    connect(alone_, &QAction::toggled, this, &ViewPanels::show_alone);
    connect(stacked_, &QAction::toggled, this, &ViewPanels::stack);
}

bool ViewPanels::eventFilter(QObject* watched, QEvent* event) {
    constexpr int kNarrow = 600;
    for (const Panel& one : panels_) {
        if (one.panel == watched && event->type() == QEvent::Resize) {
            one.button->setToolButtonStyle(one.panel->width() < kNarrow
                                               ? Qt::ToolButtonIconOnly
                                               : Qt::ToolButtonTextBesideIcon);
        }
        if (one.title != watched || event->type() != QEvent::MouseButtonDblClick) continue;
        asked_ = one.panel;
        alone_->toggle();
        return true;
    }
    return false;
}

void ViewPanels::show_alone(bool alone) {
    const QWidget* chosen = std::exchange(asked_, nullptr);
    for (const Panel& one : panels_) {
        if (chosen == nullptr && one.view->hasFocus()) chosen = one.panel;
    }
    if (chosen == nullptr) chosen = panels_.back().panel;
    for (const Panel& one : panels_) one.panel->setVisible(!alone || one.panel == chosen);
    for (const Panel& one : panels_) {
        if (alone && one.panel == chosen) one.view->setFocus();
    }
}

void ViewPanels::stack(bool stacked) {
    splitter_.setOrientation(stacked ? Qt::Vertical : Qt::Horizontal);
}

void ViewPanels::save(QSettings& settings) const {
    // Of one alone the splitter knows no sizes for both.
    if (!alone_->isChecked()) settings.setValue("window/views", splitter_.saveState());
    settings.setValue("window/stacked", stacked_->isChecked());
}

void ViewPanels::restore(const QSettings& settings) {
    splitter_.restoreState(settings.value("window/views").toByteArray());
    // Which of them was alone is not remembered: at the next start there are both.
    stacked_->setChecked(settings.value("window/stacked", false).toBool());
    stack(stacked_->isChecked());
}

}  // namespace hitos::window
