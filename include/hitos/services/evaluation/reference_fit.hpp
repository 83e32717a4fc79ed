// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a reference is one of the run that is compared with it.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "hitos/services/evaluation/measures.hpp"
#include "hitos/services/evaluation/suitability.hpp"

namespace hitos {

class TourReader;

/// Of how many poses of a path, or scans of a tour, a reference trajectory tells.
struct ReferenceFit {
    std::size_t poses = 0;
    std::size_t common = 0;  ///< of these, with a pose of the reference at their stamp

    /// What there is to doubt where that is less than half of them.
    std::optional<Advice> doubt() const;
};

/// The poses are paired as trajectory_error() pairs them. Throws Error, with the times of both,
/// where fewer than three of the path's poses (or, of fewer, not all) have one of the reference,
/// where both share less than a tenth of the path's time, or where fewer than ten are paired and
/// these are less than a tenth of what both have in that time: errors would be figures of nothing.
ReferenceFit fit_of_reference(const Trajectory& path, const Trajectory& reference,
                              double tolerance_s = kSameStamp);
/// The same of a tour before it is run: reads the stamps of its scans anew, and leaves it where it
/// stands.
ReferenceFit fit_of_reference(const TourReader& tour, const Trajectory& reference,
                              double tolerance_s = kSameStamp);

/// What there is to doubt of a reference map: less than half of the run's landmarks lie near one of
/// it, or none is of a kind that it has. Nothing where the run has no landmark.
std::optional<Advice> doubt_of_map(const LandmarkMap& map, const LandmarkMap& reference);

}  // namespace hitos
