// SPDX-License-Identifier: GPL-3.0-or-later
// The graph of graph-slam: key poses and landmarks, and what ties them to each other.
#pragma once

#include <span>
#include <vector>

#include "graph_landmark.hpp"
#include "hitos/registration/pose_algebra.hpp"
#include "hitos/registration/pose_graph.hpp"

namespace hitos {

/// Information of a pose that nothing ties [1/m^2, 1/rad^2].
inline constexpr double kUntiedInformation = 1e-6;

/// Poses of keys, landmarks, edges between keys and sightings of landmarks by keys. The first key
/// never moves: it holds the frame.
class LandmarkGraph {
  public:
    const std::vector<KeyPose>& keys() const { return keys_; }
    const std::vector<PoseEdge>& edges() const { return edges_; }
    const std::vector<GraphLandmark>& landmarks() const { return landmarks_; }
    const std::vector<Sighting>& sightings() const { return sightings_; }
    /// Indices into edges() and sightings() of those that have to do with a key.
    std::span<const std::uint32_t> edges_of(std::size_t key) const { return edges_of_[key]; }
    std::span<const std::uint32_t> sightings_of(std::size_t key) const {
        return sightings_of_[key];
    }

    void add_key(const KeyPose& key);
    void add_edges(std::span<const PoseEdge> edges);
    void replace_edges(std::span<const PoseEdge> edges);
    /// A landmark without sightings. Returns its index.
    /// Says which landmark it is, where nobody has.
    void name(std::uint32_t landmark, std::int32_t identity) {
        if (landmarks_[landmark].identity == kNameless) landmarks_[landmark].identity = identity;
    }
    std::uint32_t add_landmark(FeatureKind kind, const LandmarkPlace& place,
                               std::int32_t identity = kNameless);
    void add(const Sighting& sighting);
    /// Makes one landmark of each group: `leader[i]` is the landmark, not after i, that i becomes
    /// part of, or i itself. Their sightings are pooled. Returns what each landmark's index has
    /// become.
    std::vector<std::uint32_t> merge(std::span<const std::uint32_t> leader);

    /// Where everything is, to come back to.
    struct Places {
        std::vector<KeyPose> keys;
        std::vector<LandmarkPlace> landmarks;
    };
    Places places() const {
        Places places{keys_, {}};
        for (const GraphLandmark& landmark : landmarks_) places.landmarks.push_back(landmark.place);
        return places;
    }
    void restore(const Places& places) {
        keys_ = places.keys;
        for (std::size_t i = 0; i < landmarks_.size(); ++i) {
            landmarks_[i].place = places.landmarks[i];
        }
    }

    Pose& pose(std::size_t key) { return keys_[key].pose; }
    void move_landmark(std::size_t landmark, const Vector2& step) {
        move(landmarks_[landmark], step);
    }
    /// Moves it as a whole.
    void transform_landmark(std::size_t landmark, const Pose& motion);
    /// Measures a line's extent anew from its sightings, and takes its point to the middle.
    void remeasure(std::size_t landmark);

    SightingError error_of(const Sighting& sighting) const {
        return sighting_error(sighting.z, keys_[sighting.key].pose, landmarks_[sighting.landmark]);
    }
    /// Of the landmark's local coordinates, were all poses certain.
    Matrix2 covariance_given_poses(std::size_t landmark) const;
    int count(FeatureKind kind) const;

  private:
    /// What a sighting shows of a line, along the line.
    Extent extent_of(const Sighting& sighting, const LandmarkPlace& line) const;

    std::vector<KeyPose> keys_;
    std::vector<PoseEdge> edges_;
    std::vector<GraphLandmark> landmarks_;
    std::vector<Sighting> sightings_;
    std::vector<std::vector<std::uint32_t>> edges_of_;
    std::vector<std::vector<std::uint32_t>> sightings_of_;
};

/// Throws std::logic_error where a graph contradicts itself: an edge or sighting of what is not
/// there, lists of a key or landmark that are not those of its edges and sightings, what is no
/// number, information that is none.
void check(const LandmarkGraph& graph);

}  // namespace hitos
