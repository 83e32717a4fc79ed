// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/features/extraction_parameters.hpp"

#include <vector>

#include "hitos/base/geometry.hpp"
#include "hitos/features/line_methods.hpp"

namespace hitos {
namespace {

using namespace declare;
using Table = std::vector<Parameter<ExtractionParams>>;
using Extraction = ExtractionParams;

Table observation_entries() {
    const auto covariance = choice<&ExtractionParams::covariance>(
        {"observation.covariance", HITOS_TEXT("ParameterLabel", "Covariance"),
         HITOS_TEXT(
             "Parameter",
             "How sure an observation is: fixed takes var_rho and var_theta for all; points "
             "computes the covariance of each line and corner from the points that support it."),
         "observation"},
        {{"fixed", HITOS_TEXT("ParameterChoice", "Fixed variances")},
         {"points", HITOS_TEXT("ParameterChoice", "From the points")}});
    const Parameter<Extraction>::Condition with_covariances{
        "observation.covariance", "points, or features.circles on", [](const Extraction& e) {
            return e.covariance == ObservationCovariance::points || e.circles.find;
        }};
    return {
        covariance,
        real<&ExtractionParams::point_sigma_m>(
            {"observation.point_sigma", "m", 1e-6, 10, HITOS_TEXT("ParameterLabel", "σ range"),
             HITOS_TEXT("Parameter",
                        "Standard deviation of a measured range, for the covariance points and for "
                        "circles; a higher value trusts the laser less."),
             "observation"},
            {with_covariances}),
        real<&ExtractionParams::common_sigma_m>(
            {"observation.common_sigma", "m", 0, 10, HITOS_TEXT("ParameterLabel", "σ shared"),
             HITOS_TEXT("Parameter",
                        "Standard deviation of the error that all points of a line or circle "
                        "share, for the covariance points and for circles: walls that are not "
                        "straight, trunks that are not round, ranges in steps; a higher value "
                        "trusts long walls less."),
             "observation"},
            {with_covariances}),
    };
}

Table feature_entries() {
    const auto detect = choice<&ExtractionParams::detect>(
        {"features.detect", HITOS_TEXT("ParameterLabel", "Features"),
         HITOS_TEXT("Parameter",
                    "What is looked for in a scan: lines, corners where two lines meet, or both."),
         "features"},
        {{"lines", HITOS_TEXT("ParameterChoice", "Lines")},
         {"corners", HITOS_TEXT("ParameterChoice", "Corners")},
         {"both", HITOS_TEXT("ParameterChoice", "Both")}});
    return {
        choice<&ExtractionParams::method>(
            {"features.method", HITOS_TEXT("ParameterLabel", "Lines by"),
             HITOS_TEXT("Parameter",
                        "How lines are found in a scan. Every method uses min_length, min_points "
                        "and collinear_* of split_merge."),
             "features"},
            choices_of(line_methods())),
        detect,
        real<&ExtractionParams::corner_distance_m>(
            {"features.corner_distance", "m", 0, 10,
             HITOS_TEXT("ParameterLabel", "Corner distance (Es)"),
             HITOS_TEXT("Parameter",
                        "Greatest distance Es of a corner from the nearest point of each of its "
                        "lines; a higher value accepts corners that were seen less closely."),
             "", "Es"},
            {where(detect, {"corners", "both"})}),
        real<&ExtractionParams::corner_angle_rad>(
            {"features.corner_angle", "rad", 0, kPi / 2.0,
             HITOS_TEXT("ParameterLabel", "Corner angle"),
             HITOS_TEXT("Parameter",
                        "Least angle between the lines of a corner, modulo pi; a higher value "
                        "takes fewer bends for corners, among them those of a wall that noise has "
                        "broken; 0 takes any, as the thesis does.")},
            {where(detect, {"corners", "both"})}),
        choice<&ExtractionParams::corner_lines>(
            {"features.corner_lines", HITOS_TEXT("ParameterLabel", "Corners of"),
             HITOS_TEXT("Parameter",
                        "What corners are the intersections of: the lines as they are detected, or "
                        "least squares lines over all points of each, which differ where lines go "
                        "through their end points.")},
            {{"detected", HITOS_TEXT("ParameterChoice", "Detected lines")},
             {"fitted", HITOS_TEXT("ParameterChoice", "Fitted walls")}},
            {where(detect, {"corners", "both"}),
             {"split_merge.fit", "endpoints, by which no line of ransac is fitted",
              [](const Extraction& e) {
                  return e.method != "ransac" && e.split_merge.fit == LineFit::endpoints;
              }}}),
    };
}

Table circle_entries() {
    const auto find = choice<&Extraction::circles, &CircleParams::find>(
        {"features.circles", HITOS_TEXT("ParameterLabel", "Trees and posts"),
         HITOS_TEXT("Parameter",
                    "Whether round things that stand alone are point landmarks at their centres, "
                    "whatever else is looked for: trees, posts."),
         "features"},
        off_on());
    return {
        find,
        real<&Extraction::circles, &CircleParams::max_radius_m>(
            {"features.circle_radius", "m", 1e-3, 10, HITOS_TEXT("ParameterLabel", "Thickest"),
             HITOS_TEXT("Parameter",
                        "Greatest radius of a circle; a higher value takes thicker trees, and "
                        "more that is none."),
             "features"},
            {where(find, {"on"})}),
        real<&Extraction::circles, &CircleParams::gap_m>(
            {"features.circle_gap", "m", 1e-3, 100, HITOS_TEXT("ParameterLabel", "Stands alone by"),
             HITOS_TEXT("Parameter",
                        "Nothing else may be as near to a circle, and what is behind it is farther "
                        "by more; a higher value takes fewer twigs of bushes, and fewer trees that "
                        "stand close together.")},
            {where(find, {"on"})}),
        integer<&Extraction::circles, &CircleParams::min_points>(
            {"features.circle_points", "", 1, 10000, HITOS_TEXT("ParameterLabel", "Fewest points"),
             HITOS_TEXT("Parameter",
                        "Fewest points of a circle; a higher value takes fewer of the trees that "
                        "are far away, and less that is none.")},
            {where(find, {"on"})}),
    };
}

Table split_merge_entries() {
    return {
        real<&Extraction::split_merge, &SplitMergeParams::dmax_m>(
            {"split_merge.dmax", "m", 1e-6, 10, HITOS_TEXT("ParameterLabel", "D max"),
             HITOS_TEXT("Parameter",
                        "Greatest distance Dmax of a point from its line; a higher value makes "
                        "fewer and rougher lines."),
             "features", "Dmax"}),
        real<&Extraction::lines, &LineParams::min_length_m>(
            {"split_merge.min_length", "m", 0, 100, HITOS_TEXT("ParameterLabel", "L min"),
             HITOS_TEXT("Parameter", "Shortest line Lmin; a higher value drops more short lines."),
             "features", "Lmin"}),
        integer<&Extraction::lines, &LineParams::min_points>(
            {"split_merge.min_points", "", 2, 10000, HITOS_TEXT("ParameterLabel", "P min"),
             HITOS_TEXT("Parameter",
                        "Fewest points Pmin of a line; a higher value drops more lines that are "
                        "short or far."),
             "features", "Pmin"}),
        choice<&Extraction::split_merge, &SplitMergeParams::fit>(
            {"split_merge.fit", HITOS_TEXT("ParameterLabel", "Fit"),
             HITOS_TEXT("Parameter",
                        "How an accepted line is fitted: through its first and last point, or by "
                        "total least squares over all its points."),
             "features"},
            {{"endpoints", HITOS_TEXT("ParameterChoice", "End points")},
             {"least-squares", HITOS_TEXT("ParameterChoice", "Least squares")}}),
        real<&Extraction::lines, &LineParams::collinear, &CollinearParams::rho_m>(
            {"split_merge.collinear_rho", "m", 0, 10, HITOS_TEXT("ParameterLabel", "Collinear ρ"),
             HITOS_TEXT("Parameter",
                        "Lines whose rho differs by less than this are merged if their theta is "
                        "near too; a higher value merges more.")}),
        real<&Extraction::lines, &LineParams::collinear, &CollinearParams::theta_rad>(
            {"split_merge.collinear_theta", "rad", 0, kPi / 2.0,
             HITOS_TEXT("ParameterLabel", "Collinear θ"),
             HITOS_TEXT("Parameter",
                        "Lines whose theta differs by less than this are merged if their rho is "
                        "near too; a higher value merges more.")}),
        real<&Extraction::lines, &LineParams::collinear, &CollinearParams::gap_m>(
            {"split_merge.collinear_gap", "m", 0, 1000,
             HITOS_TEXT("ParameterLabel", "Collinear gap"),
             HITOS_TEXT("Parameter",
                        "Lines are merged only where they are less than this apart, so a higher "
                        "value merges more; 0 merges over any distance.")}),
        real<&Extraction::split_merge, &SplitMergeParams::gap_m>(
            {"split_merge.gap", "m", 0, 100, HITOS_TEXT("ParameterLabel", "Gap"),
             HITOS_TEXT(
                 "Parameter",
                 "Neighbouring points further apart than gap + gap_per_range * range never share a "
                 "line, so a higher value lets lines cross wider gaps; both 0 allow any gap.")}),
        real<&Extraction::split_merge, &SplitMergeParams::gap_per_range>(
            {"split_merge.gap_per_range", "m/m", 0, 1,
             HITOS_TEXT("ParameterLabel", "Gap per range"),
             HITOS_TEXT("Parameter",
                        "How much the gap allowed between neighbours grows with their range; a "
                        "higher value lets far lines cross wider gaps.")}),
    };
}

Table ransac_entries() {
    return {
        real<&Extraction::ransac, &RansacParams::edge_m>(
            {"ransac.edge", "m", 0, 100, HITOS_TEXT("ParameterLabel", "RANSAC edge"),
             HITOS_TEXT("Parameter",
                        "Ranges of neighbours that differ by more than edge + edge_per_range * "
                        "range end a run; a higher value makes longer runs.")}),
        real<&Extraction::ransac, &RansacParams::edge_per_range>(
            {"ransac.edge_per_range", "m/m", 0, 10, HITOS_TEXT("ParameterLabel", "Edge per range"),
             HITOS_TEXT("Parameter",
                        "How much the difference allowed between neighbours grows with their "
                        "range; a higher value lets walls run on that are seen at a flat angle.")}),
        real<&Extraction::ransac, &RansacParams::threshold_m>(
            {"ransac.threshold", "m", 1e-6, 10, HITOS_TEXT("ParameterLabel", "RANSAC threshold"),
             HITOS_TEXT("Parameter",
                        "Greatest distance of a point that agrees with a line; a higher value "
                        "makes fewer and rougher lines."),
             "features"}),
        integer<&Extraction::ransac, &RansacParams::iterations>(
            {"ransac.iterations", "", 1, 1e6, HITOS_TEXT("ParameterLabel", "RANSAC iterations"),
             HITOS_TEXT("Parameter",
                        "Most hypotheses tried for one line; a higher value finds lines among more "
                        "stray points and takes longer.")}),
        choice<&Extraction::ransac, &RansacParams::order>(
            {"ransac.order", HITOS_TEXT("ParameterLabel", "RANSAC order"),
             HITOS_TEXT(
                 "Parameter",
                 "Whether the scan is divided at edges and RANSAC finds the lines of each part, or "
                 "RANSAC has the whole scan and the points of each line are divided at edges.")},
            {{"edges-first", HITOS_TEXT("ParameterChoice", "Edges, then RANSAC")},
             {"ransac-first", HITOS_TEXT("ParameterChoice", "RANSAC, then edges")}}),
    };
}

Table make_table() {
    Table table = together({observation_entries(), feature_entries(), circle_entries(),
                            split_merge_entries(), ransac_entries()});
    heed_readers(table, "features.method", line_methods());
    return table;
}

}  // namespace

std::span<const Parameter<ExtractionParams>> extraction_parameters() {
    static const Table table = make_table();
    return table;
}

}  // namespace hitos
