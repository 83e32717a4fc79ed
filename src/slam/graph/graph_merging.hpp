// SPDX-License-Identifier: GPL-3.0-or-later
// Which landmarks of the graph have become one.
#pragma once

#include <optional>
#include <vector>

#include "landmark_graph.hpp"

namespace hitos {

/// How far the second of two landmarks is from the first, and the derivatives by the local
/// coordinates of both: of lines (place across [m], direction [rad]) in the middle between them, of
/// corners (x, y) [m].
struct PlaceDifference {
    Vector2 value;
    Matrix2 by_first;
    Matrix2 by_second;
};
PlaceDifference difference(const GraphLandmark& a, const GraphLandmark& b);

/// Whether two landmarks of a map that is not bent can be the same: of one kind, lines seen from
/// the same side that share a part, near each other. How sure they are does not matter.
bool may_be_one(const GraphLandmark& a, const GraphLandmark& b);

/// Whether a difference is too great for one landmark, whatever its covariance.
bool is_plain(const PlaceDifference& difference, FeatureKind kind);

/// Whether a difference of this covariance is none, by a chi-square gate. Two passages of one wall
/// differ by more than their covariances say, since walls are not straight to the millimetre and
/// the errors of a scan are not independent; and where the difference is not known to a few
/// decimetres nothing is said.
bool is_none(const PlaceDifference& difference, const Matrix2& covariance, FeatureKind kind,
             double gate);

/// The landmark that each landmark is to become part of, for LandmarkGraph::merge(); nothing where
/// all stay. `covariance(a, j_a, b, j_b)` is that of j_a a + j_b b. A landmark joins the first that
/// it may be one with.
template <class Covariance>
std::optional<std::vector<std::uint32_t>> find_duplicates(const LandmarkGraph& graph, double gate,
                                                          const Covariance& covariance) {
    const std::vector<GraphLandmark>& landmarks = graph.landmarks();
    std::vector<std::uint32_t> leader(landmarks.size());
    std::vector<std::int32_t> identity(landmarks.size());  // of a leader and those that joined it
    bool any = false;
    for (std::uint32_t b = 0; b < landmarks.size(); ++b) {
        leader[b] = b;
        identity[b] = landmarks[b].identity;
        for (std::uint32_t a = 0; a < b && leader[b] == b; ++a) {
            if (leader[a] != a || !may_be_one(identity[a], landmarks[b].identity) ||
                !may_be_one(landmarks[a], landmarks[b])) {
                continue;
            }
            const PlaceDifference apart = difference(landmarks[a], landmarks[b]);
            if (is_plain(apart, landmarks[a].kind)) continue;  // spares the covariance
            if (is_none(apart, covariance(a, apart.by_first, b, apart.by_second), landmarks[a].kind,
                        gate)) {
                leader[b] = a;
                identity[a] = std::max(identity[a], identity[b]);
                any = true;
            }
        }
    }
    if (!any) return std::nullopt;
    return leader;
}

}  // namespace hitos
