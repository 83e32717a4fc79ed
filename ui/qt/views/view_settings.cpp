// SPDX-License-Identifier: GPL-3.0-or-later
#include "view_settings.hpp"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QMenu>
#include <array>
#include <utility>

namespace hitos::window {

ViewSettings::ViewSettings(UserFiles& files, QMenu* layers_menu, QMenu* theme_menu, QObject* parent)
    : QObject(parent), files_(files), layers_menu_(layers_menu) {
    fill_layers(layers_menu);
    fill_themes(theme_menu);
}

Theme ViewSettings::saved_theme(UserFiles& files) {
    return theme_from(files.settings().value("view/theme").toString());
}

void ViewSettings::fill_layers(QMenu* menu) {
    int number = 1;
    for (const LayerInfo& info : kLayerTable) {
        const QString key = QString("layers/") + info.key;
        const bool on = files_.settings().value(key, info.on).toBool();
        QAction* action = menu->addAction(layer_name(info, particles_));
        switches_.at(static_cast<std::size_t>(number - 1)) = action;
        action->setObjectName(QString("layer_") + info.key);
        action->setCheckable(true);
        action->setChecked(on);
        action->setToolTip(layer_meaning(info));
        if (number <= 9) action->setShortcut(QKeySequence(Qt::ALT | (Qt::Key_0 + number)));
        ++number;
        connect(action, &QAction::toggled, this, [this, key](bool checked) {
            files_.settings().setValue(key, checked);
            update_layers();
        });
    }
    update_layers();
    draw_signs();
}

void ViewSettings::draw_signs() {
    for (std::size_t i = 0; i < kLayers; ++i) switches_[i]->setIcon(layer_sign(kLayerTable[i]));
}

void ViewSettings::set_particles(bool particles) {
    particles_ = particles;
    for (std::size_t i = 0; i < kLayers; ++i) {
        const QString name = layer_name(kLayerTable[i], particles);
        switches_[i]->setVisible(!name.isEmpty());  // what is hidden has no key either
        if (!name.isEmpty()) switches_[i]->setText(name);
    }
    update_layers();
}

void ViewSettings::update_layers() {
    LayerSet layers;
    for (std::size_t i = 0; i < kLayers; ++i) {
        const bool there = !layer_name(kLayerTable[i], particles_).isEmpty();
        layers.set(kLayerTable[i].layer, there && switches_[i]->isChecked());
    }
    if (layers == layers_) return;
    layers_ = layers;
    emit layers_changed(layers_);
}

void ViewSettings::fill_themes(QMenu* menu) {
    auto* group = new QActionGroup(this);
    const Theme now = saved_theme(files_);
    const std::array<std::pair<Theme, QString>, 3> themes{{{Theme::system, tr("As the system")},
                                                           {Theme::light, tr("Light")},
                                                           {Theme::dark, tr("Dark")}}};
    for (const auto& [theme, words] : themes) {
        QAction* action = menu->addAction(words);
        action->setObjectName("theme_" + to_word(theme));
        action->setCheckable(true);
        action->setChecked(theme == now);
        group->addAction(action);
        connect(action, &QAction::triggered, this, [this, wanted = theme] {
            files_.settings().setValue("view/theme", to_word(wanted));
            apply_theme(*qobject_cast<QApplication*>(QApplication::instance()), wanted);
            draw_signs();
            emit theme_changed();
        });
    }
}

}  // namespace hitos::window
