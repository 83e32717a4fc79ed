// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "hitos/features/extractor.hpp"
#include "speed_workloads.hpp"

namespace speed {
namespace {

using namespace hitos;

/// A configuration of config/ without what the older release does not know: values for worlds, and
/// a motion model that takes its path from registration.
Configuracion configuration(const std::string& name) {
    const std::filesystem::path path =
        std::filesystem::path(HITOS_SOURCE_DIR) / "config" / (name + ".cfg");
    std::ifstream file(path);
    if (!file) throw std::runtime_error(fmt::format("{} is not there", path.string()));
    std::string text;
    bool taken = true;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with('[')) taken = line != "[source]";
        if (taken && !line.starts_with("model = \"registered\"")) text += line + '\n';
    }
    return ArchivoConfiguracion::parse(text, path.string());
}

/// Every scan with the controls before it.
template <class NextScan>
void fill(Tour& tour, NextScan next_scan, ControlTrack& track) {
    while (auto scan = next_scan()) {
        tour.scans.push_back(std::move(*scan));
        tour.controls.emplace_back();
        track.controls_until(tour.scans.back(), tour.controls.back());
    }
}

/// A recorded tour; with the thesis's noise on its odometry, or none.
void fill_from_log(Tour& tour, const std::string& log, double noise_level) {
    Procesador reader(open_log(log));
    OdometryNoise noise(noise_level, OdometryNoiseKind::relative_sigma, 1);
    ControlTrack track([&]() -> std::optional<Odometria> {
        auto reading = reader.next_odometry();
        if (reading) reading = noise(*reading);
        return reading;
    });
    fill(
        tour, [&] { return reader.next_scan(); }, track);
}

/// A world of data/worlds with the thesis's laser and noise.
void fill_from_world(Tour& tour, const std::string& name) {
    World world =
        read_world(std::filesystem::path(HITOS_SOURCE_DIR) / "data/worlds" / (name + ".toml"));
    set_world_value(world, "laser.sigma=0.003");
    const SimulatedTour simulated(world);
    OdometryNoise noise(0.1, OdometryNoiseKind::relative_sigma, 1);
    std::uint64_t reading = 0;
    std::uint64_t scan = 0;
    ControlTrack track([&]() -> std::optional<Odometria> {
        if (reading == simulated.readings()) return {};
        return noise(simulated.true_reading(reading++));
    });
    const auto next_scan = [&]() -> std::optional<Scan> {
        if (scan == simulated.scans()) return {};
        return simulated.scan(scan++);
    };
    fill(tour, next_scan, track);
}

}  // namespace

std::string log_of(std::string_view name, const std::string& log) {
    if (!log.empty()) return log;
    const std::filesystem::path shared(HITOS_SHARED_DIR);
    const std::filesystem::path path =
        shared / (name == "intel" ? "data/radish/intel.log.gz" : "data/player/bigloop2.log.gz");
    if (std::filesystem::exists(path)) return path.string();
    if (name == "intel") throw std::runtime_error(fmt::format("{} is not there", path.string()));
    return (std::filesystem::path(HITOS_SOURCE_DIR) / "data/bigloop.log.gz").string();
}

Tour read_tour(std::string_view name, const std::string& log) {
    Tour tour;
    tour.configuration = configuration(name == "intel" ? "recorded" : "thesis");
    if (name == "complex") {
        fill_from_world(tour, "complex");
    } else {
        fill_from_log(tour, log_of(name, log), name == "intel" ? 0.0 : 0.1);
    }
    if (name == "intel") take_proportional_motion(tour.configuration.filter);
    return tour;
}

void measure_tour(const Tour& tour, const Options& options) {
    const std::size_t first =
        std::min(static_cast<std::size_t>(options.warm), tour.scans.size() - 1);
    const std::size_t left = tour.scans.size() - first;
    const std::size_t count =
        options.scans == 0 ? left : std::min(static_cast<std::size_t>(options.scans), left);
    FilterParams params = tour.configuration.filter;
    params.particles = options.particles;
    const auto particles = static_cast<double>(options.particles);
    const auto scans = static_cast<double>(count);

    const auto extractor = make_extractor(tour.configuration.extraction);
    std::unique_ptr<SlamFilter> filter;
    Observation seen;
    std::size_t features = 0;
    const auto feed = [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            extractor->extract(tour.scans[i], seen);
            step(*filter, tour.scans[i], tour.controls[i], seen);
            features += seen.lines.size() + seen.corners.size();
        }
    };
    const auto prepare = [&] {
        filter.reset();
        filter = make_filter(params, 1, options.threads);
        feed(0, first);
        features = 0;
    };
    const auto work = [&] { feed(first, first + count); };

    if (options.count) {
        if (!can_count_memory()) return;
        start_counting_memory();
        prepare();
        const std::int64_t before = counted_memory().allocations;
        work();
        const MemoryCount memory = counted_memory();
        print("allocations_per_scan", static_cast<double>(memory.allocations - before) / scans,
              "1");
        print("peak_bytes_per_particle", static_cast<double>(memory.peak_bytes) / particles, "B");
        return;
    }
    const Cost cost = cheapest(options.seconds, prepare, work);
    print_per(cost, scans, "scan");
    print("scans_per_second", scans / cost.wall_s, "1/s");
    print("features_per_scan", static_cast<double>(features) / scans, "1");
    print("landmarks", landmarks(*filter), "1");
    print("scans", scans, "1");
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    print("peak_resident", static_cast<double>(usage.ru_maxrss) / 1024.0, "MiB");
}

}  // namespace speed
