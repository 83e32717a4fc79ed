// SPDX-License-Identifier: GPL-3.0-or-later
// The stages around the filter, each alone.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include "hitos/features/extractor.hpp"
#include "speed_workloads.hpp"

namespace speed {
namespace {

using namespace hitos;

/// Bytes of a log's text; those of a compressed one stand in its last four bytes.
double text_bytes(const std::string& path) {
    if (!path.ends_with(".gz")) return static_cast<double>(std::filesystem::file_size(path));
    std::ifstream file(path, std::ios::binary);
    file.seekg(-4, std::ios::end);
    std::uint32_t size = 0;
    for (unsigned shift = 0; shift < 32; shift += 8) {
        size |= static_cast<std::uint32_t>(file.get() & 0xff) << shift;
    }
    return size;
}

std::vector<Pose> odometry_path(const Tour& tour) {
    std::vector<Pose> path;
    Pose pose;
    for (const std::vector<Control>& controls : tour.controls) {
        for (const Control& c : controls) pose = compose(pose, displacement(c.twist, c.duration_s));
        path.push_back(pose);
    }
    return path;
}

}  // namespace

void measure_reading(const Options& options) {
    const std::string log = log_of("bigloop2", options.log);
    std::uint64_t scans = 0;
    const auto work = [&] {
        scans = 0;
        Procesador reader(open_log(log));
        while (reader.next_scan()) ++scans;
        while (reader.next_odometry()) {
        }
    };
    const Cost cost = cheapest(
        options.seconds, [] {}, work);
    print_per(cost, static_cast<double>(scans), "scan");
    print("text", text_bytes(log) / 1e6, "MB");
    print("scans", static_cast<double>(scans), "1");
}

void measure_extraction(const Tour& tour, const Options& options) {
    const auto extractor = make_extractor(tour.configuration.extraction);
    Observation seen;
    std::size_t features = 0;
    const auto work = [&] {
        features = 0;
        for (const Scan& scan : tour.scans) {
            extractor->extract(scan, seen);
            features += seen.lines.size() + seen.corners.size();
        }
    };
    const auto scans = static_cast<double>(tour.scans.size());
    print_per(cheapest(
                  options.seconds, [] {}, work),
              scans, "scan");
    print("features_per_scan", static_cast<double>(features) / scans, "1");
}

void measure_weights(const Options& options) {
    std::mt19937 engine(7);
    std::normal_distribution<double> draw(-20.0, 3.0);
    std::vector<double> logs(static_cast<std::size_t>(options.particles));
    for (double& value : logs) value = draw(engine);
    std::vector<double> weights;
    double neff = 0.0;
    constexpr int kTimes = 100;
    const auto weigh = [&] {
        for (int i = 0; i < kTimes; ++i) {
            normalize_log_weights(logs, weights);
            neff += effective_particles(weights);
        }
    };
    Selection selection;
    std::uint64_t count = 0;
    const auto select = [&] {
        for (int i = 0; i < kTimes; ++i) selection.select(weights, ++count);
    };
    const double parts = static_cast<double>(options.particles) * kTimes;
    print_per(cheapest(
                  options.seconds / 2.0, [] {}, weigh),
              parts, "weight");
    print_per(cheapest(
                  options.seconds / 2.0, [] {}, select),
              parts, "selection");
    keep(neff);
    keep(selection.selected());
}

void measure_grid(const Tour& tour, const Options& options) {
    const std::vector<Pose> path = odometry_path(tour);
    Grid grid(tour.configuration.grid);
    const auto work = [&] {
        for (std::size_t i = 0; i < path.size(); ++i) grid.add(tour.scans[i], path[i]);
    };
    const Cost cost = cheapest(
        options.seconds, [&] { grid = Grid(tour.configuration.grid); }, work);
    print_per(cost, static_cast<double>(path.size()), "scan");
    print("cells", static_cast<double>(grid.columns()) * grid.rows(), "1");
}

void measure_files(const Tour& tour, const Options& options) {
    const std::vector<Pose> path = odometry_path(tour);
    Trajectory trajectory;
    Grid grid(tour.configuration.grid);
    for (std::size_t i = 0; i < path.size(); ++i) {
        trajectory.push_back({tour.scans[i].time_s, path[i]});
        grid.add(tour.scans[i], path[i]);
    }
    LandmarkMap map;
    for (int i = 0; i < options.landmarks; ++i) {
        ICaracteristica landmark;
        const double place = std::sqrt(2.0 + i);
        if (i % 2 == 0) {
            landmark.value = Recta{place, std::sin(place)};
        } else {
            landmark.value = Esquina{place, std::cos(place)};
        }
        map.push_back(landmark);
    }
    std::size_t bytes = 0;
    const auto share = [&](std::string_view part, double count, const std::function<void()>& work) {
        print_per(cheapest(
                      options.seconds / 3.0, [] {}, work),
                  count, part);
    };
    share("landmark", options.landmarks, [&] { bytes += map_to_text(map).size(); });
    share("pose", static_cast<double>(path.size()),
          [&] { bytes += trajectory_to_text(trajectory).size(); });
    share("picture", 1.0, [&] { bytes += encode_picture(grid, PictureStyle{}, "png").size(); });
    keep(bytes);
}

}  // namespace speed
