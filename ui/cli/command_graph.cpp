// SPDX-License-Identifier: GPL-3.0-or-later
// hitos-cli graph: a graph of poses and landmarks in g2o's text, solved, drawn and written again.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/plural.hpp"
#include "hitos/base/process.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/services/files/g2o_file.hpp"
#include "hitos/services/results/solved_graph.hpp"
#include "options.hpp"
#include "report.hpp"

namespace hitos::cli {
namespace {

namespace fs = std::filesystem;

struct GraphOptions {
    std::string file;
    std::string edits;
    std::string out;
    GraphChoices choices;
    bool replace = false;
    bool json = false;
};

/// Tried before the solving, which may take its time.
std::unique_ptr<GraphFolder> folder_for(const GraphOptions& options) {
    if (options.out.empty()) return nullptr;
    auto folder = std::make_unique<GraphFolder>(options.out,
                                                std::vector<fs::path>{options.file, options.edits});
    if (const auto held = folder->held(); held && !options.replace) {
        throw FileError(options.out,
                        verbatim(fmt::format("holds {}; choose another folder, or say --replace to "
                                             "put this graph in its place",
                                             *held)));
    }
    return folder;
}

PlacedEdits edits_for(const GraphOptions& options) {
    if (options.edits.empty()) return {};
    PlacedEdits edits =
        parse_vertex_edits(input::read_text(options.edits, input::kLargestSettings), options.edits);
    if (edits.edits.empty())
        fmt::print(stderr, "{}: has no change by hand\n", on_one_line(options.edits));
    return edits;
}

template <class Kind>
void tell_count(Report& report, const PlanarGraph& graph, Kind kind) {
    const std::size_t count = graph.count(kind);
    if (count > 0) report.count(std::string(g2o_tag(kind)), count);
}

void tell_graph(Report& report, const PlanarGraph& graph, const std::vector<UnreadLines>& unread) {
    using Vertex = PlanarVertex::Kind;
    using Edge = PlanarEdge::Kind;
    for (const Vertex kind : {Vertex::pose, Vertex::point, Vertex::line}) {
        tell_count(report, graph, kind);
    }
    for (const Edge kind : {Edge::step, Edge::point, Edge::line, Edge::pose_prior,
                            Edge::position_prior, Edge::point_prior}) {
        tell_count(report, graph, kind);
    }
    report.count("fixed", std::ranges::count(graph.vertices, true, &PlanarVertex::fixed));
    nlohmann::ordered_json& told = report.object()["unread"] = nlohmann::ordered_json::object();
    for (const UnreadLines& lines : unread) {
        told[lines.tag] = lines.lines;
        report.warn(fmt::format(
            "{} of {} {} passed over, and not written: what {} says is not "
            "known here",
            plural(lines.lines, "line"), lines.tag, lines.lines == 1 ? "is" : "are", lines.tag));
    }
}

void tell_solution(Report& report, const SolvedGraph& solved) {
    const PlanarGraph& graph = solved.graph;
    const PlanarSolution& solution = solved.solution;
    constexpr std::size_t kMostNamed = 10;
    report.count("parts", solution.parts);
    nlohmann::ordered_json& held = report.object()["held"] = nlohmann::ordered_json::array();
    std::vector<std::string> named;
    for (const std::uint32_t vertex : solution.held) {
        held.push_back(graph.vertices[vertex].id);
        if (named.size() < kMostNamed) named.push_back(std::to_string(graph.vertices[vertex].id));
    }
    if (held.size() > named.size()) named.emplace_back("…");
    if (!held.empty()) {
        report.note(fmt::format("nothing is fixed in {}: held {} vertex {}",
                                plural(held.size(), "part"), held.size() == 1 ? "is" : "are",
                                fmt::join(named, ", ")));
    }
    report.figure("chi_square_before", solution.chi_square_before, 6);
    report.figure("chi_square_after", solution.chi_square_after, 6);
    report.count("steps", solution.steps);
    report.figure("seconds", solved.seconds, 3);
    report.figure("greatest_move_m", solution.greatest_move_m, 6);
    report.object()["converged"] = solution.converged;
    if (!solution.converged) {
        report.warn(
            "further steps would still move the graph: it may have no best place; are edges false? "
            "--robust takes their weight from those that are far from the rest");
    }
}

void tell_worst(Report& report, const SolvedGraph& solved) {
    const PlanarGraph& graph = solved.graph;
    nlohmann::ordered_json& told = report.object()["worst"] = nlohmann::ordered_json::array();
    for (const std::size_t i : solved.worst) {
        const PlanarEdge& edge = graph.edges[i];
        const double distance = std::sqrt(mahalanobis_squared(graph, edge));
        const std::uint64_t from = graph.vertices[edge.from].id;
        const std::uint64_t to = graph.vertices[edge.to].id;
        report.say("worst {} {} {:.3f}\n", g2o_tag(edge.kind),
                   edge.prior() ? fmt::format("{}", to) : fmt::format("{} {}", from, to), distance);
        told.push_back(
            {{"edge", g2o_tag(edge.kind)}, {"from", from}, {"to", to}, {"mahalanobis", distance}});
    }
}

void solve_graph(GraphOptions options) {
    options.file = input_named(options.file, "graph");
    if (!options.edits.empty()) options.edits = input_named(options.edits, "--edits");
    const StopByRequest request;  // what is half written is cleared
    const std::unique_ptr<GraphFolder> folder = folder_for(options);
    G2oFile file = read_g2o(options.file);
    const PlacedEdits edits = edits_for(options);
    const SolvedGraph solved = solved_graph(std::move(file.graph), edits, options.choices);
    if (StopByRequest::wanted()) throw CLI::RuntimeError(StopByRequest::status());
    Report report(options.json);
    report.object()["file"] = options.file;
    if (!edits.edits.empty()) report.count("edits", edits.edits.size());
    tell_graph(report, solved.graph, file.unread);
    tell_solution(report, solved);
    for (const Advice& doubt : doubts_of_graph(solved)) report.warn(doubt.words());
    tell_worst(report, solved);
    if (folder) {
        folder->write(fs::path(options.file).filename().string(), solved, edits.edits);
        report.say("graph.g2o, graph.svg, graph.png and edits.txt in {}\n",
                   on_one_line(options.out));
        report.object()["folder"] = options.out;
    }
    report.end();
}

}  // namespace

void add_graph(CLI::App& program) {
    auto options = std::make_shared<GraphOptions>();
    CLI::App* command = program.add_subcommand(
        "graph", "Solve a graph of poses and landmarks, as g2o's text has it (docs/formats.md)");
    command->add_option("graph", options->file, "Graph (g2o, may be packed with gzip)")->required();
    command
        ->add_option("--out", options->out,
                     "Folder for the solved graph.g2o, its picture, graph.svg and graph.png, and "
                     "its changes, edits.txt; made if missing")
        ->check(&complaint_of_output);
    command->add_option(
        "--edits", options->edits,
        "File of changes by hand, one a line: \"refuse A B\", \"close A B X Y "
        "THETA\" (A seen from B), \"fix A X Y THETA\", \"slip A\"; A and B are ids of "
        "poses");
    command->add_flag("--robust", options->choices.robust,
                      "Edges far from the rest lose weight (Cauchy's loss); else plain least "
                      "squares, whose chi square other solvers have too");
    command
        ->add_option("--worst", options->choices.worst,
                     "How many edges of the greatest errors are told and marked (default: 10)")
        ->check(CLI::Range(std::size_t{0}, kMostWorst));
    command->add_flag("--replace", options->replace,
                      "Put the files in the place of those that the folder has");
    add_report_option(*command, options->json);
    command->callback([options] { solve_graph(*options); });
}

}  // namespace hitos::cli
