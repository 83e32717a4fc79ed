// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the graph of graph-slam is sound.
#include <Eigen/Eigenvalues>
#include <cmath>

#include "landmark_graph.hpp"
#include "models/sound.hpp"

namespace hitos {
namespace {

bool is_finite(const Pose& pose) {
    return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.theta);
}
bool is_finite(const Point2& point) {
    return std::isfinite(point.x) && std::isfinite(point.y);
}

/// A corridor leaves a direction unknown, which nothing of a landmark may be.
template <class Matrix>
bool is_information(const Matrix& matrix, bool of_all_directions) {
    if (!matrix.allFinite()) return false;
    const double greatest = matrix.cwiseAbs().maxCoeff();
    if (!(matrix - matrix.transpose()).isZero(1e-6 * greatest)) return false;
    const double least =
        Eigen::SelfAdjointEigenSolver<Matrix>(matrix, Eigen::EigenvaluesOnly).eigenvalues()(0);
    return of_all_directions ? least > 0.0 : least >= -1e-6 * greatest;
}

/// Lists by owners of what names them: each one once, in order, with all that do.
class Lists {
  public:
    Lists(const char* kind, std::size_t count) : kind_(kind), listed_(count, 0) {}

    /// `names(i)`: whether it names the owner.
    template <class Names>
    void add(const char* owner, std::size_t number, std::span<const std::uint32_t> list,
             const Names& names) {
        for (std::size_t k = 0; k < list.size(); ++k) {
            const std::uint32_t i = list[k];
            expect_sound(i < listed_.size() && (k == 0 || list[k - 1] < i) && names(i),
                         "graph: {} {} lists {} {}, which is none of its own or out of order",
                         owner, number, kind_, i);
            ++listed_[i];
        }
    }
    void end(int owners) const {
        for (std::size_t i = 0; i < listed_.size(); ++i) {
            expect_sound(listed_[i] == owners,
                         "graph: {} {} is listed by {} of the {} that it names", kind_, i,
                         listed_[i], owners);
        }
    }

  private:
    const char* kind_;
    std::vector<int> listed_;
};

void check_edges(const LandmarkGraph& graph) {
    const std::vector<PoseEdge>& edges = graph.edges();
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const PoseEdge& edge = edges[i];
        expect_sound(edge.from != edge.to && std::max(edge.from, edge.to) < graph.keys().size(),
                     "graph: edge {} leads from key {} to key {} of {}", i, edge.from, edge.to,
                     graph.keys().size());
        expect_sound(is_finite(edge.z), "graph: edge {}: its motion is no number", i);
        expect_sound(is_information(edge.information, false),
                     "graph: edge {}: its information is not symmetric and positive", i);
    }
    Lists lists("edge", edges.size());
    for (std::size_t key = 0; key < graph.keys().size(); ++key) {
        lists.add("key", key, graph.edges_of(key),
                  [&](std::uint32_t i) { return edges[i].from == key || edges[i].to == key; });
    }
    lists.end(2);
}

void check_sightings(const LandmarkGraph& graph) {
    const std::vector<Sighting>& sightings = graph.sightings();
    for (std::size_t i = 0; i < sightings.size(); ++i) {
        const Sighting& sighting = sightings[i];
        expect_sound(
            sighting.key < graph.keys().size() && sighting.landmark < graph.landmarks().size(),
            "graph: sighting {} is of landmark {} of {} by key {} of {}", i, sighting.landmark,
            graph.landmarks().size(), sighting.key, graph.keys().size());
        expect_sound(sighting.z.allFinite() && is_finite(sighting.low) && is_finite(sighting.high),
                     "graph: sighting {}: what was seen is no number", i);
        expect_sound(is_information(sighting.information, true),
                     "graph: sighting {}: its information is not symmetric and positive definite",
                     i);
    }
    Lists by_key("sighting", sightings.size());
    for (std::size_t key = 0; key < graph.keys().size(); ++key) {
        by_key.add("key", key, graph.sightings_of(key),
                   [&](std::uint32_t i) { return sightings[i].key == key; });
    }
    by_key.end(1);
    Lists by_landmark("sighting", sightings.size());
    for (std::size_t k = 0; k < graph.landmarks().size(); ++k) {
        const GraphLandmark& landmark = graph.landmarks()[k];
        expect_sound(!landmark.sightings.empty(), "graph: landmark {} was never seen", k);
        by_landmark.add("landmark", k, landmark.sightings,
                        [&](std::uint32_t i) { return sightings[i].landmark == k; });
    }
    by_landmark.end(1);
}

}  // namespace

void check(const LandmarkGraph& graph) {
    for (std::size_t key = 0; key < graph.keys().size(); ++key) {
        expect_sound(is_finite(graph.keys()[key].pose), "graph: key {}: its pose is no number",
                     key);
    }
    for (std::size_t i = 0; i < graph.landmarks().size(); ++i) {
        const GraphLandmark& landmark = graph.landmarks()[i];
        expect_sound(is_finite(landmark.place.point) && std::isfinite(landmark.place.angle),
                     "graph: landmark {}: its place is no number", i);
        expect_sound(
            landmark.extent.low <= landmark.extent.high || landmark.kind != FeatureKind::line,
            "graph: landmark {}: it ends at {} before it begins at {}", i, landmark.extent.high,
            landmark.extent.low);
    }
    check_edges(graph);
    check_sightings(graph);
}

}  // namespace hitos
