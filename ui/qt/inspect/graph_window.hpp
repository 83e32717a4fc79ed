// SPDX-License-Identifier: GPL-3.0-or-later
// A graph of poses from a file: seen, solved, changed by hand and written again.
#pragma once

#include <QDialog>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "graph_changes.hpp"
#include "look/figures_table.hpp"
#include "look/prompts.hpp"
#include "look/user_files.hpp"
#include "views/figure.hpp"
#include "workers/graph_solver.hpp"

class QCheckBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace hitos::window {

class GraphHand;
class GraphModel;
class GraphView;

/// What hitos-cli graph does, with the same files. A change is solved at once.
class GraphWindow final : public QDialog {
    Q_OBJECT

  public:
    /// The file is read beside the window; where it is no graph the user is told, and it closes.
    GraphWindow(const QString& path, UserFiles& files, Prompts& prompts, QWidget* parent);

    /// Whether the window may close: changes that are written nowhere are asked about.
    bool may_end();
    /// Reading, solving or writing.
    bool busy() const { return solver_->busy(); }
    std::shared_ptr<const ShownGraph> shown() const { return solver_->shown(); }
    const std::vector<GraphEdit>& edits() const { return changes_->edits(); }
    GraphView& view() const { return *view_; }
    FiguresTable& table() const { return *table_; }
    void reject() override;

  signals:
    void notice(QString text);
    void picture_wanted(const hitos::window::Exportable& figure);

  private:
    QWidget* made_tools();
    QWidget* made_column();
    QPushButton* made_button(QWidget* parent, const char* name, const QString& words,
                             const QString& tip, void (GraphWindow::*pressed)());

    void take_graph();
    void make_room_for_table();
    void tell_not_read(const QString& problem);
    void tell_not_solved(const QString& problem);
    void end_writing(const QString& folder, const QString& problem);

    void solve();
    /// Whether it was taken.
    bool change(std::vector<GraphEdit> edits);
    void add(const GraphEdit& edit);
    void open_edits();
    void save();

    void choose_edge(const std::optional<std::size_t>& edge);
    void take_pose(std::uint32_t vertex);
    void show_chosen();
    void show_state();

    UserFiles& files_;
    Prompts& prompts_;
    GraphSolver* solver_;
    GraphModel* model_;
    GraphView* view_ = nullptr;
    FiguresTable* table_ = nullptr;
    QCheckBox* robust_ = nullptr;
    QSpinBox* worst_ = nullptr;
    QPushButton* undo_ = nullptr;
    QPushButton* redo_ = nullptr;
    QPushButton* before_ = nullptr;
    QPushButton* save_ = nullptr;
    QPushButton* open_edits_ = nullptr;
    GraphHand* hand_ = nullptr;
    GraphChanges* changes_ = nullptr;
    QLabel* words_ = nullptr;
    std::vector<GraphEdit> saved_;     ///< those that are written somewhere
    std::vector<GraphEdit> writing_;   ///< those that are being written
    std::optional<std::size_t> edge_;  ///< chosen, of shown()
    QString told_;                     ///< what was done last
};

}  // namespace hitos::window
