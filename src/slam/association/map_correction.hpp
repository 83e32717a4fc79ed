// SPDX-License-Identifier: GPL-3.0-or-later
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

template <Sensor S>
KeptLandmark<S> kept_of(const typename S::Columns& landmarks, std::size_t i) {
    return {landmarks.get(i), landmarks.extent(i), landmarks.record(i)};
}

template <Sensor S>
void keep(typename S::Columns& landmarks, std::size_t i, const KeptLandmark<S>& kept) {
    landmarks.set(i, kept.estimate);
    landmarks.set_extent(i, kept.extent);
    landmarks.record(i) = kept.record;
}

/// Whether two landmarks whose errors are independent are one.
template <Sensor S>
bool same(const KeptLandmark<S>& a, const KeptLandmark<S>& b) {
    if (!may_be_one(a.record.identity, b.record.identity)) return false;
    const Matrix2 together =
        a.estimate.covariance +
        S::difference(a.estimate.mean, b.estimate.mean).turned(b.estimate.covariance);
    return S::same(a.estimate.mean, a.extent, b.estimate.mean, b.extent, together);
}

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
    kept.record.first_seen = std::min(kept.record.first_seen, other.record.first_seen);
    kept.record.existence = std::max(kept.record.existence, other.record.existence);
    kept.record.identity = std::max(kept.record.identity, other.record.identity);
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
        kept.push_back(kept_of<S>(landmarks, i));
        move(kept.back(), by_scan[kept.back().record.last_seen]);
    }
    landmarks.forget_index();
    std::vector<typename S::Glance> glances;
    glances.reserve(kept.size());
    const auto look = [](const KeptLandmark<S>& one) {
        return S::glance(one.estimate.mean, one.extent, one.estimate.covariance);
    };
    for (const KeptLandmark<S>& one : kept) glances.push_back(look(one));
    NewPlaces places(kept.size());
    std::vector<bool> gone(kept.size(), false);
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        if (gone[i]) continue;
        for (std::size_t j = i + 1; j < kept.size(); ++j) {
            if (gone[j] || S::differ(glances[i], glances[j]) || !same(kept[i], kept[j])) continue;
            fuse(kept[i], kept[j]);
            glances[i] = look(kept[i]);
            gone[j] = true;
            places[j] = next;
        }
        keep(landmarks, next, kept[i]);
        places[i] = next++;
    }
    landmarks.cut(next);
    return places;
}

/// Fuses the landmarks that have just been `seen` with others that they have grown to meet: those
/// that are the same and no further apart than `margin`. False where there are none.
template <Sensor S>
bool grow_together(typename S::Columns& landmarks, std::span<const std::uint32_t> seen,
                   double margin, NewPlaces& places) {
    std::vector<std::uint32_t> taken_by(landmarks.size());
    std::iota(taken_by.begin(), taken_by.end(), 0U);
    bool any = false;
    for (const std::uint32_t i : seen) {
        if (taken_by[i] != i) continue;
        KeptLandmark<S> kept = kept_of<S>(landmarks, i);
        bool grown = false;
        for (std::uint32_t j = 0; j < landmarks.size(); ++j) {
            if (j == i || taken_by[j] != j) continue;
            const KeptLandmark<S> other = kept_of<S>(landmarks, j);
            if (!same(kept, other) || kept.extent.gap(S::carried(other.extent, other.estimate.mean,
                                                                 kept.estimate.mean)) > margin) {
                continue;
            }
            fuse(kept, other);
            for (std::uint32_t& owner : taken_by) {
                if (owner == j) owner = i;
            }
            grown = any = true;
        }
        if (grown) keep(landmarks, i, kept);
    }
    if (!any) return false;
    NewPlaces left;
    landmarks.take_out([&](std::uint32_t i) { return taken_by[i] != i; }, left);
    places.clear();
    for (const std::uint32_t owner : taken_by) places.push_back(left[owner]);
    return true;
}

/// Makes associations point where the landmarks are now; `places` of all kinds in turn, as
/// best_map() lists them.
void follow(std::span<Association> associations, std::span<const NewPlaces> places,
            std::span<const std::size_t> sizes);

/// Throws std::invalid_argument where the correction is not of the scans that the filter has seen.
void check(const PathCorrection& correction, std::uint64_t steps);

}  // namespace hitos
