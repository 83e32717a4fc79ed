// SPDX-License-Identifier: GPL-3.0-or-later
#include "file_menus.hpp"

#include <QDir>
#include <QFileInfo>
#include <QMenu>

#include "configuration_actions.hpp"
#include "hitos/workbench/presets.hpp"
#include "look/parameter_text.hpp"

namespace hitos::window {

FileMenus::FileMenus(UserFiles& files, ConfigurationActions& configuration, QMenu& recent,
                     QMenu& presets, QAction& save_preset, QObject* parent)
    : QObject(parent),
      files_(files),
      configuration_(configuration),
      recent_(recent),
      presets_(presets),
      save_preset_(save_preset) {
    connect(&files, &UserFiles::recent_changed, this, &FileMenus::refill_recent);
    connect(&presets, &QMenu::aboutToShow, this, &FileMenus::refill_presets);
    refill_recent();
    refill_presets();
}

void FileMenus::refill_recent() {
    recent_.clear();
    for (const QString& path : files_.recent()) {
        QAction* action = recent_.addAction(QFileInfo(path).fileName());
        action->setToolTip(path);
        action->setStatusTip(path);
        connect(action, &QAction::triggered, &configuration_,
                [this, path] { configuration_.open(path); });
    }
    recent_.setEnabled(!recent_.isEmpty());
    if (recent_.isEmpty()) return;
    recent_.addSeparator();
    connect(recent_.addAction(tr("Clear the list")), &QAction::triggered, &files_,
            &UserFiles::clear_recent);
}

/// Those that come with Hitos, then the user's own.
void FileMenus::refill_presets() {
    presets_.clear();
    for (const Preset& preset : hitos::presets()) {
        QAction* action = presets_.addAction(translated("Preset", preset.label));
        action->setObjectName("action_preset_" + to_qt(preset.word));
        action->setToolTip(translated("Preset", preset.purpose));
        connect(action, &QAction::triggered, &configuration_,
                [this, word = preset.word] { configuration_.use_preset(word); });
    }
    presets_.addSeparator();
    for (const QString& path : files_.presets()) {
        QAction* action = presets_.addAction(QFileInfo(path).completeBaseName());
        action->setToolTip(QDir::toNativeSeparators(path));
        connect(action, &QAction::triggered, &configuration_,
                [this, path] { configuration_.open(path); });
    }
    presets_.addAction(&save_preset_);
}

}  // namespace hitos::window
