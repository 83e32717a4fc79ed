// SPDX-License-Identifier: GPL-3.0-or-later
// The tables and the document of a reproduction.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "hitos/base/text_table.hpp"
#include "hitos/workbench/reproduction.hpp"
#include "reproduction_parts.hpp"
#include "reproduction_remarks.hpp"
#include "reproduction_summary.hpp"

namespace hitos {
namespace {

namespace fs = std::filesystem;

std::string misses_text(const Reproduction& reproduction) {
    struct Miss {
        double excess = 0.0;
        std::string line;
    };
    std::vector<Miss> inside;
    std::string outside;
    for (const ReproducedFigure& figure : reproduction.figures) {
        const std::string_view parameter = figure.thesis.table->parameter;
        for (const ReproducedRow& row : figure.rows) {
            const std::string line =
                fmt::format("* {} {} {} = {}: {}.\n", figure.thesis.name, figure.thesis.world,
                            parameter, row.thesis.value, row.verdict.words);
            if (!row.in_range) {
                if (!row.verdict.same_tendency) outside += line;
            } else if (!row.verdict.error_met || !row.verdict.landmarks_met) {
                const double excess = row.error_m && row.thesis.error_m && !row.verdict.error_met
                                          ? row.error_m->mean - *row.thesis.error_m
                                          : 0.0;
                inside.push_back({excess, line});
            }
        }
    }
    std::ranges::stable_sort(inside, std::greater<>(), &Miss::excess);
    std::string text =
        "Rows of the working range that are not at least as good, the worst first:\n\n";
    if (inside.empty()) text += "* none.\n";
    for (const Miss& miss : inside) text += miss.line;
    text += "\nRows outside it with another tendency than the thesis's:\n\n";
    return text + (outside.empty() ? "* none.\n" : outside) + "\n";
}

std::string row_text(const ReproducedRow& row) {
    const std::string value =
        row.in_range ? fmt::format("**{}**", row.thesis.value) : row.thesis.value;
    std::string ours = "∞ | |";
    if (row.error_m) {
        ours = fmt::format("{:.3f} | {} |", row.error_m->mean,
                           text_or(row.error_m->variance, "{:.4f}", ""));
    }
    std::string words = row.verdict.words;
    if (row.bare > 0 && row.error_m) words += fmt::format("; {} runs without landmarks", row.bare);
    if (row.failed > 0) words += fmt::format("; {} runs failed", row.failed);
    return fmt::format("| {} | {} | {:.4f} | {:.1f} | {} {} | {} | {} |\n", value,
                       text_or(row.thesis.error_m, "{:.3f}", "∞"), row.thesis.error_variance,
                       row.thesis.landmarks, ours,
                       row.landmarks ? fmt::format("{:.1f}", row.landmarks->mean) : "",
                       row.verdict.difference, words);
}

std::string figure_text(const ReproducedFigure& figure, const std::string& plots) {
    const ThesisTable& table = *figure.thesis.table;
    const std::string stem = figure.thesis.stem();
    std::string text = fmt::format(
        "### Figure {}: {}, {}\n\nTable {}, section {}; {} true landmarks; working range {} to "
        "{}.\n"
        "\n| {} | thesis: error (m) | variance | landmarks | Hitos: error (m) | variance | "
        "landmarks | against the thesis | at least as good |\n|---|---|---|---|---|---|---|---|---|"
        "\n",
        figure.thesis.name, figure.thesis.world, table.parameter, table.table, table.section,
        figure.true_landmarks, figure.thesis.range.least, figure.thesis.range.greatest,
        table.parameter);
    for (const ReproducedRow& row : figure.rows) text += row_text(row);
    return text + fmt::format("\n![{0}]({1}/{0}.png)\n\n", stem, plots);
}

}  // namespace

std::string reproduction_csv(const Reproduction& reproduction) {
    std::string text =
        "figure,map,parameter,value,thesis_error_m,thesis_error_variance,thesis_landmarks,error_m,"
        "error_variance,error_min_m,error_max_m,landmarks,true_landmarks,runs,runs_failed,"
        "runs_without_landmarks,in_working_range,error_within_margin,landmarks_within_margin,"
        "at_least_as_good,difference,verdict\n";
    for (const ReproducedFigure& figure : reproduction.figures) {
        for (const ReproducedRow& row : figure.rows) {
            const auto& error = row.error_m;
            text += fmt::format("{},{},{},{},{},{},{},", figure.thesis.name, figure.thesis.world,
                                figure.thesis.table->parameter, row.thesis.value,
                                text_or(row.thesis.error_m, "{}", "inf"), row.thesis.error_variance,
                                row.thesis.landmarks);
            text +=
                error ? fmt::format("{},{},{},{},", error->mean, text_or(error->variance, "{}", ""),
                                    error->minimum, error->maximum)
                      : std::string(row.finished > 0 ? "inf,,,," : ",,,,");
            const auto yes_no = [](bool value) { return value ? "yes" : "no"; };
            text += fmt::format("{},{},{},{},{},{},{},{},{},",
                                row.landmarks ? fmt::format("{}", row.landmarks->mean) : "",
                                figure.true_landmarks, row.finished, row.failed, row.bare,
                                yes_no(row.in_range), yes_no(row.verdict.error_near),
                                yes_no(row.verdict.landmarks_near), yes_no(row.verdict.error_met));
            text += csv_line({row.verdict.difference, row.verdict.words});
        }
    }
    return text;
}

std::string reproduction_markdown(const Reproduction& reproduction, const std::string& plots,
                                  std::span<const Reproduction> tried) {
    std::string text = "# Reproduction of the thesis's synthetic experiments\n\n";
    text += reproduction_introduction(reproduction.reading);
    text += "## Summary\n\n" + summary_text(reproduction);
    text += "## Where Hitos differs\n\n" + differences_text(reproduction, tried);
    text += readings_text(reproduction, tried);
    text += "## Where Hitos is worse\n\n" + misses_text(reproduction);
    if (!reproduction.plot_problem.empty()) {
        text += fmt::format("There are no plots: {}.\n\n", reproduction.plot_problem);
    }
    text += "## Figures\n\nValues in the working range are bold.\n\n";
    for (const ReproducedFigure& figure : reproduction.figures) text += figure_text(figure, plots);
    text.pop_back();
    return text;
}

void write_report(const Reproduction& reproduction, const fs::path& document, const fs::path& plots,
                  std::span<const Reproduction> tried) {
    std::vector<std::string> stems;
    for (const ReproducedFigure& figure : reproduction.figures) {
        stems.push_back(figure.thesis.stem());
    }
    write_with_pictures(document, plots, stems, [&](const std::string& folder) {
        return reproduction_markdown(reproduction, folder, tried);
    });
}

}  // namespace hitos
