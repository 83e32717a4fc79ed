// The sentences of the parameter table, where lupdate finds them; the table itself lives in a
// library without Qt. A test holds the two against each other.
#include "parameter_strings.hpp"

#include <QtGlobal>
#include <array>

namespace hitos::window {
namespace {

// QT_TRANSLATE_NOOP gives its text; lupdate reads it.
constexpr auto kDescriptions = std::to_array<const char*>({
    QT_TRANSLATE_NOOP("Parameter",
                      "Path of the log to read, plain or gzip; empty where none is chosen."),
    QT_TRANSLATE_NOOP("Parameter", "Format of the log; auto finds it from the first lines."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "Readings at or beyond this range are no points, so a higher value keeps more far "
        "readings; 0 takes what the log says."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "Whether controls come from the differences of the logged poses or are the logged "
        "v and omega."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "What builds the map: fastslam, particles with one small filter per landmark; ekf-slam, "
        "one extended Kalman filter over the pose and all landmarks."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "Number of particles M; more of them follow more hypotheses, and time and memory "
        "grow in proportion."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "How an observation finds its landmark: ml takes the maximum likelihood, with p0 "
        "for a new landmark; gnn the nearest one inside a chi-square gate."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "Likelihood P0 of a new landmark; a higher value makes new landmarks more readily."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "Probability of the chi-square gate of gnn; a higher value accepts observations "
        "that lie further from their landmark."),
    QT_TRANSLATE_NOOP("Parameter",
                      "ekf-slam, which always associates by gnn: probability of the chi-square "
                      "gate outside which an observation is a new landmark, and between the two "
                      "gates nothing; a higher value makes fewer new landmarks."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "What an observation that fits several landmarks, and is kept out of the map, does "
        "to the weight: keep-likelihood multiplies it with the best likelihood, neutral "
        "leaves it, new-landmark multiplies it with p0; off updates the best landmark "
        "instead."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "Second best likelihood over the best from which an observation is ambiguous; a "
        "higher value calls fewer observations ambiguous."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "odometry: controls and noise of constant sigma; no-odometry: controls are ignored "
        "and the particles only spread; proportional: controls and noise that grows with "
        "the motion."),
    QT_TRANSLATE_NOOP("Parameter",
                      "Standard deviation of the motion noise in x per step with constant noise; a "
                      "higher value spreads the particles more."),
    QT_TRANSLATE_NOOP("Parameter",
                      "Standard deviation of the motion noise in y per step with constant noise; a "
                      "higher value spreads the particles more."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "Standard deviation of the heading noise per step with constant noise; a higher "
        "value spreads the headings more."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "Proportional noise: variance along the motion per metre; a higher value trusts "
        "the measured distance less."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "Proportional noise: variance across the motion per metre; a higher value allows "
        "more sideways slip."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "Proportional noise: variance of the heading per radian turned; a higher value "
        "trusts measured turns less."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "Proportional noise: variance of the heading per metre driven; a higher value "
        "allows more drift of the heading on straight ways."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "Variance sigma^2 of the observed rho of a line or range of a corner; a higher "
        "value trusts the laser less and accepts greater differences from a landmark."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "Variance sigma^2 of the observed theta of a line or bearing of a corner; a higher "
        "value trusts the laser less and accepts greater differences from a landmark."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "How sure an observation is: fixed takes var_rho and var_theta for all; points computes "
        "the covariance of each line and corner from the points that support it."),
    QT_TRANSLATE_NOOP("Parameter",
                      "Standard deviation of a measured range, for the covariance points; a higher "
                      "value trusts the laser less."),
    QT_TRANSLATE_NOOP("Parameter",
                      "Standard deviation of the error that all points of a line share, for the "
                      "covariance points: walls that are not straight, ranges in steps; a higher "
                      "value trusts long walls less."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "How lines are found: split-merge divides runs of points at the farthest one; ransac cuts "
        "the scan at edges and takes the lines that most points agree with, fitted by least "
        "squares. Both use min_length, min_points and collinear_* of split_merge."),
    QT_TRANSLATE_NOOP(
        "Parameter", "What is looked for in a scan: lines, corners where two lines meet, or both."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "Greatest distance Es of a corner from the nearest point of each of its lines; a "
        "higher value accepts corners that were seen less closely."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "Greatest distance Dmax of a point from its line; a higher value makes fewer and "
        "rougher lines."),
    QT_TRANSLATE_NOOP("Parameter", "Shortest line Lmin; a higher value drops more short lines."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "Fewest points Pmin of a line; a higher value drops more lines that are short or "
        "far."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "How an accepted line is fitted: through its first and last point, or by total "
        "least squares over all its points."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "Lines whose rho differs by less than this are merged if their theta is near too; "
        "a higher value merges more."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "Lines whose theta differs by less than this are merged if their rho is near too; "
        "a higher value merges more."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "Lines are merged only where they are less than this apart, so a higher value "
        "merges more; 0 merges over any distance."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "Neighbouring points further apart than gap + gap_per_range * range never share a "
        "line, so a higher value lets lines cross wider gaps; both 0 allow any gap."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "How much the gap allowed between neighbours grows with their range; a higher "
        "value lets far lines cross wider gaps."),
    QT_TRANSLATE_NOOP("Parameter",
                      "Ranges of neighbours that differ by more than edge + edge_per_range * range "
                      "end a run; a higher value makes longer runs."),
    QT_TRANSLATE_NOOP("Parameter",
                      "How much the difference allowed between neighbours grows with their range; "
                      "a higher value lets walls run on that are seen at a flat angle."),
    QT_TRANSLATE_NOOP("Parameter",
                      "Greatest distance of a point that agrees with a line; a higher value makes "
                      "fewer and rougher lines."),
    QT_TRANSLATE_NOOP("Parameter",
                      "Most hypotheses tried for one line; a higher value finds lines among more "
                      "stray points and takes longer."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "When particles are drawn anew: after every step that observed something, or only "
        "where Neff has fallen below its threshold."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "Effective number of particles Neff below which the rule neff resamples; a higher "
        "value resamples more often."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "Side of a cell of the occupancy grid; a higher value makes a coarser and faster "
        "map."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "Added to the cell that a ray ends in; a higher value makes walls appear sooner."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "Added to every cell that a ray passes; a value nearer to 0 clears free space more "
        "slowly."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "Greatest absolute value of a cell; a higher value makes a sure cell slower to "
        "change again."),
    QT_TRANSLATE_NOOP("Parameter",
                      "Rays are drawn up to this length, so a higher value draws more of the far "
                      "readings; 0 draws them whole."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "Seed of all random numbers; the same seed gives the same result to the last bit."),
    QT_TRANSLATE_NOOP(
        "Parameter",
        "Number of threads, which changes the time and never the result; 0 uses as many as "
        "the machine has."),
});

}  // namespace

std::span<const char* const> parameter_descriptions() {
    return kDescriptions;
}

}  // namespace hitos::window
