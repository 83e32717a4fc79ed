// SPDX-License-Identifier: GPL-3.0-or-later
#include "landmark_graph.hpp"

#include <Eigen/LU>

#include "hitos/registration/pose_graph_solver.hpp"

namespace hitos {

void LandmarkGraph::add_key(const KeyPose& key) {
    keys_.push_back(key);
    edges_of_.emplace_back();
    sightings_of_.emplace_back();
}

void LandmarkGraph::add_edges(std::span<const PoseEdge> edges) {
    for (const PoseEdge& edge : edges) {
        const auto index = static_cast<std::uint32_t>(edges_.size());
        edges_.push_back(edge);
        edges_of_[edge.from].push_back(index);
        edges_of_[edge.to].push_back(index);
    }
}

void LandmarkGraph::replace_edges(std::span<const PoseEdge> edges) {
    edges_.clear();
    for (auto& indices : edges_of_) indices.clear();
    add_edges(edges);
}

std::uint32_t LandmarkGraph::add_landmark(FeatureKind kind, const LandmarkPlace& place,
                                          std::int32_t identity) {
    landmarks_.push_back({kind, place, {}, {}, identity});
    return static_cast<std::uint32_t>(landmarks_.size() - 1);
}

void LandmarkGraph::add(const Sighting& sighting) {
    const auto index = static_cast<std::uint32_t>(sightings_.size());
    sightings_.push_back(sighting);
    sightings_of_[sighting.key].push_back(index);
    GraphLandmark& landmark = landmarks_[sighting.landmark];
    landmark.sightings.push_back(index);
    if (landmark.kind != FeatureKind::line) return;
    const Extent seen = extent_of(sighting, landmark.place);
    if (landmark.sightings.size() == 1) landmark.extent = seen;
    landmark.extent = landmark.extent.joined(seen);
}

Extent LandmarkGraph::extent_of(const Sighting& sighting, const LandmarkPlace& line) const {
    const Pose& pose = keys_[sighting.key].pose;
    return extent_along(line, transform(pose, sighting.low), transform(pose, sighting.high));
}

std::vector<std::uint32_t> LandmarkGraph::merge(std::span<const std::uint32_t> leader) {
    std::vector<std::uint32_t> now(landmarks_.size());
    std::vector<GraphLandmark> kept;
    for (std::size_t i = 0; i < landmarks_.size(); ++i) {
        if (leader[i] == i) {
            now[i] = static_cast<std::uint32_t>(kept.size());
            kept.push_back({landmarks_[i].kind,
                            landmarks_[i].place,
                            landmarks_[i].extent,
                            {},
                            landmarks_[i].identity});
        } else {
            now[i] = now[leader[i]];
            std::int32_t& identity = kept[now[i]].identity;
            identity = std::max(identity, landmarks_[i].identity);
        }
    }
    landmarks_ = std::move(kept);
    for (std::size_t i = 0; i < sightings_.size(); ++i) {
        sightings_[i].landmark = now[sightings_[i].landmark];
        landmarks_[sightings_[i].landmark].sightings.push_back(static_cast<std::uint32_t>(i));
    }
    for (std::size_t i = 0; i < landmarks_.size(); ++i) remeasure(i);
    return now;
}

void LandmarkGraph::transform_landmark(std::size_t landmark, const Pose& motion) {
    LandmarkPlace& place = landmarks_[landmark].place;
    place.point = transform(motion, place.point);
    place.angle = wrap_angle(place.angle + motion.theta);
}

void LandmarkGraph::remeasure(std::size_t index) {
    GraphLandmark& landmark = landmarks_[index];
    if (landmark.kind != FeatureKind::line || landmark.sightings.empty()) return;
    bool first = true;
    for (const std::uint32_t i : landmark.sightings) {
        const Extent seen = extent_of(sightings_[i], landmark.place);
        if (first) landmark.extent = seen;
        landmark.extent = landmark.extent.joined(seen);
        first = false;
    }
    const double middle = landmark.extent.middle();
    landmark.place.point.x -= middle * std::sin(landmark.place.angle);
    landmark.place.point.y += middle * std::cos(landmark.place.angle);
    landmark.extent = {landmark.extent.low - middle, landmark.extent.high - middle};
}

Matrix2 LandmarkGraph::covariance_given_poses(std::size_t landmark) const {
    Matrix2 information = Matrix2::Zero();
    for (const std::uint32_t i : landmarks_[landmark].sightings) {
        const Sighting& sighting = sightings_[i];
        const SightingError error = error_of(sighting);
        information += sighting.weight(error.value.dot(sighting.information * error.value)) *
                       error.by_landmark.transpose() * sighting.information * error.by_landmark;
    }
    return information.inverse();
}

int LandmarkGraph::count(FeatureKind kind) const {
    return static_cast<int>(std::ranges::count(landmarks_, kind, &GraphLandmark::kind));
}

}  // namespace hitos
