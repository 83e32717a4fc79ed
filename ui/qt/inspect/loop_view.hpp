// SPDX-License-Identifier: GPL-3.0-or-later
// Both passages of a loop, as the loop lays them over each other.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "hitos/services/run/run_worker.hpp"
#include "views/canvas_view.hpp"

namespace hitos::window {

/// The scans of the earlier passage and of the later one, in the frame of the earlier scan. The
/// later one is laid by hand: dragged by its points, with Shift turned about its robot; the arrow
/// keys move it by 5 cm, with Shift those to the sides turn it by a degree.
class LoopView final : public CanvasView {
    Q_OBJECT

  public:
    explicit LoopView(QWidget* parent = nullptr);

    /// Of a snapshot with key scans; nothing: no loop is shown.
    void set_loop(const std::shared_ptr<const Snapshot>& snapshot,
                  const std::optional<RunLoop>& loop);
    /// Of the later scan, seen from the earlier one.
    const Pose& pose() const { return pose_; }
    bool laid_by_hand() const { return by_hand_; }
    /// As if by hand.
    void lay(const Pose& pose);
    /// The next loop lies as it is, even if it is the same.
    void let_go() { by_hand_ = false; }
    /// What is drawn, in the frame of the earlier scan [m].
    const std::vector<QPointF>& earlier_points() const { return earlier_; }
    const std::vector<QPointF>& later_points() const { return later_; }

  signals:
    void laid();

  protected:
    bool pick_up(const QPointF& point) override;
    void drag(const QPointF& point) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paint_scene(QPainter& painter, const Scene& scene) const override;
    QRectF content() const override;
    double whole_pixels_per_m() const override { return 60.0; }
    QString file_name() const override { return QStringLiteral("loop"); }
    std::optional<ICaracteristica> landmark_below(const QPointF& /*point*/) const override {
        return std::nullopt;
    }
    QString empty_text() const override;

  private:
    void place_later();

    std::optional<RunLoop> loop_;
    Pose pose_;
    bool by_hand_ = false;
    bool turning_ = false;
    QPointF dragged_from_;
    std::vector<QPointF> later_alone_;  ///< in the frame of its own scan
    std::vector<QPointF> earlier_;
    std::vector<QPointF> later_;
};

}  // namespace hitos::window
