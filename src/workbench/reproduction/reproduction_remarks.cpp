// SPDX-License-Identifier: GPL-3.0-or-later
#include "reproduction_remarks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "hitos/base/text_table.hpp"
#include "reproduction_parts.hpp"
#include "reproduction_summary.hpp"

namespace hitos {
namespace {

bool explained(const ReproducedRow& row) {
    return row.verdict.error_near && row.verdict.landmarks_near;
}

/// One parameter's rows inside or outside the working range.
struct Group {
    std::string parameter;
    bool inside = false;
    int rows = 0;
    std::vector<std::pair<std::size_t, std::size_t>> differ;  ///< figure and row
    Agreement agreement;
    std::vector<double> errors_m;  ///< ours minus the thesis's, of rows whose error differs
    std::vector<double> landmarks;
};

std::vector<Group> group_rows(const Reproduction& reproduction) {
    std::vector<Group> groups;
    for (std::size_t f = 0; f < reproduction.figures.size(); ++f) {
        const ReproducedFigure& figure = reproduction.figures[f];
        for (std::size_t r = 0; r < figure.rows.size(); ++r) {
            const ReproducedRow& row = figure.rows[r];
            auto group = std::ranges::find_if(groups, [&](const Group& known) {
                return known.parameter == figure.thesis.table->parameter &&
                       known.inside == row.in_range;
            });
            if (group == groups.end()) {
                groups.emplace_back();
                group = groups.end() - 1;
                group->parameter = figure.thesis.table->parameter;
                group->inside = row.in_range;
            }
            ++group->rows;
            group->agreement.add(row);
            if (!explained(row)) group->differ.emplace_back(f, r);
            if (!row.verdict.error_near && row.error_m && row.thesis.error_m) {
                group->errors_m.push_back(row.error_m->mean - *row.thesis.error_m);
            }
            if (!row.verdict.landmarks_near && row.landmarks) {
                group->landmarks.push_back(row.landmarks->mean - row.thesis.landmarks);
            }
        }
    }
    std::ranges::stable_sort(groups, std::greater<>(),
                             [](const Group& group) { return group.differ.size(); });
    return groups;
}

/// "3 below, 1 above, −0.06 … +0.12 m".
std::string spread_words(const std::vector<double>& differences, const char* less, const char* more,
                         const char* format) {
    if (differences.empty()) return "";
    const auto below = std::ranges::count_if(differences, [](double d) { return d < 0.0; });
    const auto above = std::ssize(differences) - below;
    const auto [least, most] = std::ranges::minmax(differences);
    std::string text;
    if (below > 0) text = fmt::format("{} {}", below, less);
    if (above > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", above, more);
    return text + ": " + fmt::format(fmt::runtime(format), least, most);
}

std::size_t explained_rows(const Group& group, const Reproduction& reading) {
    return static_cast<std::size_t>(std::ranges::count_if(group.differ, [&](const auto& place) {
        return explained(reading.figures[place.first].rows[place.second]);
    }));
}

/// The reading that brings most of the group's differing rows to the thesis's figures.
std::string best_reading(const Group& group, std::span<const Reproduction> tried) {
    const Reproduction* best = nullptr;
    for (const Reproduction& reading : tried) {
        if (best == nullptr || explained_rows(group, reading) > explained_rows(group, *best)) {
            best = &reading;
        }
    }
    if (best == nullptr || explained_rows(group, *best) == 0) return "none";
    return fmt::format("`{}`: {}", best->reading.name, explained_rows(group, *best));
}

/// The worlds on which a reading is chosen: one of each size, and the one with all parameters.
constexpr std::array<std::string_view, 3> kChosenOn{"lineamedia", "bigloop2", "complex"};

bool is_chosen_on(const ReproducedFigure& figure) {
    return std::ranges::count(kChosenOn, figure.thesis.world) > 0;
}

/// Percent, over those worlds or the others; nothing where there are no rows of a kind.
std::optional<double> score_of(const Reproduction& reproduction, bool where_chosen) {
    constexpr double kHalf = 50.0;
    const Agreement inside = sum_up(reproduction, [&](const auto& figure, const auto& row) {
        return row.in_range && is_chosen_on(figure) == where_chosen;
    });
    const Agreement all = sum_up(reproduction, [&](const auto& figure, const auto&) {
        return is_chosen_on(figure) == where_chosen;
    });
    if (inside.rows == 0 || all.tendency_asked == 0) return std::nullopt;
    return kHalf * inside.both_near / inside.rows + kHalf * all.same_tendency / all.tendency_asked;
}

constexpr std::string_view kReadingsHead =
    "| reading | working range: error | number | explained | mean difference (m) | outside: same "
    "tendency | all rows: explained | score where chosen | where judged | supposes |\n"
    "|---|---|---|---|---|---|---|---|---|---|\n";

std::string reading_row(const Reproduction& reading) {
    const Agreement inside = sum_up(reading, in_range);
    const Agreement all = sum_up(reading, any_row);
    const char* mark = reading.reading.name == reading_as_published().name ? "**" : "";
    return fmt::format(
        "| {0}`{1}`{0} | {2} of {3} | {4} | {5} | {6:+.3f} | {7} of {8} | {9} of {10} | {11} | "
        "{12} | {13} |\n",
        mark, reading.reading.name, inside.error_near, inside.rows, inside.landmarks_near,
        inside.both_near, inside.mean_difference_m(), all.same_tendency, all.tendency_asked,
        all.both_near, all.rows, text_or(score_of(reading, true), "{:.1f} %", kNoFigure),
        text_or(score_of(reading, false), "{:.1f} %", kNoFigure), reading.reading.sentence);
}

std::string unexplained_text(const Reproduction& reproduction,
                             std::span<const Reproduction> tried) {
    std::string lines;
    std::size_t count = 0;
    const std::size_t figures = reproduction.figures.size();  // the same of every reading
    for (std::size_t f = 0; f < figures; ++f) {
        const ReproducedFigure& figure = reproduction.figures[f];
        std::vector<std::string> values;
        for (std::size_t r = 0; r < figure.rows.size(); ++r) {
            const bool known = std::ranges::any_of(tried, [&](const Reproduction& reading) {
                return explained(reading.figures[f].rows[r]);
            });
            if (known || explained(figure.rows[r])) continue;
            values.push_back(figure.rows[r].in_range
                                 ? fmt::format("**{}**", figure.rows[r].thesis.value)
                                 : figure.rows[r].thesis.value);
            ++count;
        }
        if (values.empty()) continue;
        lines += fmt::format("* {} {} {}: {}.\n", figure.thesis.name, figure.thesis.world,
                             figure.thesis.table->parameter, fmt::join(values, ", "));
    }
    if (count == 0) return "Every row is explained by one reading or another.\n\n";
    return fmt::format(
               "{} rows that no reading explains (bold: in the working range); what in the "
               "thesis's program or tours made them is not known:\n\n",
               count) +
           lines + "\n";
}

}  // namespace

std::string reproduction_introduction(const Reading& reading) {
    std::string text =
        R"(`hitos-cli reproduce` wrote this document. It runs every row of `data/results.csv` (chapter 10 of the
thesis, synthetic worlds) and sets error, variance and number of landmarks beside the thesis's:

```sh
hitos-cli reproduce --report docs/reproduction.md
```

* Fixed parameters: those of the thesis's table for that figure and no others; what a table does not
  name stays at the default. Infinite Neff is resampling after every scan.
* The motion numbers of the tables are taken as standard deviations per scan, the observation
  covariances as variances: no other reading gives errors and landmark counts like the thesis's.
* Tours: the worlds of `data/worlds`, laser sigma 3 mm, odometry with relative sigma 0.1 at 10 Hz. Run
  k of a value has seed k for the filter, the laser's noise and the odometry's noise.
* Error of a run: mean distance of its landmarks to the nearest true one of the same kind, no
  alignment. The thesis divides the variance by an unknown n or n - 1; ours is n - 1.
* Two judgements. **Against the thesis**, every row: its error within ±0.05 m of the thesis's and its
  number of landmarks within 1 of the thesis's. **At least as good**: an error at most 0.05 m above the
  thesis's; in the working range a number of landmarks within 0.5 (complex: 1.5) of the true one.
* The working range of a parameter is the one that the text of its section calls good, world by world
  where the text does so. Outside it the tendency counts too: a row is harmed where it has no landmarks,
  1.5 times the mean error of the working range and 0.05 m more, or a number of landmarks that is off by
  more than 1.

)";
    if (!text_of(reading).empty()) {
        text += fmt::format(
            "**This is the reading `{}`**: {}. It changes the worlds and configurations by\n\n```\n"
            "{}```\n\n",
            reading.name, reading.sentence, text_of(reading));
    }
    return text;
}

std::string differences_text(const Reproduction& reproduction,
                             std::span<const Reproduction> tried) {
    const Agreement all = sum_up(reproduction, any_row);
    std::string text = fmt::format(
        "The thesis's tours, its simulator's settings and its program are not published. {} of {} "
        "rows differ from it: {} errors lie more than {} m below and {} above, {} rows have fewer "
        "landmarks and {} more. By parameter, the largest groups first:\n\n",
        all.rows - all.both_near, all.rows, all.below, kErrorMargin, all.above, all.fewer,
        all.more);
    text +=
        fmt::format("| rows | differ | error | number of landmarks |{}\n|---|---|---|---|{}\n",
                    tried.empty() ? "" : " explained by most: rows |", tried.empty() ? "" : "---|");
    for (const Group& group : group_rows(reproduction)) {
        if (group.differ.empty()) continue;
        text += fmt::format("| `{}`, {} the working range | {} of {} | {} | {} |", group.parameter,
                            group.inside ? "in" : "outside", group.differ.size(), group.rows,
                            spread_words(group.errors_m, "below", "above", "{:+.3f} … {:+.3f} m"),
                            spread_words(group.landmarks, "fewer", "more", "{:+.1f} … {:+.1f}"));
        if (!tried.empty()) text += fmt::format(" {} |", best_reading(group, tried));
        text += '\n';
    }
    text += '\n';
    if (!tried.empty()) text += unexplained_text(reproduction, tried);
    return text;
}

std::vector<Reading> close_readings(std::span<const Reproduction> tried) {
    constexpr double kClose = 3.0;  // of a hundred
    double best = 0.0;
    for (const Reproduction& reading : tried) {
        best = std::max(best, score_of(reading, true).value_or(0.0));
    }
    std::vector<Reading> close;
    for (const Reproduction& reading : tried) {
        const auto score = score_of(reading, true);
        if (score && *score >= best - kClose) close.push_back(find_reading(reading.reading.name));
    }
    return close;
}

std::string readings_text(const Reproduction& reproduction, std::span<const Reproduction> tried) {
    if (tried.empty()) return "";
    const Reproduction* published = nullptr;
    const Reproduction* best = &reproduction;  // of those that were looked at most closely
    std::string once;
    std::string closely;
    for (const Reproduction& reading : tried) {
        (reading.runs > reproduction.runs ? closely : once) += reading_row(reading);
        if (reading.reading.name == reading_as_published().name) published = &reading;
        const auto standing = [](const Reproduction& one) {
            return std::pair(one.runs, score_of(one, true));
        };
        if (standing(reading) > standing(*best)) best = &reading;
    }
    std::string text = fmt::format(
        "## Readings that were tried\n\nEach reading supposes something that the thesis does not "
        "say, or says otherwise, and is run over the same rows ({} runs of each):\n\n"
        "```sh\nhitos-cli reproduce --hypotheses --report docs/reproduction.md\n"
        "hitos-cli reproduce --reading {}\n```\n\n"
        "A row is explained where error and number of landmarks agree with the thesis's. The score "
        "is the mean of two shares: of the rows of the working range that are explained, and of "
        "those outside it that have the same tendency. The reading to recommend is the one with "
        "the greatest score on {}; on the other worlds it is judged. Runs scatter: the readings "
        "within three points of the best are run again, four times as often, and the best of these "
        "counts. The rule was laid down, and the worlds parted, before the readings with an "
        "interpolated laser were run, with five points, which were made three when they were "
        "known, for the time that a second look takes; that one ray in four is traced was known "
        "from a trial on the rows of 3 and 5 points of all worlds, and the readings without it "
        "from all rows, so "
        "that the other worlds are not wholly new to it.\n\n{}",
        reproduction.runs, reading_as_published().name, fmt::join(kChosenOn, ", "), kReadingsHead);
    text += reading_row(reproduction) + once + '\n';
    if (!closely.empty()) {
        text += fmt::format("The closest, {} runs of each:\n\n{}{}\n", best->runs, kReadingsHead,
                            closely);
    }
    if (published == nullptr) return text;
    text += fmt::format(
        "### As published: `{}`\n\n{}; `hitos-cli reproduce --as-published` runs it alone. It "
        "changes the worlds and configurations by\n\n```\n{}```\n\n",
        published->reading.name,
        score_of(*published, true) == score_of(*best, true)
            ? "No other reading has a greater score where it is chosen"
            : fmt::format("`{}` has a greater score where it is chosen", best->reading.name),
        text_of(published->reading));
    return text + summary_text(*published);
}

}  // namespace hitos
