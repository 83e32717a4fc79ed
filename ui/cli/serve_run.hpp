// SPDX-License-Identifier: GPL-3.0-or-later
// run --serve: the run as it goes on, for browsers and Foxglove.
#pragma once

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "hitos/services/live/live_server.hpp"
#include "hitos/services/run/run_worker.hpp"

namespace hitos::cli {

void add_serve_option(CLI::App& command, std::string& address);

/// Asks the run for what is shown, where somebody looks and no oftener than it costs little: of the
/// run itself it changes nothing.
class ServeRun {
  public:
    /// `address` as the option has it. Says on standard error where it is. Throws ConfigError.
    ServeRun(const std::string& address, const std::string& log);

    /// By the program's thread, over and over, while the run goes on.
    void look(RunWorker& worker, std::optional<double> behind_s);
    /// Shows the state that the run has come to, to those too who come while files are written; the
    /// run rests.
    void look_at_end(RunWorker& worker);

  private:
    std::unique_ptr<LiveServer> server_;
    std::chrono::steady_clock::time_point due_;
    std::shared_ptr<const Snapshot> shown_;
};

}  // namespace hitos::cli
