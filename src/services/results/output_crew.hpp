// SPDX-License-Identifier: GPL-3.0-or-later
// Several workers write what a run leaves on disk.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "run_outputs.hpp"

namespace hitos {

/// Writes outputs of a run side by side, which changes the time and never the files. What throws
/// is tried again alone: memory may suffice for it then.
class OutputCrew {
  public:
    /// Tells `told`, if anybody, of each of `count` outputs as it begins.
    OutputCrew(const FinishedRun& finished, std::filesystem::path folder,
               const WritingObserver& told, std::size_t count)
        : finished_(finished), folder_(std::move(folder)), told_(told), count_(count) {}

    /// Writes those, the essential ones first and one by one. Of each why its first file is
    /// missing, else an empty message. Throws what an essential one throws and what the observer
    /// throws. `threads` 0: as many as the machine has; never more than the memory of a few grids
    /// allows.
    std::vector<Message> write(std::span<const RunOutput* const> outputs, int threads);
    /// Processor time of each one's writing [s], in the order of what was written.
    const std::vector<double>& seconds() const { return seconds_; }

  private:
    enum class Attempt { first, last };
    void work_together(std::span<const RunOutput* const> outputs, int workers);
    void work(std::span<const RunOutput* const> outputs, Attempt attempt);
    /// Where the last attempt throws it leaves no file, and says why.
    void write_one(const RunOutput& output, std::size_t place, Attempt attempt);
    void write_timed(const RunOutput& output, std::size_t place);
    int workers(int threads) const;
    void tell(const RunOutput& output);

    const FinishedRun& finished_;
    std::filesystem::path folder_;
    const WritingObserver& told_;
    std::size_t count_;
    std::atomic<std::size_t> next_ = 0;
    std::atomic<bool> stopped_ = false;
    std::vector<Message> reasons_;  // each worker writes those of its own
    std::vector<char> failed_;      // likewise
    std::vector<double> seconds_;   // likewise

    std::mutex mutex_;  // guards all below
    std::size_t told_of_ = 0;
    std::exception_ptr broken_;
};

}  // namespace hitos
