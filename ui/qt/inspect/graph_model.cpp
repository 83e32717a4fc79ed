// SPDX-License-Identifier: GPL-3.0-or-later
#include "graph_model.hpp"

#include <QCoreApplication>
#include <array>
#include <cmath>
#include <utility>

#include "look/parameter_text.hpp"

namespace hitos::window {

QString edge_words(PlanarEdge::Kind kind) {
    constexpr std::array kWords{QT_TRANSLATE_NOOP("PlanarEdge", "Between poses"),
                                QT_TRANSLATE_NOOP("PlanarEdge", "Point seen"),
                                QT_TRANSLATE_NOOP("PlanarEdge", "Line seen"),
                                QT_TRANSLATE_NOOP("PlanarEdge", "Known pose"),
                                QT_TRANSLATE_NOOP("PlanarEdge", "Known position"),
                                QT_TRANSLATE_NOOP("PlanarEdge", "Known point")};
    return translated("PlanarEdge", kWords.at(static_cast<std::size_t>(kind)));
}

GraphModel::GraphModel(QObject* parent)
    : FiguresModel({tr("From"), tr("To"), tr("Edge"), tr("Error [σ]")}, parent) {}

void GraphModel::set_graph(const ShownGraph& graph) {
    const PlanarGraph& solved = graph.solved.graph;
    std::vector<Row> rows;
    rows.reserve(graph.solved.worst.size());
    for (const std::size_t i : graph.solved.worst) {
        const PlanarEdge& edge = solved.edges[i];
        rows.push_back({i, edge.kind, edge.by_hand, solved.vertices[edge.from].id,
                        solved.vertices[edge.to].id, std::sqrt(mahalanobis_squared(solved, edge))});
    }
    change(static_cast<int>(rows.size()), [&] { rows_ = std::move(rows); });
}

QVariant GraphModel::key(int row, int column) const {
    const Row& one = rows_[static_cast<std::size_t>(row)];
    switch (column) {
        case from:
            return QVariant::fromValue<qulonglong>(one.from);
        case to:
            return QVariant::fromValue<qulonglong>(one.to);
        case kind:
            return edge_words(one.kind);
        default:
            return one.sigmas;
    }
}

QString GraphModel::text(int row, int column) const {
    const Row& one = rows_[static_cast<std::size_t>(row)];
    switch (column) {
        case from:
            return one.prior() ? QStringLiteral("–") : QString::number(one.from);
        case to:
            return QString::number(one.to);
        case kind:
            return edge_words(one.kind);
        default:
            return QString::number(one.sigmas, 'f', 3);
    }
}

bool GraphModel::strong(int row) const {
    return rows_[static_cast<std::size_t>(row)].by_hand;
}

}  // namespace hitos::window
