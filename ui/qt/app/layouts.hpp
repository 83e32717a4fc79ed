// SPDX-License-Identifier: GPL-3.0-or-later
// How the window is laid out: by names that the user gives, and for a classroom.
#pragma once

#include <QObject>
#include <QString>
#include <functional>

class QAction;
class QMainWindow;
class QMenu;
class QSettings;

namespace hitos::window {

class Prompts;

/// Keeps layouts under "layouts/NAME" of the settings, and lists them in a menu. Presenting has
/// large letters and one view alone, without docks and configuration; what was there before comes
/// back.
class Layouts final : public QObject {
    Q_OBJECT

  public:
    /// How a layout is written to the settings, under the group that is open, and read from them.
    struct Means {
        std::function<void()> save;
        std::function<void()> restore;
    };
    /// The switches of one view alone and of the configuration at a glance.
    struct Switches {
        QAction* presenting;
        QAction* alone;
        QAction* summary;
    };
    Layouts(QMainWindow& window, QMenu& menu, const Switches& switches, QSettings& settings,
            Prompts& prompts, Means means);

    /// Before the window's own layout is written: a class is no layout.
    void end_presenting();

  private:
    QStringList names() const;
    void fill();
    void keep();
    /// With that group open.
    void within(const QString& group, const std::function<void()>& use);
    void present(bool on);

    QMainWindow& window_;
    QMenu& menu_;
    Switches switches_;
    QSettings& settings_;
    Prompts& prompts_;
    Means means_;
    QString letters_;  ///< what presenting adds to the style sheet
};

}  // namespace hitos::window
