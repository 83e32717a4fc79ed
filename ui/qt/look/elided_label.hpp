// SPDX-License-Identifier: GPL-3.0-or-later
// A label that ends in dots where it is too narrow, instead of a cut word.
#pragma once

#include <QLabel>
#include <QPainter>

namespace hitos::window {

class ElidedLabel final : public QLabel {
  public:
    using QLabel::QLabel;

    QSize minimumSizeHint() const override {
        constexpr int kLeastWidth = 20;
        return {kLeastWidth, QLabel::minimumSizeHint().height()};
    }

  protected:
    void paintEvent(QPaintEvent* event) override {
        Q_UNUSED(event)
        QPainter painter(this);
        painter.setPen(palette().color(foregroundRole()));
        painter.drawText(rect(), Qt::AlignLeft | Qt::AlignVCenter,
                         fontMetrics().elidedText(text(), Qt::ElideRight, width()));
    }
};

}  // namespace hitos::window
