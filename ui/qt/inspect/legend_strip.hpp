// SPDX-License-Identifier: GPL-3.0-or-later
// What colours stand for, one beside the other across the top of a view.
#pragma once

#include <QColor>
#include <QFont>
#include <QPointF>
#include <QString>
#include <vector>

#include "views/figure.hpp"

class QPainter;

namespace hitos::window {

/// As many rows as the width asks for.
class LegendStrip {
  public:
    struct Entry {
        QString words;
        QColor colour;
    };
    LegendStrip(std::vector<Entry> entries, const QFont& font, double width);

    double height() const { return height_; }
    void paint(QPainter& painter, const Scene& scene) const;

  private:
    std::vector<Entry> entries_;
    std::vector<QPointF> places_;  ///< of their left ends, in the middle of their rows
    double height_ = 0.0;
};

}  // namespace hitos::window
