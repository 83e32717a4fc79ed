// SPDX-License-Identifier: GPL-3.0-or-later
#include "ransac_lines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hitos/capture/closed_scan.hpp"
#include "hitos/features/line_fit.hpp"

namespace hitos {
namespace {

/// Readings that may stray before a jump counts as an edge: spurious readings must not cut a wall.
constexpr std::uint32_t kStrays = 5;
/// Chance of having drawn two points of the best line when a search ends early.
constexpr double kConfidence = 0.9999;
constexpr int kRefits = 10;
constexpr std::size_t kNoLine = std::numeric_limits<std::size_t>::max();

std::size_t draw_below(std::size_t count, RandomStream& random) {
    return std::min(static_cast<std::size_t>(random.uniform() * static_cast<double>(count)),
                    count - 1);
}

/// Draws after which two points of a line that holds `part` of all were drawn with kConfidence.
double draws_needed(double part) {
    const double miss = 1.0 - part * part;
    return miss <= 0.0 ? 1.0 : std::log(1.0 - kConfidence) / std::log(miss);
}

}  // namespace

void RansacLines::extract_lines(const Scan& scan, Observation& out) {
    RandomStream random(seed_, RandomPurpose::line_sampling, next_scan_++, 0);
    pieces_.clear();
    points_.clear();
    points_.reserve(2 * scan.points.size() + 2);  // pieces point into it: it must not move
    const std::span<const Point2> points = in_order(scan);
    if (params_.order == RansacOrder::ransac_first) {
        run_ranges_ = ranges_;
        run_of_.clear();
        for (std::size_t run = 0; run < scan.run_starts.size(); ++run)
            run_of_.resize(scan.run_end(run), static_cast<std::uint32_t>(run));
        run_of_.resize(points.size(), 0);
        search(points, random);
    } else if (goes_all_round(scan)) {
        follow_edges(points, 0, points.size(), random);
    } else {
        for (std::size_t run = 0; run < scan.run_starts.size(); ++run) {
            follow_edges(points, scan.run_starts[run], scan.run_end(run), random);
        }
    }
    merge_collinear(pieces_, lines_params_.collinear, LineFit::least_squares, scan.fan.closed(),
                    out);
}

/// The points of the scan, and `ranges_` with theirs. A run that goes all round begins behind an
/// edge; where it has none it stays cut at a corner, whose point then ends the run too, so that it
/// can be of both walls.
std::span<const Point2> RansacLines::in_order(const Scan& scan) {
    ranges_.clear();
    const Pose& laser = scan.fan.pose_robot_laser;
    for (const Point2& p : scan.points) {
        ranges_.push_back(std::hypot(p.x - laser.x, p.y - laser.y));
    }
    if (!goes_all_round(scan)) return scan.points;
    const std::size_t count = ranges_.size();
    // Of the edges that are no strays the greatest, for what the parameters call an edge.
    std::size_t start = count;
    double greatest = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const double before = ranges_[(i + count - 1) % count];
        const double step = std::abs(ranges_[i] - before) / std::min(ranges_[i], before);
        if (step <= greatest) continue;
        bool edge = true;
        for (std::size_t k = 0; edge && k <= std::min<std::size_t>(kStrays, count - 1); ++k) {
            edge = edge_between(ranges_[(i + k) % count], before) &&
                   edge_between(ranges_[i], ranges_[(i + count - 1 - k) % count]);
        }
        if (!edge) continue;
        greatest = step;
        start = i;
    }
    around_ = scan.points;
    if (start < count) {
        const auto by = static_cast<std::ptrdiff_t>(start);
        std::rotate(around_.begin(), around_.begin() + by, around_.end());
        std::rotate(ranges_.begin(), ranges_.begin() + by, ranges_.end());
    } else {
        around_.push_back(around_.front());
        ranges_.push_back(ranges_.front());
    }
    return around_;
}

void RansacLines::follow_edges(std::span<const Point2> points, std::size_t begin, std::size_t end,
                               RandomStream& random) {
    while (begin < end) {
        std::size_t last = begin;
        for (std::size_t i = begin + 1; i < end && i - last <= kStrays + 1; ++i) {
            if (!edge_between(ranges_[i], ranges_[last])) last = i;
        }
        run_ranges_ = std::span(ranges_).subspan(begin, last - begin + 1);
        search(points.subspan(begin, last - begin + 1), random);
        begin = last + 1;
    }
}

/// Whether more than strays, an edge or the end of a run of neighbours lies between two points.
bool RansacLines::parted(std::size_t last, std::size_t next) const {
    return place_[next] - place_[last] > kStrays + 1 ||
           edge_between(run_ranges_[next], run_ranges_[last]) ||
           (params_.order == RansacOrder::ransac_first && run_of_[next] != run_of_[last]);
}

bool RansacLines::edge_between(double range_a, double range_b) const {
    return std::abs(range_a - range_b) >
           params_.edge_m + params_.edge_per_range * std::min(range_a, range_b);
}

void RansacLines::search(std::span<const Point2> run, RandomStream& random) {
    const auto fewest = static_cast<std::size_t>(lines_params_.min_points);
    candidates_.x.clear();
    candidates_.y.clear();
    for (const Point2& p : run) {
        candidates_.x.push_back(p.x);
        candidates_.y.push_back(p.y);
    }
    found_.clear();
    while (candidates_.size() >= fewest) {
        Recta line;
        if (!hypothesize(random, line)) break;
        const Recta hypothesis = line;
        const bool refined = refine(line);
        if (refined && long_enough(consensus_, line)) found_.push_back(line);
        if (!refined) line = hypothesis;
        // Take the consensus away, whether it is a line or not: the search must come to an end.
        std::size_t kept = 0;
        const PreparedRecta taken(line);
        for (std::size_t i = 0; i < candidates_.size(); ++i) {
            if (near(taken, {candidates_.x[i], candidates_.y[i]})) continue;
            candidates_.x[kept] = candidates_.x[i];
            candidates_.y[kept++] = candidates_.y[i];
        }
        if (kept == candidates_.size()) break;
        candidates_.x.resize(kept);
        candidates_.y.resize(kept);
    }
    if (!found_.empty()) keep_pieces(run);
}

bool RansacLines::hypothesize(RandomStream& random, Recta& best) const {
    const std::size_t count = candidates_.size();
    const double* x = candidates_.x.data();
    const double* y = candidates_.y.data();
    int most = 0;
    double needed = params_.iterations;
    for (int draw = 0; draw < params_.iterations && draw < needed; ++draw) {
        const std::size_t a = draw_below(count, random);
        std::size_t b = draw_below(count - 1, random);
        if (b >= a) ++b;
        const double length = std::hypot(x[b] - x[a], y[b] - y[a]);
        if (length == 0.0) continue;
        const double nx = (y[b] - y[a]) / length;
        const double ny = (x[a] - x[b]) / length;
        const double rho = nx * x[a] + ny * y[a];
        int inside = 0;
        for (std::size_t i = 0; i < count; ++i) {
            inside += std::abs(nx * x[i] + ny * y[i] - rho) < params_.threshold_m ? 1 : 0;
        }
        if (inside <= most) continue;
        most = inside;
        best = normalized({rho, std::atan2(ny, nx)});
        needed = draws_needed(static_cast<double>(inside) / static_cast<double>(count));
    }
    return most >= lines_params_.min_points;
}

bool RansacLines::refine(Recta& line) {
    std::size_t before = 0;
    for (int i = 0; i < kRefits; ++i) {
        consensus_.clear();
        const PreparedRecta prepared(line);
        for (std::size_t k = 0; k < candidates_.size(); ++k) {
            const Point2 point{candidates_.x[k], candidates_.y[k]};
            if (near(prepared, point)) consensus_.push_back(point);
        }
        if (consensus_.size() < static_cast<std::size_t>(lines_params_.min_points)) return false;
        if (consensus_.size() == before) break;
        before = consensus_.size();
        line = fit_least_squares(consensus_);
    }
    return true;
}

void RansacLines::keep_pieces(std::span<const Point2> run) {
    // The first line found has taken the ends of those that meet it; give them back.
    prepared_.clear();
    for (const Recta& line : found_) prepared_.emplace_back(line);
    nearest_.assign(run.size(), kNoLine);
    for (std::size_t i = 0; i < run.size(); ++i) {
        double least = params_.threshold_m;
        for (std::size_t line = 0; line < prepared_.size(); ++line) {
            const double away = std::abs(prepared_[line].signed_distance(run[i]));
            if (away >= least) continue;
            least = away;
            nearest_[i] = line;
        }
    }
    share_corners(run);
    // In scan order of their first points, as every method gives them.
    order_.clear();
    for (const std::size_t line : nearest_) {
        if (line != kNoLine && std::find(order_.begin(), order_.end(), line) == order_.end()) {
            order_.push_back(line);
        }
    }
    // Where RANSAC comes first, points on no line are gone before anything is divided.
    place_.clear();
    std::size_t place = 0;
    for (const std::size_t line : nearest_) {
        place_.push_back(place);
        place += line != kNoLine || params_.order == RansacOrder::edges_first ? 1 : 0;
    }
    for (const std::size_t line : order_) {
        std::size_t first = points_.size();
        fitted_.clear();
        std::size_t last = 0;  // place in the run of the line's newest point
        for (std::size_t i = 0; i < run.size(); ++i) {
            if (nearest_[i] != line && shared_[i] != line) continue;
            // Where an infinite line crosses another wall far away, a point of that wall is on it
            // by chance: what other points or an edge part from the line must be one by itself.
            if (points_.size() > first && parted(last, i)) {
                keep_piece(first);
                first = points_.size();
                fitted_.clear();
            }
            points_.push_back(run[i]);
            if (shared_[i] == kNoLine) fitted_.push_back(run[i]);
            last = i;
        }
        keep_piece(first);
    }
}

void RansacLines::share_corners(std::span<const Point2> run) {
    shared_.assign(run.size(), kNoLine);
    for (std::size_t i = 0; i + 1 < run.size(); ++i) {
        const std::size_t a = nearest_[i];
        const std::size_t b = nearest_[i + 1];
        if (a == b || a == kNoLine || b == kNoLine) continue;
        const double to_b = std::abs(prepared_[b].signed_distance(run[i]));
        const double to_a = std::abs(prepared_[a].signed_distance(run[i + 1]));
        if (std::min(to_a, to_b) >= params_.threshold_m) continue;
        (to_b <= to_a ? shared_[i] : shared_[i + 1]) = to_b <= to_a ? b : a;
    }
}

void RansacLines::keep_piece(std::size_t first) {
    const std::span<const Point2> points(points_.data() + first, points_.size() - first);
    if (points.size() >= static_cast<std::size_t>(lines_params_.min_points)) {
        // A point at a corner supports both walls but would tilt the one it is not on.
        const Recta fitted =
            fit_least_squares(fitted_.size() < 2 ? points : std::span<const Point2>(fitted_));
        if (long_enough(points, fitted)) {
            pieces_.push_back({points, fitted});
            return;
        }
    }
    points_.resize(first);
}

bool RansacLines::near(const PreparedRecta& line, const Point2& point) const {
    return std::abs(line.signed_distance(point)) < params_.threshold_m;
}

bool RansacLines::long_enough(std::span<const Point2> points, const Recta& line) const {
    const PreparedRecta prepared(line);
    double from = std::numeric_limits<double>::infinity();
    double to = -from;
    for (const Point2& p : points) {
        const double along = prepared.along(p);
        from = std::min(from, along);
        to = std::max(to, along);
    }
    return to > from && to - from >= lines_params_.min_length_m;
}

LineMethodEntry ransac_method() {
    LineMethodEntry entry;
    entry.word = "ransac";
    entry.label = HITOS_TEXT("ParameterChoice", "RANSAC");
    entry.purpose =
        "cuts the scan at edges and takes the lines that most points agree with, fitted by least "
        "squares";
    entry.reads = {"ransac.edge", "ransac.edge_per_range", "ransac.threshold", "ransac.iterations",
                   "ransac.order"};
    entry.make = [](const ExtractionParams& params, std::uint64_t seed) {
        return std::make_unique<RansacLines>(params.lines, params.ransac, seed);
    };
    return entry;
}

}  // namespace hitos
