// SPDX-License-Identifier: GPL-3.0-or-later
#include "clipping_device.hpp"

#include <QPaintEngine>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <optional>

namespace hitos::window {
namespace {

/// QRectF::contains() says no of what has no area, such as an upright line.
bool holds(const QRectF& outer, const QRectF& inner) {
    return inner.left() >= outer.left() && inner.right() <= outer.right() &&
           inner.top() >= outer.top() && inner.bottom() <= outer.bottom();
}

/// The part of the line within the rectangle (Liang and Barsky).
std::optional<QLineF> part_within(const QLineF& line, const QRectF& clip) {
    double from = 0.0;
    double to = 1.0;
    // How far the line moves out of a side, and how far its start is from leaving by it.
    const auto cut = [&](double outwards, double room) {
        if (outwards == 0.0) return room >= 0.0;
        if (outwards > 0.0)
            to = std::min(to, room / outwards);
        else
            from = std::max(from, room / outwards);
        return from <= to;
    };
    if (!cut(-line.dx(), line.x1() - clip.left()) || !cut(line.dx(), clip.right() - line.x1()) ||
        !cut(-line.dy(), line.y1() - clip.top()) || !cut(line.dy(), clip.bottom() - line.y1()))
        return std::nullopt;
    // Its own ends as they are, else the next part would not seem to go on from there.
    return QLineF(from > 0.0 ? line.pointAt(from) : line.p1(),
                  to < 1.0 ? line.pointAt(to) : line.p2());
}

class ClippingEngine final : public QPaintEngine {
  public:
    explicit ClippingEngine(QPaintDevice& target)  // with what QSvgGenerator's own can do
        : QPaintEngine(PaintEngineFeatures(AllFeatures) & ~PaintEngineFeatures(PatternBrush) &
                       ~PaintEngineFeatures(PerspectiveTransform) &
                       ~PaintEngineFeatures(ConicalGradientFill) &
                       ~PaintEngineFeatures(PorterDuff)),
          target_(target) {}

    bool begin(QPaintDevice* /*device*/) override { return out_.begin(&target_); }
    bool end() override { return out_.end(); }
    Type type() const override { return User; }

    void updateState(const QPaintEngineState& now) override {
        const DirtyFlags changed = now.state();
        if (changed.testFlag(DirtyTransform)) out_.setTransform(now.transform());
        if (changed.testFlag(DirtyPen)) out_.setPen(now.pen());
        if (changed.testFlag(DirtyBrush)) out_.setBrush(now.brush());
        if (changed.testFlag(DirtyBrushOrigin)) out_.setBrushOrigin(now.brushOrigin());
        if (changed.testFlag(DirtyFont)) out_.setFont(now.font());
        if (changed.testFlag(DirtyOpacity)) out_.setOpacity(now.opacity());
        if (changed.testFlag(DirtyHints)) {
            out_.setRenderHints(out_.renderHints(), false);
            out_.setRenderHints(now.renderHints());
        }
        if (changed.testFlag(DirtyBackground)) out_.setBackground(now.backgroundBrush());
        if (changed.testFlag(DirtyBackgroundMode)) out_.setBackgroundMode(now.backgroundMode());
    }

    using QPaintEngine::drawPolygon;
    void drawPolygon(const QPointF* points, int count, PolygonDrawMode mode) override {
        const QPolygonF polygon(QList<QPointF>(points, points + count));
        if (mode == PolylineMode) {
            if (const auto clip = cut_by(polygon.boundingRect()))
                draw_within(polygon, *clip);
            else
                out_.drawPolyline(polygon);
            return;
        }
        const Qt::FillRule rule = mode == WindingMode ? Qt::WindingFill : Qt::OddEvenFill;
        if (!cut_by(polygon.boundingRect())) return out_.drawPolygon(polygon, rule);
        QPainterPath path;
        path.setFillRule(rule);
        path.addPolygon(polygon);
        path.closeSubpath();
        drawPath(path);
    }

    void drawPath(const QPainterPath& path) override {
        const std::optional<QRectF> clip = cut_by(path.controlPointRect());
        if (!clip) return out_.drawPath(path);
        if (out_.brush().style() != Qt::NoBrush) {
            QPainterPath within;
            within.addRect(*clip);
            const QPen pen = out_.pen();
            out_.setPen(Qt::NoPen);
            within = within.intersected(path);
            if (!within.isEmpty()) out_.drawPath(within);
            out_.setPen(pen);
        }
        if (out_.pen().style() == Qt::NoPen) return;
        for (const QPolygonF& line : path.toSubpathPolygons()) draw_within(line, *clip);
    }

    void drawPixmap(const QRectF& place, const QPixmap& pixmap, const QRectF& source) override {
        drawImage(place, pixmap.toImage(), source, Qt::AutoColor);
    }

    void drawImage(const QRectF& place, const QImage& image, const QRectF& source,
                   Qt::ImageConversionFlags flags) override {
        const std::optional<QRectF> clip = cut_by(place);
        if (!clip && source == QRectF(image.rect()))
            return out_.drawImage(place, image, source, flags);
        const QRectF seen = clip ? place & *clip : place;
        if (!seen.isEmpty()) draw_piece(place, image, source, seen);
    }

    void drawTextItem(const QPointF& place, const QTextItem& text) override {
        const QRectF around(place.x(), place.y() - text.ascent(), text.width(),
                            text.ascent() + text.descent());
        const std::optional<QRectF> clip = cut_by(around);
        if (!clip || clip->intersects(around)) out_.drawTextItem(place, text);
    }

  private:
    /// By what something in these bounds is to be cut; nothing where it is seen as a whole.
    std::optional<QRectF> cut_by(const QRectF& bounds) const {
        if (!painter()->hasClipping()) return std::nullopt;
        const QRectF clip = painter()->clipBoundingRect();
        if (holds(clip, bounds)) return std::nullopt;
        return clip;
    }

    void draw_within(const QPolygonF& line, const QRectF& clip) {
        QPolygonF piece;
        const auto draw = [&] {
            if (piece.size() > 1) out_.drawPolyline(piece);
            piece.clear();
        };
        for (qsizetype i = 1; i < line.size(); ++i) {
            const std::optional<QLineF> part = part_within({line[i - 1], line[i]}, clip);
            if (!part) {
                draw();
                continue;
            }
            if (piece.isEmpty() || piece.last() != part->p1()) {
                draw();
                piece << part->p1();
            }
            piece << part->p2();
        }
        draw();
    }

    /// What is seen, as a picture of its own: QSvgGenerator draws all of one whatever part of it is
    /// wanted. Where its pixels are large they are divided, so that they too end with the clip.
    void draw_piece(const QRectF& place, const QImage& image, const QRectF& source,
                    const QRectF& seen) {
        const QRectF drawn = out_.transform().mapRect(place);
        const double largest =
            std::max(drawn.width() / source.width(), drawn.height() / source.height());
        const int parts = std::clamp(static_cast<int>(std::ceil(2.0 * largest)), 1, 16);
        QTransform parts_place;  // of the image's pixels, each divided
        parts_place.translate(place.left(), place.top());
        parts_place.scale(place.width() / source.width() / parts,
                          place.height() / source.height() / parts);
        parts_place.translate(-source.left() * parts, -source.top() * parts);
        const QRect wanted = parts_place.inverted().mapRect(seen).toRect();
        const QRect whole(QPoint(wanted.left() / parts, wanted.top() / parts),
                          QPoint(wanted.right() / parts, wanted.bottom() / parts));
        if (wanted.isEmpty()) return;
        const QImage piece = image.copy(whole)
                                 .scaled(whole.size() * parts)
                                 .copy(wanted.translated(-whole.topLeft() * parts));
        out_.drawImage(parts_place.mapRect(QRectF(wanted)), piece);
    }

    QPaintDevice& target_;
    QPainter out_;
};

}  // namespace

ClippingDevice::ClippingDevice(QPaintDevice& target)
    : target_(target), engine_(std::make_unique<ClippingEngine>(target)) {}

ClippingDevice::~ClippingDevice() = default;

QPaintEngine* ClippingDevice::paintEngine() const {
    return engine_.get();
}

int ClippingDevice::metric(PaintDeviceMetric metric) const {
    switch (metric) {
        case PdmWidth:
            return target_.width();
        case PdmHeight:
            return target_.height();
        case PdmWidthMM:
            return target_.widthMM();
        case PdmHeightMM:
            return target_.heightMM();
        case PdmNumColors:
            return target_.colorCount();
        case PdmDepth:
            return target_.depth();
        case PdmDpiX:
            return target_.logicalDpiX();
        case PdmDpiY:
            return target_.logicalDpiY();
        case PdmPhysicalDpiX:
            return target_.physicalDpiX();
        case PdmPhysicalDpiY:
            return target_.physicalDpiY();
        case PdmDevicePixelRatio:
            return qRound(target_.devicePixelRatio());
        case PdmDevicePixelRatioScaled:
            return qRound(target_.devicePixelRatioF() * devicePixelRatioFScale());
        default:
            return QPaintDevice::metric(metric);
    }
}

}  // namespace hitos::window
