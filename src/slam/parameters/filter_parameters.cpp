// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/slam/filter_parameters.hpp"

#include <fmt/format.h>

#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/slam/filters.hpp"
#include "hitos/slam/proposal.hpp"
#include "hitos/slam/resampler.hpp"
#include "hitos/slam/robot.hpp"
#include "parameter_tables.hpp"

namespace hitos {
namespace {

using namespace declare;
using Table = FilterTable;
using Filter = FilterParams;

Table filter_entries() {
    return {
        choice<&Filter::algorithm>(
            {"filter.algorithm", HITOS_TEXT("ParameterLabel", "Algorithm"),
             HITOS_TEXT("Parameter", "What builds the map of landmarks and the path."), "filter"},
            choices_of(slam_algorithms())),
        integer<&Filter::particles>(
            {"filter.particles", "", 1, 1e6, HITOS_TEXT("ParameterLabel", "Particles"),
             HITOS_TEXT("Parameter",
                        "Number of particles M; more of them follow more hypotheses, and time and "
                        "memory grow in proportion."),
             "filter", "M"}),
        choice<&Filter::proposal>(
            {"filter.proposal", HITOS_TEXT("ParameterLabel", "Proposal"),
             HITOS_TEXT("Parameter", "Where particles draw their new poses from.")},
            choices_of(proposals())),
    };
}

Table association_entries() {
    const auto method = choice<&Filter::association, &AssociationParams::method>(
        {"association.method", HITOS_TEXT("ParameterLabel", "Association"),
         HITOS_TEXT(
             "Parameter",
             "How an observation finds its landmark: ml takes the maximum likelihood, with p0 for "
             "a new landmark, and is gnn where an algorithm has no p0; gnn the nearest one inside "
             "a chi-square gate; jcbb pairs all observations of a scan together."),
         "observation"},
        {{"ml", HITOS_TEXT("ParameterChoice", "Maximum likelihood")},
         {"gnn", HITOS_TEXT("ParameterChoice", "Gated nearest neighbour")},
         {"jcbb", HITOS_TEXT("ParameterChoice", "Joint compatibility")}});
    return {
        method,
        real<&Filter::association, &AssociationParams::p0>(
            {"association.p0", "", 1e-30, 1000, HITOS_TEXT("ParameterLabel", "P0"),
             HITOS_TEXT("Parameter",
                        "Likelihood P0 of a new landmark; a higher value makes new landmarks more "
                        "readily."),
             "filter", "P0"}),
        // What has no p0 associates by gnn in the place of ml.
        real<&Filter::association, &AssociationParams::gate_probability>(
            {"association.gate_probability", "", 0.5, 0.999999,
             HITOS_TEXT("ParameterLabel", "Gate probability"),
             HITOS_TEXT(
                 "Parameter",
                 "Probability of the chi-square gate of gnn and jcbb; a higher value accepts "
                 "observations that lie further from their landmark."),
             "filter"},
            {{"association.method", "gnn, jcbb, or with an algorithm without p0",
              [](const Filter& f) {
                  return !slam_algorithms().reads(f.algorithm, "association.p0") ||
                         f.association.method != AssociationMethod::maximum_likelihood;
              }}}),
        real<&Filter::association, &AssociationParams::joint_probability>(
            {"association.joint_probability", "", 0.5, 0.999999,
             HITOS_TEXT("ParameterLabel", "Joint probability"),
             HITOS_TEXT(
                 "Parameter",
                 "Probability of the chi-square gate that all pairings of a scan pass together "
                 "with jcbb; a higher value pairs more observations that fit less well together.")},
            {where(method, {"jcbb"})}),
        real<&Filter::association, &AssociationParams::new_probability>(
            {"association.new_probability", "", 0.5, 0.999999999999,
             HITOS_TEXT("ParameterLabel", "New landmark gate"),
             HITOS_TEXT("Parameter",
                        "ekf-slam: probability of the chi-square gate outside which an observation "
                        "is a new landmark, and between the two gates nothing; a higher value "
                        "makes fewer new landmarks."),
             "filter"}),
        choice<&Filter::association, &AssociationParams::ambiguity>(
            {"association.ambiguity", HITOS_TEXT("ParameterLabel", "Ambiguous"),
             HITOS_TEXT("Parameter",
                        "What an observation that fits several landmarks, and is kept out of the "
                        "map, does to the weight: keep-likelihood multiplies it with the best "
                        "likelihood, neutral leaves it, new-landmark multiplies it with p0; off "
                        "updates the best landmark instead."),
             "observation"},
            {{"keep-likelihood", HITOS_TEXT("ParameterChoice", "Keep the likelihood")},
             {"neutral", HITOS_TEXT("ParameterChoice", "Neutral")},
             {"new-landmark", HITOS_TEXT("ParameterChoice", "As a new landmark")},
             {"off", HITOS_TEXT("ParameterChoice", "Off")}}),
        real<&Filter::association, &AssociationParams::ambiguity_ratio>(
            {"association.ambiguity_ratio", "", 0, 1,
             HITOS_TEXT("ParameterLabel", "Ambiguity ratio"),
             HITOS_TEXT("Parameter",
                        "Second best likelihood over the best from which an observation is "
                        "ambiguous, and from which two new ones of a scan are one landmark; a "
                        "higher value does both less often.")}),
    };
}

Table motion_entries() {
    return {
        choice<&Filter::motion, &MotionParams::model>(
            {"motion.model", HITOS_TEXT("ParameterLabel", "Model"),
             HITOS_TEXT("Parameter",
                        "How the robot moves between two scans, and how unsure that is."),
             "motion"},
            choices_of(motion_models())),
        choice<&Filter::motion, &MotionParams::unit>(
            {"motion.unit", HITOS_TEXT("ParameterLabel", "Noise given as"),
             HITOS_TEXT("Parameter",
                        "Whether sigma_x, sigma_y and sigma_theta are standard deviations or "
                        "variances; the thesis calls its numbers variances, but only as standard "
                        "deviations do they give its figures.")},
            {{"sigma", HITOS_TEXT("ParameterChoice", "Standard deviations")},
             {"variance", HITOS_TEXT("ParameterChoice", "Variances")}}),
        real<&Filter::motion, &MotionParams::sigma_x_m>(
            {"motion.sigma_x", "m or m^2", 0, 10, HITOS_TEXT("ParameterLabel", "σ x"),
             HITOS_TEXT(
                 "Parameter",
                 "Constant noise: standard deviation of the motion noise in x per step, or its "
                 "variance as motion.unit says; a higher value spreads the particles more."),
             "motion", "σ²x"}),
        real<&Filter::motion, &MotionParams::sigma_y_m>(
            {"motion.sigma_y", "m or m^2", 0, 10, HITOS_TEXT("ParameterLabel", "σ y"),
             HITOS_TEXT(
                 "Parameter",
                 "Constant noise: standard deviation of the motion noise in y per step, or its "
                 "variance as motion.unit says; a higher value spreads the particles more."),
             "motion", "σ²y"}),
        real<&Filter::motion, &MotionParams::sigma_theta_rad>(
            {"motion.sigma_theta", "rad or rad^2", 0, 10, HITOS_TEXT("ParameterLabel", "σ θ"),
             HITOS_TEXT("Parameter",
                        "Constant noise: standard deviation of the heading noise per step, or its "
                        "variance as motion.unit says; a higher value spreads the headings more."),
             "motion", "σ²θ"}),
        real<&Filter::motion, &MotionParams::var_along_m2_per_m>(
            {"motion.var_along", "m^2/m", 0, 10, HITOS_TEXT("ParameterLabel", "Var. along"),
             HITOS_TEXT("Parameter",
                        "Proportional noise: variance along the motion per metre; a higher value "
                        "trusts the measured distance less."),
             "motion"}),
        real<&Filter::motion, &MotionParams::var_across_m2_per_m>(
            {"motion.var_across", "m^2/m", 0, 10, HITOS_TEXT("ParameterLabel", "Var. across"),
             HITOS_TEXT("Parameter",
                        "Proportional noise: variance across the motion per metre; a higher value "
                        "allows more sideways slip."),
             "motion"}),
        real<&Filter::motion, &MotionParams::var_theta_rad2_per_rad>(
            {"motion.var_theta_per_rad", "rad^2/rad", 0, 10,
             HITOS_TEXT("ParameterLabel", "Var. θ per rad"),
             HITOS_TEXT("Parameter",
                        "Proportional noise: variance of the heading per radian turned; a higher "
                        "value trusts measured turns less."),
             "motion"}),
        real<&Filter::motion, &MotionParams::var_theta_rad2_per_m>(
            {"motion.var_theta_per_m", "rad^2/m", 0, 10,
             HITOS_TEXT("ParameterLabel", "Var. θ per m"),
             HITOS_TEXT("Parameter",
                        "Proportional noise: variance of the heading per metre driven; a higher "
                        "value allows more drift of the heading on straight ways."),
             "motion"}),
        real<&Filter::motion, &MotionParams::ratio_x>(
            {"motion.ratio_x", "m/m", 0, 10, HITOS_TEXT("ParameterLabel", "Ratio x"),
             HITOS_TEXT("Parameter",
                        "Noise of increments: standard deviation of the step ahead per metre of "
                        "it; a higher value trusts it less."),
             "motion"}),
        real<&Filter::motion, &MotionParams::ratio_y>(
            {"motion.ratio_y", "m/m", 0, 10, HITOS_TEXT("ParameterLabel", "Ratio y"),
             HITOS_TEXT("Parameter",
                        "Noise of increments: standard deviation of the step sideways per metre of "
                        "it; a higher value trusts it less."),
             "motion"}),
        real<&Filter::motion, &MotionParams::ratio_theta>(
            {"motion.ratio_theta", "rad/rad", 0, 10, HITOS_TEXT("ParameterLabel", "Ratio θ"),
             HITOS_TEXT("Parameter",
                        "Noise of increments: standard deviation of the turn per radian of it; a "
                        "higher value trusts it less."),
             "motion"}),
    };
}

Table observation_entries() {
    return {
        real<&Filter::observation, &ObservationParams::var_rho_m2>(
            {"observation.var_rho", "m^2", 1e-12, 1000, HITOS_TEXT("ParameterLabel", "σ² ρ"),
             HITOS_TEXT(
                 "Parameter",
                 "Variance sigma^2 of the observed rho of a line or range of a corner; a higher "
                 "value trusts the laser less and accepts greater differences from a landmark."),
             "observation", "σ²ρ"}),
        real<&Filter::observation, &ObservationParams::var_theta_rad2>(
            {"observation.var_theta", "rad^2", 1e-12, 10, HITOS_TEXT("ParameterLabel", "σ² θ"),
             HITOS_TEXT("Parameter",
                        "Variance sigma^2 of the observed theta of a line or bearing of a corner; "
                        "a higher value trusts the laser less and accepts greater differences from "
                        "a landmark."),
             "observation", "σ²θ"}),
    };
}

Table resampling_entries() {
    const auto rule = choice<&Filter::resampling, &ResamplingParams::rule>(
        {"resampling.rule", HITOS_TEXT("ParameterLabel", "Resampling"),
         HITOS_TEXT("Parameter",
                    "When particles are drawn anew: after every step that observed something, or "
                    "only where Neff has fallen below its threshold."),
         "filter"},
        {{"always", HITOS_TEXT("ParameterChoice", "Without threshold")},
         {"neff", HITOS_TEXT("ParameterChoice", "With Neff threshold")}});
    return {
        rule,
        real<&Filter::resampling, &ResamplingParams::neff_threshold>(
            {"resampling.neff_threshold", "particles", 0, 1e6,
             HITOS_TEXT("ParameterLabel", "Neff threshold"),
             HITOS_TEXT("Parameter",
                        "Effective number of particles Neff below which the rule neff resamples; a "
                        "higher value resamples more often."),
             "filter", "Neff"},
            {where(rule, {"neff"})}),
        choice<&Filter::resampling, &ResamplingParams::method>(
            {"resampling.method", HITOS_TEXT("ParameterLabel", "Resampling method"),
             HITOS_TEXT(
                 "Parameter",
                 "How particles are drawn anew; every method gives a particle as many copies in "
                 "the mean as its weight says, and they differ in how much chance adds.")},
            choices_of(resampling_methods())),
    };
}

/// An algorithm that takes its motion from registration reads no motion model.
void heed_registered(Table& table) {
    std::vector<std::string> others;
    for (const SlamAlgorithmEntry& entry : slam_algorithms().entries()) {
        if (!entry.registered) others.push_back(entry.word);
    }
    const auto chooser = std::ranges::find(table, "filter.algorithm", &ParameterFacts::key);
    for (Parameter<Filter>& parameter : table) {
        if (!parameter.key.starts_with("motion.")) continue;
        parameter.conditions.insert(parameter.conditions.begin(), where(*chooser, others));
    }
}

/// A number whose unit is "m or m^2" is read as motion.unit says.
void heed_motion_unit(Table& table) {
    for (Parameter<Filter>& parameter : table) {
        const std::size_t end = parameter.unit.find(" or ");
        if (end == std::string_view::npos) continue;
        parameter.unit_now = [unit = parameter.unit, end](const Filter& f) {
            return f.motion.unit == MotionUnit::variance ? unit.substr(end + 4)
                                                         : unit.substr(0, end);
        };
    }
}

Table make_table() {
    Table table = together({filter_entries(), association_entries(), bounded_association_entries(),
                            landmark_entries(), motion_entries(), registered_motion_entries(),
                            observation_entries(), resampling_entries()});
    heed_motion_unit(table);
    heed_readers(table, "filter.algorithm", slam_algorithms());
    heed_readers(table, "filter.proposal", proposals());
    heed_readers(table, "motion.model", motion_models());
    heed_readers(table, "resampling.method", resampling_methods());
    heed_registered(table);
    return table;
}

void check_motion(const MotionParams& motion) {
    if (!motion_models().find(motion.model).reads_odometry && motion.sigma_x_m == 0.0 &&
        motion.sigma_y_m == 0.0 && motion.sigma_theta_rad == 0.0) {
        throw ConfigError(
            "motion.model",
            HITOS_TEXT("Errors",
                       "%1 with motion.sigma_x, motion.sigma_y and motion.sigma_theta all "
                       "0 can never move; give at least one of them a value above 0"),
            motion.model);
    }
}

}  // namespace

std::span<const Parameter<FilterParams>> filter_parameters() {
    static const Table table = make_table();
    return table;
}

void check(const FilterParams& params) {
    check_all(filter_parameters(), params);
    check_motion(params.motion);
    const AssociationParams& association = params.association;
    if (slam_algorithms().reads(params.algorithm, "association.new_probability") &&
        association.new_probability < association.gate_probability) {
        throw ConfigError("association.new_probability",
                          HITOS_TEXT("Errors",
                                     "%1 is less than association.gate_probability %2; an "
                                     "observation inside that gate cannot be new"),
                          association.new_probability, association.gate_probability);
    }
}

}  // namespace hitos
