// SPDX-License-Identifier: GPL-3.0-or-later
// A graph of poses and landmarks, as its file has it or solved.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "legend_strip.hpp"
#include "views/canvas_view.hpp"
#include "workers/graph_solver.hpp"

namespace hitos::window {

class GraphView final : public CanvasView {
    Q_OBJECT

  public:
    explicit GraphView(QWidget* parent = nullptr);

    void set_graph(std::shared_ptr<const ShownGraph> graph);
    /// Whether vertices stand where the file has them.
    void show_before(bool on);
    /// What stands out: an edge, and poses with their names, by their places in the graph.
    struct Chosen {
        std::optional<std::size_t> edge;
        std::vector<std::pair<std::uint32_t, QString>> poses;
    };
    void choose(Chosen chosen);
    /// Of the graph that is shown.
    const PlanarEdge& edge_at(std::size_t edge) const { return graph_->solved.graph.edges[edge]; }
    /// Where a vertex is shown [m].
    Point2 place_of(std::uint32_t vertex) const;

  signals:
    void pose_clicked(std::uint32_t vertex);
    void edge_clicked(quint64 edge);

  protected:
    void paint_scene(QPainter& painter, const Scene& scene) const override;
    QRectF content() const override;
    double band_above(const QSizeF& size) const override;
    QString file_name() const override { return QStringLiteral("graph"); }
    std::optional<ICaracteristica> landmark_below(const QPointF& /*point*/) const override {
        return std::nullopt;
    }
    void click(const QPointF& point) override;
    QString empty_text() const override;

  private:
    const GraphShape& shape() const { return before_ ? graph_->before : graph_->after; }
    std::span<const PlanarVertex> vertices() const;
    void paint_chosen(QPainter& painter, const Scene& scene) const;
    LegendStrip legend(const Colours& c, double width) const;
    /// As they stand in the table, the first of them.
    std::span<const GraphShape::Segment> marked() const {
        return std::span(shape().marked).first(marked_);
    }

    std::shared_ptr<const ShownGraph> graph_;
    std::size_t marked_ = 0;  ///< how many are off enough
    bool before_ = false;
    Chosen chosen_;
};

}  // namespace hitos::window
