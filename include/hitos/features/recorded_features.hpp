// SPDX-License-Identifier: GPL-3.0-or-later
// The features of a recorded tour, extracted once and handed to many runs.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <utility>

#include "hitos/capture/recorded_tour.hpp"
#include "hitos/features/extractor.hpp"

namespace hitos {

/// Scan by scan; immutable and so safe to share between threads.
using RecordedFeatures = std::deque<Observation>;

/// What the extractor finds in all scans of the tour; null where that may not grow so large.
std::shared_ptr<const RecordedFeatures> record_features(const RecordedTour& tour,
                                                        Extractor& extractor,
                                                        const MayGrow& may_grow);

/// Gives what the extractor gave, by the numbers of the scans, which must be those of the tour.
class RecordedExtractor final : public Extractor {
  public:
    explicit RecordedExtractor(std::shared_ptr<const RecordedFeatures> features)
        : features_(std::move(features)) {}
    void go_to(std::uint64_t scan) override { next_ = scan; }
    /// Throws std::logic_error for another scan.
    void extract(const Scan& scan, Observation& out) override;

  private:
    std::shared_ptr<const RecordedFeatures> features_;
    std::uint64_t next_ = 0;
};

}  // namespace hitos
