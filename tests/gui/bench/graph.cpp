// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <sys/resource.h>

#include <QCheckBox>
#include <QCoreApplication>
#include <QEventLoop>
#include <QFile>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "app/main_window.hpp"
#include "hitos/base/error.hpp"
#include "hitos/services/files/g2o_file.hpp"
#include "inspect/graph_view.hpp"
#include "inspect/graph_window.hpp"
#include "measures.hpp"
#include "probe.hpp"
#include "unit/slam/manhattan.hpp"

namespace hitos::window {
namespace {

/// What the user does, until the graph is solved, and how late the window answered meanwhile.
void watch(const char* what, const std::function<void()>& act, const std::function<bool()>& done,
           double& slowest_ms) {
    Probe probe;
    const auto begin = Clock::now();
    act();
    while (!done()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    const double seconds = seconds_since(begin);
    std::vector<double> answers = probe.finish();
    std::ranges::sort(answers);
    slowest_ms = std::max(slowest_ms, quantile(answers, 1.0));
    fmt::print("{:32} {:7.2f} s  {:6.1f} ms  {:6.1f} ms\n", what, seconds, quantile(answers, 0.5),
               quantile(answers, 1.0));
}

}  // namespace

int measure_graph(MainWindow& window, int poses) {
    const QTemporaryDir folder;
    const QString path = folder.filePath("town.g2o");
    {
        const double half_m = std::max(4.0, std::sqrt(poses) / 2.9);  // as many loops for each pose
        QFile file(path);
        const PlanarGraph town = test::ManhattanWorld({.poses = poses, .half_m = half_m}).graph;
        const auto text = QByteArray::fromStdString(g2o_text(town));
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size()) {
            throw Error(verbatim(path.toStdString() + ": cannot be written"));
        }
        fmt::print("{} poses, {} edges\n", poses, town.edges.size());
    }
    window.show();
    QCoreApplication::processEvents();
    double slowest_ms = 0.0;
    GraphWindow* graph = nullptr;
    const auto rests = [&] { return graph->shown() && !graph->busy(); };
    const auto find = [&](auto*& part, const char* name) {
        part = graph->findChild<std::remove_reference_t<decltype(*part)>*>(name);
        if (part == nullptr) throw Error(verbatim(std::string("no ") + name));
    };
    fmt::print("{:32} {:>9}  {:>9}  {:>9}\n", "", "done", "median", "slowest");
    watch(
        "opened, shown and solved", [&] { graph = &window.open_graph(path); }, rests, slowest_ms);
    QLineEdit* a = nullptr;
    QLineEdit* b = nullptr;
    QPushButton* refuse = nullptr;
    QPushButton* close = nullptr;
    QCheckBox* robust = nullptr;
    find(a, "graph_a");
    find(b, "graph_b");
    find(refuse, "graph_refuse");
    find(close, "graph_close");
    find(robust, "graph_robust");
    const PlanarGraph& solved = graph->shown()->solved.graph;
    const auto loop = std::ranges::find_if(
        solved.edges, [](const PlanarEdge& edge) { return edge.to > edge.from + 1; });
    if (loop == solved.edges.end()) throw Error(verbatim("too few poses for a loop"));
    const QString from = QString::number(solved.vertices[loop->from].id);
    const QString to = QString::number(solved.vertices[loop->to].id);
    const auto name_poses = [&](const QString& one, const QString& other) {
        for (const auto& [line, id] : {std::pair(a, one), std::pair(b, other)}) {
            line->setText(id);
            emit line->textEdited(id);
        }
    };
    const auto seen = [&](std::size_t edits) {
        return [&, edits] { return graph->shown()->edits.size() == edits; };
    };
    name_poses(to, from);
    const auto refused = [&] { refuse->click(); };
    watch("a loop refused, seen", refused, seen(1), slowest_ms);
    watch(
        "… and solved", [] {}, rests, slowest_ms);
    watch(
        "robust", [&] { robust->setChecked(true); }, rests, slowest_ms);
    name_poses(QString::number(poses - 1), QString::number(poses / 2));
    watch(
        "two poses closed, seen", [&] { close->click(); }, seen(2), slowest_ms);
    watch(
        "… and solved", [] {}, rests, slowest_ms);
    int frames = 0;
    QObject::connect(&graph->view(), &CanvasView::painted, &window, [&] { ++frames; });
    constexpr int kFrames = 40;
    const auto zoom = [&] {
        // One picture after the other, ever nearer and back.
        QObject::connect(
            &graph->view(), &CanvasView::painted, graph,
            [&] { graph->view().zoom(frames < kFrames / 2 ? 1.2 : 1.0 / 1.2); },
            Qt::QueuedConnection);
        graph->view().zoom(1.2);
    };
    watch(
        "zoomed, 40 pictures", zoom, [&] { return frames >= kFrames; }, slowest_ms);
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    fmt::print("slowest answer {:.1f} ms (limit {:.0f} ms), at most {:.0f} MB resident\n",
               slowest_ms, kSlowestAnswerMs, static_cast<double>(usage.ru_maxrss) / 1024.0);
    return slowest_ms <= kSlowestAnswerMs ? 0 : 1;
}

}  // namespace hitos::window
