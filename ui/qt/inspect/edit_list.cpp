#include "edit_list.hpp"

#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "hitos/registration/graph_edit.hpp"
#include "look/flow_layout.hpp"
#include "look/parameter_text.hpp"

namespace hitos::window {
namespace {

QString words_of(const GraphEdit& edit) {
    const QString scan = QString::number(edit.scan.scan + 1);
    const QString earlier = QString::number(edit.earlier.scan + 1);
    switch (edit.kind) {
        case GraphEdit::Kind::refuse:
            return EditList::tr("Refused: scan %1 has not come back to %2").arg(scan, earlier);
        case GraphEdit::Kind::close:
            return EditList::tr("Closed: scan %1 has come back to %2").arg(scan, earlier);
        case GraphEdit::Kind::fix:
            return EditList::tr("Scan %1 is fixed").arg(scan);
        default:
            return EditList::tr("The step to scan %1 slipped").arg(scan);
    }
}

std::vector<GraphEdit> edits_of(const Session& session) {
    return parse_graph_edits(session.configuration().registration.edits);
}

}  // namespace

EditList::EditList(Session& session, QWidget* parent) : QWidget(parent), session_(session) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    list_ = new QListWidget(this);
    list_->setObjectName("graph_edits");
    list_->setAccessibleName(tr("Changes by hand"));
    list_->setMaximumHeight(4 * fontMetrics().height());
    column->addWidget(list_);
    auto* bar = new QWidget(this);
    auto* row = new FlowLayout(bar, 4);
    take_back_ = new QPushButton(tr("Take back the change"), bar);
    take_back_->setObjectName("edit_take_back");
    row->addWidget(take_back_);
    slip_ = new QPushButton(bar);
    slip_->setObjectName("edit_slip");
    slip_->setToolTip(
        tr("The odometry says nothing of the step to the scan that is shown: its "
           "wheels slipped, or somebody pushed the robot"));
    row->addWidget(slip_);
    column->addWidget(bar);
    connect(take_back_, &QPushButton::clicked, this, &EditList::take_back);
    connect(slip_, &QPushButton::clicked, this, &EditList::note_slip);
    connect(list_, &QListWidget::currentRowChanged, this,
            [this](int chosen) { take_back_->setEnabled(chosen >= 0); });
}

void EditList::refresh() {
    const std::vector<GraphEdit> edits = edits_of(session_);
    QStringList words;
    for (const GraphEdit& edit : edits) {
        words << words_of(edit);
        if (!edit.comment.empty()) words.back() += " – " + to_qt(edit.comment);
    }
    QStringList shown;
    for (int i = 0; i < list_->count(); ++i) shown << list_->item(i)->text();
    if (shown != words) {
        list_->clear();
        list_->addItems(words);
    }
    list_->setVisible(!edits.empty());
    take_back_->setVisible(!edits.empty());
    take_back_->setEnabled(list_->currentRow() >= 0);
    const auto snapshot = session_.snapshot();
    const std::uint64_t steps = snapshot ? snapshot->steps : 0;
    const bool said = std::ranges::any_of(edits, [&](const GraphEdit& edit) {
        return edit.kind == GraphEdit::Kind::slip && edit.scan.scan + 1 == steps;
    });
    slip_->setText(tr("The step to %1 slipped").arg(steps));
    slip_->setEnabled(steps > 1 && !said);
}

void EditList::take_back() {
    std::vector<GraphEdit> edits = edits_of(session_);
    const int chosen = list_->currentRow();
    if (chosen < 0 || static_cast<std::size_t>(chosen) >= edits.size()) return;
    edits.erase(edits.begin() + chosen);
    emit edits_wanted(to_qt(text_of(edits)));
}

void EditList::note_slip() {
    const auto snapshot = session_.snapshot();
    if (!snapshot || snapshot->steps < 2) return;
    std::vector<GraphEdit> edits = edits_of(session_);
    edits.push_back(
        {GraphEdit::Kind::slip, {snapshot->steps - 1, snapshot->best_trajectory.back().time_s}});
    emit edits_wanted(to_qt(text_of(edits)));
}

}  // namespace hitos::window
