// SPDX-License-Identifier: GPL-3.0-or-later
#include "loop_table.hpp"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QShortcut>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <utility>

#include "edit_list.hpp"
#include "hitos/services/evaluation/reference_fit.hpp"
#include "hitos/services/evaluation/tour_frames.hpp"
#include "hitos/services/results/kept_run.hpp"
#include "hitos/slam/filters.hpp"
#include "look/docks.hpp"
#include "look/flow_layout.hpp"
#include "look/named.hpp"
#include "look/parameter_text.hpp"
#include "look/screen_fit.hpp"
#include "look/undo_keys.hpp"
#include "look/words_of.hpp"
#include "loop_model.hpp"
#include "loop_view.hpp"

namespace hitos::window {
namespace {

/// Which places the table lists.
enum Which { all, closed, refused };

bool same(const RunLoop& a, const RunLoop& b) {
    return a.record.scan == b.record.scan && a.record.earlier == b.record.earlier;
}

/// Two searches of one scan may find the same place; a change gives the loop other figures.
auto found_in(const std::vector<RunLoop>& loops, const RunLoop& loop) {
    const auto exact = std::ranges::find_if(loops, [&](const RunLoop& one) {
        return same(one, loop) && one.record.score == loop.record.score;
    });
    return exact != loops.end()
               ? exact
               : std::ranges::find_if(loops, [&](const RunLoop& one) { return same(one, loop); });
}

/// The change of this very loop among those by hand; of one that was refused with others the
/// refusal that it follows on.
auto change_of(const std::vector<GraphEdit>& edits, const RunLoop& loop) {
    const auto own = std::ranges::find_if(edits, [&](const GraphEdit& edit) {
        return edit.of_two() && edit.scan.scan == loop.record.scan &&
               edit.earlier.scan == loop.record.earlier;
    });
    if (own != edits.end()) return own;
    return std::ranges::find_if(edits, [&](const GraphEdit& edit) {
        return edit.kind == GraphEdit::Kind::refuse &&
               loop.record.refused_by == NamedLoop{edit.scan.scan, edit.earlier.scan};
    });
}

QString measured_words(const LoopRecord& record) {
    return LoopTable::tr("score %1, overlap %2, looked through %3")
        .arg(record.score, 0, 'f', 2)
        .arg(record.overlap, 0, 'f', 2)
        .arg(record.seen_through.value_or(0.0), 0, 'f', 2);
}

/// Of the scan made nearest to a place, of those that count.
template <class Counts>
std::optional<std::uint64_t> nearest_key(const Snapshot& snapshot, const QPointF& place,
                                         Counts counts) {
    std::optional<std::uint64_t> nearest;
    double reach = 2.0;  // [m]
    for (const KeyPose& key : snapshot.keys) {
        const Pose& pose = snapshot.best_trajectory.at(key.scan).pose;
        const double away = std::hypot(pose.x - place.x(), pose.y - place.y());
        if (away >= reach || !counts(key.scan)) continue;
        reach = away;
        nearest = key.scan;
    }
    return nearest;
}

}  // namespace

LoopTable::LoopTable(Session& session, QWidget* parent)
    : QWidget(parent), session_(session), model_(new LoopModel(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(4, 4, 4, 4);
    // Where the room is too low for all, nothing is squeezed but scrolled.
    scroll_ = new QScrollArea(this);
    scroll_->setWidgetResizable(true);
    scroll_->setFrameShape(QFrame::NoFrame);
    scroll_->setFocusPolicy(Qt::NoFocus);
    scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    there_ = new QWidget(scroll_);
    scroll_->setWidget(there_);
    auto* inside = new QVBoxLayout(there_);
    inside->setContentsMargins(0, 0, 0, 0);
    inside->addWidget(made_bar(there_));
    auto* halves = new QSplitter(Qt::Vertical, there_);
    table_ = named(new FiguresTable(model_, halves), "loop_table");
    table_->setMinimumHeight(80);
    table_->setAccessibleName(tr("Loops"));
    view_ = named(new LoopView(halves), "loop_view");
    view_->setMinimumHeight(120);
    inside->addWidget(halves, 1);
    reason_ = named(new QLabel(there_), "loop_reason");
    reason_->setWordWrap(true);
    inside->addWidget(reason_);
    edits_ = new EditList(session, *table_, there_);
    inside->addWidget(edits_);
    scroll_down_only(*scroll_);
    connect(edits_, &EditList::edits_wanted, this, &LoopTable::edits_wanted);
    connect(edits_, &EditList::drawing_wanted, this, &LoopTable::drawing_wanted);
    connect(edits_, &EditList::drawing_read, this, &LoopTable::drawing_read);
    column->addWidget(scroll_, 1);
    none_ = named(new QLabel(this), "no_loops");
    none_->setAlignment(Qt::AlignCenter);
    none_->setWordWrap(true);
    column->addWidget(none_, 1);
    constexpr int kPollMs = 15;
    timer_.setInterval(kPollMs);
    connect(&timer_, &QTimer::timeout, this, &LoopTable::poll);
    connect(which_, &QComboBox::currentIndexChanged, this, &LoopTable::refresh);
    connect(&session, &Session::snapshot_changed, this, &LoopTable::refresh);
    connect(&session, &Session::references_changed, this, &LoopTable::refresh);
    connect(&session, &Session::failed, this, &LoopTable::refresh);
    connect(&session, &Session::restarted, this, [this] {
        fitted_ = {};
        first_place_.reset();
        model_->set_loops({});
        view_->set_loop(nullptr, std::nullopt);
        forget_other_tour();
    });
    connect(table_, &FiguresTable::row_chosen, this,
            [this](int place) { choose(model_->loops()[static_cast<std::size_t>(place)]); });
    connect(table_, &QAbstractItemView::activated, this, &LoopTable::to_scan);
    auto* by_key = new QShortcut(Qt::Key_Delete, table_, nullptr, nullptr, Qt::WidgetShortcut);
    connect(by_key, &QShortcut::activated, change_, &QPushButton::click);
    connect(view_, &CanvasView::picture_wanted, this, &LoopTable::picture_wanted);
    connect(view_, &LoopView::laid, this, [this] {
        measured_.reset();
        show_change();
        show_reason();
    });
}

QWidget* LoopTable::made_bar(QWidget* parent) {
    auto* bar = new QWidget(parent);
    auto* row = new FlowLayout(bar, 4);
    which_ = named(new QComboBox(bar), "loops_listed");
    which_->addItems(
        {tr("All places (%1)").arg(0), tr("Closed loops (%1)").arg(0), tr("Refused (%1)").arg(0)});
    which_->setCurrentIndex(closed);
    which_->setToolTip(tr("Which places the table lists"));
    row->addWidget(which_);
    row->addWidget(change_ = add_button(bar, "loop_change", &LoopTable::change));
    row->addWidget(fit_ = add_button(bar, "loop_fit", &LoopTable::fit));
    fit_->setText(tr("Fit"));
    fit_->setToolTip(
        tr("Lays the later passage on the walls of the earlier one, from where it "
           "lies below"));
    row->addWidget(pick_ = add_button(bar, "loop_pick", nullptr));
    pick_->setText(tr("Choose in the map"));
    pick_->setToolTip(
        tr("Two clicks into the map, on the later passage and on the earlier one, "
           "propose a loop"));
    pick_->setCheckable(true);
    connect(pick_, &QPushButton::toggled, this, [this] { first_place_.reset(); });
    scan_ = add_number(bar, "loop_scan", tr("Scan %1").arg(QString()));
    to_scan_ = add_button(bar, "loop_to_scan", &LoopTable::to_scan);
    earlier_ = add_number(bar, "loop_earlier", tr("came back to %1").arg(QString()));
    to_earlier_ = add_button(bar, "loop_to_earlier", &LoopTable::to_earlier);
    // However narrow the dock, a number and its button stay together.
    for (const auto& [number, button] :
         {std::pair(scan_, to_scan_), std::pair(earlier_, to_earlier_)}) {
        auto* both = new QWidget(bar);
        auto* inside = new QHBoxLayout(both);
        inside->setContentsMargins(0, 0, 0, 0);
        inside->setSpacing(4);
        inside->addWidget(number);
        inside->addWidget(button);
        row->addWidget(both);
    }
    for (QPushButton* button : {to_scan_, to_earlier_}) {
        button->setText(tr("Go"));
        button->setToolTip(tr("The run goes to this scan"));
    }
    return bar;
}

QPushButton* LoopTable::add_button(QWidget* parent, const char* name,
                                   void (LoopTable::*pressed)()) {
    auto* button = named(new QPushButton(parent), name);
    if (pressed != nullptr) connect(button, &QPushButton::clicked, this, pressed);
    return button;
}

QSpinBox* LoopTable::add_number(QWidget* parent, const char* name, const QString& words) {
    auto* number = named(new QSpinBox(parent), name);
    number->setPrefix(words);
    number->setKeyboardTracking(false);
    number->setRange(1, 1);
    connect(number, &QSpinBox::valueChanged, this, &LoopTable::propose);
    return number;
}

std::vector<GraphEdit> LoopTable::edits() const {
    return parse_graph_edits(session_.configuration().registration.edits);
}

/// What was chosen or proposed is of the tour that it was found on.
void LoopTable::forget_other_tour() {
    const Configuracion& now = session_.configuration();
    const bool other = tour_ && (!same_log(*tour_, now) || drive_ != session_.drive());
    tour_ = now;
    drive_ = session_.drive();
    if (!other) return;
    chosen_.reset();
    proposed_ = false;
    measured_.reset();
    emit loop_shown(std::nullopt);
}

/// Two scans that are none of the listed pairs are a loop that somebody proposes, between the key
/// scans nearest to them.
void LoopTable::propose() {
    const auto snapshot = session_.snapshot();
    if (!snapshot || snapshot->keys.empty()) return;
    // From key to key, in the direction that the number goes.
    const auto key_at = [&](int number, std::optional<std::uint64_t> before) {
        const auto scan = static_cast<std::uint64_t>(number - 1);
        auto key = std::ranges::lower_bound(snapshot->keys, scan, {}, &KeyPose::scan);
        const bool down = before && scan < *before;
        if (key == snapshot->keys.end() ||
            (down && key->scan > scan && key != snapshot->keys.begin())) {
            --key;
        }
        return key->scan;
    };
    RunLoop loop;
    const bool had = chosen_.has_value();
    loop.record.scan =
        key_at(scan_->value(), had ? std::optional(chosen_->record.scan) : std::nullopt);
    loop.record.earlier =
        key_at(earlier_->value(), had ? std::optional(chosen_->record.earlier) : std::nullopt);
    if (loop.record.earlier >= loop.record.scan) {
        choose(std::nullopt);
        reason_->setText(tr("The earlier scan has to come before the other."));
        return;
    }
    loop.scan = snapshot->best_trajectory.at(loop.record.scan);
    loop.earlier = snapshot->best_trajectory.at(loop.record.earlier);
    loop.record.pose_earlier_scan = between(loop.earlier.pose, loop.scan.pose);
    loop.record.verdict = LoopVerdict::alone;
    proposed_ = true;
    chosen_ = loop;
    measured_.reset();
    view_->let_go();
    show_chosen();
}

bool LoopTable::takes_places() const {
    return pick_->isChecked() && isVisible();
}

void LoopTable::take_place(const QPointF& world_m) {
    constexpr std::uint64_t kOtherPassage = 20;  // scans
    const auto snapshot = session_.snapshot();
    if (!takes_places() || !snapshot) return;
    const auto scan = nearest_key(*snapshot, world_m, [&](std::uint64_t number) {
        return !first_place_ || (number > *first_place_ ? number - *first_place_
                                                        : *first_place_ - number) > kOtherPassage;
    });
    if (!scan) return;
    if (!first_place_) {
        first_place_ = scan;
        reason_->setText(tr("Scan %1. Now click the other passage.").arg(*scan + 1));
        return;
    }
    const auto [earlier, later] = std::minmax({*first_place_, *scan});
    pick_->setChecked(false);
    {
        const QSignalBlocker quiet(scan_);
        scan_->setValue(static_cast<int>(later) + 1);
    }
    const QSignalBlocker quiet(earlier_);
    earlier_->setValue(static_cast<int>(earlier) + 1);
    propose();
}

/// What was changed of it is taken back, else it is taken out or put in, as it lies.
void LoopTable::change() {
    if (!chosen_) return;
    std::vector<GraphEdit> next = edits();
    const auto made = change_of(next, *chosen_);
    const bool by_hand = view_->laid_by_hand();
    GraphEdit closing{GraphEdit::Kind::close,
                      {chosen_->record.scan, chosen_->scan.time_s},
                      {chosen_->record.earlier, chosen_->earlier.time_s},
                      view_->pose()};
    if (made != next.end()) closing.comment = made->comment;
    const auto place = made - next.begin();
    if (made != next.end() && by_hand && made->scan.scan == closing.scan.scan) {
        next[static_cast<std::size_t>(place)] = closing;
    } else if (made != next.end() && !by_hand) {
        next.erase(next.begin() + place);
    } else if (chosen_->closed() && !by_hand) {
        next.push_back({GraphEdit::Kind::refuse, closing.scan, closing.earlier});
    } else {
        next.push_back(closing);
    }
    view_->let_go();
    measured_.reset();
    emit edits_wanted(to_qt(text_of(next)));
}

void LoopTable::open_drawing(const QString& path) {
    edits_->open_drawing(path);
}

void LoopTable::fit() {
    if (!chosen_ || session_.worker() == nullptr) return;
    fitted_ = session_.worker()->with_run(
        [scan = chosen_->record.scan, earlier = chosen_->record.earlier, pose = view_->pose()](
            const Algoritmo& run) { return run.registration()->fitted_loop(scan, earlier, pose); });
    timer_.start();
}

void LoopTable::poll() {
    if (fitted_.valid() && fitted_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return;
    timer_.stop();
    if (!fitted_.valid()) return;
    try {
        const LoopRecord record = fitted_.get();
        if (!chosen_ || record.scan != chosen_->record.scan ||
            record.earlier != chosen_->record.earlier) {
            return;
        }
        view_->lay(record.pose_earlier_scan);
        measured_ = record;
        show_reason();
    } catch (const std::exception& error) {  // the run has gone back before one of the scans
        reason_->setText(window::words_of(error));
    }
}

void LoopTable::go_to(bool earlier) {
    if (!chosen_) return;
    session_.seek((earlier ? chosen_->record.earlier : chosen_->record.scan) + 1);
}

void LoopTable::choose(const std::optional<RunLoop>& loop) {
    chosen_ = loop;
    proposed_ = false;
    measured_.reset();
    view_->let_go();
    refresh();
}

void LoopTable::take_keys() {
    if (!chosen_ && !model_->loops().empty()) choose(model_->loops().front());
    table_->setFocus();
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

/// Those of the run, with their errors, and of them what the table lists.
void LoopTable::take_loops() {
    const auto snapshot = session_.snapshot();
    loops_ = snapshot ? snapshot->loops : std::vector<RunLoop>();
    const References& references = session_.references();
    if (references.trajectory && !loops_.empty() &&
        fit_of_path(in_one_frame(snapshot->best_trajectory, snapshot->later_tours),
                    *references.trajectory, references.tolerance_s)
            .judges_loops()) {
        judge_loops(loops_, *references.trajectory, references.tolerance_s);
    }
    const auto number = std::ranges::count_if(loops_, &RunLoop::closed);
    const auto count = static_cast<std::ptrdiff_t>(loops_.size());
    which_->setItemText(all, tr("All places (%1)").arg(count));
    which_->setItemText(closed, tr("Closed loops (%1)").arg(number));
    which_->setItemText(refused, tr("Refused (%1)").arg(count - number));
    std::vector<RunLoop> listed = loops_;
    const int which = which_->currentIndex();
    if (which != all) {
        std::erase_if(listed,
                      [&](const RunLoop& loop) { return loop.closed() != (which == closed); });
    }
    model_->set_loops(std::move(listed));
}

void LoopTable::refresh() {
    if (!isVisible()) return;
    const auto snapshot = session_.snapshot();
    const bool registered = needs_registration(session_.configuration().filter);
    none_->setText(registered ? tr("No scan has been registered yet.")
                              : tr("With these parameters scans are not registered, and no loops "
                                   "are looked for. The preset “Recorded tours” does both."));
    const bool redone =
        !snapshot && scroll_->isVisible() && session_.progress().state == Progress::State::running;
    const bool there = (snapshot && !snapshot->keys.empty()) || redone;
    show_or_say(there, *scroll_, *table_, *none_);
    for (QSpinBox* number : {scan_, earlier_}) {
        const QSignalBlocker quiet(number);
        const int most = there && snapshot ? static_cast<int>(snapshot->steps) : number->maximum();
        if (most > number->maximum() || !number->hasFocus()) number->setMaximum(most);
    }
    take_loops();
    edits_->refresh();
    show_chosen();
}

void LoopTable::show_chosen() {
    const auto found = chosen_ ? found_in(loops_, *chosen_) : loops_.end();
    const auto snapshot = session_.snapshot();
    const bool found_it = found != loops_.end();
    if (found_it) chosen_ = *found;
    // One that was closed and is no more is a proposal again.
    if (!found_it && proposed_ && chosen_) chosen_->record.verdict = LoopVerdict::alone;
    const bool shown =
        found_it || (proposed_ && chosen_ && snapshot && chosen_->record.scan < snapshot->steps);
    // It may be one that the table does not list.
    const std::vector<RunLoop>& listed = model_->loops();
    const auto row = found_it ? found_in(listed, *chosen_) : listed.end();
    table_->choose(row != listed.end() ? static_cast<int>(row - listed.begin()) : -1);
    const auto show = [](QSpinBox* number, std::uint64_t scan) {
        const QSignalBlocker quiet(number);
        const int value = static_cast<int>(scan) + 1;
        if (number->value() != value) number->setValue(value);  // else what is being typed stays
    };
    if (shown) {
        show(scan_, chosen_->record.scan);
        show(earlier_, chosen_->record.earlier);
    }
    for (QPushButton* button : {fit_, change_}) set_enabled(*button, shown, *table_);
    for (QPushButton* button : {to_scan_, to_earlier_})
        set_enabled(*button, chosen_.has_value(), *table_);
    view_->set_loop(snapshot, shown ? chosen_ : std::nullopt);
    show_change();
    show_reason();
    emit loop_shown(shown ? chosen_ : std::nullopt);
}

void LoopTable::show_change() {
    const std::vector<GraphEdit> made = edits();
    const bool changed = chosen_ && change_of(made, *chosen_) != made.end();
    if (changed && !view_->laid_by_hand()) {
        change_->setText(tr("Take back"));
        change_->setToolTip(tr("Does not change this place by hand any more"));
    } else if (chosen_ && chosen_->closed() && !view_->laid_by_hand()) {
        change_->setText(tr("Refuse"));
        change_->setToolTip(tr("Takes this loop, and what was found beside it, out of the map"));
    } else {
        change_->setText(tr("Close"));
        change_->setToolTip(tr("Closes this loop as both passages lie below"));
    }
}

void LoopTable::show_reason() {
    // Behind another dock nothing is enabled.
    if (!change_->isEnabledTo(this)) {
        reason_->clear();
    } else if (measured_) {
        constexpr double kFits = 0.3;
        const QString words =
            measured_->score < kFits ? tr("It fits nothing here: %1.") : tr("Fitted: %1.");
        reason_->setText(words.arg(measured_words(*measured_)));
    } else if (view_->laid_by_hand()) {
        reason_->setText(tr("Laid by hand; Fit lays it on the walls."));
    } else if (proposed_ && found_in(loops_, *chosen_) == loops_.end()) {
        reason_->setText(tr("As the path has both passages; drag the later one, or Fit it."));
    } else {
        reason_->setText(verdict_words(chosen_->record.verdict) + ": " +
                         words_of(reason_of(chosen_->record)) + ".");
    }
}

}  // namespace hitos::window
