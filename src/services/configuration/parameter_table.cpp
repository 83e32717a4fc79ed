#include "parameter_table.hpp"

#include <initializer_list>
#include <type_traits>

#include "hitos/features/line_methods.hpp"
#include "hitos/slam/filters.hpp"
#include "hitos/slam/proposal.hpp"
#include "hitos/slam/resampler.hpp"
#include "hitos/slam/robot.hpp"

namespace hitos {
namespace {

using Group = ParameterGroup;
using Config = Configuracion;
using Filter = FilterParams;

/// Follows pointers to members from the configuration down to one of its values.
template <auto... Members>
auto& member(auto& configuration) {
    return (configuration.*....*Members);
}

Parameter described(Parameter::Type type, std::string_view key, Group group,
                    std::string_view description) {
    Parameter parameter;
    parameter.key = key;
    parameter.group = group;
    parameter.type = type;
    parameter.description = description;
    return parameter;
}

template <auto... Members>
Parameter real(std::string_view key, Group group, std::string_view unit, double minimum,
               double maximum, std::string_view description) {
    Parameter parameter = described(Parameter::Type::real, key, group, description);
    parameter.unit = unit;
    parameter.minimum = minimum;
    parameter.maximum = maximum;
    parameter.real = [](Config& c) -> double& { return member<Members...>(c); };
    parameter.get_real = [](const Config& c) { return member<Members...>(c); };
    return parameter;
}

template <auto... Members>
void reach_as_integer(Parameter& parameter) {
    parameter.get_integer = [](const Config& c) {
        return static_cast<std::int64_t>(member<Members...>(c));
    };
    parameter.set_integer = [](Config& c, std::int64_t value) {
        auto& target = member<Members...>(c);
        target = static_cast<std::remove_reference_t<decltype(target)>>(value);
    };
}

template <auto... Members>
Parameter integer(std::string_view key, Group group, double minimum, double maximum,
                  std::string_view description) {
    Parameter parameter = described(Parameter::Type::integer, key, group, description);
    parameter.minimum = minimum;
    parameter.maximum = maximum;
    reach_as_integer<Members...>(parameter);
    return parameter;
}

template <auto... Members>
Parameter choice(std::string_view key, Group group, std::initializer_list<std::string_view> words,
                 std::string_view description) {
    Parameter parameter = described(Parameter::Type::choice, key, group, description);
    parameter.choices = words;
    reach_as_integer<Members...>(parameter);
    return parameter;
}

/// A word of the registry that `Entries` gives, kept as it is.
template <auto Entries, auto... Members>
Parameter registered(std::string_view key, Group group, std::string_view description) {
    Parameter parameter = described(Parameter::Type::choice, key, group, description);
    for (const auto& entry : Entries().entries()) parameter.choices.push_back(entry.word);
    parameter.get_integer = [](const Config& c) {
        const auto& entries = Entries().entries();
        for (std::size_t i = 0; i < entries.size(); ++i) {
            if (entries[i].word == member<Members...>(c)) return static_cast<std::int64_t>(i);
        }
        return std::int64_t{-1};
    };
    parameter.set_integer = [](Config& c, std::int64_t place) {
        member<Members...>(c) = Entries().entries().at(static_cast<std::size_t>(place)).word;
    };
    return parameter;
}

template <auto... Members>
Parameter text(std::string_view key, Group group, std::string_view description) {
    Parameter parameter = described(Parameter::Type::text, key, group, description);
    parameter.words = [](Config& c) -> std::string& { return member<Members...>(c); };
    parameter.get_words = [](const Config& c) -> const std::string& {
        return member<Members...>(c);
    };
    return parameter;
}

using Table = std::vector<Parameter>;

void add_source(Table& table) {
    table.push_back(text<&Config::source, &SourceParams::file>(
        "source.file", Group::source,
        "Path of the log to read, plain or gzip; empty where none is chosen."));
    Parameter format = described(Parameter::Type::choice, "source.format", Group::source,
                                 "Format of the log; auto finds it from the first lines.");
    format.choices = {kAutoFormat};
    for (const LogFormat& known : log_formats().entries()) format.choices.push_back(known.word);
    format.get_integer = [](const Config& c) {
        if (c.source.format == kAutoFormat) return std::int64_t{0};
        return &log_formats().find(c.source.format) - log_formats().entries().data() + 1;
    };
    format.set_integer = [](Config& c, std::int64_t place) {
        c.source.format = place == 0 ? std::string(kAutoFormat)
                                     : log_formats().entries()[static_cast<std::size_t>(place - 1)].word;
    };
    table.push_back(std::move(format));
    table.push_back(real<&Config::source, &SourceParams::read, &ReadOptions::max_range_m>(
        "source.max_range", Group::source, "m", 0.0, 1000.0,
        "Readings at or beyond this range are no points, so a higher value keeps more far "
        "readings; "
        "0 takes what the log says."));
    table.push_back(choice<&Config::source, &SourceParams::read, &ReadOptions::logged_velocities>(
        "source.odometry", Group::source, {"poses", "velocities"},
        "Whether controls come from the differences of the logged poses or are the logged v and "
        "omega."));
}

void add_particle_filter(Table& table) {
    table.push_back(registered<&slam_algorithms, &Config::filter, &Filter::algorithm>(
        "filter.algorithm", Group::particle_filter,
        "What builds the map: fastslam, particles with one small filter per landmark; ekf-slam, "
        "one extended Kalman filter over the pose and all landmarks."));
    table.push_back(integer<&Config::filter, &Filter::particles>(
        "filter.particles", Group::particle_filter, 1.0, 1e6,
        "Number of particles M; more of them follow more hypotheses, and time and memory grow in "
        "proportion."));
    table.push_back(registered<&proposals, &Config::filter, &Filter::proposal>(
        "filter.proposal", Group::particle_filter,
        "Where particles draw their new poses from: motion takes the motion model alone, as "
        "FastSLAM 1.0 does."));
    table.push_back(choice<&Config::filter, &Filter::association, &AssociationParams::method>(
        "association.method", Group::particle_filter, {"ml", "gnn"},
        "How an observation finds its landmark: ml takes the maximum likelihood, with p0 for a "
        "new landmark; gnn the nearest one inside a chi-square gate."));
    table.push_back(real<&Config::filter, &Filter::association, &AssociationParams::p0>(
        "association.p0", Group::particle_filter, "", 1e-30, 1000.0,
        "Likelihood P0 of a new landmark; a higher value makes new landmarks more readily."));
    table.push_back(
        real<&Config::filter, &Filter::association, &AssociationParams::gate_probability>(
            "association.gate_probability", Group::particle_filter, "", 0.5, 0.999999,
            "Probability of the chi-square gate of gnn; a higher value accepts observations that "
            "lie further from their landmark."));
    table.push_back(
        real<&Config::filter, &Filter::association, &AssociationParams::new_probability>(
            "association.new_probability", Group::particle_filter, "", 0.5, 0.999999999999,
            "ekf-slam, which always associates by gnn: probability of the chi-square gate outside "
            "which an observation is a new landmark, and between the two gates nothing; a higher "
            "value makes fewer new landmarks."));
    table.push_back(choice<&Config::filter, &Filter::association, &AssociationParams::ambiguity>(
        "association.ambiguity", Group::particle_filter,
        {"keep-likelihood", "neutral", "new-landmark", "off"},
        "What an observation that fits several landmarks, and is kept out of the map, does to "
        "the weight: keep-likelihood multiplies it with the best likelihood, neutral leaves it, "
        "new-landmark multiplies it with p0; off updates the best landmark instead."));
    table.push_back(
        real<&Config::filter, &Filter::association, &AssociationParams::ambiguity_ratio>(
            "association.ambiguity_ratio", Group::particle_filter, "", 0.0, 1.0,
            "Second best likelihood over the best from which an observation is ambiguous; a higher "
            "value calls fewer observations ambiguous."));
}

void add_motion(Table& table) {
    table.push_back(registered<&motion_models, &Config::filter, &Filter::motion,
                               &MotionParams::model>(
        "motion.model", Group::motion,
        "odometry: controls and noise of constant sigma; no-odometry: controls are ignored and the "
        "particles only spread; proportional: controls and noise that grows with the motion."));
    table.push_back(real<&Config::filter, &Filter::motion, &MotionParams::sigma_x_m>(
        "motion.sigma_x", Group::motion, "m", 0.0, 10.0,
        "Standard deviation of the motion noise in x per step with constant noise; a higher value "
        "spreads the particles more."));
    table.push_back(real<&Config::filter, &Filter::motion, &MotionParams::sigma_y_m>(
        "motion.sigma_y", Group::motion, "m", 0.0, 10.0,
        "Standard deviation of the motion noise in y per step with constant noise; a higher value "
        "spreads the particles more."));
    table.push_back(real<&Config::filter, &Filter::motion, &MotionParams::sigma_theta_rad>(
        "motion.sigma_theta", Group::motion, "rad", 0.0, 10.0,
        "Standard deviation of the heading noise per step with constant noise; a higher value "
        "spreads the headings more."));
    table.push_back(real<&Config::filter, &Filter::motion, &MotionParams::var_along_m2_per_m>(
        "motion.var_along", Group::motion, "m^2/m", 0.0, 10.0,
        "Proportional noise: variance along the motion per metre; a higher value trusts the "
        "measured distance less."));
    table.push_back(real<&Config::filter, &Filter::motion, &MotionParams::var_across_m2_per_m>(
        "motion.var_across", Group::motion, "m^2/m", 0.0, 10.0,
        "Proportional noise: variance across the motion per metre; a higher value allows more "
        "sideways slip."));
    table.push_back(real<&Config::filter, &Filter::motion, &MotionParams::var_theta_rad2_per_rad>(
        "motion.var_theta_per_rad", Group::motion, "rad^2/rad", 0.0, 10.0,
        "Proportional noise: variance of the heading per radian turned; a higher value trusts "
        "measured turns less."));
    table.push_back(real<&Config::filter, &Filter::motion, &MotionParams::var_theta_rad2_per_m>(
        "motion.var_theta_per_m", Group::motion, "rad^2/m", 0.0, 10.0,
        "Proportional noise: variance of the heading per metre driven; a higher value allows more "
        "drift of the heading on straight ways."));
}

void add_observation(Table& table) {
    table.push_back(real<&Config::filter, &Filter::observation, &ObservationParams::var_rho_m2>(
        "observation.var_rho", Group::observation, "m^2", 1e-12, 1000.0,
        "Variance sigma^2 of the observed rho of a line or range of a corner; a higher value "
        "trusts "
        "the laser less and accepts greater differences from a landmark."));
    table.push_back(real<&Config::filter, &Filter::observation, &ObservationParams::var_theta_rad2>(
        "observation.var_theta", Group::observation, "rad^2", 1e-12, 10.0,
        "Variance sigma^2 of the observed theta of a line or bearing of a corner; a higher value "
        "trusts the laser less and accepts greater differences from a landmark."));
    table.push_back(choice<&Config::extraction, &ExtractionParams::covariance>(
        "observation.covariance", Group::observation, {"fixed", "points"},
        "How sure an observation is: fixed takes var_rho and var_theta for all; points computes "
        "the covariance of each line and corner from the points that support it."));
    table.push_back(real<&Config::extraction, &ExtractionParams::point_sigma_m>(
        "observation.point_sigma", Group::observation, "m", 1e-6, 10.0,
        "Standard deviation of a measured range, for the covariance points; a higher value trusts "
        "the laser less."));
    table.push_back(real<&Config::extraction, &ExtractionParams::common_sigma_m>(
        "observation.common_sigma", Group::observation, "m", 0.0, 10.0,
        "Standard deviation of the error that all points of a line share, for the covariance "
        "points: walls that are not straight, ranges in steps; a higher value trusts long walls "
        "less."));
}

void add_features(Table& table) {
    table.push_back(registered<&line_methods, &Config::extraction, &ExtractionParams::method>(
        "features.method", Group::split_merge,
        "How lines are found: split-merge divides runs of points at the farthest one; ransac cuts "
        "the scan at edges and takes the lines that most points agree with, fitted by least "
        "squares. Both use min_length, min_points and collinear_* of split_merge."));
    table.push_back(choice<&Config::extraction, &ExtractionParams::detect>(
        "features.detect", Group::split_merge, {"lines", "corners", "both"},
        "What is looked for in a scan: lines, corners where two lines meet, or both."));
    table.push_back(real<&Config::extraction, &ExtractionParams::corner_distance_m>(
        "features.corner_distance", Group::split_merge, "m", 0.0, 10.0,
        "Greatest distance Es of a corner from the nearest point of each of its lines; a higher "
        "value accepts corners that were seen less closely."));
}

void add_split_merge(Table& table) {
    using Extraction = ExtractionParams;
    table.push_back(real<&Config::extraction, &Extraction::split_merge, &SplitMergeParams::dmax_m>(
        "split_merge.dmax", Group::split_merge, "m", 1e-6, 10.0,
        "Greatest distance Dmax of a point from its line; a higher value makes fewer and rougher "
        "lines."));
    table.push_back(real<&Config::extraction, &Extraction::lines, &LineParams::min_length_m>(
        "split_merge.min_length", Group::split_merge, "m", 0.0, 100.0,
        "Shortest line Lmin; a higher value drops more short lines."));
    table.push_back(integer<&Config::extraction, &Extraction::lines, &LineParams::min_points>(
        "split_merge.min_points", Group::split_merge, 2.0, 10000.0,
        "Fewest points Pmin of a line; a higher value drops more lines that are short or far."));
    table.push_back(choice<&Config::extraction, &Extraction::split_merge, &SplitMergeParams::fit>(
        "split_merge.fit", Group::split_merge, {"endpoints", "least-squares"},
        "How an accepted line is fitted: through its first and last point, or by total least "
        "squares over all its points."));
    table.push_back(real<&Config::extraction, &Extraction::lines, &LineParams::collinear,
                         &CollinearParams::rho_m>(
        "split_merge.collinear_rho", Group::split_merge, "m", 0.0, 10.0,
        "Lines whose rho differs by less than this are merged if their theta is near too; a "
        "higher value merges more."));
    table.push_back(real<&Config::extraction, &Extraction::lines, &LineParams::collinear,
                         &CollinearParams::theta_rad>(
        "split_merge.collinear_theta", Group::split_merge, "rad", 0.0, kPi / 2.0,
        "Lines whose theta differs by less than this are merged if their rho is near too; a "
        "higher value merges more."));
    table.push_back(real<&Config::extraction, &Extraction::lines, &LineParams::collinear,
                         &CollinearParams::gap_m>(
        "split_merge.collinear_gap", Group::split_merge, "m", 0.0, 1000.0,
        "Lines are merged only where they are less than this apart, so a higher value merges "
        "more; 0 merges over any distance."));
    table.push_back(real<&Config::extraction, &Extraction::split_merge, &SplitMergeParams::gap_m>(
        "split_merge.gap", Group::split_merge, "m", 0.0, 100.0,
        "Neighbouring points further apart than gap + gap_per_range * range never share a line, so "
        "a higher value lets lines cross wider gaps; both 0 allow any gap."));
    table.push_back(
        real<&Config::extraction, &Extraction::split_merge, &SplitMergeParams::gap_per_range>(
            "split_merge.gap_per_range", Group::split_merge, "m/m", 0.0, 1.0,
            "How much the gap allowed between neighbours grows with their range; a higher value "
            "lets far lines cross wider gaps."));
}

void add_ransac(Table& table) {
    using Extraction = ExtractionParams;
    table.push_back(real<&Config::extraction, &Extraction::ransac, &RansacParams::edge_m>(
        "ransac.edge", Group::split_merge, "m", 0.0, 100.0,
        "Ranges of neighbours that differ by more than edge + edge_per_range * range end a run; a "
        "higher value makes longer runs."));
    table.push_back(real<&Config::extraction, &Extraction::ransac, &RansacParams::edge_per_range>(
        "ransac.edge_per_range", Group::split_merge, "m/m", 0.0, 10.0,
        "How much the difference allowed between neighbours grows with their range; a higher value "
        "lets walls run on that are seen at a flat angle."));
    table.push_back(real<&Config::extraction, &Extraction::ransac, &RansacParams::threshold_m>(
        "ransac.threshold", Group::split_merge, "m", 1e-6, 10.0,
        "Greatest distance of a point that agrees with a line; a higher value makes fewer and "
        "rougher lines."));
    table.push_back(integer<&Config::extraction, &Extraction::ransac, &RansacParams::iterations>(
        "ransac.iterations", Group::split_merge, 1.0, 1e6,
        "Most hypotheses tried for one line; a higher value finds lines among more stray points "
        "and takes longer."));
}

void add_resampling(Table& table) {
    table.push_back(choice<&Config::filter, &Filter::resampling, &ResamplingParams::rule>(
        "resampling.rule", Group::resampling, {"always", "neff"},
        "When particles are drawn anew: after every step that observed something, or only where "
        "Neff has fallen below its threshold."));
    table.push_back(real<&Config::filter, &Filter::resampling, &ResamplingParams::neff_threshold>(
        "resampling.neff_threshold", Group::resampling, "particles", 0.0, 1e6,
        "Effective number of particles Neff below which the rule neff resamples; a higher value "
        "resamples more often."));
    table.push_back(registered<&resampling_methods, &Config::filter, &Filter::resampling,
                               &ResamplingParams::method>(
        "resampling.method", Group::resampling,
        "How particles are drawn anew; all methods give a particle as many copies in the mean as "
        "its weight says and differ in how much chance adds, low-variance least."));
}

void add_grid(Table& table) {
    table.push_back(real<&Config::grid, &GridParams::resolution_m>(
        "grid.resolution", Group::grid, "m", 0.001, 10.0,
        "Side of a cell of the occupancy grid; a higher value makes a coarser and faster map."));
    table.push_back(real<&Config::grid, &GridParams::log_odds_hit>(
        "grid.hit", Group::grid, "log-odds", 0.0, 50.0,
        "Added to the cell that a ray ends in; a higher value makes walls appear sooner."));
    table.push_back(real<&Config::grid, &GridParams::log_odds_miss>(
        "grid.miss", Group::grid, "log-odds", -50.0, 0.0,
        "Added to every cell that a ray passes; a value nearer to 0 clears free space more "
        "slowly."));
    table.push_back(real<&Config::grid, &GridParams::log_odds_limit>(
        "grid.limit", Group::grid, "log-odds", 0.1, 100.0,
        "Greatest absolute value of a cell; a higher value makes a sure cell slower to change "
        "again."));
    table.push_back(real<&Config::grid, &GridParams::max_range_m>(
        "grid.max_range", Group::grid, "m", 0.0, 1000.0,
        "Rays are drawn up to this length, so a higher value draws more of the far readings; 0 "
        "draws them whole."));
}

void add_run(Table& table) {
    // 2^63 is the double next to the greatest seed, 2^63 - 1.
    table.push_back(integer<&Config::run, &RunParams::seed>(
        "run.seed", Group::run, 0.0, 0x1p63,
        "Seed of all random numbers; the same seed gives the same result to the last bit."));
    table.push_back(integer<&Config::run, &RunParams::threads>(
        "run.threads", Group::run, 0.0, 256.0,
        "Number of threads, which changes the time and never the result; 0 uses as many as the "
        "machine has."));
}

}  // namespace

std::vector<Parameter> make_parameter_table() {
    Table table;
    add_source(table);
    add_particle_filter(table);
    add_motion(table);
    add_observation(table);
    add_features(table);
    add_split_merge(table);
    add_ransac(table);
    add_resampling(table);
    add_grid(table);
    add_run(table);
    return table;
}

}  // namespace hitos
