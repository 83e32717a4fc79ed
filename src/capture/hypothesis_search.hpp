// SPDX-License-Identifier: GPL-3.0-or-later
// Looks for the hypothesis about a tour with which its scans fit best.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "hitos/capture/tour_examination.hpp"

namespace hitos {

using Hypothesis = TourExamination::Hypothesis;
/// The mean agreement with a hypothesis, 0 where there is none.
using Fit = TourExamination::Fit;

/// How much better than what the tour says another reading of it has to fit.
inline constexpr double kClearly = 0.06;
/// A scan of which less lies on its neighbour says nothing about where it was.
inline constexpr double kLeastFit = 0.4;
inline constexpr double kShortestDelay = 0.3;  // [s]

/// Where a few centimetres tell: over the way, or the turn, of a pair.
inline Hypothesis closely(Hypothesis hypothesis = {}) {
    hypothesis.near_m = 0.02;
    hypothesis.near_per_range = 0.005;
    return hypothesis;
}

/// The best of some hypotheses.
struct BestFit {
    Hypothesis hypothesis = {};
    double agreement = 0.0;

    void try_out(const Fit& fit, const Hypothesis& other) {
        const double found = fit(other, agreement);
        if (found <= agreement) return;
        hypothesis = other;
        agreement = found;
    }
};

/// Climbs from there, by steps to either side that are halved down to the finest:
/// `moves(hypothesis, step)` are the neighbours that are tried.
template <class Moves>
BestFit climbed(const Fit& fit, BestFit best, double step, double finest, const Moves& moves) {
    while (step > finest) {
        const BestFit from = best;
        for (const Hypothesis& other : moves(from.hypothesis, step)) best.try_out(fit, other);
        if (best.agreement <= from.agreement) step /= 2.0;
    }
    return best;
}

/// Of the offsets up to `most` to either side, in so many steps, the middle of those that fit as
/// well as the best: `at(offset)` is what is asked.
template <class At>
double middle_offset(const Fit& fit, double most, int steps, const At& at) {
    constexpr double kAsWell = 0.01;
    struct Asked {
        double offset;
        double fits;
    };
    std::vector<Asked> asked;
    double least = 0.0;
    for (int i = -steps; i <= steps; ++i) {
        const double offset = most * i / steps;
        asked.push_back({offset, fit(at(offset), least)});
        least = std::max(least, asked.back().fits - kAsWell);
    }
    double sum = 0.0;
    int count = 0;
    for (const Asked& one : asked) {
        if (one.fits < least) continue;
        sum += one.offset;
        ++count;
    }
    return sum / count;
}

/// The delay by which the scans fit best: of those that fit about as well, as on every lap of a
/// tour, the one nearest to `middle`, round which it is looked for.
BestFit best_delay(const Fit& fit, double middle);

/// All readings longer or shorter by the same, up to so many steps.
BestFit best_range_offset(const Fit& fit, const Hypothesis& as, double step_m, int steps);

/// The laser as it would fit best: turned, mirrored, or with rays over another angle than this
/// fan's.
BestFit best_mounting(const Fit& fit, const Fan& fan);

/// "0.25 s", "11.0 s".
std::string seconds_words(double seconds);

inline long percent(double share) {
    return std::lround(100.0 * share);
}

}  // namespace hitos
