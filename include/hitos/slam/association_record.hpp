// SPDX-License-Identifier: GPL-3.0-or-later
// What an algorithm weighed when it took the features of a scan for what it did.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "hitos/slam/slam_filter.hpp"

namespace hitos {

/// How a landmark stood to an observed feature.
enum class Standing : std::uint8_t {
    candidate,  ///< likelier than p0, or inside the gate
    outside,    ///< not that
    elsewhere,  ///< not beside where the landmark was seen, or seen from its other side
    far         ///< passed over at a glance, since it could not be a candidate
};

/// A landmark and what an observation says against it, before any update by the scan.
struct ComparedLandmark {
    std::int32_t landmark = -1;  ///< place in the map after the scan, -1 where it is not there
    Eigen::Vector2d innovation = Eigen::Vector2d::Zero();  ///< z - h [m, rad]
    double mahalanobis_squared = 0.0;
    double log_likelihood = 0.0;
    Standing standing = Standing::candidate;
};

/// What became of a feature, and all landmarks that it was compared with.
struct RecordedFeature {
    Association decision;
    std::vector<ComparedLandmark> compared;
};

/// Filled by a step that is asked to (SlamInput::record), with the numbers that it went by. What
/// a correction by registration moves afterwards is not followed.
struct AssociationRecord {
    /// For every hypothesis, by its number before the resampling: the features of the scan, lines
    /// first, as SlamFilter::associations() lists those of the best.
    std::vector<std::vector<RecordedFeature>> hypotheses;
    std::size_t best = 0;  ///< of hypotheses
    /// Of the best, after the step. Fewer in its map are what a correction has made one since, and
    /// others may have other places.
    std::size_t landmarks = 0;
    std::optional<double> log_p0;    ///< ln of the likelihood of a new landmark, where one is used
    std::optional<double> gate;      ///< squared Mahalanobis distance of candidates, likewise
    std::optional<double> new_gate;  ///< and from which on a feature is of no landmark
};

}  // namespace hitos
