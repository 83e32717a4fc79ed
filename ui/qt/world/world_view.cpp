#include "world_view.hpp"

#include <QKeyEvent>
#include <cmath>
#include <utility>

#include "views/canvas_paint.hpp"

namespace hitos::window {
namespace {

QPointF point_of(const Point2& point) {
    return {point.x, point.y};
}

void draw_walls(QPainter& painter, const Scene& scene, const std::vector<WallSegment>& walls,
                const QPen& pen) {
    painter.setPen(pen);
    for (const WallSegment& wall : walls) {
        painter.drawLine(scene.to_screen.map(point_of(wall.a)),
                         scene.to_screen.map(point_of(wall.b)));
    }
}

}  // namespace

WorldView::WorldView(QWidget* parent) : CanvasView(parent) {
    setFocusPolicy(Qt::StrongFocus);
}

void WorldView::set_tour(std::shared_ptr<const SimulatedTour> tour) {
    tour_ = std::move(tour);
    goal_.reset();
    set_held(0);
    content_ = {};
    if (tour_) {
        std::vector<QPointF> points;
        for (const auto* walls : {&tour_->world().walls, &tour_->world().doors}) {
            for (const WallSegment& wall : *walls) {
                points.push_back(point_of(wall.a));
                points.push_back(point_of(wall.b));
            }
        }
        const Pose start = tour_->pose_now();
        points.emplace_back(start.x, start.y);
        content_ = box_of(points);
    }
    content_changed(std::nullopt);
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

QRectF WorldView::content() const {
    return content_;
}

std::optional<ICaracteristica> WorldView::landmark_below(const QPointF& point) const {
    Q_UNUSED(point)
    return std::nullopt;
}

QString WorldView::empty_text() const {
    return tr("Choose a world to drive a robot through.");
}

void WorldView::click(const QPointF& point) {
    if (tour_) emit goal_chosen(point);
}

void WorldView::paint_scene(QPainter& painter, const Scene& scene) const {
    draw_metre_grid(painter, scene);
    if (tour_) {
        paint_rays(painter, scene);
        paint_walls(painter, scene);
        paint_belief(painter, scene);
        paint_truth(painter, scene);
        if (goal_) {
            draw_cross(painter, scene.to_screen.map(point_of(*goal_)), scene.colours.accent);
        }
    }
    if (scene.chrome) draw_scale_bar(painter, scene);
}

void WorldView::paint_walls(QPainter& painter, const Scene& scene) const {
    const World& world = tour_->world();
    // Where a door is, whether it stands open or not: a closed one is a wall too.
    draw_walls(painter, scene, world.doors, thin_pen(scene.colours.accent, 1.2, Qt::DashLine));
    draw_walls(painter, scene, tour_->walls_now(), thin_pen(scene.colours.text, 2.0));
    const std::vector<Point2> people = tour_->people_now();
    painter.setPen(thin_pen(scene.colours.text, 1.2));
    painter.setBrush(faded(scene.colours.text, 60));
    for (std::size_t i = 0; i < people.size(); ++i) {
        const double radius = world.walkers[i].radius_m * scene.pixels_per_m;
        painter.drawEllipse(scene.to_screen.map(point_of(people[i])), radius, radius);
    }
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
    for (const Point2& point : scan.points) {
        painter.drawLine(scene.to_screen.map(point_of(laser)),
                         scene.to_screen.map(point_of(transform(robot, point))));
    }
    for (const Point2& point : scan.points) {
        draw_disc(painter, scene.to_screen.map(point_of(transform(robot, point))), 1.4,
                  scene.colours.scan);
    }
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
    draw_path(painter, of_run, points_of(snapshot_->best_trajectory),
              thin_pen(scene.colours.path, 1.6));
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
