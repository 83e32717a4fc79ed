// SPDX-License-Identifier: GPL-3.0-or-later
#include "world_view.hpp"

#include <QKeyEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "hitos/simulation/text/world_editing.hpp"
#include "views/canvas_paint.hpp"
#include "views/landmark_painter.hpp"

namespace hitos::window {
namespace {

void draw_walls(QPainter& painter, const Scene& scene, const std::vector<WallSegment>& walls,
                const QPen& pen) {
    painter.setPen(pen);
    for (const WallSegment& wall : walls) {
        painter.drawLine(scene.to_screen.map(point_of(wall.a)),
                         scene.to_screen.map(point_of(wall.b)));
    }
}

std::vector<QPointF> as_points(const std::vector<Point2>& points) {
    std::vector<QPointF> all;
    all.reserve(points.size());
    for (const Point2& point : points) all.push_back(point_of(point));
    return all;
}

/// Everything that lies somewhere.
std::vector<QPointF> all_places(const World& world) {
    std::vector<QPointF> points = {{world.tour.start.x, world.tour.start.y}};
    for (const auto* walls : {&world.walls, &world.doors}) {
        for (const WallSegment& wall : *walls) {
            points.push_back(point_of(wall.a));
            points.push_back(point_of(wall.b));
        }
    }
    for (const Walker& walker : world.walkers) {
        for (const Point2& point : walker.way) points.push_back(point_of(point));
    }
    for (const Point2& mark : world.landmarks.at) points.push_back(point_of(mark));
    for (const WayPoint& point : world.tour.way_points) points.push_back(point_of(point.at));
    for (const Disturbance& event : world.tour.events) {
        if (event.kind == DisturbanceKind::box)
            points.emplace_back(event.values[0], event.values[1]);
    }
    return points;
}

/// What is in sight of a world without walls [m].
constexpr QRectF kEmptySheet(-2.0, -2.0, 14.0, 9.0);

}  // namespace

WorldView::WorldView(QWidget* parent) : CanvasView(parent) {
    setAccessibleName(tr("World"));
    setFocusPolicy(Qt::StrongFocus);
}

const World* WorldView::world() const {
    return tour_ ? &tour_->world() : world_.get();
}

void WorldView::fit() {
    sheet_ = {};
    grow_sheet();
    CanvasView::fit();
}

void WorldView::set_world(std::shared_ptr<const World> world) {
    world_ = std::move(world);
    grow_sheet();
}

/// Whoever draws is not to see everything jump with each line.
void WorldView::grow_sheet() {
    const World* shown = world();
    if (shown == nullptr) return;
    constexpr double kMargin = 1.0;  // m
    const QRectF all = box_of(all_places(*shown));
    if (sheet_.isEmpty()) {
        sheet_ = shown->walls.empty() ? kEmptySheet.united(all) : all;
    } else if (!sheet_.contains(all)) {
        sheet_ = sheet_.united(all.adjusted(-kMargin, -kMargin, kMargin, kMargin));
    }
    content_changed(std::nullopt);
}

void WorldView::set_tour(std::shared_ptr<const SimulatedTour> tour) {
    tour_ = std::move(tour);
    goal_.reset();
    set_held(0);
    grow_sheet();
}

void WorldView::set_snapshot(std::shared_ptr<const Snapshot> snapshot) {
    snapshot_ = snapshot && snapshot->steps > 0 ? std::move(snapshot) : nullptr;
    update();
}

void WorldView::set_goal(std::optional<Point2> goal) {
    goal_ = goal;
    update();
}

void WorldView::refresh() {
    if (!tour_) return;
    const Pose robot = tour_->pose_now();
    content_changed(QPointF(robot.x, robot.y));
}

LayerSet WorldView::drawable() const {
    if (!tour_) return {};
    LayerSet layers{Layer::scan, Layer::robot};
    if (snapshot_) {
        layers = {Layer::scan,        Layer::robot,   Layer::landmarks, Layer::path,
                  Layer::uncertainty, Layer::endless, Layer::names,     Layer::particles};
    }
    return layers;
}

QRectF WorldView::content() const {
    return sheet_;
}

std::optional<ICaracteristica> WorldView::landmark_below(const QPointF& point) const {
    Q_UNUSED(point)
    return std::nullopt;
}

QString WorldView::empty_text() const {
    return tr("Draw a world, or open one, and drive a robot through it.");
}

void WorldView::click(const QPointF& point) {
    if (tour_) emit goal_chosen(point);
}

/// The goal.
bool WorldView::pick_up(const QPointF& point) {
    return tour_ && goal_ &&
           std::hypot(point.x() - goal_->x, point.y() - goal_->y) <= tolerance_m();
}

void WorldView::drag(const QPointF& point) {
    if (tour_) emit goal_chosen(point);
}

void WorldView::paint_scene(QPainter& painter, const Scene& scene) const {
    draw_metre_grid(painter, scene);
    if (tour_) {
        if (layers().has(Layer::scan)) paint_rays(painter, scene);
        paint_walls(painter, scene);
        paint_belief(painter, scene);
        if (layers().has(Layer::robot)) paint_truth(painter, scene);
        if (goal_) {
            draw_cross(painter, scene.to_screen.map(point_of(*goal_)), scene.colours.accent);
        }
    } else if (world_) {
        paint_walls(painter, scene);
        paint_plan(painter, scene);
    }
    if (scene.scale_bar) draw_scale_bar(painter, scene);
}

void WorldView::paint_walls(QPainter& painter, const Scene& scene) const {
    const std::vector<WallSegment> walls = tour_ ? tour_->walls_now() : world()->walls;
    draw_walls(painter, scene, walls, thin_pen(scene.colours.text, 2.0));
    paint_doors(painter, scene, walls);
    paint_marks(painter, scene);
    std::vector<Point2> people;
    if (tour_) people = tour_->people_now();
    for (std::size_t i = 0; i < world()->walkers.size(); ++i) {
        const Walker& walker = world()->walkers[i];
        painter.setPen(thin_pen(scene.colours.text, 1.2));
        painter.setBrush(faded(scene.colours.text, 60));
        const double radius = walker.radius_m * scene.pixels_per_m;
        const Point2 at = tour_ ? people[i] : walker.way.front();
        painter.drawEllipse(scene.to_screen.map(point_of(at)), radius, radius);
    }
}

void WorldView::paint_marks(QPainter& painter, const Scene& scene) const {
    const MarkParams& marks = world()->landmarks;
    for (std::size_t i = 0; i < marks.at.size(); ++i) {
        const QPointF place = scene.to_screen.map(point_of(marks.at[i]));
        if (marks.round()) {
            constexpr double kLeast = 2.5;  // pixels
            const double radius = std::max(kLeast, marks.radii_m[i] * scene.pixels_per_m);
            painter.setPen(thin_pen(scene.colours.accent, 1.6));
            painter.setBrush(faded(scene.colours.accent, 60));
            painter.drawEllipse(place, radius, radius);
        } else {
            draw_cross(painter, place, scene.colours.accent);
            painter.drawText(place + QPointF(5.0, -5.0), QString::number(i));
        }
    }
}

/// Closed ones solid, open ones dashed; with their numbers.
void WorldView::paint_doors(QPainter& painter, const Scene& scene,
                            const std::vector<WallSegment>& walls) const {
    int number = 0;
    for (const WallSegment& door : world()->doors) {
        const bool closed = !tour_ || std::ranges::any_of(walls, [&](const WallSegment& wall) {
            return wall.a == door.a && wall.b == door.b;
        });
        draw_walls(painter, scene, {door},
                   closed ? thin_pen(scene.colours.accent, 3.0)
                          : thin_pen(scene.colours.accent, 1.2, Qt::DashLine));
        const Point2 middle{(door.a.x + door.b.x) / 2.0, (door.a.y + door.b.y) / 2.0};
        painter.setPen(scene.colours.accent);
        painter.drawText(scene.to_screen.map(point_of(middle)) + QPointF(5.0, -5.0),
                         QString::number(++number));
    }
}

/// What is to happen in a world: ways of people, boxes, the tour from its start.
void WorldView::paint_plan(QPainter& painter, const Scene& scene) const {
    for (const Walker& walker : world_->walkers) {
        draw_path(painter, scene, as_points(walker.way),
                  thin_pen(faded(scene.colours.text, 130), 1.2, Qt::DotLine));
    }
    painter.setPen(thin_pen(scene.colours.text, 1.6));
    painter.setBrush(faded(scene.colours.text, 30));
    for (const Disturbance& event : world_->tour.events) {
        if (event.kind != DisturbanceKind::box) continue;
        QPolygonF outline;
        for (const Point2& corner : box_outline(event)) outline << point_of(corner);
        painter.drawPolygon(scene.to_screen.map(outline));
    }
    const TourParams& tour = world_->tour;
    std::vector<QPointF> way = {{tour.start.x, tour.start.y}};
    for (const WayPoint& point : tour.way_points) way.push_back(point_of(point.at));
    draw_path(painter, scene, way, thin_pen(scene.colours.path, 1.2, Qt::DashLine));
    int number = 0;
    for (const WayPoint& point : tour.way_points) {
        const QPointF at = scene.to_screen.map(point_of(point.at));
        draw_disc(painter, at, 3.5, scene.colours.path);
        painter.setPen(scene.colours.muted);
        painter.drawText(at + QPointF(6.0, -4.0), QString::number(++number));
    }
    Colours quiet = scene.colours;
    quiet.robot = quiet.text;
    draw_robot(painter, {scene.to_screen, scene.size, scene.pixels_per_m, quiet, false},
               tour.start);
}

/// In the colour of the walls, which is no colour of what the filter believes.
void WorldView::paint_truth(QPainter& painter, const Scene& scene) const {
    Colours colours = scene.colours;
    colours.robot = colours.text;
    draw_robot(painter, {scene.to_screen, scene.size, scene.pixels_per_m, colours, false},
               tour_->pose_now());
}

/// Where the laser's newest points are in truth.
void WorldView::paint_rays(QPainter& painter, const Scene& scene) const {
    const std::uint64_t scans = tour_->scans();
    if (scans == 0) return;
    const Scan scan = tour_->scan(scans - 1);
    const Pose robot = compose(tour_->world().tour.start, tour_->true_pose(scans - 1));
    const Point2 laser =
        transform(robot, Point2{scan.fan.pose_robot_laser.x, scan.fan.pose_robot_laser.y});
    painter.setPen(thin_pen(faded(scene.colours.scan, 28)));
    const std::vector<Point2> points = shown_points(scan);
    for (const Point2& point : points) {
        painter.drawLine(scene.to_screen.map(point_of(laser)),
                         scene.to_screen.map(point_of(transform(robot, point))));
    }
    for (const Point2& point : points) {
        draw_disc(painter, scene.to_screen.map(point_of(transform(robot, point))), 1.4,
                  scene.colours.scan);
    }
}

void WorldView::paint_landmarks(QPainter& painter, const Scene& scene) const {
    LandmarkStyle style;
    style.uncertainty = layers().has(Layer::uncertainty);
    style.endless = layers().has(Layer::endless);
    style.numbers = layers().has(Layer::names);
    draw_landmarks(painter, scene, {snapshot_->best_map, snapshot_->line_extents}, style);
}

/// The run's frame is that of the start.
void WorldView::paint_belief(QPainter& painter, const Scene& scene) const {
    if (!snapshot_) return;
    const Pose start = tour_->world().tour.start;
    QTransform run_world;
    run_world.translate(start.x, start.y);
    run_world.rotateRadians(start.theta);
    const Scene of_run{run_world * scene.to_screen, scene.size, scene.pixels_per_m, scene.colours,
                       false};
    if (layers().has(Layer::landmarks)) paint_landmarks(painter, of_run);
    if (layers().has(Layer::path)) {
        draw_path(painter, of_run, snapshot_->best_trajectory, thin_pen(scene.colours.path, 1.6));
    }
    if (!layers().has(Layer::particles)) return;
    for (const WeightedPose& hypothesis : snapshot_->hypotheses) {
        draw_disc(painter, of_run.to_screen.map(QPointF(hypothesis.pose.x, hypothesis.pose.y)), 1.6,
                  scene.colours.particle);
    }
    const Pose& best = snapshot_->best_pose;
    const QPointF at = of_run.to_screen.map(QPointF(best.x, best.y));
    constexpr double kNose = 0.4;  // m
    painter.setPen(thin_pen(scene.colours.path, 2.2));
    painter.drawLine(at, of_run.to_screen.map(QPointF(best.x + kNose * std::cos(best.theta),
                                                      best.y + kNose * std::sin(best.theta))));
    draw_disc(painter, at, 3.5, scene.colours.path);
}

unsigned WorldView::held_by(int key) {
    switch (key) {
        case Qt::Key_Up:
        case Qt::Key_W:
            return ahead;
        case Qt::Key_Down:
        case Qt::Key_S:
            return back;
        case Qt::Key_Left:
        case Qt::Key_A:
            return left_turn;
        case Qt::Key_Right:
        case Qt::Key_D:
            return right_turn;
        default:
            return 0;
    }
}

void WorldView::set_held(unsigned keys) {
    if (keys == keys_) return;
    keys_ = keys;
    const auto part = [keys](unsigned more, unsigned less) {
        return ((keys & more) != 0 ? 1.0 : 0.0) - ((keys & less) != 0 ? 1.0 : 0.0);
    };
    emit held(part(ahead, back), part(left_turn, right_turn));
}

void WorldView::keyPressEvent(QKeyEvent* event) {
    const unsigned key = held_by(event->key());
    if (!tour_ || key == 0 || event->modifiers().testFlag(Qt::ControlModifier)) {
        CanvasView::keyPressEvent(event);
        return;
    }
    set_held(keys_ | key);
}

void WorldView::keyReleaseEvent(QKeyEvent* event) {
    const unsigned key = held_by(event->key());
    if (key == 0 || event->isAutoRepeat()) {
        CanvasView::keyReleaseEvent(event);
        return;
    }
    set_held(keys_ & ~key);
}

/// Nobody hears of a key that is let go elsewhere.
void WorldView::focusOutEvent(QFocusEvent* event) {
    set_held(0);
    CanvasView::focusOutEvent(event);
}

}  // namespace hitos::window
