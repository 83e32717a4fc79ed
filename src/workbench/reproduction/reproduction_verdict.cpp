// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a reproduced row is what the thesis says.
#include <fmt/format.h>

#include <cmath>

#include "hitos/workbench/reproduction.hpp"

namespace hitos {
namespace {

/// Mean figures over the rows of the working range.
struct Level {
    double error_m = 0.0;
    double landmarks = 0.0;
};

/// A row is harmed where it has no error figure, half as much error again as the working range
/// (and not just noise), or landmarks too many or too few.
bool harmed(const std::optional<double>& error, double landmarks, const Level& level) {
    constexpr double kFactor = 1.5;
    constexpr double kNoise = 0.05;
    constexpr double kLandmarks = 1.0;
    if (!error) return true;
    return *error > kFactor * level.error_m + kNoise ||
           std::abs(landmarks - level.landmarks) > kLandmarks;
}

template <class Error, class Landmarks>
Level level_of(const ReproducedFigure& figure, Error error, Landmarks landmarks) {
    Level level;
    int count = 0;
    for (const ReproducedRow& row : figure.rows) {
        if (!row.in_range || !error(row)) continue;
        level.error_m += *error(row);
        level.landmarks += landmarks(row);
        ++count;
    }
    if (count > 0) {
        level.error_m /= count;
        level.landmarks /= count;
    }
    return level;
}

std::optional<double> our_error(const ReproducedRow& row) {
    return row.error_m ? std::optional(row.error_m->mean) : std::nullopt;
}
double our_landmarks(const ReproducedRow& row) {
    return row.landmarks ? row.landmarks->mean : 0.0;
}

constexpr double kRounding = 1e-9;

/// Both ways, whichever side is the better one: a reproduction is to give the thesis's figures.
void compare(ReproducedRow& row) {
    const auto error = our_error(row);
    const auto& thesis = row.thesis.error_m;
    Verdict& verdict = row.verdict;
    verdict.error_near = error && thesis ? std::abs(*error - *thesis) <= kErrorMargin + kRounding
                                         : !error && !thesis;
    verdict.error_met = error && thesis && row.bare == 0
                            ? *error <= *thesis + kErrorMargin + kRounding
                            : !error && !thesis;
    verdict.landmarks_near =
        std::abs(our_landmarks(row) - row.thesis.landmarks) <= kLandmarkMargin + kRounding;
}

/// "as the thesis", or what differs from it and by how much.
std::string difference_words(const ReproducedRow& row) {
    std::string words;
    if (!row.verdict.error_near) {
        const auto error = our_error(row);
        if (error && row.thesis.error_m) {
            words = fmt::format("error {:+.3f} m", *error - *row.thesis.error_m);
        } else {
            words = error ? "landmarks where the thesis finds none" : "no landmarks";
        }
    }
    if (!row.verdict.landmarks_near) {
        words += fmt::format("{}landmarks {:+.1f}", words.empty() ? "" : "; ",
                             our_landmarks(row) - row.thesis.landmarks);
    }
    return words.empty() ? "as the thesis" : words;
}

void judge_inside(const ReproducedFigure& figure, ReproducedRow& row) {
    const double truth = figure.true_landmarks;
    const double off = our_landmarks(row) - truth;
    row.verdict.landmarks_met = std::abs(off) <= figure.tolerance + kRounding;
    row.verdict.thesis_landmarks_met =
        std::abs(row.thesis.landmarks - truth) <= figure.tolerance + kRounding;
    const auto error = our_error(row);
    std::string words;
    if (!error) {
        words = "no landmarks";
    } else if (!row.verdict.error_met) {
        words = fmt::format("error {:.3f} m too high",
                            *error - row.thesis.error_m.value_or(0.0) - kErrorMargin);
    }
    if (!row.verdict.landmarks_met) {
        words +=
            fmt::format("{}landmarks {:+.1f} from the true number", words.empty() ? "" : "; ", off);
    }
    row.verdict.words = words.empty() ? "met" : words;
}

}  // namespace

void judge(ReproducedFigure& figure) {
    const auto thesis_error = [](const ReproducedRow& row) { return row.thesis.error_m; };
    const auto thesis_landmarks = [](const ReproducedRow& row) { return row.thesis.landmarks; };
    const Level theirs = level_of(figure, thesis_error, thesis_landmarks);
    const Level ours = level_of(figure, our_error, our_landmarks);
    for (ReproducedRow& row : figure.rows) {
        row.verdict = {};
        if (row.finished == 0) {
            row.verdict.words = "every run failed";
            row.verdict.difference = "every run failed";
            continue;
        }
        compare(row);
        row.verdict.difference = difference_words(row);
        if (row.in_range) {
            judge_inside(figure, row);
            continue;
        }
        const bool harm = harmed(row.thesis.error_m, row.thesis.landmarks, theirs);
        const bool our_harm = harmed(our_error(row), our_landmarks(row), ours);
        row.verdict.same_tendency = harm == our_harm;
        if (harm) {
            row.verdict.words = our_harm ? "harms, as in the thesis" : "harms the thesis, not us";
        } else {
            row.verdict.words = our_harm ? "harms us, not the thesis" : "no harm, as in the thesis";
        }
    }
}

}  // namespace hitos
