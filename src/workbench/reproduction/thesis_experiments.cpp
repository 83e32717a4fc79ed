#include "hitos/workbench/thesis_experiments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "experiment_lists.hpp"
#include "experiment_remarks.hpp"
#include "hitos/workbench/presets.hpp"
#include "hitos/workbench/thesis_figures.hpp"

namespace hitos {
namespace {

using namespace experiments;

/// The numbers that a table of fixed parameters has. The robot's are standard deviations
/// (docs/reproduction.md), the observation's variances.
struct Fixed {
    int particles = 100;
    int points = 15;
    double dmax = 0.02;
    double length = 0.6;
    double sigma_xy = 0.01;
    double sigma_theta = 0.008;
    double var_rho = 0.04;
    double var_theta = 0.00122;
};

Settings settings(const Fixed& fixed) {
    return {"motion.model=odometry",
            "resampling.rule=always",
            "association.p0=0.005",
            fmt::format("filter.particles={}", fixed.particles),
            fmt::format("split_merge.min_points={}", fixed.points),
            fmt::format("split_merge.dmax={}", fixed.dmax),
            fmt::format("split_merge.min_length={}", fixed.length),
            fmt::format("motion.sigma_x={}", fixed.sigma_xy),
            fmt::format("motion.sigma_y={}", fixed.sigma_xy),
            fmt::format("motion.sigma_theta={}", fixed.sigma_theta),
            fmt::format("observation.var_rho={}", fixed.var_rho),
            fmt::format("observation.var_theta={}", fixed.var_theta)};
}

/// A pair of figures: SLAM's map and the odometry's.
ThesisExperiment pair(const char* figure, const char* parameter, const char* world,
                      const char* value) {
    const ThesisTable& table = find_thesis_table(parameter);
    return {figure,
            parameter,
            std::string(table.key),
            std::string(table.table),
            Place::world,
            world,
            Show::maps,
            1,
            {table.settings.begin(), table.settings.end()},
            {{value, "the map is true to the place, the odometry's is not"}},
            ""};
}

void add_pairs(std::vector<ThesisExperiment>& all) {
    const std::array worlds{"recinto", "lineamedia", "bigloop", "bigloop2", "complex"};
    const std::array dmax{"10.12", "10.15", "10.18", "10.21", "10.24"};
    const std::array length{"10.29", "10.32", "10.35", "10.38", "10.41"};
    const std::array points{"10.45", "10.48", "10.51", "10.54", "10.57"};
    const std::array particles{"10.86", "10.88", "10.90", "10.92", "10.94"};
    // The caption of figure 10.94 says 20 particles, its text 150.
    const std::array count{"50", "100", "100", "100", "150"};
    for (std::size_t i = 0; i < worlds.size(); ++i) {
        all.push_back(pair(dmax.at(i), "dmax", worlds.at(i), "0.02"));
        all.push_back(pair(length.at(i), "mlon", worlds.at(i), "1"));
        all.push_back(pair(points.at(i), "mpuntos", worlds.at(i), "15"));
        all.push_back(pair(particles.at(i), "p", worlds.at(i), count.at(i)));
    }
}

void add_lines(std::vector<ThesisExperiment>& all) {
    add_maps(all, "10.25", "dmax", kDmax, "10.3", "usc-sal",
             settings({.particles = 50, .length = 1.5}),
             {{"0.001", "no feature is found, and SLAM is impossible"},
              {"0.01", "nearer to the truth than below"},
              {"0.02", "nearer still"},
              {"0.03", "the best map"},
              {"0.05", "many noisy landmarks do harm"},
              {"0.1", "many noisy landmarks do harm"}},
             remarks::kDmaxHall);
    add_maps(all, "10.42", "mlon", kLength, "10.5", "iusiani", settings({.sigma_xy = 0.005}),
             {{"0.1", "very many lines, most of them noise"},
              {"0.3", "very many lines, most of them noise"},
              {"0.6", "the truest map, with a moderate number of lines"},
              {"1", "too few landmarks: SLAM fails"}},
             remarks::kLengthLaboratory);
    add_maps(all, "10.58", "mpuntos", kPoints, "10.7", "iusiani",
             settings({.particles = 50, .sigma_xy = 0.005}),
             {{"3", "no end of lines"},
              {"17", "the lines are those of the place"},
              {"40", "very few lines and a wrong map"}},
             remarks::kPointsLaboratory);
    const Claims same_rho{{"0.001", "no influence on error and number"},
                          {"0.01", "no influence"},
                          {"0.03", "no influence"},
                          {"0.05", "no influence"},
                          {"0.5", "no influence within reason"},
                          {"1", "no influence within reason"}};
    const Claims same_theta{{"0.001", "no influence on error and number"},
                            {"0.01", "no influence"},
                            {"0.03", "no influence"},
                            {"0.07", "no influence"},
                            {"0.2", "no influence within reason"},
                            {"0.5", "no influence within reason"}};
    const Settings big = settings({.points = 9, .length = 0.4, .sigma_xy = 0.007});
    add_counts(all, 5, "10.60", "col_rho", kColRho, "10.8", "bigloop2",
               with(big, {"split_merge.collinear_theta=0.07"}), same_rho,
               remarks::kCollinearBigloop2);
    add_counts(all, 5, "10.60", "col_theta", kColTheta, "10.8", "bigloop2",
               with(big, {"split_merge.collinear_rho=0.1"}), same_theta, "");
    const Settings hall = settings({.particles = 50});
    add_counts(all, 1, "10.61", "col_rho", kColRho, "10.9", "usc-sal",
               with(hall, {"split_merge.collinear_theta=0.07"}),
               {{"0.001", "a right map, the usual lines, too many corners"},
                {"0.01", "too many corners"},
                {"0.03", "too many corners"},
                {"0.05", "the number of corners settles from here on"},
                {"0.5", "as at 0.05"},
                {"1", "as at 0.05, though such lines should not be merged"}},
               remarks::kCollinearHall);
    add_counts(all, 1, "10.61", "col_theta", kColTheta, "10.9", "usc-sal",
               with(hall, {"split_merge.collinear_rho=0.1"}),
               {{"0.001", ""}, {"0.01", ""}, {"0.03", ""}, {"0.07", ""}, {"0.2", ""}, {"0.5", ""}},
               "");
}

void add_motion(std::vector<ThesisExperiment>& all) {
    add_maps(all, "10.65/10.66/10.67", "mov_theta", kSigmaTheta, "10.11", "usc-sal",
             settings({.particles = 50, .length = 1.0, .sigma_xy = 0.007}),
             {{"0.0001", "far from the truth"},
              {"0.001", "far from the truth"},
              {"0.003", "nearer"},
              {"0.005", "nearer"},
              {"0.008", "the loop closes"},
              {"0.03", "diverges again"},
              {"0.08", "diverges again"},
              {"0.2", "diverges again"}},
             remarks::kAngularNoise);
    add_maps(
        all, "10.68", "p", kParticles, "10.11", "usc-sal",
        settings({.length = 1.0, .sigma_xy = 0.007, .sigma_theta = 0.03}),
        {{"50", "with this much noise the map is wrong"}, {"100", "more particles make up for it"}},
        "");
    add_maps(all, "10.69/10.70", "mov_pos", kSigmaXy, "10.11", "usc-sal",
             settings({.particles = 50, .length = 1.0}),
             {{"0.0001/0.0001", "the loop stays open, the shape is there"},
              {"0.001/0.001", "the loop stays open, the shape is there"},
              {"0.003/0.003", "fit for navigation"},
              {"0.005/0.005", "fit for navigation"},
              {"0.008/0.008", "fit for navigation"},
              {"0.02/0.02", "diverges altogether"}},
             remarks::kPositionNoise);
}

void add_observation(std::vector<ThesisExperiment>& all) {
    const Settings laboratory = settings({.sigma_xy = 0.005});
    add_maps(all, "10.75", "sensor_rho", kVarRho, "10.12", "bigloop2",
             settings({.points = 9, .length = 0.4, .sigma_xy = 0.007, .var_theta = 0.0008}),
             {{"0.01", "the map is true to the place, the odometry's is not"}}, "");
    add_maps(all, "10.76", "sensor_rho", kVarRho, "10.13", "iusiani",
             with(laboratory, {"observation.var_theta=0.001224"}),
             {{"0.0001", "a right map, too many landmarks"},
              {"0.001", "a right map, too many landmarks"},
              {"0.01", "a right map and number"},
              {"0.1", "right, but some lines near each other become one"},
              {"1", "wrong associations begin to spoil the map"}},
             remarks::kRhoLaboratory);
    add_maps(all, "10.77", "sensor_theta", kVarTheta, "10.13", "iusiani",
             with(laboratory, {"observation.var_rho=0.001"}),
             {{"0.0001", "a wrong map and too many landmarks"},
              {"0.0008", "a wrong map and too many landmarks"},
              {"0.001224", "right, and the least noisy"},
              {"0.014", "right"},
              {"0.2", "wrong associations, a wrong map"},
              {"0.5", "wrong associations, a wrong map"}},
             remarks::kThetaLaboratory);
    add_maps(all, "10.78", "sensor_theta", kVarTheta, "10.13", "iusiani",
             with(laboratory, {"observation.var_rho=0.01"}),
             {{"0.003", "the map is true to the place, the odometry's looks like chance"}}, "");
}

void add_filter(std::vector<ThesisExperiment>& all) {
    const Settings below{"resampling.rule=neff"};
    add_maps(all, "10.80", "neff", kNeff, "10.14", "usc-sal",
             with(settings({.sigma_xy = 0.007}), below),
             {{"2", "hardly another map (10.6.1 ends with: somewhat worse)"},
              {"20", "no difference"},
              {"80", "no difference"},
              {"100", "no difference"}},
             remarks::kNeffHall);
    add_maps(all, "10.82", "neff", kNeff, "10.15", "iusiani",
             with(settings({.points = 30, .length = 1.8, .sigma_xy = 0.001}), below),
             {{"100", "a right map"},
              {"80", "a right map"},
              {"40", "a right map"},
              {"2", "a right map"}},
             remarks::kNeffLaboratory);
    const std::array<std::pair<const char*, const char*>, 5> steady{
        {{"recinto", "error 0.14 m"},
         {"lineamedia", "error 0.13 m"},
         {"bigloop", "error 0.11 m"},
         {"bigloop2", "error 0.12 m"},
         {"complex", "error 0.28 m: its corridor of 40 m leaves x open"}}};
    const Settings table = settings({.points = 9, .length = 0.4});
    for (const auto& [world, says] : steady) {
        add_counts(all, 5, "10.95", "p", kParticles, "10.17", world, table, {{"100", says}}, "");
    }
    add_maps(all, "10.96", "p", kParticles, "10.18", "usc-sal",
             settings({.sigma_xy = 0.001, .sigma_theta = 0.0008}),
             {{"5", "much like the truth"},
              {"50", "the right map"},
              {"100", "no better than 50"},
              {"200", "no better than 50"}},
             remarks::kParticlesHall);
}

}  // namespace

std::string ThesisExperiment::stem() const {
    return fmt::format("{}-{}-{}", figure.substr(0, figure.find('/')), name, parameter);
}

bool ThesisExperiment::is_named(std::string_view word) const {
    if (word == name || word == parameter || word == stem()) return true;
    std::string_view rest = figure;
    for (;;) {
        const std::size_t slash = rest.find('/');
        if (word == rest.substr(0, slash)) return true;
        if (slash == std::string_view::npos) return false;
        rest.remove_prefix(slash + 1);
    }
}

std::span<const ThesisExperiment> thesis_experiments() {
    static const std::vector<ThesisExperiment> all = [] {
        std::vector<ThesisExperiment> list;
        add_pairs(list);
        add_lines(list);
        add_motion(list);
        add_observation(list);
        add_filter(list);
        const auto number = [](const ThesisExperiment& experiment) {
            return std::stod(experiment.figure.substr(3));  // behind "10."
        };
        std::ranges::stable_sort(list, {}, number);
        add_recorded(list);
        return list;
    }();
    return all;
}

Configuracion experiment_configuration(const ThesisExperiment& experiment) {
    Configuracion configuration;
    if (experiment.place == Place::log) {
        configuration = preset_configuration("recorded-fastslam1");
    }
    for (const std::string& setting : experiment.settings) set_parameter(configuration, setting);
    return configuration;
}

}  // namespace hitos
