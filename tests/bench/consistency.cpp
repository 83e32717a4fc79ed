// SPDX-License-Identifier: GPL-3.0-or-later
// Is EKF-SLAM as sure as it may be? Monte Carlo runs with known noise; the normalised estimation
// error squared (NEES) of the pose, e' P^-1 e with e = estimate - truth, has mean 3 where the
// filter's covariance tells the truth. The mean over N runs then lies within the 95 % band of a
// chi-square variable with 3 N degrees of freedom, divided by N (Bar-Shalom, Li and Kirubarajan,
// Estimation with Applications to Tracking and Navigation, 2001, section 5.4).
//
// usage: build/release/bench/consistency [RUNS [STEPS.csv]]

#include <fmt/core.h>

#include <Eigen/Dense>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "hitos/features/extractor.hpp"
#include "hitos/services/evaluation/nees.hpp"
#include "hitos/simulation/drive/simulated_tour.hpp"
#include "hitos/slam/filters.hpp"
#include "hitos/slam/robot.hpp"

namespace {

using namespace hitos;

struct Scenario {
    const char* name;
    const char* world;
    double noise;  ///< times the variances of the gentle motion noise
    Detection detect;
    ObservationCovariance covariance;
};

constexpr double kLaserSigma = 0.01;

MotionParams motion_noise(double factor) {
    MotionParams motion;
    motion.model = "proportional";
    motion.var_along_m2_per_m = 0.0005 * factor;
    motion.var_across_m2_per_m = 0.0001 * factor;
    // Not per radian: the filter would count the noise's own turns as the robot's.
    motion.var_theta_rad2_per_rad = 0.0;
    motion.var_theta_rad2_per_m = 0.0002 * factor;
    return motion;
}

/// What one run says at every scan: the pose's NEES, or NaN before the first motion.
struct Run {
    std::vector<double> nees;
    double last_error_m = 0.0;
    int landmarks = 0;
};

Run run_once(const Scenario& scenario, const SimulatedTour& tour, std::uint64_t seed) {
    FilterParams filter_params;
    filter_params.algorithm = "ekf-slam";
    filter_params.motion = motion_noise(scenario.noise);
    filter_params.association.gate_probability = 0.999;
    filter_params.association.new_probability = 0.999999;
    ExtractionParams extraction;
    extraction.detect = scenario.detect;
    extraction.method = "ransac";
    extraction.lines.min_length_m = 0.4;
    extraction.lines.min_points = 9;
    extraction.covariance = scenario.covariance;
    extraction.point_sigma_m = kLaserSigma;
    const auto extractor = make_extractor(extraction, seed);
    const auto filter = make_filter(filter_params, seed, 1);
    const auto robot = make_robot(filter_params.motion);

    Run run;
    Observation seen;
    for (std::uint64_t k = 0; k < tour.scans(); ++k) {
        std::vector<Control> controls;
        if (k > 0) {
            const double seconds = tour.scan_time(k) - tour.scan_time(k - 1);
            const Pose driven = between(tour.true_pose(k - 1), tour.true_pose(k));
            const Control exact{twist_between(driven, seconds), seconds};
            RandomStream random(seed, RandomPurpose::odometry_noise, k, 0);
            const Pose told = robot->sample({}, sum_controls(std::span(&exact, 1)), random);
            controls.push_back({twist_between(told, seconds), seconds});
        }
        const Scan scan = tour.scan(k);
        extractor->extract(scan, seen);
        filter->step({scan, controls, seen});

        const Pose truth = tour.true_pose(k);
        const Pose estimate = filter->best_pose();
        run.nees.push_back(
            pose_nees(estimate, filter->pose_covariance(), truth).value_or(std::nan("")));
        run.last_error_m = std::hypot(estimate.x - truth.x, estimate.y - truth.y);
    }
    run.landmarks = filter->best_count(FeatureKind::line) + filter->best_count(FeatureKind::corner);
    return run;
}

void study(const Scenario& scenario, int runs, std::ofstream& steps) {
    World world = read_world(std::filesystem::path(HITOS_SOURCE_DIR) / "data/worlds" /
                             (std::string(scenario.world) + ".toml"));
    world.laser.sigma_m = kLaserSigma;
    std::vector<double> sums;
    double errors2 = 0.0;
    int landmarks = 0;
    for (int r = 1; r <= runs; ++r) {
        world.seed = static_cast<std::uint64_t>(r);
        const Run run = run_once(scenario, SimulatedTour(world), world.seed);
        sums.resize(run.nees.size());
        for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += run.nees[k];
        errors2 += run.last_error_m * run.last_error_m;
        landmarks += run.landmarks;
    }
    const double n = runs;
    const NeesInterval band = nees_interval(runs, 3);
    int counted = 0;
    int inside = 0;
    int above = 0;
    double mean = 0.0;
    std::vector<double> averages;
    for (std::size_t k = 0; k < sums.size(); ++k) {
        const double average = sums[k] / n;
        if (std::isnan(average)) continue;
        ++counted;
        inside += average >= band.low && average <= band.high ? 1 : 0;
        above += average > band.high ? 1 : 0;
        mean += average;
        averages.push_back(average);
        if (steps) steps << fmt::format("\"{}\",{},{:.4f}\n", scenario.name, k, average);
    }
    // Errors of neighbouring steps hang together: the tour's second half is told by itself.
    double late = 0.0;
    const std::size_t middle = averages.size() / 2;
    for (std::size_t k = middle; k < averages.size(); ++k) late += averages[k];
    late /= static_cast<double>(averages.size() - middle);
    fmt::print("{:<34} {:>5} {:>6.2f} {:>9.2f}   {:>4.0f} %    {:>4.0f} %  {:>8.3f} {:>9.1f}\n",
               scenario.name, sums.size(), mean / counted, late, 100.0 * inside / counted,
               100.0 * above / counted, std::sqrt(errors2 / n), static_cast<double>(landmarks) / n);
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    int runs = 50;
    if (argc > 1) {
        const std::string text = argv[1];
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), runs);
        if (error != std::errc() || end != text.data() + text.size() || runs < 2) {
            fmt::print(stderr, "consistency: found '{}'; expected 2 runs or more\n", text);
            return 2;
        }
    }
    std::ofstream steps;
    if (argc > 2) {
        steps.open(argv[2]);
        if (!steps) {
            fmt::print(stderr, "consistency: cannot write {}\n", argv[2]);
            return 1;
        }
        steps << "scenario,scan,nees\n";
    }
    const NeesInterval band = nees_interval(runs, 3);
    fmt::print(
        "EKF-SLAM, {} runs; pose NEES: 3 where the covariance tells the truth, 95 % band "
        "of the mean {:.2f} to {:.2f}\n",
        runs, band.low, band.high);
    fmt::print("{:<34} {:>5} {:>6} {:>9}  {:>7}   {:>6}  {:>8} {:>9}\n", "scenario", "scans",
               "mean", "2nd half", "in band", "above", "rmse_m", "landmarks");
    const auto lines = Detection::lines;
    const auto points = ObservationCovariance::points;
    for (const Scenario& scenario :
         {Scenario{"recinto, gentle noise", "recinto", 1.0, lines, points},
          Scenario{"bigloop, gentle noise", "bigloop", 1.0, lines, points},
          Scenario{"complex, gentle noise", "complex", 1.0, lines, points},
          Scenario{"bigloop, noise x 3", "bigloop", 3.0, lines, points},
          Scenario{"bigloop, noise x 10", "bigloop", 10.0, lines, points},
          Scenario{"bigloop, noise x 30", "bigloop", 30.0, lines, points},
          Scenario{"bigloop, lines and their corners", "bigloop", 1.0, Detection::both, points},
          Scenario{"bigloop, the thesis's variances", "bigloop", 1.0, lines,
                   ObservationCovariance::fixed}}) {
        study(scenario, runs, steps);
    }
    return 0;
}
