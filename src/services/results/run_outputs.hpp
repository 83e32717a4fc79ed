// SPDX-License-Identifier: GPL-3.0-or-later
// The table of what a finished run leaves on disk.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "hitos/base/message.hpp"
#include "hitos/services/results/results.hpp"

namespace hitos {

/// A run with what several of its files are made of.
struct FinishedRun {
    const Algoritmo& run;
    const References& references;
    const RunSummary& summary;
    Configuracion configuration;  ///< as written_configuration() has it
    Trajectory best;
    LandmarkMap map;
    std::vector<LineExtent> segments;  ///< of the map's lines
    OdometryGridAhead* odometry_grid = nullptr;
    std::span<const std::string> also = {};  ///< words of outputs that are asked for
    std::function<bool()> stop = {};         ///< whether to end soon; null: never
    std::filesystem::path folder = {};       ///< in which the files are in the end

    bool stopped() const { return stop && stop(); }
};

/// A run's configuration for a file: its changes by hand have the stamps and marks of their scans,
/// so that no other tour takes them. `best` is its path.
Configuracion written_configuration(const Algoritmo& run, const Trajectory& best);

/// A file of a run, or several that belong together.
struct RunOutput {
    /// In a name: where the number of the particle stands whose grid is asked for.
    static constexpr char kNumber = '#';

    std::vector<std::string> names;  ///< of its files, the one that people look at first
    /// Writes into the folder. Returns why the first of the files is missing, else an empty
    /// message. Throws Error.
    std::function<Message(const FinishedRun&, const std::filesystem::path& folder)> write;
    /// Whether there is something to write; null: always.
    std::function<bool(const FinishedRun&)> wanted = {};
    bool essential = false;  ///< whether the run fails without it
    bool rereads = false;    ///< it reads the tour again, and is left out where the run is to end
    /// By which it is asked for, and half a sentence for help texts; empty: it needs no asking.
    std::string word = {};
    std::string purpose = {};
    /// Likewise the option without which there is nothing to write; a number's is kNumber too.
    std::string option = {};

    /// The names of the files of this run.
    std::vector<std::string> files(const FinishedRun& finished) const;
    /// Whether it writes a file of that name, of any run.
    bool owns(const std::string& file) const;
    /// The option by which it writes that file, which it owns; empty: none.
    std::string option_of(const std::string& file) const;
};

/// In the order in which they are written, the essential ones first; summary.json, which comes
/// last, is not among them.
const std::vector<RunOutput>& run_outputs();

/// Why an output that takes long is missing where the run is to end.
Message left_out();

/// Whether one of them writes a file of that name, of any run.
bool is_run_output(const std::string& name);

}  // namespace hitos
