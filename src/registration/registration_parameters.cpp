#include "hitos/registration/registration_parameters.hpp"

#include <vector>

namespace hitos {
namespace {

using namespace declare;
using Table = std::vector<Parameter<RegistrationParams>>;
using Params = RegistrationParams;

void add_matching(Table& table) {
    table.push_back(real<&Params::range_m>(
        {.key = "registration.range",
         .unit = "m",
         .minimum = 1.0,
         .maximum = 1000.0,
         .description = HITOS_TEXT("Parameter",
                                   "Readings beyond it are not registered; a higher value sees the "
                                   "ends of corridors and halls, which hold the heading."),
         .label = HITOS_TEXT("ParameterLabel", "Range")}));
    table.push_back(integer<&Params::key_scans>(
        {.key = "registration.key_scans",
         .unit = "scans",
         .minimum = 2.0,
         .maximum = 1000.0,
         .description = HITOS_TEXT("Parameter",
                                   "Newest key scans that a scan is matched with; half as many of "
                                   "an earlier passage come in addition. More take longer."),
         .label = HITOS_TEXT("ParameterLabel", "Key scans")}));
    table.push_back(real<&Params::key_distance_m>(
        {.key = "registration.key_distance",
         .unit = "m",
         .minimum = 0.01,
         .maximum = 10.0,
         .description = HITOS_TEXT("Parameter",
                                   "A scan that far from the last key scan is the next one; a "
                                   "higher value keeps fewer and is quicker."),
         .label = HITOS_TEXT("ParameterLabel", "Key distance")}));
    table.push_back(real<&Params::key_angle_rad>(
        {.key = "registration.key_angle",
         .unit = "rad",
         .minimum = 0.01,
         .maximum = 3.2,
         .description = HITOS_TEXT("Parameter",
                                   "A scan turned that far from the last key scan is the next one; "
                                   "a higher value keeps fewer and is quicker."),
         .label = HITOS_TEXT("ParameterLabel", "Key angle")}));
    table.push_back(real<&Params::point_sigma_m>(
        {.key = "registration.point_sigma",
         .unit = "m",
         .minimum = 1e-3,
         .maximum = 10.0,
         .description = HITOS_TEXT(
             "Parameter",
             "Standard deviation of a matched point, the errors that neighbours share included; a "
             "higher value trusts the odometry more and searches wider for loops."),
         .label = HITOS_TEXT("ParameterLabel", "σ point")}));
    table.push_back(real<&Params::odometry_scale>(
        {.key = "registration.odometry_scale",
         .minimum = 0.01,
         .maximum = 100.0,
         .description = HITOS_TEXT(
             "Parameter",
             "Factor of the odometry's standard deviations (2 cm and 10 % along, 1 cm and 5 % "
             "across, 30 mrad and 15 % of a turn); a higher value trusts the scans more."),
         .label = HITOS_TEXT("ParameterLabel", "Odometry noise")}));
    table.push_back(choice<&Params::robust_prior>(
        {.key = "registration.robust_prior",
         .description = HITOS_TEXT("Parameter",
                                   "Whether odometry that the scan plainly contradicts loses "
                                   "weight, as when a wheel slips."),
         .label = HITOS_TEXT("ParameterLabel", "Robust odometry"),
         .choices = off_on()}));
    table.push_back(choice<&Params::search>(
        {.key = "registration.search",
         .description = HITOS_TEXT("Parameter",
                                   "Whether a scan that fits nothing near its odometry is searched "
                                   "for in a window about it."),
         .label = HITOS_TEXT("ParameterLabel", "Search"),
         .choices = off_on()}));
    table.push_back(choice<&Params::calibrate>(
        {.key = "registration.calibrate",
         .description = HITOS_TEXT("Parameter",
                                   "Whether the laser's angle and its distance ahead of the axle "
                                   "are learnt while driving."),
         .label = HITOS_TEXT("ParameterLabel", "Calibration"),
         .choices = off_on()}));
}

void add_loops(Table& table) {
    const auto loops = choice<&Params::loops>(
        {.key = "registration.loops",
         .description = HITOS_TEXT(
             "Parameter",
             "Whether the robot's return to a place is looked for and the path behind corrected."),
         .label = HITOS_TEXT("ParameterLabel", "Loops"),
         .choices = off_on()});
    table.push_back(loops);
    table.push_back(used(
        real<&Params::loop_score>(
            {.key = "registration.loop_score",
             .minimum = 0.1,
             .maximum = 1.0,
             .description = HITOS_TEXT("Parameter",
                                       "Least correlation of the last metres with an earlier "
                                       "passage; a higher value refuses more, false and true."),
             .label = HITOS_TEXT("ParameterLabel", "Loop score")}),
        {where(loops, {"on"})}));
    table.push_back(used(
        integer<&Params::loops_agree>(
            {.key = "registration.loops_agree",
             .unit = "searches",
             .minimum = 1.0,
             .maximum = 12.0,
             .description = HITOS_TEXT("Parameter",
                                       "Searches in a row that must say the same before a loop is "
                                       "closed; a higher value refuses more, false and true."),
             .label = HITOS_TEXT("ParameterLabel", "Agreeing searches")}),
        {where(loops, {"on"})}));
    table.push_back(integer<&Params::final_passes>(
        {.key = "registration.final_passes",
         .unit = "passes",
         .minimum = 0.0,
         .maximum = 100.0,
         .description = HITOS_TEXT(
             "Parameter",
             "How often all key scans are matched anew with their neighbours at the tour's end."),
         .label = HITOS_TEXT("ParameterLabel", "Final passes")}));
}

}  // namespace

std::span<const Parameter<RegistrationParams>> registration_parameters() {
    static const Table table = [] {
        Table made;
        add_matching(made);
        add_loops(made);
        return made;
    }();
    return table;
}

}  // namespace hitos
