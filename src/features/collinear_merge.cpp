#include "collinear_merge.hpp"

#include <algorithm>
#include <cmath>

#include "line_fit.hpp"

namespace hitos {
namespace {

bool collinear(const Recta& recta, const LinePiece& last_piece, const LinePiece& candidate,
               const CollinearParams& params) {
    const LineDifference apart = difference(recta, candidate.recta);
    if (apart.rho >= params.rho_m || apart.theta >= params.theta_rad) return false;
    if (params.gap_m == 0.0) return true;
    const Point2& end = last_piece.points.back();
    const Point2& begin = candidate.points.front();
    return std::hypot(end.x - begin.x, end.y - begin.y) < params.gap_m;
}

}  // namespace

Recta fit_line(std::span<const Point2> points, const std::array<Point2, 2>& ends, LineFit fit) {
    return fit == LineFit::endpoints ? line_through(ends[0], ends[1]) : fit_least_squares(points);
}

std::array<Point2, 2> ends_of(std::span<const Point2> points, const Recta& line) {
    const auto along = [prepared = PreparedRecta(line)](const Point2& p) {
        return prepared.along(p);
    };
    const auto [least, greatest] =
        std::minmax_element(points.begin(), points.end(),
                            [&](const Point2& a, const Point2& b) { return along(a) < along(b); });
    const double extent = along(*greatest) - along(*least);
    if (std::abs(along(points.back()) - along(points.front())) >= 0.5 * extent) {
        return {points.front(), points.back()};
    }
    return {*least, *greatest};
}

void merge_collinear(std::span<LinePiece> pieces, const CollinearParams& params, LineFit fit,
                     Observation& out) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (pieces[i].merged) continue;
        DetectedLine line{pieces[i].recta, static_cast<std::uint32_t>(out.support.size()), 0};
        const auto append = [&](const LinePiece& piece) {
            out.support.insert(out.support.end(), piece.points.begin(), piece.points.end());
            line.count = static_cast<std::uint32_t>(out.support.size()) - line.first;
        };
        append(pieces[i]);
        std::size_t newest = i;
        for (std::size_t j = i + 1; j < pieces.size(); ++j) {
            if (pieces[j].merged || !collinear(line.recta, pieces[newest], pieces[j], params)) {
                continue;
            }
            pieces[j].merged = true;
            append(pieces[j]);
            const std::span<const Point2> support(&out.support[line.first], line.count);
            line.recta = fit_line(support, ends_of(support, line.recta), fit);
            newest = j;
        }
        out.lines.push_back(line);
    }
}

}  // namespace hitos
