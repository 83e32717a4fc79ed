// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the thesis's experiments that are shown by grid maps and counts.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "hitos/services/study/study.hpp"
#include "hitos/workbench/reproduction.hpp"
#include "hitos/workbench/thesis_experiments.hpp"

namespace hitos {

/// One experiment and what came out of it.
struct ReproducedExperiment {
    const ThesisExperiment* thesis = nullptr;
    StudyPlan plan;
    std::vector<StudyRecord> records;
    std::vector<StudyCell> cells;
    std::optional<double> odometry_blur_m2;  ///< of the odometry's grid, of experiments with maps
    std::string sheet_problem;  ///< why there is no contact sheet; empty where there is one
};

/// Time of a run against the number of particles.
struct ParticleTime {
    int particles = 0;
    double cpu_seconds = 0.0;
    std::uint64_t scans = 0;
};

/// What the reproduction of the thesis's maps found.
struct MapReproduction {
    std::vector<ReproducedExperiment> experiments;
    std::vector<std::string> left_out;  ///< experiments whose log is not there, with the reason
    std::vector<ParticleTime> times;    ///< where figure 10.95 is asked for
    std::size_t computed = 0;
    std::size_t reused = 0;
    std::vector<std::string> failures;
};

/// Whether a word of --only means one of the experiments.
bool names_experiment(const std::string& word);

/// Runs what is not yet done of the experiments that are named, and writes into the folder
/// reproduction-maps.md and .csv, a contact sheet for each (maps/), and where figure 10.95 is among
/// them time-against-particles.timing.csv, the one file that is not the same every time. Throws
/// what run_studies() throws, and StudyStopped.
MapReproduction reproduce_maps(const ReproductionOptions& options);

/// `sheets` is the folder of the contact sheets as seen from the document.
std::string map_reproduction_markdown(const MapReproduction& reproduction,
                                      const std::string& sheets);
std::string map_reproduction_csv(const MapReproduction& reproduction);

/// Writes the document and its sheets (beside it, in a folder of its stem).
void write_map_report(const MapReproduction& reproduction, const std::filesystem::path& document,
                      const std::filesystem::path& sheets);

}  // namespace hitos
