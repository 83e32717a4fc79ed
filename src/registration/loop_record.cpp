// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/registration/loop_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "loop_limits.hpp"

namespace hitos {
namespace {

/// In the order of LoopVerdict.
constexpr std::array<std::string_view, 10> kVerdicts{
    "closed",  "poor-fit", "bare",    "seen-through", "alone",
    "no-edge", "strained", "by-hand", "ambiguous",    "unlike"};

/// With as many digits as tell it from the limit that it is beyond.
std::string apart(double value, double limit, int digits) {
    constexpr int kMostDigits = 6;
    const auto words = [&digits](double number) { return fmt::format("{:.{}f}", number, digits); };
    while (digits < kMostDigits && value != limit && words(value) == words(limit)) ++digits;
    return words(value);
}

std::string percent(double share, double limit) {
    return apart(100.0 * share, 100.0 * limit, 0) + " %";
}

std::string percent(double limit) {
    return fmt::format("{:.0f} %", 100.0 * limit);
}

}  // namespace

std::string_view word_of(LoopVerdict verdict) {
    return kVerdicts.at(static_cast<std::size_t>(verdict));
}

LoopVerdict verdict_of(std::string_view word) {
    const auto found = std::ranges::find(kVerdicts, word);
    if (found == kVerdicts.end()) {
        throw Error(message(HITOS_TEXT("Errors", "found the verdict %1 of a loop; expected %2"),
                            input::in_quotes(word), either(kVerdicts)));
    }
    return static_cast<LoopVerdict>(found - kVerdicts.begin());
}

Message reason_of(const LoopRecord& loop) {
    switch (loop.verdict) {
        case LoopVerdict::closed:
            return loop.by_hand
                       ? marked(HITOS_TEXT("Errors", "somebody has put it in"))
                       : marked(HITOS_TEXT("Errors", "the walls match, and the graph explains it"));
        case LoopVerdict::poor_fit:
            return message(HITOS_TEXT("Errors",
                                      "the points lie badly on the earlier walls: a score of %1, "
                                      "and more than %2 is asked"),
                           apart(loop.score, kLeastLoopScore, 2), kLeastLoopScore);
        case LoopVerdict::bare:
            return marked(HITOS_TEXT("Errors", "one direction is left open, as along a corridor"));
        case LoopVerdict::seen_through:
            return message(HITOS_TEXT("Errors",
                                      "one passage looks through %1 of what the other saw, and at "
                                      "most %2 is allowed"),
                           percent(loop.seen_through.value_or(1.0), kMostSeenThrough),
                           percent(kMostSeenThrough));
        case LoopVerdict::alone:
            return marked(HITOS_TEXT("Errors", "too few searches in a row have said the same yet"));
        case LoopVerdict::no_edge:
            return marked(
                HITOS_TEXT("Errors", "the scan alone says too little of any earlier one"));
        case LoopVerdict::by_hand:
            return marked(HITOS_TEXT("Errors", "somebody has taken it out"));
        case LoopVerdict::ambiguous:
            return marked(HITOS_TEXT("Errors", "another place looks nearly as like"));
        case LoopVerdict::unlike:
            return message(HITOS_TEXT("Errors",
                                      "the robot may have been carried, and for that the places "
                                      "are too little alike: %1 (score times overlap times what is "
                                      "not seen through), and more than %2 is asked; %3 is seen "
                                      "through, and at most %4 is allowed"),
                           apart(likeness(loop), kLeastLikeness, 2), kLeastLikeness,
                           percent(loop.seen_through.value_or(1.0), kMostPieceThrough),
                           percent(kMostPieceThrough));
        case LoopVerdict::strained:
            break;
    }
    return message(HITOS_TEXT("Errors",
                              "the graph would be bent more than its edges explain: chi-square %1, "
                              "and at most %2 is allowed"),
                   apart(loop.chi_square.value_or(0.0), loop.chi_square_limit.value_or(0.0), 0),
                   fmt::format("{:.0f}", loop.chi_square_limit.value_or(0.0)));
}

}  // namespace hitos
