// SPDX-License-Identifier: GPL-3.0-or-later
// What a finished run leaves on disk.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "hitos/base/message.hpp"
#include "hitos/base/staged_folder.hpp"
#include "hitos/services/drawing/paths_picture.hpp"
#include "hitos/services/evaluation/distances.hpp"
#include "hitos/services/evaluation/quality.hpp"
#include "hitos/services/evaluation/run_measures.hpp"
#include "hitos/services/grid/odometry_grid.hpp"
#include "hitos/services/results/run_times.hpp"
#include "hitos/services/run/algoritmo.hpp"

namespace hitos {

/// The version of the program, as in summaries and --version.
std::string version();

/// Of this very program: a digest of its sources, and the compiler with its flags. Where it is the
/// same, the same input gives the same results to the last bit.
std::string build_identity();

/// What to compare a run with.
struct References {
    std::optional<LandmarkMap> map;
    std::optional<Trajectory> trajectory;  ///< of the clock of the scans' stamps, in any frame
    std::vector<PoseRelation> relations;   ///< likewise of that clock; empty: none
    double tolerance_s = kSameStamp;       ///< of trajectory_error()
    std::vector<NamedDistance> distances;  ///< in the map's frame
    Walls walls;                           ///< true walls for pictures, in the map's frame
};

/// A file that a run could do without, and why it is missing.
struct NotWritten {
    std::string file;
    Message reason;
};

/// A file of a run as it was written.
struct WrittenFile {
    std::string name;
    std::uintmax_t bytes = 0;
    std::string digest;  ///< Digest::text() of its content

    bool operator==(const WrittenFile&) const = default;
};

/// The figures of a run, as summary.json states them.
struct RunSummary : RunErrors {
    std::string source;
    std::string format;  ///< as TourReader::format()
    std::uint64_t scans = 0;
    bool finished = false;  ///< the tour is over; else it was stopped after these scans
    double duration_s = 0.0;
    std::string algorithm;  ///< as in the configuration: "fastslam", "ekf-slam"
    int particles = 0;      ///< of FastSLAM; 0: the algorithm has none
    std::uint64_t seed = 0;
    std::optional<std::uint64_t> tour_seed;  ///< of a simulated tour's noise
    std::uint64_t searches_cut = 0;          ///< as FilterStatistics::searches_cut
    ReadReport report;
    RunFigures figures;
    std::optional<TrajectoryError> online_error;  ///< of Algoritmo::online_trajectory()
    std::vector<MeasuredDistance> distances;
    SuitabilityFigures suitability;
    std::vector<Advice> advice;
    RunQuality quality;
    std::vector<Advice> reference_doubts;  ///< of its warnings those about the references
    std::vector<NotWritten> not_written;
    std::vector<WrittenFile> files;  ///< by name; not the summary itself
    std::optional<RunTimes> times;   ///< where the run's stages were timed
};

/// Of the run's best map and best path.
RunErrors errors_of(const Algoritmo& run, const LandmarkMap& map, const Trajectory& path,
                    const References& references);

/// Once `stop` says so, what reads the tour again is left out.
RunSummary summarize(const Algoritmo& run, const References& references,
                     const std::function<bool()>& stop = {});

/// The summary as JSON text; units stand in the names. `seconds` is the wall time of the run.
std::string to_json(const RunSummary& summary, double seconds);

/// What was damaged in a log, as the summary states it under "log".
std::string to_json(const ReadReport& report);
/// Likewise a list of them.
std::string to_json(std::span<const TourFinding> findings);
/// Each as summary.json states it, closed or not.
std::string to_json(std::span<const RunLoop> loops);

/// Measured distances, as the summary states them under "distances".
std::string to_json(std::span<const MeasuredDistance> distances);

/// Makes the folder (and its parents) and makes sure that files can be written there. Throws
/// FileError, where it holds the results of a run too: they would not be what they were.
void prepare_output_folder(const std::filesystem::path& folder);

/// Whether a run may write a file of that name.
bool is_results_file(const std::string& name);

/// The name of a file in the folder that no run has left there, and that a run would write over
/// with the outputs that need no asking and those asked for by the words `also`.
std::optional<std::string> somebodys_file(const std::filesystem::path& folder,
                                          std::span<const std::string> also);

/// Files of a run that the same run would not write now, and what would ask for them.
struct UnaskedFiles {
    std::set<std::string> files;    ///< by name
    std::set<std::string> words;    ///< of outputs
    std::set<std::string> options;  ///< "--uncertainty", "--grid-of 3"
};
/// Those in the folder of a run that is asked for these outputs and given these options.
UnaskedFiles unasked_files(const std::filesystem::path& folder, std::span<const std::string> also,
                           std::span<const std::string> options);

/// Whether the folder has the results of a run that went on to its tour's end, as far as can be
/// known.
bool holds_finished_run(const std::filesystem::path& folder);

/// The folder of one run's results, kept for it: what is written there takes the place of an
/// earlier run's all at once, and other people's files in it stay. Throws FileError, so that a long
/// run does not end in vain.
StagedFolder results_folder(const std::filesystem::path& folder);

/// Which of the files of a run is being written.
struct WritingProgress {
    std::string file;        ///< the first of those that are written together
    std::size_t number = 0;  ///< from 1
    std::size_t count = 0;
};
/// Told before each, by one thread at a time, before the summary when all others are written; the
/// grids of long tours take their time.
using WritingObserver = std::function<void(const WritingProgress&)>;

/// Writes map.txt, segments.txt, map.dxf, trajectory.tum, trajectory_online.tum, odometry.tum,
/// grid_best_steps, grid_best
/// and grid_odometry (each as .png and .jpg), config.cfg and summary.json; distances.csv where
/// distances are given; paths.png and its script where a trajectory is given; odometry_scans.png
/// and its script where the true walls are known; uncertainty.csv, .png and their script where the
/// run recorded it. The summary names all others with their sizes and digests. They appear together
/// once all are written: whatever happens before, the folder is what it was. Map, trajectories and
/// configuration come first, and without them the run fails (FileError); of the others each may be
/// missing, and the summary says why. Several threads write, as many as the run has, up to three;
/// `ahead` may have the grid along the odometry; `also` are words of optional_outputs(), of which
/// the files are written too. Once `stop` says so, what reads the tour again is left out, as the
/// summary says. Returns the summary.
RunSummary write_results(const Algoritmo& run, const References& references, double seconds,
                         StagedFolder& folder, const WritingObserver& told = {},
                         OdometryGridAhead* ahead = nullptr, std::span<const std::string> also = {},
                         const std::function<bool()>& stop = {});
RunSummary write_results(const Algoritmo& run, const References& references, double seconds,
                         const std::filesystem::path& folder, const WritingObserver& told = {});

}  // namespace hitos
