// SPDX-License-Identifier: GPL-3.0-or-later
#include "reproduction_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hitos {
namespace {

/// The probability that two means, each of as many runs with the scatter that the row states, lie
/// within the margin of each other where the true means are one.
double chance_near(const ReproducedRow& row) {
    constexpr int kThesisRuns = 5;  // [T 10.3]
    const Spread& ours = *row.error_m;
    const double variance =
        row.thesis.error_variance / kThesisRuns +
        ours.variance.value_or(row.thesis.error_variance) / std::max(row.finished - row.bare, 1);
    return variance > 0.0 ? std::erf(kErrorMargin / std::sqrt(2.0 * variance)) : 1.0;
}

std::string parameter_of(const ReproducedFigure& figure) {
    return figure.thesis.table->parameter;
}
std::string world_of(const ReproducedFigure& figure) {
    return figure.thesis.world;
}

std::string summary_table(const Reproduction& reproduction, const char* title,
                          const std::function<std::string(const ReproducedFigure&)>& name) {
    std::vector<std::string> names;
    for (const ReproducedFigure& figure : reproduction.figures) {
        if (std::ranges::find(names, name(figure)) == names.end()) names.push_back(name(figure));
    }
    std::string text = fmt::format(
        "| {} | rows in the working range | error within ±{} m | number within {} | both | at "
        "least "
        "as good | mean error thesis → Hitos (m) | true number (thesis's own) | all rows: error, "
        "number | same tendency outside |\n|---|---|---|---|---|---|---|---|---|---|\n",
        title, kErrorMargin, kLandmarkMargin);
    for (const std::string& key : names) {
        const Agreement inside = sum_up(reproduction, [&](const auto& figure, const auto& row) {
            return row.in_range && name(figure) == key;
        });
        const Agreement all = sum_up(
            reproduction, [&](const auto& figure, const auto&) { return name(figure) == key; });
        text += fmt::format(
            "| {} | {} | {} | {} | {} | {} | {:.3f} → {:.3f} | {} ({}) | {}, {} of {} | {} of {} "
            "|\n",
            key, inside.rows, inside.error_near, inside.landmarks_near, inside.both_near,
            inside.at_least, inside.mean_thesis_m(), inside.mean_ours_m(), inside.truth_met,
            inside.thesis_truth_met, all.error_near, all.landmarks_near, all.rows,
            all.same_tendency, all.tendency_asked);
    }
    return text + "\n";
}

}  // namespace

void Agreement::add(const ReproducedRow& row) {
    const Verdict& verdict = row.verdict;
    ++rows;
    error_near += verdict.error_near ? 1 : 0;
    landmarks_near += verdict.landmarks_near ? 1 : 0;
    both_near += verdict.error_near && verdict.landmarks_near ? 1 : 0;
    at_least += verdict.error_met ? 1 : 0;
    if (row.in_range) {
        truth_met += verdict.landmarks_met ? 1 : 0;
        thesis_truth_met += verdict.thesis_landmarks_met ? 1 : 0;
    } else {
        ++tendency_asked;
        same_tendency += verdict.same_tendency ? 1 : 0;
    }
    if (row.landmarks && !verdict.landmarks_near) {
        ++(row.landmarks->mean < row.thesis.landmarks ? fewer : more);
    }
    if (!row.error_m || !row.thesis.error_m) return;
    ++compared;
    thesis_m += *row.thesis.error_m;
    ours_m += row.error_m->mean;
    expected_near += chance_near(row);
    if (!verdict.error_near) ++(row.error_m->mean < *row.thesis.error_m ? below : above);
}

Agreement sum_up(const Reproduction& reproduction, const RowFilter& wanted) {
    Agreement sum;
    for (const ReproducedFigure& figure : reproduction.figures) {
        for (const ReproducedRow& row : figure.rows) {
            if (wanted(figure, row)) sum.add(row);
        }
    }
    return sum;
}

bool in_range(const ReproducedFigure& /*figure*/, const ReproducedRow& row) {
    return row.in_range;
}
bool any_row(const ReproducedFigure& /*figure*/, const ReproducedRow& /*row*/) {
    return true;
}

std::string summary_text(const Reproduction& reproduction) {
    const Agreement inside = sum_up(reproduction, in_range);
    const Agreement all = sum_up(reproduction, any_row);
    std::string text = fmt::format(
        "* {} figures, {} rows, {} runs of each.\n"
        "* **As the thesis has it, on both sides.** Working range, {} rows: error within ±{} m of "
        "the thesis's in **{}**, number of landmarks within {} of the thesis's in **{}**, both in "
        "**{}**. All {} rows: {}, {} and {}. Were the true means the same, the scatter of the runs "
        "would leave about {:.0f} errors of the working range within the margin.\n"
        "* **At least as good.** Working range: error at most {} m above the thesis's in **{}** of "
        "{}; {} lie further below it and {} above. Number of landmarks near the true one (within "
        "0.5; complex 1.5) in {}; the thesis's own figures are so in {}.\n"
        "* Mean error over the working range: thesis {:.3f} m, Hitos {:.3f} m, difference "
        "**{:+.3f} m**.\n"
        "* Outside the working range the same tendency (harm or none) in {} of {} rows.\n\n",
        reproduction.figures.size(), all.rows, reproduction.runs, inside.rows, kErrorMargin,
        inside.error_near, kLandmarkMargin, inside.landmarks_near, inside.both_near, all.rows,
        all.error_near, all.landmarks_near, all.both_near, inside.expected_near, kErrorMargin,
        inside.at_least, inside.rows, inside.below, inside.above, inside.truth_met,
        inside.thesis_truth_met, inside.mean_thesis_m(), inside.mean_ours_m(),
        inside.mean_difference_m(), all.same_tendency, all.tendency_asked);
    text += summary_table(reproduction, "parameter", parameter_of);
    text += summary_table(reproduction, "world", world_of);
    return text;
}

}  // namespace hitos
