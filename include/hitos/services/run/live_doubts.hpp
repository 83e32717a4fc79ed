// SPDX-License-Identifier: GPL-3.0-or-later
// What there is to doubt about a tour, told while it comes in.
#pragma once

#include <cstdint>
#include <future>
#include <optional>
#include <utility>
#include <vector>

#include "hitos/capture/tour_examination.hpp"
#include "hitos/capture/tour_finding.hpp"
#include "hitos/services/run/run_worker.hpp"

namespace hitos {

/// Looks at the tour's examination after 100 scans, 200, 400 and so on, and where the run stands
/// still a quarter further. The run waits for nobody, and nobody for it.
class LiveDoubts {
  public:
    /// What was not told before; to be called over and over.
    std::vector<TourFinding> look(RunWorker& run);
    /// An answer is on its way, which the next look() may have.
    bool awaits() const { return looking_.valid() || weighing_.valid(); }

  private:
    bool is_due(const Progress& progress) const;
    /// Both as they were at one moment; nothing where the tour is not examined.
    using Evidence = std::pair<std::optional<TourExamination>, std::vector<TourFinding>>;

    std::uint64_t looked_at_ = 0;  ///< steps
    std::future<Evidence> looking_;
    std::future<std::vector<TourFinding>> weighing_;  ///< beside whoever looks
    std::vector<TourFinding::Kind> told_;
};

}  // namespace hitos
