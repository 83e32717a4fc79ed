// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks.hpp"

#include <QAction>
#include <QChildEvent>
#include <QDockWidget>
#include <QMenu>
#include <QPointer>
#include <QTabBar>

#include "named.hpp"

namespace hitos::window {
namespace {

/// Of what QMainWindow::saveState() gives: where docks are first put is part of it.
constexpr int kState = 2;
/// Of the window: somebody has chosen how wide the column is, or it was shown once.
constexpr const char* kPlaced = "docks_placed";

/// Else it would be as narrow as what is in it can be.
void give_width(QMainWindow& window, QDockWidget* dock) {
    constexpr int kWidth = 400;
    if (window.property(kPlaced).toBool() || dock->isFloating() || !dock->isVisible()) return;
    window.setProperty(kPlaced, true);
    window.resizeDocks({dock}, {kWidth}, Qt::Horizontal);
}

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

QByteArray save_docks(const QMainWindow& window) {
    return (window.property(kPlaced).toBool() ? '1' : '0') + window.saveState(kState);
}

void restore_docks(QMainWindow& window, const QByteArray& state) {
    if (window.restoreState(state.mid(1), kState))
        window.setProperty(kPlaced, state.startsWith('1'));
}

QDockWidget* make_dock(QMainWindow& window, QDockWidget* first, QWidget* widget,
                       const QString& title, const char* name) {
    auto* dock = named(new QDockWidget(title, &window), name);
    dock->setWidget(widget);
    // Else the keyboard goes to the next widget, a button that Space presses.
    const auto give_keys = [&window, dock, middle = QPointer(window.centralWidget())] {
        if (middle == nullptr || !window.isVisible()) return;  // or the window itself goes
        const QWidget* keys = window.focusWidget();
        if (keys != nullptr && dock->isAncestorOf(keys)) middle->setFocus();
    };
    QObject::connect(dock, &QDockWidget::visibilityChanged, widget,
                     [&window, dock, widget, give_keys](bool shown) {
                         if (!shown) give_keys();
                         widget->setEnabled(shown);
                         if (shown) give_width(window, dock);
                     });
    window.addDockWidget(Qt::RightDockWidgetArea, dock);
    if (first != nullptr) window.tabifyDockWidget(first, dock);
    dock->hide();
    return dock;
}

void show_or_say(bool there, QWidget& shown, QWidget& keys, QWidget& words) {
    QWidget& next = there ? shown : words;
    QWidget& other = there ? words : shown;
    const QWidget* focused = shown.window()->focusWidget();
    const bool had_keys = focused != nullptr && (focused == &other || other.isAncestorOf(focused));
    next.setVisible(true);
    if (had_keys) (there ? keys : words).setFocus();
    other.setVisible(false);
}

QDockWidget* add_dock(const DockPlace& place, QWidget* widget, const QString& title,
                      const char* name, const QKeySequence& key) {
    QDockWidget* dock = make_dock(*place.window, place.first, widget, title, name);
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
