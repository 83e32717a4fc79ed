// SPDX-License-Identifier: GPL-3.0-or-later
// What stays of a run that is over or was left: enough to look at it and to compare it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "hitos/registration/registration.hpp"
#include "hitos/services/configuration/configuracion.hpp"
#include "hitos/services/evaluation/run_loops.hpp"
#include "hitos/services/evaluation/run_measures.hpp"
#include "hitos/services/files/line_extents.hpp"
#include "hitos/services/files/trajectory_file.hpp"
#include "hitos/services/grid/grid_tiles.hpp"

namespace hitos {

/// A run as its folder has it.
struct KeptRun {
    Configuracion configuration;
    /// Of a tour that somebody has driven in the world of the configuration: which of those that
    /// the program knows; 0 of all others.
    std::uint64_t drive = 0;
    std::uint64_t scans = 0;
    bool finished = false;  ///< the tour is over, and what smooths the path has done it
    double seconds = 0.0;   ///< of wall time that its steps took
    LandmarkMap map;        ///< of the best hypothesis; from a folder without covariances
    std::vector<LineExtent> line_extents;
    Trajectory path;  ///< of the best hypothesis
    Trajectory odometry;
    GridTiles grid;                                  ///< empty where only the log could tell
    std::vector<RunLoop> loops = {};                 ///< of a folder, without their errors
    std::vector<SecondTour> later_tours = {};        ///< behind the first one; where each was found
    RunFigures figures = {};                         ///< of a folder those that its summary states
    std::vector<std::string> reference_doubts = {};  ///< likewise, in English
    /// By which the figures were measured since, for who asks again; null: none.
    std::shared_ptr<const Trajectory> reference = {};
};

/// A run from the folder that write_results() wrote, without its grid. Throws FileError where a
/// file of it is missing and FormatError where one is not what was written.
KeptRun read_results(const std::filesystem::path& folder);

/// Throws FormatError where one of the files that read_results() reads is not the one that the
/// folder's summary names, FileError where there is no summary.
void expect_results_unchanged(const std::filesystem::path& folder);

/// Whether both are of one tour.
bool same_tour(const KeptRun& a, const KeptRun& b);

/// Whether both are of one log or world, however its path is written and whether or not it is
/// there.
bool same_log(const Configuracion& a, const Configuracion& b);

/// The parameters in which two configurations differ, but for the log and what changes no result,
/// in the order of the table; those without effect in both are left out. Throws ConfigError where
/// their changes by hand are none.
std::vector<const ConfigParameter*> differences(const Configuracion& a, const Configuracion& b);

}  // namespace hitos
