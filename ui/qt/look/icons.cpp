// SPDX-License-Identifier: GPL-3.0-or-later
#include "icons.hpp"

#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>
#include <cmath>

#include "theme.hpp"

namespace hitos::window {
namespace {

// Everything is drawn on a square of 24 units.
void draw_application(QPainter& p) {
    p.setPen(Qt::NoPen);
    p.setBrush(QColor("#1f5fd6"));
    p.drawRoundedRect(QRectF(1, 1, 22, 22), 5.5, 5.5);
    p.setPen(QPen(Qt::white, 1.7, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    p.drawPolyline(QPolygonF{{5.0, 18.5}, {5.0, 6.0}, {18.5, 6.0}});
    p.setPen(QPen(QColor("#ffc35a"), 1.5, Qt::SolidLine, Qt::RoundCap));
    QPainterPath path(QPointF(17.5, 19.0));
    path.cubicTo(17.5, 12.0, 10.0, 17.0, 9.3, 10.5);
    p.setBrush(Qt::NoBrush);
    p.drawPath(path);
    p.setPen(Qt::NoPen);
    p.setBrush(QColor("#ffc35a"));
    p.drawEllipse(QPointF(17.5, 18.8), 1.9, 1.9);
    p.setBrush(Qt::white);
    p.drawPolygon(QPolygonF{{5.0, 2.9}, {8.1, 6.0}, {5.0, 9.1}, {1.9, 6.0}});
}

void draw_folded_map(QPainter& p) {
    p.drawPolygon(
        QPolygonF{{3, 6}, {9, 4}, {15, 6}, {21, 4}, {21, 18}, {15, 20}, {9, 18}, {3, 20}});
    p.drawLine(QPointF(9, 4), QPointF(9, 18));
    p.drawLine(QPointF(15, 6), QPointF(15, 20));
}

/// What a triangle or circle is about.
void draw_mark(QPainter& p, const QColor& colour, double top, double bottom) {
    p.drawLine(QPointF(12, top), QPointF(12, bottom - 4));
    p.setBrush(colour);
    p.setPen(Qt::NoPen);
    p.drawEllipse(QPointF(12, bottom), 1.3, 1.3);
}

void draw_folder(QPainter& p) {
    p.drawPolyline(QPolygonF{{3, 19}, {3, 5}, {9, 5}, {11, 8}, {20, 8}, {20, 11}});
    p.drawPolygon(QPolygonF{{3, 19}, {6, 11}, {22, 11}, {19, 19}});
}

void draw_arrow(QPainter& p, double quarters) {
    p.translate(12, 12);
    p.rotate(90.0 * quarters);
    p.drawLine(QPointF(-8, 0), QPointF(8, 0));
    p.drawPolyline(QPolygonF{{2, -6}, {8, 0}, {2, 6}});
}

void draw_glyph(QPainter& p, Glyph glyph, const QColor& colour) {
    const QPen pen(colour, 1.9, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    p.setPen(pen);
    p.setBrush(Qt::NoBrush);
    switch (glyph) {
        case Glyph::application:
            draw_application(p);
            break;
        case Glyph::run:
            p.setBrush(colour);
            p.drawPolygon(QPolygonF{{7, 4.5}, {19, 12}, {7, 19.5}});
            break;
        case Glyph::stop:
            p.setBrush(colour);
            p.drawRoundedRect(QRectF(6, 5, 4, 14), 1, 1);
            p.drawRoundedRect(QRectF(14, 5, 4, 14), 1, 1);
            break;
        case Glyph::step:
            p.setBrush(colour);
            p.drawPolygon(QPolygonF{{5, 5}, {14, 12}, {5, 19}});
            p.drawLine(QPointF(18.5, 5), QPointF(18.5, 19));
            break;
        case Glyph::full_speed:
            p.setBrush(colour);
            p.drawPolygon(QPolygonF{{3, 5}, {12, 12}, {3, 19}});
            p.drawPolygon(QPolygonF{{12, 5}, {21, 12}, {12, 19}});
            break;
        case Glyph::best_map:
            draw_folded_map(p);
            break;
        case Glyph::odometry: {
            QPainterPath path(QPointF(5, 19));
            path.cubicTo(5, 9, 19, 15, 19, 5);
            p.drawPath(path);
            p.setBrush(colour);
            p.drawEllipse(QPointF(5, 19), 2, 2);
            p.drawEllipse(QPointF(19, 5), 2, 2);
            break;
        }
        case Glyph::save_map:
            p.drawPolyline(QPolygonF{{4, 15}, {4, 20}, {20, 20}, {20, 15}});
            p.drawLine(QPointF(12, 4), QPointF(12, 15));
            p.drawPolyline(QPolygonF{{8, 11}, {12, 15}, {16, 11}});
            break;
        case Glyph::restart:
            p.drawArc(QRectF(5, 5, 14, 14), 60 * 16, 290 * 16);
            p.drawPolyline(QPolygonF{{15.5, 2.5}, {15.8, 6.2}, {12, 7}});
            break;
        case Glyph::open:
            draw_folder(p);
            break;
        case Glyph::settings:
            for (const double y : {6.0, 12.0, 18.0}) p.drawLine(QPointF(3, y), QPointF(21, y));
            p.setBrush(colour);
            p.drawEllipse(QPointF(15, 6), 2.2, 2.2);
            p.drawEllipse(QPointF(8, 12), 2.2, 2.2);
            p.drawEllipse(QPointF(16, 18), 2.2, 2.2);
            break;
        case Glyph::picture:
            p.drawRoundedRect(QRectF(3, 4, 18, 16), 2, 2);
            p.drawPolyline(QPolygonF{{3, 17}, {9, 11}, {14, 16}, {17, 13}, {21, 17}});
            p.drawEllipse(QPointF(16, 8.5), 1.2, 1.2);
            break;
        case Glyph::distance:
            p.drawRoundedRect(QRectF(2, 8, 20, 8), 1.5, 1.5);
            for (const double x : {7.0, 12.0, 17.0}) p.drawLine(QPointF(x, 8), QPointF(x, 12));
            break;
        case Glyph::angle:
            p.drawPolyline(QPolygonF{{17, 4}, {4, 19}, {21, 19}});
            p.drawArc(QRectF(-6, 9, 20, 20), 0, 49 * 16);
            break;
        case Glyph::fit:
            p.drawPolyline(QPolygonF{{4, 9}, {4, 4}, {9, 4}});
            p.drawPolyline(QPolygonF{{15, 4}, {20, 4}, {20, 9}});
            p.drawPolyline(QPolygonF{{20, 15}, {20, 20}, {15, 20}});
            p.drawPolyline(QPolygonF{{9, 20}, {4, 20}, {4, 15}});
            break;
        case Glyph::follow:
            p.drawEllipse(QPointF(12, 12), 6, 6);
            for (const double angle : {0.0, 90.0, 180.0, 270.0}) {
                p.save();
                p.translate(12, 12);
                p.rotate(angle);
                p.drawLine(QPointF(4, 0), QPointF(9.5, 0));
                p.restore();
            }
            break;
        case Glyph::frame:
            p.drawPolyline(QPolygonF{{5, 4}, {5, 19}, {20, 19}});
            p.drawPolyline(QPolygonF{{2.5, 6.5}, {5, 4}, {7.5, 6.5}});
            p.drawPolyline(QPolygonF{{17.5, 16.5}, {20, 19}, {17.5, 21.5}});
            break;
        case Glyph::plots:
            p.drawPolyline(QPolygonF{{3, 4}, {3, 20}, {21, 20}});
            p.drawPolyline(QPolygonF{{6, 16}, {10, 10}, {14, 13}, {20, 5}});
            break;
        case Glyph::zoom_in:
            p.drawLine(QPointF(12, 5), QPointF(12, 19));
            p.drawLine(QPointF(5, 12), QPointF(19, 12));
            break;
        case Glyph::zoom_out:
            p.drawLine(QPointF(5, 12), QPointF(19, 12));
            break;
        case Glyph::information:
            p.drawEllipse(QPointF(12, 12), 9.5, 9.5);
            p.translate(0, 24);
            p.scale(1, -1);
            draw_mark(p, colour, 6.5, 16.8);
            break;
        case Glyph::question: {
            p.drawEllipse(QPointF(12, 12), 9.5, 9.5);
            QPainterPath path(QPointF(9, 9.5));
            path.cubicTo(9, 5.5, 15, 5.5, 15, 9.5);
            path.cubicTo(15, 11.5, 12, 11.5, 12, 13.8);
            p.drawPath(path);
            draw_mark(p, colour, 13.4, 17.6);
            break;
        }
        case Glyph::warning:
            p.drawPolygon(QPolygonF{{12, 2.5}, {22.5, 21}, {1.5, 21}});
            draw_mark(p, colour, 8.5, 17.8);
            break;
        case Glyph::file:
            p.drawPolygon(QPolygonF{{5, 2.5}, {14, 2.5}, {19, 7.5}, {19, 21.5}, {5, 21.5}});
            p.drawPolyline(QPolygonF{{14, 2.5}, {14, 7.5}, {19, 7.5}});
            break;
        case Glyph::new_folder:
            p.drawPolygon(QPolygonF{{2.5, 19}, {2.5, 5}, {9, 5}, {11, 8}, {21.5, 8}, {21.5, 19}});
            p.drawLine(QPointF(12, 10.5), QPointF(12, 16.5));
            p.drawLine(QPointF(9, 13.5), QPointF(15, 13.5));
            break;
        case Glyph::up:
            draw_arrow(p, 3);
            break;
        case Glyph::back:
            draw_arrow(p, 2);
            break;
        case Glyph::forward:
            draw_arrow(p, 0);
            break;
        case Glyph::tiles:
            for (const double x : {4.0, 14.0}) {
                for (const double y : {4.0, 14.0}) p.drawRect(QRectF(x, y, 6, 6));
            }
            break;
        case Glyph::computer:
            p.drawRoundedRect(QRectF(2.5, 4, 19, 12.5), 1.5, 1.5);
            p.drawLine(QPointF(12, 16.5), QPointF(12, 20));
            p.drawLine(QPointF(7.5, 20), QPointF(16.5, 20));
            break;
        case Glyph::clear:
            p.drawLine(QPointF(6, 6), QPointF(18, 18));
            p.drawLine(QPointF(18, 6), QPointF(6, 18));
            break;
        case Glyph::lines:
            for (const double y : {5.0, 10.0, 15.0, 20.0})
                p.drawLine(QPointF(3, y - 0.5), QPointF(21, y - 0.5));
            break;
    }
}

class GlyphEngine final : public QIconEngine {
  public:
    explicit GlyphEngine(Glyph glyph) : glyph_(glyph) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode,
               QIcon::State state) override {
        const Colours& c = colours();
        QColor colour = state == QIcon::On ? c.accent : c.text;
        if (glyph_ == Glyph::run && mode != QIcon::Disabled) colour = c.on_accent;
        if (glyph_ == Glyph::information || glyph_ == Glyph::question) colour = c.accent;
        if (glyph_ == Glyph::warning) colour = c.odometry;
        if (mode == QIcon::Disabled) colour.setAlpha(90);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->translate(rect.topLeft());
        const double side = std::min(rect.width(), rect.height());
        painter->scale(side / 24.0, side / 24.0);
        draw_glyph(*painter, glyph_, colour);
        painter->restore();
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return pixmap;
    }

    QIconEngine* clone() const override { return new GlyphEngine(glyph_); }

  private:
    Glyph glyph_;
};

}  // namespace

QIcon icon(Glyph glyph) {
    return QIcon(new GlyphEngine(glyph));
}

}  // namespace hitos::window
