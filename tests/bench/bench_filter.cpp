// SPDX-License-Identifier: GPL-3.0-or-later
// Speed of the chain on a recorded tour: reading, line extraction, the FastSLAM step, grids.
//
// The log is bigloop2 where the shared logs are there, else the bigloop of data/; its odometry gets
// the thesis's noise (sigma 10 %), the parameters are those of config/thesis.cfg. Everything is
// read before the clock starts, except where reading is what is measured.

#include <benchmark/benchmark.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <vector>

#include "hitos/capture/archivo.hpp"
#include "hitos/capture/procesador.hpp"
#include "hitos/features/extractor.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/files/line_extents.hpp"
#include "hitos/services/grid/grid.hpp"
#include "hitos/simulation/worlds/odometry_noise.hpp"
#include "hitos/slam/filters.hpp"

namespace {

using namespace hitos;

std::filesystem::path log_path() {
    std::filesystem::path shared =
        std::filesystem::path(HITOS_SHARED_DIR) / "data/player/bigloop2.log.gz";
    if (std::filesystem::exists(shared)) return shared;
    return std::filesystem::path(HITOS_SOURCE_DIR) / "data/bigloop.log.gz";
}

struct Tour {
    std::vector<Scan> scans;
    std::vector<std::vector<Control>> controls;
    Configuracion configuration;
};

const Tour& tour() {
    static const Tour loaded = [] {
        Tour t;
        t.configuration = ArchivoConfiguracion::read(std::filesystem::path(HITOS_SOURCE_DIR) /
                                                     "config/thesis.cfg");
        Procesador reader(open_log(log_path()));
        OdometryNoise noise(0.1, OdometryNoiseKind::relative_sigma, 1);
        ControlTrack track([&]() -> std::optional<Odometria> {
            auto reading = reader.next_odometry();
            if (reading) reading = noise(*reading);
            return reading;
        });
        while (auto scan = reader.next_scan()) {
            t.scans.push_back(std::move(*scan));
            t.controls.emplace_back();
            track.controls_until(t.scans.back(), t.controls.back());
        }
        return t;
    }();
    return loaded;
}

/// From parsed scans to resampled particles. Arguments: particles, threads, scans (0: all).
void extraction_and_filter(benchmark::State& state) {
    const Tour& t = tour();
    FilterParams params = t.configuration.filter;
    params.particles = static_cast<int>(state.range(0));
    const std::size_t scans =
        state.range(2) == 0 ? t.scans.size() : static_cast<std::size_t>(state.range(2));
    double landmarks = 0.0;
    for (auto _ : state) {
        const auto extractor = make_extractor(t.configuration.extraction);
        const auto filter = make_filter(params, 1, static_cast<int>(state.range(1)));
        Observation seen;
        landmarks = 0.0;
        for (std::size_t i = 0; i < scans; ++i) {
            extractor->extract(t.scans[i], seen);
            filter->step({t.scans[i], t.controls[i], seen});
            landmarks +=
                filter->best_count(FeatureKind::line) + filter->best_count(FeatureKind::corner);
        }
        benchmark::DoNotOptimize(filter->best_pose());
    }
    const auto total = static_cast<double>(state.iterations()) * static_cast<double>(scans);
    state.counters["scans/s"] = benchmark::Counter(total, benchmark::Counter::kIsRate);
    state.counters["us/scan"] =
        benchmark::Counter(total / 1e6, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    state.counters["ns/particle/landmark"] = benchmark::Counter(
        static_cast<double>(state.iterations()) * landmarks * params.particles / 1e9,
        benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// What the segments of lines cost in every step (noting) and once at the end (laying them out).
void segments(benchmark::State& state) {
    const Tour& t = tour();
    FilterParams params = t.configuration.filter;
    params.particles = 100;
    const auto extractor = make_extractor(t.configuration.extraction);
    double noting = 0.0;
    double laying_out = 0.0;
    for (auto _ : state) {
        const auto filter = make_filter(params, 1, 1);
        LineExtents extents;
        Observation seen;
        for (std::size_t i = 0; i < t.scans.size(); ++i) {
            extractor->extract(t.scans[i], seen);
            filter->step({t.scans[i], t.controls[i], seen});
            const auto begin = std::chrono::steady_clock::now();
            extents.note(*filter, seen);
            noting +=
                std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        }
        Trajectory path;
        for (const Pose& pose : filter->best_history()) path.push_back({0.0, pose});
        const LandmarkMap map = filter->best_map();
        const auto begin = std::chrono::steady_clock::now();
        benchmark::DoNotOptimize(extents.of(map, path));
        laying_out +=
            std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }
    const auto runs = static_cast<double>(state.iterations());
    state.counters["noting_us/scan"] = noting * 1e6 / runs / static_cast<double>(t.scans.size());
    state.counters["laying_out_ms"] = laying_out * 1e3 / runs;
}

/// Line and corner extraction alone.
void extraction(benchmark::State& state) {
    const Tour& t = tour();
    const auto extractor = make_extractor(t.configuration.extraction);
    Observation seen;
    std::size_t features = 0;
    for (auto _ : state) {
        for (const Scan& scan : t.scans) {
            extractor->extract(scan, seen);
            features += seen.lines.size() + seen.corners.size();
        }
    }
    const auto total =
        static_cast<double>(state.iterations()) * static_cast<double>(t.scans.size());
    state.counters["scans/s"] = benchmark::Counter(total, benchmark::Counter::kIsRate);
    state.counters["features/scan"] = static_cast<double>(features) / total;
}

/// From the compressed file to scans and odometry.
void reading(benchmark::State& state) {
    std::uint64_t scans = 0;
    for (auto _ : state) {
        Procesador reader(open_log(log_path()));
        while (reader.next_scan()) ++scans;
        while (reader.next_odometry()) {
        }
    }
    state.counters["scans/s"] =
        benchmark::Counter(static_cast<double>(scans), benchmark::Counter::kIsRate);
}

/// The step-by-step grid of the best path.
void grid(benchmark::State& state) {
    const Tour& t = tour();
    for (auto _ : state) {
        Grid map(t.configuration.grid);
        Pose pose;
        for (std::size_t i = 0; i < t.scans.size(); ++i) {
            for (const Control& c : t.controls[i]) {
                pose = compose(pose, displacement(c.twist, c.duration_s));
            }
            map.add(t.scans[i], pose);
        }
        benchmark::DoNotOptimize(map.log_odds(0, 0));
    }
    state.counters["scans/s"] = benchmark::Counter(
        static_cast<double>(state.iterations()) * static_cast<double>(t.scans.size()),
        benchmark::Counter::kIsRate);
}

BENCHMARK(extraction_and_filter)
    ->ArgNames({"particles", "threads", "scans"})
    ->Args({100, 1, 0})
    ->Args({1000, 1, 0})
    ->Args({10000, 1, 200})
    ->Args({1000, 1, 200})
    ->Args({1000, 2, 0})
    ->Args({10000, 2, 200})
    ->Args({100, 1, 300})  // against the whole tour: nothing grows with the scans
    ->Unit(benchmark::kMillisecond);
BENCHMARK(segments)->Unit(benchmark::kMillisecond);
BENCHMARK(extraction)->Unit(benchmark::kMillisecond);
BENCHMARK(reading)->Unit(benchmark::kMillisecond);
BENCHMARK(grid)->Unit(benchmark::kMillisecond);

}  // namespace
