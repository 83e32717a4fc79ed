// SPDX-License-Identifier: GPL-3.0-or-later
// From a scan to observed features [T ch. 4, 9.2.3].
#pragma once

#include <cstdint>
#include <memory>

#include "hitos/capture/scan.hpp"
#include "hitos/features/extraction_params.hpp"
#include "hitos/features/observation.hpp"

namespace hitos {

/// Finds features in a scan. Not thread-safe: it keeps working memory between calls.
class Extractor {
  public:
    virtual ~Extractor() = default;
    /// The scan that comes next is the one of this number, counted from 0; without, the one after
    /// the last. What is drawn at random is drawn by this number.
    virtual void go_to(std::uint64_t scan) = 0;
    /// Replaces the content of `out`.
    virtual void extract(const Scan& scan, Observation& out) = 0;
};

/// The extractor that the parameters ask for; a method that draws at random draws from `seed` and
/// the number of the scan. Throws ConfigError for values out of range.
std::unique_ptr<Extractor> make_extractor(const ExtractionParams& params, std::uint64_t seed = 1);

/// Whether another seed may give other features. Throws ConfigError where there is no such method.
bool draws_at_random(const ExtractionParams& params);

}  // namespace hitos
