// The tables and the document of a reproduction.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <system_error>

#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/workbench/reproduction.hpp"
#include "reproduction_remarks.hpp"

namespace hitos {
namespace {

namespace fs = std::filesystem;

std::string exact(const std::optional<double>& value) {
    return value ? fmt::format("{}", *value) : "inf";
}

/// Sums over the rows of a working range.
struct Summary {
    int rows = 0;
    int error_met = 0;
    int below = 0;
    int landmarks_met = 0;
    int thesis_landmarks_met = 0;
    int both_met = 0;
    int compared = 0;
    double difference_m = 0.0;  ///< sum of ours minus the thesis's
    double thesis_m = 0.0;
    double ours_m = 0.0;
    int outside = 0;
    int same_tendency = 0;

    void add(const ReproducedRow& row) {
        if (!row.in_range) {
            ++outside;
            same_tendency += row.verdict.same_tendency ? 1 : 0;
            return;
        }
        ++rows;
        error_met += row.verdict.error_met ? 1 : 0;
        landmarks_met += row.verdict.landmarks_met ? 1 : 0;
        thesis_landmarks_met += row.verdict.thesis_landmarks_met ? 1 : 0;
        both_met += row.verdict.error_met && row.verdict.landmarks_met ? 1 : 0;
        if (!row.error_m || !row.thesis.error_m) return;
        ++compared;
        thesis_m += *row.thesis.error_m;
        ours_m += row.error_m->mean;
        difference_m += row.error_m->mean - *row.thesis.error_m;
        below += row.error_m->mean < *row.thesis.error_m ? 1 : 0;
    }
    double mean(double sum) const { return compared > 0 ? sum / compared : 0.0; }
};

template <class Wanted>
Summary sum_up(const Reproduction& reproduction, Wanted wanted) {
    Summary summary;
    for (const ReproducedFigure& figure : reproduction.figures) {
        if (!wanted(figure)) continue;
        for (const ReproducedRow& row : figure.rows) summary.add(row);
    }
    return summary;
}

template <class Name>
std::string summary_table(const Reproduction& reproduction, const char* title, Name name) {
    std::vector<std::string> names;
    for (const ReproducedFigure& figure : reproduction.figures) {
        const std::string key(name(figure));
        if (std::ranges::find(names, key) == names.end()) names.push_back(key);
    }
    std::string text = fmt::format(
        "| {} | rows in the working range | error met | mean error thesis → Hitos (m) | landmarks "
        "met (thesis's own) | same tendency outside |\n|---|---|---|---|---|---|\n",
        title);
    for (const std::string& key : names) {
        const Summary sum =
            sum_up(reproduction, [&](const ReproducedFigure& f) { return name(f) == key; });
        text += fmt::format("| {} | {} | {} | {:.3f} → {:.3f} | {} ({}) | {} of {} |\n", key,
                            sum.rows, sum.error_met, sum.mean(sum.thesis_m), sum.mean(sum.ours_m),
                            sum.landmarks_met, sum.thesis_landmarks_met, sum.same_tendency,
                            sum.outside);
    }
    return text + "\n";
}

std::string summary_text(const Reproduction& reproduction) {
    const Summary sum = sum_up(reproduction, [](const ReproducedFigure&) { return true; });
    std::string text = fmt::format(
        "* {} figures, {} rows, {} runs of each.\n"
        "* Working range: {} rows. Error at most {} m above the thesis's: **{} of {}**; below the "
        "thesis's: {}.\n"
        "* Mean error over these rows: thesis {:.3f} m, Hitos {:.3f} m, difference **{:+.3f} m**.\n"
        "* Number of landmarks near the true one (within 0.5; complex 1.5): **{} of {}**; the "
        "thesis's own figures: {}. Error and number both: {}.\n"
        "* Outside the working range the same tendency (harm or none) in {} of {} rows.\n\n",
        reproduction.figures.size(), sum.rows + sum.outside, reproduction.runs, sum.rows,
        kErrorMargin, sum.error_met, sum.rows, sum.below, sum.mean(sum.thesis_m),
        sum.mean(sum.ours_m), sum.mean(sum.difference_m), sum.landmarks_met, sum.rows,
        sum.thesis_landmarks_met, sum.both_met, sum.same_tendency, sum.outside);
    text += summary_table(reproduction, "parameter", [](const ReproducedFigure& figure) {
        return std::string_view(figure.thesis.table->parameter);
    });
    text += summary_table(reproduction, "world", [](const ReproducedFigure& figure) {
        return std::string_view(figure.thesis.world);
    });
    return text;
}

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
    std::string text = "Rows of the working range that miss what is asked, the worst first:\n\n";
    if (inside.empty()) text += "* none.\n";
    for (const Miss& miss : inside) text += miss.line;
    text += "\nRows outside it with another tendency than the thesis's:\n\n";
    return text + (outside.empty() ? "* none.\n" : outside) + "\n";
}

std::string error_text(const std::optional<double>& value) {
    return value ? fmt::format("{:.3f}", *value) : "∞";
}

std::string row_text(const ReproducedRow& row) {
    const std::string value =
        row.in_range ? fmt::format("**{}**", row.thesis.value) : row.thesis.value;
    std::string ours = "∞ | |";
    if (row.error_m) {
        ours =
            fmt::format("{:.3f} | {} |", row.error_m->mean,
                        row.error_m->variance ? fmt::format("{:.4f}", *row.error_m->variance) : "");
    }
    std::string words = row.verdict.words;
    if (row.bare > 0 && row.error_m) words += fmt::format("; {} runs without landmarks", row.bare);
    if (row.failed > 0) words += fmt::format("; {} runs failed", row.failed);
    return fmt::format("| {} | {} | {:.4f} | {:.1f} | {} {} | {} |\n", value,
                       error_text(row.thesis.error_m), row.thesis.error_variance,
                       row.thesis.landmarks, ours,
                       row.landmarks ? fmt::format("{:.1f}", row.landmarks->mean) : "", words);
}

std::string figure_text(const ReproducedFigure& figure, const std::string& plots) {
    const ThesisTable& table = *figure.thesis.table;
    const std::string stem = figure.thesis.stem();
    std::string text = fmt::format(
        "### Figure {}: {}, {}\n\nTable {}, section {}; {} true landmarks; working range {} to "
        "{}.\n"
        "\n| {} | thesis: error (m) | variance | landmarks | Hitos: error (m) | variance | "
        "landmarks | verdict |\n|---|---|---|---|---|---|---|---|\n",
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
        "runs_without_landmarks,in_working_range,verdict\n";
    for (const ReproducedFigure& figure : reproduction.figures) {
        for (const ReproducedRow& row : figure.rows) {
            const auto& error = row.error_m;
            text += fmt::format("{},{},{},{},{},{},{},", figure.thesis.name, figure.thesis.world,
                                figure.thesis.table->parameter, row.thesis.value,
                                exact(row.thesis.error_m), row.thesis.error_variance,
                                row.thesis.landmarks);
            text += error ? fmt::format("{},{},{},{},", error->mean,
                                        error->variance ? fmt::format("{}", *error->variance) : "",
                                        error->minimum, error->maximum)
                          : std::string(row.finished > 0 ? "inf,,,," : ",,,,");
            text += fmt::format("{},{},{},{},{},{},{}\n",
                                row.landmarks ? fmt::format("{}", row.landmarks->mean) : "",
                                figure.true_landmarks, row.finished, row.failed, row.bare,
                                row.in_range ? "yes" : "no", row.verdict.words);
        }
    }
    return text;
}

std::string reproduction_markdown(const Reproduction& reproduction, const std::string& plots) {
    std::string text = "# Reproduction of the thesis's synthetic experiments\n\n";
    text += reproduction_introduction();
    text += "## Summary\n\n" + summary_text(reproduction);
    text += "## Where Hitos differs, and why\n\n" + reproduction_remarks();
    text += misses_text(reproduction);
    if (!reproduction.plot_problem.empty()) {
        text += fmt::format("There are no plots: {}.\n\n", reproduction.plot_problem);
    }
    text += "## Figures\n\nValues in the working range are bold.\n\n";
    for (const ReproducedFigure& figure : reproduction.figures) text += figure_text(figure, plots);
    text.pop_back();
    return text;
}

void write_report(const Reproduction& reproduction, const fs::path& document,
                  const fs::path& plots) {
    const fs::path folder = document.parent_path() / document.stem();
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw FileError(folder.string(), "cannot make this folder: " + error.message());
    for (const ReproducedFigure& figure : reproduction.figures) {
        const std::string picture = figure.thesis.stem() + ".png";
        if (!fs::exists(plots / picture, error)) continue;
        fs::copy_file(plots / picture, folder / picture, fs::copy_options::overwrite_existing,
                      error);
        if (error) {
            throw FileError((folder / picture).string(), "cannot be written: " + error.message());
        }
    }
    write_file(document, reproduction_markdown(reproduction, document.stem().string()));
}

}  // namespace hitos
