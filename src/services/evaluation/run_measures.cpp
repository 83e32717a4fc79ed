// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/evaluation/run_measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "calibration.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/services/evaluation/grid_blur.hpp"
#include "hitos/slam/slam_filter.hpp"

namespace hitos {
namespace {

using About = Measure::About;

constexpr double kDegrees = 180.0 / kPi;

/// The member of an error that there may be.
template <class Error>
std::optional<double> member(const std::optional<Error>& error, double Error::*of) {
    return error ? std::optional((*error).*of) : std::nullopt;
}

template <std::optional<RelativeError> RunErrors::*of>
std::optional<double> relative(const MeasuredRun& run) {
    const auto& error = run.errors.*of;
    return error ? std::optional(error->translation_m.rmse) : std::nullopt;
}
template <std::optional<RelativeError> RunErrors::*of>
std::optional<double> relative_turn(const MeasuredRun& run) {
    const auto& error = run.errors.*of;
    return error ? std::optional(error->rotation_rad.rmse * kDegrees) : std::nullopt;
}
template <ErrorFigures RelationErrors::*of>
std::optional<double> of_relations(const MeasuredRun& run) {
    const auto& errors = run.errors.relation_errors;
    return errors ? std::optional(((*errors).*of).mean) : std::nullopt;
}
std::optional<double> turn_of_relations(const MeasuredRun& run) {
    const auto mean = of_relations<&RelationErrors::rotation_rad>(run);
    return mean ? std::optional(*mean * kDegrees) : std::nullopt;
}

/// Errors of the way from pose to pose, which no frame changes.
std::vector<Measure> relative_measures() {
    std::vector<Measure> measures{
        {"rpe_1m_m", "RPE 1 m", About::path, "m", 3, "", &relative<&RunErrors::relative_error_1m>,
         "root mean square error of the path's every metre, against the true one's"},
        {"rpe_10m_m", "RPE 10 m", About::path, "m", 3, "",
         &relative<&RunErrors::relative_error_10m>, "the same of every ten metres",
         HITOS_TEXT("Measure", "relative error in 10 m")},
        {"rpe_1m_turn_deg", "turn in 1 m", About::path, "deg", 3, "",
         &relative_turn<&RunErrors::relative_error_1m>,
         "root mean square error of the turn in every metre"},
        {"rpe_10m_turn_deg", "turn in 10 m", About::path, "deg", 3, "",
         &relative_turn<&RunErrors::relative_error_10m>, "the same in every ten metres"},
        {"relations_m", "relations", About::path, "m", 3, "",
         &of_relations<&RelationErrors::translation_m>,
         "mean error of the way between the poses of the relations"},
        {"relations_turn_deg", "relations' turn", About::path, "deg", 3, "", &turn_of_relations,
         "mean error of the turn between them"}};
    for (Measure& measure : measures) {
        measure.rare = true;
        measure.detail = measure.word.starts_with("rpe_1m") || measure.word.ends_with("turn_deg");
    }
    return measures;
}

/// Shares of the truth in the regions, first of the pose, then of the landmarks.
template <Coverage Calibration::*of, std::size_t region>
std::optional<double> inside(const MeasuredRun& run) {
    if (run.calibration == nullptr || (run.calibration->*of).count() == 0) return std::nullopt;
    return (run.calibration->*of).inside(region);
}
template <Coverage Calibration::*of>
std::optional<double> nees(const MeasuredRun& run) {
    if (run.calibration == nullptr || (run.calibration->*of).count() == 0) return std::nullopt;
    return (run.calibration->*of).mean();
}
template <Coverage Calibration::*of>
std::vector<Measure> calibration_measures(const std::string& label, const char* plot) {
    const std::string share = "share of the true " + label + "s in the filter's region of ";
    std::vector<Measure> measures{
        {label + "_in_95", label + " in 95 %", About::path, "", 3, "", &inside<of, 2>,
         share + "95 %", plot},
        {label + "_nees", label + " NEES", About::path, "", 2, "", &nees<of>,
         "mean of the " + label + "'s squared error in units of its covariance"},
        {label + "_in_50", label + " in 50 %", About::path, "", 3, "", &inside<of, 0>,
         share + "50 %"},
        {label + "_in_68", label + " in 68 %", About::path, "", 3, "", &inside<of, 1>,
         share + "68 %"},
        {label + "_in_99", label + " in 99 %", About::path, "", 3, "", &inside<of, 3>,
         share + "99 %"}};
    for (Measure& measure : measures) {
        measure.detail = !measure.word.ends_with("95");
        measure.rare = true;
        for (const double region : kRegions) {
            if (measure.word.ends_with(fmt::format("_{:.0f}", 100.0 * region)))
                measure.target = region;
        }
        if (!measure.target) measure.target = (Calibration().*of).degrees();
    }
    return measures;
}

std::vector<Measure> all_measures() {
    using Run = const MeasuredRun&;
    using Figure = std::optional<double>;
    std::vector<Measure> measures{
        {"error_m", "error", About::map, "m", 3, "/map_error/mean_m",
         [](Run run) { return member(run.errors.map_error, &MapError::mean_m); },
         "mean distance of landmarks to the nearest of the reference map",
         HITOS_TEXT("Measure", "map error"), true, "map_error_m", "map error"},
        {"aligned_error_m", "aligned error", About::map, "m", 3, "/map_error_aligned/mean_m",
         [](Run run) {
             const auto& aligned = run.errors.aligned_map_error;
             return aligned ? Figure(aligned->error.mean_m) : Figure();
         },
         "the same after the best rigid motion of the map", "", false, "map_error_aligned_m",
         "aligned map error", "aligned"},
        {"trajectory_error_m", "ATE", About::path, "m", 3, "/trajectory_error/ate_rmse_m",
         [](Run run) { return member(run.errors.trajectory_error, &TrajectoryError::rmse_m); },
         "root mean square distance of the path to the true one, after alignment",
         HITOS_TEXT("Measure", "trajectory error"), false, "ate_rmse_m"},
        {"online_ate_rmse_m", "ATE while driving", About::path, "m", 3, "/online_error/ate_rmse_m"},
        {"odometry_error_m", "odometry's ATE", About::path, "m", 3, "/odometry_error/ate_rmse_m",
         [](Run run) { return member(run.errors.odometry_error, &TrajectoryError::rmse_m); },
         "the same of the path by odometry alone", "", false, "odometry_ate_rmse_m"},
        {"common_poses", "poses compared", About::path, "", 0, "/trajectory_error/poses"},
        {"blur_m2", "blur", About::grid, "m^2", 2, "",
         [](Run run) { return run.grid != nullptr ? grid_blur_m2(*run.grid) : Figure(); },
         "area that the grid map leaves undecided; lower is crisper",
         HITOS_TEXT("Measure", "blur of the grid map")},
        {"cells_per_point", "cells per point", About::grid, "", 4, "/quality/cells_per_point"},
        {"scans", "scans", About::count, "", 0, "/scans"},
        {"landmarks", "landmarks", About::count, "", 0, "",
         [](Run run) {
             return Figure(run.filter.best_count(FeatureKind::line) +
                           run.filter.best_count(FeatureKind::corner));
         },
         "landmarks of the map", HITOS_TEXT("Measure", "landmarks")},
        {"lines", "lines", About::count, "", 0, "/landmarks/lines",
         [](Run run) { return Figure(run.filter.best_count(FeatureKind::line)); },
         "lines among them"},
        {"corners", "corners", About::count, "", 0, "/landmarks/corners",
         [](Run run) { return Figure(run.filter.best_count(FeatureKind::corner)); },
         "corners among them"},
        {"loops_closed", "loops", About::course, "", 0, "/quality/loops_closed",
         [](Run run) {
             if (run.loops == nullptr) return Figure();
             return Figure(std::ranges::count_if(*run.loops, &RunLoop::closed));
         },
         "loops that registration closed"},
        {"loops_false", "false loops", About::course, "", 0, "/quality/loops_false",
         [](Run run) {
             const auto precision =
                 run.loops == nullptr ? LoopPrecision{} : precision_of(*run.loops);
             return precision.judged > 0 ? Figure(precision.wrong) : Figure();
         },
         "of these the ones that the true path contradicts"},
        {"run_seconds", "time", About::course, "s", 2, "/run_seconds"}};
    for (Measure& measure : measures)
        if (measure.word.starts_with("loops_")) measure.rare = true;
    for (auto& more :
         {relative_measures(),
          calibration_measures<&Calibration::pose>(
              "pose", HITOS_TEXT("Measure", "true poses in the region of 95 %")),
          calibration_measures<&Calibration::landmarks>(
              "landmark", HITOS_TEXT("Measure", "true landmarks in the region of 95 %")),
          calibration_measures<&Calibration::distances>(
              "distance", HITOS_TEXT("Measure", "true distances in the region of 95 %"))}) {
        measures.insert(measures.end(), more.begin(), more.end());
    }
    return measures;
}

/// What tables, records and Python's arrays say beside the figures.
constexpr std::string_view kOtherWords =
    "cell,cpu_seconds,duplicate_scans,failed,finished,first_damage,log,map,measured,ok,picture,"
    "problem,reference_found,reference_landmarks,run,runs,scans,seconds,seed,skipped_lines,"
    "stamps_backwards,status,values";

/// As words for programs end in it.
std::string ending_of(const std::string& unit) {
    return unit.empty() ? unit : "_" + plain_unit(unit);
}

}  // namespace

void MeasureRegistry::add(Measure measure) {
    // Python says them without their units; what is not taken of every run stands in no table.
    const std::string stem = measure.stem();
    const std::vector<std::string_view> others = input::listed(kOtherWords);
    const bool said =
        std::ranges::count(others, measure.word) + std::ranges::count(others, stem) > 0 ||
        std::ranges::count(all_measures(), stem, &Measure::stem) > 0;
    if (measure.take != nullptr && said) {
        throw ConfigError(
            "measures",
            HITOS_TEXT("Errors",
                       "found a figure of a run of the word \"%1\", but tables, records or Python "
                       "say \"%2\" of something else; give it another word"),
            measure.word, stem);
    }
    Registry::add(std::move(measure));
}

MeasureRegistry& run_measures() {
    static MeasureRegistry registry("figure of a run", "measures", all_measures());
    return registry;
}

std::vector<const Measure*> taken_measures() {
    std::vector<const Measure*> taken;
    for (const Measure& measure : run_measures().entries()) {
        if (measure.take != nullptr) taken.push_back(&measure);
    }
    return taken;
}

RunFigures figures_of(const MeasuredRun& run) {
    RunFigures figures;
    for (const Measure* measure : taken_measures()) {
        const std::optional<double> figure = measure->take(run);
        if (figure && std::isfinite(*figure)) figures[*measure] = figure;
    }
    return figures;
}

std::string printed_unit(std::string unit) {
    const std::size_t square = unit.find("^2");
    return square == std::string::npos ? unit : unit.replace(square, 2, "²");
}

std::string plain_unit(std::string unit) {
    std::erase(unit, '^');
    return unit;
}

std::string squared_unit(const std::string& unit) {
    if (unit.empty()) return unit;
    return unit.ends_with("^2") ? unit.substr(0, unit.size() - 1) + '4' : unit + "^2";
}

std::string Measure::stem() const {
    const std::string ending = ending_of(unit);
    return word.ends_with(ending) ? word.substr(0, word.size() - ending.size()) : word;
}

std::string Measure::word_of(std::string_view statistic, bool squared) const {
    return fmt::format("{}_{}{}", stem(), statistic,
                       ending_of(squared ? squared_unit(unit) : unit));
}

std::string Measure::rounded(double value, bool of_several) const {
    return fmt::format("{:.{}f}", value, decimals + (of_several && is_count() ? 1 : 0));
}

}  // namespace hitos
