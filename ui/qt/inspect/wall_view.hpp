// SPDX-License-Identifier: GPL-3.0-or-later
// Walls of which one is chosen, or a place on them: of a drawing, or of a scan.
#pragma once

#include <QLineF>
#include <optional>
#include <vector>

#include "hitos/base/geometry.hpp"
#include "views/canvas_view.hpp"

namespace hitos::window {

/// A click chooses the nearest wall, seen from where it was clicked, or the nearest corner or end,
/// or the place itself. The arrow keys go on to the next one in their direction; space looks at the
/// wall from its other side.
class WallView final : public CanvasView {
    Q_OBJECT

  public:
    /// In the view's frame [m].
    struct Walls {
        std::vector<QLineF> walls;
        std::vector<QPointF> places;  ///< corners and ends, to be met exactly
        std::vector<QPointF> dots;    ///< what a scan shows
        std::optional<Pose> robot;
        bool sided = false;  ///< they lead from left to right as the robot sees them already
    };

    WallView(const QString& name, QString empty_text, QWidget* parent);

    /// What was chosen stays.
    void set_walls(Walls walls);
    /// Only what is seen over them changes.
    void set_dots(std::vector<QPointF> dots, const std::optional<Pose>& robot);
    /// Places are chosen, in place of walls.
    void set_of_places(bool places);
    /// The chosen wall, from left to right as the robot sees it; the chosen place.
    const std::optional<QLineF>& wall() const { return wall_; }
    const std::optional<QPointF>& place() const { return place_; }
    /// As if by hand, but told to nobody.
    void choose_wall(const std::optional<QLineF>& wall);
    void choose_place(const std::optional<QPointF>& place);
    const Walls& walls() const { return walls_; }

  signals:
    void chosen();

  protected:
    void click(const QPointF& point) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paint_scene(QPainter& painter, const Scene& scene) const override;
    QRectF content() const override { return content_; }
    QString file_name() const override { return QStringLiteral("walls"); }
    std::optional<ICaracteristica> landmark_below(const QPointF& /*point*/) const override {
        return std::nullopt;
    }
    QString empty_text() const override { return empty_text_; }

  private:
    void go(const QPointF& direction);

    QString empty_text_;
    Walls walls_;
    QRectF content_;
    bool of_places_ = false;
    std::optional<QLineF> wall_;
    std::optional<QPointF> place_;
};

/// The wall from left to right for who stands there.
QLineF seen_from(const QLineF& wall, const QPointF& eye);

}  // namespace hitos::window
