#include "loop_table.hpp"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <utility>

#include "hitos/slam/filters.hpp"
#include "look/flow_layout.hpp"
#include "look/parameter_text.hpp"
#include "look/words_of.hpp"
#include "loop_view.hpp"

namespace hitos::window {
namespace {

/// Which places the table lists.
enum Which { all, closed, refused };

bool same(const RunLoop& a, const RunLoop& b) {
    return a.record.scan == b.record.scan && a.record.earlier == b.record.earlier;
}

/// The change of this very loop among those by hand.
auto change_of(const std::vector<GraphEdit>& edits, const RunLoop& loop) {
    return std::ranges::find_if(edits, [&](const GraphEdit& edit) {
        return edit.of_two() && edit.scan.scan == loop.record.scan &&
               edit.earlier.scan == loop.record.earlier;
    });
}

QString verdict_words(LoopVerdict verdict) {
    constexpr std::array kWords{QT_TRANSLATE_NOOP("LoopVerdict", "Closed"),
                                QT_TRANSLATE_NOOP("LoopVerdict", "Fits badly"),
                                QT_TRANSLATE_NOOP("LoopVerdict", "Corridor"),
                                QT_TRANSLATE_NOOP("LoopVerdict", "Looked through"),
                                QT_TRANSLATE_NOOP("LoopVerdict", "Said once"),
                                QT_TRANSLATE_NOOP("LoopVerdict", "No edge"),
                                QT_TRANSLATE_NOOP("LoopVerdict", "Bends the graph"),
                                QT_TRANSLATE_NOOP("LoopVerdict", "Refused by hand")};
    return translated("LoopVerdict", kWords.at(static_cast<std::size_t>(verdict)));
}

}  // namespace

LoopModel::LoopModel(QObject* parent)
    : FiguresModel(
          {tr("Scan"), tr("Earlier"), tr("Verdict"), tr("Score"), tr("Overlap"),
           tr("Looked through"), "χ²", tr("Way between"), tr("Moved"), tr("Weight"), tr("Off")},
          parent) {}

void LoopModel::set_loops(std::vector<RunLoop> loops) {
    change(static_cast<int>(loops.size()), [&] { loops_ = std::move(loops); });
}

std::optional<double> LoopModel::figure(int row, int column) const {
    const RunLoop& loop = loops_[static_cast<std::size_t>(row)];
    const LoopRecord& record = loop.record;
    switch (column) {
        case score:
            return record.score;
        case overlap:
            return record.overlap;
        case through:
            return record.seen_through;
        case chi:
            return record.chi_square;
        case way:
            return record.way_m;
        case moved:
            return loop.closed() ? std::optional(record.move_m) : std::nullopt;
        case weight:
            return record.weight;
        default:
            return loop.error_m;
    }
}

QVariant LoopModel::key(int row, int column) const {
    const LoopRecord& record = loops_[static_cast<std::size_t>(row)].record;
    switch (column) {
        case scan:
            return QVariant::fromValue<qulonglong>(record.scan);
        case earlier:
            return QVariant::fromValue<qulonglong>(record.earlier);
        case verdict:
            return verdict_words(record.verdict);
        default:
            return figure(row, column).value_or(-1.0);
    }
}

QString LoopModel::text(int row, int column) const {
    const LoopRecord& record = loops_[static_cast<std::size_t>(row)].record;
    switch (column) {
        case scan:
            return QString::number(record.scan + 1);
        case earlier:
            return QString::number(record.earlier + 1);
        case verdict:
            return verdict_words(record.verdict);
        default:
            break;
    }
    const std::optional<double> value = figure(row, column);
    if (!value) return QStringLiteral("–");
    if (column == way || column == moved || column == error) return metre_words(*value);
    return QString::number(*value, 'f', column == chi ? 1 : 2);
}

bool LoopModel::strong(int row) const {
    return loops_[static_cast<std::size_t>(row)].closed();
}

LoopTable::LoopTable(Session& session, QWidget* parent)
    : QWidget(parent), session_(session), model_(new LoopModel(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(4, 4, 4, 4);
    there_ = new QWidget(this);
    auto* inside = new QVBoxLayout(there_);
    inside->setContentsMargins(0, 0, 0, 0);
    auto* bar = new QWidget(there_);
    auto* row = new FlowLayout(bar, 4);
    which_ = new QComboBox(bar);
    which_->setObjectName("loops_listed");
    which_->addItems({tr("All places"), tr("Closed loops"), tr("Refused")});
    which_->setToolTip(tr("Which places the table lists"));
    row->addWidget(which_);
    row->addWidget(change_ = add_button("loop_change", &LoopTable::change));
    row->addWidget(to_scan_ = add_button("loop_to_scan", &LoopTable::to_scan));
    row->addWidget(to_earlier_ = add_button("loop_to_earlier", &LoopTable::to_earlier));
    to_scan_->setToolTip(tr("The run goes to the scan that came back"));
    to_earlier_->setToolTip(tr("The run goes to the scan of the earlier passage"));
    inside->addWidget(bar);
    auto* halves = new QSplitter(Qt::Vertical, there_);
    table_ = new FiguresTable(model_, halves);
    table_->setObjectName("loop_table");
    table_->setAccessibleName(tr("Loops"));
    view_ = new LoopView(halves);
    view_->setObjectName("loop_view");
    view_->setMinimumHeight(120);
    inside->addWidget(halves, 1);
    reason_ = new QLabel(there_);
    reason_->setObjectName("loop_reason");
    reason_->setWordWrap(true);
    inside->addWidget(reason_);
    column->addWidget(there_, 1);
    none_ = new QLabel(this);
    none_->setObjectName("no_loops");
    none_->setAlignment(Qt::AlignCenter);
    none_->setWordWrap(true);
    column->addWidget(none_, 1);
    connect(which_, &QComboBox::currentIndexChanged, this, &LoopTable::refresh);
    connect(&session, &Session::snapshot_changed, this, &LoopTable::refresh);
    connect(&session, &Session::references_changed, this, &LoopTable::refresh);
    connect(&session, &Session::restarted, this, [this] {
        model_->set_loops({});
        view_->set_loop(nullptr, std::nullopt);
    });
    connect(table_, &FiguresTable::row_chosen, this,
            [this](int place) { choose(model_->loops()[static_cast<std::size_t>(place)]); });
    connect(table_, &QAbstractItemView::activated, this, [this] { go_to(false); });
    connect(view_, &CanvasView::picture_wanted, this, &LoopTable::picture_wanted);
}

QPushButton* LoopTable::add_button(const char* name, void (LoopTable::*pressed)()) {
    auto* button = new QPushButton(there_);
    button->setObjectName(name);
    connect(button, &QPushButton::clicked, this, pressed);
    return button;
}

std::vector<GraphEdit> LoopTable::edits() const {
    return parse_graph_edits(session_.configuration().registration.edits);
}

/// What was changed of it is taken back, else it is opened or closed.
void LoopTable::change() {
    if (!chosen_) return;
    std::vector<GraphEdit> next = edits();
    if (const auto made = change_of(next, *chosen_); made != next.end()) {
        next.erase(made);
    } else {
        const LoopRecord& record = chosen_->record;
        next.push_back({chosen_->closed() ? GraphEdit::Kind::refuse : GraphEdit::Kind::close,
                        {record.scan, chosen_->scan.time_s},
                        {record.earlier, chosen_->earlier.time_s},
                        chosen_->closed() ? Pose{} : record.pose_earlier_scan});
    }
    emit edits_wanted(to_qt(text_of(next)));
}

void LoopTable::go_to(bool earlier) {
    if (!chosen_) return;
    session_.seek((earlier ? chosen_->record.earlier : chosen_->record.scan) + 1);
}

void LoopTable::choose(const std::optional<RunLoop>& loop) {
    chosen_ = loop;
    refresh();
}

void LoopTable::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    refresh();
    want();
}

void LoopTable::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    want();
    emit loop_shown(std::nullopt);
}

void LoopTable::want() {
    SnapshotParts parts = session_.parts();
    parts.key_scans = isVisible();
    session_.want(parts);
}

std::vector<RunLoop> LoopTable::listed() const {
    const auto snapshot = session_.snapshot();
    if (!snapshot) return {};
    std::vector<RunLoop> loops = snapshot->loops;
    const int which = which_->currentIndex();
    if (which != all) {
        std::erase_if(loops,
                      [&](const RunLoop& loop) { return loop.closed() != (which == closed); });
    }
    const References& references = session_.references();
    if (references.trajectory) judge_loops(loops, *references.trajectory, references.tolerance_s);
    return loops;
}

void LoopTable::refresh() {
    if (!isVisible()) return;
    const auto snapshot = session_.snapshot();
    const bool registered = needs_registration(session_.configuration().filter);
    none_->setText(registered ? tr("No place has looked like an earlier one yet.")
                              : tr("With these parameters scans are not registered, and no loops "
                                   "are looked for. The preset “Recorded tours” does both."));
    const bool there = snapshot && !snapshot->loops.empty();
    there_->setVisible(there);
    none_->setVisible(!there);
    model_->set_loops(listed());
    show_chosen();
}

void LoopTable::show_change(const std::optional<RunLoop>& loop) {
    change_->setEnabled(loop.has_value());
    const std::vector<GraphEdit> made = edits();
    if (loop && change_of(made, *loop) != made.end()) {
        change_->setText(tr("Take back"));
        change_->setToolTip(tr("Does not change this place by hand any more"));
    } else if (!loop || loop->closed()) {
        change_->setText(tr("Refuse"));
        change_->setToolTip(tr("Takes this loop, and what was found beside it, out of the map"));
    } else {
        change_->setText(tr("Close"));
        change_->setToolTip(tr("Closes this loop as both passages lie below"));
    }
}

void LoopTable::show_chosen() {
    const std::vector<RunLoop>& loops = model_->loops();
    const auto found =
        chosen_ ? std::ranges::find_if(loops, [&](const RunLoop& l) { return same(l, *chosen_); })
                : loops.end();
    const bool there = found != loops.end();
    table_->choose(there ? static_cast<int>(found - loops.begin()) : -1);
    const auto name = [&](QPushButton* button, std::uint64_t scan) {
        button->setEnabled(there);
        button->setText(tr("Go to %1").arg(there ? QString::number(scan + 1) : QString("–")));
    };
    name(to_scan_, there ? found->record.scan : 0);
    name(to_earlier_, there ? found->record.earlier : 0);
    if (there) chosen_ = *found;
    const std::optional<RunLoop> shown = there ? chosen_ : std::nullopt;
    show_change(shown);
    view_->set_loop(session_.snapshot(), shown);
    emit loop_shown(shown);
    reason_->setText(there ? verdict_words(found->record.verdict) + ": " +
                                 words_of(reason_of(found->record)) + "."
                           : QString());
}

}  // namespace hitos::window
