// SPDX-License-Identifier: GPL-3.0-or-later
// The world itself, as nobody but the simulator knows it, with what the filter believes over it.
#pragma once

#include <memory>

#include "hitos/services/run/run_worker.hpp"
#include "hitos/simulation/drive/simulated_tour.hpp"
#include "views/canvas_view.hpp"
#include "views/layers.hpp"

namespace hitos::window {

/// In the world's frame: the world as it is drawn, or the robot that is driven through it. While
/// one is, the arrow keys and W, A, S, D drive it, and a click is where it is to go,
/// which the mouse can drag elsewhere.
class WorldView final : public CanvasView {
    Q_OBJECT

  public:
    explicit WorldView(QWidget* parent = nullptr);

    /// What is seen while nothing is driven.
    void set_world(std::shared_ptr<const World> world);
    /// All that is there now, and no more.
    void fit() override;
    /// What is driven; null: nothing.
    void set_tour(std::shared_ptr<const SimulatedTour> tour);
    void set_snapshot(std::shared_ptr<const Snapshot> snapshot);
    void set_goal(std::optional<Point2> goal);
    /// Something has moved.
    void refresh();

  signals:
    /// Parts of the greatest speed and turn rate (to the left).
    void held(double ahead, double left);
    void goal_chosen(QPointF world_m);

  protected:
    void paint_scene(QPainter& painter, const Scene& scene) const override;
    QString file_name() const override { return QStringLiteral("world"); }
    LayerSet drawable() const override;
    QRectF content() const override;
    std::optional<ICaracteristica> landmark_below(const QPointF& point) const override;
    void click(const QPointF& point) override;
    bool pick_up(const QPointF& point) override;
    void drag(const QPointF& point) override;
    QString empty_text() const override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

  private:
    enum Held : unsigned { ahead = 1, back = 2, left_turn = 4, right_turn = 8 };
    static unsigned held_by(int key);
    void set_held(unsigned keys);
    const World* world() const;
    void grow_sheet();
    void paint_landmarks(QPainter& painter, const Scene& scene) const;
    void paint_walls(QPainter& painter, const Scene& scene) const;
    void paint_marks(QPainter& painter, const Scene& scene) const;
    void paint_doors(QPainter& painter, const Scene& scene,
                     const std::vector<WallSegment>& walls) const;
    void paint_plan(QPainter& painter, const Scene& scene) const;
    void paint_truth(QPainter& painter, const Scene& scene) const;
    void paint_belief(QPainter& painter, const Scene& scene) const;
    void paint_rays(QPainter& painter, const Scene& scene) const;

    std::shared_ptr<const World> world_;
    std::shared_ptr<const SimulatedTour> tour_;
    std::shared_ptr<const Snapshot> snapshot_;
    std::optional<Point2> goal_;
    QRectF sheet_;  ///< what is in sight; grows with what is drawn beyond it
    unsigned keys_ = 0;
};

}  // namespace hitos::window
