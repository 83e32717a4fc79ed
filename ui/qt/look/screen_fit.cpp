// SPDX-License-Identifier: GPL-3.0-or-later
#include "screen_fit.hpp"

#include <QGuiApplication>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QWidget>
#include <algorithm>

namespace hitos::window {
namespace {

constexpr QMargins kFrame(8, 36, 8, 8);  // what window managers draw round a window, at most

QRect room_on(const QScreen& screen) {
    return screen.availableGeometry().marginsRemoved(kFrame);
}

QRect room_for(const QWidget& window) {
    const QWidget* parent = window.parentWidget();
    return room_on(*(parent == nullptr ? &window : parent)->screen());
}

/// A window is moved by the corner of its frame, of which the room is the inside.
void move_into(const QRect& room, QWidget& window, QPoint wanted) {
    const QPoint least = room.topLeft() - QPoint(kFrame.left(), kFrame.top());
    const QPoint most(least.x() + std::max(0, room.width() - window.width()),
                      least.y() + std::max(0, room.height() - window.height()));
    window.move(std::clamp(wanted.x(), least.x(), most.x()),
                std::clamp(wanted.y(), least.y(), most.y()));
}

/// Whenever its content is laid out anew, as for other words.
class WideEnough final : public QObject {
  public:
    explicit WideEnough(QScrollArea& area) : QObject(&area), area_(area) { widen(); }

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::LayoutRequest) widen();
        return QObject::eventFilter(watched, event);
    }

  private:
    void widen() {
        area_.setMinimumWidth(area_.widget()->minimumSizeHint().width() + 2 * area_.frameWidth() +
                              area_.verticalScrollBar()->sizeHint().width());
    }

    QScrollArea& area_;
};

}  // namespace

void fit_to_screen(QWidget& window) {
    window.resize(window.size().boundedTo(room_for(window).size()));
}

void scroll_down_only(QScrollArea& area) {
    // What the style sheet says of fonts and margins counts from the first showing on, else.
    for (QWidget* part : area.widget()->findChildren<QWidget*>()) part->ensurePolished();
    area.widget()->ensurePolished();
    area.widget()->installEventFilter(new WideEnough(area));
}

void apply_size(QWidget& window, const std::string& size) {
    const QStringList parts = QString::fromStdString(size).split('x');
    if (parts.size() != 2) return;
    window.setWindowState(Qt::WindowNoState);
    window.resize(parts[0].toInt(), parts[1].toInt());
}

void place_beside_parent(QWidget& window, QPoint offset) {
    fit_to_screen(window);
    move_into(room_for(window), window, window.parentWidget()->pos() + offset);
}

void keep_on_screen(QWidget& window) {
    const QScreen* there = QGuiApplication::screenAt(window.geometry().center());
    const QScreen& screen = there == nullptr ? *window.screen() : *there;
    if (screen.availableGeometry().contains(window.geometry())) return;
    const QRect room = room_on(screen);
    window.resize(window.size().boundedTo(room.size()));
    move_into(room, window, window.pos());
}

}  // namespace hitos::window
