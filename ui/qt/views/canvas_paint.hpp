// SPDX-License-Identifier: GPL-3.0-or-later
// Small drawings that views share; everything in pixels of the scene.
#pragma once

#include <Eigen/Core>
#include <QPainter>
#include <QPolygonF>
#include <vector>

#include "canvas_view.hpp"
#include "hitos/capture/scan.hpp"
#include "hitos/services/files/trajectory_file.hpp"

namespace hitos::window {

QPen thin_pen(const QColor& colour, double width = 1.0, Qt::PenStyle style = Qt::SolidLine);
QColor faded(QColor colour, int alpha);
/// From one colour (share 0) to another (1).
QColor mixed(const QColor& from, const QColor& to, double share);

/// A bar of a round length in the lower left corner, with that length in words.
void draw_scale_bar(QPainter& painter, const Scene& scene);
/// Lines every round distance, and nothing where they would be too dense.
void draw_metre_grid(QPainter& painter, const Scene& scene);
/// Words on a quiet background with the upper left corner at `at`.
void draw_chip(QPainter& painter, const Scene& scene, const QPointF& at, const QStringList& lines);
/// The robot's outline with its heading.
void draw_robot(QPainter& painter, const Scene& scene, const Pose& pose_view_robot);
/// How unsure a pose is, at 1, 2 and 3 standard deviations: ellipses of the place, and wedges of
/// the heading. `mean` and the covariance of (x, y, theta) about it are in the world's frame.
void draw_pose_uncertainty(QPainter& painter, const Scene& scene, const Pose& mean,
                           const Eigen::Matrix3d& covariance, const Pose& pose_view_world = {});
/// A path; points nearer than three pixels to the one before are left out. No line leads to those
/// that `begins` numbers, in their order.
void draw_path(QPainter& painter, const Scene& scene, const std::vector<QPointF>& path_m,
               const QPen& pen, const std::vector<std::size_t>& begins = {});
/// A small cross, as gun sights have it.
/// What a scan shows, robot frame: points that a laser hit, and landmarks that a sensor told.
std::vector<Point2> shown_points(const Scan& scan);

void draw_cross(QPainter& painter, const QPointF& pixel, const QColor& colour);
void draw_disc(QPainter& painter, const QPointF& pixel, double radius, const QColor& colour);

/// The part of an infinite line that lies in sight, as pixels; empty where none does.
QPolygonF visible_line(const Scene& scene, double rho_m, double theta_rad);
/// The ellipse of `sigmas` standard deviations of a covariance, in the view's frame [m].
QPolygonF ellipse(const QPointF& centre_m, const Eigen::Matrix2d& covariance, double sigmas);

inline QPointF point_of(const Point2& point) {
    return {point.x, point.y};
}

/// Of a segment from a point.
double distance_to(const QLineF& segment, const QPointF& point);

/// Around points; null where there are none.
QRectF box_of(const std::vector<QPointF>& points);

/// Lines of which those in sight that can be seen are drawn. Very many are drawn thin and rough, as
/// pens of one pixel are without smoothing: the window must not wait for them.
class SeenLines {
  public:
    explicit SeenLines(const Scene& scene) : scene_(scene) {}
    /// In the view's frame [m].
    void add(const QLineF& line_m);
    void draw(QPainter& painter, const QColor& colour, double width) const;

  private:
    const Scene& scene_;
    QVector<QLineF> lines_;
};

/// Points of a trajectory, moved by `pose_view_world`.
std::vector<QPointF> points_of(const Trajectory& trajectory, const Pose& pose_view_world = {});
/// Those of them at which another tour begins.
std::vector<std::size_t> begins_of(const Trajectory& trajectory);
void draw_path(QPainter& painter, const Scene& scene, const Trajectory& path, const QPen& pen,
               const Pose& pose_view_world = {});

}  // namespace hitos::window
