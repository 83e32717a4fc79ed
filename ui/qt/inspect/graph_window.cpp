// SPDX-License-Identifier: GPL-3.0-or-later
#include "graph_window.hpp"

#include <QCheckBox>
#include <QDir>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QShortcut>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>
#include <initializer_list>
#include <utility>

#include "graph_changes.hpp"
#include "graph_hand.hpp"
#include "graph_model.hpp"
#include "graph_view.hpp"
#include "graph_words.hpp"
#include "hitos/base/text_input.hpp"
#include "look/flow_layout.hpp"
#include "look/named.hpp"
#include "look/screen_fit.hpp"
#include "look/steady_label.hpp"
#include "look/undo_keys.hpp"
#include "look/words_of.hpp"

namespace hitos::window {
namespace {

constexpr QSize kGraphSize(1120, 640);

/// The same edge in a graph with other changes.
std::optional<std::size_t> same_edge_in(const PlanarGraph& graph, const PlanarEdge& edge) {
    const auto found = std::ranges::find_if(graph.edges, [&](const PlanarEdge& one) {
        return one.kind == edge.kind && one.from == edge.from && one.to == edge.to &&
               one.z == edge.z;
    });
    if (found == graph.edges.end()) return std::nullopt;
    return static_cast<std::size_t>(found - graph.edges.begin());
}

}  // namespace

GraphWindow::GraphWindow(const QString& path, UserFiles& files, Prompts& prompts, QWidget* parent)
    : QDialog(parent, Qt::Window),
      files_(files),
      prompts_(prompts),
      solver_(new GraphSolver(path, this)),
      model_(new GraphModel(this)) {
    setObjectName("graph_window");
    setWindowTitle(tr("%1 – Graph").arg(QFileInfo(path).fileName()));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* column = new QVBoxLayout(this);
    column->addWidget(made_tools());
    auto* halves = new QSplitter(this);
    view_ = named(new GraphView(halves), "graph_view");
    halves->addWidget(made_column());
    halves->setStretchFactor(0, 1);
    halves->setChildrenCollapsible(false);
    column->addWidget(halves, 1);
    words_ = named(new QLabel(this), "graph_words");
    column->addWidget(keep_lines(*words_, 2));
    connect(view_, &GraphView::pose_clicked, this, &GraphWindow::take_pose);
    connect(view_, &GraphView::edge_clicked, this, [this](quint64 edge) { choose_edge(edge); });
    connect(view_, &CanvasView::picture_wanted, this,
            [this] { emit picture_wanted(view_->exportable()); });
    connect(solver_, &GraphSolver::changed, this, &GraphWindow::take_graph);
    connect(solver_, &GraphSolver::not_read, this, &GraphWindow::tell_not_read);
    connect(solver_, &GraphSolver::not_solved, this, &GraphWindow::tell_not_solved);
    connect(solver_, &GraphSolver::written, this, &GraphWindow::end_writing);
    connect(solver_, &GraphSolver::busy_changed, this, &GraphWindow::show_state);
    new UndoKeys(this);
    resize(kGraphSize);
    fit_to_screen(*this);
    show_chosen();
    solver_->read();
}

QWidget* GraphWindow::made_tools() {
    auto* bar = new QWidget(this);
    auto* row = new FlowLayout(bar, 6);
    robust_ = named(new QCheckBox(tr("Robust"), bar), "graph_robust");
    robust_->setToolTip(tr("Edges far from the rest lose weight, as false ones are"));
    connect(robust_, &QCheckBox::toggled, this, &GraphWindow::solve);
    row->addWidget(robust_);
    worst_ = named(new QSpinBox(bar), "graph_worst");
    worst_->setPrefix(tr("Greatest errors: "));
    worst_->setAccessibleName(tr("Greatest errors: "));
    worst_->setRange(0, static_cast<int>(kMostWorst));
    worst_->setValue(static_cast<int>(GraphChoices().worst));
    worst_->setKeyboardTracking(false);
    worst_->setToolTip(tr("How many edges of the greatest errors are listed and marked"));
    connect(worst_, &QSpinBox::valueChanged, this, &GraphWindow::solve);
    row->addWidget(worst_);
    before_ = made_button(bar, "graph_before", tr("As in the file"),
                          tr("Shows poses and landmarks where the file has them"), nullptr);
    before_->setCheckable(true);
    connect(before_, &QPushButton::toggled, this, [this](bool on) { view_->show_before(on); });
    row->addWidget(before_);
    for (QWidget* low : {static_cast<QWidget*>(robust_), static_cast<QWidget*>(worst_)}) {
        low->setMinimumHeight(before_->sizeHint().height());
    }
    row->addWidget(undo_ = made_button(bar, "graph_undo", tr("Undo"),
                                       tr("The last change (Ctrl+Z)"), nullptr));
    undo_->setShortcut(QKeySequence::Undo);
    connect(undo_, &QPushButton::clicked, this, [this] { changes_->undo(); });
    row->addWidget(redo_ = made_button(bar, "graph_redo", tr("Redo"),
                                       tr("The change that was undone (Ctrl+Shift+Z)"), nullptr));
    redo_->setShortcut(QKeySequence::Redo);
    connect(redo_, &QPushButton::clicked, this, [this] { changes_->redo(); });
    row->addWidget(open_edits_ = made_button(
                       bar, "graph_open_edits", tr("Open changes…"),
                       tr("Changes by hand from a file, in the place of those that are made"),
                       &GraphWindow::open_edits));
    row->addWidget(save_ = made_button(bar, "graph_save", tr("Save…"),
                                       tr("Into a folder: the solved graph.g2o, its picture and "
                                          "its changes by hand (Ctrl+S)"),
                                       &GraphWindow::save));
    save_->setShortcut(QKeySequence::Save);
    auto* picture = made_button(bar, "graph_picture", tr("Save as image…"), {}, nullptr);
    connect(picture, &QPushButton::clicked, this,
            [this] { emit picture_wanted(view_->exportable()); });
    row->addWidget(picture);
    return bar;
}

QWidget* GraphWindow::made_column() {
    auto* side = new QWidget(this);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(6, 0, 0, 0);
    table_ = named(new FiguresTable(model_, side), "graph_table");
    table_->setAccessibleName(tr("Edges of the greatest errors"));
    table_->sortByColumn(GraphModel::error, Qt::DescendingOrder);
    table_->setMinimumHeight(80);
    connect(table_, &FiguresTable::row_chosen, this,
            [this](int row) { choose_edge(model_->rows()[static_cast<std::size_t>(row)].edge); });
    column->addWidget(table_, 1);
    hand_ = new GraphHand(*table_, side);
    connect(hand_, &GraphHand::edit_wanted, this, &GraphWindow::add);
    connect(hand_, &GraphHand::poses_written, this, [this] {
        edge_.reset();
        show_chosen();
    });
    column->addWidget(hand_);
    changes_ = new GraphChanges(side);
    connect(changes_, &GraphChanges::changed, this, &GraphWindow::solve);
    column->addWidget(changes_);
    auto* by_key = new QShortcut(Qt::Key_Delete, table_, nullptr, nullptr, Qt::WidgetShortcut);
    connect(by_key, &QShortcut::activated, hand_, &GraphHand::refuse);
    return side;
}

QPushButton* GraphWindow::made_button(QWidget* parent, const char* name, const QString& words,
                                      const QString& tip, void (GraphWindow::*pressed)()) {
    auto* button = named(new QPushButton(words, parent), name);
    button->setToolTip(tip);
    button->setAutoDefault(false);
    if (pressed != nullptr) connect(button, &QPushButton::clicked, this, pressed);
    return button;
}

/// What was read is solved at once.
void GraphWindow::take_graph() {
    const auto graph = shown();
    hand_->set_graph(graph);
    if (graph->stage == ShownGraph::Stage::read) {
        files_.note_recent(solver_->path());
        files_.note_opened("graph", solver_->path());
        model_->set_graph(*graph);
        view_->set_graph(graph);
        make_room_for_table();
        solve();
        return;
    }
    if (edge_) edge_ = same_edge_in(graph->solved.graph, view_->edge_at(*edge_));
    model_->set_graph(*graph);
    view_->choose({});  // of the graph before
    view_->set_graph(graph);
    changes_->show_errors(*graph);
    show_chosen();
}

/// Ids may have many digits: all columns, up to half of the window. Where they fit nothing moves,
/// so that a large graph is not drawn twice.
void GraphWindow::make_room_for_table() {
    const int columns = table_->horizontalHeader()->length();
    const int around = table_->verticalScrollBar()->sizeHint().width() + 2 * table_->frameWidth();
    const int wanted = std::min(columns + around, width() / 2);
    if (wanted > table_->width()) table_->setMinimumWidth(wanted);
}

void GraphWindow::tell_not_read(const QString& problem) {
    hide();
    prompts_.warn(parentWidget(), tr("The graph was not opened"), problem);
    deleteLater();
}

/// What could not be is left: the last change, or another way to solve.
void GraphWindow::tell_not_solved(const QString& problem) {
    const auto graph = shown();
    const bool at_first = graph->stage == ShownGraph::Stage::read;
    told_.clear();  // what was given up is back
    prompts_.warn(this,
                  at_first && !changes_->can_undo() ? tr("The graph was not solved")
                                                    : tr("The change was not made"),
                  problem);
    if (changes_->can_undo() && edits() != graph->edits) {
        changes_->forget_last();
        const GraphChoices wanted{robust_->isChecked(), static_cast<std::size_t>(worst_->value())};
        if (edits() != graph->edits || wanted != graph->choices) solve();
    } else if (!at_first) {
        const QSignalBlocker quiet(robust_);
        robust_->setChecked(graph->choices.robust);
    }
    show_state();
}

void GraphWindow::solve() {
    if (!shown()) return;
    told_.clear();
    solver_->solve(placed(edits()),
                   {robust_->isChecked(), static_cast<std::size_t>(worst_->value())});
    show_state();
}

bool GraphWindow::change(std::vector<GraphEdit> edits) {
    if (!shown()) return false;
    try {
        placed(edits);
    } catch (const FormatError& error) {
        prompts_.warn(this, tr("The change was not made"), words_of(error.problem()));
        return false;
    }
    changes_->replace(std::move(edits));
    return true;
}

void GraphWindow::add(const GraphEdit& edit) {
    GraphChanges::With with = changes_->with(edit);
    const auto a = hand_->a();
    const auto b = hand_->b();
    // What there is by hand alone goes with the change that made it.
    const bool by_hand =
        edit.kind == GraphEdit::Kind::refuse && a && b && !joined(shown()->file->graph, *a, *b);
    if (by_hand) with.edits.pop_back();
    if (!change(std::move(with.edits)) || by_hand) return;
    told_ = with.replaced;
    show_state();
}

void GraphWindow::open_edits() {
    const QString path = prompts_.open_file(this, {tr("Open changes"),
                                                   files_.folder_to_open("graph"),
                                                   tr("Changes by hand (*.txt);;All files (*)"),
                                                   {}});
    if (path.isEmpty()) return;
    const std::string file = path.toStdString();
    try {
        change(parse_vertex_edits(input::read_text(file, input::kLargestSettings), file).edits);
    } catch (const std::exception& error) {
        prompts_.warn(this, tr("The changes were not opened"), words_of(error));
    }
}

void GraphWindow::save() {
    const QString name = QFileInfo(solver_->path()).baseName() + "-solved";
    const QString folder = ask_where_to_save(
        prompts_, this,
        {tr("Save graph: name of a new folder"), files_.place_to_save(name), {}, {}, true});
    if (folder.isEmpty()) return;
    writing_ = shown()->edits;
    solver_->write(folder);
}

void GraphWindow::end_writing(const QString& folder, const QString& problem) {
    if (!problem.isEmpty()) {
        tell_not_written(prompts_, this, problem);
        return;
    }
    saved_ = writing_;
    files_.note_saved("graph", folder);
    const QString place = QDir::toNativeSeparators(folder);
    told_ = tr("Graph saved in %1.").arg(place);
    emit notice(tr("Graph saved: %1").arg(place));
    show_state();
}

bool GraphWindow::may_end() {
    if (edits().empty() || edits() == saved_) return true;
    return prompts_.confirm(
        this, {tr("Changes by hand"), tr("Close the graph without its changes by hand?"),
               tr("They are written nowhere yet: “Save…” keeps them."), tr("Close"), true});
}

void GraphWindow::reject() {
    if (may_end()) QDialog::reject();
}

/// Its poses are A and B, as somebody would close it anew.
void GraphWindow::choose_edge(const std::optional<std::size_t>& edge) {
    edge_ = edge;
    if (edge) {
        const PlanarGraph& graph = shown()->solved.graph;
        const PlanarEdge& one = graph.edges[*edge];
        const auto id = [&](std::uint32_t vertex) {
            return QString::number(graph.vertices[vertex].id);
        };
        if (one.kind == PlanarEdge::Kind::step) {
            hand_->set_poses(id(one.to), id(one.from));
        } else {
            hand_->set_poses(
                id(graph.vertices[one.from].kind == PlanarVertex::Kind::pose ? one.from : one.to),
                {});
        }
    }
    show_chosen();
}

void GraphWindow::take_pose(std::uint32_t vertex) {
    edge_.reset();
    hand_->take_pose(QString::number(shown()->solved.graph.vertices[vertex].id));
    show_chosen();
}

void GraphWindow::show_chosen() {
    GraphView::Chosen chosen{edge_, {}};
    if (const auto b = hand_->b()) chosen.poses.emplace_back(*b, "B " + hand_->b_id());
    if (const auto a = hand_->a()) chosen.poses.emplace_back(*a, "A " + hand_->a_id());
    view_->choose(std::move(chosen));
    const auto row = std::ranges::find(
        model_->rows(), edge_, [](const GraphModel::Row& one) { return std::optional(one.edge); });
    table_->choose(row == model_->rows().end() ? -1
                                               : static_cast<int>(row - model_->rows().begin()));
    show_state();
}

void GraphWindow::show_state() {
    const auto graph = shown();
    set_enabled(*undo_, changes_->can_undo(), *table_);
    set_enabled(*redo_, changes_->can_redo(), *table_);
    before_->setEnabled(graph != nullptr);
    open_edits_->setEnabled(graph != nullptr);
    save_->setEnabled(graph && graph->stage == ShownGraph::Stage::solved && !busy());
    QStringList words{told_};
    words << hand_->problems();
    words << graph_words(graph.get(), busy());
    words_->setText(words.join(' ').trimmed());
}

}  // namespace hitos::window
