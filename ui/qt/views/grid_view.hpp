// SPDX-License-Identifier: GPL-3.0-or-later
// The grid map with the best path and the reference [T 9.2.6.2, right].
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "canvas_view.hpp"
#include "drawing_layer.hpp"
#include "grid_layer.hpp"
#include "hitos/services/run/run_worker.hpp"
#include "landmark_painter.hpp"
#include "layers.hpp"
#include "run_trace.hpp"

namespace hitos::window {

/// A grid map in the world's frame: that of a snapshot, or one that a builder makes.
class GridView final : public CanvasView {
    Q_OBJECT

  public:
    explicit GridView(QWidget* parent = nullptr);

    const GridTiles& tiles() const { return tiles_; }
    const std::vector<hitos::window::RunTrace>& traces() const { return traces_; }

    void set_snapshot(const std::shared_ptr<const Snapshot>& snapshot);
    /// Shows a grid that is not of a snapshot, with the path it was made along.
    void set_grid(const GridTiles& tiles, const Trajectory& path);
    /// The landmarks over such a grid, in its frame.
    void set_landmarks(const hitos::window::MarkedMap& landmarks);
    void set_highlight(const hitos::window::PickedLandmark& picked);
    /// Shows this loop strongly, closed or not; nothing shows none.
    void set_loop(const std::optional<RunLoop>& loop);
    /// The walls of the drawing that the run is anchored to, in its own frame [m].
    void set_drawing(const std::vector<QLineF>& walls);
    void set_reference_map(const std::optional<LandmarkMap>& map);
    void set_reference_path(const Trajectory& path_world);
    /// Drawn over everything else, with a legend.
    void set_traces(std::vector<hitos::window::RunTrace> traces);
    /// Shows all that is in the world's frame where it lies in another one, which is the view's.
    void set_frame(const Pose& pose_view_world);
    /// Counts as content too [m], in the view's frame, so that views of two runs fit alike.
    void set_other_content(const QRectF& box);

    /// And the map as a figure for papers, as a run's results have it.
    std::vector<FigureOffer> figures() override;

  signals:
    void landmark_clicked(hitos::window::PickedLandmark landmark);
    /// One that is drawn, and no landmark before it.
    void loop_clicked(std::optional<hitos::RunLoop> loop);
    void place_clicked(QPointF world_m);

  protected:
    void paint_scene(QPainter& painter, const Scene& view) const override;
    Pose pose_view_world() const override { return pose_view_world_; }
    const Colours& layer_colours(const Colours& /*screen*/) const override {
        return light_colours();
    }
    QString file_name() const override { return QStringLiteral("map"); }
    LayerSet drawable() const override;
    LayerSet hidden() const override;
    std::vector<FigureEntry> entries() const override;
    QRectF content() const override;
    bool of_particles() const override { return snapshot_ && snapshot_->hypotheses.size() > 1; }
    double whole_pixels_per_m() const override;
    std::optional<ICaracteristica> landmark_below(const QPointF& point) const override;
    void hover(std::optional<QPointF> point) override;
    void click(const QPointF& point) override;
    QString empty_text() const override;

  private:
    QTransform view_world() const;
    QPointF in_world(const QPointF& point) const;
    /// Whether there is no grid but landmarks, as of a tour without a laser.
    bool only_landmarks() const;
    void paint_traces(QPainter& painter, const Scene& scene) const;
    void paint_reference(QPainter& painter, const Scene& scene) const;
    void paint_graph(QPainter& painter, const Scene& scene) const;
    void paint_loop(QPainter& painter, const Scene& scene) const;
    /// From the earlier scan to the later one, where the path is that of the snapshot.
    std::optional<QLineF> line_of(const RunLoop& loop) const;
    std::optional<RunLoop> loop_below(const QPointF& point) const;
    void paint_landmarks(QPainter& painter, const Scene& scene) const;
    void paint_marks(QPainter& painter, const Scene& scene) const;

    std::shared_ptr<const Snapshot> snapshot_;
    GridTiles tiles_;
    GridLayer layer_;
    std::vector<QPointF> path_;
    std::vector<std::size_t> begins_;  // of its points; odometry and online path have the same
    std::vector<QPointF> odometry_;
    std::vector<QPointF> online_;
    std::vector<QPointF> reference_path_;
    DrawingLayer drawing_;
    std::optional<LandmarkMap> reference_map_;
    std::vector<RunTrace> traces_;
    QRectF other_content_;
    Pose pose_view_world_;
    MarkedMap landmarks_;
    PickedLandmark highlight_;
    std::optional<RunLoop> loop_;
    int hovered_ = -1;
    QPointF hovered_at_m_;
};

}  // namespace hitos::window
