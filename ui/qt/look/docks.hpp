// Docks below the views.
#pragma once

#include <QKeySequence>
#include <QMainWindow>
#include <QString>

class QAction;
class QDockWidget;
class QMenu;

namespace hitos::window {

/// Where docks go: tabbed with the first one, below the views, for tables are wide; their switches
/// into the menu before `before`.
struct DockPlace {
    QMainWindow* window = nullptr;
    QDockWidget* first = nullptr;
    QMenu* menu = nullptr;
    QAction* before = nullptr;
};

/// What lies behind another dock, out of sight, takes no keys: Tab goes past it.
void keep_keys_in_front(QDockWidget* dock);

/// The docks have keys of their own; their tabs, which are there with every dock hidden, take none.
void keep_keys_off_tabs(QMainWindow& window);

/// Hidden at first. Its switch is called "action_" + name.
QDockWidget* add_dock(const DockPlace& place, QWidget* widget, const QString& title,
                      const char* name, const QKeySequence& key);

}  // namespace hitos::window
