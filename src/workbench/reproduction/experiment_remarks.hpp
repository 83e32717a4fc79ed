// What we see in the maps of the thesis's experiments, and where we differ from it.
#pragma once

#include <string_view>

namespace hitos::remarks {

inline constexpr std::string_view kDmaxHall =
    "As in the thesis, 0.001 m finds next to nothing and the map comes apart; from 0.01 m on the "
    "loop "
    "closes. The harm above 0.03 m is missing: the walls of the world are straight and nothing "
    "stands "
    "before them, so a loose Dmax has nothing to misread. On the recorded tour below it has.";
inline constexpr std::string_view kLengthLaboratory =
    "All four maps are right and the number of lines hardly changes: the thesis's noisy lines came "
    "of "
    "the furniture of a real room. What remains is that longer minimum lengths lose corners. The "
    "recorded tour below has the many short lines.";
inline constexpr std::string_view kPointsLaboratory =
    "As in the thesis, 17 points give the lines of the place, and 40 lose lines and most corners "
    "and "
    "blur the map. 3 points do no harm where there is no clutter.";
inline constexpr std::string_view kCollinearBigloop2 =
    "The thesis does not print the values of this figure; these are those of figure 10.61. Within "
    "reason (0.05 m and 0.07 rad and more) nothing changes, as it says. Below, pieces of one wall "
    "are "
    "no longer merged: up to one corner in surplus, and a somewhat greater error.";
inline constexpr std::string_view kCollinearHall =
    "The number of lines hardly changes, as in the thesis. Its surplus of corners below "
    "0.05 m "
    "is missing where walls are straight.";
inline constexpr std::string_view kAngularNoise =
    "Too little noise tears the map, as in the thesis, but only at 0.0001: the odometry of the "
    "simulated tour is better than that of the real one. Beyond 0.03 the map does not diverge but "
    "blurs, and the path gets worse.";
inline constexpr std::string_view kPositionNoise =
    "The thesis's tendency without its failures: the path is best from 0.003 to 0.008 and worse on "
    "both sides, yet the loop closes everywhere.";
inline constexpr std::string_view kRhoLaboratory =
    "As in the thesis, all maps up to 0.1 are right, and at 1 lines are confused and the map "
    "suffers. "
    "The surplus of landmarks at small values is missing here; on the recorded tour below it is "
    "great.";
inline constexpr std::string_view kThetaLaboratory =
    "As in the thesis, great values confuse landmarks: at 0.2 the map blurs, at 0.5 it is wrong "
    "and "
    "has many more landmarks. Its failure at small values is missing: where the laser's noise is 3 "
    "mm, "
    "trusting the laser is right. On the recorded tour below both ends fail.";
inline constexpr std::string_view kNeffHall =
    "As in the thesis: no difference that can be seen, and 2 is somewhat worse.";
inline constexpr std::string_view kNeffLaboratory =
    "As in the thesis: all maps are alike; at 2 the path is "
    "somewhat worse.";
inline constexpr std::string_view kParticlesHall =
    "Unlike in the thesis, 5 particles make many landmarks too many and a path half a metre off, "
    "though the building can be told. More of them go on helping, slowly: the motion noise of this "
    "table is less than the odometry's own, so that the "
    "particles must find the rare great deviations.";
inline constexpr std::string_view kDmaxRecorded =
    "As the thesis says of its recorded tour: at 0.001 m nothing is found and SLAM is impossible, "
    "0.03 m gives the best map, and beyond it ever more landmarks do harm.";
inline constexpr std::string_view kLengthRecorded =
    "As in the thesis the number of lines falls from very many to few. SLAM does not fail at 1 m: "
    "the "
    "corridors here are long.";
inline constexpr std::string_view kPointsRecorded =
    "As in the thesis: no end of lines at 3 points, few at 40, and then a blurred map.";
inline constexpr std::string_view kCollinearRecorded =
    "As in the thesis: the lines stay the same, and small thresholds bring a surplus of corners.";
inline constexpr std::string_view kAngularRecorded =
    "The thesis's figures again: torn with too little noise, right about the true noise, worse "
    "with "
    "too much.";
inline constexpr std::string_view kPositionRecorded =
    "As in the thesis noise far beyond the true one does harm; below it the path hardly changes.";
inline constexpr std::string_view kRhoRecorded =
    "As in the thesis: a surplus of landmarks at small values, and a worse map at 1.";
inline constexpr std::string_view kThetaRecorded =
    "As in the thesis: at 0.0001 a surplus of landmarks and a worse map, at 0.2 and 0.5 wrong "
    "associations and a wrong map.";
inline constexpr std::string_view kNeffRecorded =
    "From 80 on the map is right; rarer resampling does harm here, where a scan is taken only "
    "every "
    "half metre.";
inline constexpr std::string_view kParticlesRecorded =
    "5 particles are too few for loops of this size, whose odometry is off by degrees at every "
    "scan; "
    "from 100 on the differences are those of single runs.";

}  // namespace hitos::remarks
