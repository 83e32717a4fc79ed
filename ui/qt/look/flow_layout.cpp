// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow_layout.hpp"

#include <QEvent>
#include <QWidget>
#include <algorithm>
#include <utility>

namespace hitos::window {
namespace {

class Stacker final : public QObject {
  public:
    Stacker(QWidget& widget, QBoxLayout& sides, int width)
        : QObject(&widget), widget_(widget), sides_(sides), width_(width) {
        widget.installEventFilter(this);
    }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Resize) {
            sides_.setDirection(widget_.width() < width_ ? QBoxLayout::TopToBottom
                                                         : QBoxLayout::LeftToRight);
        }
        return QObject::eventFilter(watched, event);
    }

  private:
    QWidget& widget_;
    QBoxLayout& sides_;
    int width_;
};

}  // namespace

void stack_when_narrow(QWidget& widget, QBoxLayout& sides, int width) {
    sides.setDirection(QBoxLayout::TopToBottom);  // what it needs at least
    new Stacker(widget, sides, width);
}

FlowLayout::FlowLayout(QWidget* parent, int spacing) : QLayout(parent) {
    setContentsMargins(0, 0, 0, 0);
    setSpacing(spacing);
}

FlowLayout::~FlowLayout() {
    for (QLayoutItem* item : items_) delete item;
}

QLayoutItem* FlowLayout::itemAt(int index) const {
    return index >= 0 && index < count() ? items_[static_cast<std::size_t>(index)] : nullptr;
}

QLayoutItem* FlowLayout::takeAt(int index) {
    QLayoutItem* item = itemAt(index);
    if (item != nullptr) items_.erase(items_.begin() + index);
    return item;
}

/// That of its widest item.
QSize FlowLayout::minimumSize() const {
    QSize least;
    for (const QLayoutItem* item : items_) {
        if (!item->isEmpty()) least = least.expandedTo(item->minimumSize());
    }
    return least;
}

void FlowLayout::setGeometry(const QRect& place) {
    QLayout::setGeometry(place);
    arranged(place, true);
}

int FlowLayout::arranged(const QRect& place, bool move) const {
    QPoint at = place.topLeft();
    int height = 0;
    std::vector<std::pair<QLayoutItem*, QRect>> line;
    const auto end_line = [&] {
        for (auto& [item, room] : line) {
            // In the middle of the line, so that what is written stands on one height.
            if (move) item->setGeometry(room.translated(0, (height - room.height()) / 2));
        }
        line.clear();
    };
    for (QLayoutItem* item : items_) {
        if (item->isEmpty()) continue;  // hidden
        const QSize size = item->sizeHint();
        if (at.x() > place.left() && at.x() + size.width() > place.right() + 1) {
            end_line();
            at = QPoint(place.left(), at.y() + height + spacing());
            height = 0;
        }
        line.emplace_back(item, QRect(at, size));
        at.rx() += size.width() + spacing();
        height = std::max(height, size.height());
    }
    end_line();
    return at.y() + height - place.top();
}

}  // namespace hitos::window
