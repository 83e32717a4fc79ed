// SPDX-License-Identifier: GPL-3.0-or-later
#include "graph_hand.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QRegularExpressionValidator>
#include <QVBoxLayout>
#include <algorithm>
#include <initializer_list>
#include <utility>
#include <vector>

#include "look/named.hpp"
#include "look/theme.hpp"
#include "look/undo_keys.hpp"
#include "workers/graph_solver.hpp"
#include "written_pose.hpp"

namespace hitos::window {

bool joined(const PlanarGraph& graph, std::uint32_t a, std::uint32_t b) {
    return std::ranges::any_of(graph.edges, [&](const PlanarEdge& edge) {
        return edge.kind == PlanarEdge::Kind::step &&
               std::minmax(edge.from, edge.to) == std::minmax(a, b);
    });
}

GraphHand::GraphHand(QWidget& list, QWidget* parent) : QWidget(parent), list_(list) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    const auto add_row = [&](std::initializer_list<QWidget*> widgets) {
        auto* row = new QHBoxLayout;
        for (QWidget* widget : widgets) row->addWidget(widget);
        column->addLayout(row);
    };
    const auto named = [&](const QString& words, QLineEdit* line) {
        auto* label = new QLabel(words, this);
        label->setBuddy(line);
        return label;
    };
    a_ = made_number("graph_a", tr("Pose A, by its id"));
    b_ = made_number("graph_b", tr("Pose B, by its id"));
    add_row({named("A", a_), a_, named("B", b_), b_});
    refuse_ = made_button("graph_refuse", tr("Refuse"), tr("Drops the edges between A and B"),
                          &GraphHand::refuse);
    slip_ = made_button("graph_slip", tr("Slip"),
                        tr("The step to A from the pose before it says next to nothing"),
                        &GraphHand::slip);
    add_row({refuse_, slip_});
    close_ = made_button("graph_close", tr("Close"),
                         tr("An edge more: A is seen from B there, as sure as an eye is"),
                         &GraphHand::close_loop);
    close_at_ = made_pose("graph_close_at", tr("A seen from B: x, y [m] and heading [°]"), close_);
    add_row({close_, close_at_});
    fix_ = made_button("graph_fix", tr("Fix"), tr("A is known to be there in the map"),
                       &GraphHand::fix);
    fix_at_ = made_pose("graph_fix_at", tr("A in the map: x, y [m] and heading [°]"), fix_);
    add_row({fix_, fix_at_});
    refresh();
}

QPushButton* GraphHand::made_button(const char* name, const QString& words, const QString& tip,
                                    void (GraphHand::*pressed)()) {
    auto* button = named(new QPushButton(words, this), name);
    button->setToolTip(tip);
    button->setAutoDefault(false);
    connect(button, &QPushButton::clicked, this, pressed);
    return button;
}

QLineEdit* GraphHand::made_number(const char* name, const QString& words) {
    auto* line = named(new QLineEdit(this), name);
    line->setToolTip(words);
    line->setAccessibleName(words);
    line->setValidator(new QRegularExpressionValidator(QRegularExpression("[0-9]{1,19}"), line));
    connect(line, &QLineEdit::textEdited, this, [this] {
        forget_written();
        refresh();
        emit poses_written();
    });
    return line;
}

QLineEdit* GraphHand::made_pose(const char* name, const QString& words, QPushButton* done) {
    auto* line = named(new QLineEdit(this), name);
    make_pose_line(*line, words);
    connect(line, &QLineEdit::returnPressed, done, &QPushButton::click);
    connect(line, &QLineEdit::textChanged, this, &GraphHand::show_state);
    return line;
}

void GraphHand::set_graph(std::shared_ptr<const ShownGraph> graph) {
    graph_ = std::move(graph);
    refresh();
}

void GraphHand::set_poses(const QString& a, const QString& b) {
    a_->setText(a);
    b_->setText(b);
    forget_written();
    refresh();
}

void GraphHand::take_pose(const QString& id) {
    set_poses(id, a_->text() == id ? b_->text() : a_->text());
}

QString GraphHand::a_id() const {
    return a_->text();
}

QString GraphHand::b_id() const {
    return b_->text();
}

QStringList GraphHand::problems() const {
    QStringList problems;
    for (const QLineEdit* line : {a_, b_}) {
        if (graph_ && !line->text().isEmpty() && !pose_in(*line))
            problems << tr("The graph has no pose %1.").arg(line->text());
    }
    return problems;
}

void GraphHand::refuse() {
    if (!refuse_->isEnabled()) return;
    emit edit_wanted(
        {GraphEdit::Kind::refuse, {a_->text().toULongLong()}, {b_->text().toULongLong()}});
}

void GraphHand::close_loop() {
    const auto pose = pose_of(*close_at_);
    if (!pose) return;
    emit edit_wanted(
        {GraphEdit::Kind::close, {a_->text().toULongLong()}, {b_->text().toULongLong()}, *pose});
}

void GraphHand::slip() {
    emit edit_wanted({GraphEdit::Kind::slip, {a_->text().toULongLong()}});
}

void GraphHand::fix() {
    const auto pose = pose_of(*fix_at_);
    if (pose) emit edit_wanted({GraphEdit::Kind::fix, {a_->text().toULongLong()}, {}, *pose});
}

std::optional<std::uint32_t> GraphHand::pose_in(const QLineEdit& line) const {
    bool number = false;
    const std::uint64_t id = line.text().toULongLong(&number);
    if (!graph_ || !number) return std::nullopt;
    const std::vector<PlanarVertex>& vertices = graph_->solved.graph.vertices;
    const auto found = std::ranges::find_if(vertices, [&](const PlanarVertex& vertex) {
        return vertex.id == id && vertex.kind == PlanarVertex::Kind::pose;
    });
    if (found == vertices.end()) return std::nullopt;
    return static_cast<std::uint32_t>(found - vertices.begin());
}

/// What somebody has written belongs to the poses that it was written for.
void GraphHand::forget_written() {
    for (QLineEdit* line : {close_at_, fix_at_}) line->setModified(false);
}

/// Where A lies now is where it would be closed or fixed.
void GraphHand::refresh() {
    const auto at_a = a();
    const auto at_b = b();
    const auto pose = [&](std::uint32_t vertex) {
        return graph_->solved.graph.vertices[vertex].pose();
    };
    if (!close_at_->isModified()) {
        close_at_->setText(at_a && at_b && *at_a != *at_b
                               ? pose_text(between(pose(*at_b), pose(*at_a)))
                               : QString());
    }
    if (!fix_at_->isModified()) fix_at_->setText(at_a ? pose_text(pose(*at_a)) : QString());
    for (QLineEdit* line : {a_, b_}) {
        const bool none = graph_ && !line->text().isEmpty() && !pose_in(*line);
        set_look(*line, "state", none ? "wrong" : "good");
    }
    show_state();
}

void GraphHand::show_state() {
    const auto at_a = a();
    const auto at_b = b();
    const bool both = at_a && at_b && *at_a != *at_b;
    set_enabled(*refuse_, both && joined(graph_->solved.graph, *at_a, *at_b), list_);
    set_enabled(*slip_, at_a.has_value(), list_);
    close_at_->setEnabled(both);
    set_enabled(*close_, both && pose_of(*close_at_), list_);
    fix_at_->setEnabled(at_a.has_value());
    set_enabled(*fix_, at_a && pose_of(*fix_at_), list_);
}

}  // namespace hitos::window
