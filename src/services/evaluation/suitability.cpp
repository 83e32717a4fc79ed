// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/evaluation/suitability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hitos/base/translatable.hpp"
#include "hitos/features/line_methods.hpp"

namespace hitos {
namespace {

/// The first scans of a map match nothing, whatever the configuration.
constexpr std::uint64_t kFirstScans = 20;

// Where a figure speaks plainly; docs/evaluation.md has those of good and of bad runs.
constexpr double kLongStep = 0.25;      // m
constexpr double kStepPerSigma = 20.0;  // noise below a twentieth of the step covers no slip
constexpr double kMuchScatter = 0.38;   // of dmax: with normal noise one wall in a few breaks
constexpr double kManyUnmatched = 0.3;
constexpr double kManyEmpty = 0.6;  // of recorded buildings up to 0.3, of an orchard 0.8

}  // namespace

std::string Advice::words() const {
    std::string words(text);
    words.replace(words.find("%1"), 2, figure);
    return preset.empty() ? words : fmt::format("{} Try --preset {}.", words, preset);
}

void Suitability::note(std::span<const Control> controls, bool points, const Observation& seen,
                       std::span<const Association> associations) {
    if (points) {
        ++with_points_;
        if (seen.lines.empty() && seen.corners.empty()) ++empty_;
    }
    const double way = driven_way(controls).path_m;
    if (way > 0.0) {
        way_m_ += way;
        ++moves_;
    }
    for (const DetectedLine& line : seen.lines) {
        const PreparedRecta prepared(line.recta);
        for (const Point2& point : seen.support_of(line)) {
            const double away = prepared.signed_distance(point);
            distance2_m2_ += away * away;
        }
        points_ += line.count;
    }
    if (scans_++ < kFirstScans) return;
    for (const Association& association : associations) {
        ++observed_;
        matched_ += association.outcome == Association::Outcome::created ? 0U : 1U;
    }
}

SuitabilityFigures Suitability::figures() const {
    SuitabilityFigures figures;
    if (moves_ > 0) figures.step_m = way_m_ / static_cast<double>(moves_);
    if (points_ > 0) figures.scatter_m = std::sqrt(distance2_m2_ / static_cast<double>(points_));
    if (observed_ > 0) {
        figures.unmatched =
            static_cast<double>(observed_ - matched_) / static_cast<double>(observed_);
    }
    if (with_points_ > 0)
        figures.empty = static_cast<double>(empty_) / static_cast<double>(with_points_);
    return figures;
}

std::vector<Advice> Suitability::advice(const Configuracion& configuration, bool simulated) const {
    std::vector<Advice> advice;
    if (scans_ < kFirstScans) return advice;
    const SuitabilityFigures seen = figures();
    const MotionParams& motion = configuration.filter.motion;
    double sigma = std::max(motion.sigma_x_m, motion.sigma_y_m);
    if (motion.unit == MotionUnit::variance) sigma = std::sqrt(sigma);
    // Neither of these knows trees.
    const std::string_view preset = configuration.extraction.circles.find ? ""
                                    : simulated                           ? "simulated"
                                                                          : "recorded";
    if (seen.empty > kManyEmpty && !configuration.extraction.circles.find) {
        advice.push_back({HITOS_TEXT("Advice",
                                     "%1 of the scans show no wall and no corner: of trees and "
                                     "posts, which are round, landmarks are made where "
                                     "features.circles is on."),
                          fmt::format("{:.0f} %", 100.0 * seen.empty), kTreePreset});
    }
    if (motion.model == "odometry" && seen.step_m > kLongStep &&
        seen.step_m > kStepPerSigma * sigma) {
        advice.push_back({HITOS_TEXT("Advice",
                                     "The robot drives %1 between scans, which is far for noise of "
                                     "a fixed size at every scan: the path may be lost."),
                          fmt::format("{:.2f} m", seen.step_m), preset});
    }
    const ExtractionParams& extraction = configuration.extraction;
    if (line_methods().reads(extraction.method, "split_merge.dmax") &&
        seen.scatter_m > kMuchScatter * extraction.split_merge.dmax_m) {
        advice.push_back(
            {HITOS_TEXT("Advice",
                        "The points of a line lie %1 from it, too much for split_merge.dmax: walls "
                        "break into pieces, and their ends become false corners."),
             fmt::format("{:.1f} mm", 1e3 * seen.scatter_m), preset});
    }
    if (seen.unmatched > kManyUnmatched) {
        advice.push_back({HITOS_TEXT("Advice",
                                     "%1 of the observations match nothing in the map: what is "
                                     "seen again becomes a new landmark."),
                          fmt::format("{:.0f} %", 100.0 * seen.unmatched), preset});
    }
    return advice;
}

}  // namespace hitos
