// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid_view.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include "hitos/services/drawing/map_figure.hpp"
#include "look/words_of.hpp"
#include "particle_painter.hpp"

namespace hitos::window {
namespace {

constexpr double kPaperWidth = 85.0;  // mm

/// The figure that a run's results have.
Picture map_picture(const Snapshot& run, const FigureWish& wish) {
    MapFigureContent content{std::filesystem::path(run.source).filename().string(), run.best_map,
                             run.line_extents, run.best_trajectory, run.odometry_trajectory};
    content.style.width_mm = wish.width_mm;
    content.style.landmarks = wish.layers.has(Layer::landmarks);
    content.style.uncertainty = wish.layers.has(Layer::uncertainty);
    content.style.path = wish.layers.has(Layer::path);
    content.style.odometry = wish.layers.has(Layer::odometry);
    content.style.axes = wish.axes;
    content.style.legend = wish.legend;
    content.style.heading = wish.title.toStdString();
    const VectorDrawing drawing = map_figure(content);
    Picture picture;
    picture.size = QSizeF(drawing.width, drawing.height) / wish.mm_per_point;
    picture.mm_per_point = wish.mm_per_point;
    picture.shapes = [drawing](const QString& ending) {
        return QByteArray::fromStdString(ending == "pdf" ? pdf_text(drawing) : svg_text(drawing));
    };
    picture.paint = [drawing, wish](QPaintDevice& device, double by) {
        const std::string png = png_text(drawing, by / wish.mm_per_point);
        QPainter(&device).drawImage(0, 0, QImage::fromData(QByteArray::fromStdString(png)));
    };
    return picture;
}

}  // namespace

GridView::GridView(QWidget* parent) : CanvasView(parent) {
    setAccessibleName(tr("Grid map"));
}

void GridView::set_snapshot(const std::shared_ptr<const Snapshot>& snapshot) {
    snapshot_ = snapshot && snapshot->steps > 0 ? snapshot : nullptr;
    drawing_.lay(snapshot_ ? snapshot_->drawing : std::nullopt);
    hovered_ = -1;
    if (!snapshot_) {
        tiles_ = {};
        layer_.clear();
        path_.clear();
        odometry_.clear();
        online_.clear();
        begins_.clear();
        landmarks_ = {};
        content_changed(std::nullopt);
        return;
    }
    tiles_ = snapshot_->step_grid;
    layer_.set_tiles(tiles_);
    landmarks_ = {snapshot_->best_map, snapshot_->line_extents};
    path_ = points_of(snapshot_->best_trajectory);
    odometry_ = points_of(snapshot_->odometry_trajectory);
    online_ = points_of(snapshot_->online_trajectory);
    begins_ = begins_of(snapshot_->best_trajectory);
    content_changed(QPointF(snapshot_->best_pose.x, snapshot_->best_pose.y));
}

void GridView::set_grid(const GridTiles& tiles, const Trajectory& path) {
    tiles_ = tiles;
    layer_.set_tiles(tiles_);
    path_ = points_of(path);
    begins_ = begins_of(path);
    content_changed(path_.empty() ? std::nullopt
                                  : std::optional<QPointF>(view_world().map(path_.back())));
}

void GridView::set_landmarks(const MarkedMap& landmarks) {
    landmarks_ = landmarks;
    hovered_ = -1;
    hover_again();
    update();
}

void GridView::set_highlight(const PickedLandmark& picked) {
    highlight_ = picked;
    update();
}

void GridView::set_loop(const std::optional<RunLoop>& loop) {
    loop_ = loop;
    update();
}

void GridView::set_drawing(const std::vector<QLineF>& walls) {
    drawing_.set_walls(walls);
    update();
}

void GridView::set_reference_map(const std::optional<LandmarkMap>& map) {
    reference_map_ = map;
    update();
}

void GridView::set_reference_path(const Trajectory& path_world) {
    reference_path_ = points_of(path_world);
    update();
}

void GridView::set_traces(std::vector<RunTrace> traces) {
    traces_ = std::move(traces);
    content_changed();
}

void GridView::set_frame(const Pose& pose_view_world) {
    if (pose_view_world == pose_view_world_) return;
    pose_view_world_ = pose_view_world;
    content_changed();
}

QTransform GridView::view_world() const {
    QTransform turned;
    if (pose_view_world_ == Pose{}) return turned;
    turned.translate(pose_view_world_.x, pose_view_world_.y);
    turned.rotateRadians(pose_view_world_.theta);
    return turned;
}

QPointF GridView::in_world(const QPointF& point) const {
    return view_world().inverted().map(point);
}

void GridView::set_other_content(const QRectF& box) {
    if (box == other_content_) return;
    other_content_ = box;
    content_changed();
}

QRectF GridView::content() const {
    QRectF box = layer_.bounds();
    for (const RunTrace& trace : traces_) box = box.united(box_of(trace.path));
    const auto in_view = [&](const QRectF& own) {
        return (own.isNull() ? own : view_world().mapRect(own)).united(other_content_);
    };
    if (!only_landmarks()) return in_view(box);
    constexpr double kAround = 0.5;  // [m]
    for (const ICaracteristica& landmark : landmarks_.map) {
        const Point2 at = landmark.point();
        box = box.united(QRectF(at.x - kAround, at.y - kAround, 2.0 * kAround, 2.0 * kAround));
    }
    return in_view(box.united(box_of(path_)));
}

bool GridView::only_landmarks() const {
    return tiles_.empty() && !landmarks_.map.empty();
}

LayerSet GridView::drawable() const {
    LayerSet layers;
    layers.set(Layer::path, !path_.empty());
    layers.set(Layer::reference, reference_map_ || !reference_path_.empty() || !drawing_.empty());
    const bool traced = std::ranges::any_of(
        traces_, [](const RunTrace& trace) { return !trace.landmarks.map.empty(); });
    const bool landmarks = traced || only_landmarks() || (!snapshot_ && !landmarks_.map.empty());
    for (const Layer layer : {Layer::landmarks, Layer::endless, Layer::names}) {
        layers.set(layer, landmarks);
    }
    layers.set(Layer::uncertainty, landmarks || snapshot_);
    if (!snapshot_) return layers;
    layers.set(Layer::robot, true);
    layers.set(Layer::odometry, true);
    layers.set(Layer::online, true);
    layers.set(Layer::graph, !snapshot_->keys.empty());
    layers.set(Layer::ancestry, !snapshot_->ancestry.empty());
    return layers;
}

LayerSet GridView::hidden() const {
    LayerSet layers;
    layers.set(Layer::path, std::ranges::any_of(traces_, [this](const RunTrace& trace) {
                   return !path_.empty() && trace.path == path_;
               }));
    return layers;
}

std::vector<FigureEntry> GridView::entries() const {
    return entries_of(traces_);
}

std::vector<FigureOffer> GridView::figures() {
    std::vector<FigureOffer> offers = CanvasView::figures();
    if (!snapshot_) return offers;
    FigureOffer paper;
    paper.words = tr("The map for papers, as results have it (map.pdf)");
    paper.width = kPaperWidth / kMmPerPoint;
    paper.paper_mm = kPaperWidth;
    paper.legend = paper.axes = paper.for_print = true;
    paper.uncertainty = tr("Uncertainty (%1 σ)").arg(kFigureSigmas);
    paper.layers =
        paper.shown = {Layer::landmarks, Layer::uncertainty, Layer::path, Layer::odometry};
    paper.picture = [run = snapshot_](const FigureWish& wish) { return map_picture(*run, wish); };
    offers.push_back(std::move(paper));
    return offers;
}

double GridView::whole_pixels_per_m() const {
    return tiles_.empty() ? 20.0 : 1.0 / tiles_.resolution_m;
}

void GridView::paint_scene(QPainter& painter, const Scene& view) const {
    const Scene scene{view_world() * view.to_screen,
                      view.size,
                      view.pixels_per_m,
                      view.colours,
                      view.chrome,
                      view.scale_bar,
                      view.framed};
    // What lies out of the grid is as unknown as what it holds of it.
    const int unknown = shade_of(kUnknownGrey, scene.colours.dark);
    painter.fillRect(QRectF(QPointF(), scene.size), QColor(unknown, unknown, unknown));
    layer_.paint(painter, scene);
    if (layers().has(Layer::reference)) paint_reference(painter, scene);
    if (layers().has(Layer::odometry)) {
        draw_path(painter, scene, odometry_, thin_pen(light_colours().odometry, 1.4, Qt::DashLine),
                  begins_);
    }
    if (layers().has(Layer::online)) {
        draw_path(painter, scene, online_, thin_pen(faded(light_colours().path, 150), 1.2),
                  begins_);
    }
    if (layers().has(Layer::path)) {
        draw_path(painter, scene, path_, thin_pen(light_colours().path, 1.8), begins_);
    }
    if (snapshot_) {
        const Scene paper{scene.to_screen, scene.size, scene.pixels_per_m, light_colours(), false};
        if (layers().has(Layer::ancestry))
            draw_ancestry(painter, paper, snapshot_->ancestry, begins_, {});
        if (snapshot_->particle) draw_particle(painter, paper, *snapshot_->particle, {});
    }
    if (layers().has(Layer::graph)) paint_graph(painter, scene);
    if ((!snapshot_ || only_landmarks()) && layers().has(Layer::landmarks))
        paint_landmarks(painter, scene);
    paint_traces(painter, scene);
    paint_loop(painter, scene);
    paint_marks(painter, scene);
    if (scene.scale_bar) draw_scale_bar(painter, scene);
    if (hovered_ >= 0) {
        draw_chip(painter, scene, scene.to_screen.map(hovered_at_m_) + QPointF(14.0, 14.0),
                  describe(landmarks_.map[static_cast<std::size_t>(hovered_)], hovered_));
    }
}

void GridView::paint_reference(QPainter& painter, const Scene& scene) const {
    const QColor colour = light_colours().reference;
    drawing_.paint(painter, scene, faded(colour, 190));
    if (reference_map_) {
        painter.setPen(thin_pen(faded(colour, 190), 1.3, Qt::DotLine));
        painter.setBrush(Qt::NoBrush);
        for (const ICaracteristica& landmark : *reference_map_) {
            if (const auto* recta = std::get_if<Recta>(&landmark.value)) {
                painter.drawPolyline(visible_line(scene, recta->rho, recta->theta));
            } else {
                const Point2 point = landmark.point();
                painter.drawEllipse(scene.to_screen.map(QPointF(point.x, point.y)), 5.0, 5.0);
            }
        }
    }
    draw_path(painter, scene, reference_path_, thin_pen(colour, 1.6, Qt::DashLine));
}

void GridView::paint_traces(QPainter& painter, const Scene& scene) const {
    const Scene paper{scene.to_screen, scene.size, scene.pixels_per_m, light_colours(), false};
    LandmarkStyle style;
    style.uncertainty = false;
    for (const RunTrace& trace : traces_) {
        style.colour = trace.colour;
        if (layers().has(Layer::landmarks)) draw_landmarks(painter, paper, trace.landmarks, style);
        if (trace.errors_m.empty()) {
            draw_path(painter, scene, trace.path, thin_pen(trace.colour, 1.8, trace.line),
                      trace.begins);
        } else {
            draw_errors(painter, scene, trace);
        }
    }
    if (scene.chrome && !scene.framed) draw_legend(painter, scene, traces_, landmarks_);
}

/// The keys of registration's graph, and each closed loop as an edge between its two passages.
void GridView::paint_graph(QPainter& painter, const Scene& scene) const {
    if (!snapshot_ || path_.size() != snapshot_->steps) return;
    const QColor colour = light_colours().end;
    painter.setPen(Qt::NoPen);
    painter.setBrush(faded(colour, 150));
    for (const KeyPose& key : snapshot_->keys) {
        painter.drawEllipse(scene.to_screen.map(path_[key.scan]), 1.6, 1.6);
    }
    painter.setPen(thin_pen(colour, 1.6));
    for (const RunLoop& loop : snapshot_->loops) {
        if (const auto line = line_of(loop); line && loop.closed())
            painter.drawLine(scene.to_screen.map(*line));
    }
}

std::optional<QLineF> GridView::line_of(const RunLoop& loop) const {
    const auto [scan, earlier] = std::pair(loop.record.scan, loop.record.earlier);
    if (!snapshot_ || std::max(scan, earlier) >= path_.size()) return std::nullopt;
    return QLineF(path_[earlier], path_[scan]);
}

void GridView::paint_loop(QPainter& painter, const Scene& scene) const {
    if (!loop_) return;
    const auto line = line_of(*loop_);
    if (!line) return;
    const QColor colour = light_colours().highlight;
    const QLineF on_screen = scene.to_screen.map(*line);
    painter.setPen(thin_pen(colour, 3.0, loop_->closed() ? Qt::SolidLine : Qt::DashLine));
    painter.drawLine(on_screen);
    draw_disc(painter, on_screen.p1(), 5.5, colour);
    draw_disc(painter, on_screen.p2(), 5.5, colour);
}

std::optional<RunLoop> GridView::loop_below(const QPointF& point) const {
    if (!snapshot_ || !layers().has(Layer::graph)) return std::nullopt;
    std::optional<RunLoop> nearest;
    double reach = tolerance_m();
    for (const RunLoop& loop : snapshot_->loops) {
        const auto line = line_of(loop);
        if (!line || !loop.closed()) continue;
        const double away = distance_to(*line, point);
        if (away > reach) continue;
        reach = away;
        nearest = loop;
    }
    return nearest;
}

/// On paper, which a grid is in every theme.
void GridView::paint_landmarks(QPainter& painter, const Scene& scene) const {
    const Scene paper{scene.to_screen, scene.size, scene.pixels_per_m, light_colours(), false};
    draw_landmarks(painter, paper, landmarks_,
                   {layers().has(Layer::uncertainty), layers().has(Layer::endless),
                    layers().has(Layer::names), -1});
}

void GridView::paint_marks(QPainter& painter, const Scene& scene) const {
    if (highlight_.landmark || hovered_ >= 0) {
        int index = find_same(landmarks_.map, highlight_.landmark);
        if (index < 0) index = hovered_;
        if (index >= 0) {
            draw_highlight(painter, scene, landmarks_, index, layers().has(Layer::uncertainty));
        }
    }
    if (path_.empty()) return;
    if (layers().has(Layer::path)) {
        draw_disc(painter, scene.to_screen.map(path_.front()), 5.5, light_colours().start);
        draw_disc(painter, scene.to_screen.map(path_.back()), 5.5, light_colours().end);
    }
    if (layers().has(Layer::robot) && snapshot_) {
        Scene paper{scene.to_screen, scene.size, scene.pixels_per_m, light_colours(), false};
        if (layers().has(Layer::uncertainty)) {
            draw_pose_uncertainty(painter, paper, snapshot_->mean_pose, snapshot_->pose_covariance);
        }
        draw_robot(painter, paper, snapshot_->best_pose);
    }
}

void GridView::hover(std::optional<QPointF> point) {
    int found = -1;
    if (point) {
        hovered_at_m_ = in_world(*point);
        found = landmark_at(landmarks_, {hovered_at_m_.x(), hovered_at_m_.y()}, tolerance_m());
    }
    if (found < 0 && hovered_ < 0) return;
    hovered_ = found;
    update();
}

std::optional<ICaracteristica> GridView::landmark_below(const QPointF& point) const {
    const QPointF own = in_world(point);
    const int found = landmark_at(landmarks_, {own.x(), own.y()}, tolerance_m());
    if (found < 0) return std::nullopt;
    return landmarks_.map[static_cast<std::size_t>(found)];
}

void GridView::click(const QPointF& point) {
    const auto landmark = landmark_below(point);
    emit landmark_clicked({landmark});
    if (!landmark) emit loop_clicked(loop_below(in_world(point)));
    emit place_clicked(in_world(point));
}

QString GridView::empty_text() const {
    return tr("The map grows here, step by step, from where the robot is believed to be.");
}

}  // namespace hitos::window
