// SPDX-License-Identifier: GPL-3.0-or-later
// A run's state as bytes, for digests.
#pragma once

#include <span>
#include <string>

#include "hitos/services/run/run_state.hpp"

namespace hitos {

/// Adds values of types without padding, byte by byte.
template <class... Values>
void put(std::string& bytes, const Values&... values) {
    (bytes.append(reinterpret_cast<const char*>(&values), sizeof values), ...);
}

template <class Row>
void put_all(std::string& bytes, const Row& row) {
    for (const auto& one : row) put(bytes, one);
}

/// Poses and their times.
inline void put_path(std::string& bytes, std::span<const StampedPose> path) {
    for (const StampedPose& one : path) put(bytes, one.time_s, one.pose);
}

/// A figure that there is not as one that no figure is.
inline void put_loop(std::string& bytes, const LoopRecord& loop) {
    put(bytes, loop.scan, loop.earlier, loop.pose_earlier_scan, loop.way_m, loop.score,
        loop.overlap, loop.seen_through.value_or(-1.0), loop.chi_square.value_or(-1.0),
        loop.chi_square_limit.value_or(-1.0), loop.move_m, loop.weight.value_or(-1.0), loop.verdict,
        loop.by_hand, loop.refused_by ? loop.refused_by->scan : 0);
    if (loop.refused_by) put(bytes, loop.refused_by->earlier);
}

inline void put_hypotheses(std::string& bytes, const SlamFilter& filter) {
    for (const WeightedPose& one : filter.hypotheses())
        put(bytes, one.pose, one.weight, one.weight_before, one.from);
}

inline void put_landmarks(std::string& bytes, const LandmarkMap& map) {
    for (const ICaracteristica& one : map) {
        put(bytes, one.point(), one.covariance, one.observations, one.from_m, one.to_m,
            one.first_seen, one.last_seen, one.identity);
    }
}

/// With all that the filter takes of it.
inline void put_observation(std::string& bytes, const Observation& seen) {
    put_all(bytes, seen.lines);
    put_all(bytes, seen.corners);
    put_all(bytes, seen.support);
    put_all(bytes, seen.line_covariances);
    put_all(bytes, seen.corner_covariances);
    put_all(bytes, seen.identities);
    put_all(bytes, seen.circle_radii_m);
}

inline void put_told(std::string& bytes, const Scan& scan) {
    for (const LandmarkSighting& one : scan.landmarks)
        put(bytes, one.range_m, one.bearing_rad, one.identity);
}

}  // namespace hitos
