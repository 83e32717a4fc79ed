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

void add_filter(Table& table) {
    table.push_back(choice<&Filter::algorithm>(
        {.key = "filter.algorithm",
         .description = HITOS_TEXT("Parameter", "What builds the map of landmarks and the path."),
         .label = HITOS_TEXT("ParameterLabel", "Algorithm"),
         .card = "filter",
         .choices = choices_of(slam_algorithms())}));
    table.push_back(integer<&Filter::particles>(
        {.key = "filter.particles",
         .minimum = 1.0,
         .maximum = 1e6,
         .description = HITOS_TEXT("Parameter",
                                   "Number of particles M; more of them follow more hypotheses, "
                                   "and time and memory grow in proportion."),
         .label = HITOS_TEXT("ParameterLabel", "Particles"),
         .symbol = "M",
         .card = "filter"}));
    table.push_back(choice<&Filter::proposal>(
        {.key = "filter.proposal",
         .description = HITOS_TEXT("Parameter", "Where particles draw their new poses from."),
         .label = HITOS_TEXT("ParameterLabel", "Proposal"),
         .choices = choices_of(proposals())}));
}

void add_association(Table& table) {
    const auto method = choice<&Filter::association, &AssociationParams::method>(
        {.key = "association.method",
         .description = HITOS_TEXT(
             "Parameter",
             "How an observation finds its landmark: ml takes the maximum likelihood, with p0 for "
             "a new landmark, and is gnn where an algorithm has no p0; gnn the nearest one inside "
             "a chi-square gate; jcbb pairs all observations of a scan together."),
         .label = HITOS_TEXT("ParameterLabel", "Association"),
         .card = "observation",
         .choices = {{"ml", HITOS_TEXT("ParameterChoice", "Maximum likelihood")},
                     {"gnn", HITOS_TEXT("ParameterChoice", "Gated nearest neighbour")},
                     {"jcbb", HITOS_TEXT("ParameterChoice", "Joint compatibility")}}});
    table.push_back(method);
    table.push_back(real<&Filter::association, &AssociationParams::p0>(
        {.key = "association.p0",
         .minimum = 1e-30,
         .maximum = 1000.0,
         .description = HITOS_TEXT(
             "Parameter",
             "Likelihood P0 of a new landmark; a higher value makes new landmarks more readily."),
         .label = HITOS_TEXT("ParameterLabel", "P0"),
         .symbol = "P0",
         .card = "filter"}));
    auto gate = real<&Filter::association, &AssociationParams::gate_probability>(
        {.key = "association.gate_probability",
         .minimum = 0.5,
         .maximum = 0.999999,
         .description =
             HITOS_TEXT("Parameter",
                        "Probability of the chi-square gate of gnn and jcbb; a higher value "
                        "accepts observations that lie further from their landmark."),
         .label = HITOS_TEXT("ParameterLabel", "Gate probability"),
         .card = "filter"});
    // What has no p0 associates by gnn in the place of ml.
    gate.conditions.push_back(
        {"association.method", "gnn, jcbb, or with an algorithm without p0", [](const Filter& f) {
             return !slam_algorithms().reads(f.algorithm, "association.p0") ||
                    f.association.method != AssociationMethod::maximum_likelihood;
         }});
    table.push_back(std::move(gate));
    table.push_back(used(
        real<&Filter::association, &AssociationParams::joint_probability>(
            {.key = "association.joint_probability",
             .minimum = 0.5,
             .maximum = 0.999999,
             .description = HITOS_TEXT(
                 "Parameter",
                 "Probability of the chi-square gate that all pairings of a scan pass together "
                 "with jcbb; a higher value pairs more observations that fit less well together."),
             .label = HITOS_TEXT("ParameterLabel", "Joint probability")}),
        {where(method, {"jcbb"})}));
    table.push_back(real<&Filter::association, &AssociationParams::new_probability>(
        {.key = "association.new_probability",
         .minimum = 0.5,
         .maximum = 0.999999999999,
         .description = HITOS_TEXT("Parameter",
                                   "ekf-slam: probability of the chi-square gate outside which an "
                                   "observation is a new landmark, and between the two gates "
                                   "nothing; a higher value makes fewer new landmarks."),
         .label = HITOS_TEXT("ParameterLabel", "New landmark gate"),
         .card = "filter"}));
    table.push_back(choice<&Filter::association, &AssociationParams::ambiguity>(
        {.key = "association.ambiguity",
         .description = HITOS_TEXT(
             "Parameter",
             "What an observation that fits several landmarks, and is kept out of the map, does to "
             "the weight: keep-likelihood multiplies it with the best likelihood, neutral leaves "
             "it, new-landmark multiplies it with p0; off updates the best landmark instead."),
         .label = HITOS_TEXT("ParameterLabel", "Ambiguous"),
         .card = "observation",
         .choices = {{"keep-likelihood", HITOS_TEXT("ParameterChoice", "Keep the likelihood")},
                     {"neutral", HITOS_TEXT("ParameterChoice", "Neutral")},
                     {"new-landmark", HITOS_TEXT("ParameterChoice", "As a new landmark")},
                     {"off", HITOS_TEXT("ParameterChoice", "Off")}}}));
    table.push_back(real<&Filter::association, &AssociationParams::ambiguity_ratio>(
        {.key = "association.ambiguity_ratio",
         .minimum = 0.0,
         .maximum = 1.0,
         .description = HITOS_TEXT("Parameter",
                                   "Second best likelihood over the best from which an observation "
                                   "is ambiguous, and from which two new ones of a scan are one "
                                   "landmark; a higher value does both less often."),
         .label = HITOS_TEXT("ParameterLabel", "Ambiguity ratio")}));
    add_bounded_association(table);
    add_landmarks(table);
}

/// A number of constant noise, which motion.unit says how to read.
Parameter<Filter> of_constant_noise(Parameter<Filter> parameter, std::string_view sigma,
                                    std::string_view variance) {
    parameter.unit_now = [sigma, variance](const Filter& f) {
        return f.motion.unit == MotionUnit::variance ? variance : sigma;
    };
    return parameter;
}

void add_motion(Table& table) {
    table.push_back(choice<&Filter::motion, &MotionParams::model>(
        {.key = "motion.model",
         .description = HITOS_TEXT(
             "Parameter", "How the robot moves between two scans, and how unsure that is."),
         .label = HITOS_TEXT("ParameterLabel", "Model"),
         .card = "motion",
         .choices = choices_of(motion_models())}));
    table.push_back(choice<&Filter::motion, &MotionParams::unit>(
        {.key = "motion.unit",
         .description =
             HITOS_TEXT("Parameter",
                        "Whether sigma_x, sigma_y and sigma_theta are standard deviations or "
                        "variances; the thesis calls its numbers variances, but only as standard "
                        "deviations do they give its figures."),
         .label = HITOS_TEXT("ParameterLabel", "Noise given as"),
         .choices = {{"sigma", HITOS_TEXT("ParameterChoice", "Standard deviations")},
                     {"variance", HITOS_TEXT("ParameterChoice", "Variances")}}}));
    table.push_back(of_constant_noise(
        real<&Filter::motion, &MotionParams::sigma_x_m>(
            {.key = "motion.sigma_x",
             .unit = "m or m^2",
             .minimum = 0.0,
             .maximum = 10.0,
             .description = HITOS_TEXT(
                 "Parameter",
                 "Constant noise: standard deviation of the motion noise in x per step, or its "
                 "variance as motion.unit says; a higher value spreads the particles more."),
             .label = HITOS_TEXT("ParameterLabel", "σ x"),
             .symbol = "σ²x",
             .card = "motion"}),
        "m", "m^2"));
    table.push_back(of_constant_noise(
        real<&Filter::motion, &MotionParams::sigma_y_m>(
            {.key = "motion.sigma_y",
             .unit = "m or m^2",
             .minimum = 0.0,
             .maximum = 10.0,
             .description = HITOS_TEXT(
                 "Parameter",
                 "Constant noise: standard deviation of the motion noise in y per step, or its "
                 "variance as motion.unit says; a higher value spreads the particles more."),
             .label = HITOS_TEXT("ParameterLabel", "σ y"),
             .symbol = "σ²y",
             .card = "motion"}),
        "m", "m^2"));
    table.push_back(of_constant_noise(
        real<&Filter::motion, &MotionParams::sigma_theta_rad>(
            {.key = "motion.sigma_theta",
             .unit = "rad or rad^2",
             .minimum = 0.0,
             .maximum = 10.0,
             .description = HITOS_TEXT(
                 "Parameter",
                 "Constant noise: standard deviation of the heading noise per step, or its "
                 "variance as motion.unit says; a higher value spreads the headings more."),
             .label = HITOS_TEXT("ParameterLabel", "σ θ"),
             .symbol = "σ²θ",
             .card = "motion"}),
        "rad", "rad^2"));
    table.push_back(real<&Filter::motion, &MotionParams::var_along_m2_per_m>(
        {.key = "motion.var_along",
         .unit = "m^2/m",
         .minimum = 0.0,
         .maximum = 10.0,
         .description = HITOS_TEXT("Parameter",
                                   "Proportional noise: variance along the motion per metre; a "
                                   "higher value trusts the measured distance less."),
         .label = HITOS_TEXT("ParameterLabel", "Var. along"),
         .card = "motion"}));
    table.push_back(real<&Filter::motion, &MotionParams::var_across_m2_per_m>(
        {.key = "motion.var_across",
         .unit = "m^2/m",
         .minimum = 0.0,
         .maximum = 10.0,
         .description = HITOS_TEXT("Parameter",
                                   "Proportional noise: variance across the motion per metre; a "
                                   "higher value allows more sideways slip."),
         .label = HITOS_TEXT("ParameterLabel", "Var. across"),
         .card = "motion"}));
    table.push_back(real<&Filter::motion, &MotionParams::var_theta_rad2_per_rad>(
        {.key = "motion.var_theta_per_rad",
         .unit = "rad^2/rad",
         .minimum = 0.0,
         .maximum = 10.0,
         .description = HITOS_TEXT("Parameter",
                                   "Proportional noise: variance of the heading per radian turned; "
                                   "a higher value trusts measured turns less."),
         .label = HITOS_TEXT("ParameterLabel", "Var. θ per rad"),
         .card = "motion"}));
    table.push_back(real<&Filter::motion, &MotionParams::var_theta_rad2_per_m>(
        {.key = "motion.var_theta_per_m",
         .unit = "rad^2/m",
         .minimum = 0.0,
         .maximum = 10.0,
         .description =
             HITOS_TEXT("Parameter",
                        "Proportional noise: variance of the heading per metre driven; a higher "
                        "value allows more drift of the heading on straight ways."),
         .label = HITOS_TEXT("ParameterLabel", "Var. θ per m"),
         .card = "motion"}));
    table.push_back(real<&Filter::motion, &MotionParams::ratio_x>(
        {.key = "motion.ratio_x",
         .unit = "m/m",
         .minimum = 0.0,
         .maximum = 10.0,
         .description = HITOS_TEXT("Parameter",
                                   "Noise of increments: standard deviation of the step ahead per "
                                   "metre of it; a higher value trusts it less."),
         .label = HITOS_TEXT("ParameterLabel", "Ratio x"),
         .card = "motion"}));
    table.push_back(real<&Filter::motion, &MotionParams::ratio_y>(
        {.key = "motion.ratio_y",
         .unit = "m/m",
         .minimum = 0.0,
         .maximum = 10.0,
         .description = HITOS_TEXT("Parameter",
                                   "Noise of increments: standard deviation of the step sideways "
                                   "per metre of it; a higher value trusts it less."),
         .label = HITOS_TEXT("ParameterLabel", "Ratio y"),
         .card = "motion"}));
    table.push_back(real<&Filter::motion, &MotionParams::ratio_theta>(
        {.key = "motion.ratio_theta",
         .unit = "rad/rad",
         .minimum = 0.0,
         .maximum = 10.0,
         .description = HITOS_TEXT("Parameter",
                                   "Noise of increments: standard deviation of the turn per radian "
                                   "of it; a higher value trusts it less."),
         .label = HITOS_TEXT("ParameterLabel", "Ratio θ"),
         .card = "motion"}));
    add_registered_motion(table);
}

void add_observation(Table& table) {
    table.push_back(real<&Filter::observation, &ObservationParams::var_rho_m2>(
        {.key = "observation.var_rho",
         .unit = "m^2",
         .minimum = 1e-12,
         .maximum = 1000.0,
         .description = HITOS_TEXT(
             "Parameter",
             "Variance sigma^2 of the observed rho of a line or range of a corner; a higher value "
             "trusts the laser less and accepts greater differences from a landmark."),
         .label = HITOS_TEXT("ParameterLabel", "σ² ρ"),
         .symbol = "σ²ρ",
         .card = "observation"}));
    table.push_back(real<&Filter::observation, &ObservationParams::var_theta_rad2>(
        {.key = "observation.var_theta",
         .unit = "rad^2",
         .minimum = 1e-12,
         .maximum = 10.0,
         .description = HITOS_TEXT(
             "Parameter",
             "Variance sigma^2 of the observed theta of a line or bearing of a corner; a higher "
             "value trusts the laser less and accepts greater differences from a landmark."),
         .label = HITOS_TEXT("ParameterLabel", "σ² θ"),
         .symbol = "σ²θ",
         .card = "observation"}));
}

void add_resampling(Table& table) {
    const auto rule = choice<&Filter::resampling, &ResamplingParams::rule>(
        {.key = "resampling.rule",
         .description = HITOS_TEXT("Parameter",
                                   "When particles are drawn anew: after every step that observed "
                                   "something, or only where Neff has fallen below its threshold."),
         .label = HITOS_TEXT("ParameterLabel", "Resampling"),
         .card = "filter",
         .choices = {{"always", HITOS_TEXT("ParameterChoice", "Without threshold")},
                     {"neff", HITOS_TEXT("ParameterChoice", "Neff threshold")}}});
    table.push_back(rule);
    table.push_back(used(
        real<&Filter::resampling, &ResamplingParams::neff_threshold>(
            {.key = "resampling.neff_threshold",
             .unit = "particles",
             .minimum = 0.0,
             .maximum = 1e6,
             .description = HITOS_TEXT("Parameter",
                                       "Effective number of particles Neff below which the rule "
                                       "neff resamples; a higher value resamples more often."),
             .label = HITOS_TEXT("ParameterLabel", "Neff threshold"),
             .symbol = "Neff",
             .card = "filter"}),
        {where(rule, {"neff"})}));
    table.push_back(choice<&Filter::resampling, &ResamplingParams::method>(
        {.key = "resampling.method",
         .description = HITOS_TEXT(
             "Parameter",
             "How particles are drawn anew; every method gives a particle as many copies in the "
             "mean as its weight says, and they differ in how much chance adds."),
         .label = HITOS_TEXT("ParameterLabel", "Resampling method"),
         .choices = choices_of(resampling_methods())}));
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

Table make_table() {
    Table table;
    add_filter(table);
    add_association(table);
    add_motion(table);
    add_observation(table);
    add_resampling(table);
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
