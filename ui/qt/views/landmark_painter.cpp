// SPDX-License-Identifier: GPL-3.0-or-later
#include "landmark_painter.hpp"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <limits>

namespace hitos::window {
namespace {

double along(const Recta& line, const Point2& point) {
    return point.y * std::cos(line.theta) - point.x * std::sin(line.theta);
}

QPointF at(const Recta& line, double t) {
    const double c = std::cos(line.theta);
    const double s = std::sin(line.theta);
    return {line.rho * c - t * s, line.rho * s + t * c};
}

struct Painter {
    QPainter& painter;
    const Scene& scene;
    const LandmarkStyle& style;

    QColor colour_of(bool strong) const {
        if (strong) return scene.colours.highlight;
        return style.colour.isValid() ? style.colour : scene.colours.landmark;
    }

    void band(const Recta& recta, const Eigen::Matrix2d& covariance, double from, double to,
              double sigmas) const {
        // The line moves by d_rho - t d_theta at the place t along it, t = 0 at the foot.
        constexpr int kPieces = 8;
        QPolygonF polygon;
        for (const int side : {1, -1}) {
            for (int i = 0; i <= kPieces; ++i) {
                const int place = side > 0 ? i : kPieces - i;
                const double t = from + (to - from) * place / kPieces;
                const double variance =
                    covariance(0, 0) - 2.0 * t * covariance(0, 1) + t * t * covariance(1, 1);
                const double rho = recta.rho + side * sigmas * std::sqrt(std::max(variance, 0.0));
                polygon.append(scene.to_screen.map(at({rho, recta.theta}, t)));
            }
        }
        painter.drawPolygon(polygon);
    }

    void endless(const Recta& recta, bool strong) const {
        const QColor colour = colour_of(strong);
        painter.setPen(thin_pen(faded(colour, 90), 1.0, Qt::DashLine));
        painter.drawPolyline(visible_line(scene, recta.rho, recta.theta));
    }

    void stretch(const ICaracteristica& landmark, const LineExtent& extent, bool strong) const {
        const auto& recta = std::get<Recta>(landmark.value);
        const auto [from, to] = std::minmax({along(recta, extent.a), along(recta, extent.b)});
        const QLineF line = scene.to_screen.map(QLineF(at(recta, from), at(recta, to)));
        const QRectF sight(-50.0, -50.0, scene.size.width() + 100.0, scene.size.height() + 100.0);
        const QRectF box = QRectF(line.p1(), line.p2()).normalized().adjusted(-1, -1, 1, 1);
        if (!sight.intersects(box)) return;
        const QColor colour = colour_of(strong);
        const Eigen::Matrix2d& covariance = landmark.covariance;
        const double widest = std::max(std::abs(from), std::abs(to));
        const double sigma = std::sqrt(covariance(0, 0)) + widest * std::sqrt(covariance(1, 1));
        // A band that hardly leaves its line would only cost time.
        if (style.uncertainty && 3.0 * sigma * scene.pixels_per_m > 2.0) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(faded(colour, strong ? 52 : 34));
            for (const double sigmas : {3.0, 2.0, 1.0}) band(recta, covariance, from, to, sigmas);
        }
        painter.setPen(thin_pen(colour, strong ? 2.6 : 1.5));
        painter.drawLine(line);
    }

    void corner(const Esquina& esquina, const Eigen::Matrix2d& covariance, bool strong) const {
        const QColor colour = colour_of(strong);
        const QPointF centre(esquina.x, esquina.y);
        const double sigma = std::sqrt(std::max(covariance(0, 0), covariance(1, 1)));
        const QRectF sight(-50.0, -50.0, scene.size.width() + 100.0, scene.size.height() + 100.0);
        if (!sight.contains(scene.to_screen.map(centre))) return;
        if (style.uncertainty && 3.0 * sigma * scene.pixels_per_m > 4.0) {
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

    void number(const QPointF& place_m, int number) const {
        painter.setPen(scene.colours.landmark);
        painter.drawText(scene.to_screen.map(place_m) + QPointF(7.0, -5.0),
                         QString::number(number));
    }
};

QString landmark_words(const char* text) {
    return QCoreApplication::translate("Landmarks", text);
}

}  // namespace

MarkedMap transform(const Pose& pose_a_b, const LandmarkMap& map_b,
                    const std::vector<LineExtent>& extents_b) {
    MarkedMap marked;
    marked.map.reserve(map_b.size());
    for (const ICaracteristica& landmark : map_b)
        marked.map.push_back(transform(pose_a_b, landmark));
    marked.extents.reserve(extents_b.size());
    for (const LineExtent& extent : extents_b) {
        marked.extents.push_back(
            {extent.landmark, transform(pose_a_b, extent.a), transform(pose_a_b, extent.b)});
    }
    return marked;
}

void draw_landmarks(QPainter& painter, const Scene& scene, const MarkedMap& marked,
                    const LandmarkStyle& style) {
    const Painter draw{painter, scene, style};
    // Lines first, so that they cover no corner.
    for (const ICaracteristica& landmark : marked.map) {
        const auto* recta = std::get_if<Recta>(&landmark.value);
        if (recta != nullptr && style.endless) draw.endless(*recta, false);
    }
    for (const LineExtent& extent : marked.extents)
        draw.stretch(marked.map[static_cast<std::size_t>(extent.landmark)], extent, false);
    for (std::size_t i = 0; i < marked.map.size(); ++i) {
        const ICaracteristica& landmark = marked.map[i];
        if (const auto* corner = std::get_if<Esquina>(&landmark.value)) {
            draw.corner(*corner, landmark.covariance, false);
            const bool named = landmark.identity >= 0;
            if (style.numbers || named) {
                draw.number(QPointF(corner->x, corner->y),
                            named ? landmark.identity : static_cast<int>(i) + 1);
            }
        }
    }
    if (style.numbers) {
        for (const LineExtent& extent : marked.extents) {
            draw.number(QPointF(extent.a.x + extent.b.x, extent.a.y + extent.b.y) / 2.0,
                        extent.landmark + 1);
        }
    }
    if (style.highlighted >= 0) {
        draw_highlight(painter, scene, marked, style.highlighted, style.uncertainty);
    }
}

void draw_highlight(QPainter& painter, const Scene& scene, const MarkedMap& marked, int index,
                    bool uncertainty) {
    LandmarkStyle style;
    style.uncertainty = uncertainty;
    const Painter draw{painter, scene, style};
    const ICaracteristica& landmark = marked.map[static_cast<std::size_t>(index)];
    if (const auto* corner = std::get_if<Esquina>(&landmark.value)) {
        draw.corner(*corner, landmark.covariance, true);
        return;
    }
    draw.endless(std::get<Recta>(landmark.value), true);
    for (const LineExtent& extent : marked.extents) {
        if (extent.landmark == index) draw.stretch(landmark, extent, true);
    }
}

int landmark_at(const MarkedMap& marked, const Point2& point, double tolerance_m) {
    int found = -1;
    double nearest = tolerance_m;
    for (std::size_t i = 0; i < marked.map.size(); ++i) {
        if (marked.map[i].kind() != FeatureKind::corner) continue;
        const double away = distance(marked.map[i].point(), point);
        if (away > nearest) continue;
        nearest = away;
        found = static_cast<int>(i);
    }
    if (found >= 0) return found;
    for (const LineExtent& extent : marked.extents) {
        const auto& recta =
            std::get<Recta>(marked.map[static_cast<std::size_t>(extent.landmark)].value);
        const auto [from, to] = std::minmax({along(recta, extent.a), along(recta, extent.b)});
        const double t = along(recta, point);
        const double away = std::abs(signed_distance(recta, point));
        if (t < from - tolerance_m || t > to + tolerance_m || away > nearest) continue;
        nearest = away;
        found = extent.landmark;
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

bool taken_in(const Association& association, const LandmarkMap& map, std::uint64_t scans) {
    const auto place = static_cast<std::size_t>(std::max(association.landmark, 0));
    return association.outcome == Association::Outcome::created && association.landmark >= 0 &&
           place < map.size() && map[place].first_seen + std::uint64_t{1} < scans;
}

QString name_of(const ICaracteristica& landmark, int index) {
    if (landmark.identity >= 0)
        return landmark_words(QT_TRANSLATE_NOOP("Landmarks", "Landmark %1")).arg(landmark.identity);
    return landmark_words(landmark.kind() == FeatureKind::line
                              ? QT_TRANSLATE_NOOP("Landmarks", "Line %1")
                              : QT_TRANSLATE_NOOP("Landmarks", "Corner %1"))
        .arg(index + 1);
}

QStringList describe(const ICaracteristica& world, int index) {
    // A file of results tells no covariance and no number of observations.
    const bool known = !world.covariance.isZero(0.0);
    const auto value = [&](double number, int place, double factor, int decimals) {
        QString words = QString::number(number * factor, 'f', decimals);
        if (!known) return words;
        const double sigma = std::sqrt(std::max(world.covariance(place, place), 0.0));
        return words + " ± " + QString::number(sigma * factor, 'f', decimals);
    };
    QStringList lines{name_of(world, index)};
    if (const auto* recta = std::get_if<Recta>(&world.value)) {
        lines << QString("ρ  %1 m").arg(value(recta->rho, 0, 1.0, 3))
              << QString("θ  %1°").arg(value(recta->theta, 1, kDegreesPerRadian, 2));
    } else {
        const auto& esquina = std::get<Esquina>(world.value);
        lines << QString("x  %1 m").arg(value(esquina.x, 0, 1.0, 3))
              << QString("y  %1 m").arg(value(esquina.y, 1, 1.0, 3));
    }
    if (world.observations > 0) {
        lines << (world.observations == 1
                      ? landmark_words(QT_TRANSLATE_NOOP("Landmarks", "Observed once"))
                      : landmark_words(QT_TRANSLATE_NOOP("Landmarks", "Observed %1 times"))
                            .arg(world.observations));
    }
    return lines;
}

}  // namespace hitos::window
