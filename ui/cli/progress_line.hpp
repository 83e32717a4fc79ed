// SPDX-License-Identifier: GPL-3.0-or-later
// Progress of anything that lasts, on a terminal or in a log.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace hitos::cli {

/// " 37 %"; 100 is said of nothing but the whole.
std::string percent_text(double fraction);

/// On a terminal one line on stderr that is written over, ten times a second, with a bar, the rate
/// and the time left; elsewhere a plain line every ten seconds.
class ProgressLine {
  public:
    /// `unit` is what is counted, e.g. "scans".
    explicit ProgressLine(std::string_view unit);
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// `fraction` 0 … 1 where known; `detail` is appended.
    void show(std::uint64_t count, std::optional<double> fraction, const std::string& detail = {});
    /// Ends the line with its final state.
    void finish(std::uint64_t count, const std::string& detail = {});
    /// A line of its own on stderr, above the progress.
    void say(const std::string& message);
    double seconds() const;

  private:
    void print(std::uint64_t count, std::optional<double> fraction, const std::string& detail);

    std::string unit_;
    bool terminal_;
    bool open_ = false;
    std::chrono::steady_clock::time_point start_;
    std::chrono::steady_clock::time_point shown_;
};

}  // namespace hitos::cli
