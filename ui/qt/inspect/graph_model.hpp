// SPDX-License-Identifier: GPL-3.0-or-later
// The edges of a graph that have the greatest errors, as rows of figures.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "look/figures_table.hpp"
#include "workers/graph_solver.hpp"

namespace hitos::window {

/// "Between poses" …
QString edge_words(PlanarEdge::Kind kind);

class GraphModel final : public FiguresModel {
    Q_OBJECT

  public:
    enum Column { from, to, kind, error };

    struct Row {
        std::size_t edge = 0;  ///< of the graph
        PlanarEdge::Kind kind = PlanarEdge::Kind::step;
        bool by_hand = false;
        std::uint64_t from = 0;  ///< ids
        std::uint64_t to = 0;
        double sigmas = 0.0;  ///< standard deviations

        bool prior() const { return kind >= PlanarEdge::Kind::pose_prior; }
    };

    explicit GraphModel(QObject* parent);
    void set_graph(const ShownGraph& graph);
    const std::vector<Row>& rows() const { return rows_; }

  protected:
    QVariant key(int row, int column) const override;
    QString text(int row, int column) const override;
    /// Those put in by hand.
    bool strong(int row) const override;

  private:
    std::vector<Row> rows_;
};

}  // namespace hitos::window
