// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_controls.hpp"

#include <QAction>
#include <QApplication>
#include <QHBoxLayout>
#include <QPointer>
#include <QToolButton>

#include "hitos/simulation/drive/simulated_tour.hpp"
#include "look/icons.hpp"
#include "look/named.hpp"
#include "look/parameter_text.hpp"
#include "pace_control.hpp"
#include "views/time_line.hpp"

namespace hitos::window {
namespace {

constexpr double kLongUnseen = 10.0;  // [s]; of a landmark that is worth a mark when it comes back

}  // namespace

RunControls::RunControls(QWidget* parent) : QWidget(parent) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    time_line_ = named(new TimeLine(this), "time_line");
}

QToolButton* RunControls::add_button(QAction* action, const char* name, bool primary) {
    auto* button = named(new QToolButton(this), name);
    button->setProperty("role", "run");
    button->setProperty("primary", primary);
    button->setDefaultAction(action);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setIconSize(QSize(18, 18));
    button->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    button->setFocusPolicy(Qt::TabFocus);
    layout()->addWidget(button);
    return button;
}

void RunControls::set_up(const RunActions& actions, Session& session, QSettings& settings) {
    actions_ = actions;
    actions.run->setIcon(icon(Glyph::run));
    actions.stop->setIcon(icon(Glyph::stop));
    actions.step->setIcon(icon(Glyph::step));
    actions.best_map->setIcon(icon(Glyph::best_map));
    actions.odometry->setIcon(icon(Glyph::odometry));
    actions.save_map->setIcon(icon(Glyph::save_map));
    actions.restart->setIcon(icon(Glyph::restart));
    run_ = add_button(actions.run, "button_run", true);
    stop_ = add_button(actions.stop, "button_stop");
    step_ = add_button(actions.step, "button_step");
    qobject_cast<QHBoxLayout*>(layout())->addWidget(time_line_, 1);
    pace_ = new PaceControl(session, settings, actions.full_speed, this);
    layout()->addWidget(pace_);
    setTabOrder(step_, time_line_);
    setTabOrder(time_line_, pace_);
    maps_ = {add_button(actions.best_map, "button_best_map"),
             add_button(actions.odometry, "button_odometry"),
             add_button(actions.save_map, "button_save_map")};
    controls_ = {run_, stop_, step_, add_button(actions.restart, "button_restart")};
    measure();
    connect(&session, &Session::configuration_changed, this, &RunControls::measure);
    connect(actions.run, &QAction::triggered, &session, [&session] { session.run(); });
    connect(actions.stop, &QAction::triggered, &session, &Session::pause);
    connect(actions.step, &QAction::triggered, &session, [&session] { session.run_steps(1); });
    // Behind the last scan the path is smoothed: nobody who goes to the end means to miss that.
    connect(time_line_, &TimeLine::chosen, &session, [this, &session](int scan) {
        const auto wanted = static_cast<quint64>(scan);
        const bool to_end = total_ && wanted >= *total_ && !session.is_live();
        if (to_end && session.progress().state == Progress::State::finished) return;
        session.seek(to_end ? RunWorker::kToTheEnd : wanted);
    });
    connect(actions.previous_event, &QAction::triggered, time_line_,
            [this] { time_line_->choose_event(false); });
    connect(actions.next_event, &QAction::triggered, time_line_,
            [this] { time_line_->choose_event(true); });
    const auto refresh = [this, &session] {
        show_progress(session.progress(), session.has_source());
        pace_->setEnabled(!session.is_live());  // which has its own
        if (session.has_source()) note_marks(session);
        enable_events();
    };
    connect(&session, &Session::restarted, this, &RunControls::forget_marks);
    connect(&session, &Session::progress_changed, this, refresh);
    connect(&session, &Session::configuration_changed, this, refresh);
    refresh();
}

void RunControls::set_words(Words words) {
    const auto style = [](bool told) {
        return told ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly;
    };
    for (QToolButton* button : controls_) button->setToolButtonStyle(style(words != Words::none));
    for (QToolButton* button : maps_) button->setToolButtonStyle(style(words == Words::all));
}

/// What the row needs beside the time line.
int RunControls::width_with(Words words) {
    set_words(words);
    int width = pace_->sizeHint().width();
    for (auto* button : findChildren<QToolButton*>(QString(), Qt::FindDirectChildrenOnly)) {
        button->ensurePolished();
        width += button->sizeHint().width() + layout()->spacing();
    }
    return width + layout()->spacing();
}

/// The buttons' words are those of what runs.
void RunControls::measure() {
    least_width_ = width_with(Words::none);
    some_width_ = width_with(Words::of_controls);
    full_width_ = width_with(Words::all);
    fit_buttons();
}

/// The time line comes before the words, and those of the maps go first.
void RunControls::fit_buttons() {
    constexpr int kTimeLine = 160;
    const int room = width() - kTimeLine;
    set_words(room >= full_width_   ? Words::all
              : room >= some_width_ ? Words::of_controls
                                    : Words::none);
}

QSize RunControls::minimumSizeHint() const {
    return {least_width_ + time_line_->minimumSizeHint().width(),
            QWidget::minimumSizeHint().height()};
}

void RunControls::resizeEvent(QResizeEvent* event) {
    fit_buttons();
    QWidget::resizeEvent(event);
}

void RunControls::pass_focus(bool running, bool can_run) {
    if (running == actions_.stop->isEnabled()) return;
    QWidget* focused = QApplication::focusWidget();
    if (running && (focused == run_ || focused == step_)) {
        before_stop_ = focused;
        actions_.stop->setEnabled(true);
        stop_->setFocus();
    } else if (!running && focused == stop_ && can_run) {
        actions_.run->setEnabled(true);
        actions_.step->setEnabled(true);
        QWidget* back = before_stop_ == nullptr ? run_ : before_stop_;
        back->setFocus();
    }
}

void RunControls::show_progress(const Progress& progress, bool has_source) {
    using State = Progress::State;
    const bool over = progress.state == State::finished || progress.state == State::failed;
    const bool running = progress.state == State::running;
    const bool begun = progress.steps > 0;
    pass_focus(running, has_source && !over);
    const QPointer<QWidget> focused(QApplication::focusWidget());
    actions_.run->setEnabled(has_source && !over && !running);
    actions_.step->setEnabled(has_source && !over && !running);
    actions_.stop->setEnabled(running);
    actions_.restart->setEnabled(has_source && (begun || over));
    actions_.best_map->setEnabled(begun);
    actions_.save_map->setEnabled(begun);
    actions_.odometry->setEnabled(has_source);
    time_line_->setEnabled(has_source && progress.state != State::failed);
    // The keyboard stays here, and Space means the run, where its button has gone grey.
    if (focused && focused->parentWidget() == this && !focused->isEnabled()) {
        for (QWidget* next : {static_cast<QWidget*>(run_), static_cast<QWidget*>(time_line_),
                              static_cast<QWidget*>(controls_.back())}) {
            if (!next->isEnabled()) continue;
            next->setFocus();
            break;
        }
    }
    if (!running) time_line_->arrive();
    const auto scan = static_cast<int>(progress.steps);
    time_line_->show_run(scan, static_cast<int>(total_.value_or(figures_taken_)));
}

void RunControls::enable_events() {
    actions_.previous_event->setEnabled(time_line_->event_beside(false) > 0);
    actions_.next_event->setEnabled(time_line_->event_beside(true) > 0);
}

void RunControls::set_total(std::optional<quint64> scans) {
    total_ = scans;
    time_line_->show_run(time_line_->value(), static_cast<int>(total_.value_or(figures_taken_)));
}

void RunControls::set_duration(double seconds) {
    pace_->suit(seconds);
}

/// Of scans that were not seen before; going back forgets none.
void RunControls::note_marks(const Session& session) {
    const RunWorker& worker = *session.worker();
    const bool sometimes = session.configuration().filter.resampling.rule != ResamplingRule::always;
    using Kind = TimeLine::Mark::Kind;
    std::vector<TimeLine::Mark> fresh;
    for (const StepFigures& step : worker.figures_since(figures_taken_)) {
        const auto scan = static_cast<int>(++figures_taken_);
        const auto mark = [&](const QString& text, Kind kind) {
            fresh.push_back({scan, text, kind});
        };
        if (step.created > 0) mark(tr("new landmarks: %1").arg(step.created), Kind::event);
        if (step.loop_closed) mark(tr("a loop was closed"), Kind::loop);
        if (step.unseen_s >= kLongUnseen) {
            mark(tr("a landmark seen again after %1 s").arg(step.unseen_s, 0, 'f', 1), Kind::event);
        }
        if (step.resampled && sometimes) mark(tr("resampled"), Kind::filter);
        if (step.best_changed) mark(tr("another particle is the best"), Kind::filter);
        if (step.skipped > skipped_) {
            mark(tr("damaged and skipped before it: %1").arg(step.skipped - skipped_),
                 Kind::damage);
        }
        skipped_ = step.skipped;
    }
    time_line_->add_marks(fresh);
    note_disturbances(session);
}

/// What happens to a simulated robot, at the first scan after it.
void RunControls::note_disturbances(const Session& session) {
    const auto& tour = session.simulated_tour();
    if (!tour) return;
    std::vector<TimeLine::Mark> fresh;
    const std::vector<Disturbance> all = tour->disturbances();
    disturbances_noted_.resize(all.size(), false);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::uint64_t scan = tour->scan_from(all[i].at_s) + 1;
        if (disturbances_noted_[i] || scan > figures_taken_) continue;
        disturbances_noted_[i] = true;
        const QString words = translated("Disturbance", all[i].facts().label);
        fresh.push_back({static_cast<int>(scan), words, TimeLine::Mark::Kind::disturbance});
    }
    time_line_->add_marks(fresh);
}

void RunControls::forget_marks() {
    figures_taken_ = 0;
    skipped_ = 0;
    disturbances_noted_.clear();
    time_line_->set_marks({});
}

}  // namespace hitos::window
