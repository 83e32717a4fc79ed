// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the synthetic experiments of thesis chapter 10 again and sets the outcome beside its
// figures.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "hitos/services/study/study.hpp"
#include "hitos/workbench/readings.hpp"
#include "hitos/workbench/thesis_figures.hpp"

namespace hitos {

/// Which of the thesis's figures are reproduced, and how.
struct ReproductionOptions {
    /// Figures and experiments by number, place or parameter; all where empty.
    std::vector<std::string> only;
    int runs = 5;     ///< of each value of the figures with errors, with seeds from 1
    int threads = 0;  ///< runs at a time; 0: as many as the machine has
    Reading reading = readings().front();
    /// Changes beside those of every reading: "key=value" of worlds and of configurations.
    std::vector<std::string> world;
    std::vector<std::string> settings;
    std::filesystem::path out;
    /// Folder of the recorded tours (NAME.log.gz, NAME.gt.tum.gz); empty: their experiments are
    /// left out.
    std::filesystem::path logs;
    StudyObserver observer;
    std::stop_token stop;  ///< ends it within a step; what is done stays done
};

/// How a row came out against what is asked of it.
struct Verdict {
    bool error_near = false;      ///< within kErrorMargin of the thesis's, or neither has an error
    bool landmarks_near = false;  ///< within kLandmarkMargin of the thesis's
    bool error_met = false;       ///< at most kErrorMargin above the thesis's
    bool landmarks_met = false;   ///< working range: near enough to the true number
    bool thesis_landmarks_met = false;  ///< whether the thesis's own figure is
    bool same_tendency = false;         ///< outside the range: harm or none, as in the thesis
    std::string difference;             ///< from the thesis's figures
    std::string words;                  ///< what became of what is asked
};

/// A row of a table of the thesis, and what the same setting gives here.
struct ReproducedRow {
    ThesisRow thesis;
    bool in_range = false;
    int finished = 0;
    int failed = 0;
    int bare = 0;                   ///< runs that found no landmark at all
    std::optional<Spread> error_m;  ///< over the runs that found some
    std::optional<Spread> landmarks;
    Verdict verdict;
};

/// A figure of the thesis with all of its rows.
struct ReproducedFigure {
    ThesisFigure thesis;
    int true_landmarks = 0;
    double tolerance = 0.0;  ///< of the number of landmarks
    std::vector<ReproducedRow> rows;
};

/// What a reproduction found.
struct Reproduction {
    Reading reading;
    std::vector<ReproducedFigure> figures;
    int runs = 0;
    std::size_t computed = 0;
    std::size_t reused = 0;
    std::vector<std::string> failures;
    std::string plot_problem;  ///< why there are no plots; empty where there are
};

/// How far from the thesis's error ours may lie [m], and from its number of landmarks.
constexpr double kErrorMargin = 0.05;
constexpr double kLandmarkMargin = 1.0;
/// Laser and odometry of the simulated tours: SPEC section 9.
constexpr double kReproductionLaserSigma = 0.003;
constexpr double kReproductionOdometryNoise = 0.1;

/// The figures that `only` names, in their order. Throws ConfigError where it names none.
std::vector<ThesisFigure> select_figures(const std::vector<ThesisFigure>& figures,
                                         const std::vector<std::string>& only);

/// Runs what is not yet done, and writes reproduction.csv, reproduction.md and plots/ into the
/// folder. Nothing written depends on threads or interruptions. Throws what run_studies() throws,
/// and StudyStopped.
Reproduction reproduce(const ReproductionOptions& options);

/// Runs the same figures under every other reading of readings(), each in readings/NAME of the
/// folder, with its reproduction.csv; those that agree best once more, with four times the runs,
/// after all others. Writes reproduction.md anew, with `result`, which reproduce() gave for the
/// same options, beside them. `begin` is told of each. Throws as reproduce().
std::vector<Reproduction> try_readings(const ReproductionOptions& options,
                                       const Reproduction& result,
                                       const std::function<void(const Reading&)>& begin);

/// Judges all rows of the figure.
void judge(ReproducedFigure& figure);

std::string reproduction_csv(const Reproduction& reproduction);
/// `plots` is the folder of the pictures as seen from the document; `tried` are other readings of
/// the same figures, for the table of readings.
std::string reproduction_markdown(const Reproduction& reproduction, const std::string& plots,
                                  std::span<const Reproduction> tried = {});
/// Draws every figure; gives the reason why there are no pictures, else an empty text.
std::string draw_reproduction(const Reproduction& reproduction,
                              const std::filesystem::path& folder);
/// Writes the document and its pictures (beside it, in a folder of its stem).
void write_report(const Reproduction& reproduction, const std::filesystem::path& document,
                  const std::filesystem::path& plots, std::span<const Reproduction> tried = {});

}  // namespace hitos
