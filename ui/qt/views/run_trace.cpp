// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_trace.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "look/words_of.hpp"

namespace hitos::window {
namespace {

/// Its two ends in metres beside it, in the painter's colour.
void draw_error_scale(QPainter& painter, const QRectF& row, double greatest_m) {
    constexpr double kGap = 6.0;
    constexpr double kThick = 8.0;
    const QString least = QStringLiteral("0");
    const QString greatest = metre_words(greatest_m);
    const QFontMetricsF metrics(painter.font());
    const QRectF bar(
        row.left() + metrics.horizontalAdvance(least) + kGap, row.center().y() - kThick / 2.0,
        row.width() - metrics.horizontalAdvance(least + greatest) - 2.0 * kGap, kThick);
    QLinearGradient gradient(bar.topLeft(), bar.topRight());
    constexpr int kStops = 8;
    for (int i = 0; i <= kStops; ++i) {
        const double share = static_cast<double>(i) / kStops;
        gradient.setColorAt(share, heat_colour(share));
    }
    painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter, least);
    painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, greatest);
    painter.setPen(Qt::NoPen);
    painter.fillRect(bar, gradient);
}

/// The one whose errors are drawn, which they all share the scale of.
const RunTrace* coloured(const std::vector<RunTrace>& traces) {
    const auto found =
        std::ranges::find_if(traces, [](const RunTrace& trace) { return !trace.errors_m.empty(); });
    return found == traces.end() ? nullptr : &*found;
}

constexpr double kErrorScale = 130.0;

/// Places that a legend had better not cover: along paths and walls.
std::vector<QPointF> shown_places(const std::vector<RunTrace>& traces, const MarkedMap& landmarks) {
    constexpr int kOfWall = 8;
    std::vector<QPointF> places;
    const auto add_walls = [&places](const MarkedMap& map) {
        for (const LineExtent& wall : map.extents) {
            const QLineF line(point_of(wall.a), point_of(wall.b));
            for (int i = 0; i <= kOfWall; ++i)
                places.push_back(line.pointAt(static_cast<double>(i) / kOfWall));
        }
    };
    add_walls(landmarks);
    for (const RunTrace& trace : traces) {
        add_walls(trace.landmarks);
        places.insert(places.end(), trace.path.begin(), trace.path.end());
    }
    return places;
}

/// Of the corners that are free of other things the one that the fewest places lie in.
QRectF emptiest_corner(const Scene& scene, const QSizeF& size, double margin,
                       const std::vector<QPointF>& places) {
    const double right = scene.size.width() - margin - size.width();
    const double bottom = scene.size.height() - margin - size.height();
    const std::array corners{QPointF(margin, margin), QPointF(right, margin),
                             QPointF(right, bottom)};  // the scale bar has the fourth
    QRectF emptiest;
    std::ptrdiff_t fewest = std::numeric_limits<std::ptrdiff_t>::max();
    for (const QPointF& corner : corners) {
        const QRectF there(corner, size);
        const std::ptrdiff_t covered = std::ranges::count_if(places, [&](const QPointF& place) {
            return there.contains(scene.to_screen.map(place));
        });
        if (covered >= fewest) continue;
        fewest = covered;
        emptiest = there;
    }
    return emptiest;
}

}  // namespace

void draw_errors(QPainter& painter, const Scene& scene, const RunTrace& trace) {
    constexpr double kLeastPixels = 3.0;
    draw_path(painter, scene, trace.path, thin_pen(trace.colour, 5.0), trace.begins);
    std::optional<QPointF> last;
    for (std::size_t i = 0; i < trace.path.size(); ++i) {
        const QPointF pixel = scene.to_screen.map(trace.path[i]);
        if (std::ranges::binary_search(trace.begins, i)) last.reset();
        if (last && QLineF(*last, pixel).length() < kLeastPixels) continue;
        if (last && std::isfinite(trace.errors_m[i])) {
            const double share = trace.errors_m[i] / std::max(trace.greatest_m, 1e-9);
            painter.setPen(thin_pen(heat_colour(share), 2.6));
            painter.drawLine(*last, pixel);
        }
        last = pixel;
    }
}

void draw_legend(QPainter& painter, const Scene& scene, const std::vector<RunTrace>& traces,
                 const MarkedMap& landmarks) {
    if (traces.empty()) return;
    constexpr double kMargin = 8.0;
    constexpr double kStroke = 22.0;
    const QFontMetricsF metrics(painter.font());
    const RunTrace* with_scale = coloured(traces);
    double width = with_scale != nullptr ? kErrorScale : 0.0;
    for (const RunTrace& trace : traces)
        width = std::max(width, metrics.horizontalAdvance(trace.name));
    const double height =
        metrics.height() * static_cast<double>(traces.size() + (with_scale != nullptr ? 1 : 0));
    const Colours& paper = light_colours();
    const QRectF place = emptiest_corner(scene, {width + kStroke + 3.0 * kMargin, height + kMargin},
                                         kMargin, shown_places(traces, landmarks));
    painter.setPen(thin_pen(paper.border));
    painter.setBrush(faded(paper.card, 225));
    painter.drawRoundedRect(place, 5.0, 5.0);
    const double left = place.left() + kMargin;
    double y = place.top() + 0.5 * kMargin + metrics.height() / 2.0;
    for (const RunTrace& trace : traces) {
        painter.setPen(thin_pen(trace.colour, 2.4, trace.line));
        painter.drawLine(QLineF(left, y, left + kStroke, y));
        painter.setPen(paper.text);
        painter.drawText(
            QPointF(left + kMargin + kStroke, y + metrics.ascent() - metrics.height() / 2.0),
            trace.name);
        y += metrics.height();
    }
    if (with_scale == nullptr) return;
    painter.setPen(paper.text);
    draw_error_scale(
        painter,
        QRectF(left, y - metrics.height() / 2.0, width + kStroke + kMargin, metrics.height()),
        with_scale->greatest_m);
}

std::vector<FigureEntry> entries_of(const std::vector<RunTrace>& traces) {
    std::vector<FigureEntry> entries;
    entries.reserve(traces.size() + 1);
    for (const RunTrace& trace : traces)
        entries.push_back({.name = trace.name, .colour = trace.colour, .line = trace.line});
    if (const RunTrace* with_scale = coloured(traces)) {
        entries.push_back(
            {.width = kErrorScale,
             .paint = [greatest_m = with_scale->greatest_m](QPainter& painter, const QRectF& row) {
                 draw_error_scale(painter, row, greatest_m);
             }});
    }
    return entries;
}

}  // namespace hitos::window
