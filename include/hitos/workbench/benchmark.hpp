// SPDX-License-Identifier: GPL-3.0-or-later
// Benchmarks: tours by algorithms, each several times, as one table that anybody can make again.
#pragma once

#include <cstdint>
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "hitos/services/study/benchmark_table.hpp"
#include "hitos/services/study/study.hpp"
#include "hitos/simulation/worlds/odometry_noise.hpp"

namespace hitos {

/// By what a plan knows a tour: Digest::text() of its file, or of the names and contents of all
/// that it is read from, as of a recording in a folder. Throws FileError where one cannot be read.
std::string digest_of_tour(const std::filesystem::path& path);

/// A log or world to be mapped, and what its maps are measured against.
struct BenchmarkTour {
    std::string name;        ///< in the table; no other tour has it
    std::string file;        ///< a path, or the name of a world that comes with Hitos
    std::string map;         ///< reference map; empty: none
    std::string trajectory;  ///< reference path (TUM); empty: none, or a world's own
    std::string relations;   ///< between its poses (hitos/services/evaluation/relations.hpp)
    std::string digest;      ///< digest_of_tour(); empty: nobody says
    std::string address;     ///< where the file can be had; empty: nobody says
    double noise = 0.0;      ///< level of what is added to the odometry of each run
    OdometryNoiseKind noise_kind = OdometryNoiseKind::relative_sigma;
    int copies = 0;  ///< perturbed ones, that runs have instead of it in turn (set_study_copies())
    std::vector<std::string> settings;  ///< "key=value", over the algorithms'
};

/// A way to map it.
struct BenchmarkAlgorithm {
    std::string name;                   ///< in the table; no other one has it
    std::string preset = "auto";        ///< a word of presets(), or what suits the tour
    std::string config;                 ///< a file instead of the preset; empty: none
    std::vector<std::string> settings;  ///< "key=value"
};

/// What another program made of a tour: a row beside ours.
struct BenchmarkPeer {
    std::string name;
    std::string tour;        ///< the tour's name
    std::string trajectory;  ///< TUM
};

/// Tours by algorithms, as a plan's file has them.
struct BenchmarkPlan {
    std::string title;
    std::uint64_t first_seed = 1;
    int runs = 5;  ///< of every tour by every algorithm
    std::vector<BenchmarkTour> tours;
    std::vector<BenchmarkAlgorithm> algorithms;
    std::vector<BenchmarkPeer> peers;
};

/// The plan of a TOML file (docs/benchmark.md). Paths that are not absolute are looked for in
/// `tours`, where that is not empty, else and then from the plan's folder. Throws FileError, and
/// FormatError that names the line.
BenchmarkPlan read_benchmark_plan(const std::filesystem::path& path,
                                  const std::filesystem::path& tours = {});

/// The plans that come with Hitos, by name: "worlds" …
std::vector<std::string> shipped_benchmarks();
/// The path itself where it exists or is more than a bare name; else the plan of that name. Throws
/// FileError that lists their names where there is none.
std::filesystem::path find_benchmark(const std::string& name);

/// How a benchmark is done; nothing here changes its results.
struct BenchmarkOptions {
    std::filesystem::path out;
    int threads = 0;  ///< runs at a time; 0: as many as the machine has
    StudyShard shard;
    bool pictures = true;  ///< of each row's first run
    StudyObserver observer;
    std::stop_token stop;
};

/// Runs what is not yet done and gives the table. Runs are kept in `out`, as those of studies, so
/// that a benchmark that was stopped goes on where it was; of a shard the table is not whole. A
/// tour that cannot be read, or an algorithm that no run could have, is a row that says why. Throws
/// FileError for the output.
BenchmarkTable run_benchmark(const BenchmarkPlan& plan, const BenchmarkOptions& options);

}  // namespace hitos
