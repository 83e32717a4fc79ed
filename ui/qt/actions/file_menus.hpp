// SPDX-License-Identifier: GPL-3.0-or-later
// The menus of files that were used and of configurations that are at hand.
#pragma once

#include <QObject>

class QAction;
class QMenu;

namespace hitos::window {

class ConfigurationActions;
class UserFiles;

/// Keeps the two menus up to date; what is chosen in them is opened.
class FileMenus final : public QObject {
    Q_OBJECT

  public:
    /// `save_preset` stands at the end of the presets.
    FileMenus(UserFiles& files, ConfigurationActions& configuration, QMenu& recent, QMenu& presets,
              QAction& save_preset, QObject* parent);

  private:
    void refill_recent();
    void refill_presets();

    UserFiles& files_;
    ConfigurationActions& configuration_;
    QMenu& recent_;
    QMenu& presets_;
    QAction& save_preset_;
};

}  // namespace hitos::window
