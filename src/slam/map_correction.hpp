// What a correction of the path does to a map: its landmarks move along, and those that it lays
// upon each other become one.
#pragma once

#include <Eigen/LU>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "hitos/slam/slam_filter.hpp"
#include "models/ekf.hpp"
#include "models/landmark_columns.hpp"
#include "models/landmark_kinds.hpp"

namespace hitos {

/// A landmark with all that a map keeps of it.
template <Sensor S>
struct KeptLandmark {
    LandmarkEstimate<S> estimate;
    Extent extent;
    LandmarkRecord record;
};

/// Moves it with the world: mean and extent by the motion, P to J P J' with the motion's Jacobian.
template <Sensor S>
void move(KeptLandmark<S>& kept, const Pose& motion) {
    const typename S::Landmark before = kept.estimate.mean;
    const typename S::Landmark raw = S::moved(motion, before);
    const Matrix2 j = S::moved_jacobian(motion, before);
    kept.estimate = {raw, j * kept.estimate.covariance * j.transpose()};
    normalize(kept.estimate);
    kept.extent = S::carried(S::moved(motion, before, kept.extent), raw, kept.estimate.mean);
}

/// Makes one landmark of two whose errors are independent: mean and covariance weighted by their
/// information, the extents joined, the observations counted together.
template <Sensor S>
void fuse(KeptLandmark<S>& kept, const KeptLandmark<S>& other) {
    const typename S::Landmark before = kept.estimate.mean;
    const LandmarkDifference apart = S::difference(before, other.estimate.mean);
    const Matrix2& p = kept.estimate.covariance;
    const Matrix2 gain = p * (p + apart.turned(other.estimate.covariance)).inverse();
    Matrix2 fused = p - gain * p;
    fused(1, 0) = fused(0, 1) = 0.5 * (fused(0, 1) + fused(1, 0));
    kept.estimate = {S::from_state(S::to_state(before) - gain * apart.nu), fused};
    normalize(kept.estimate);
    kept.extent = S::carried(kept.extent, before, kept.estimate.mean)
                      .joined(S::carried(other.extent, other.estimate.mean, kept.estimate.mean));
    kept.record.observations += other.record.observations;
    kept.record.last_seen = std::max(kept.record.last_seen, other.record.last_seen);
}

/// Where the landmarks of a map are once some are gone: the new index of each.
using NewPlaces = std::vector<std::uint32_t>;

/// Moves every landmark of a kind by the motion of the scan that saw it last and fuses those that
/// are the same; a landmark that goes has the place of the one that took it in. The others keep
/// their order.
template <Sensor S>
NewPlaces correct_landmarks(typename S::Columns& landmarks, std::span<const Pose> by_scan) {
    std::vector<KeptLandmark<S>> kept;
    kept.reserve(landmarks.size());
    for (std::size_t i = 0; i < landmarks.size(); ++i) {
        kept.push_back({landmarks.get(i), landmarks.extent(i), landmarks.record(i)});
        move(kept.back(), by_scan[kept.back().record.last_seen]);
    }
    NewPlaces places(kept.size());
    std::vector<bool> gone(kept.size(), false);
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        if (gone[i]) continue;
        for (std::size_t j = i + 1; j < kept.size(); ++j) {
            const LandmarkEstimate<S>& a = kept[i].estimate;
            const LandmarkEstimate<S>& b = kept[j].estimate;
            if (gone[j]) continue;
            const Matrix2 together =
                a.covariance + S::difference(a.mean, b.mean).turned(b.covariance);
            if (!S::same(a.mean, kept[i].extent, b.mean, kept[j].extent, together)) continue;
            fuse(kept[i], kept[j]);
            gone[j] = true;
            places[j] = next;
        }
        landmarks.set(next, kept[i].estimate);
        landmarks.set_extent(next, kept[i].extent);
        landmarks.record(next) = kept[i].record;
        places[i] = next++;
    }
    landmarks.cut(next);
    return places;
}

/// Makes associations point where the landmarks are now; `places` of all kinds in turn, as
/// best_map() lists them.
void follow(std::span<Association> associations, std::span<const NewPlaces> places,
            std::span<const std::size_t> sizes);

/// Throws std::invalid_argument where the correction is not of the scans that the filter has seen.
void check(const PathCorrection& correction, std::uint64_t steps);

}  // namespace hitos
