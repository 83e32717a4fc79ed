// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_list.hpp"

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "anchor_dialog.hpp"
#include "hitos/services/evaluation/tour_frames.hpp"
#include "look/edit_words.hpp"
#include "look/flow_layout.hpp"
#include "look/named.hpp"
#include "look/parameter_text.hpp"
#include "look/undo_keys.hpp"
#include "look/words_of.hpp"
#include "written_pose.hpp"

namespace hitos::window {
namespace {

double largest_move_m(const Trajectory& before, const Trajectory& after) {
    double largest = 0.0;
    for (std::size_t i = 0; i < std::min(before.size(), after.size()); ++i) {
        const Pose& a = before[i].pose;
        const Pose& b = after[i].pose;
        largest = std::max(largest, std::hypot(a.x - b.x, a.y - b.y));
    }
    return largest;
}

std::vector<GraphEdit> edits_of(const Session& session) {
    return parse_graph_edits(session.configuration().registration.edits);
}

}  // namespace

EditList::EditList(Session& session, QWidget& table, QWidget* parent)
    : QWidget(parent), session_(session), table_(table) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    list_ = named(new QListWidget(this), "graph_edits");
    list_->setAccessibleName(tr("Changes by hand"));
    list_->setWordWrap(true);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setMaximumHeight(4 * fontMetrics().height());
    column->addWidget(list_);
    warnings_ = named(new QLabel(this), "edit_warnings");
    warnings_->setWordWrap(true);
    column->addWidget(warnings_);
    auto* bar = new QWidget(this);
    auto* row = new FlowLayout(bar, 4);
    take_back_ = named(new QPushButton(tr("Take back the change"), bar), "edit_take_back");
    row->addWidget(take_back_);
    slip_ = named(new QPushButton(bar), "edit_slip");
    slip_->setToolTip(
        tr("The odometry says nothing of the step to the scan that is shown: its "
           "wheels slipped, or somebody pushed the robot"));
    row->addWidget(slip_);
    fix_ = named(new QPushButton(bar), "edit_fix");
    fix_->setToolTip(tr("The scan that is shown was made there: it stays, and the map bends"));
    row->addWidget(fix_);
    at_ = named(new QLineEdit(bar), "edit_fix_at");
    make_pose_line(*at_, tr("x, y [m] and heading [°] in the map"));
    row->addWidget(at_);
    anchor_ = named(new QPushButton(tr("Anchor…"), bar), "edit_anchor");
    anchor_->setToolTip(
        tr("A wall or point of the scan that is shown is one of a drawing, or has known "
           "coordinates: the map bends to it"));
    row->addWidget(anchor_);
    before_ = named(new QPushButton(tr("As before"), bar), "edit_before");
    before_->setCheckable(true);
    before_->setToolTip(tr("Shows the map as it was before the last change"));
    row->addWidget(before_);
    column->addWidget(bar);
    effect_ = named(new QLabel(this), "edit_effect");
    effect_->setWordWrap(true);
    column->addWidget(effect_);
    connect(before_, &QPushButton::toggled, &session_, &Session::show_before);
    connect(anchor_, &QPushButton::clicked, this, &EditList::show_anchors);
    connect(fix_, &QPushButton::clicked, this, &EditList::note_fix);
    connect(at_, &QLineEdit::returnPressed, fix_, &QPushButton::click);
    connect(at_, &QLineEdit::textChanged, this, &EditList::show_steps);
    connect(take_back_, &QPushButton::clicked, this, &EditList::take_back);
    connect(slip_, &QPushButton::clicked, this, &EditList::note_slip);
    connect(list_, &QListWidget::currentRowChanged, this,
            [this](int chosen) { set_enabled(*take_back_, chosen >= 0, table_); });
}

void EditList::refresh() {
    const std::vector<GraphEdit> edits = edits_of(session_);
    QStringList words;
    for (const GraphEdit& edit : edits) {
        // By its number errors name it.
        words << QString("%1. %2").arg(words.size() + 1).arg(change_in_words(edit));
        if (!edit.comment.empty()) words.back() += " – " + to_qt(edit.comment);
    }
    QStringList shown;
    for (int i = 0; i < list_->count(); ++i) shown << list_->item(i)->text();
    if (shown != words) {
        list_->clear();
        list_->addItems(words);
    }
    if (edits.empty() && list_->hasFocus()) table_.setFocus();
    list_->setVisible(!edits.empty());
    set_enabled(*take_back_, list_->currentRow() >= 0, table_);
    take_back_->setVisible(!edits.empty());
    const auto snapshot = session_.snapshot();
    // What somebody has written belongs to the scan that it was written for.
    if (snapshot && snapshot->steps > 0 &&
        (snapshot->steps != std::exchange(at_steps_, snapshot->steps) || !at_->isModified())) {
        const Pose& pose = snapshot->best_trajectory.back().pose;
        at_->setText(pose_text(pose));
    }
    show_steps();
    show_effect();
    show_warnings();
}

/// What can be said of the scan that is shown.
void EditList::show_steps() {
    const auto snapshot = session_.snapshot();
    const std::uint64_t steps = snapshot ? snapshot->steps : 0;
    const std::vector<GraphEdit> edits = edits_of(session_);
    const auto said = [&](GraphEdit::Kind kind) {
        return std::ranges::any_of(edits, [&](const GraphEdit& edit) {
            return edit.kind == kind && edit.scan.scan + 1 == steps;
        });
    };
    slip_->setText(tr("The step to %1 slipped").arg(steps));
    set_enabled(*slip_, steps > 1 && !said(GraphEdit::Kind::slip), table_);
    fix_->setText(tr("Fix scan %1 at").arg(steps));
    set_enabled(*fix_, steps > 1 && !said(GraphEdit::Kind::fix) && pose_of(*at_), table_);
    set_enabled(*at_, steps > 1, table_);
    anchor_->setEnabled(steps > 0);
}

/// What the last change made of the error, where a reference is known, and of the graph.
void EditList::show_effect() {
    const auto before = session_.before_edits();
    const QSignalBlocker quiet(before_);
    before_->setChecked(session_.shows_before());
    before_->setVisible(before != nullptr);
    effect_->setVisible(before != nullptr);
    if (!before || session_.shows_before()) return;
    const auto after = session_.snapshot();
    QStringList words;
    const auto changes = [&](const QString& name, double was, double is, int digits) {
        words << name.arg(was, 0, 'f', digits).arg(is, 0, 'f', digits);
    };
    const References& references = session_.references();
    if (references.trajectory) {
        const auto error = [&](const Snapshot& snapshot) {
            return trajectory_error(in_one_frame(snapshot.best_trajectory, snapshot.later_tours),
                                    *references.trajectory, references.tolerance_s);
        };
        const auto was = error(*before);
        const auto is = error(*after);
        if (was && is) changes(tr("error %1 → %2 m"), was->rmse_m, is->rmse_m, 3);
    }
    if (before->chi_square && after->chi_square) {
        const int digits = std::max(*before->chi_square, *after->chi_square) < 100.0 ? 1 : 0;
        changes(tr("χ² %1 → %2"), *before->chi_square, *after->chi_square, digits);
    }
    words << tr("up to %1 m moved")
                 .arg(largest_move_m(before->best_trajectory, after->best_trajectory), 0, 'f', 2);
    effect_->setText((after->foreseen ? tr("Foreseen, the scans are taken anew: %1.")
                                      : tr("By the last change: %1."))
                         .arg(words.join(", ")));
    if (anchors_ != nullptr) anchors_->tell(effect_->text());
}

/// What the run says of the changes as they are: none of those that were before, or are foreseen.
void EditList::show_warnings() {
    QStringList told;
    const auto snapshot = session_.snapshot();
    if (snapshot && !snapshot->foreseen && !session_.shows_before()) {
        for (const Advice& advice : snapshot->advice)
            if (advice.by_hand) told << words_of(advice);
    }
    const Progress progress = session_.progress();
    if (progress.state == Progress::State::failed &&
        progress.error.english().starts_with(kGraphEditsKey)) {
        told << words_of(progress.error);
    }
    for (QString& words : told) words = QString::fromUtf8("⚠ ") + words;
    warnings_->setText(told.join('\n'));
    warnings_->setVisible(!told.isEmpty());
}

void EditList::show_anchors() {
    if (anchors_ == nullptr) {
        anchors_ = new AnchorDialog(session_, window());
        connect(anchors_, &AnchorDialog::drawing_wanted, this, &EditList::drawing_wanted);
        connect(anchors_, &AnchorDialog::drawing_read, this, &EditList::drawing_read);
        connect(anchors_, &AnchorDialog::anchored, this, [this](const GraphEdit& anchor) {
            std::vector<GraphEdit> edits = edits_of(session_);
            edits.push_back(anchor);
            emit edits_wanted(to_qt(text_of(edits)));
        });
    }
    anchors_->show();
    anchors_->raise();
    anchors_->activateWindow();
}

void EditList::open_drawing(const QString& path) {
    if (anchors_ != nullptr) anchors_->open_drawing(path);
}

void EditList::take_back() {
    std::vector<GraphEdit> edits = edits_of(session_);
    const int chosen = list_->currentRow();
    if (chosen < 0 || static_cast<std::size_t>(chosen) >= edits.size()) return;
    edits.erase(edits.begin() + chosen);
    emit edits_wanted(to_qt(text_of(edits)));
}

/// Of the scan that is shown.
void EditList::add(GraphEdit edit) {
    const auto snapshot = session_.snapshot();
    if (!snapshot || snapshot->steps < 2) return;
    edit.scan = {snapshot->steps - 1, snapshot->best_trajectory.back().time_s};
    std::vector<GraphEdit> edits = edits_of(session_);
    edits.push_back(edit);
    emit edits_wanted(to_qt(text_of(edits)));
}

void EditList::note_slip() {
    add({GraphEdit::Kind::slip, {}});
}

void EditList::note_fix() {
    if (const auto pose = pose_of(*at_)) add({GraphEdit::Kind::fix, {}, {}, *pose});
}

}  // namespace hitos::window
