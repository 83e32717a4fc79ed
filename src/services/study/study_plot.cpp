// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_plot.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "calibration_plot.hpp"
#include "hitos/services/drawing/gnuplot.hpp"
#include "hitos/services/study/study_abscissa.hpp"

namespace hitos::study {
namespace {

/// What has a plot: a figure of each cell against the parameter.
std::vector<const Measure*> plotted() {
    std::vector<const Measure*> measures = taken_measures();
    std::erase_if(measures,
                  [](const Measure* measure) { return measure->plot.empty() || measure->rare; });
    return measures;
}

/// Of the plot's files: "trajectory-error".
std::string stem_of(const Measure& measure) {
    std::string stem = measure.stem();
    std::ranges::replace(stem, '_', '-');
    return stem;
}

/// Whether the study asks for the measure: then a plot without a figure is worth a word.
bool asked_for(const Measure& measure, const StudyPlan& plan) {
    return measure.is_count() || (measure.of_landmarks() && plan.has_reference());
}

std::size_t curves(const StudyPlan& plan) {
    return plan.axes.size() < 2 ? 1 : plan.axes[1].values.size();
}

/// gnuplot's blocks: one for each curve, with two empty lines between.
std::string data_text(const StudyPlan& plan, std::span<const StudyCell> cells,
                      const StudyAbscissa& x, const Measure& measure) {
    std::string text = "# x mean standard_deviation minimum maximum runs\n";
    std::vector<std::size_t> order(x.positions.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return x.positions[a] < x.positions[b]; });
    for (std::size_t curve = 0; curve < curves(plan); ++curve) {
        if (curve > 0) text += "\n\n";
        if (plan.axes.size() > 1) {
            text += fmt::format("# {} = {}\n", plan.axes[1].name,
                                fmt::join(plan.axes[1].values[curve], "/"));
        }
        for (const std::size_t i : order) {
            const auto& spread = cells[i * curves(plan) + curve].figures[measure];
            if (!spread) {
                text += fmt::format("{} NaN NaN NaN NaN 0\n", x.positions[i]);
                continue;
            }
            text += fmt::format("{} {} {} {} {} {}\n", x.positions[i], spread->mean,
                                std::sqrt(spread->variance.value_or(0.0)), spread->minimum,
                                spread->maximum, spread->count);
        }
    }
    return text;
}

/// gnuplot's own goes to whole decades where x is logarithmic.
std::string range(const StudyAbscissa& x) {
    const auto [least, greatest] = x.range(0.04);
    return fmt::format("{}set xrange [{:.6g}:{:.6g}]\n", x.logarithmic ? "set logscale x\n" : "",
                       least, greatest);
}

/// Words, and the values of a logarithmic axis, stand at their places.
std::string tics(const StudyAbscissa& x) {
    std::vector<std::string> marks;
    for (std::size_t i = 0; i < x.positions.size(); ++i) {
        marks.push_back(fmt::format("{} {}", gnuplot_quoted(x.words[i]), x.positions[i]));
    }
    return fmt::format("set xtics ({})\n", fmt::join(marks, ", "));
}

std::string script_text(const StudyLayout& layout, const StudyPlan& plan, const StudyAbscissa& x,
                        const Measure& measure) {
    const std::string stem = layout.prefix + stem_of(measure);
    std::string plot = "plot ";
    for (std::size_t curve = 0; curve < curves(plan); ++curve) {
        const std::string title = plan.axes.size() < 2
                                      ? "mean and standard deviation"
                                      : fmt::format("{} = {}", plan.axes[1].name,
                                                    fmt::join(plan.axes[1].values[curve], "/"));
        if (curve > 0) plot += ", \\\n     ";
        plot += fmt::format(
            "{} index {} using 1:2:3 with yerrorlines linewidth 1.5 pointtype 7 "
            "pointsize 0.7 title {}",
            gnuplot_file(stem + ".dat"), curve, gnuplot_quoted(title));
    }
    if (measure.word == "landmarks" && plan.has_reference()) {
        plot += fmt::format(
            ", \\\n     {} with lines dashtype 2 linecolor 'black' title "
            "'in the reference'",
            plan.reference_lines + plan.reference_corners);
    }
    std::string text = gnuplot_head(stem + ".gp");
    text +=
        fmt::format("set xlabel {} noenhanced\n", gnuplot_quoted(study_axis_label(plan.axes[0])));
    text +=
        fmt::format("set ylabel '{}'\n", figure_label(measure.plot, printed_unit(measure.unit)));
    text += "set grid\nset key outside top center horizontal noenhanced\n";
    text += "set yrange [0:*]\n";
    text += range(x);
    if (x.logarithmic || !x.numbers) text += tics(x);
    text += "set xtics noenhanced\n";
    for (const auto& [extension, terminal] :
         {std::pair("png", "pngcairo size 900,600"), std::pair("svg", "svg size 900,600")}) {
        text += fmt::format("set terminal {}\nset output {}\n{}\n", terminal,
                            gnuplot_file(stem + "." + extension), plot);
    }
    return text + "unset output\n";
}

}  // namespace

Message write_plots(const StudyLayout& layout, const StudyPlan& plan,
                    std::span<const StudyCell> cells) {
    if (plan.axes.empty()) return {};
    const StudyAbscissa x = study_abscissa(plan.axes[0]);
    Message problem;
    for (const Measure* one : plotted()) {
        const Measure& measure = *one;
        const std::string stem = layout.prefix + stem_of(measure);
        const bool any = has_figures(cells, measure);
        if (!any && !asked_for(measure, plan)) continue;
        const std::vector<PlotFile> files{{stem + ".dat", data_text(plan, cells, x, measure)},
                                          {stem + ".gp", script_text(layout, plan, x, measure)}};
        const std::vector<std::string> pictures{stem + ".png", stem + ".svg"};
        const Message failure = draw_pictures(
            layout.folder, files, stem + ".gp", pictures,
            any ? Message()
                : message(HITOS_TEXT("Errors", "no run gave a figure for %1"), stem_of(measure)));
        if (problem.empty()) problem = failure;
    }
    std::vector<CalibrationCurve> curves;
    for (std::size_t cell = 0; cell < cells.size(); ++cell)
        curves.push_back({plan.cell_label(cell), &cells[cell].figures});
    const Message failure = write_calibration(layout, curves);
    return problem.empty() ? failure : problem;
}

bool is_plot(const std::string& name) {
    static constexpr std::array kExtensions{".dat", ".gp", ".png", ".svg"};
    std::vector<std::string> stems{kCalibrationPlot};
    for (const Measure* measure : plotted()) stems.push_back(stem_of(*measure));
    return std::ranges::any_of(stems, [&](const std::string& stem) {
        return std::ranges::any_of(kExtensions,
                                   [&](const char* extension) { return name == stem + extension; });
    });
}

}  // namespace hitos::study
