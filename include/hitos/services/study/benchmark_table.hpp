// SPDX-License-Identifier: GPL-3.0-or-later
// The table of a benchmark: what it says, how it is written, and what has changed since another.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "hitos/base/text_table.hpp"
#include "hitos/services/evaluation/run_measures.hpp"
#include "hitos/services/study/study_result.hpp"

namespace hitos {

/// A line of the table: all runs of a tour by one algorithm, or what a peer made of it.
struct BenchmarkRow {
    std::string tour;
    std::string algorithm;
    bool peer = false;
    /// What was done to the tour before it was mapped, in words; nothing of earlier versions.
    std::optional<std::string> setting = "";
    int runs = 0;  ///< that have figures
    int failed = 0;
    std::optional<int> reference_landmarks;  ///< of the reference map
    ByMeasure<Spread> figures;
    double cpu_seconds = 0.0;            ///< of one run, in the mean; not reproducible
    double scans = 0.0;                  ///< of one run, in the mean
    std::optional<StageSeconds> stages;  ///< of one run, in the mean; parts of cpu_seconds
    double state_bytes = 0.0;            ///< that the state of a run took in the end, at the most
    /// Of all that its runs gave, bit by bit: figures and maps. Empty where one failed.
    std::string hash;
    std::string problem;        ///< why there is no figure, or why runs failed; else empty
    std::string remark;         ///< what there is to doubt; else empty
    std::filesystem::path map;  ///< picture of the first run's grid map; empty: none
};

/// What a benchmark found.
struct BenchmarkTable {
    std::string title;
    std::string program;  ///< build_identity() of what made it
    std::string version;
    std::string machine;  ///< processor, cores and system
    int runs = 0;
    std::uint64_t first_seed = 1;
    std::vector<BenchmarkRow> rows;  ///< by tours, in the plan's order
    bool stopped = false;            ///< before all was done
};

/// Writes benchmark.json, .csv, .md, .tex and .html, all of them or none, and where the truth is
/// known calibration.png and .svg; gives the reason where these cannot be drawn. Throws FileError.
Message write_benchmark(const BenchmarkTable& table, const std::filesystem::path& out);

/// The table as a row a row, with the digits that mean something; "m²", or for latex() "m^2".
TextTable benchmark_table(const BenchmarkTable& table, bool for_latex = false);
/// Where the time of a run went, and its memory, row by row; empty where no row tells.
TextTable benchmark_costs(const BenchmarkTable& table);
/// The same with every digit, as one JSON object.
std::string benchmark_json(const BenchmarkTable& table);
/// Reads what write_benchmark() wrote to that folder. Throws FileError and FormatError.
BenchmarkTable read_benchmark(const std::filesystem::path& out);

/// How a figure of a row has changed.
struct BenchmarkChange {
    enum class Verdict {
        same,      ///< the whole row, bit for bit
        within,    ///< no more than chance lets differ
        better,    ///< beyond that
        worse,     ///< beyond that
        unknown,   ///< of a single run nobody can tell
        gone,      ///< the row, or its figure, is not there any more
        appeared,  ///< it was not there before
        other      ///< another setting: another experiment
    };
    std::string tour;
    std::string algorithm;
    std::string measure;  ///< its word; empty: of the whole row
    Verdict verdict = Verdict::same;
    std::optional<double> before = {};  ///< means
    std::optional<double> after = {};
    std::optional<double> chance = {};  ///< that they lie so far apart or further by chance
};

/// Of errors, for which less is better, and of what has a value that it ought to have (landmarks as
/// many as the reference's, Measure::target), row by row. The chance is that of Welch's test of
/// both means ("The generalization of 'Student's' problem when several different population
/// variances are involved", Biometrika 34, 1947); what is better or worse has one so small that
/// among all figures that are judged not even one would look so by chance in 95 of 100 comparisons
/// (Holm, "A simple sequentially rejective multiple test procedure", Scandinavian Journal of
/// Statistics 6, 1979). Rows without spread, as those of algorithms that draw nothing at random,
/// change beyond rounding or not at all.
std::vector<BenchmarkChange> compare_benchmarks(const BenchmarkTable& before,
                                                const BenchmarkTable& after);
TextTable changes_table(const std::vector<BenchmarkChange>& changes);

}  // namespace hitos
