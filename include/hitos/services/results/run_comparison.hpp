// SPDX-License-Identifier: GPL-3.0-or-later
// Finished runs side by side: in what they were set differently and what came of it.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "hitos/base/text_table.hpp"
#include "hitos/services/results/kept_run.hpp"

namespace hitos {

/// One of the runs that are compared.
struct ComparedRun {
    std::string name;  ///< of its folder, as far as it tells the runs apart
    std::filesystem::path folder;
    KeptRun run;
};

/// Runs side by side, and in what they differ.
struct RunComparison {
    std::vector<ComparedRun> runs;
    bool same_log = true;                          ///< by name
    std::vector<const ConfigParameter*> settings;  ///< in which any two differ, see differences()
    std::vector<const Measure*> figures;           ///< those that at least one run has
};

/// Reads the folders' runs. Throws what read_results() throws.
RunComparison compare_runs(std::span<const std::filesystem::path> folders);

/// A row a run: its name, its log where they differ, the settings that differ, the figures.
TextTable comparison_table(const RunComparison& comparison);

/// The same with every digit, as one JSON object: "runs", each with "folder", "log", "finished",
/// "settings" and "figures" (null where the run lacks one).
std::string comparison_json(const RunComparison& comparison);

}  // namespace hitos
