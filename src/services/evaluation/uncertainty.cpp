// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/evaluation/uncertainty.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "hitos/base/atomic_file.hpp"
#include "hitos/services/drawing/gnuplot.hpp"

namespace hitos {
namespace {

/// gnuplot's blocks: the curves of all lines, then those of all corners; scan, sigma_1, sigma_2.
struct Curves {
    std::string text;
    std::size_t lines = 0;
    std::size_t corners = 0;
};

Curves curves_of(const UncertaintyRecord& record) {
    std::map<std::pair<FeatureKind, int>, std::string> blocks;
    for (const LandmarkSigma& entry : record.entries()) {
        // Angles in degrees, as in map files.
        const double second =
            entry.kind == FeatureKind::line ? entry.sigma_2 * 180.0 / kPi : entry.sigma_2;
        blocks[{entry.kind, entry.landmark}] +=
            fmt::format("{} {:.6g} {:.6g}\n", entry.scan + 1, entry.sigma_1, second);
    }
    Curves curves;
    for (const auto& [landmark, block] : blocks) {
        ++(landmark.first == FeatureKind::line ? curves.lines : curves.corners);
        if (!curves.text.empty()) curves.text += "\n\n";
        curves.text +=
            fmt::format("# {} {}\n{}", to_string(landmark.first), landmark.second + 1, block);
    }
    return curves;
}

std::string plot_of(const Curves& curves, bool lines, int column) {
    const std::size_t first = lines ? 0 : curves.lines;
    const std::size_t count = lines ? curves.lines : curves.corners;
    // More names than these hide the curves.
    constexpr std::size_t kMostNames = 24;
    const std::string title =
        count > kMostNames ? "notitle" : fmt::format("title sprintf('%d', i + 1 - {})", first);
    return fmt::format(
        "plot for [i={}:{}] 'uncertainty.dat' index i using 1:{} with lines lw 1.5 {}\n", first,
        first + count - 1, column, title);
}

std::string curves_script(const Curves& curves) {
    const int rows = (curves.lines > 0 ? 2 : 0) + (curves.corners > 0 ? 2 : 0);
    std::string script = fmt::format(
        "set terminal pngcairo size 1000,{}\n"
        "set output 'uncertainty.png'\n"
        "set multiplot layout {},1\n"
        "set logscale y\nset grid\nset key outside right top title 'landmark'\n"
        "set xlabel 'scan'\nset format y '%g'\n",
        320 * rows, rows);
    if (curves.lines > 0) {
        script += "set ylabel 'sigma of rho, lines (m)'\n" + plot_of(curves, true, 2);
        script += "set ylabel 'sigma of theta, lines (degrees)'\n" + plot_of(curves, true, 3);
    }
    if (curves.corners > 0) {
        script += "set ylabel 'sigma of x, corners (m)'\n" + plot_of(curves, false, 2);
        script += "set ylabel 'sigma of y, corners (m)'\n" + plot_of(curves, false, 3);
    }
    return script + "unset multiplot\n";
}

}  // namespace

void UncertaintyRecord::note(double time_s, const LandmarkMap& map) {
    const std::uint64_t scan = scans_++;
    if (scan % every_ != 0) return;
    int lines = 0;
    int corners = 0;
    for (const ICaracteristica& landmark : map) {
        int& number = landmark.kind() == FeatureKind::line ? lines : corners;
        entries_.push_back({scan, time_s, landmark.kind(), number++,
                            std::sqrt(std::max(landmark.covariance(0, 0), 0.0)),
                            std::sqrt(std::max(landmark.covariance(1, 1), 0.0))});
    }
    // A single scan is kept whole, however many landmarks it has.
    while (entries_.size() > most_entries_ && entries_.front().scan != entries_.back().scan) {
        every_ *= 2;
        std::erase_if(entries_,
                      [this](const LandmarkSigma& entry) { return entry.scan % every_ != 0; });
    }
}

void UncertaintyRecord::clear() {
    entries_.clear();
    scans_ = 0;
    every_ = 1;
}

std::string uncertainty_csv(const UncertaintyRecord& record) {
    std::string text = "scan,time_s,kind,landmark,sigma_1,sigma_2\n";
    for (const LandmarkSigma& entry : record.entries()) {
        text +=
            fmt::format("{},{},{},{},{:.9g},{:.9g}\n", entry.scan + 1, entry.time_s,
                        to_string(entry.kind), entry.landmark + 1, entry.sigma_1, entry.sigma_2);
    }
    return text;
}

Message write_uncertainty(const UncertaintyRecord& record, const std::filesystem::path& folder) {
    write_file(folder / "uncertainty.csv", uncertainty_csv(record));
    const Curves curves = curves_of(record);
    const std::vector<PlotFile> files = {{"uncertainty.dat", curves.text},
                                         {"uncertainty.gp", curves_script(curves)}};
    const std::vector<std::string> pictures = {"uncertainty.png"};
    return draw_pictures(folder, files, "uncertainty.gp", pictures,
                         curves.text.empty()
                             ? message(HITOS_TEXT("Errors", "no landmark was observed"))
                             : Message());
}

}  // namespace hitos
