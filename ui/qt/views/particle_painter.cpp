// SPDX-License-Identifier: GPL-3.0-or-later
#include "particle_painter.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "landmark_painter.hpp"

namespace hitos::window {
namespace {

constexpr std::size_t kWeightShades = 6;

/// From next to nothing to the colour of the heaviest.
QColor shade_of(const Scene& scene, double weight) {
    return mixed(faded(scene.colours.muted, 90), scene.colours.particle, weight);
}

}  // namespace

void draw_particle(QPainter& painter, const Scene& scene, const ParticleDetails& particle,
                   const Pose& pose_view_world) {
    LandmarkStyle style;
    style.uncertainty = false;
    style.colour = scene.colours.highlight;
    draw_landmarks(painter, scene, transform(pose_view_world, particle.map, particle.line_extents),
                   style);
    draw_path(painter, scene, particle.path, thin_pen(faded(scene.colours.highlight, 190), 1.6),
              pose_view_world);
    if (particle.path.empty()) return;
    const Pose pose = compose(pose_view_world, particle.path.back().pose);
    QLineF heading = scene.to_screen.map(
        QLineF(pose.x, pose.y, pose.x + std::cos(pose.theta), pose.y + std::sin(pose.theta)));
    heading.setLength(18.0);
    painter.setPen(thin_pen(scene.colours.highlight, 2.4));
    painter.drawLine(heading);
    draw_disc(painter, heading.p1(), 5.5, scene.colours.highlight);
}

void draw_ancestry(QPainter& painter, const Scene& scene,
                   const std::vector<HistoryBranch>& branches,
                   const std::vector<std::size_t>& begins, const Pose& pose_view_world) {
    for (const HistoryBranch& branch : branches) {
        std::vector<std::size_t> of_branch;
        for (const std::size_t scan : begins)
            if (scan > branch.first) of_branch.push_back(scan - branch.first);
        std::vector<QPointF> points;
        points.reserve(branch.poses.size());
        for (const Pose& pose : branch.poses) {
            const Point2 point = transform(pose_view_world, Point2{pose.x, pose.y});
            points.emplace_back(point.x, point.y);
        }
        const double width = std::min(0.8 + 0.4 * std::log2(1.0 + branch.particles), 4.0);
        draw_path(painter, scene, points, thin_pen(faded(scene.colours.particle, 200), width),
                  of_branch);
    }
}

void draw_cloud(QPainter& painter, const Scene& scene, const ParticleCloud& cloud) {
    constexpr double kArrowPixels = 9.0;
    std::array<QVector<QLineF>, kWeightShades> arrows;
    std::array<QPolygonF, kWeightShades> places;
    for (std::size_t i = 0; i < cloud.particles.size(); ++i) {
        const auto shade = static_cast<std::size_t>(
            std::lround(cloud.weights[i] * static_cast<double>(kWeightShades - 1)));
        QLineF arrow = scene.to_screen.map(cloud.particles[i]);
        arrow.setLength(kArrowPixels);
        arrows.at(shade).append(arrow);
        places.at(shade).append(arrow.p1());
    }
    const bool many = cloud.particles.size() > 300;  // antialiasing a thousand lines is dear
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, !many);
    for (std::size_t shade = 0; shade < kWeightShades; ++shade) {  // the heavy ones on top
        QColor colour =
            shade_of(scene, static_cast<double>(shade) / static_cast<double>(kWeightShades - 1));
        painter.setPen(QPen(colour, 2.4, Qt::SolidLine, Qt::RoundCap));
        painter.drawPoints(places.at(shade));
        colour.setAlpha(colour.alpha() * (many ? 110 : 150) / 255);
        painter.setPen(thin_pen(colour));
        painter.drawLines(arrows.at(shade));
    }
    painter.restore();
}

}  // namespace hitos::window
