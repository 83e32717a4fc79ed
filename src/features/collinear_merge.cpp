// SPDX-License-Identifier: GPL-3.0-or-later
#include "collinear_merge.hpp"

#include <algorithm>
#include <cmath>

#include "hitos/features/line_fit.hpp"

namespace hitos {
namespace {

/// The points are those between which the gap lies.
bool collinear(const Recta& recta, const Recta& candidate, const Point2& end, const Point2& begin,
               const CollinearParams& params) {
    const LineDifference apart = difference(recta, candidate);
    if (apart.rho >= params.rho_m || apart.theta >= params.theta_rad) return false;
    if (params.gap_m == 0.0) return true;
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
                     bool closed, Observation& out) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (pieces[i].merged) continue;
        DetectedLine line{pieces[i].recta, static_cast<std::uint32_t>(out.support.size()), 0};
        const auto take_up = [&](LinePiece& piece, bool in_front) {
            piece.merged = true;
            out.support.insert(in_front ? out.support.begin() + line.first : out.support.end(),
                               piece.points.begin(), piece.points.end());
            line.count = static_cast<std::uint32_t>(out.support.size()) - line.first;
        };
        const auto fit_anew = [&] {
            const std::span<const Point2> support(&out.support[line.first], line.count);
            line.recta = fit_line(support, ends_of(support, line.recta), fit);
        };
        take_up(pieces[i], false);
        // Round the seam of a closed scan the wall goes on with the last pieces.
        for (std::size_t j = pieces.size(), next = i; closed && i == 0 && --j > i; next = j) {
            if (!collinear(line.recta, pieces[j].recta, pieces[j].points.back(),
                           pieces[next].points.front(), params)) {
                break;
            }
            take_up(pieces[j], true);
            fit_anew();
        }
        std::size_t newest = i;
        for (std::size_t j = i + 1; j < pieces.size(); ++j) {
            if (pieces[j].merged ||
                !collinear(line.recta, pieces[j].recta, pieces[newest].points.back(),
                           pieces[j].points.front(), params)) {
                continue;
            }
            take_up(pieces[j], false);
            fit_anew();
            newest = j;
        }
        out.lines.push_back(line);
    }
}

}  // namespace hitos
