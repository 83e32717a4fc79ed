// SPDX-License-Identifier: GPL-3.0-or-later
#include "graph_words.hpp"

#include <QStringList>

#include "graph_window.hpp"
#include "look/words_of.hpp"

namespace hitos::window {

QString graph_words(const ShownGraph* graph, bool busy) {
    if (!graph) return GraphWindow::tr("The graph is being read…");
    const PlanarGraph& solved = graph->solved.graph;
    QStringList words{GraphWindow::tr("Poses: %1, edges: %2.")
                          .arg(solved.count(PlanarVertex::Kind::pose))
                          .arg(solved.edges.size())};
    for (const UnreadLines& lines : graph->file->unread) {
        words << GraphWindow::tr(
                     "Passed over, and not written, for what they say is not known here: %1 of %2.")
                     .arg(counted_words(lines.lines, GraphWindow::tr("1 line"),
                                        GraphWindow::tr("%1 lines")),
                          QString::fromStdString(lines.tag));
    }
    const PlanarSolution& solution = graph->solved.solution;
    // What is foreseen begins where the graph before lies, not where the file has it.
    if (graph->stage == ShownGraph::Stage::foreseen) {
        words << GraphWindow::tr("χ² %1, foreseen; it is being solved from the beginning.")
                     .arg(solution.chi_square_after, 0, 'g', 6);
    } else if (graph->stage != ShownGraph::Stage::read) {
        words << GraphWindow::tr("χ² %1 → %2, up to %3 m moved.")
                     .arg(solution.chi_square_before, 0, 'g', 6)
                     .arg(solution.chi_square_after, 0, 'g', 6)
                     .arg(solution.greatest_move_m, 0, 'f', 3);
        if (!solution.held.empty()) {
            words
                << GraphWindow::tr(
                       "Nothing is fixed in %1 of %2 parts: one vertex of each is held, %3 first.")
                       .arg(solution.held.size())
                       .arg(solution.parts)
                       .arg(solved.vertices[solution.held.front()].id);
        }
    }
    if (graph->stage == ShownGraph::Stage::solved) {
        for (const Advice& doubt : doubts_of_graph(graph->solved)) words << words_of(doubt);
    }
    if (graph->stage == ShownGraph::Stage::solved && !solution.converged) {
        words << GraphWindow::tr(
            "Further steps would still move the graph: are edges false? “Robust” takes "
            "their weight from those that are far from the rest.");
    } else if (busy && graph->stage != ShownGraph::Stage::foreseen) {
        words << GraphWindow::tr("At work…");
    }
    return words.join(' ');
}

}  // namespace hitos::window
