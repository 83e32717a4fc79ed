#include "hitos/services/run/quality.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "../evaluation/map_crispness.hpp"
#include "hitos/base/translatable.hpp"

namespace hitos {
namespace {

// docs/evaluation.md has the figures of good and of bad runs.
constexpr double kManyUnmatched = 0.02;
constexpr double kPoorScore = 0.5;
constexpr double kBlurrier = 1.05;          // than the odometry's map
constexpr double kLongWithoutLoop = 100.0;  // [m]

void measure_crispness(const Algoritmo& run, RunQuality& quality) {
    MapCrispness best;
    MapCrispness odometry;
    const Trajectory path = run.best_trajectory();
    const std::unique_ptr<TourReader> reader = run.reader().reopen();
    for (std::size_t i = 0; i < path.size(); ++i) {
        const std::optional<Scan> scan = reader->next_scan();
        if (!scan) break;
        best.add(*scan, path[i].pose);
        odometry.add(*scan, run.odometry_trajectory()[i].pose);
    }
    quality.cells_per_point = best.cells_per_point();
    quality.odometry_cells_per_point = odometry.cells_per_point();
}

double length_of(const Trajectory& path) {
    double length = 0.0;
    for (std::size_t i = 1; i < path.size(); ++i) {
        length +=
            std::hypot(path[i].pose.x - path[i - 1].pose.x, path[i].pose.y - path[i - 1].pose.y);
    }
    return length;
}

void warn_of_registration(const Algoritmo& run, RunQuality& quality) {
    const RegistrationFigures& figures = *quality.registration;
    const double unmatched = figures.scans > 0 ? static_cast<double>(figures.unmatched) /
                                                     static_cast<double>(figures.scans)
                                               : 0.0;
    if (unmatched > kManyUnmatched) {
        quality.warnings.push_back(
            {HITOS_TEXT("Advice",
                        "%1 of the scans fitted nothing that was seen before: the robot may have "
                        "been carried, or its laser blind; the map may be in pieces."),
             fmt::format("{:.0f} %", 100.0 * unmatched),
             {}});
    }
    if (figures.unmatched < figures.scans && figures.mean_score < kPoorScore) {
        quality.warnings.push_back(
            {HITOS_TEXT("Advice",
                        "The scans lie badly on each other (score %1 of 1): much moves here, or "
                        "the odometry and the laser do not belong together."),
             fmt::format("{:.2f}", figures.mean_score),
             {}});
    }
    const double length = length_of(run.best_trajectory());
    if (quality.loops == 0 && length > kLongWithoutLoop) {
        quality.warnings.push_back(
            {HITOS_TEXT("Advice",
                        "No loop was closed in %1: nothing shows whether the map is bent."),
             fmt::format("{:.0f} m", length),
             {}});
    }
}

}  // namespace

RunQuality judge(const Algoritmo& run) {
    RunQuality quality;
    measure_crispness(run, quality);
    if (const Registration* registration = run.registration()) {
        quality.registration = registration->figures();
        quality.loops = registration->loops().size();
        warn_of_registration(run, quality);
    }
    if (quality.cells_per_point > kBlurrier * quality.odometry_cells_per_point) {
        quality.warnings.push_back(
            {HITOS_TEXT("Advice",
                        "The map is less crisp than that of the odometry alone (%1 times the "
                        "cells per point): do not trust it."),
             fmt::format("{:.2f}", quality.cells_per_point / quality.odometry_cells_per_point),
             quality.registration ? std::string_view() : "recorded"});
    }
    return quality;
}

}  // namespace hitos
