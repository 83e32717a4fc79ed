// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/results/solved_graph.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "drawing/graph_figure.hpp"
#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/file_exchange.hpp"
#include "hitos/base/geometry.hpp"
#include "hitos/base/input_files.hpp"
#include "hitos/base/staged_files.hpp"
#include "hitos/base/translatable.hpp"
#include "hitos/services/files/g2o_file.hpp"
#include "hitos/services/results/results.hpp"

namespace hitos {

std::vector<Advice> doubts_of_graph(const SolvedGraph& solved) {
    using Kind = PlanarEdge::Kind;
    constexpr double kMostTurn = 2.001 * kPi;
    constexpr double kMostDeviation = 10.0;
    const PlanarGraph& graph = solved.graph;
    std::size_t turned = 0;
    std::size_t figures = 0;
    for (const PlanarEdge& edge : graph.edges) {
        const bool turns = edge.kind == Kind::step || edge.kind == Kind::pose_prior;
        const double angle = turns ? edge.z(2) : edge.kind == Kind::line ? edge.z(0) : 0.0;
        if (std::abs(angle) > kMostTurn) ++turned;
        figures += static_cast<std::size_t>(edge.size());
    }
    for (const PlanarVertex& vertex : graph.vertices) {
        const std::size_t free = vertex.kind == PlanarVertex::Kind::pose ? 3 : 2;
        if (!vertex.fixed) figures -= std::min(figures, free);
    }
    std::vector<Advice> doubts;
    if (turned > 0) {
        doubts.push_back({HITOS_TEXT("Advice",
                                     "Of the edges %1 turn by more than a whole turn: angles of "
                                     "such a file are radians; are these degrees?"),
                          fmt::format("{}/{}", turned, graph.edges.size()),
                          {}});
    }
    if (figures == 0) return doubts;
    const double off = std::sqrt(solved.solution.chi_square_after / static_cast<double>(figures));
    if (off > kMostDeviation) {
        doubts.push_back({HITOS_TEXT("Advice",
                                     "Solved, the edges are %1 times as far off as their "
                                     "information says: are their numbers metres and radians, and "
                                     "the information the inverse of their covariance? Or are some "
                                     "of them false?"),
                          fmt::format("{:.0f}", off),
                          {}});
    }
    return doubts;
}

SolvedGraph solved_graph(PlanarGraph graph, const PlacedEdits& edits, const GraphChoices& choices,
                         PlanarStart start, const std::stop_token& stop) {
    SolvedGraph solved;
    solved.graph = std::move(graph);
    edit(solved.graph, edits);
    const auto begin = std::chrono::steady_clock::now();
    solved.solution = solve(solved.graph, choices.robust, start, stop);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    solved.seconds = took.count();
    solved.worst = worst_edges(solved.graph, choices.worst);
    return solved;
}

std::span<const std::size_t> marked_edges(const SolvedGraph& solved) {
    constexpr double kLeast = 1.0;
    const auto end = std::ranges::find_if(solved.worst, [&](std::size_t i) {
        return mahalanobis_squared(solved.graph, solved.graph.edges[i]) < kLeast;
    });
    return {solved.worst.begin(), end};
}

GraphFolder::GraphFolder(std::filesystem::path folder,
                         std::span<const std::filesystem::path> inputs)
    : folder_(std::move(folder)) {
    // The graph last: it says that the others are whole.
    for (const char* name : {"graph.svg", "graph.png", "edits.txt", "graph.g2o"}) {
        files_.push_back(folder_ / name);
    }
    check_apart(files_, inputs);
    const bool missing = !is_there(folder_);
    prepare_output_folder(folder_);
    made_ = missing;
}

GraphFolder::~GraphFolder() {
    if (made_) ::rmdir(folder_.c_str());  // not where there is anything in it
}

std::optional<std::string> GraphFolder::held() const {
    const auto file = std::ranges::find_if(files_, [](const auto& one) { return is_there(one); });
    return file == files_.end() ? std::nullopt : std::optional(file->filename().string());
}

void GraphFolder::write(const std::string& name, const SolvedGraph& solved,
                        std::span<const GraphEdit> edits) const {
    constexpr double kPixelsPerMm = 10.0;
    const std::string graph = g2o_text(solved.graph);  // which may not be written
    const VectorDrawing figure = graph_figure(name, solved.graph, marked_edges(solved));
    StagedFiles staged(files_);
    staged.write([&] {
        write_file(staged.staged(files_[0]), svg_text(figure));
        write_file(staged.staged(files_[1]), png_text(figure, kPixelsPerMm));
        write_file(staged.staged(files_[2]), fmt::format("# Changes by hand of {}\n\n{}",
                                                         on_one_line(name), vertex_text_of(edits)));
        write_file(staged.staged(files_[3]), graph);
    });
    staged.commit();
}

}  // namespace hitos
