// SPDX-License-Identifier: GPL-3.0-or-later
#include "calibration_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "hitos/base/atomic_file.hpp"
#include "hitos/services/drawing/gnuplot.hpp"
#include "hitos/services/study/calibration_figures.hpp"
#include "json_input.hpp"

namespace hitos::study {
namespace {

bool has(const CalibrationCurve& curve, const CalibrationKind& kind) {
    return has_shares(*curve.figures, kind);
}

/// A block for each curve: what it ought to be, and the shares of the panels.
std::string data_text(std::span<const CalibrationCurve> curves) {
    std::string text = "# expected poses landmarks distances\n";
    for (const CalibrationCurve& curve : curves) {
        if (&curve != &curves.front()) text += "\n\n";
        for (std::size_t region = 0; region < kRegions.size(); ++region) {
            text += fmt::format("{:.2f}", kRegions.at(region));
            for (const CalibrationKind& kind : kCalibrationKinds) {
                const auto seen = shares_in_regions(*curve.figures, kind).at(region);
                text += seen ? fmt::format(" {}", *seen) : " NaN";
            }
            text += '\n';
        }
    }
    return text;
}

std::string script_text(const std::string& stem, std::span<const CalibrationCurve> curves) {
    std::vector<std::size_t> panels;
    for (std::size_t i = 0; i < kCalibrationKinds.size(); ++i) {
        const auto has_it = [&](const CalibrationCurve& curve) {
            return has(curve, kCalibrationKinds.at(i));
        };
        if (std::ranges::any_of(curves, has_it)) panels.push_back(i);
    }
    constexpr int kWidth = 430;  // pixels, of a panel
    constexpr std::size_t kLetter = 9;
    constexpr std::size_t kBeside = 80;
    std::size_t longest = 20;
    for (const CalibrationCurve& curve : curves) longest = std::max(longest, curve.name.size());
    // What the curves are called, at the right.
    const auto legend = static_cast<int>(kLetter * longest + kBeside);
    constexpr int kAxis = 85;
    constexpr int kGap = 15;
    constexpr int kLine = 20;                       // of the legend
    constexpr std::size_t kColours = 8;             // of gnuplot's lines, which then begin anew
    constexpr std::array kDashes{1, 3, 4, 5};       // 2 is what ought to be
    constexpr std::array kPoints{7, 5, 9, 13, 11};  // filled
    const int height = std::max(kWidth + kAxis / 3, kLine * (static_cast<int>(curves.size()) + 4));
    const int width = kWidth * static_cast<int>(panels.size()) + legend;
    std::string body =
        "set xlabel 'expected share'\nset ylabel 'share seen'\nset grid\n"
        "set xrange [0.45:1.02]\nset yrange [-0.04:1.04]\n"
        "set xtics (0.5, 0.68, 0.95, '' 0.99)\nset size ratio 1\n";
    for (std::size_t at = 0; at < panels.size(); ++at) {
        const std::size_t place = panels[at];
        const bool last = at + 1 == panels.size();
        const int left = kWidth * static_cast<int>(at);
        body += last ? "set key at screen 0.995,0.9 right top noenhanced\n" : "set key off\n";
        body +=
            fmt::format("set title 'true {} in the region'\n", kCalibrationKinds.at(place).name);
        body += fmt::format("set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\n",
                            static_cast<double>(left + kAxis) / width,
                            static_cast<double>(left + kWidth - kGap) / width);
        std::string plot =
            "plot x with lines dashtype 2 linecolor 'black' title 'as it ought to be'";
        for (std::size_t i = 0; i < curves.size(); ++i) {
            const std::size_t round = i / kColours;
            plot += fmt::format(
                ", \\\n     {} index {} using 1:{} with linespoints linewidth 1.5 dashtype {} "
                "pointtype {} pointsize 0.7 linecolor {} title {}",
                gnuplot_file(stem + ".dat"), i, place + 2, kDashes.at(round % kDashes.size()),
                kPoints.at(round % kPoints.size()), i + 1, gnuplot_quoted(curves[i].name));
        }
        body += plot + "\n";
    }
    std::string text = gnuplot_head(stem + ".gp");
    for (const auto& [extension, terminal] :
         {std::pair("png", "pngcairo"), std::pair("svg", "svg")}) {
        text += fmt::format(
            "set terminal {} size {},{}\nset output {}\nset multiplot layout 1,{}\n{}"
            "unset multiplot\n",
            terminal, width, height, gnuplot_file(stem + "." + extension), panels.size(), body);
    }
    return text + "unset output\n";
}

}  // namespace

ByMeasure<Spread> mean_shares(std::span<const ByMeasure<Spread>* const> rows) {
    ByMeasure<Spread> mean;
    for (const CalibrationKind& kind : kCalibrationKinds) {
        for (const double region : kRegions) {
            const std::string word = word_of_share(kind, region);
            std::vector<double> shares;
            for (const ByMeasure<Spread>* row : rows)
                if (const auto& seen = (*row)[word]) shares.push_back(seen->mean);
            mean[word] = spread_of(shares);
        }
    }
    return mean;
}

Message write_calibration(const StudyLayout& layout, std::vector<CalibrationCurve> curves) {
    constexpr std::size_t kLongestName = 60;
    std::erase_if(curves, [](const CalibrationCurve& curve) {  // such as another program's
        return std::ranges::none_of(kCalibrationKinds,
                                    [&](const CalibrationKind& kind) { return has(curve, kind); });
    });
    if (curves.empty()) return {};
    for (CalibrationCurve& curve : curves)
        if (curve.name.size() > kLongestName)
            curve.name = in_utf8(curve.name.substr(0, kLongestName)) + "…";
    const std::string stem = layout.prefix + kCalibrationPlot;
    const std::vector<PlotFile> files{{stem + ".dat", data_text(curves)},
                                      {stem + ".gp", script_text(stem, curves)}};
    const std::vector<std::string> pictures{stem + ".png", stem + ".svg"};
    return draw_pictures(layout.folder, files, stem + ".gp", pictures);
}

}  // namespace hitos::study
