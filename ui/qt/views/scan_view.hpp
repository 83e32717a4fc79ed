// SPDX-License-Identifier: GPL-3.0-or-later
// The last scan with what the algorithm makes of it [T 9.2.6.2, left].
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "canvas_view.hpp"
#include "hitos/services/run/run_worker.hpp"
#include "landmark_painter.hpp"
#include "layers.hpp"
#include "particle_painter.hpp"

namespace hitos::window {

/// Scan, detected features, particles, landmarks with their uncertainty, and associations; in the
/// robot's frame (ahead is up) or in the world's.
class ScanView final : public CanvasView {
    Q_OBJECT

  public:
    explicit ScanView(QWidget* parent = nullptr);

    bool robot_frame() const { return robot_frame_; }

    void set_snapshot(const std::shared_ptr<const Snapshot>& snapshot);
    void set_robot_frame(bool on);
    /// Shows this landmark of the world strongly; nothing shows none.
    void set_highlight(const hitos::window::PickedLandmark& picked);
    /// Marks a feature of the scan, a place in Snapshot::associations; -1 marks none.
    void set_feature(int feature);

  signals:
    void landmark_clicked(hitos::window::PickedLandmark landmark);
    void particle_clicked(int particle);
    /// A place in Snapshot::associations.
    void feature_clicked(int feature);

  protected:
    void paint_scene(QPainter& painter, const Scene& scene) const override;
    QString file_name() const override { return QStringLiteral("scan"); }
    LayerSet drawable() const override;
    QRectF content() const override { return content_; }
    bool of_particles() const override { return snapshot_ && snapshot_->hypotheses.size() > 1; }
    double whole_pixels_per_m() const override { return 60.0; }
    Pose pose_view_world() const override;
    std::optional<ICaracteristica> landmark_below(const QPointF& point) const override;
    void hover(std::optional<QPointF> point) override;
    void click(const QPointF& point) override;
    QString empty_text() const override;

  private:
    struct Link {
        QPointF observed;
        QPointF landmark;
        Association::Outcome outcome = Association::Outcome::ignored;
    };

    void prepare();
    void prepare_cloud();
    void prepare_links();
    void grow_content();
    Pose pose_view_robot() const;
    /// Number of the landmark at a point of the view's frame; -1 where none is shown.
    int landmark_shown_at(const QPointF& point) const;
    void paint_particles(QPainter& painter, const Scene& scene) const;
    /// Number of the particle at a point of the view's frame; -1 where there is none.
    int particle_at(const QPointF& point) const;
    /// The same of the feature.
    int feature_at(const QPointF& point) const;
    void paint_detected(QPainter& painter, const Scene& scene) const;
    void paint_links(QPainter& painter, const Scene& scene) const;

    std::shared_ptr<const Snapshot> snapshot_;
    bool robot_frame_ = true;
    PickedLandmark highlight_;
    int feature_ = -1;
    int hovered_ = -1;
    QPointF hovered_at_m_;

    // In the view's frame, made once per snapshot.
    std::vector<QPointF> points_;
    std::vector<QLineF> segments_;
    std::vector<QPointF> corners_;
    ParticleCloud cloud_;
    std::size_t cloud_stride_ = 1;  // particles from one of the cloud to the next
    std::vector<Link> links_;
    MarkedMap landmarks_;
    QRectF content_;
};

}  // namespace hitos::window
