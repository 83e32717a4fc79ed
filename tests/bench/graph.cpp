// SPDX-License-Identifier: GPL-3.0-or-later
// How soon a change by hand of a graph from a file is a new graph, and what memory that takes.
//
// usage: build/release/bench/bench_graph POSES...
//
// For each number, in a process of its own, a made town of so many poses is solved, then one of its
// loops is refused and it is solved again from its file's places, plainly and robustly [s], and
// foreseen from where it was solved. Printed with the greatest memory that the process had [MB].

#include <fmt/core.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "hitos/services/results/solved_graph.hpp"
#include "unit/slam/manhattan.hpp"

namespace {

using namespace hitos;

double peak_mb() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void measure(int poses) {
    const double half_m = std::max(4.0, std::sqrt(poses) / 2.9);  // as many loops for each pose
    const double before_mb = peak_mb();
    const PlanarGraph town = test::ManhattanWorld({.poses = poses, .half_m = half_m}).graph;
    const auto loop = std::ranges::find_if(
        town.edges, [](const PlanarEdge& edge) { return edge.to > edge.from + 1; });
    if (loop == town.edges.end()) throw std::runtime_error("too few poses for a loop");
    const PlacedEdits edits =
        parse_vertex_edits(fmt::format("refuse {} {}", loop->to, loop->from), "");
    const auto timed = [&](PlanarGraph graph, bool robust, PlanarStart start) {
        const auto begin = std::chrono::steady_clock::now();
        SolvedGraph solved = solved_graph(std::move(graph), edits, {robust}, start);
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
        return std::pair(took.count(), std::move(solved.graph.vertices));
    };
    const auto [plain_s, places] = timed(town, false, PlanarStart::best);
    const double robust_s = timed(town, true, PlanarStart::best).first;
    PlanarGraph solved = town;
    solved.vertices = solved_graph(town, {}, {}).graph.vertices;
    const double soon_s = timed(solved, false, PlanarStart::here).first;
    fmt::print("{:8} {:8} {:9.2f} {:9.2f} {:9.2f} {:9.1f} {:9.1f}\n", poses, town.edges.size(),
               plain_s, robust_s, soon_s, peak_mb(), peak_mb() - before_mb);
}

}  // namespace

int main(int count, char** words) try {
    if (count < 2) throw std::runtime_error("usage: bench_graph POSES...");
    fmt::print("{:>8} {:>8} {:>9} {:>9} {:>9} {:>9} {:>9}\n", "poses", "edges", "plain", "robust",
               "foreseen", "MB", "of it own");
    std::fflush(stdout);
    for (int i = 1; i < count; ++i) {
        const int poses = std::stoi(words[i]);
        const pid_t child = ::fork();
        if (child < 0) throw std::runtime_error("no process could be made");
        if (child == 0) {
            int code = 0;
            try {
                measure(poses);
            } catch (const std::exception& error) {
                fmt::print(stderr, "{}\n", error.what());
                code = 1;
            }
            std::fflush(stdout);
            ::_exit(code);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        if (status != 0) return 1;
    }
    return 0;
} catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
}
