// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/features/extractor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "circle_extractor.hpp"
#include "collinear_merge.hpp"
#include "extractors.hpp"
#include "hitos/base/error.hpp"
#include "hitos/capture/closed_scan.hpp"
#include "hitos/features/extraction_parameters.hpp"
#include "hitos/features/line_fit.hpp"

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
    for (const Point2& p : observation.support_of(line)) {
        const double dx = p.x - point.x;
        const double dy = p.y - point.y;
        nearest = std::min(nearest, dx * dx + dy * dy);
    }
    return std::sqrt(nearest);
}

/// A method of somebody's own may return anything; nothing that is computed from what is no number,
/// or of points that are not there, would tell.
void check_lines(const Observation& seen) {
    for (std::size_t i = 0; i < seen.lines.size(); ++i) {
        const auto& [line, first, count] = seen.lines[i];
        if (count == 0 || first > seen.support.size() || count > seen.support.size() - first) {
            throw Error(message(
                HITOS_TEXT("Errors",
                           "the line method returned %1 points from %2 on, of %3, "
                           "for line %4 of the scan at %5 s; expected at least one, "
                           "and all of them in Observation::support"),
                count, first, seen.support.size(), i + 1, fmt::format("{:.6f}", seen.time_s)));
        }
        if (std::isfinite(line.rho) && std::isfinite(line.theta)) continue;
        throw Error(message(HITOS_TEXT("Errors",
                                       "the line method returned rho %1, theta %2 for line %3 of "
                                       "the scan at %4 s; expected finite numbers"),
                            line.rho, line.theta, i + 1, fmt::format("{:.6f}", seen.time_s)));
    }
}

/// Landmarks that a sensor told by themselves are corners, behind those that were found.
void add_landmarks(const Scan& scan, Observation& out) {
    if (scan.landmarks.empty()) return;
    out.identities.assign(out.corners.size(), LandmarkSighting::kNameless);
    for (const LandmarkSighting& seen : scan.landmarks) {
        const Point2 point = seen.point();
        out.corners.push_back({point.x, point.y});
        out.identities.push_back(seen.identity);
    }
}

}  // namespace

void find_corners(Observation& seen, double corner_distance_m, double corner_angle_rad) {
    const double least_sine = std::sin(corner_angle_rad);
    for (std::size_t i = 0; i < seen.lines.size(); ++i) {
        for (std::size_t j = i + 1; j < seen.lines.size(); ++j) {
            const DetectedLine& a = seen.lines[i];
            const DetectedLine& b = seen.lines[j];
            if (std::abs(std::sin(b.recta.theta - a.recta.theta)) < least_sine) continue;
            const auto meeting = intersection(a.recta, b.recta);
            if (!meeting || distance_to_support(seen, a, *meeting) > corner_distance_m ||
                distance_to_support(seen, b, *meeting) > corner_distance_m) {
                continue;
            }
            seen.corners.push_back({meeting->x, meeting->y});
            if (seen.line_covariances.empty()) continue;
            seen.corner_covariances.push_back(intersection_covariance(
                a.recta, seen.line_covariances[i], b.recta, seen.line_covariances[j], *meeting));
        }
    }
}

LineFinder::LineFinder(const ExtractionParams& params, std::uint64_t seed)
    : method_(line_methods().find(params.method).make(params, draws_at_random(params) ? seed : 0)),
      covariance_(params.covariance),
      point_sigma_m_(params.point_sigma_m),
      common_sigma_m_(params.common_sigma_m) {}

void LineFinder::find(const Scan& scan, Observation& out) {
    out.clear();
    out.time_s = scan.time_s;
    method_->extract_lines(cut_open(scan, cut_open_), out);
    check_lines(out);
    if (covariance_ == ObservationCovariance::fixed) return;
    const PointErrors of_points = errors(scan);
    for (const DetectedLine& line : out.lines) {
        const std::span<const Point2> support = out.support_of(line);
        out.line_covariances.push_back(
            method_->fits_end_points()
                ? line_covariance(line.recta, ends_of(support, line.recta), of_points)
                : line_covariance(line.recta, support, of_points));
    }
}

void LineFinder::fit_all(const Scan& scan, Observation& out) const {
    for (DetectedLine& line : out.lines) line.recta = fit_least_squares(out.support_of(line));
    for (std::size_t i = 0; i < out.line_covariances.size(); ++i) {
        const DetectedLine& line = out.lines[i];
        out.line_covariances[i] = line_covariance(line.recta, out.support_of(line), errors(scan));
    }
}

PointErrors LineFinder::errors(const Scan& scan) const {
    return {point_sigma_m_,
            common_sigma_m_,
            {scan.fan.pose_robot_laser.x, scan.fan.pose_robot_laser.y}};
}

void ExRectas::extract(const Scan& scan, Observation& out) {
    lines_.find(scan, out);
    add_landmarks(scan, out);
}

void ExPuntos::extract(const Scan& scan, Observation& out) {
    lines_.find(scan, out);
    if (fit_) {
        detected_ = out.lines;
        detected_covariances_ = out.line_covariances;
        lines_.fit_all(scan, out);
    }
    find_corners(out, corner_distance_m_, corner_angle_rad_);
    add_landmarks(scan, out);
    if (keep_lines_) {
        if (fit_) {
            out.lines = detected_;
            out.line_covariances = detected_covariances_;
        }
        return;
    }
    out.lines.clear();
    out.line_covariances.clear();
    out.support.clear();
}

std::unique_ptr<Extractor> make_extractor(const ExtractionParams& params, std::uint64_t seed) {
    check_all(extraction_parameters(), params);
    LineFinder lines(params, seed);
    std::unique_ptr<Extractor> extractor;
    if (params.detect == Detection::lines) {
        extractor = std::make_unique<ExRectas>(std::move(lines));
    } else {
        extractor = std::make_unique<ExPuntos>(std::move(lines), params.corner_distance_m,
                                               params.corner_angle_rad, params.corner_lines,
                                               params.detect == Detection::both);
    }
    if (!params.circles.find) return extractor;
    return std::make_unique<CircleExtractor>(params, std::move(extractor));
}

bool draws_at_random(const ExtractionParams& params) {
    return line_methods().find(params.method).random;
}

}  // namespace hitos
