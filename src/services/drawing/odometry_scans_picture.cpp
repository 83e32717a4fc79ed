#include "odometry_scans_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>

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

/// A named block of data in a script: places in a row.
void add_block(std::string& script, const char* name, std::span<const Point2> points) {
    auto out = std::back_inserter(script);
    fmt::format_to(out, "${} << EOD\n", name);
    for (const Point2& p : points) fmt::format_to(out, "{:.3f} {:.3f}\n", p.x, p.y);
    script += "EOD\n";
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
    Bounds frame;
    for (const Point2& p : points_) frame.hold(p);
    for (const Point2& p : path_) frame.hold(p);
    std::string text;
    add_block(text, "points", points_);
    add_block(text, "path", path_);
    text += "$walls << EOD\n";
    for (const auto& [a, b] : walls_) {
        frame.hold(a);
        frame.hold(b);
        fmt::format_to(std::back_inserter(text), "{:.4f} {:.4f}\n{:.4f} {:.4f}\n\n", a.x, a.y, b.x,
                       b.y);
    }
    const double width = frame.high.x - frame.low.x;
    const double height = frame.high.y - frame.low.y;
    const double margin = 0.03 * std::max(width, height) + 0.2;
    constexpr double kLongest = 1300.0;  // pixels
    constexpr double kLeast = 360.0;
    constexpr double kAround = 130.0;  // for axes and legend
    const double scale = kLongest / (std::max(width, height) + 2.0 * margin);
    const auto pixels = [&](double metres) {
        return std::max((metres + 2.0 * margin) * scale, kLeast) + kAround;
    };
    return text +
           fmt::format(
               "EOD\nset terminal pngcairo size {:.0f},{:.0f}\n"
               "set output 'odometry_scans.png'\n"
               "set size ratio -1\nset xrange [{:.3f}:{:.3f}]\nset yrange [{:.3f}:{:.3f}]\n"
               "set xlabel 'x (m)'\nset ylabel 'y (m)'\nset grid lc rgb '#e0e0e0'\n"
               "set key below horizontal\n"
               "plot $walls with lines lw 5 lc rgb '#c8c8c8' title 'true walls', "
               "$points with points pt 7 ps 0.25 lc rgb '#0000ff' title 'scans by odometry', "
               "$path with lines lw 2 lc rgb '#ff00ff' title 'odometry'\n",
               pixels(width), pixels(height), frame.low.x - margin, frame.high.x + margin,
               frame.low.y - margin, frame.high.y + margin);
}

Message OdometryScansPicture::write(const std::filesystem::path& folder) const {
    const std::vector<PlotFile> files = {{"odometry_scans.gp", script()}};
    const std::vector<std::string> pictures = {"odometry_scans.png"};
    return draw_pictures(folder, files, "odometry_scans.gp", pictures);
}

}  // namespace hitos
