// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of what is found in a scan, one struct per part [T ch. 4, SPEC 4].
#pragma once

#include <string>

namespace hitos {

/// How a line is fitted to its points.
enum class LineFit {
    endpoints,     ///< through the first and the last point (iterative end point fit, [T 4.4])
    least_squares  ///< total least squares over all points of an accepted line [P 2]
};

/// Which pieces are one line [T table 4.4]. SPEC names in brackets.
struct CollinearParams {
    double rho_m = 0.1;       ///< merge below this difference of rho [col]
    double theta_rad = 0.07;  ///< and this difference of theta [col]
    double gap_m = 0.0;       ///< and only pieces less than this apart; 0: any distance
    friend bool operator==(const CollinearParams&, const CollinearParams&) = default;
};

/// What is a line, whichever method finds it [T 4.4].
struct LineParams {
    double min_length_m = 0.5;  ///< shortest line [mlon]
    int min_points = 15;        ///< fewest points of a line [mpuntos]
    CollinearParams collinear;
    friend bool operator==(const LineParams&, const LineParams&) = default;
};

/// Split & Merge [T tables 4.3, 4.4].
struct SplitMergeParams {
    double dmax_m = 0.02;              ///< greatest distance of a point from its line [dmax]
    LineFit fit = LineFit::endpoints;  ///< fit of the accepted lines
    double gap_m = 0.0;                ///< neighbours further apart than gap_m + gap_per_range *
    double gap_per_range = 0.0;        ///< range end a run; both 0: they never do
    friend bool operator==(const SplitMergeParams&, const SplitMergeParams&) = default;
};

/// Which comes first, RANSAC or the division of the scan at edges.
enum class RansacOrder {
    edges_first,  ///< RANSAC inside each run, which knows nothing of the walls beside it
    ransac_first  ///< RANSAC over the whole scan; what is left is divided [P 2]
};

/// RANSAC and successive edge following [P 2].
struct RansacParams {
    double edge_m = 0.3;          ///< ranges of neighbours that differ by more than edge_m +
    double edge_per_range = 0.1;  ///< edge_per_range * range are an edge: a run ends
    double threshold_m = 0.04;    ///< greatest distance of a consensus point from its line
    int iterations = 200;         ///< most hypotheses tried for one line
    RansacOrder order = RansacOrder::edges_first;
    friend bool operator==(const RansacParams&, const RansacParams&) = default;
};

/// How sure an observation is.
enum class ObservationCovariance {
    fixed,  ///< the observation model's variances, the same for every feature [T]
    points  ///< each feature's own, from the points that support it [P 2]
};

/// What is looked for in a scan [SPEC 4].
enum class Detection { lines, corners, both };

/// Which lines corners are the intersections of.
enum class CornerLines {
    detected,  ///< the lines as the method fitted them [T table 4.2]
    fitted     ///< total least squares over all points of each, however the line itself is fitted
};

/// Trees and posts: round things that stand alone, each a point landmark at its centre.
struct CircleParams {
    bool find = false;
    double max_radius_m = 0.5;  ///< no thicker ones
    double gap_m = 0.5;         ///< nothing else is as near to it
    int min_points = 2;         ///< fewest points of a circle
    friend bool operator==(const CircleParams&, const CircleParams&) = default;
};

/// How features are found in a scan, and how sure they are taken to be.
struct ExtractionParams {
    Detection detect = Detection::both;
    std::string method = "split-merge";  ///< which finds the lines: a word of line_methods()
    LineParams lines;
    SplitMergeParams split_merge;
    RansacParams ransac;
    CircleParams circles;
    ObservationCovariance covariance = ObservationCovariance::fixed;
    double point_sigma_m = 0.01;     ///< for `points` and circles: standard deviation of a range
    double common_sigma_m = 0.0;     ///< and of what all points of a line, or circle, share
    double corner_distance_m = 0.1;  ///< greatest distance of a corner from both its lines [es]
    double corner_angle_rad = 0.0;   ///< least angle between the lines of a corner; 0: any
    CornerLines corner_lines = CornerLines::detected;
    friend bool operator==(const ExtractionParams&, const ExtractionParams&) = default;
};

}  // namespace hitos
