// SPDX-License-Identifier: GPL-3.0-or-later
#include "legend.hpp"

#include <QAction>
#include <QMenu>
#include <QToolButton>

#include "layers.hpp"
#include "look/flow_layout.hpp"
#include "view_settings.hpp"

namespace hitos::window {

Legend::Legend(QWidget* parent) : QWidget(parent) {
    constexpr int kSpacing = 2;
    new FlowLayout(this, kSpacing);
}

QToolButton* Legend::add_button() {
    auto* button = new QToolButton(this);
    button->setProperty("role", "chip");
    button->setFocusPolicy(Qt::NoFocus);  // the layers have a menu and keys
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setIconSize(QSize(14, 14));
    layout()->addWidget(button);
    return button;
}

void Legend::set_up(const ViewSettings& settings, Of of) {
    for (std::size_t i = 0; i < kLayers; ++i) {
        const LayerInfo& info = kLayerTable[i];
        if (!(of == Of::scan ? info.in_scan : info.in_grid)) continue;
        QToolButton* button = add_button();
        button->setObjectName(QString("chip_") + info.key);
        button->setDefaultAction(settings.layer_switch(i));
        const bool of_world = info.layer == Layer::path || info.layer == Layer::ancestry;
        chips_.push_back({button, info.on, of_world});
        connect(settings.layer_switch(i), &QAction::changed, this, &Legend::refresh);
    }
    QToolButton* all = add_button();
    all->setObjectName("chip_all");
    all->setText(tr("More…"));
    all->setToolTip(tr("All layers"));
    all->setMenu(settings.layers_menu());
    all->setPopupMode(QToolButton::InstantPopup);
    refresh();
}

void Legend::set_world_frame(bool on) {
    world_frame_ = on;
    refresh();
}

void Legend::refresh() {
    for (const Chip& chip : chips_) {
        const QAction* action = chip.button->defaultAction();
        chip.button->setVisible(action->isVisible() && (world_frame_ || !chip.of_world) &&
                                (chip.by_default || action->isChecked()));
    }
}

void Legend::resizeEvent(QResizeEvent* event) {
    constexpr int kWords = 340;
    const auto style = width() < kWords ? Qt::ToolButtonIconOnly : Qt::ToolButtonTextBesideIcon;
    for (const Chip& chip : chips_) chip.button->setToolButtonStyle(style);
    QWidget::resizeEvent(event);
}

}  // namespace hitos::window
