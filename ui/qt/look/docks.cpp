#include "docks.hpp"

#include <QAction>
#include <QChildEvent>
#include <QDockWidget>
#include <QMenu>
#include <QTabBar>

namespace hitos::window {
namespace {

class TabsWithoutKeys final : public QObject {
  public:
    using QObject::QObject;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::ChildPolished) {
            // NOLINTNEXTLINE(*-static-cast-downcast): by its type
            auto* tabs = qobject_cast<QTabBar*>(static_cast<QChildEvent*>(event)->child());
            if (tabs != nullptr) tabs->setFocusPolicy(Qt::NoFocus);
        }
        return QObject::eventFilter(watched, event);
    }
};

}  // namespace

void keep_keys_off_tabs(QMainWindow& window) {
    window.installEventFilter(new TabsWithoutKeys(&window));
}

void keep_keys_in_front(QDockWidget* dock) {
    QObject::connect(dock, &QDockWidget::visibilityChanged, dock->widget(), &QWidget::setEnabled);
}

QDockWidget* add_dock(const DockPlace& place, QWidget* widget, const QString& title,
                      const char* name, const QKeySequence& key) {
    auto* dock = new QDockWidget(title, place.window);
    dock->setObjectName(name);
    dock->setWidget(widget);
    keep_keys_in_front(dock);
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
