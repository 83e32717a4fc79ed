#include "experiment_lists.hpp"
#include "experiment_remarks.hpp"

namespace hitos::experiments {

/// The same questions to public recordings, whose scans lie half a metre or ten degrees apart: so
/// the fixed parameters are those of the preset `recorded-fastslam1`, and motion noise is sought
/// tenfold.
void add_recorded(std::vector<ThesisExperiment>& all) {
    const auto add = [&](const char* figure, const char* parameter, const char* key,
                         const char* log, Settings settings, Claims claims,
                         std::string_view remark) {
        all.push_back({figure, parameter, key, "", Place::log, log, Show::maps, 1,
                       std::move(settings), std::move(claims), remark});
    };
    const Settings fifty{"filter.particles=50"};
    const Settings noise{"filter.particles=50", "motion.model=odometry"};
    add("10.25", "dmax", kDmax, "aces", fifty,
        {{"0.001", "no feature is found, and SLAM is impossible"},
         {"0.01", "nearer to the truth than below"},
         {"0.03", "the best map"},
         {"0.05", "many noisy landmarks do harm"},
         {"0.1", "many noisy landmarks do harm"},
         {"0.3", ""}},
        remarks::kDmaxRecorded);
    add("10.42", "mlon", kLength, "freiburg-101", fifty,
        {{"0.1", "very many lines, most of them noise"},
         {"0.3", "very many lines, most of them noise"},
         {"0.6", "the truest map, with a moderate number of lines"},
         {"1", "too few landmarks: SLAM fails"},
         {"2", ""}},
        remarks::kLengthRecorded);
    add("10.58", "mpuntos", kPoints, "freiburg-101", fifty,
        {{"3", "no end of lines"},
         {"17", "the lines are those of the place"},
         {"40", "very few lines and a wrong map"}},
        remarks::kPointsRecorded);
    add("10.61", "col_rho", kColRho, "aces", fifty,
        {{"0.001", "a right map, the usual lines, too many corners"},
         {"0.01", "too many corners"},
         {"0.03", "too many corners"},
         {"0.05", "the number of corners settles from here on"},
         {"0.5", "as at 0.05"},
         {"1", "as at 0.05, though such lines should not be merged"}},
        remarks::kCollinearRecorded);
    all.back().show = Show::counts;
    add("10.66/10.67", "mov_theta", kSigmaTheta, "aces",
        with(noise, {"motion.sigma_x=0.07", "motion.sigma_y=0.07"}),
        {{"0.001", "far from the truth (of 0.0001)"},
         {"0.01", "far from the truth (0.001)"},
         {"0.03", "nearer (0.003)"},
         {"0.05", "nearer (0.005)"},
         {"0.08", "the loop closes (0.008)"},
         {"0.3", "diverges again (0.03)"}},
        remarks::kAngularRecorded);
    add("10.69/10.70", "mov_pos", kSigmaXy, "aces", with(noise, {"motion.sigma_theta=0.05"}),
        {{"0.001/0.001", "the loop stays open, the shape is there (of 0.0001)"},
         {"0.01/0.01", "the loop stays open, the shape is there (0.001)"},
         {"0.03/0.03", "fit for navigation (0.003)"},
         {"0.05/0.05", "fit for navigation (0.005)"},
         {"0.08/0.08", "fit for navigation (0.008)"},
         {"0.2/0.2", "diverges altogether (0.02)"}},
        remarks::kPositionRecorded);
    add("10.76", "sensor_rho", kVarRho, "freiburg-101", fifty,
        {{"0.0001", "a right map, too many landmarks"},
         {"0.001", "a right map, too many landmarks"},
         {"0.01", "a right map and number"},
         {"0.1", "right, but some lines near each other become one"},
         {"1", "wrong associations begin to spoil the map"}},
        remarks::kRhoRecorded);
    add("10.77", "sensor_theta", kVarTheta, "freiburg-101", fifty,
        {{"0.0001", "a wrong map and too many landmarks"},
         {"0.0008", "a wrong map and too many landmarks"},
         {"0.001224", "right, and the least noisy"},
         {"0.014", "right"},
         {"0.2", "wrong associations, a wrong map"},
         {"0.5", "wrong associations, a wrong map"}},
        remarks::kThetaRecorded);
    add("10.80", "neff", kNeff, "aces", {"filter.particles=100", "resampling.rule=neff"},
        {{"2", "hardly another map"},
         {"20", "no difference"},
         {"80", "no difference"},
         {"100", "no difference"}},
        remarks::kNeffRecorded);
    add("10.96", "p", kParticles, "aces", {},
        {{"5", "much like the truth"},
         {"50", "the right map"},
         {"100", "no better than 50"},
         {"200", "no better than 50"}},
        remarks::kParticlesRecorded);
}

}  // namespace hitos::experiments
