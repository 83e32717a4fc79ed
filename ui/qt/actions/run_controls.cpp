#include "run_controls.hpp"

#include <QAction>
#include <QApplication>
#include <QHBoxLayout>
#include <QProgressBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <cmath>

#include "app/icons.hpp"

namespace hitos::window {
namespace {

constexpr int kProgressSteps = 1000;

}  // namespace

RunControls::RunControls(QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    progress_ = new QProgressBar(this);
    progress_->setObjectName("run_progress");
    progress_->setRange(0, kProgressSteps);
    progress_->setTextVisible(false);
    column->addWidget(progress_);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    column->addLayout(row);
}

QToolButton* RunControls::add_button(QAction* action, const char* name, bool primary) {
    auto* button = new QToolButton(this);
    button->setObjectName(name);
    button->setProperty("role", "run");
    button->setProperty("primary", primary);
    button->setDefaultAction(action);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setIconSize(QSize(18, 18));
    button->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    button->setFocusPolicy(Qt::TabFocus);
    auto* row = qobject_cast<QHBoxLayout*>(layout()->itemAt(1)->layout());
    row->addWidget(button);
    return button;
}

void RunControls::set_up(const RunActions& actions, Session& session) {
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
    auto* row = qobject_cast<QHBoxLayout*>(layout()->itemAt(1)->layout());
    row->addStretch(1);
    add_button(actions.best_map, "button_best_map");
    add_button(actions.odometry, "button_odometry");
    add_button(actions.save_map, "button_save_map");
    row->addStretch(1);
    add_button(actions.restart, "button_restart");

    connect(actions.run, &QAction::triggered, &session, &Session::run);
    connect(actions.stop, &QAction::triggered, &session, &Session::pause);
    connect(actions.step, &QAction::triggered, &session, [&session] { session.run_steps(1); });
    connect(actions.restart, &QAction::triggered, &session, &Session::restart);
    const auto refresh = [this, &session] {
        show_progress(session.progress(), session.has_source());
    };
    connect(&session, &Session::progress_changed, this, refresh);
    connect(&session, &Session::configuration_changed, this, refresh);
    refresh();
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
    actions_.run->setEnabled(has_source && !over && !running);
    actions_.step->setEnabled(has_source && !over && !running);
    actions_.stop->setEnabled(running);
    actions_.restart->setEnabled(has_source && (begun || over));
    actions_.best_map->setEnabled(begun);
    actions_.save_map->setEnabled(begun);
    actions_.odometry->setEnabled(has_source);
    // By scans where their number is known; the place in the file runs ahead by what is buffered.
    double part = progress.fraction.value_or(0.0);
    if (total_ && *total_ > 0) {
        part = static_cast<double>(progress.steps) / static_cast<double>(*total_);
    }
    progress_->setValue(static_cast<int>(std::lround(part * kProgressSteps)));
}

}  // namespace hitos::window
