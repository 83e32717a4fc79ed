// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/registration/registration_parameters.hpp"

#include <vector>

#include "hitos/registration/graph_edit.hpp"

namespace hitos {
namespace {

using namespace declare;
using Table = std::vector<Parameter<RegistrationParams>>;
using Params = RegistrationParams;

Table matching_entries() {
    return {
        real<&Params::range_m>(
            {"registration.range", "m", 1, 1000, HITOS_TEXT("ParameterLabel", "Range"),
             HITOS_TEXT("Parameter",
                        "Readings beyond it are not registered; a higher value sees the ends of "
                        "corridors and halls, which hold the heading.")}),
        integer<&Params::key_scans>(
            {"registration.key_scans", "scans", 2, 1000, HITOS_TEXT("ParameterLabel", "Key scans"),
             HITOS_TEXT("Parameter",
                        "Newest key scans that a scan is matched with; half as many of an earlier "
                        "passage come in addition. More take longer.")}),
        real<&Params::key_distance_m>(
            {"registration.key_distance", "m", 0.01, 10,
             HITOS_TEXT("ParameterLabel", "Key distance"),
             HITOS_TEXT("Parameter",
                        "A scan that far from the last key scan is the next one; a higher value "
                        "keeps fewer and is quicker.")}),
        real<&Params::key_angle_rad>(
            {"registration.key_angle", "rad", 0.01, 3.2, HITOS_TEXT("ParameterLabel", "Key angle"),
             HITOS_TEXT("Parameter",
                        "A scan turned that far from the last key scan is the next one; a higher "
                        "value keeps fewer and is quicker.")}),
        real<&Params::point_sigma_m>(
            {"registration.point_sigma", "m", 1e-3, 10, HITOS_TEXT("ParameterLabel", "σ point"),
             HITOS_TEXT("Parameter",
                        "Standard deviation of a matched point, the errors that neighbours share "
                        "included; a higher value trusts the odometry more and searches wider for "
                        "loops.")}),
        real<&Params::odometry_scale>(
            {"registration.odometry_scale", "", 0.01, 100,
             HITOS_TEXT("ParameterLabel", "Odometry noise"),
             HITOS_TEXT(
                 "Parameter",
                 "Factor of the odometry's standard deviations (2 cm and 10 % along, 1 cm and 5 % "
                 "across, 30 mrad and 15 % of a turn); a higher value trusts the scans more.")}),
        choice<&Params::robust_prior>(
            {"registration.robust_prior", HITOS_TEXT("ParameterLabel", "Robust odometry"),
             HITOS_TEXT("Parameter",
                        "Whether odometry that the scan plainly contradicts loses weight, as when "
                        "a wheel slips.")},
            off_on()),
        choice<&Params::search>({"registration.search", HITOS_TEXT("ParameterLabel", "Search"),
                                 HITOS_TEXT("Parameter",
                                            "Whether a scan that fits nothing near its odometry is "
                                            "searched for in a window about it.")},
                                off_on()),
        choice<&Params::calibrate>(
            {"registration.calibrate", HITOS_TEXT("ParameterLabel", "Calibration"),
             HITOS_TEXT("Parameter",
                        "Whether the laser's angle and its distance ahead of the axle are learnt "
                        "while driving.")},
            off_on()),
    };
}

Table loop_entries() {
    const auto loops = choice<&Params::loops>(
        {"registration.loops", HITOS_TEXT("ParameterLabel", "Loops"),
         HITOS_TEXT(
             "Parameter",
             "Whether the robot's return to a place is looked for and the path behind corrected.")},
        off_on());
    return {
        loops,
        real<&Params::loop_score>(
            {"registration.loop_score", "", 0.1, 1, HITOS_TEXT("ParameterLabel", "Loop score"),
             HITOS_TEXT("Parameter",
                        "Least correlation of the last metres with an earlier passage; a higher "
                        "value refuses more, false and true.")},
            {where(loops, {"on"})}),
        integer<&Params::loops_agree>(
            {"registration.loops_agree", "searches", 1, 12,
             HITOS_TEXT("ParameterLabel", "Agreeing searches"),
             HITOS_TEXT("Parameter",
                        "Searches in a row that must say the same before a loop is closed; a "
                        "higher value refuses more, false and true.")},
            {where(loops, {"on"})}),
        integer<&Params::final_passes>({"registration.final_passes", "passes", 0, 100,
                                        HITOS_TEXT("ParameterLabel", "Final passes"),
                                        HITOS_TEXT("Parameter",
                                                   "How often all key scans are matched anew with "
                                                   "their neighbours at the tour's end.")}),
        text<&Params::edits>(
            {kGraphEditsKey, HITOS_TEXT("ParameterLabel", "Changes by hand"),
             HITOS_TEXT("Parameter",
                        "What is changed in the graph of this very tour: \"refuse SCAN EARLIER\" "
                        "(no loop), \"close SCAN EARLIER X Y THETA\" (a loop), \"fix SCAN X Y "
                        "THETA\", \"slip SCAN\", \"wall SCAN BEARING X1 Y1 X2 Y2\" and \"point "
                        "SCAN DX DY X Y\" (anchors to a drawing), with semicolons between; a file "
                        "of them is read by --edits.")}),
    };
}

}  // namespace

std::span<const Parameter<RegistrationParams>> registration_parameters() {
    static const Table table = together({matching_entries(), loop_entries()});
    return table;
}

}  // namespace hitos
