// SPDX-License-Identifier: GPL-3.0-or-later
// Are the particles as sure as they may be? Monte Carlo runs in a room with noise that is exactly
// what the filter is told. The normalised estimation error squared (NEES) of the pose has mean 3
// where the particles' covariance tells the truth (Bar-Shalom, Li and Kirubarajan, Estimation with
// Applications to Tracking and Navigation, 2001, section 5.4).
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "hitos/services/evaluation/nees.hpp"
#include "hitos/slam/filters.hpp"
#include "hitos/slam/robot.hpp"

namespace hitos {
namespace {

constexpr int kRuns = 60;
constexpr int kSteps = 40;

/// `gentle`: motion noise below what a scan tells; else far above it.
FilterParams told(const std::string& proposal, bool gentle) {
    FilterParams params;
    params.proposal = proposal;
    params.particles = 400;
    params.motion.model = "proportional";
    const double factor = gentle ? 0.1 : 1.0;
    params.motion.var_along_m2_per_m = 0.002 * factor;
    params.motion.var_across_m2_per_m = 0.001 * factor;
    params.motion.var_theta_rad2_per_rad = 0.0;
    params.motion.var_theta_rad2_per_m = 0.002 * factor;
    params.observation = {0.02 * 0.02, 0.01 * 0.01};
    if (gentle) params.observation = {0.06 * 0.06, 0.04 * 0.04};
    params.association.p0 = 1e-3;
    params.resampling = {ResamplingRule::neff, 100.0};
    return params;
}

/// What a robot at the pose sees of a square room, with the noise that the filter is told of.
Observation look(const Pose& pose, const ObservationParams& noise, std::mt19937& engine) {
    std::normal_distribution<double> normal(0.0, 1.0);
    Observation seen;
    for (int side = 0; side < 4; ++side) {
        const Recta wall{4.0, wrap_angle(0.5 * kPi * side)};
        Recta local = transform(inverse(pose), wall);
        local.rho += std::sqrt(noise.var_rho_m2) * normal(engine);
        local.theta = wrap_angle(local.theta + std::sqrt(noise.var_theta_rad2) * normal(engine));
        if (std::abs(local.theta) < kPi / 2.0) seen.lines.push_back({local, 0, 0});
    }
    return seen;
}

/// Mean NEES over runs and the steps of their second half.
double mean_nees(const FilterParams& params) {
    const auto robot = make_robot(params.motion);
    double sum = 0.0;
    for (int run = 1; run <= kRuns; ++run) {
        std::mt19937 engine(static_cast<unsigned>(run));
        const auto filter = make_filter(params, static_cast<std::uint64_t>(run), 1);
        const Scan scan;
        Pose truth;
        for (int k = 0; k < kSteps; ++k) {
            const Control control{{0.5, 0.0, 0.4}, k == 0 ? 0.0 : 0.5};
            RandomStream random(static_cast<std::uint64_t>(run), RandomPurpose::odometry_noise,
                                static_cast<std::uint64_t>(k), 0);
            truth = robot->sample(truth, sum_controls(std::span(&control, 1)), random);
            const Observation seen = look(truth, params.observation, engine);
            filter->step({scan, std::span(&control, 1), seen});
            if (k < kSteps / 2) continue;
            sum += pose_nees(filter->mean_pose(), filter->pose_covariance(), truth).value();
        }
        EXPECT_EQ(filter->best_count(FeatureKind::line), 4) << run;
    }
    constexpr int kCounted = kSteps - kSteps / 2;
    return sum / (kRuns * kCounted);
}

TEST(ParticleConsistency, BothProposalsTellTheTruthWhereTheMotionIsGentle) {
    for (const char* proposal : {"motion", "posterior"}) {
        const double nees = mean_nees(told(proposal, true));
        EXPECT_GT(nees, 2.2) << proposal;
        EXPECT_LT(nees, 3.9) << proposal;
    }
}

TEST(ParticleConsistency, OnlyThePosteriorCopesWithSharpSensors) {
    // Few of the poses that the motion model draws fit the scan: FastSLAM 1.0 loses its variety.
    const double one = mean_nees(told("motion", false));
    const double two = mean_nees(told("posterior", false));
    EXPECT_GT(two, 2.2);
    EXPECT_LT(two, 4.2);
    EXPECT_GT(one, 2.0 * two);
}

}  // namespace
}  // namespace hitos
