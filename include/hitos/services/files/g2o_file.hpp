// SPDX-License-Identifier: GPL-3.0-or-later
// Graphs of poses and landmarks as g2o's text files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/slam/planar_graph.hpp"

namespace hitos {

/// Lines of a tag that is not read.
struct UnreadLines {
    std::string tag;
    std::uint64_t lines = 0;
};

/// What a file in the format of g2o holds.
struct G2oFile {
    PlanarGraph graph;
    std::vector<UnreadLines> unread;  ///< by their tags; of very many the last is of all others
};

/// "VERTEX_SE2", "EDGE_SE2" …
std::string_view g2o_tag(PlanarVertex::Kind kind);
std::string_view g2o_tag(PlanarEdge::Kind kind);

/// Vertices and edges in the file's order, which may be any; plain or gzip. Throws FileError where
/// there is none to be read, and FormatError with the line that is none, contradicts another or
/// names a vertex that is not there, and where there is no pose.
G2oFile read_g2o(const std::filesystem::path& path);
G2oFile parse_g2o(std::string_view text, const std::string& name);

/// The text of a graph: vertices, those that are fixed, edges, each in their order. It reads back
/// as the same to the last bit. Throws Error for a number that would not be read.
std::string g2o_text(const PlanarGraph& graph);

}  // namespace hitos
