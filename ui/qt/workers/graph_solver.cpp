// SPDX-License-Identifier: GPL-3.0-or-later
#include "graph_solver.hpp"

#include <QCoreApplication>
#include <QFileInfo>
#include <QPointer>
#include <QThreadPool>
#include <array>
#include <exception>
#include <filesystem>
#include <utility>

#include "hitos/base/error.hpp"
#include "look/words_of.hpp"
#include "session/background.hpp"

namespace hitos::window {
namespace {

struct GraphOutcome {
    std::shared_ptr<const ShownGraph> graph;
    QString problem;
};

/// Of a change the reason alone: lists of changes that were made here are no files.
QString reason_of_failure(const std::exception& error) {
    if (const auto* format = dynamic_cast<const FormatError*>(&error); format != nullptr) {
        if (format->path().empty()) return words_of(format->problem());
    }
    return words_of(error);
}

template <class Make>
GraphOutcome outcome_of(Make make) {
    try {
        return {make(), {}};
    } catch (const std::exception& error) {
        return {nullptr, reason_of_failure(error)};
    }
}

void add_shapes(ShownGraph& shown) {
    const PlanarGraph& graph = shown.solved.graph;
    shown.before = graph_shape(shown.file->graph.vertices, graph.edges, shown.solved.worst);
    shown.after = graph_shape(graph.vertices, graph.edges, shown.solved.worst);
}

std::shared_ptr<const ShownGraph> read_graph(const QString& path) {
    auto shown = std::make_shared<ShownGraph>();
    shown->file = std::make_shared<const G2oFile>(read_g2o(path.toStdString()));
    shown->solved.graph = shown->file->graph;
    shown->solved.worst = worst_edges(shown->solved.graph, shown->choices.worst);
    add_shapes(*shown);
    return shown;
}

/// From the file's places, or from those of `from`.
std::shared_ptr<const ShownGraph> solve_graph(const ShownGraph& from, const PlacedEdits& edits,
                                              const GraphChoices& choices, ShownGraph::Stage stage,
                                              const std::stop_token& stop) {
    const bool foreseen = stage == ShownGraph::Stage::foreseen;
    auto shown = std::make_shared<ShownGraph>();
    shown->file = from.file;
    shown->choices = choices;
    shown->edits = edits.edits;
    shown->stage = stage;
    PlanarGraph graph = from.file->graph;
    if (foreseen) graph.vertices = from.solved.graph.vertices;
    shown->solved = solved_graph(std::move(graph), edits, choices,
                                 foreseen ? PlanarStart::here : PlanarStart::best, stop);
    add_shapes(*shown);
    return shown;
}

}  // namespace

GraphSolver::GraphSolver(QString path, QObject* parent) : QObject(parent), path_(std::move(path)) {}

GraphSolver::~GraphSolver() {
    stop_.request_stop();
}

template <class Work, class Take>
void GraphSolver::start(Work work, Take take) {
    ++at_work_;
    emit busy_changed();
    QThreadPool::globalInstance()->start([self = QPointer(this), work, take] {
        begin_background_work();
        auto outcome = work();
        QMetaObject::invokeMethod(qApp, [self, take, outcome = std::move(outcome)] {
            if (!self) return;
            take(*self, outcome);
            if (self) self->work_ended();
        });
    });
}

void GraphSolver::work_ended() {
    --at_work_;
    emit busy_changed();
}

void GraphSolver::read() {
    start([path = path_] { return outcome_of([&] { return read_graph(path); }); },
          [](GraphSolver& self, const GraphOutcome& outcome) {
              if (!outcome.graph) {
                  emit self.not_read(outcome.problem);
                  return;
              }
              self.shown_ = outcome.graph;
              emit self.changed();
          });
}

void GraphSolver::solve(const PlacedEdits& edits, const GraphChoices& choices) {
    constexpr double kSoon = 0.5;  // [s]
    stop_.request_stop();
    stop_ = std::stop_source();
    const quint64 number = ++number_;
    const auto take = [number](GraphSolver& self, const GraphOutcome& outcome) {
        if (number != self.number_) return;
        if (outcome.graph) {
            self.shown_ = outcome.graph;
            emit self.changed();
        } else {
            emit self.not_solved(outcome.problem);
        }
    };
    const auto tell = [self = QPointer(this), take](const GraphOutcome& outcome) {
        QMetaObject::invokeMethod(qApp, [self, take, outcome] {
            if (self) take(*self, outcome);
        });
    };
    start(
        [from = shown_, edits, choices, tell, stop = stop_.get_token()] {
            const auto solved = [&](ShownGraph::Stage stage) {
                return outcome_of([&] { return solve_graph(*from, edits, choices, stage, stop); });
            };
            if (from->solved.seconds > kSoon) {
                GraphOutcome foreseen = solved(ShownGraph::Stage::foreseen);
                if (!foreseen.graph) return foreseen;
                tell(foreseen);
            }
            return solved(ShownGraph::Stage::solved);
        },
        take);
}

void GraphSolver::write(const QString& folder) {
    const auto work = [graph = shown_, folder, path = path_] {
        try {
            const std::array<std::filesystem::path, 1> inputs{path.toStdString()};
            GraphFolder place(folder.toStdString(), inputs);
            place.write(QFileInfo(path).fileName().toStdString(), graph->solved, graph->edits);
            return QString();
        } catch (const std::exception& error) {
            return words_of(error);
        }
    };
    start(work, [folder](GraphSolver& self, const QString& problem) {
        emit self.written(folder, problem);
    });
}

}  // namespace hitos::window
