#include "hitos/features/extraction_parameters.hpp"

#include <vector>

#include "hitos/base/geometry.hpp"
#include "hitos/features/line_methods.hpp"

namespace hitos {
namespace {

using namespace declare;
using Table = std::vector<Parameter<ExtractionParams>>;
using Extraction = ExtractionParams;

void add_observation(Table& table) {
    const auto covariance = choice<&ExtractionParams::covariance>(
        {.key = "observation.covariance",
         .description = HITOS_TEXT(
             "Parameter",
             "How sure an observation is: fixed takes var_rho and var_theta for all; points "
             "computes the covariance of each line and corner from the points that support it."),
         .label = HITOS_TEXT("ParameterLabel", "Covariance"),
         .card = "observation",
         .choices = {{"fixed", HITOS_TEXT("ParameterChoice", "Fixed variances")},
                     {"points", HITOS_TEXT("ParameterChoice", "From the points")}}});
    table.push_back(covariance);
    table.push_back(used(
        real<&ExtractionParams::point_sigma_m>(
            {.key = "observation.point_sigma",
             .unit = "m",
             .minimum = 1e-6,
             .maximum = 10.0,
             .description = HITOS_TEXT("Parameter",
                                       "Standard deviation of a measured range, for the covariance "
                                       "points; a higher value trusts the laser less."),
             .label = HITOS_TEXT("ParameterLabel", "σ range"),
             .card = "observation"}),
        {where(covariance, {"points"})}));
    table.push_back(used(real<&ExtractionParams::common_sigma_m>(
                             {.key = "observation.common_sigma",
                              .unit = "m",
                              .minimum = 0.0,
                              .maximum = 10.0,
                              .description = HITOS_TEXT(
                                  "Parameter",
                                  "Standard deviation of the error that all points of a line "
                                  "share, for the covariance points: walls that are not straight, "
                                  "ranges in steps; a higher value trusts long walls less."),
                              .label = HITOS_TEXT("ParameterLabel", "σ shared"),
                              .card = "observation"}),
                         {where(covariance, {"points"})}));
}

void add_features(Table& table) {
    table.push_back(choice<&ExtractionParams::method>(
        {.key = "features.method",
         .description = HITOS_TEXT("Parameter",
                                   "How lines are found in a scan. Every method uses min_length, "
                                   "min_points and collinear_* of split_merge."),
         .label = HITOS_TEXT("ParameterLabel", "Lines by"),
         .card = "features",
         .choices = choices_of(line_methods())}));
    const auto detect = choice<&ExtractionParams::detect>(
        {.key = "features.detect",
         .description = HITOS_TEXT(
             "Parameter",
             "What is looked for in a scan: lines, corners where two lines meet, or both."),
         .label = HITOS_TEXT("ParameterLabel", "Features"),
         .card = "features",
         .choices = {{"lines", HITOS_TEXT("ParameterChoice", "Lines")},
                     {"corners", HITOS_TEXT("ParameterChoice", "Corners")},
                     {"both", HITOS_TEXT("ParameterChoice", "Both")}}});
    table.push_back(detect);
    table.push_back(
        used(real<&ExtractionParams::corner_distance_m>(
                 {.key = "features.corner_distance",
                  .unit = "m",
                  .minimum = 0.0,
                  .maximum = 10.0,
                  .description = HITOS_TEXT(
                      "Parameter",
                      "Greatest distance Es of a corner from the nearest point of each of its "
                      "lines; a higher value accepts corners that were seen less closely."),
                  .label = HITOS_TEXT("ParameterLabel", "Corner distance (Es)"),
                  .symbol = "Es"}),
             {where(detect, {"corners", "both"})}));
    table.push_back(used(real<&ExtractionParams::corner_angle_rad>(
                             {.key = "features.corner_angle",
                              .unit = "rad",
                              .minimum = 0.0,
                              .maximum = kPi / 2.0,
                              .description = HITOS_TEXT(
                                  "Parameter",
                                  "Least angle between the lines of a corner, modulo pi; a higher "
                                  "value takes fewer bends for corners, among them those of a wall "
                                  "that noise has broken; 0 takes any, as the thesis does."),
                              .label = HITOS_TEXT("ParameterLabel", "Corner angle")}),
                         {where(detect, {"corners", "both"})}));
    table.push_back(
        used(choice<&ExtractionParams::corner_lines>(
                 {.key = "features.corner_lines",
                  .description =
                      HITOS_TEXT("Parameter",
                                 "What corners are the intersections of: the lines as they are "
                                 "detected, or least squares lines over all points of each, which "
                                 "differ where lines go through their end points."),
                  .label = HITOS_TEXT("ParameterLabel", "Corners of"),
                  .choices = {{"detected", HITOS_TEXT("ParameterChoice", "Detected lines")},
                              {"fitted", HITOS_TEXT("ParameterChoice", "Fitted walls")}}}),
             {where(detect, {"corners", "both"}),
              {"split_merge.fit", "endpoints, by which no line of ransac is fitted",
               [](const Extraction& e) {
                   return e.method != "ransac" && e.split_merge.fit == LineFit::endpoints;
               }}}));
}

void add_split_merge(Table& table) {
    table.push_back(real<&Extraction::split_merge, &SplitMergeParams::dmax_m>(
        {.key = "split_merge.dmax",
         .unit = "m",
         .minimum = 1e-6,
         .maximum = 10.0,
         .description = HITOS_TEXT("Parameter",
                                   "Greatest distance Dmax of a point from its line; a higher "
                                   "value makes fewer and rougher lines."),
         .label = HITOS_TEXT("ParameterLabel", "D max"),
         .symbol = "Dmax",
         .card = "features"}));
    table.push_back(real<&Extraction::lines, &LineParams::min_length_m>(
        {.key = "split_merge.min_length",
         .unit = "m",
         .minimum = 0.0,
         .maximum = 100.0,
         .description =
             HITOS_TEXT("Parameter", "Shortest line Lmin; a higher value drops more short lines."),
         .label = HITOS_TEXT("ParameterLabel", "L min"),
         .symbol = "Lmin",
         .card = "features"}));
    table.push_back(integer<&Extraction::lines, &LineParams::min_points>(
        {.key = "split_merge.min_points",
         .minimum = 2.0,
         .maximum = 10000.0,
         .description = HITOS_TEXT("Parameter",
                                   "Fewest points Pmin of a line; a higher value drops more lines "
                                   "that are short or far."),
         .label = HITOS_TEXT("ParameterLabel", "P min"),
         .symbol = "Pmin",
         .card = "features"}));
    table.push_back(choice<&Extraction::split_merge, &SplitMergeParams::fit>(
        {.key = "split_merge.fit",
         .description = HITOS_TEXT("Parameter",
                                   "How an accepted line is fitted: through its first and last "
                                   "point, or by total least squares over all its points."),
         .label = HITOS_TEXT("ParameterLabel", "Fit"),
         .card = "features",
         .choices = {{"endpoints", HITOS_TEXT("ParameterChoice", "End points")},
                     {"least-squares", HITOS_TEXT("ParameterChoice", "Least squares")}}}));
    table.push_back(real<&Extraction::lines, &LineParams::collinear, &CollinearParams::rho_m>(
        {.key = "split_merge.collinear_rho",
         .unit = "m",
         .minimum = 0.0,
         .maximum = 10.0,
         .description = HITOS_TEXT("Parameter",
                                   "Lines whose rho differs by less than this are merged if their "
                                   "theta is near too; a higher value merges more."),
         .label = HITOS_TEXT("ParameterLabel", "Collinear ρ")}));
    table.push_back(real<&Extraction::lines, &LineParams::collinear, &CollinearParams::theta_rad>(
        {.key = "split_merge.collinear_theta",
         .unit = "rad",
         .minimum = 0.0,
         .maximum = kPi / 2.0,
         .description = HITOS_TEXT("Parameter",
                                   "Lines whose theta differs by less than this are merged if "
                                   "their rho is near too; a higher value merges more."),
         .label = HITOS_TEXT("ParameterLabel", "Collinear θ")}));
    table.push_back(real<&Extraction::lines, &LineParams::collinear, &CollinearParams::gap_m>(
        {.key = "split_merge.collinear_gap",
         .unit = "m",
         .minimum = 0.0,
         .maximum = 1000.0,
         .description = HITOS_TEXT("Parameter",
                                   "Lines are merged only where they are less than this apart, so "
                                   "a higher value merges more; 0 merges over any distance."),
         .label = HITOS_TEXT("ParameterLabel", "Collinear gap")}));
    table.push_back(real<&Extraction::split_merge, &SplitMergeParams::gap_m>(
        {.key = "split_merge.gap",
         .unit = "m",
         .minimum = 0.0,
         .maximum = 100.0,
         .description = HITOS_TEXT(
             "Parameter",
             "Neighbouring points further apart than gap + gap_per_range * range never share a "
             "line, so a higher value lets lines cross wider gaps; both 0 allow any gap."),
         .label = HITOS_TEXT("ParameterLabel", "Gap")}));
    table.push_back(real<&Extraction::split_merge, &SplitMergeParams::gap_per_range>(
        {.key = "split_merge.gap_per_range",
         .unit = "m/m",
         .minimum = 0.0,
         .maximum = 1.0,
         .description = HITOS_TEXT("Parameter",
                                   "How much the gap allowed between neighbours grows with their "
                                   "range; a higher value lets far lines cross wider gaps."),
         .label = HITOS_TEXT("ParameterLabel", "Gap per range")}));
}

void add_ransac(Table& table) {
    table.push_back(real<&Extraction::ransac, &RansacParams::edge_m>(
        {.key = "ransac.edge",
         .unit = "m",
         .minimum = 0.0,
         .maximum = 100.0,
         .description =
             HITOS_TEXT("Parameter",
                        "Ranges of neighbours that differ by more than edge + edge_per_range * "
                        "range end a run; a higher value makes longer runs."),
         .label = HITOS_TEXT("ParameterLabel", "RANSAC edge")}));
    table.push_back(real<&Extraction::ransac, &RansacParams::edge_per_range>(
        {.key = "ransac.edge_per_range",
         .unit = "m/m",
         .minimum = 0.0,
         .maximum = 10.0,
         .description =
             HITOS_TEXT("Parameter",
                        "How much the difference allowed between neighbours grows with their "
                        "range; a higher value lets walls run on that are seen at a flat angle."),
         .label = HITOS_TEXT("ParameterLabel", "Edge per range")}));
    table.push_back(real<&Extraction::ransac, &RansacParams::threshold_m>(
        {.key = "ransac.threshold",
         .unit = "m",
         .minimum = 1e-6,
         .maximum = 10.0,
         .description = HITOS_TEXT("Parameter",
                                   "Greatest distance of a point that agrees with a line; a higher "
                                   "value makes fewer and rougher lines."),
         .label = HITOS_TEXT("ParameterLabel", "RANSAC threshold"),
         .card = "features"}));
    table.push_back(integer<&Extraction::ransac, &RansacParams::iterations>(
        {.key = "ransac.iterations",
         .minimum = 1.0,
         .maximum = 1e6,
         .description = HITOS_TEXT("Parameter",
                                   "Most hypotheses tried for one line; a higher value finds lines "
                                   "among more stray points and takes longer."),
         .label = HITOS_TEXT("ParameterLabel", "RANSAC iterations")}));
    table.push_back(choice<&Extraction::ransac, &RansacParams::order>(
        {.key = "ransac.order",
         .description = HITOS_TEXT(
             "Parameter",
             "Whether the scan is divided at edges and RANSAC finds the lines of each part, or "
             "RANSAC has the whole scan and the points of each line are divided at edges."),
         .label = HITOS_TEXT("ParameterLabel", "RANSAC order"),
         .choices = {{"edges-first", HITOS_TEXT("ParameterChoice", "Edges, then RANSAC")},
                     {"ransac-first", HITOS_TEXT("ParameterChoice", "RANSAC, then edges")}}}));
}

Table make_table() {
    Table table;
    add_observation(table);
    add_features(table);
    add_split_merge(table);
    add_ransac(table);
    heed_readers(table, "features.method", line_methods());
    return table;
}

}  // namespace

std::span<const Parameter<ExtractionParams>> extraction_parameters() {
    static const Table table = make_table();
    return table;
}

}  // namespace hitos
