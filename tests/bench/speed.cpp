// SPDX-License-Identifier: GPL-3.0-or-later
// One workload of tests/bench/speed: its figures as lines `name value unit` on stdout.
//
// usage: bench_speed WORKLOAD [--particles N] [--threads N] [--landmarks N] [--warm SCANS]
//        [--scans N] [--steps N] [--seconds S] [--log FILE] [--count]

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <stdexcept>

#include "speed_workloads.hpp"

namespace {

using namespace speed;

constexpr std::string_view kWorkloads =
    "bigloop2, complex, intel, corners, pillars, points, kernels, ekf, reading, extraction, "
    "weights, grid, "
    "files";

Options options_of(std::span<char*> words) {
    Options options;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string_view word = words[i];
        if (word == "--count") {
            options.count = true;
            continue;
        }
        if (i + 1 == words.size()) throw std::runtime_error(fmt::format("{}: no value", word));
        const std::string value = words[++i];
        if (word == "--particles") {
            options.particles = std::stoi(value);
        } else if (word == "--threads") {
            options.threads = std::stoi(value);
        } else if (word == "--landmarks") {
            options.landmarks = std::stoi(value);
        } else if (word == "--warm") {
            options.warm = std::stoi(value);
        } else if (word == "--scans") {
            options.scans = std::stoi(value);
        } else if (word == "--steps") {
            options.steps = std::stoi(value);
        } else if (word == "--seconds") {
            options.seconds = std::stod(value);
        } else if (word == "--log") {
            options.log = value;
        } else {
            throw std::runtime_error(fmt::format("{}: no such option", word));
        }
    }
    return options;
}

void measure(std::string_view workload, const Options& options) {
    if (workload == "bigloop2" || workload == "complex" || workload == "intel") {
        measure_tour(read_tour(workload, options.log), options);
    } else if (workload == "corners") {
        measure_field(FieldKind::corners, options);
    } else if (workload == "pillars") {
        measure_field(FieldKind::pillars, options);
    } else if (workload == "points") {
        measure_points(options);
#ifndef HITOS_BASELINE
    } else if (workload == "kernels") {
        measure_kernels(options);
#endif
    } else if (workload == "ekf") {
        measure_ekf(options);
    } else if (workload == "reading") {
        measure_reading(options);
    } else if (workload == "extraction") {
        measure_extraction(read_tour("bigloop2", options.log), options);
    } else if (workload == "weights") {
        measure_weights(options);
    } else if (workload == "grid") {
        measure_grid(read_tour("bigloop2", options.log), options);
    } else if (workload == "files") {
        measure_files(read_tour("bigloop2", options.log), options);
    } else {
        throw std::runtime_error(
            fmt::format("found workload \"{}\", expected one of {}", workload, kWorkloads));
    }
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const std::span words(argv, static_cast<std::size_t>(argc));
        if (words.size() < 2) throw std::runtime_error(fmt::format("a workload of {}", kWorkloads));
        measure(words[1], options_of(words.subspan(2)));
    } catch (const std::exception& error) {
        fmt::print(stderr, "bench_speed: {}\n", error.what());
        return 1;
    }
    return 0;
}
