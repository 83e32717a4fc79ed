// SPDX-License-Identifier: GPL-3.0-or-later
#include "loop_view.hpp"

#include <QFontMetricsF>
#include <QGuiApplication>
#include <QKeyEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "views/canvas_paint.hpp"

namespace hitos::window {
namespace {

constexpr double kPassage = 5.0;  // [m] of way before and behind a scan

/// Points of the keys about a scan of the tour, seen from that scan. Their own poses say how they
/// lie to each other.
std::vector<QPointF> passage(const Snapshot& snapshot, std::uint64_t scan) {
    std::vector<QPointF> points;
    const std::size_t count = std::min(snapshot.keys.size(), snapshot.key_scans.size());
    const auto keys = std::span(snapshot.keys).first(count);
    const auto middle = std::ranges::lower_bound(keys, scan, {}, &KeyPose::scan);
    if (middle == keys.end()) return points;
    const Pose from = inverse(middle->pose);
    const auto add = [&](std::size_t key) {
        const Pose pose = compose(from, keys[key].pose);
        for (const Point2& point : snapshot.key_scans[key]->points)
            points.push_back(point_of(transform(pose, point)));
    };
    const auto way = [&](std::size_t key) {
        return std::hypot(keys[key + 1].pose.x - keys[key].pose.x,
                          keys[key + 1].pose.y - keys[key].pose.y);
    };
    const auto at = static_cast<std::size_t>(middle - keys.begin());
    add(at);
    double way_m = 0.0;
    for (std::size_t key = at; key > 0 && (way_m += way(key - 1)) < kPassage; --key) add(key - 1);
    way_m = 0.0;
    for (std::size_t key = at; key + 1 < count && (way_m += way(key)) < kPassage; ++key)
        add(key + 1);
    return points;
}

void draw_points(QPainter& painter, const Scene& scene, const std::vector<QPointF>& points,
                 const QColor& colour) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(faded(colour, 150));
    for (const QPointF& point : points) painter.drawEllipse(scene.to_screen.map(point), 1.4, 1.4);
}

}  // namespace

LoopView::LoopView(QWidget* parent) : CanvasView(parent) {
    setAccessibleName(tr("Both passages of the loop"));
}

void LoopView::set_loop(const std::shared_ptr<const Snapshot>& snapshot,
                        const std::optional<RunLoop>& loop) {
    const bool same = loop && loop_ && loop->record.scan == loop_->record.scan &&
                      loop->record.earlier == loop_->record.earlier;
    loop_ = loop;
    earlier_.clear();
    later_alone_.clear();
    by_hand_ = by_hand_ && same;
    if (loop && !by_hand_) pose_ = loop->record.pose_earlier_scan;
    if (snapshot && loop) {
        earlier_ = passage(*snapshot, loop->record.earlier);
        later_alone_ = passage(*snapshot, loop->record.scan);
    }
    place_later();
    if (!same) fit();
}

void LoopView::place_later() {
    later_.clear();
    for (const QPointF& point : later_alone_)
        later_.push_back(point_of(transform(pose_, Point2{point.x(), point.y()})));
    content_changed(std::nullopt);
}

void LoopView::lay(const Pose& pose) {
    if (!loop_) return;
    pose_ = pose;
    by_hand_ = true;
    place_later();
    emit laid();
}

bool LoopView::pick_up(const QPointF& point) {
    const double reach = 2.0 * tolerance_m();
    const bool there = std::ranges::any_of(
        later_, [&](const QPointF& one) { return QLineF(one, point).length() < reach; });
    turning_ = QGuiApplication::keyboardModifiers().testFlag(Qt::ShiftModifier);
    dragged_from_ = point;
    return there;
}

void LoopView::drag(const QPointF& point) {
    const QPointF from = std::exchange(dragged_from_, point);
    hold_camera(true);
    Pose next = pose_;
    if (turning_) {
        const auto bearing = [&](const QPointF& at) {
            return std::atan2(at.y() - pose_.y, at.x() - pose_.x);
        };
        next.theta = wrap_angle(pose_.theta + bearing(point) - bearing(from));
    } else {
        next.x += point.x() - from.x();
        next.y += point.y() - from.y();
    }
    lay(next);
    hold_camera(false);
}

void LoopView::keyPressEvent(QKeyEvent* event) {
    constexpr double kStep = 0.05;  // [m]
    const bool turns = event->modifiers().testFlag(Qt::ShiftModifier);
    Pose next = pose_;
    switch (event->key()) {
        case Qt::Key_Left:
            turns ? next.theta = wrap_angle(next.theta + kRadiansPerDegree) : next.x -= kStep;
            break;
        case Qt::Key_Right:
            turns ? next.theta = wrap_angle(next.theta - kRadiansPerDegree) : next.x += kStep;
            break;
        case Qt::Key_Up:
            next.y += kStep;
            break;
        case Qt::Key_Down:
            next.y -= kStep;
            break;
        default:
            CanvasView::keyPressEvent(event);
            return;
    }
    lay(next);
}

QRectF LoopView::content() const {
    return box_of(earlier_) | box_of(later_);
}

void LoopView::paint_scene(QPainter& painter, const Scene& scene) const {
    if (!loop_) return;
    draw_metre_grid(painter, scene);
    draw_points(painter, scene, earlier_, scene.colours.landmark);
    draw_points(painter, scene, later_, scene.colours.particle);
    draw_robot(painter, scene, {});
    draw_robot(painter, scene, pose_);
    if (!scene.chrome) return;
    const QPointF corner(8.0, 8.0);
    draw_chip(painter, scene, corner,
              {"    " + tr("scan %1").arg(loop_->record.earlier + 1),
               "    " + tr("scan %1").arg(loop_->record.scan + 1)});
    const double line = QFontMetricsF(painter.font()).height();
    const QPointF first = corner + QPointF(12.0, 5.0 + line / 2.0);
    draw_disc(painter, first, 3.5, scene.colours.landmark);
    draw_disc(painter, first + QPointF(0.0, line), 3.5, scene.colours.particle);
}

QString LoopView::empty_text() const {
    return tr("Choose a place: the scans of both passages stand here, one over the other.");
}

}  // namespace hitos::window
