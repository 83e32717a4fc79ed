// SPDX-License-Identifier: GPL-3.0-or-later
// What a place must show to be one of an earlier passage: docs/registration.md.
#pragma once

#include "hitos/registration/loop_record.hpp"

namespace hitos {

constexpr double kLeastLoopScore = 0.5;    // of the last metres' points
constexpr double kLeastLoopSpread = 0.03;  // of a corridor's matches along it
constexpr double kMostSeenThrough = 0.3;   // share of the points
// Where the graph says nothing of the place, for the robot may have been carried.
constexpr double kMostPieceThrough = 0.15;
constexpr double kLeastLikeness = 0.35;

/// How like two passages are, 0 … 1.
inline double likeness(const LoopRecord& loop) {
    return loop.score * loop.overlap * (1.0 - loop.seen_through.value_or(1.0));
}

}  // namespace hitos
