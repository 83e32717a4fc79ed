#include "collinear_merge.hpp"

#include <cmath>

#include "hitos/features/line_fit.hpp"

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

Recta fit_line(std::span<const Point2> points, LineFit fit) {
    return fit == LineFit::endpoints ? line_through(points.front(), points.back())
                                     : fit_least_squares(points);
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
            line.recta = fit_line({&out.support[line.first], line.count}, fit);
            newest = j;
        }
        out.lines.push_back(line);
    }
}

}  // namespace hitos
