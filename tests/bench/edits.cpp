// SPDX-License-Identifier: GPL-3.0-or-later
// How soon a change by hand is seen, and how near what is foreseen comes to what the tour gives.
//
// usage: build/release/bench/bench_edits [--key M] [--most N] TOUR...
//
// TOUR is a log or a world, run by the preset "recorded", or a configuration (.cfg); with a key
// scan every M metres (default: the configuration's). Then up to N of its loops (default 5, spread
// over the tour) are refused, each taken back again, and 0.5 m is put between a scan in the middle
// and where it lay. Printed for each: the time until a foreseen picture is there and until the tour
// has been taken again [s], how far that moved a scan, and how far from it the foreseen one lay
// (greatest, median [m]).

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <thread>
#include <vector>

#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/run/run_worker.hpp"
#include "hitos/workbench/open_tour.hpp"
#include "hitos/workbench/presets.hpp"

namespace {

using namespace hitos;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

std::shared_ptr<const Snapshot> next_snapshot(RunWorker& worker, const Snapshot* last) {
    SnapshotParts parts;
    parts.key_scans = true;
    worker.request_snapshot(parts);
    for (;;) {
        auto snapshot = worker.latest_snapshot();
        if (snapshot && snapshot.get() != last) return snapshot;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

/// Greatest and median distance of two paths [m].
std::pair<double, double> apart(const Trajectory& a, const Trajectory& b) {
    std::vector<double> metres;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        metres.push_back(std::hypot(a[i].pose.x - b[i].pose.x, a[i].pose.y - b[i].pose.y));
    }
    std::ranges::sort(metres);
    return {metres.back(), metres[metres.size() / 2]};
}

void change(RunWorker& worker, const std::string& name, const std::string& edits) {
    const auto before = next_snapshot(worker, worker.latest_snapshot().get());
    const auto begin = Clock::now();
    worker.set_edits(edits);
    const auto foreseen = next_snapshot(worker, nullptr);
    const double at_once = seconds_since(begin);
    worker.wait();
    const double again = seconds_since(begin);
    const auto made = next_snapshot(worker, foreseen.get());
    const auto [moved, moved_median] = apart(before->best_trajectory, made->best_trajectory);
    const auto [off, off_median] = apart(foreseen->best_trajectory, made->best_trajectory);
    fmt::print("{:28} {:8.2f} {:8.2f} {:9.3f} {:7.3f} {:9.3f} {:7.3f}{}\n", name, at_once, again,
               moved, moved_median, off, off_median, foreseen->foreseen ? "" : "  not foreseen");
    std::fflush(stdout);
}

void measure(const std::string& tour, double key_m, std::size_t most) {
    Configuracion configuration;
    if (tour.ends_with(".cfg")) {
        configuration = ArchivoConfiguracion::read(tour);
    } else {
        configuration = preset_configuration("recorded");
        configuration.source.file = tour;
    }
    if (key_m > 0.0) configuration.registration.key_distance_m = key_m;
    AlgoritmoOptions options;
    options.go_back = true;
    RunWorker worker(configuration, open_tour(configuration), options);
    const auto begin = Clock::now();
    worker.run();
    worker.wait();
    const auto whole = next_snapshot(worker, nullptr);
    std::vector<RunLoop> loops = whole->loops;
    std::erase_if(loops, [](const RunLoop& loop) { return !loop.closed(); });
    fmt::print("{}: {} scans, {} keys, {} loops, run in {:.1f} s\n", tour, whole->steps,
               whole->keys.size(), loops.size(), seconds_since(begin));
    fmt::print("{:28} {:>8} {:>8} {:>17} {:>17}\n", "", "foreseen", "again", "moved", "off");
    const std::size_t some = std::min(most, loops.size());
    for (std::size_t i = 0; i < some; ++i) {
        const RunLoop& loop = loops[i * loops.size() / some];
        const std::string text = text_of(std::vector<GraphEdit>{
            {GraphEdit::Kind::refuse, {loop.record.scan}, {loop.record.earlier}}});
        change(worker, text, text);
        change(worker, "  taken back", "");
    }
    const std::uint64_t middle = whole->keys[whole->keys.size() / 2].scan;
    const Pose lay = whole->best_trajectory[middle].pose;
    const std::string text = text_of(std::vector<GraphEdit>{
        {GraphEdit::Kind::fix, {middle}, {}, {lay.x + 0.5, lay.y, lay.theta}}});
    change(worker, fmt::format("fix {} half a metre off", middle + 1), text);
    change(worker, "  taken back", "");
}

}  // namespace

int main(int count, char** words) try {
    double key_m = 0.0;
    std::size_t most = 5;
    std::vector<std::string> tours;
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        if (word == "--key" && i + 1 < count) {
            key_m = std::stod(words[++i]);
        } else if (word == "--most" && i + 1 < count) {
            most = std::stoul(words[++i]);
        } else {
            tours.push_back(word);
        }
    }
    if (tours.empty()) throw std::runtime_error("usage: bench_edits [--key M] [--most N] TOUR...");
    for (const std::string& tour : tours) measure(tour, key_m, most);
    return 0;
} catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
}
