// SPDX-License-Identifier: GPL-3.0-or-later
#include "figure.hpp"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "canvas_paint.hpp"
#include "hitos/services/drawing/scale_bar.hpp"

namespace hitos::window {
namespace {

// Points.
constexpr double kTick = 4.0;
constexpr double kSpace = 3.0;
constexpr double kFreeEdge = 8.0;  // free at the right and above
constexpr double kSign = 16.0;
constexpr double kEntryGap = 14.0;

}  // namespace

Picture FigureOffer::as_seen(double scale) const {
    FigureWish wish;
    wish.width_mm = width * kMmPerPoint;
    wish.layers = shown;
    wish.as_seen = true;
    Picture seen = picture(wish);
    seen.scale = scale;
    return seen;
}

void copy(const FigureOffer& offer) {
    copy(offer.as_seen(kCopyScale));
}

QString figure_number(double value) {
    QString words = QString::number(std::abs(value) < 1e-9 ? 0.0 : value, 'g', 6);
    return words.replace('-', QChar(0x2212));
}

FigureFrame::FigureFrame(FigureWish wish, const QFont& font, bool particles,
                         std::vector<FigureEntry> own)
    : wish_(std::move(wish)), metrics_(font) {
    const double line = metrics_.height();
    if (!wish_.title.isEmpty()) around_.setTop(line + 2.0 * kSpace);
    if (wish_.axes) {
        axis_room_ = kTick + 2.0 * line + 2.0 * kSpace;
        around_.setTop(std::max(around_.top(), kFreeEdge));
        around_.setRight(kFreeEdge);
        around_.setBottom(axis_room_);
        around_.setLeft(kTick + 3.0 * kSpace + line +
                        metrics_.horizontalAdvance(figure_number(-88.8)));
    }
    if (wish_.legend) lay_out_legend(particles, std::move(own));
}

double FigureFrame::width_of(const FigureEntry& entry) const {
    return entry.paint ? entry.width : kSign + kSpace + metrics_.horizontalAdvance(entry.name);
}

/// Row by row below everything else, so that it covers nothing.
void FigureFrame::lay_out_legend(bool particles, std::vector<FigureEntry> own) {
    const double row = std::max(metrics_.height(), kSign) + kSpace;
    QPointF at(around_.left(), kSpace);
    const auto add = [&](const LayerInfo* layer, FigureEntry entry) {
        const double room = wish_.points() - around_.left();
        if (!entry.paint && width_of(entry) > room) {  // a long name gives way, not its colour
            entry.name = metrics_.elidedText(entry.name, Qt::ElideMiddle,
                                             std::max(room - kSign - kSpace, 0.0));
        }
        const double width = width_of(entry);
        if (at.x() > around_.left() && at.x() + width > wish_.points())
            at = {around_.left(), at.y() + row};
        legend_.push_back({layer, std::move(entry), at});
        at.rx() += width + kEntryGap;
    };
    for (const LayerInfo& info : kLayerTable) {
        const QString name = layer_name(info, particles);
        if (!name.isEmpty() && wish_.layers.has(info.layer)) add(&info, {name});
    }
    for (FigureEntry& entry : own) add(nullptr, std::move(entry));
    if (!legend_.empty()) around_.setBottom(around_.bottom() + at.y() + row);
}

void FigureFrame::paint(QPainter& painter, const Scene& scene, const Colours& layers) const {
    // Not every kind of file is cut by the painter.
    const QRectF inside(QPointF(), scene.size);
    const QRectF all = inside.marginsAdded(around_);
    const QColor ground = wish_.ground();
    painter.fillRect(QRectF(all.left(), all.top(), all.width(), around_.top()), ground);
    painter.fillRect(QRectF(all.left(), inside.bottom(), all.width(), around_.bottom()), ground);
    painter.fillRect(QRectF(all.left(), all.top(), around_.left(), all.height()), ground);
    painter.fillRect(QRectF(inside.right(), all.top(), around_.right(), all.height()), ground);
    painter.setPen(scene.colours.text);
    const double width = scene.size.width();
    if (!wish_.title.isEmpty()) {
        painter.drawText(
            QRectF(-around_.left(), -around_.top(), wish_.points(), around_.top() - kSpace),
            Qt::AlignHCenter | Qt::AlignVCenter,
            metrics_.elidedText(wish_.title, Qt::ElideRight, wish_.points()));
    }
    if (wish_.axes) {
        painter.setPen(thin_pen(scene.colours.text));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(QPointF(), scene.size));
        paint_axis(painter, scene, false);
        paint_axis(painter, scene, true);
    }
    const double top = scene.size.height() + axis_room_;
    const double row = std::max(metrics_.height(), kSign);
    for (const Entry& entry : legend_) {
        const QPointF at(entry.at.x() - around_.left(), top + entry.at.y());
        painter.save();
        if (entry.own.paint) {
            entry.own.paint(painter, QRectF(at, QSizeF(entry.own.width, row)));
        } else if (entry.layer == nullptr) {
            painter.setPen(thin_pen(entry.own.colour, 2.4, entry.own.line));
            const double middle = at.y() + row / 2.0;
            painter.drawLine(QLineF(at.x() + 2.0, middle, at.x() + kSign - 2.0, middle));
        } else {
            painter.translate(at.x(), at.y() + (row - kSign) / 2.0);
            paint_sign(painter, *entry.layer, layers.*(entry.layer->colour));
        }
        painter.restore();
        painter.setPen(scene.colours.text);
        painter.drawText(QRectF(at.x() + kSign + kSpace, at.y(), width, row),
                         Qt::AlignLeft | Qt::AlignVCenter, entry.own.name);
    }
}

/// The axis of the frame that runs along that edge of the inside; of a frame that stands askew
/// there is none.
void FigureFrame::paint_axis(QPainter& painter, const Scene& scene, bool upright) const {
    constexpr double kLeastPoints = 34.0;  // from one number to the next
    constexpr double kAskew = 1e-6;
    const QTransform back = scene.to_screen.inverted();
    const double length = upright ? scene.size.height() : scene.size.width();
    const QPointF from = back.map(QPointF(0.0, scene.size.height()));
    const QPointF way =
        back.map(upright ? QPointF(0.0, 0.0) : QPointF(length, scene.size.height())) - from;
    const bool along_y = std::abs(way.y()) > std::abs(way.x());
    if (std::min(std::abs(way.x()), std::abs(way.y())) > kAskew * length) return;
    const double begin = along_y ? from.y() : from.x();
    const double span = along_y ? way.y() : way.x();
    // At least 0.4 of its limit, so that numbers have room.
    const double step = round_length(2.5 * kLeastPoints / scene.pixels_per_m);
    const double least = std::min(begin, begin + span);
    const double most = std::max(begin, begin + span);
    const double line = metrics_.height();
    const double bottom = scene.size.height();
    double widest = 0.0;
    for (auto k = std::lround(std::ceil(least / step)); static_cast<double>(k) * step <= most;
         ++k) {
        const double value = static_cast<double>(k) * step;
        const double at = (value - begin) / span * length;
        const QString words = figure_number(value);
        widest = std::max(widest, metrics_.horizontalAdvance(words));
        const double half = metrics_.horizontalAdvance(words) / 2.0;
        if (upright) {
            const double y = bottom - at;
            painter.drawLine(QLineF(-kTick, y, 0.0, y));
            painter.drawText(
                QRectF(-around_.left(), y - line / 2.0, around_.left() - kTick - kSpace, line),
                Qt::AlignRight | Qt::AlignVCenter, words);
        } else {
            painter.drawLine(QLineF(at, bottom, at, bottom + kTick));
            if (at + half > length + around_.right()) continue;
            painter.drawText(QPointF(at - half, bottom + kTick + metrics_.ascent()), words);
        }
    }
    const QString words = along_y ? QStringLiteral("y [m]") : QStringLiteral("x [m]");
    const double half = metrics_.horizontalAdvance(words) / 2.0;
    painter.save();
    if (upright) {
        painter.translate(-kTick - 2.0 * kSpace - widest - metrics_.descent(), bottom / 2.0 + half);
        painter.rotate(-90.0);
        painter.drawText(QPointF(), words);
    } else {
        painter.drawText(QPointF(length / 2.0 - half, bottom + kTick + line + metrics_.ascent()),
                         words);
    }
    painter.restore();
}

}  // namespace hitos::window
