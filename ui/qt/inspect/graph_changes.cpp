// SPDX-License-Identifier: GPL-3.0-or-later
#include "graph_changes.hpp"

#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "look/named.hpp"
#include "look/undo_keys.hpp"

namespace hitos::window {
namespace {

using IdPair = std::pair<std::uint64_t, std::uint64_t>;

IdPair ids_of(std::uint64_t a, std::uint64_t b) {
    return std::minmax(a, b);
}

/// Two changes of which one alone can be in a list.
bool of_the_same_poses(const GraphEdit& a, const GraphEdit& b) {
    if (a.of_two() && b.of_two())
        return ids_of(a.scan.scan, a.earlier.scan) == ids_of(b.scan.scan, b.earlier.scan);
    return a.kind == b.kind && a.scan.scan == b.scan.scan;
}

/// The pose that a step leads to another one from: that of the next lower id.
std::uint64_t id_before(const PlanarGraph& graph, std::uint64_t id) {
    std::uint64_t before = 0;
    for (const PlanarVertex& vertex : graph.vertices) {
        if (vertex.kind == PlanarVertex::Kind::pose && vertex.id < id)
            before = std::max(before, vertex.id);
    }
    return before;
}

}  // namespace

QString edit_words(const GraphEdit& edit) {
    const QString a = QString::number(edit.scan.scan);
    const QString b = QString::number(edit.earlier.scan);
    switch (edit.kind) {
        case GraphEdit::Kind::refuse:
            return GraphChanges::tr("Refused: the edges between %1 and %2").arg(a, b);
        case GraphEdit::Kind::close:
            return GraphChanges::tr("Closed: %1 seen from %2").arg(a, b);
        case GraphEdit::Kind::fix:
            return GraphChanges::tr("Fixed: %1").arg(a);
        default:
            return GraphChanges::tr("Slipped: the step to %1").arg(a);
    }
}

PlacedEdits placed(const std::vector<GraphEdit>& edits) {
    return parse_vertex_edits(vertex_text_of(edits), {});
}

std::vector<std::optional<double>> errors_of_edits(const ShownGraph& graph) {
    const PlanarGraph& solved = graph.solved.graph;
    std::vector<std::optional<double>> errors(graph.edits.size());
    const auto note = [&](std::size_t change, const PlanarEdge& edge) {
        const double sigmas = std::sqrt(mahalanobis_squared(solved, edge));
        errors[change] = std::max(errors[change].value_or(0.0), sigmas);
    };
    // What was dropped, or taken for nothing, stands in the file alone.
    std::map<IdPair, std::size_t> of_file;
    auto by_hand = solved.edges.begin();
    for (std::size_t i = 0; i < graph.edits.size(); ++i) {
        const GraphEdit& edit = graph.edits[i];
        if (edit.has_pose()) {
            by_hand = std::find_if(by_hand, solved.edges.end(),
                                   [](const PlanarEdge& edge) { return edge.by_hand; });
            if (by_hand != solved.edges.end()) note(i, *by_hand++);
            continue;
        }
        const std::uint64_t other =
            edit.of_two() ? edit.earlier.scan : id_before(solved, edit.scan.scan);
        of_file.emplace(ids_of(edit.scan.scan, other), i);
    }
    if (of_file.empty()) return errors;
    for (const PlanarEdge& edge : graph.file->graph.edges) {
        if (edge.kind != PlanarEdge::Kind::step) continue;
        const auto found =
            of_file.find(ids_of(solved.vertices[edge.from].id, solved.vertices[edge.to].id));
        if (found != of_file.end()) note(found->second, edge);
    }
    return errors;
}

GraphChanges::GraphChanges(QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    list_ = named(new QListWidget(this), "graph_edits");
    list_->setAccessibleName(tr("Changes by hand"));
    list_->setFixedHeight(5 * fontMetrics().height());
    list_->setWordWrap(true);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setResizeMode(QListView::Adjust);
    column->addWidget(list_);
    take_back_ = named(new QPushButton(tr("Take back the change"), this), "graph_take_back");
    take_back_->setAutoDefault(false);
    take_back_->setEnabled(false);
    column->addWidget(take_back_);
    connect(take_back_, &QPushButton::clicked, this, &GraphChanges::take_back);
    connect(list_, &QListWidget::currentRowChanged, take_back_,
            [this](int row) { set_enabled(*take_back_, row >= 0, *list_); });
}

void GraphChanges::replace(std::vector<GraphEdit> edits) {
    history_.resize(now_ + 1);
    history_.push_back(std::move(edits));
    redo();
}

GraphChanges::With GraphChanges::with(GraphEdit edit) const {
    With with{edits(), {}};
    const auto former = std::ranges::find_if(
        with.edits, [&](const GraphEdit& one) { return of_the_same_poses(one, edit); });
    if (former != with.edits.end()) {
        with.replaced = tr("Another change of the same poses was given up for it: %1.")
                            .arg(edit_words(*former));
        with.edits.erase(former);
    }
    with.edits.push_back(std::move(edit));
    return with;
}

void GraphChanges::undo() {
    if (!can_undo()) return;
    --now_;
    list();
    emit changed();
}

void GraphChanges::redo() {
    if (!can_redo()) return;
    ++now_;
    list();
    emit changed();
}

void GraphChanges::forget_last() {
    if (!can_undo()) return;
    history_.resize(now_--);
    list();
}

void GraphChanges::show_errors(const ShownGraph& graph) {
    measured_ = graph.edits;
    errors_ = errors_of_edits(graph);
    list();
}

/// With the numbers that what is wrong is told by.
void GraphChanges::list() {
    QStringList words;
    for (std::size_t i = 0; i < edits().size(); ++i) {
        const GraphEdit& edit = edits()[i];
        QString line = QString("%1. %2").arg(i + 1).arg(edit_words(edit));
        if (measured_ == edits() && errors_[i])
            line += ' ' + tr("(%1 σ off)").arg(*errors_[i], 0, 'f', 1);
        if (!edit.comment.empty()) line += " – " + QString::fromStdString(edit.comment);
        words << line;
    }
    const int row = list_->currentRow();
    {
        const QSignalBlocker quiet(list_);
        while (list_->count() > words.size()) delete list_->takeItem(list_->count() - 1);
        for (int i = 0; i < words.size(); ++i) {
            if (i == list_->count()) list_->addItem(QString());
            list_->item(i)->setText(words[i]);
        }
        list_->setCurrentRow(row < words.size() ? row : -1);
    }
    set_enabled(*take_back_, list_->currentRow() >= 0, *list_);
}

void GraphChanges::take_back() {
    std::vector<GraphEdit> next = edits();
    const int chosen = list_->currentRow();
    if (chosen < 0 || static_cast<std::size_t>(chosen) >= next.size()) return;
    next.erase(next.begin() + chosen);
    list_->setCurrentRow(-1);
    replace(std::move(next));
}

}  // namespace hitos::window
