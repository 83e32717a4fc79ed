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

/// Of how many poses of a path, or scans of a tour, a reference trajectory tells, and what.
struct ReferenceFit {
    std::size_t poses = 0;   ///< of several tours, those of the ones that the reference is of
    std::size_t common = 0;  ///< of these, with a pose of the reference at their stamp
    /// It is of another clock, another shape or another size: errors against it are none.
    std::optional<Advice> misfit = std::nullopt;
    /// It has no headings, or others: only errors of positions are any.
    std::optional<Advice> headings = std::nullopt;

    /// Whether it may call a loop false.
    bool judges_loops() const { return !misfit && !headings; }
    /// Those two, and that it tells of less than half of the poses.
    std::vector<Advice> doubts() const;
};

/// What there is to doubt of a reference trajectory whose poses tell of the path's:
/// - it has two places at one stamp;
/// - with its stamps a little later or earlier, up to a minute, it lies much nearer to the path;
/// - over pieces of ten metres, which even bad odometry bends little, it is a mirror image of the
///   path or of another size, or is nowhere like it and far from it as a whole too;
/// - its headings are all the same, or turn otherwise than both ways do.
/// Nothing of a path of a few metres.
ReferenceFit fit_of_path(const Trajectory& path, const Trajectory& reference,
                         double tolerance_s = kSameStamp);

/// The same. The poses are paired as trajectory_error() pairs them. Throws Error, with the times of
/// both, where fewer than three of the path's poses (or, of fewer, not all) have one of the
/// reference, where both share less than a tenth of the path's time (of several tours, one behind
/// the other, that of those that the reference is of, without what passed between them), or where
/// fewer than ten are paired and these are less than a tenth of what both have in that time: errors
/// would be figures of nothing.
ReferenceFit fit_of_reference(const Trajectory& path, const Trajectory& reference,
                              double tolerance_s = kSameStamp);
/// The same of a tour before it is run, by the path that its odometry tells: reads it anew, and
/// leaves it where it stands.
ReferenceFit fit_by_odometry(const TourReader& tour, const Trajectory& reference,
                             double tolerance_s = kSameStamp);
/// By the stamps of its scans alone: the rest a run's own path tells better.
ReferenceFit fit_of_reference(const TourReader& tour, const Trajectory& reference,
                              double tolerance_s = kSameStamp);

/// What there is to doubt of a reference map: less than half of the run's landmarks (of ten and
/// more less than four fifths) lie near one of it, or none is of a kind that it has. It is told
/// where they do once its angles are radians, its columns change places, it is in millimetres,
/// centimetres or feet, or a mirror image. Nothing where the run has no landmark.
std::optional<Advice> doubt_of_map(const LandmarkMap& map, const LandmarkMap& reference);

}  // namespace hitos
