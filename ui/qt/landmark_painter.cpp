#include "landmark_painter.hpp"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <limits>

namespace hitos::window {
namespace {

constexpr double kDegrees = 180.0 / kPi;

struct Painter {
    QPainter& painter;
    const Scene& scene;
    const LandmarkStyle& style;

    void band(const Recta& recta, const Eigen::Matrix2d& covariance, double t_middle, double reach,
              double sigmas) const {
        // The line moves by d_rho - t d_theta at the place t along it, t = 0 at the foot.
        constexpr int kPieces = 24;
        const double c = std::cos(recta.theta);
        const double s = std::sin(recta.theta);
        QPolygonF polygon;
        for (const int side : {1, -1}) {
            for (int i = 0; i <= kPieces; ++i) {
                const double t = t_middle + side * reach * (2.0 * i / kPieces - 1.0);
                const double variance =
                    covariance(0, 0) - 2.0 * t * covariance(0, 1) + t * t * covariance(1, 1);
                const double rho =
                    recta.rho + side * sigmas * std::sqrt(std::max(variance, 0.0));
                polygon.append(scene.to_screen.map(QPointF(rho * c - t * s, rho * s + t * c)));
            }
        }
        painter.drawPolygon(polygon);
    }

    void line(const Recta& recta, const Eigen::Matrix2d& covariance, bool strong) const {
        const QPolygonF seen = visible_line(scene, recta.rho, recta.theta);
        if (seen.isEmpty()) return;
        const QColor colour = strong ? scene.colours.highlight : scene.colours.landmark;
        if (style.uncertainty) {
            const QTransform back = scene.to_screen.inverted();
            const QPointF a = back.map(seen.front());
            const QPointF b = back.map(seen.back());
            const QPointF middle = (a + b) / 2.0;
            const double t = middle.y() * std::cos(recta.theta) - middle.x() * std::sin(recta.theta);
            const double reach = std::hypot(b.x() - a.x(), b.y() - a.y()) / 2.0;
            painter.setPen(Qt::NoPen);
            painter.setBrush(faded(colour, strong ? 40 : 16));
            for (const double sigmas : {3.0, 2.0, 1.0})
                band(recta, covariance, t, reach, sigmas);
        }
        painter.setPen(thin_pen(faded(colour, strong ? 255 : 150), strong ? 2.4 : 1.2));
        painter.drawPolyline(seen);
    }

    void corner(const Esquina& esquina, const Eigen::Matrix2d& covariance, bool strong) const {
        const QColor colour = strong ? scene.colours.highlight : scene.colours.landmark;
        const QPointF centre(esquina.x, esquina.y);
        if (style.uncertainty) {
            painter.setBrush(faded(colour, 18));
            for (const double sigmas : {3.0, 2.0, 1.0}) {
                painter.setPen(thin_pen(faded(colour, sigmas > 2.5 ? 110 : 170)));
                painter.drawPolygon(scene.to_screen.map(ellipse(centre, covariance, sigmas)));
            }
        }
        const QPointF at = scene.to_screen.map(centre);
        const double r = strong ? 6.0 : 4.0;
        painter.setPen(thin_pen(colour, strong ? 2.4 : 1.6));
        painter.setBrush(faded(scene.colours.canvas, 200));
        painter.drawPolygon(QPolygonF{
            {at + QPointF(0, -r), at + QPointF(r, 0), at + QPointF(0, r), at + QPointF(-r, 0)}});
    }

    void number(const ICaracteristica& landmark, int index) const {
        QPointF at;
        if (const auto* recta = std::get_if<Recta>(&landmark.value)) {
            const QPolygonF seen = visible_line(scene, recta->rho, recta->theta);
            if (seen.isEmpty()) return;
            at = (seen.front() + seen.back()) / 2.0;
        } else {
            const Point2 point = landmark.point();
            at = scene.to_screen.map(QPointF(point.x, point.y));
        }
        painter.setPen(scene.colours.landmark);
        painter.drawText(at + QPointF(7.0, -5.0), QString::number(index + 1));
    }
};

double distance(const Point2& a, const Point2& b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

QString translated(const char* text) {
    return QCoreApplication::translate("Landmarks", text);
}

}  // namespace

void draw_landmarks(QPainter& painter, const Scene& scene, const LandmarkMap& map,
                    const LandmarkStyle& style) {
    const Painter draw{painter, scene, style};
    // Lines first, so that they cover no corner.
    for (const bool lines : {true, false}) {
        for (std::size_t i = 0; i < map.size(); ++i) {
            const bool strong = static_cast<int>(i) == style.highlighted;
            if (const auto* recta = std::get_if<Recta>(&map[i].value)) {
                if (lines) draw.line(*recta, map[i].covariance, strong);
            } else if (!lines) {
                draw.corner(std::get<Esquina>(map[i].value), map[i].covariance, strong);
            }
        }
    }
    if (!style.numbers) return;
    for (std::size_t i = 0; i < map.size(); ++i)
        draw.number(map[i], static_cast<int>(i));
}

int landmark_at(const LandmarkMap& map, const Point2& point, double tolerance_m) {
    int found = -1;
    bool corner_found = false;
    double nearest = tolerance_m;
    for (std::size_t i = 0; i < map.size(); ++i) {
        const auto* recta = std::get_if<Recta>(&map[i].value);
        if (recta != nullptr && corner_found) continue;
        const double away = recta != nullptr ? std::abs(signed_distance(*recta, point))
                                             : distance(map[i].point(), point);
        const bool first_corner = recta == nullptr && !corner_found && away <= tolerance_m;
        if (away > nearest && !first_corner) continue;
        nearest = away;
        found = static_cast<int>(i);
        corner_found = recta == nullptr;
    }
    return found;
}

int find_same(const LandmarkMap& map, const std::optional<ICaracteristica>& wanted) {
    if (!wanted) return -1;
    int found = -1;
    double nearest = 0.5;
    for (std::size_t i = 0; i < map.size(); ++i) {
        if (map[i].kind() != wanted->kind()) continue;
        double away = distance(map[i].point(), wanted->point());
        if (const auto* recta = std::get_if<Recta>(&map[i].value)) {
            const LineDifference apart = difference(*recta, std::get<Recta>(wanted->value));
            away = apart.rho + apart.theta;
        }
        if (away > nearest) continue;
        nearest = away;
        found = static_cast<int>(i);
    }
    return found;
}

QStringList describe(const ICaracteristica& world, int index) {
    const double sigma_0 = std::sqrt(std::max(world.covariance(0, 0), 0.0));
    const double sigma_1 = std::sqrt(std::max(world.covariance(1, 1), 0.0));
    QStringList lines;
    if (const auto* recta = std::get_if<Recta>(&world.value)) {
        lines << translated(QT_TRANSLATE_NOOP("Landmarks", "Line %1")).arg(index + 1)
              << QString("ρ  %1 ± %2 m").arg(recta->rho, 0, 'f', 3).arg(sigma_0, 0, 'f', 3)
              << QString("θ  %1 ± %2°")
                     .arg(recta->theta * kDegrees, 0, 'f', 2)
                     .arg(sigma_1 * kDegrees, 0, 'f', 2);
    } else {
        const auto& esquina = std::get<Esquina>(world.value);
        lines << translated(QT_TRANSLATE_NOOP("Landmarks", "Corner %1")).arg(index + 1)
              << QString("x  %1 ± %2 m").arg(esquina.x, 0, 'f', 3).arg(sigma_0, 0, 'f', 3)
              << QString("y  %1 ± %2 m").arg(esquina.y, 0, 'f', 3).arg(sigma_1, 0, 'f', 3);
    }
    lines << translated(QT_TRANSLATE_NOOP("Landmarks", "Observed %1 times")).arg(world.observations);
    return lines;
}

}  // namespace hitos::window
