// What a place must show to be one of an earlier passage: docs/registration.md.
#pragma once

namespace hitos {

constexpr double kLeastLoopScore = 0.5;    // of the last metres' points
constexpr double kLeastLoopSpread = 0.03;  // of a corridor's matches along it
constexpr double kMostSeenThrough = 0.3;   // share of the points

}  // namespace hitos
