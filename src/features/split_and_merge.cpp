#include "split_and_merge.hpp"

#include <algorithm>
#include <cmath>

#include "hitos/features/line_fit.hpp"

namespace hitos {
namespace {

double distance(const Point2& a, const Point2& b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

}  // namespace

Recta fit_least_squares(std::span<const Point2> points) {
    const auto n = static_cast<double>(points.size());
    double mean_x = 0.0;
    double mean_y = 0.0;
    for (const Point2& p : points) {
        mean_x += p.x;
        mean_y += p.y;
    }
    mean_x /= n;
    mean_y /= n;
    double sxx = 0.0;
    double sxy = 0.0;
    double syy = 0.0;
    for (const Point2& p : points) {
        const double dx = p.x - mean_x;
        const double dy = p.y - mean_y;
        sxx += dx * dx;
        sxy += dx * dy;
        syy += dy * dy;
    }
    // The scatter's principal axis lies at half of atan2(2 sxy, sxx - syy); the normal is
    // perpendicular to it.
    const double theta = 0.5 * std::atan2(2.0 * sxy, sxx - syy) + kPi / 2.0;
    return normalized({mean_x * std::cos(theta) + mean_y * std::sin(theta), theta});
}

bool SplitAndMerge::gap_between(const Point2& a, const Point2& b) const {
    if (params_.gap_m == 0.0 && params_.gap_per_range == 0.0) return false;
    const double range = std::min(std::hypot(a.x, a.y), std::hypot(b.x, b.y));
    return distance(a, b) > params_.gap_m + params_.gap_per_range * range;
}

void SplitAndMerge::split(const Scan& scan, std::uint32_t first, std::uint32_t last) {
    // A stack of index ranges instead of recursion: a scan of many rays must not grow the call
    // stack. The left half is taken first, so pieces come in scan order.
    pending_.assign(1, {first, last});
    while (!pending_.empty()) {
        const auto [begin, end] = pending_.back();
        pending_.pop_back();
        if (end - begin + 1 < static_cast<std::uint32_t>(params_.min_points)) continue;
        const Point2& a = scan.points[begin];
        const Point2& b = scan.points[end];
        const double length = distance(a, b);
        if (length < params_.min_length_m || length == 0.0) continue;
        // Distance from the chord, as a cross product: no angle is needed to split.
        const double nx = (b.y - a.y) / length;
        const double ny = (a.x - b.x) / length;
        double farthest = -1.0;
        std::uint32_t at = begin;
        for (std::uint32_t i = begin + 1; i < end; ++i) {
            const double d =
                std::abs((scan.points[i].x - a.x) * nx + (scan.points[i].y - a.y) * ny);
            if (d > farthest) {
                farthest = d;
                at = i;
            }
        }
        if (farthest < params_.dmax_m) {
            pieces_.push_back({begin, end, fit(&scan.points[begin], end - begin + 1), false});
        } else {
            // Both halves keep the point of the split: a corner belongs to both its walls.
            pending_.emplace_back(at, end);
            pending_.emplace_back(begin, at);
        }
    }
}

bool SplitAndMerge::collinear(const Scan& scan, const Recta& recta, const Piece& last_piece,
                              const Piece& candidate) const {
    const LineDifference apart = difference(recta, candidate.recta);
    if (apart.rho >= params_.collinear_rho_m || apart.theta >= params_.collinear_theta_rad) {
        return false;
    }
    return params_.collinear_gap_m == 0.0 ||
           distance(scan.points[last_piece.last], scan.points[candidate.first]) <
               params_.collinear_gap_m;
}

Recta SplitAndMerge::fit(const Point2* points, std::size_t count) const {
    if (params_.fit == LineFit::endpoints) return line_through(points[0], points[count - 1]);
    return fit_least_squares({points, count});
}

void SplitAndMerge::extract_lines(const Scan& scan, Observation& out) {
    pieces_.clear();
    const auto total = static_cast<std::uint32_t>(scan.points.size());
    for (std::size_t run = 0; run < scan.run_starts.size(); ++run) {
        const std::uint32_t run_end =
            run + 1 < scan.run_starts.size() ? scan.run_starts[run + 1] : total;
        std::uint32_t begin = scan.run_starts[run];
        for (std::uint32_t i = begin + 1; i <= run_end; ++i) {
            if (i == run_end || gap_between(scan.points[i - 1], scan.points[i])) {
                split(scan, begin, i - 1);
                begin = i;
            }
        }
    }

    // [T table 4.4]: each piece takes up the later ones that are collinear with it as it grows.
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        if (pieces_[i].merged) continue;
        DetectedLine line{pieces_[i].recta, static_cast<std::uint32_t>(out.support.size()), 0};
        const auto append = [&](const Piece& piece) {
            out.support.insert(out.support.end(), scan.points.begin() + piece.first,
                               scan.points.begin() + piece.last + 1);
            line.count = static_cast<std::uint32_t>(out.support.size()) - line.first;
        };
        append(pieces_[i]);
        std::size_t newest = i;
        for (std::size_t j = i + 1; j < pieces_.size(); ++j) {
            if (pieces_[j].merged || !collinear(scan, line.recta, pieces_[newest], pieces_[j])) {
                continue;
            }
            pieces_[j].merged = true;
            append(pieces_[j]);
            line.recta = fit(&out.support[line.first], line.count);
            newest = j;
        }
        out.lines.push_back(line);
    }
}

}  // namespace hitos
