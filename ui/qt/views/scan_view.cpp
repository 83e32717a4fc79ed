// SPDX-License-Identifier: GPL-3.0-or-later
#include "scan_view.hpp"

#include <algorithm>
#include <cmath>

namespace hitos::window {
namespace {

constexpr std::size_t kMostParticlesDrawn = 2000;

QPointF to_qt(const Point2& point) {
    return {point.x, point.y};
}

QPointF moved(const Pose& pose, const Point2& point) {
    return to_qt(transform(pose, point));
}

void unite(QRectF& box, const QPointF& point) {
    if (box.isNull()) {
        box = QRectF(point, QSizeF(1e-6, 1e-6));
        return;
    }
    box.setLeft(std::min(box.left(), point.x()));
    box.setRight(std::max(box.right(), point.x()));
    box.setTop(std::min(box.top(), point.y()));
    box.setBottom(std::max(box.bottom(), point.y()));
}

}  // namespace

ScanView::ScanView(QWidget* parent) : CanvasView(parent) {
    setAccessibleName(tr("Last scan"));
    set_turn(kPi / 2.0);
}

Pose ScanView::pose_view_robot() const {
    return robot_frame_ || !snapshot_ ? Pose{} : snapshot_->best_pose;
}

Pose ScanView::pose_view_world() const {
    return robot_frame_ && snapshot_ ? inverse(snapshot_->best_pose) : Pose{};
}

void ScanView::set_snapshot(const std::shared_ptr<const Snapshot>& snapshot) {
    const bool anew = !snapshot || !snapshot_ || snapshot->steps < snapshot_->steps;
    snapshot_ = snapshot && snapshot->steps > 0 ? snapshot : nullptr;
    if (anew) content_ = {};
    hovered_ = -1;
    prepare();
}

void ScanView::set_robot_frame(bool on) {
    if (robot_frame_ == on) return;
    robot_frame_ = on;
    set_turn(on ? kPi / 2.0 : 0.0);
    content_ = {};
    prepare();
    fit();
}

void ScanView::set_highlight(const PickedLandmark& picked) {
    highlight_ = picked;
    update();
}

void ScanView::set_feature(int feature) {
    feature_ = feature;
    update();
}

void ScanView::prepare() {
    points_.clear();
    segments_.clear();
    corners_.clear();
    cloud_ = {};
    links_.clear();
    landmarks_ = {};
    if (!snapshot_) {
        content_changed(std::nullopt);
        return;
    }
    const Pose from_robot = pose_view_robot();
    const Pose from_world = pose_view_world();
    for (const Point2& point : shown_points(snapshot_->scan))
        points_.push_back(moved(from_robot, point));
    const Observation& seen = snapshot_->observation;
    for (const DetectedLine& line : seen.lines) {
        segments_.emplace_back(moved(from_robot, seen.support[line.first]),
                               moved(from_robot, seen.support[line.first + line.count - 1]));
    }
    for (const Esquina& corner : seen.corners)
        corners_.push_back(moved(from_robot, {corner.x, corner.y}));
    prepare_cloud();
    landmarks_ = transform(from_world, snapshot_->best_map, snapshot_->line_extents);
    prepare_links();
    grow_content();
    content_changed(QPointF(from_robot.x, from_robot.y));
}

void ScanView::prepare_cloud() {
    const Pose from_world = pose_view_world();
    const auto& hypotheses = snapshot_->hypotheses;
    cloud_stride_ = 1 + (hypotheses.size() - 1) / kMostParticlesDrawn;
    double heaviest = 0.0;
    for (const WeightedPose& particle : hypotheses) {
        heaviest = std::max(heaviest, particle.weight_before);
    }
    for (std::size_t i = 0; i < hypotheses.size(); i += cloud_stride_) {
        const Pose pose = compose(from_world, hypotheses[i].pose);
        cloud_.particles.emplace_back(pose.x, pose.y, pose.x + std::cos(pose.theta),
                                      pose.y + std::sin(pose.theta));
        cloud_.weights.push_back(heaviest > 0.0 ? hypotheses[i].weight_before / heaviest : 1.0);
    }
}

void ScanView::prepare_links() {
    for (const Association& association : snapshot_->associations) {
        Link link;
        // What was new is none any more where it is one with an older landmark.
        link.outcome = taken_in(association, snapshot_->best_map, snapshot_->steps)
                           ? Association::Outcome::matched
                           : association.outcome;
        const bool line = association.kind == FeatureKind::line;
        link.observed =
            line ? segments_.at(association.observed).center() : corners_.at(association.observed);
        link.landmark = link.observed;
        const auto index = static_cast<std::size_t>(std::max(association.landmark, 0));
        if (association.landmark >= 0 && index < landmarks_.map.size()) {
            const ICaracteristica& landmark = landmarks_.map[index];
            if (const auto* recta = std::get_if<Recta>(&landmark.value)) {
                const double away = recta->rho - link.observed.x() * std::cos(recta->theta) -
                                    link.observed.y() * std::sin(recta->theta);
                link.landmark += away * QPointF(std::cos(recta->theta), std::sin(recta->theta));
            } else {
                link.landmark = to_qt(landmark.point());
            }
        }
        links_.push_back(link);
    }
}

/// Keeps in sight what was seen since the start, but for the farthest readings: a window of 80 m
/// for one reading through a door would show nothing.
void ScanView::grow_content() {
    const Pose robot = pose_view_robot();
    std::vector<double> ranges;
    ranges.reserve(points_.size());
    for (const QPointF& point : points_)
        ranges.push_back(std::hypot(point.x() - robot.x, point.y() - robot.y));
    double limit = 1.0;
    if (!ranges.empty()) {
        const auto place = ranges.begin() + static_cast<std::ptrdiff_t>(ranges.size() * 19 / 20);
        std::vector<double> sorted = ranges;
        const auto middle = sorted.begin() + (place - ranges.begin());
        std::nth_element(sorted.begin(), middle, sorted.end());
        limit = *middle;
    }
    unite(content_, QPointF(robot.x - 0.6, robot.y - 0.6));
    unite(content_, QPointF(robot.x + 0.6, robot.y + 0.6));
    for (std::size_t i = 0; i < points_.size(); ++i) {
        if (ranges[i] <= limit) unite(content_, points_[i]);
    }
}

LayerSet ScanView::drawable() const {
    LayerSet layers;
    for (const LayerInfo& info : kLayerTable) layers.set(info.layer, snapshot_ && info.in_scan);
    if (robot_frame_) {
        layers.set(Layer::path, false);
        layers.set(Layer::ancestry, false);
    }
    return layers;
}

void ScanView::paint_scene(QPainter& painter, const Scene& scene) const {
    if (!snapshot_) return;
    draw_metre_grid(painter, scene);
    const int highlighted = find_same(snapshot_->best_map, highlight_.landmark);
    if (layers().has(Layer::landmarks)) {
        draw_landmarks(painter, scene, landmarks_,
                       {layers().has(Layer::uncertainty), layers().has(Layer::endless),
                        layers().has(Layer::names), highlighted});
    }
    if (layers().has(Layer::path) && !robot_frame_) {
        draw_path(painter, scene, snapshot_->best_trajectory,
                  thin_pen(faded(scene.colours.path, 170), 1.6));
    }
    if (layers().has(Layer::scan)) {
        QPolygonF pixels;
        for (const QPointF& point : points_) pixels.append(scene.to_screen.map(point));
        painter.setPen(QPen(scene.colours.scan, 2.6, Qt::SolidLine, Qt::RoundCap));
        painter.drawPoints(pixels);
    }
    paint_particles(painter, scene);
    if (layers().has(Layer::robot)) {
        if (layers().has(Layer::uncertainty)) {
            draw_pose_uncertainty(painter, scene, snapshot_->mean_pose, snapshot_->pose_covariance,
                                  pose_view_world());
        }
        draw_robot(painter, scene, pose_view_robot());
    }
    if (layers().has(Layer::detected)) paint_detected(painter, scene);
    paint_links(painter, scene);
    if (scene.scale_bar) draw_scale_bar(painter, scene);
    if (hovered_ >= 0 && static_cast<std::size_t>(hovered_) < landmarks_.map.size()) {
        draw_chip(painter, scene, scene.to_screen.map(hovered_at_m_) + QPointF(14.0, 14.0),
                  describe(snapshot_->best_map[static_cast<std::size_t>(hovered_)], hovered_));
    }
}

void ScanView::paint_particles(QPainter& painter, const Scene& scene) const {
    if (layers().has(Layer::ancestry) && !robot_frame_) {
        draw_ancestry(painter, scene, snapshot_->ancestry, begins_of(snapshot_->best_trajectory),
                      {});
    }
    if (snapshot_->particle) {
        draw_particle(painter, scene, *snapshot_->particle, pose_view_world());
    }
    if (layers().has(Layer::particles)) draw_cloud(painter, scene, cloud_);
}

int ScanView::particle_at(const QPointF& point) const {
    if (!layers().has(Layer::particles)) return -1;
    int found = -1;
    double nearest = tolerance_m();
    for (std::size_t i = 0; i < cloud_.particles.size(); ++i) {
        const double away = QLineF(cloud_.particles[i].p1(), point).length();
        if (away >= nearest) continue;
        nearest = away;
        found = static_cast<int>(i * cloud_stride_);
    }
    return found;
}

int ScanView::feature_at(const QPointF& point) const {
    if (!layers().has(Layer::detected)) return -1;
    int found = -1;
    double nearest = tolerance_m();
    for (std::size_t i = 0; i < snapshot_->associations.size(); ++i) {
        const Association& association = snapshot_->associations[i];
        const bool line = association.kind == FeatureKind::line;
        const double away = line ? distance_to(segments_.at(association.observed), point)
                                 : QLineF(corners_.at(association.observed), point).length();
        // A corner lies on lines.
        if (away > (line ? nearest : tolerance_m())) continue;
        nearest = line ? away : 0.0;
        found = static_cast<int>(i);
    }
    return found;
}

void ScanView::paint_detected(QPainter& painter, const Scene& scene) const {
    painter.setPen(thin_pen(scene.colours.observed, 2.6));
    for (const QLineF& segment : segments_) painter.drawLine(scene.to_screen.map(segment));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(thin_pen(scene.colours.observed, 2.0));
    const std::vector<double>& radii_m = snapshot_->observation.circle_radii_m;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        constexpr double kLeast = 4.0;  // pixels
        const QPointF at = scene.to_screen.map(corners_[i]);
        if (i < radii_m.size()) {
            const double radius = std::max(kLeast, radii_m[i] * scene.pixels_per_m);
            painter.drawEllipse(at, radius, radius);
        } else {
            painter.drawRect(QRectF(at - QPointF(kLeast, kLeast), QSizeF(8.0, 8.0)));
        }
    }
}

void ScanView::paint_links(QPainter& painter, const Scene& scene) const {
    if (feature_ >= 0 && static_cast<std::size_t>(feature_) < links_.size()) {
        painter.setPen(thin_pen(scene.colours.highlight, 2.4));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(
            scene.to_screen.map(links_[static_cast<std::size_t>(feature_)].observed), 11.0, 11.0);
    }
    if (!layers().has(Layer::associations)) return;
    for (const Link& link : links_) {
        const QPointF from = scene.to_screen.map(link.observed);
        const QPointF to = scene.to_screen.map(link.landmark);
        switch (link.outcome) {
            case Association::Outcome::matched:
                painter.setPen(thin_pen(scene.colours.association, 1.8));
                painter.setBrush(scene.colours.association);
                painter.drawLine(from, to);
                painter.drawEllipse(from, 2.2, 2.2);
                break;
            case Association::Outcome::created:
                painter.setPen(thin_pen(scene.colours.created, 2.2));
                painter.setBrush(scene.colours.canvas);
                painter.drawEllipse(from, 7.0, 7.0);
                painter.drawLine(from - QPointF(3.5, 0.0), from + QPointF(3.5, 0.0));
                painter.drawLine(from - QPointF(0.0, 3.5), from + QPointF(0.0, 3.5));
                break;
            case Association::Outcome::ignored:
                painter.setPen(thin_pen(scene.colours.ignored, 2.0));
                painter.drawLine(from - QPointF(4.0, 4.0), from + QPointF(4.0, 4.0));
                painter.drawLine(from - QPointF(4.0, -4.0), from + QPointF(4.0, -4.0));
                break;
        }
    }
}

int ScanView::landmark_shown_at(const QPointF& point) const {
    if (!layers().has(Layer::landmarks)) return -1;
    return landmark_at(landmarks_, {point.x(), point.y()}, tolerance_m());
}

std::optional<ICaracteristica> ScanView::landmark_below(const QPointF& point) const {
    const int found = landmark_shown_at(point);
    if (found < 0) return std::nullopt;
    return snapshot_->best_map[static_cast<std::size_t>(found)];
}

void ScanView::hover(std::optional<QPointF> point) {
    const int found = point ? landmark_shown_at(*point) : -1;
    if (point) hovered_at_m_ = *point;
    if (found < 0 && hovered_ < 0) return;
    hovered_ = found;
    update();
}

void ScanView::click(const QPointF& point) {
    if (!snapshot_) return;
    emit landmark_clicked({landmark_below(point)});
    const int particle = particle_at(point);
    if (particle >= 0) emit particle_clicked(particle);
    const int feature = feature_at(point);
    if (feature >= 0) emit feature_clicked(feature);
}

QString ScanView::empty_text() const {
    return tr("The scan and what the algorithm makes of it appear here once it runs.");
}

}  // namespace hitos::window
