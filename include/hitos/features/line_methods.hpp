// SPDX-License-Identifier: GPL-3.0-or-later
// The methods that find lines in a scan [T 4.4, fig 9.7].
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "hitos/base/registry.hpp"
#include "hitos/capture/scan.hpp"
#include "hitos/features/extraction_params.hpp"
#include "hitos/features/observation.hpp"

namespace hitos {

/// The strategy that finds lines [T fig 9.7]. It may keep working memory between scans.
class MetodoExtraccionRectas {
  public:
    virtual ~MetodoExtraccionRectas() = default;
    /// The scan that comes next is the one of this number, counted from 0. A method whose lines
    /// depend on more than scan and parameters has to make them depend on this: runs go back.
    virtual void go_to(std::uint64_t /*scan*/) {}
    /// Appends the lines of the scan (robot frame, normal form) and their points to `out`, which is
    /// otherwise left alone. A scan of a closed fan comes cut open (capture/closed_scan.hpp), so
    /// that no wall goes on from its last point to its first where none has to.
    virtual void extract_lines(const Scan& scan, Observation& out) = 0;
    /// Whether its lines go through the first and last of their points whatever lies between: their
    /// covariance is then that of these two.
    virtual bool fits_end_points() const { return false; }
};

/// A line method as parameters name it.
struct LineMethodEntry : RegistryEntry {
    /// make_extractor() has checked the ranges.
    std::function<std::unique_ptr<MetodoExtraccionRectas>(const ExtractionParams&,
                                                          std::uint64_t seed)>
        make;
    /// Whether it draws at random, from the seed; where not, it is given the seed 0.
    bool random = true;
};

/// Those that the program knows, "split-merge" and "ransac" among them.
Registry<LineMethodEntry>& line_methods();

}  // namespace hitos
