// SPDX-License-Identifier: GPL-3.0-or-later
// hitos-cli graph: a graph of poses and landmarks in g2o's text, solved, drawn and written again.

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/file_exchange.hpp"
#include "hitos/base/input_files.hpp"
#include "hitos/base/plural.hpp"
#include "hitos/base/process.hpp"
#include "hitos/base/staged_files.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/services/drawing/graph_figure.hpp"
#include "hitos/services/files/g2o_file.hpp"
#include "hitos/services/results/results.hpp"
#include "options.hpp"
#include "report.hpp"

namespace hitos::cli {
namespace {

namespace fs = std::filesystem;

struct GraphOptions {
    std::string file;
    std::string edits;
    std::string out;
    std::size_t worst = 10;
    bool robust = false;
    bool replace = false;
    bool json = false;
};

std::vector<fs::path> outputs_of(const GraphOptions& options) {
    std::vector<fs::path> files;
    if (options.out.empty()) return files;
    // The graph last: it says that the others are whole.
    for (const char* name : {"graph.svg", "graph.png", "graph.g2o"}) {
        files.push_back(fs::path(options.out) / name);
    }
    return files;
}

/// Tried before the solving, which may take its time. One that was made for nothing goes.
class GraphFolder {
  public:
    explicit GraphFolder(fs::path folder) : folder_(std::move(folder)) {
        made_ = !is_there(folder_);
        prepare_output_folder(folder_);
    }
    ~GraphFolder() {
        if (made_) ::rmdir(folder_.c_str());  // not where there is anything in it
    }
    GraphFolder(const GraphFolder&) = delete;
    GraphFolder& operator=(const GraphFolder&) = delete;

  private:
    fs::path folder_;
    bool made_ = false;
};

void check_outputs(const GraphOptions& options, const std::vector<fs::path>& outputs) {
    if (is_there(fs::path(options.out) / "summary.json")) {
        throw FileError(options.out, verbatim("holds the results of a run, which would not be what "
                                              "they were; choose another folder"));
    }
    check_apart(outputs, std::vector<fs::path>{options.file, options.edits});
    for (const fs::path& output : outputs) {
        if (options.replace || !is_there(output)) continue;
        throw FileError(options.out,
                        verbatim(fmt::format("holds {}; choose another folder, or say --replace to "
                                             "put this graph in its place",
                                             output.filename().string())));
    }
}

template <class Kind>
void tell_count(Report& report, const PlanarGraph& graph, Kind kind) {
    const std::size_t count = graph.count(kind);
    if (count > 0) report.count(std::string(g2o_tag(kind)), count);
}

void tell_graph(Report& report, const G2oFile& file) {
    using Vertex = PlanarVertex::Kind;
    using Edge = PlanarEdge::Kind;
    for (const Vertex kind : {Vertex::pose, Vertex::point, Vertex::line}) {
        tell_count(report, file.graph, kind);
    }
    for (const Edge kind : {Edge::step, Edge::point, Edge::line, Edge::pose_prior,
                            Edge::position_prior, Edge::point_prior}) {
        tell_count(report, file.graph, kind);
    }
    report.count("fixed", std::ranges::count(file.graph.vertices, true, &PlanarVertex::fixed));
    nlohmann::ordered_json& unread = report.object()["unread"] = nlohmann::ordered_json::object();
    for (const UnreadLines& lines : file.unread) {
        unread[lines.tag] = lines.lines;
        report.warn(fmt::format(
            "{} of {} {} passed over, and not written: what {} says is not "
            "known here",
            plural(lines.lines, "line"), lines.tag, lines.lines == 1 ? "is" : "are", lines.tag));
    }
}

void tell_solution(Report& report, const PlanarGraph& graph, const PlanarSolution& solution,
                   double seconds) {
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
    report.figure("seconds", seconds, 3);
    report.figure("greatest_move_m", solution.greatest_move_m, 6);
    report.object()["converged"] = solution.converged;
    if (!solution.converged) {
        report.warn(
            "further steps would still move the graph: it may have no best place; are edges false? "
            "--robust takes their weight from those that are far from the rest");
    }
}

/// The edges of the greatest errors.
std::vector<std::size_t> tell_worst(Report& report, const PlanarGraph& graph, std::size_t most) {
    std::vector<std::size_t> edges = worst_edges(graph, most);
    nlohmann::ordered_json& told = report.object()["worst"] = nlohmann::ordered_json::array();
    for (const std::size_t i : edges) {
        const PlanarEdge& edge = graph.edges[i];
        const double distance = std::sqrt(mahalanobis_squared(graph, edge));
        const std::uint64_t from = graph.vertices[edge.from].id;
        const std::uint64_t to = graph.vertices[edge.to].id;
        report.say("worst {} {} {:.3f}\n", g2o_tag(edge.kind),
                   edge.prior() ? fmt::format("{}", to) : fmt::format("{} {}", from, to), distance);
        told.push_back(
            {{"edge", g2o_tag(edge.kind)}, {"from", from}, {"to", to}, {"mahalanobis", distance}});
    }
    return edges;
}

void write_graph(const GraphOptions& options, const PlanarGraph& graph,
                 const std::vector<std::size_t>& worst, const std::vector<fs::path>& outputs) {
    constexpr double kPixelsPerMm = 10.0;
    const VectorDrawing figure =
        graph_figure(fs::path(options.file).filename().string(), graph, worst);
    StagedFiles staged(outputs);
    staged.write([&] {
        write_file(staged.staged(outputs[0]), svg_text(figure));
        write_file(staged.staged(outputs[1]), png_text(figure, kPixelsPerMm));
        write_file(staged.staged(outputs[2]), g2o_text(graph));
    });
    staged.commit();
}

void solve_graph(GraphOptions options) {
    options.file = input_named(options.file, "graph");
    if (!options.edits.empty()) options.edits = input_named(options.edits, "--edits");
    const std::vector<fs::path> outputs = outputs_of(options);
    std::optional<GraphFolder> folder;
    if (!outputs.empty()) {
        folder.emplace(options.out);
        check_outputs(options, outputs);
    }
    G2oFile file = read_g2o(options.file);
    Report report(options.json);
    report.object()["file"] = options.file;
    if (!options.edits.empty()) {
        const PlacedEdits edits = parse_vertex_edits(
            input::read_text(options.edits, input::kLargestSettings), options.edits);
        if (edits.edits.empty()) {
            throw FormatError(options.edits, 0, verbatim("has no change; expected at least one"));
        }
        edit(file.graph, edits);
        report.count("edits", edits.edits.size());
    }
    tell_graph(report, file);
    const auto begin = std::chrono::steady_clock::now();
    const PlanarSolution solution = solve(file.graph, options.robust);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    tell_solution(report, file.graph, solution, took.count());
    const std::vector<std::size_t> worst = tell_worst(report, file.graph, options.worst);
    if (!outputs.empty()) {
        write_graph(options, file.graph, worst, outputs);
        report.say("graph.g2o, graph.svg and graph.png in {}\n", on_one_line(options.out));
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
                     "Folder for the solved graph.g2o and its picture, graph.svg and graph.png, "
                     "made if missing")
        ->check(&complaint_of_output);
    command->add_option(
        "--edits", options->edits,
        "File of changes by hand, one a line: \"refuse A B\", \"close A B X Y "
        "THETA\" (A seen from B), \"fix A X Y THETA\", \"slip A\"; A and B are ids of "
        "poses");
    command->add_flag("--robust", options->robust,
                      "Edges far from the rest lose weight (Cauchy's loss); else plain least "
                      "squares, whose chi square other solvers have too");
    constexpr std::size_t kMostWorst = 1000;
    command
        ->add_option("--worst", options->worst,
                     "How many edges of the greatest errors are told and marked (default: 10)")
        ->check(CLI::Range(std::size_t{0}, kMostWorst));
    command->add_flag("--replace", options->replace,
                      "Put the files in the place of those that the folder has");
    add_report_option(*command, options->json);
    command->callback([options] { solve_graph(*options); });
}

}  // namespace hitos::cli
