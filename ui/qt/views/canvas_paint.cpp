// SPDX-License-Identifier: GPL-3.0-or-later
#include "canvas_paint.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <QFontMetricsF>
#include <algorithm>
#include <cmath>

#include "hitos/services/drawing/scale_bar.hpp"

namespace hitos::window {
namespace {

QRectF view_bounds(const Scene& scene) {
    return scene.to_screen.inverted().mapRect(QRectF(QPointF(), scene.size));
}

}  // namespace

QPen thin_pen(const QColor& colour, double width, Qt::PenStyle style) {
    // Not cosmetic: on a fine screen and in a great picture lines grow with everything else.
    return {colour, width, style, Qt::RoundCap, Qt::RoundJoin};
}

QColor faded(QColor colour, int alpha) {
    colour.setAlpha(alpha);
    return colour;
}

QColor mixed(const QColor& from, const QColor& to, double share) {
    const auto part = [share](int a, int b) {
        return static_cast<int>(std::lround(a + (b - a) * share));
    };
    return {part(from.red(), to.red()), part(from.green(), to.green()),
            part(from.blue(), to.blue()), part(from.alpha(), to.alpha())};
}

QRectF box_of(const std::vector<QPointF>& points) {
    return QPolygonF(QList<QPointF>(points.begin(), points.end())).boundingRect();
}

void draw_scale_bar(QPainter& painter, const Scene& scene) {
    constexpr double kMargin = 14.0;
    const double length_m =
        round_length(std::min(140.0, scene.size.width() / 3.0) / scene.pixels_per_m);
    const double length = length_m * scene.pixels_per_m;
    const QString words =
        length_m >= 1.0 ? QString("%1 m").arg(length_m) : QString("%1 cm").arg(length_m * 100.0);
    const QFontMetricsF metrics(painter.font());
    const double width = std::max(length, metrics.horizontalAdvance(words));
    const double bottom = scene.size.height() - kMargin;
    const QRectF chip(kMargin - 8.0, bottom - metrics.height() - 14.0, width + 16.0,
                      metrics.height() + 20.0);
    painter.setPen(Qt::NoPen);
    painter.setBrush(scene.colours.chip);
    painter.drawRoundedRect(chip, 5.0, 5.0);
    painter.setPen(thin_pen(scene.colours.text, 1.6));
    painter.drawPolyline(QPolygonF{{kMargin, bottom - 6.0},
                                   {kMargin, bottom},
                                   {kMargin + length, bottom},
                                   {kMargin + length, bottom - 6.0}});
    painter.drawText(QPointF(kMargin + 5.0, bottom - 6.0 - metrics.descent()), words);
}

void draw_metre_grid(QPainter& painter, const Scene& scene) {
    constexpr double kLeastPixels = 48.0;
    double step = 1e-3;
    for (int i = 0; step * scene.pixels_per_m < kLeastPixels; ++i)
        step *= i % 3 == 1 ? 2.5 : 2.0;  // 1, 2, 5, 10, …
    const QRectF bounds = view_bounds(scene);
    painter.setPen(thin_pen(scene.colours.grid_line));
    QVector<QLineF> lines;
    const auto first_at = [step](double from) { return std::lround(std::floor(from / step)); };
    for (long i = first_at(bounds.left()); step * static_cast<double>(i) <= bounds.right(); ++i) {
        const double x = step * static_cast<double>(i);
        lines.append(scene.to_screen.map(QLineF(x, bounds.top(), x, bounds.bottom())));
    }
    for (long i = first_at(bounds.top()); step * static_cast<double>(i) <= bounds.bottom(); ++i) {
        const double y = step * static_cast<double>(i);
        lines.append(scene.to_screen.map(QLineF(bounds.left(), y, bounds.right(), y)));
    }
    painter.drawLines(lines);
}

void draw_chip(QPainter& painter, const Scene& scene, const QPointF& at, const QStringList& lines) {
    if (lines.isEmpty()) return;
    const QFontMetricsF metrics(painter.font());
    double width = 0.0;
    for (const QString& line : lines) width = std::max(width, metrics.horizontalAdvance(line));
    QRectF box(at,
               QSizeF(width + 16.0, metrics.height() * static_cast<double>(lines.size()) + 10.0));
    box.moveLeft(
        std::clamp(box.left(), 4.0, std::max(4.0, scene.size.width() - box.width() - 4.0)));
    box.moveTop(
        std::clamp(box.top(), 4.0, std::max(4.0, scene.size.height() - box.height() - 4.0)));
    painter.setPen(thin_pen(scene.colours.border));
    painter.setBrush(scene.colours.card);
    painter.drawRoundedRect(box, 5.0, 5.0);
    painter.setPen(scene.colours.text);
    double y = box.top() + 5.0 + metrics.ascent();
    for (const QString& line : lines) {
        painter.drawText(QPointF(box.left() + 8.0, y), line);
        y += metrics.height();
    }
}

void draw_robot(QPainter& painter, const Scene& scene, const Pose& pose_view_robot) {
    // A differential robot of 45 x 38 cm; never smaller than a mark that can be seen.
    const double grow = std::max(1.0, 20.0 / (0.45 * scene.pixels_per_m));
    const double c = std::cos(pose_view_robot.theta) * grow;
    const double s = std::sin(pose_view_robot.theta) * grow;
    const auto at = [&](double x, double y) {
        return scene.to_screen.map(
            QPointF(pose_view_robot.x + c * x - s * y, pose_view_robot.y + s * x + c * y));
    };
    const QPolygonF body{
        {at(0.26, 0.0), at(0.12, 0.17), at(-0.2, 0.17), at(-0.2, -0.17), at(0.12, -0.17)}};
    painter.setPen(thin_pen(scene.colours.robot, 1.8));
    painter.setBrush(faded(scene.colours.robot, 40));
    painter.drawPolygon(body);
    painter.drawLine(at(0.0, 0.0), at(0.26, 0.0));
}

void draw_pose_uncertainty(QPainter& painter, const Scene& scene, const Pose& mean,
                           const Eigen::Matrix3d& covariance, const Pose& pose_view_world) {
    constexpr int kPieces = 12;
    constexpr double kReachPixels = 46.0;  // of the wedges, beyond the robot's outline
    const double reach_m = kReachPixels / scene.pixels_per_m;
    const Pose at = compose(pose_view_world, mean);
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(pose_view_world.theta).toRotationMatrix();
    const Eigen::Matrix2d place = turn * covariance.topLeftCorner<2, 2>() * turn.transpose();
    const double sigma_rad = std::sqrt(std::max(covariance(2, 2), 0.0));
    const QPointF centre(at.x, at.y);
    for (const double sigmas : {3.0, 2.0, 1.0}) {
        painter.setBrush(faded(scene.colours.robot, 22));
        painter.setPen(thin_pen(faded(scene.colours.robot, sigmas > 2.5 ? 120 : 190)));
        // What is smaller than its outline would be a blot.
        if (sigmas * sigmas * place.trace() * scene.pixels_per_m * scene.pixels_per_m > 4.0) {
            painter.drawPolygon(scene.to_screen.map(ellipse(centre, place, sigmas)));
        }
        const double half = std::min(sigmas * sigma_rad, kPi);
        if (half * kReachPixels < 1.0) continue;
        QPolygonF wedge{centre};
        for (int i = -kPieces; i <= kPieces; ++i) {
            const double angle = at.theta + half * i / kPieces;
            wedge << centre + reach_m * QPointF(std::cos(angle), std::sin(angle));
        }
        painter.setPen(Qt::NoPen);
        painter.setBrush(faded(scene.colours.robot, 50));
        painter.drawPolygon(scene.to_screen.map(wedge));
    }
}

void draw_path(QPainter& painter, const Scene& scene, const std::vector<QPointF>& path_m,
               const QPen& pen, const std::vector<std::size_t>& begins) {
    constexpr double kLeastPixels = 3.0;
    painter.setBrush(Qt::NoBrush);
    QPen cheap = pen;  // round joins of a thousand points take longer than the rest of a view
    cheap.setJoinStyle(Qt::BevelJoin);
    cheap.setCapStyle(Qt::FlatCap);
    painter.setPen(cheap);
    QPolygonF pixels;
    pixels.reserve(1024);
    auto begin = begins.begin();
    for (std::size_t i = 0; i < path_m.size(); ++i) {
        const QPointF pixel = scene.to_screen.map(path_m[i]);
        if (begin != begins.end() && *begin == i) {
            ++begin;
            painter.drawPolyline(pixels);
            pixels.clear();
        }
        if (!pixels.isEmpty()) {
            const QPointF way = pixel - pixels.back();
            if (way.x() * way.x() + way.y() * way.y() < kLeastPixels * kLeastPixels) continue;
        }
        pixels.append(pixel);
    }
    painter.drawPolyline(pixels);
}

std::vector<Point2> shown_points(const Scan& scan) {
    std::vector<Point2> points = scan.points;
    for (const LandmarkSighting& seen : scan.landmarks) points.push_back(seen.point());
    return points;
}

void draw_cross(QPainter& painter, const QPointF& pixel, const QColor& colour) {
    constexpr double kArm = 9.0;
    constexpr double kGap = 3.0;
    painter.setPen(thin_pen(colour, 1.4));
    for (const QPointF& way : {QPointF(1, 0), QPointF(0, 1), QPointF(-1, 0), QPointF(0, -1)}) {
        painter.drawLine(pixel + kGap * way, pixel + kArm * way);
    }
}

void draw_disc(QPainter& painter, const QPointF& pixel, double radius, const QColor& colour) {
    painter.setPen(thin_pen(Qt::white, 1.5));
    painter.setBrush(colour);
    painter.drawEllipse(pixel, radius, radius);
}

double distance_to(const QLineF& segment, const QPointF& point) {
    const QPointF along = segment.p2() - segment.p1();
    const double length_squared = QPointF::dotProduct(along, along);
    const double share =
        length_squared > 0.0
            ? std::clamp(QPointF::dotProduct(point - segment.p1(), along) / length_squared, 0.0,
                         1.0)
            : 0.0;
    return QLineF(point, segment.p1() + share * along).length();
}

QPolygonF visible_line(const Scene& scene, double rho_m, double theta_rad) {
    const QRectF bounds = view_bounds(scene);
    const QPointF middle = bounds.center();
    const double reach = std::hypot(bounds.width(), bounds.height()) / 2.0;
    const double c = std::cos(theta_rad);
    const double s = std::sin(theta_rad);
    const double away = rho_m - (middle.x() * c + middle.y() * s);
    if (std::abs(away) > reach) return {};
    const QPointF foot(middle.x() + away * c, middle.y() + away * s);
    const QPointF along(-s * reach, c * reach);
    return QPolygonF{scene.to_screen.map(foot - along), scene.to_screen.map(foot + along)};
}

QPolygonF ellipse(const QPointF& centre_m, const Eigen::Matrix2d& covariance, double sigmas) {
    constexpr int kCorners = 32;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(covariance);
    const Eigen::Vector2d length = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt() * sigmas;
    const Eigen::Matrix2d& axes = solver.eigenvectors();
    QPolygonF polygon;
    for (int i = 0; i <= kCorners; ++i) {
        const double angle = 2.0 * kPi * i / kCorners;
        const Eigen::Vector2d point =
            axes * Eigen::Vector2d(length.x() * std::cos(angle), length.y() * std::sin(angle));
        polygon.append(centre_m + QPointF(point.x(), point.y()));
    }
    return polygon;
}

void SeenLines::add(const QLineF& line_m) {
    constexpr double kLeastPixels = 0.5;
    const QLineF line = scene_.to_screen.map(line_m);
    const auto [left, right] = std::minmax({line.x1(), line.x2()});
    const auto [top, bottom] = std::minmax({line.y1(), line.y2()});
    const bool seen = right >= 0.0 && left <= scene_.size.width() && bottom >= 0.0 &&
                      top <= scene_.size.height() &&
                      std::max(right - left, bottom - top) >= kLeastPixels;
    if (seen) lines_.append(line);
}

void SeenLines::draw(QPainter& painter, const QColor& colour, double width) const {
    constexpr qsizetype kMostSmooth = 2000;
    const bool smooth = lines_.size() <= kMostSmooth;
    painter.setRenderHint(QPainter::Antialiasing, smooth);
    painter.setPen(thin_pen(colour, smooth ? width : 1.0));
    painter.drawLines(lines_);
    painter.setRenderHint(QPainter::Antialiasing);
}

std::vector<QPointF> points_of(const Trajectory& trajectory, const Pose& pose_view_world) {
    std::vector<QPointF> points;
    points.reserve(trajectory.size());
    for (const StampedPose& stamped : trajectory) {
        const Point2 point = transform(pose_view_world, Point2{stamped.pose.x, stamped.pose.y});
        points.emplace_back(point.x, point.y);
    }
    return points;
}

std::vector<std::size_t> begins_of(const Trajectory& trajectory) {
    std::vector<std::size_t> begins;
    for (std::size_t i = 0; i < trajectory.size(); ++i)
        if (trajectory[i].begins) begins.push_back(i);
    return begins;
}

void draw_path(QPainter& painter, const Scene& scene, const Trajectory& path, const QPen& pen,
               const Pose& pose_view_world) {
    draw_path(painter, scene, points_of(path, pose_view_world), pen, begins_of(path));
}

}  // namespace hitos::window
