// Both passages of a loop, as the loop lays them over each other.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "hitos/services/run/run_worker.hpp"
#include "views/canvas_view.hpp"

namespace hitos::window {

/// The scans of the earlier passage and of the later one, in the frame of the earlier scan.
class LoopView final : public CanvasView {
    Q_OBJECT

  public:
    explicit LoopView(QWidget* parent = nullptr);

    /// Of a snapshot with key scans; nothing: no loop is shown.
    void set_loop(const std::shared_ptr<const Snapshot>& snapshot,
                  const std::optional<RunLoop>& loop);
    /// What is drawn, in the frame of the earlier scan [m].
    const std::vector<QPointF>& earlier_points() const { return earlier_; }
    const std::vector<QPointF>& later_points() const { return later_; }

  protected:
    void paint_scene(QPainter& painter, const Scene& scene) const override;
    QRectF content() const override;
    double whole_pixels_per_m() const override { return 60.0; }
    QString file_name() const override { return QStringLiteral("loop"); }
    std::optional<ICaracteristica> landmark_below(const QPointF& /*point*/) const override {
        return std::nullopt;
    }
    QString empty_text() const override;

  private:
    std::optional<RunLoop> loop_;
    std::vector<QPointF> earlier_;
    std::vector<QPointF> later_;
};

}  // namespace hitos::window
