#include "docks.hpp"

#include <QAction>
#include <QDockWidget>
#include <QMenu>

namespace hitos::window {

QDockWidget* add_dock(const DockPlace& place, QWidget* widget, const QString& title,
                      const char* name, const QKeySequence& key) {
    auto* dock = new QDockWidget(title, place.window);
    dock->setObjectName(name);
    dock->setWidget(widget);
    place.window->addDockWidget(Qt::BottomDockWidgetArea, dock);
    place.window->tabifyDockWidget(place.first, dock);
    dock->hide();
    QAction* toggle = dock->toggleViewAction();
    toggle->setObjectName(QString("action_") + name);
    toggle->setShortcut(key);
    QObject::connect(toggle, &QAction::triggered, dock, [dock](bool on) {
        if (on) dock->raise();
    });
    place.menu->insertAction(place.before, toggle);
    return dock;
}

}  // namespace hitos::window
