// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers.hpp"

#include <QCoreApplication>
#include <QPainter>
#include <QPixmap>

namespace hitos::window {
namespace {

constexpr int kSide = 16;

QPixmap drawn_sign(const LayerInfo& info, const QColor& colour) {
    constexpr double kScale = 2.0;  // for screens with small pixels
    QPixmap sign(QSize(kSide, kSide) * kScale);
    sign.setDevicePixelRatio(kScale);
    sign.fill(Qt::transparent);
    QPainter painter(&sign);
    painter.setRenderHint(QPainter::Antialiasing);
    paint_sign(painter, info, colour);
    return sign;
}

}  // namespace

void paint_sign(QPainter& painter, const LayerInfo& info, const QColor& colour) {
    painter.setBrush(Qt::NoBrush);
    QPen pen(colour, 2.0);
    pen.setCapStyle(Qt::RoundCap);
    const QLineF stroke(2.0, 12.0, 14.0, 4.0);
    switch (info.sign) {
        case Sign::points:
            pen.setWidthF(3.2);
            painter.setPen(pen);
            painter.drawPoints(QPolygonF{{2.5, 12.0}, {6.5, 8.0}, {10.0, 7.0}, {13.5, 3.5}});
            break;
        case Sign::squares:
            painter.setPen(pen);
            painter.drawLine(stroke);
            painter.drawRect(QRectF(10.0, 1.5, 5.0, 5.0));
            break;
        case Sign::dashes:
            pen.setDashPattern({2.0, 2.0});
            [[fallthrough]];
        case Sign::stroke:
            painter.setPen(pen);
            painter.drawLine(stroke);
            break;
        case Sign::arrows:
            pen.setWidthF(1.4);
            painter.setPen(pen);
            for (const double x : {2.0, 6.0, 9.0})
                painter.drawLine(QLineF(x, 12.0 - x / 2.0, x + 5.0, 8.0 - x / 2.0));
            break;
        case Sign::ellipse:
            pen.setWidthF(1.2);
            painter.setPen(pen);
            painter.drawEllipse(QRectF(1.5, 4.0, 13.0, 8.0));
            painter.drawEllipse(QRectF(5.0, 6.2, 6.0, 3.6));
            break;
        case Sign::text:
            painter.setPen(pen);
            painter.drawText(QRectF(0.0, 0.0, kSide, kSide), Qt::AlignCenter, "12");
            break;
        case Sign::robot:
            painter.setPen(pen);
            painter.drawPolygon(
                QPolygonF{{3.5, 14.0}, {3.5, 6.0}, {8.0, 2.0}, {12.5, 6.0}, {12.5, 14.0}});
            break;
    }
}

QString layer_name(const LayerInfo& info, bool particles) {
    const char* name = particles || info.alone == nullptr ? info.name : info.alone;
    return *name == '\0' ? QString() : QCoreApplication::translate("Layers", name);
}

QString layer_meaning(const LayerInfo& info) {
    return QCoreApplication::translate("Layers", info.meaning);
}

QIcon layer_sign(const LayerInfo& info) {
    const QColor colour = colours().*info.colour;
    QColor faint = colour;
    constexpr int kFaint = 70;
    faint.setAlpha(kFaint);
    QIcon icon;
    icon.addPixmap(drawn_sign(info, colour), QIcon::Normal, QIcon::On);
    icon.addPixmap(drawn_sign(info, faint), QIcon::Normal, QIcon::Off);
    return icon;
}

LayerSet default_layers() {
    LayerSet layers;
    for (const LayerInfo& info : kLayerTable) layers.set(info.layer, info.on);
    return layers;
}

}  // namespace hitos::window
