// SPDX-License-Identifier: GPL-3.0-or-later
// Runs, step by step or to the end.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "bindings.hpp"
#include "hitos/base/input_files.hpp"
#include "hitos/base/staged_folder.hpp"
#include "hitos/services/results/results.hpp"
#include "hitos/services/run/run_worker.hpp"
#include "snapshots.hpp"
#include "tours.hpp"

namespace hitos::python {

class Result;

/// A run, for one thread of Python at a time; its results may be asked by several, one after the
/// other. All functions want the interpreter's lock and let go of it while the run computes.
class Run : public std::enable_shared_from_this<Run> {
  public:
    Run(Configuracion configuration, References references, bool uncertainty);

    /// So many scans further, or to the end. `told` is called now and then with the progress;
    /// False stops the run. What Ctrl+C, `told` or the run itself raise is thrown when the run
    /// rests.
    void advance(std::uint64_t scans, const py::object& told);
    Progress progress() const;
    std::shared_ptr<State> snapshot();
    std::shared_ptr<Result> result();
    const Configuracion& configuration() const { return configuration_; }

    /// What summary.json says; the run must still be at this revision.
    std::string summary(std::uint64_t revision);
    /// Writes the results of the run as it is, `also` the files of these words
    /// (optional_outputs()).
    std::string write(std::uint64_t revision, StagedFolder& folder,
                      const std::vector<std::string>& also);
    /// The same into a folder that is kept for it when its turn has come.
    std::string write(std::uint64_t revision, const std::filesystem::path& folder,
                      const std::vector<std::string>& also);
    /// Kept for the results of this run, which may not take the place of what it reads.
    std::unique_ptr<StagedFolder> folder_for(const std::filesystem::path& path,
                                             const std::vector<std::string>& also) const;

  private:
    /// Refuses a second user while it lives.
    class Turn;
    /// Lets those who ask its results wait for each other.
    class Reading;
    std::shared_ptr<const Snapshot> newest_snapshot();
    void check_revision(std::uint64_t revision) const;

    Configuracion configuration_;
    References references_;
    InputFiles inputs_;
    std::shared_ptr<RunWorker> worker_;
    double seconds_ = 0.0;  // of wall time
    mutable std::atomic<bool> taken_ = false;
    std::timed_mutex reading_;
    std::atomic<std::thread::id> reader_{};
};

/// A run where it was left or has ended.
class Result : public State {
  public:
    Result(std::shared_ptr<Run> run, std::shared_ptr<const Snapshot> shown, bool finished,
           std::shared_ptr<const GridArray> grid, const std::vector<StepFigures>& figures);

    const std::shared_ptr<Run>& run() const { return run_; }
    const std::shared_ptr<const std::vector<FiguresRow>>& figures() const { return figures_; }

  private:
    std::shared_ptr<Run> run_;
    std::shared_ptr<const std::vector<FiguresRow>> figures_;
};

}  // namespace hitos::python
