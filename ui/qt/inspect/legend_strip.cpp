// SPDX-License-Identifier: GPL-3.0-or-later
#include "legend_strip.hpp"

#include <QFontMetricsF>
#include <utility>

#include "views/canvas_paint.hpp"

namespace hitos::window {
namespace {

constexpr double kEdge = 8.0;  // around all of it
constexpr double kSample = 18.0;
constexpr double kGap = 6.0;     // between a sample and its words
constexpr double kApart = 16.0;  // between entries

}  // namespace

LegendStrip::LegendStrip(std::vector<Entry> entries, const QFont& font, double width)
    : entries_(std::move(entries)) {
    if (entries_.empty()) return;
    const QFontMetricsF metrics(font);
    const double row = metrics.height() + 2.0;
    QPointF at(kEdge, kEdge / 2.0 + row / 2.0);
    places_.reserve(entries_.size());
    for (const Entry& entry : entries_) {
        const double wide = kSample + kGap + metrics.horizontalAdvance(entry.words);
        if (at.x() > kEdge && at.x() + wide > width - kEdge) at = {kEdge, at.y() + row};
        places_.push_back(at);
        at.rx() += wide + kApart;
    }
    height_ = at.y() + row / 2.0 + kEdge / 2.0;
}

void LegendStrip::paint(QPainter& painter, const Scene& scene) const {
    if (entries_.empty()) return;
    painter.setPen(Qt::NoPen);
    painter.setBrush(scene.colours.card);
    painter.drawRect(QRectF(0.0, 0.0, scene.size.width(), height_));
    const QFontMetricsF metrics(painter.font());
    const double base = (metrics.ascent() - metrics.descent()) / 2.0;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        const QPointF end = places_[i] + QPointF(kSample, 0.0);
        painter.setPen(thin_pen(entries_[i].colour, 2.5));
        painter.drawLine(places_[i], end);
        painter.setPen(scene.colours.text);
        painter.drawText(end + QPointF(kGap, base), entries_[i].words);
    }
}

}  // namespace hitos::window
