// SPDX-License-Identifier: GPL-3.0-or-later
#include "graph_window.hpp"

#include <QCheckBox>
#include <QDir>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QRegularExpressionValidator>
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
#include "graph_model.hpp"
#include "graph_view.hpp"
#include "graph_words.hpp"
#include "hitos/base/text_input.hpp"
#include "look/flow_layout.hpp"
#include "look/screen_fit.hpp"
#include "look/steady_label.hpp"
#include "look/theme.hpp"
#include "look/words_of.hpp"
#include "written_pose.hpp"

namespace hitos::window {
namespace {

constexpr QSize kGraphSize(1180, 700);

/// The same edge in a graph with other changes.
std::optional<std::size_t> same_edge_in(const PlanarGraph& graph, const PlanarEdge& edge) {
    const auto found = std::ranges::find_if(graph.edges, [&](const PlanarEdge& one) {
        return one.kind == edge.kind && one.from == edge.from && one.to == edge.to &&
               one.z == edge.z;
    });
    if (found == graph.edges.end()) return std::nullopt;
    return static_cast<std::size_t>(found - graph.edges.begin());
}

/// Whether there is something between the two that could be refused.
bool joined(const PlanarGraph& graph, std::uint32_t a, std::uint32_t b) {
    return std::ranges::any_of(graph.edges, [&](const PlanarEdge& edge) {
        return edge.kind == PlanarEdge::Kind::step &&
               std::minmax(edge.from, edge.to) == std::minmax(a, b);
    });
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
    view_ = new GraphView(halves);
    view_->setObjectName("graph_view");
    halves->addWidget(made_column());
    halves->setStretchFactor(0, 1);
    halves->setChildrenCollapsible(false);
    column->addWidget(halves, 1);
    words_ = new QLabel(this);
    words_->setObjectName("graph_words");
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
    resize(kGraphSize);
    fit_to_screen(*this);
    show_chosen();
    solver_->read();
}

QWidget* GraphWindow::made_tools() {
    auto* bar = new QWidget(this);
    auto* row = new FlowLayout(bar, 6);
    robust_ = new QCheckBox(tr("Robust"), bar);
    robust_->setObjectName("graph_robust");
    robust_->setToolTip(tr("Edges far from the rest lose weight, as false ones are"));
    connect(robust_, &QCheckBox::toggled, this, &GraphWindow::solve);
    row->addWidget(robust_);
    worst_ = new QSpinBox(bar);
    worst_->setObjectName("graph_worst");
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
    table_ = new FiguresTable(model_, side);
    table_->setObjectName("graph_table");
    table_->setAccessibleName(tr("Edges of the greatest errors"));
    table_->sortByColumn(GraphModel::error, Qt::DescendingOrder);
    table_->setMinimumHeight(80);
    connect(table_, &FiguresTable::row_chosen, this,
            [this](int row) { choose_edge(model_->rows()[static_cast<std::size_t>(row)].edge); });
    column->addWidget(table_, 1);
    add_changes(*column, side);
    auto* by_key = new QShortcut(Qt::Key_Delete, table_, nullptr, nullptr, Qt::WidgetShortcut);
    connect(by_key, &QShortcut::activated, refuse_, &QPushButton::click);
    return side;
}

void GraphWindow::add_changes(QVBoxLayout& column, QWidget* parent) {
    const auto add_row = [&](std::initializer_list<QWidget*> widgets) {
        auto* row = new QHBoxLayout;
        for (QWidget* widget : widgets) row->addWidget(widget);
        column.addLayout(row);
    };
    const auto named = [&](const QString& words, QLineEdit* line) {
        auto* label = new QLabel(words, parent);
        label->setBuddy(line);
        return label;
    };
    a_ = made_number(parent, "graph_a", tr("Pose A, by its id"));
    b_ = made_number(parent, "graph_b", tr("Pose B, by its id"));
    add_row({named("A", a_), a_, named("B", b_), b_});
    refuse_ = made_button(parent, "graph_refuse", tr("Refuse"),
                          tr("Drops the edges between A and B"), &GraphWindow::refuse);
    slip_ = made_button(parent, "graph_slip", tr("Slip"),
                        tr("The step to A from the pose before it says next to nothing"),
                        &GraphWindow::slip);
    add_row({refuse_, slip_});
    close_at_ = new QLineEdit(parent);
    close_at_->setObjectName("graph_close_at");
    make_pose_line(*close_at_, tr("A seen from B: x, y [m] and heading [°]"));
    close_ = made_button(parent, "graph_close", tr("Close"),
                         tr("An edge more: A is seen from B there, as sure as an eye is"),
                         &GraphWindow::close_loop);
    add_row({close_, close_at_});
    fix_at_ = new QLineEdit(parent);
    fix_at_->setObjectName("graph_fix_at");
    make_pose_line(*fix_at_, tr("A in the map: x, y [m] and heading [°]"));
    fix_ = made_button(parent, "graph_fix", tr("Fix"), tr("A is known to be there in the map"),
                       &GraphWindow::fix);
    add_row({fix_, fix_at_});
    connect(close_at_, &QLineEdit::returnPressed, close_, &QPushButton::click);
    connect(fix_at_, &QLineEdit::returnPressed, fix_, &QPushButton::click);
    for (QLineEdit* line : {close_at_, fix_at_}) {
        connect(line, &QLineEdit::textChanged, this, &GraphWindow::show_state);
    }
    changes_ = new GraphChanges(parent);
    connect(changes_, &GraphChanges::changed, this, &GraphWindow::solve);
    column.addWidget(changes_);
}

QPushButton* GraphWindow::made_button(QWidget* parent, const char* name, const QString& words,
                                      const QString& tip, void (GraphWindow::*pressed)()) {
    auto* button = new QPushButton(words, parent);
    button->setObjectName(name);
    button->setToolTip(tip);
    button->setAutoDefault(false);
    if (pressed != nullptr) connect(button, &QPushButton::clicked, this, pressed);
    return button;
}

QLineEdit* GraphWindow::made_number(QWidget* parent, const char* name, const QString& words) {
    auto* line = new QLineEdit(parent);
    line->setObjectName(name);
    line->setToolTip(words);
    line->setAccessibleName(words);
    line->setValidator(new QRegularExpressionValidator(QRegularExpression("[0-9]{1,19}"), line));
    connect(line, &QLineEdit::textEdited, this, [this] {
        edge_.reset();
        forget_written();
        show_chosen();
    });
    return line;
}

/// What was read is solved at once.
void GraphWindow::take_graph() {
    const auto graph = shown();
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

void GraphWindow::add(GraphEdit edit) {
    GraphChanges::With with = changes_->with(std::move(edit));
    if (!change(std::move(with.edits))) return;
    told_ = with.replaced;
    show_state();
}

void GraphWindow::refuse() {
    GraphEdit refusal{
        GraphEdit::Kind::refuse, {a_->text().toULongLong()}, {b_->text().toULongLong()}};
    // What there is by hand alone goes with the change that made it.
    const auto a = pose_in(*a_);
    const auto b = pose_in(*b_);
    if (!a || !b) return;
    if (joined(shown()->file->graph, *a, *b)) {
        add(std::move(refusal));
        return;
    }
    std::vector<GraphEdit> rest = changes_->with(std::move(refusal)).edits;
    rest.pop_back();
    change(std::move(rest));
}

void GraphWindow::close_loop() {
    const auto pose = pose_of(*close_at_);
    if (!pose) return;
    add({GraphEdit::Kind::close, {a_->text().toULongLong()}, {b_->text().toULongLong()}, *pose});
}

void GraphWindow::slip() {
    add({GraphEdit::Kind::slip, {a_->text().toULongLong()}});
}

void GraphWindow::fix() {
    const auto pose = pose_of(*fix_at_);
    if (pose) add({GraphEdit::Kind::fix, {a_->text().toULongLong()}, {}, *pose});
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
    if (edits() == saved_) return true;
    return prompts_.confirm(
        this, {tr("Changes by hand"), tr("Close the graph without its changes by hand?"),
               tr("They are written nowhere yet: “Save…” keeps them."), tr("Close"), true});
}

void GraphWindow::reject() {
    if (may_end()) QDialog::reject();
}

std::optional<std::uint32_t> GraphWindow::pose_in(const QLineEdit& line) const {
    const auto graph = shown();
    bool number = false;
    const std::uint64_t id = line.text().toULongLong(&number);
    if (!graph || !number) return std::nullopt;
    const std::vector<PlanarVertex>& vertices = graph->solved.graph.vertices;
    const auto found = std::ranges::find_if(vertices, [&](const PlanarVertex& vertex) {
        return vertex.id == id && vertex.kind == PlanarVertex::Kind::pose;
    });
    if (found == vertices.end()) return std::nullopt;
    return static_cast<std::uint32_t>(found - vertices.begin());
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
            set_poses(id(one.to), id(one.from));
        } else {
            set_poses(
                id(graph.vertices[one.from].kind == PlanarVertex::Kind::pose ? one.from : one.to),
                {});
        }
    }
    show_chosen();
}

/// The pose that was A before is B.
void GraphWindow::take_pose(std::uint32_t vertex) {
    edge_.reset();
    const QString id = QString::number(shown()->solved.graph.vertices[vertex].id);
    set_poses(id, a_->text() == id ? b_->text() : a_->text());
    show_chosen();
}

void GraphWindow::set_poses(const QString& a, const QString& b) {
    a_->setText(a);
    b_->setText(b);
    forget_written();
}

void GraphWindow::forget_written() {
    for (QLineEdit* line : {close_at_, fix_at_}) line->setModified(false);
}

/// Where A lies now is where it would be closed or fixed.
void GraphWindow::show_chosen() {
    const auto graph = shown();
    const auto a = pose_in(*a_);
    const auto b = pose_in(*b_);
    GraphView::Chosen chosen{edge_, {}};
    if (b) chosen.poses.emplace_back(*b, "B " + b_->text());
    if (a) chosen.poses.emplace_back(*a, "A " + a_->text());
    const auto pose = [&](std::uint32_t vertex) {
        return graph->solved.graph.vertices[vertex].pose();
    };
    // What somebody has written belongs to the poses that it was written for.
    if (!close_at_->isModified())
        close_at_->setText(a && b && *a != *b ? pose_text(between(pose(*b), pose(*a))) : QString());
    if (!fix_at_->isModified()) fix_at_->setText(a ? pose_text(pose(*a)) : QString());
    view_->choose(std::move(chosen));
    const auto row = std::ranges::find(
        model_->rows(), edge_, [](const GraphModel::Row& one) { return std::optional(one.edge); });
    table_->choose(row == model_->rows().end() ? -1
                                               : static_cast<int>(row - model_->rows().begin()));
    show_state();
}

void GraphWindow::show_state() {
    const auto graph = shown();
    const auto a = graph ? pose_in(*a_) : std::nullopt;
    const auto b = graph ? pose_in(*b_) : std::nullopt;
    const bool both = a && b && *a != *b;
    refuse_->setEnabled(both && joined(graph->solved.graph, *a, *b));
    slip_->setEnabled(a.has_value());
    close_at_->setEnabled(both);
    close_->setEnabled(both && pose_of(*close_at_));
    fix_at_->setEnabled(a.has_value());
    fix_->setEnabled(a && pose_of(*fix_at_));
    undo_->setEnabled(changes_->can_undo());
    redo_->setEnabled(changes_->can_redo());
    before_->setEnabled(graph != nullptr);
    open_edits_->setEnabled(graph != nullptr);
    save_->setEnabled(graph && graph->stage == ShownGraph::Stage::solved && !busy());
    QStringList words{told_};
    for (QLineEdit* line : {a_, b_}) {
        const bool none = graph && !line->text().isEmpty() && !pose_in(*line);
        set_look(*line, "state", none ? "wrong" : "good");
        if (none) words << tr("The graph has no pose %1.").arg(line->text());
    }
    words << graph_words(graph.get(), busy());
    words_->setText(words.join(' ').trimmed());
}

}  // namespace hitos::window
