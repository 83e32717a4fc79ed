// SPDX-License-Identifier: GPL-3.0-or-later
// A status bar whose message ends in dots where it is too long, instead of a cut word.
#pragma once

#include <QPainter>
#include <QStatusBar>
#include <QStyleOption>
#include <algorithm>

namespace hitos::window {

class ElidedStatusBar final : public QStatusBar {
  public:
    using QStatusBar::QStatusBar;

  protected:
    void paintEvent(QPaintEvent* event) override {
        Q_UNUSED(event)
        constexpr int kMargin = 6;
        QPainter painter(this);
        QStyleOption option;
        option.initFrom(this);
        style()->drawPrimitive(QStyle::PE_PanelStatusBar, &option, &painter, this);
        if (currentMessage().isEmpty()) return;
        QRect place = rect().adjusted(kMargin, 0, -kMargin, 0);
        for (const QWidget* child : findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) {
            if (child->isVisible()) place.setRight(std::min(place.right(), child->x() - kMargin));
        }
        painter.setPen(palette().windowText().color());
        painter.drawText(place, Qt::AlignLeading | Qt::AlignVCenter | Qt::TextSingleLine,
                         fontMetrics().elidedText(currentMessage(), Qt::ElideRight, place.width()));
    }
};

}  // namespace hitos::window
