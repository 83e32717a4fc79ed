// Several workers write what a run leaves on disk.
#pragma once

#include <atomic>
#include <exception>
#include <filesystem>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "run_outputs.hpp"

namespace hitos {

/// Writes outputs of a run side by side, which changes the time and never the files. What fails
/// is tried again alone: memory may suffice for it then.
class OutputCrew {
  public:
    OutputCrew(const FinishedRun& finished, std::filesystem::path folder,
               const WritingObserver& told)
        : finished_(finished), folder_(std::move(folder)), told_(told) {}

    /// Writes those of `outputs`, and tells of each as it begins. Of each why its first file is
    /// missing, else an empty message. Throws what an essential one throws, which are written first
    /// and one by one, and what the observer throws.
    std::vector<Message> write(std::span<const RunOutput* const> outputs, int threads);

  private:
    /// Whether nobody else worked.
    bool work_together(std::span<const RunOutput* const> outputs, int workers);
    void work(std::span<const RunOutput* const> outputs);
    void write_one(std::span<const RunOutput* const> outputs, std::size_t place);
    void tell(const RunOutput& output, std::size_t all);

    const FinishedRun& finished_;
    std::filesystem::path folder_;
    const WritingObserver& told_;
    std::atomic<std::size_t> next_ = 0;
    std::atomic<bool> stopped_ = false;
    std::vector<Message> reasons_;  // each worker writes those of its own
    std::vector<char> failed_;      // likewise: which threw

    std::mutex mutex_;  // guards all below
    std::size_t told_of_ = 0;
    std::exception_ptr broken_;
};

}  // namespace hitos
