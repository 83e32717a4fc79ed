// SPDX-License-Identifier: GPL-3.0-or-later
// A place that looked like one of an earlier passage, and what became of it.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "hitos/base/geometry.hpp"
#include "hitos/base/message.hpp"

namespace hitos {

enum class LoopVerdict : std::uint8_t {
    closed,
    poor_fit,      ///< the points lie badly on the earlier walls
    bare,          ///< a direction is left open, as along a corridor
    seen_through,  ///< one passage looks through what the other saw
    alone,         ///< too few searches in a row have said the same yet
    no_edge,       ///< the scan alone says too little of any earlier one
    strained,      ///< the graph would be bent more than its edges explain
    by_hand,       ///< somebody has refused it
    // Of the way since the robot may have been carried:
    ambiguous,  ///< another place is nearly as like
    unlike      ///< too little alike where nothing else speaks for it
};
/// For files: "closed", "poor-fit" …
std::string_view word_of(LoopVerdict verdict);
/// Throws Error for another word.
LoopVerdict verdict_of(std::string_view word);

/// A loop by its scans.
struct NamedLoop {
    std::uint64_t scan = 0;
    std::uint64_t earlier = 0;
    friend bool operator==(const NamedLoop&, const NamedLoop&) = default;
};

/// Figures that come later than the reason why it was refused are not there.
struct LoopRecord {
    std::uint64_t scan = 0;     ///< at which it was found
    std::uint64_t earlier = 0;  ///< the scan of an earlier passage that it joins
    Pose pose_earlier_scan;     ///< of the former, seen from the latter, as it was matched
    double way_m = 0.0;         ///< driven from the earlier scan to the later one
    double score = 0.0;         ///< match_score() of the last metres' points
    double overlap = 0.0;       ///< share of these points that lie on a wall of the earlier passage
    /// The greater of the shares that one passage looks through of what the other saw.
    std::optional<double> seen_through;
    /// What closing it adds to the sum of the squared Mahalanobis distances of all other edges and
    /// its own.
    std::optional<double> chi_square;
    std::optional<double> chi_square_limit;  ///< beyond which it is strained
    double move_m = 0.0;                     ///< greatest correction of a key by it
    /// Once the tour is at its end: the mean of the robust weights that the edges from earlier
    /// passages to the scan have in the solution; 0 where none of them is left.
    std::optional<double> weight;
    LoopVerdict verdict = LoopVerdict::closed;
    bool by_hand = false;  ///< somebody has closed it
    /// Of one that somebody has refused: what the refusal names.
    std::optional<NamedLoop> refused_by;
};
/// For people: why it was closed or not, with the figure that decided.
Message reason_of(const LoopRecord& loop);

}  // namespace hitos
