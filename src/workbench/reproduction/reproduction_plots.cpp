// SPDX-License-Identifier: GPL-3.0-or-later
// The plots of a reproduction: error and landmarks of the thesis and of Hitos, one above the other.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "hitos/base/staged_folder.hpp"
#include "hitos/services/drawing/gnuplot.hpp"
#include "reproduction_parts.hpp"

namespace hitos {
namespace {

namespace fs = std::filesystem;

std::string data_text(const ReproducedFigure& figure) {
    std::string text =
        "# value thesis_error thesis_sd thesis_landmarks error sd minimum maximum landmarks sd "
        "minimum maximum\n";
    const auto sd = [](const Spread& spread) {
        return fmt::format("{:.6g}", std::sqrt(spread.variance.value_or(0.0)));
    };
    for (const ReproducedRow& row : figure.rows) {
        text += fmt::format(
            "{} {} {} {}", row.thesis.value, text_or(row.thesis.error_m, "{:.6g}", "NaN"),
            row.thesis.error_m ? fmt::format("{:.6g}", std::sqrt(row.thesis.error_variance))
                               : "NaN",
            row.thesis.landmarks);
        for (const auto& spread : {row.error_m, row.landmarks}) {
            text += spread ? fmt::format(" {:.6g} {} {:.6g} {:.6g}", spread->mean, sd(*spread),
                                         spread->minimum, spread->maximum)
                           : std::string(" NaN NaN NaN NaN");
        }
        text += '\n';
    }
    return text;
}

/// Factor between the greatest and the least figure of the rows, both sides.
bool wide(const ReproducedFigure& figure) {
    constexpr double kWide = 12.0;
    double least = HUGE_VAL;
    double greatest = 0.0;
    const auto take = [&](double value) {
        if (value > 0.0) least = std::min(least, value);
        greatest = std::max(greatest, value);
    };
    for (const ReproducedRow& row : figure.rows) {
        if (row.thesis.error_m) take(*row.thesis.error_m);
        if (row.error_m) take(row.error_m->mean);
    }
    return greatest > kWide * least;
}

std::string script_text(const ReproducedFigure& figure, const std::string& stem) {
    const ThesisTable& table = *figure.thesis.table;
    std::vector<std::string> marks;
    double least = HUGE_VAL;
    double greatest = 0.0;
    for (const ReproducedRow& row : figure.rows) {
        const double value = std::stod(row.thesis.value);
        least = std::min(least, value);
        greatest = std::max(greatest, value);
        marks.push_back(fmt::format("'{0}' {0}", row.thesis.value));
    }
    constexpr double kRoom = 0.04;
    const double room = std::pow(greatest / least, kRoom);
    const auto inside = [&](double value) {
        return std::min(std::max(value, least / room), greatest * room);
    };
    const std::string unit = table.unit.empty() ? "" : fmt::format(" ({})", table.unit);
    const std::string data = gnuplot_quoted(stem + ".dat");
    std::string text = fmt::format(
        "# Draw again with: gnuplot {0}.gp\n"
        "set terminal pngcairo size 640,640 font ',10'\n"
        "set output {1}\n"
        "set multiplot layout 2,1 title {2} noenhanced\n"
        "set logscale x\n"
        "set xrange [{3:.6g}:{4:.6g}]\n"
        "set xtics ({5}) noenhanced rotate by -30\n"
        "set grid\n"
        "set offsets 0, 0, graph 0.12, 0\n"
        "set key top center horizontal noenhanced\n"
        "set object 1 rectangle from {6:.6g}, graph 0 to {7:.6g}, graph 1 behind "
        "fillcolor '#e8f0e8' fillstyle solid noborder\n",
        stem, gnuplot_quoted(stem + ".png"),
        gnuplot_quoted(fmt::format("Figure {}: {}, {}{} (shaded: working range)",
                                   figure.thesis.name, figure.thesis.world, table.parameter, unit)),
        least / room, greatest * room, fmt::join(marks, ", "), inside(figure.thesis.range.least),
        inside(figure.thesis.range.greatest));
    const std::string_view thesis =
        "with yerrorlines linewidth 1.5 pointtype 4 dashtype 2 "
        "linecolor '#c04040' title 'thesis'";
    const std::string_view ours =
        "with yerrorlines linewidth 1.5 pointtype 7 pointsize 0.8 linecolor '#2050a0' title "
        "'Hitos'";
    text += "set ylabel 'map error (m)'\n";
    text += wide(figure) ? "set logscale y\nset yrange [*:*] noextend\n" : "set yrange [0:*]\n";
    text += fmt::format("plot {} using 1:2:3 {}, \\\n     '' using 1:5:6 {}\n", data, thesis, ours);
    text += "unset logscale y\nset ylabel 'landmarks'\nset yrange [0:*]\n";
    text += fmt::format(
        "plot {} using 1:4 with linespoints linewidth 1.5 pointtype 4 dashtype 2 linecolor "
        "'#c04040' title 'thesis', \\\n     '' using 1:9:10 {}, \\\n     {} with lines dashtype 3 "
        "linecolor 'black' title 'true number'\n",
        data, ours, figure.true_landmarks);
    return text + "unset multiplot\nunset output\n";
}

}  // namespace

std::string draw_reproduction(const Reproduction& reproduction, const fs::path& folder) {
    made_output_folder(folder);
    std::string problem;
    for (const ReproducedFigure& figure : reproduction.figures) {
        const std::string stem = figure.thesis.stem();
        const std::vector<PlotFile> files{{stem + ".dat", data_text(figure)},
                                          {stem + ".gp", script_text(figure, stem)}};
        const std::vector<std::string> pictures{stem + ".png"};
        const std::string failure = draw_pictures(folder, files, stem + ".gp", pictures).english();
        if (problem.empty()) problem = failure;
    }
    return problem;
}

}  // namespace hitos
