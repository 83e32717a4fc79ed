// SPDX-License-Identifier: GPL-3.0-or-later
// The changes by hand of a graph from a file: their list, and what was undone of it.
#pragma once

#include <QWidget>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "workers/graph_solver.hpp"

class QListWidget;
class QPushButton;

namespace hitos::window {

/// "Closed: 12 seen from 3".
QString edit_words(const GraphEdit& edit);
/// As a file of them would be read, which says what is wrong.
PlacedEdits placed(const std::vector<GraphEdit>& edits);
/// How many standard deviations what the changes say or drop is off in the graph, in their order;
/// nothing where that is no question.
std::vector<std::optional<double>> errors_of_edits(const ShownGraph& graph);

class GraphChanges final : public QWidget {
    Q_OBJECT

  public:
    explicit GraphChanges(QWidget* parent);

    const std::vector<GraphEdit>& edits() const { return history_[now_]; }
    void replace(std::vector<GraphEdit> edits);
    /// The list with another change. Of the same poses there is one: the later is in the place of
    /// the earlier, which `replaced` says.
    struct With {
        std::vector<GraphEdit> edits;
        QString replaced;
    };
    With with(GraphEdit edit) const;
    bool can_undo() const { return now_ > 0; }
    bool can_redo() const { return now_ + 1 < history_.size(); }
    void undo();
    void redo();
    /// The last one, which could not be made.
    void forget_last();
    /// Lists them with their errors, if the graph has these very changes.
    void show_errors(const ShownGraph& graph);

  signals:
    void changed();

  private:
    void list();
    void take_back();

    std::vector<std::vector<GraphEdit>> history_{{}};
    std::size_t now_ = 0;
    std::vector<GraphEdit> measured_;  ///< the changes that errors_ is of
    std::vector<std::optional<double>> errors_;
    QListWidget* list_;
    QPushButton* take_back_;
};

}  // namespace hitos::window
