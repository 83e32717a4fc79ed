#include "hitos/features/extractor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "extractors.hpp"
#include "hitos/capture/error.hpp"
#include "split_and_merge.hpp"

namespace hitos {
namespace {

/// Where two lines meet; nothing where they are parallel to within 1e-6 rad.
std::optional<Point2> intersection(const Recta& a, const Recta& b) {
    const double det = std::sin(b.theta - a.theta);
    if (std::abs(det) < 1e-6) return std::nullopt;
    return Point2{(a.rho * std::sin(b.theta) - b.rho * std::sin(a.theta)) / det,
                  (b.rho * std::cos(a.theta) - a.rho * std::cos(b.theta)) / det};
}

/// The distance of a point from the nearest of the points that support a line [T 4.3].
double distance_to_support(const Observation& observation, const DetectedLine& line,
                           const Point2& point) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = line.first; i < line.first + line.count; ++i) {
        const double dx = observation.support[i].x - point.x;
        const double dy = observation.support[i].y - point.y;
        nearest = std::min(nearest, dx * dx + dy * dy);
    }
    return std::sqrt(nearest);
}

void require(bool allowed, const char* key, const char* expected) {
    if (!allowed) throw ConfigError(key, std::string("expected ") + expected);
}

std::unique_ptr<MetodoExtraccionRectas> make_method(const ExtractionParams& params) {
    const SplitMergeParams& p = params.split_merge;
    require(p.dmax_m > 0.0, "split_merge.dmax", "a distance above 0 m");
    require(p.min_length_m >= 0.0, "split_merge.min_length", "a length of 0 m or more");
    require(p.min_points >= 2, "split_merge.min_points", "2 points or more");
    require(p.gap_m >= 0.0 && p.gap_per_range >= 0.0, "split_merge.gap", "0 or more");
    return std::make_unique<SplitAndMerge>(p);
}

}  // namespace

void find_corners(const Observation& lines, double corner_distance_m, std::vector<Esquina>& out) {
    for (std::size_t i = 0; i < lines.lines.size(); ++i) {
        for (std::size_t j = i + 1; j < lines.lines.size(); ++j) {
            const auto meeting = intersection(lines.lines[i].recta, lines.lines[j].recta);
            if (!meeting) continue;
            if (distance_to_support(lines, lines.lines[i], *meeting) <= corner_distance_m &&
                distance_to_support(lines, lines.lines[j], *meeting) <= corner_distance_m) {
                out.push_back({meeting->x, meeting->y});
            }
        }
    }
}

void ExRectas::extract(const Scan& scan, Observation& out) {
    out.clear();
    out.time_s = scan.time_s;
    method_->extract_lines(scan, out);
}

void ExPuntos::extract(const Scan& scan, Observation& out) {
    out.clear();
    out.time_s = scan.time_s;
    method_->extract_lines(scan, out);
    find_corners(out, corner_distance_m_, out.corners);
    if (!keep_lines_) {
        out.lines.clear();
        out.support.clear();
    }
}

std::unique_ptr<Extractor> make_extractor(const ExtractionParams& params) {
    require(params.corner_distance_m >= 0.0, "features.corner_distance", "0 m or more");
    auto method = make_method(params);
    if (params.detect == Detection::lines) return std::make_unique<ExRectas>(std::move(method));
    return std::make_unique<ExPuntos>(std::move(method), params.corner_distance_m,
                                      params.detect == Detection::both);
}

}  // namespace hitos
