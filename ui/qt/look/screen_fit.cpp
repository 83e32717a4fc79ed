#include "screen_fit.hpp"

#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QWidget>
#include <algorithm>

namespace hitos::window {
namespace {

constexpr QMargins kFrame(8, 36, 8, 8);  // what window managers draw round a window, at most

QRect room_for(const QWidget& window) {
    const QWidget* parent = window.parentWidget();
    const QScreen* screen = (parent == nullptr ? &window : parent)->screen();
    return screen->availableGeometry().marginsRemoved(kFrame);
}

}  // namespace

void fit_to_screen(QWidget& window) {
    window.resize(window.size().boundedTo(room_for(window).size()));
}

void scroll_down_only(QScrollArea& area) {
    // What the style sheet says of fonts and margins counts from the first showing on, else.
    for (QWidget* part : area.widget()->findChildren<QWidget*>()) part->ensurePolished();
    area.widget()->ensurePolished();
    area.setMinimumWidth(area.widget()->minimumSizeHint().width() + 2 * area.frameWidth() +
                         area.verticalScrollBar()->sizeHint().width());
}

void apply_size(QWidget& window, const std::string& size) {
    const QStringList parts = QString::fromStdString(size).split('x');
    if (parts.size() == 2) window.resize(parts[0].toInt(), parts[1].toInt());
}

void place_beside_parent(QWidget& window, QPoint offset) {
    fit_to_screen(window);
    const QRect room = room_for(window);
    const QPoint wanted = window.parentWidget()->pos() + offset;
    window.move(std::clamp(wanted.x(), room.left(), room.right() + 1 - window.width()),
                std::clamp(wanted.y(), room.top(), room.bottom() + 1 - window.height()));
}

}  // namespace hitos::window
