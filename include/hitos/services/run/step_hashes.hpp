// SPDX-License-Identifier: GPL-3.0-or-later
// What a run is after every scan as hashes, part by part: where two runs differ, the first scan and
// part in which they do.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "hitos/services/run/algoritmo.hpp"

namespace hitos {

/// A table with one line a scan, and one for the state at the end of the tour: comma separated, RFC
/// 4180. Each part of the state has a column: 64 bits of its digest (XXH3) in hexadecimal. In the
/// order of the run loop: the pose by odometry, the scan, its features with their covariances,
/// registration's key poses and loops, all hypotheses with their weights, the landmarks of all of
/// them, the paths behind. Where two tables are the same, so is what the runs have made, to the
/// last bit; grids are not in it, which are drawn of scans and paths.
class StepHashes {
  public:
    StepHashes();
    /// Adds the state as it is; for AlgoritmoOptions::stepped. It takes time that grows with path,
    /// hypotheses and map.
    void note(const Algoritmo& run);
    const std::string& csv() const { return text_; }

  private:
    std::string text_;
};

/// Where two runs part.
struct StepDifference {
    std::string scan;  ///< its number, from 1; "end": after the last one
    std::string part;  ///< the first column that differs; "scan": one table ends before it
};

/// Of two tables of StepHashes; nothing where they are the same. Throws FormatError, with the name
/// and the line, where one of them is none.
std::optional<StepDifference> first_difference(std::string_view a, const std::string& name_a,
                                               std::string_view b, const std::string& name_b);

}  // namespace hitos
