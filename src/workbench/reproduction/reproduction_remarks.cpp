#include "reproduction_remarks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

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

std::string readings_text(const Reproduction& reproduction, std::span<const Reproduction> tried) {
    if (tried.empty()) return "";
    std::string text = fmt::format(
        "## Readings that were tried\n\nEach reading supposes something that the thesis does not "
        "say, or says otherwise, and is run over the same rows ({} runs of each):\n\n"
        "```sh\nhitos-cli reproduce --hypotheses --report docs/reproduction.md\n"
        "hitos-cli reproduce --reading {}\n```\n\n"
        "A row is explained where error and number of landmarks agree with the thesis's; gained "
        "and "
        "lost are explained rows against `{}`.\n\n"
        "| reading | working range: error | number | both | mean difference (m) | all rows: error "
        "| number | both | gained, lost | supposes |\n|---|---|---|---|---|---|---|---|---|---|\n",
        reproduction.runs, reading_as_published().name, reproduction.reading.name);
    const auto add = [&](const Reproduction& reading) {
        const Agreement inside = sum_up(reading, in_range);
        const Agreement all = sum_up(reading, any_row);
        int gained = 0;
        int lost = 0;
        const std::size_t figures = reading.figures.size();
        for (std::size_t f = 0; f < figures; ++f) {
            const std::vector<ReproducedRow>& rows_before = reproduction.figures[f].rows;
            const std::vector<ReproducedRow>& rows_now = reading.figures[f].rows;
            for (std::size_t r = 0; r < rows_now.size(); ++r) {
                const bool before = explained(rows_before[r]);
                const bool now = explained(rows_now[r]);
                gained += now && !before ? 1 : 0;
                lost += before && !now ? 1 : 0;
            }
        }
        const char* mark = reading.reading.name == reading_as_published().name ? "**" : "";
        text += fmt::format(
            "| {0}`{1}`{0} | {2} of {3} | {4} | {5} | {6:+.3f} | {7} of {8} | {9} | {10} | {11}, "
            "{12} | {13} |\n",
            mark, reading.reading.name, inside.error_near, inside.rows, inside.landmarks_near,
            inside.both_near, inside.mean_difference_m(), all.error_near, all.rows,
            all.landmarks_near, all.both_near, gained, lost, reading.reading.sentence);
    };
    add(reproduction);
    for (const Reproduction& reading : tried) add(reading);
    text += '\n';
    const auto published = std::ranges::find_if(tried, [](const Reproduction& reading) {
        return reading.reading.name == reading_as_published().name;
    });
    if (published == tried.end()) return text;
    const auto best = std::ranges::max_element(
        tried, {}, [](const Reproduction& reading) { return sum_up(reading, in_range).both_near; });
    const int most = sum_up(*best, in_range).both_near;
    text += fmt::format(
        "### As published: `{}`\n\n{}; `hitos-cli reproduce --as-published` runs it alone. It "
        "changes the worlds and configurations by\n\n```\n{}```\n\n",
        published->reading.name,
        sum_up(*published, in_range).both_near == most
            ? "No other reading explains more rows of the working range"
            : fmt::format("`{}` explains more rows of the working range, {}", best->reading.name,
                          most),
        text_of(published->reading));
    return text + summary_text(*published);
}

}  // namespace hitos
