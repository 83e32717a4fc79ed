// SPDX-License-Identifier: GPL-3.0-or-later
// Docks beside the views.
#pragma once

#include <QKeySequence>
#include <QMainWindow>
#include <QString>
#include <QWidget>

class QAction;
class QDockWidget;
class QMenu;

namespace hitos::window {

/// Where docks go: tabbed with the first one, in a column at the right of the views, for screens
/// are wide; the user may put them below or afloat. Their switches go into the menu before
/// `before`.
struct DockPlace {
    QMainWindow* window = nullptr;
    QDockWidget* first = nullptr;  ///< null: it is the first
    QMenu* menu = nullptr;
    QAction* before = nullptr;
};

/// Where the user has put them, and how wide the column is.
QByteArray save_docks(const QMainWindow& window);
void restore_docks(QMainWindow& window, const QByteArray& state);

/// The docks have keys of their own; their tabs, which are there with every dock hidden, take none.
void keep_keys_off_tabs(QMainWindow& window);

/// In that column, hidden at first. What lies behind another dock, out of sight, takes no keys: Tab
/// goes past it.
QDockWidget* make_dock(QMainWindow& window, QDockWidget* first, QWidget* widget,
                       const QString& title, const char* name);

/// The same with a switch, which is called "action_" + name.
QDockWidget* add_dock(const DockPlace& place, QWidget* widget, const QString& title,
                      const char* name, const QKeySequence& key);

/// Of what a dock has and the words that it shows without it, one is there. Where the keyboard was
/// in the other it is here now, in `keys` with the first: what is hidden would give it to anybody.
void show_or_say(bool there, QWidget& shown, QWidget& keys, QWidget& words);

}  // namespace hitos::window
