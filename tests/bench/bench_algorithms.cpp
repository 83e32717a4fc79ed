// SPDX-License-Identifier: GPL-3.0-or-later
// Cost of a step against the number of landmarks in the map, EKF-SLAM and FastSLAM on the same
// observations: a robot on a circle in a field of corners sees the ten nearest.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "hitos/slam/filters.hpp"

namespace {

using namespace hitos;

constexpr int kSeen = 10;
constexpr double kSpacing = 3.0;  // m, between corners

struct Field {
    std::vector<Esquina> corners;
    std::vector<Observation> observations;
    std::vector<Control> controls;
};

/// Corners on a square grid, shifted at random; one lap on a circle among them.
Field make_field(int landmarks) {
    Field field;
    std::mt19937 engine(7);
    std::uniform_real_distribution<double> shift(-0.5, 0.5);
    std::normal_distribution<double> noise(0.0, 0.01);
    const int side = static_cast<int>(std::ceil(std::sqrt(landmarks)));
    for (int i = 0; i < landmarks; ++i) {
        const int column = i % side;
        const int row = i / side;
        field.corners.push_back(
            {kSpacing * column + shift(engine), kSpacing * row + shift(engine)});
    }
    const double middle = 0.5 * kSpacing * side;
    const double radius = 0.5 * middle;
    constexpr int kSteps = 200;
    const double turn = 2.0 * kPi / kSteps;
    for (int k = 0; k < kSteps; ++k) {
        const double angle = turn * (k + 1);  // after the control beside it
        const Pose pose{middle + radius * std::cos(angle), middle + radius * std::sin(angle),
                        wrap_angle(angle + kPi / 2.0)};
        std::vector<Esquina> local;
        for (const Esquina& corner : field.corners)
            local.push_back(transform(inverse(pose), corner));
        const auto seen = std::min<std::ptrdiff_t>(kSeen, landmarks);
        std::partial_sort(local.begin(), local.begin() + seen, local.end(),
                          [](const Esquina& a, const Esquina& b) {
                              return std::hypot(a.x, a.y) < std::hypot(b.x, b.y);
                          });
        local.resize(static_cast<std::size_t>(seen));
        for (Esquina& corner : local) {
            corner.x += noise(engine);
            corner.y += noise(engine);
        }
        Observation observation;
        observation.corners = local;
        field.observations.push_back(observation);
        field.controls.push_back({{radius * turn / 0.2, 0.0, turn / 0.2}, 0.2});
    }
    return field;
}

/// A filter whose map already holds the whole field, seen from the robot's first place.
std::unique_ptr<SlamFilter> filter_with_map(const Field& field, const char* algorithm) {
    FilterParams params;
    params.algorithm = algorithm;
    params.motion.model = "proportional";
    params.observation = {0.0004, 0.0001};
    auto filter = make_filter(params, 1, 1);
    const double middle = 0.5 * kSpacing * std::ceil(std::sqrt(field.corners.size()));
    const Pose start{1.5 * middle, middle, kPi / 2.0};
    Observation all;
    for (const Esquina& corner : field.corners) {
        all.corners.push_back(transform(inverse(start), corner));
    }
    filter->step({Scan{}, {}, all});
    return filter;
}

void step(benchmark::State& state, const char* algorithm) {
    const Field field = make_field(static_cast<int>(state.range(0)));
    const auto filter = filter_with_map(field, algorithm);
    const Scan scan;
    std::size_t k = 0;
    for (auto _ : state) {
        filter->step({scan, std::span(&field.controls[k], 1), field.observations[k]});
        k = (k + 1) % field.observations.size();
    }
    state.counters["landmarks"] =
        filter->best_count(FeatureKind::line) + filter->best_count(FeatureKind::corner);
    state.SetComplexityN(state.range(0));
}

void sizes(benchmark::internal::Benchmark* benchmark) {
    benchmark->ArgName("landmarks")->Unit(benchmark::kMicrosecond);
    for (const int landmarks : {20, 50, 100, 200, 500, 1000}) benchmark->Arg(landmarks);
}

BENCHMARK_CAPTURE(step, ekf_slam, "ekf-slam")->Apply(sizes)->Complexity(benchmark::oNSquared);
BENCHMARK_CAPTURE(step, fastslam_100_particles, "fastslam")
    ->Apply(sizes)
    ->Complexity(benchmark::oN);

}  // namespace
