// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure_tool.hpp"

#include <QAction>
#include <QActionGroup>
#include <algorithm>
#include <cmath>

#include "views/canvas_paint.hpp"

namespace hitos::window {
namespace {

constexpr double kArcPixels = 26.0;

PickedPlace place_of(const PointedAt& pointed) {
    return pointed.landmark ? place_on(*pointed.landmark, pointed.place)
                            : PickedPlace{PickedPlace::Kind::point, pointed.place, 0.0};
}

QPointF pixel_of(const Scene& scene, const Point2& point) {
    return scene.to_screen.map(QPointF(point.x, point.y));
}

QString kind_words(const PickedPlace& place) {
    switch (place.kind) {
        case PickedPlace::Kind::wall:
            return MeasureTool::tr("Wall");
        case PickedPlace::Kind::corner:
            return MeasureTool::tr("Corner");
        default:
            return place_words(QPointF(place.at.x, place.at.y));
    }
}

/// The angle's arc, on the side that is less than half a turn.
void draw_arc(QPainter& painter, const QPointF& from, const QPointF& vertex, const QPointF& to) {
    const double begin = QLineF(vertex, from).angle();
    const double sweep = std::remainder(QLineF(vertex, to).angle() - begin, 360.0);
    const QRectF box(vertex - QPointF(kArcPixels, kArcPixels),
                     QSizeF(2.0 * kArcPixels, 2.0 * kArcPixels));
    painter.drawArc(box, static_cast<int>(std::lround(begin * 16.0)),
                    static_cast<int>(std::lround(sweep * 16.0)));
}

/// A measurement's line, and its value on it where that is in sight.
void draw_measured(QPainter& painter, const Scene& scene, const MeasuredValue& measured,
                   const QStringList& words, const QColor& colour) {
    QPolygonF line;
    for (const Point2& point : measured.line) line.append(pixel_of(scene, point));
    if (line.size() < 2) return;
    painter.setBrush(Qt::NoBrush);
    for (const QPen& pen : {thin_pen(faded(Qt::white, 200), 4.5), thin_pen(colour, 2.2)}) {
        painter.setPen(pen);
        painter.drawPolyline(line);
        if (line.size() == 3) draw_arc(painter, line[0], line[1], line[2]);
    }
    draw_disc(painter, line.front(), 4.0, colour);
    draw_disc(painter, line.back(), 4.0, colour);
    const QPointF place = line.size() == 3 ? line[1] : (line.front() + line.back()) / 2.0;
    if (QRectF(QPointF(), scene.size).contains(place)) {
        draw_chip(painter, scene, place + QPointF(9.0, 9.0), words);
    }
}

}  // namespace

MeasureTool::MeasureTool(Measurements& measurements, QAction* distance, QAction* angle,
                         QObject* parent)
    : ViewTool(parent), measurements_(measurements), distance_(distance), angle_(angle) {
    auto* group = new QActionGroup(this);
    group->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
    for (QAction* action : {distance_, angle_}) {
        group->addAction(action);
        connect(action, &QAction::toggled, this, &MeasureTool::begin);
    }
    connect(&measurements, &Measurements::changed, this, &ViewTool::changed);
    connect(&measurements, &Measurements::log_changed, this, [this] {
        picked_.clear();
        hovered_.reset();
    });
}

void MeasureTool::begin() {
    picked_.clear();
    hovered_.reset();
    emit switched();
    if (!takes_clicks()) return;
    emit notice(wanted() == Quantity::distance
                    ? tr("Click two walls, corners or places (Shift: any place); Esc ends.")
                    : tr("Click two walls, or three corners or places with the vertex second "
                         "(Shift: any place); Esc ends."));
}

bool MeasureTool::takes_clicks() const {
    return distance_->isChecked() || angle_->isChecked();
}

Quantity MeasureTool::wanted() const {
    return angle_->isChecked() ? Quantity::angle : Quantity::distance;
}

void MeasureTool::set_shown(bool on) {
    shown_ = on;
    emit changed();
}

void MeasureTool::hover(const std::optional<PointedAt>& pointed) {
    if (!pointed && !hovered_) return;
    hovered_ = pointed ? std::optional(place_of(*pointed)) : std::nullopt;
    emit changed();
}

void MeasureTool::click(const PointedAt& pointed) {
    picked_.push_back(place_of(pointed));
    if (auto made = measurement_of(wanted(), picked_)) {
        picked_.clear();
        measurements_.add(std::move(*made));
    }
    emit changed();
}

void MeasureTool::escape() {
    if (picked_.empty()) {
        distance_->setChecked(false);
        angle_->setChecked(false);
        return;
    }
    picked_.clear();
    emit changed();
}

void MeasureTool::paint(QPainter& painter, const Scene& scene) const {
    if (!shown_ && !takes_clicks()) return;
    const std::vector<MeasuredRow>& rows = measurements_.rows();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (static_cast<int>(i) != measurements_.chosen())
            paint_row(painter, scene, rows[i], false);
    }
    if (measurements_.chosen() >= 0) {
        paint_row(painter, scene, rows[static_cast<std::size_t>(measurements_.chosen())], true);
    }
    if (takes_clicks()) paint_picking(painter, scene);
}

void MeasureTool::paint_row(QPainter& painter, const Scene& scene, const MeasuredRow& row,
                            bool strong) const {
    const HandMeasurement& measurement = row.measurement;
    draw_measured(painter, scene, row.slam,
                  {QString::fromStdString(measurement.name) + "  " +
                   value_words(measurement.quantity, row.slam.value)},
                  strong ? scene.colours.highlight : scene.colours.accent);
}

void MeasureTool::paint_picking(QPainter& painter, const Scene& scene) const {
    std::vector<PickedPlace> places = picked_;
    if (hovered_) places.push_back(*hovered_);
    if (const auto next = measurement_of(wanted(), places); next && hovered_) {
        const MeasuredValue value = measurements_.value_of(*next);
        draw_measured(painter, scene, value, {value_words(next->quantity, value.value)},
                      scene.colours.highlight);
    }
    painter.setPen(thin_pen(scene.colours.highlight, 2.0));
    for (std::size_t i = 1; i < places.size() && places.size() < 3; ++i) {
        painter.drawLine(pixel_of(scene, places[i - 1].at), pixel_of(scene, places[i].at));
    }
    for (const PickedPlace& place : places) {
        draw_disc(painter, pixel_of(scene, place.at), 4.0, scene.colours.highlight);
    }
    if (hovered_) {
        draw_chip(painter, scene, pixel_of(scene, hovered_->at) + QPointF(14.0, -34.0),
                  {kind_words(*hovered_)});
    }
}

}  // namespace hitos::window
