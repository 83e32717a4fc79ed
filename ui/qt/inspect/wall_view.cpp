// SPDX-License-Identifier: GPL-3.0-or-later
#include "wall_view.hpp"

#include <QKeyEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "views/canvas_paint.hpp"

namespace hitos::window {
namespace {

double cross(const QPointF& a, const QPointF& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// The nearest of some places from one on, in a direction: at most 45 degrees aside; nothing where
/// there is none.
std::optional<std::size_t> next_in(const std::vector<QPointF>& places, const QPointF& from,
                                   const QPointF& direction) {
    constexpr double kSame = 1e-6;  // [m]
    std::optional<std::size_t> next;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < places.size(); ++i) {
        const QPointF way = places[i] - from;
        const double ahead = QPointF::dotProduct(way, direction);
        const double length = std::hypot(way.x(), way.y());
        if (length < kSame || ahead < std::abs(cross(way, direction)) || length >= nearest)
            continue;
        nearest = length;
        next = i;
    }
    return next;
}

}  // namespace

QLineF seen_from(const QLineF& wall, const QPointF& eye) {
    // Who looks at a wall has its left end where the turn to the right end is clockwise.
    return cross(wall.p1() - eye, wall.p2() - eye) < 0.0 ? wall : QLineF(wall.p2(), wall.p1());
}

WallView::WallView(const QString& name, QString empty_text, QWidget* parent)
    : CanvasView(parent), empty_text_(std::move(empty_text)) {
    setAccessibleName(name);
}

void WallView::set_walls(Walls walls) {
    walls_ = std::move(walls);
    set_turn(walls_.sided ? kPi / 2.0 : 0.0);  // ahead is up, as in the last scan
    std::vector<QPointF> all = walls_.dots;
    for (const QLineF& wall : walls_.walls) {
        all.push_back(wall.p1());
        all.push_back(wall.p2());
    }
    // Readings through doors would make all else small.
    if (walls_.walls.size() > 2)
        all.erase(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(walls_.dots.size()));
    if (walls_.robot) all.emplace_back(walls_.robot->x, walls_.robot->y);
    content_ = box_of(all);
    content_changed(std::nullopt);
}

void WallView::set_dots(std::vector<QPointF> dots, const std::optional<Pose>& robot) {
    walls_.dots = std::move(dots);
    walls_.robot = robot;
    update();
}

void WallView::set_of_places(bool places) {
    of_places_ = places;
    update();
}

void WallView::choose_wall(const std::optional<QLineF>& wall) {
    wall_ = wall;
    update();
}

void WallView::choose_place(const std::optional<QPointF>& place) {
    place_ = place;
    update();
}

void WallView::click(const QPointF& point) {
    if (of_places_) {
        place_ = point;
        double nearest = tolerance_m();
        for (const QPointF& place : walls_.places) {
            const double away = QLineF(place, point).length();
            if (away >= nearest) continue;
            nearest = away;
            place_ = place;
        }
    } else {
        // Beside it: on which side says from where it is seen.
        const QLineF* found = nullptr;
        double nearest = 3.0 * tolerance_m();
        for (const QLineF& wall : walls_.walls) {
            const double away = distance_to(wall, point);
            if (away >= nearest) continue;
            nearest = away;
            found = &wall;
        }
        if (found == nullptr) return;
        wall_ = walls_.sided ? *found : seen_from(*found, point);
    }
    update();
    emit chosen();
}

/// To the nearest wall or place in a direction of the screen.
void WallView::go(const QPointF& direction) {
    const double turn = -camera().turn_rad;
    const QPointF ahead(std::cos(turn) * direction.x() - std::sin(turn) * direction.y(),
                        std::sin(turn) * direction.x() + std::cos(turn) * direction.y());
    std::vector<QPointF> places = walls_.places;
    if (!of_places_) {
        places.clear();
        for (const QLineF& wall : walls_.walls) places.push_back(wall.center());
    }
    const QPointF middle = content_.center();
    const QPointF from = of_places_ ? place_.value_or(middle) : wall_ ? wall_->center() : middle;
    const auto next = next_in(places, from, ahead);
    if (!next) return;
    if (of_places_) {
        place_ = places[*next];
    } else {
        const QLineF& wall = walls_.walls[*next];
        wall_ = walls_.sided ? wall : seen_from(wall, from);
    }
    update();
    emit chosen();
}

void WallView::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Left:
            go({-1.0, 0.0});
            break;
        case Qt::Key_Right:
            go({1.0, 0.0});
            break;
        case Qt::Key_Up:
            go({0.0, 1.0});
            break;
        case Qt::Key_Down:
            go({0.0, -1.0});
            break;
        case Qt::Key_Space:
            if (!wall_ || of_places_ || walls_.sided) break;
            wall_ = QLineF(wall_->p2(), wall_->p1());
            update();
            emit chosen();
            break;
        default:
            CanvasView::keyPressEvent(event);
    }
}

void WallView::paint_scene(QPainter& painter, const Scene& scene) const {
    draw_metre_grid(painter, scene);
    painter.setPen(thin_pen(walls_.sided ? scene.colours.observed : scene.colours.text,
                            walls_.sided ? 2.6 : 1.4));
    for (const QLineF& wall : walls_.walls) painter.drawLine(scene.to_screen.map(wall));
    painter.setPen(QPen(scene.colours.scan, 2.6, Qt::SolidLine, Qt::RoundCap));
    for (const QPointF& dot : walls_.dots) painter.drawPoint(scene.to_screen.map(dot));
    if (walls_.robot) draw_robot(painter, scene, *walls_.robot);
    if (of_places_ && place_) {
        const QPointF at = scene.to_screen.map(*place_);
        draw_disc(painter, at, 4.0, scene.colours.highlight);
        draw_cross(painter, at, scene.colours.highlight);
    }
    if (!of_places_ && wall_) {
        const QLineF wall = scene.to_screen.map(*wall_);
        painter.setPen(thin_pen(scene.colours.highlight, 4.0));
        painter.drawLine(wall);
        // An arrow from where the robot stands; on the screen y points down.
        const double length = std::max(wall.length(), 1e-9);
        const QPointF along = (wall.p2() - wall.p1()) / length;
        const QPointF back(-along.y(), along.x());
        const QPointF tip = wall.center() + 4.0 * back;
        painter.setPen(thin_pen(scene.colours.highlight, 2.0));
        painter.drawLine(tip, tip + 22.0 * back);
        painter.drawLine(tip, tip + 7.0 * back + 5.0 * along);
        painter.drawLine(tip, tip + 7.0 * back - 5.0 * along);
    }
    if (scene.scale_bar) draw_scale_bar(painter, scene);
}

}  // namespace hitos::window
