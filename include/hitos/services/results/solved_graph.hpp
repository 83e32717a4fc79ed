// SPDX-License-Identifier: GPL-3.0-or-later
// A graph from a file, changed by hand and solved, and the folder that it is written to.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "hitos/services/evaluation/suitability.hpp"
#include "hitos/slam/planar_graph.hpp"

namespace hitos {

/// A graph from a file as it was changed and solved.
struct SolvedGraph {
    PlanarGraph graph;
    PlanarSolution solution;
    double seconds = 0.0;            ///< that solving took
    std::vector<std::size_t> worst;  ///< of graph.edges, those of the greatest errors
};

/// Of those the ones that are off by a standard deviation at least: where a graph fits, its
/// greatest errors are none that anybody has to look at.
std::span<const std::size_t> marked_edges(const SolvedGraph& solved);

/// What there is to doubt of its numbers, which are solved whatever they are: edges that turn by
/// more than a whole turn, as in degrees, and, solved, edges ten times as far off as their
/// information says, in the mean.
std::vector<Advice> doubts_of_graph(const SolvedGraph& solved);

/// Whether errors far from the rest lose weight, and how many edges of the greatest errors are told
/// and marked.
struct GraphChoices {
    bool robust = false;
    std::size_t worst = 10;
    friend bool operator==(const GraphChoices&, const GraphChoices&) = default;
};
inline constexpr std::size_t kMostWorst = 1000;

/// Throws what edit() and solve() throw.
SolvedGraph solved_graph(PlanarGraph graph, const PlacedEdits& edits, const GraphChoices& choices,
                         PlanarStart start = PlanarStart::best, const std::stop_token& stop = {});

/// Takes graph.svg and graph.png, the picture of a solved graph, edits.txt, its changes by hand as
/// parse_vertex_edits() reads them, and graph.g2o.
class GraphFolder {
  public:
    /// Made if missing. Throws FileError where it cannot be written to, holds the results of a run,
    /// or one of the files is one of `inputs`; empty paths are none.
    GraphFolder(std::filesystem::path folder, std::span<const std::filesystem::path> inputs);
    /// A folder that was made for nothing goes.
    ~GraphFolder();
    GraphFolder(const GraphFolder&) = delete;
    GraphFolder& operator=(const GraphFolder&) = delete;

    /// Of these files the first that the folder has already.
    std::optional<std::string> held() const;
    /// In the place of those that the folder has, all or none; `name` is that of the file that the
    /// graph is from. Throws FileError.
    void write(const std::string& name, const SolvedGraph& solved,
               std::span<const GraphEdit> edits) const;

  private:
    std::filesystem::path folder_;
    std::vector<std::filesystem::path> files_;
    bool made_ = false;
};

}  // namespace hitos
