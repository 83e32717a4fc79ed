// SPDX-License-Identifier: GPL-3.0-or-later
// What a run whose tour comes in while it is mapped has more than others: run --follow.
#pragma once

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "hitos/capture/live_source.hpp"
#include "hitos/services/configuration/configuracion.hpp"
#include "hitos/services/run/live_doubts.hpp"
#include "hitos/services/run/run_worker.hpp"
#include "pose_lines.hpp"
#include "progress_line.hpp"
#include "report.hpp"

namespace hitos::cli {

struct LiveOptions {
    bool follow = false;
    std::string received;  ///< what comes in is kept in; empty: beside the results
    double patience_s = std::chrono::duration<double>(LiveSource::kPatience).count();
    std::size_t opening = LiveSource::kOpeningScans;
    std::string poses;
};

void add_live_options(CLI::App& command, LiveOptions& options);

/// One run that follows. The worker's thread notes scans, the program's asks.
class LiveRun {
  public:
    /// Begins to follow `log`, or to keep what a server tells where it is the address of one, or
    /// what comes by standard input where it is "-"; nothing
    /// (file() is empty) where the program was asked to end before anything came. Throws FileError.
    LiveRun(const LiveOptions& options, const std::string& log, const std::string& out,
            bool replace);
    ~LiveRun();
    LiveRun(const LiveRun&) = delete;
    LiveRun& operator=(const LiveRun&) = delete;

    std::string file() const { return source_ ? source_->file().string() : std::string(); }
    /// Waits until the first scan may be taken, and says in the source how it is read. False where
    /// the program was asked to end before. Throws what open_log() throws.
    bool wait_for_opening(SourceParams& source);

    /// Throws FileError. Not before it is known to be none of what is read.
    void open_poses();
    /// What a connection has to say of itself.
    void tell_news(ProgressLine& line);
    /// Of every step, by the worker's thread.
    void note(const Algoritmo& run);
    /// By the program's thread, over and over: says what is to doubt as soon as it shows.
    void look(RunWorker& worker, ProgressLine& line);
    /// How far the run is behind what comes; nothing where no scan of what comes was taken yet.
    std::optional<double> behind_s() const;
    /// The same in words; empty where it is not.
    std::string behind() const;
    void tell(Report& report) const;
    /// There are results of all that was to come: what it was to replace goes.
    void replace_former();
    /// Where the run has failed: what becomes of what was received, and of what that was to
    /// replace. It is no longer waited for more.
    void tell_early_end();
    /// Why the tour ended before its time; nothing where it did not.
    std::optional<FileError> problem() const { return source_->problem(); }
    /// Why not all poses were written; nothing where they were.
    std::optional<std::string> poses_problem() const;
    void end() {
        if (source_) source_->end();
    }

  private:
    void put_pose(const Algoritmo& run, std::optional<double> latency_s);

    LiveOptions options_;
    std::unique_ptr<LiveSource> source_;
    bool received_ = false;  ///< and kept here; else the file is another program's
    std::optional<PoseLines> poses_;
    mutable std::mutex mutex_;
    std::vector<float> latencies_s_;  ///< of scans that came while it ran
    std::uint64_t steps_ = 0;
    bool asked_ = false;  ///< to end
    LiveDoubts doubts_;
    std::optional<std::string> poses_problem_;
    bool told_poses_ = false;
    bool told_problem_ = false;
    std::jthread watch_;  // last: it uses the source
};

}  // namespace hitos::cli
