// SPDX-License-Identifier: GPL-3.0-or-later
#include "odometry_scans_picture.hpp"

#include <array>
#include <cmath>

#include "hitos/services/drawing/gnuplot.hpp"

namespace hitos {
namespace {

constexpr double kCell = 0.01;  // m

std::uint64_t centimetre_cell_of(const Point2& point) {
    const auto place = [](double metres) {
        return static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(metres / kCell)));
    };
    return (static_cast<std::uint64_t>(place(point.x)) << 32U) | place(point.y);
}

}  // namespace

void OdometryScansPicture::add(const Scan& scan, const Pose& odometry) {
    path_.push_back({odometry.x, odometry.y});
    for (const Point2& point : scan.points) {
        const Point2 placed = transform(odometry, point);
        if (cells_.insert(centimetre_cell_of(placed)).second) points_.push_back(placed);
    }
}

std::string OdometryScansPicture::script() const {
    PlotLayer walls{"walls", "lines lw 5 lc rgb '#c8c8c8' title 'true walls'", {}};
    for (const auto& [a, b] : walls_) walls.lines.push_back({a, b});
    return place_script(
        "odometry_scans.png",
        std::array{std::move(walls),
                   PlotLayer{"points",
                             "points pt 7 ps 0.25 lc rgb '#0000ff' title 'scans by odometry'",
                             {points_}},
                   PlotLayer{"path", "lines lw 2 lc rgb '#ff00ff' title 'odometry'", {path_}}});
}

Message OdometryScansPicture::write(const std::filesystem::path& folder) const {
    const std::vector<PlotFile> files = {{"odometry_scans.gp", script()}};
    const std::vector<std::string> pictures = {"odometry_scans.png"};
    return draw_pictures(folder, files, "odometry_scans.gp", pictures);
}

}  // namespace hitos
