// SPDX-License-Identifier: GPL-3.0-or-later
// Use cases 8.2.2.6 to 8.2.2.8: running, looking at maps.

#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include "dialogs/configuration_dialog.hpp"
#include "gui_fixture.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "tests.hpp"
#include "workers/first_look.hpp"

namespace hitos::window {
namespace {

using State = Progress::State;

bool run_enabled(const Fixture& f) {
    return f.action("action_run")->isEnabled() || f.action("action_step")->isEnabled();
}

}  // namespace

void RunTest::without_a_source_nothing_can_run() {
    Fixture f(false);
    for (const char* name : {"action_run", "action_stop", "action_step", "action_best_map",
                             "action_odometry", "action_save_map", "action_restart"}) {
        QVERIFY2(!f.action(name)->isEnabled(), name);
    }
}

void RunTest::the_first_scan_is_there_before_the_run() {
    Fixture f;
    auto* look = f.window->findChild<FirstLook*>();
    const auto* title = f.window->findChild<QLabel*>("scan_panel_title");
    const auto looked = [&] { return look->snapshot() != nullptr; };
    QTRY_VERIFY(looked());
    QVERIFY(title->text().startsWith("First scan"));
    // The run itself has not begun, and has the same state once it has.
    QCOMPARE(f.steps(), 0U);
    QVERIFY(!f.session.snapshot() && !f.action("action_best_map")->isEnabled());
    const std::shared_ptr<const Snapshot> before = look->snapshot();
    f.run_steps(1);
    QVERIFY(f.session.snapshot()->best_map.size() == before->best_map.size());
    QCOMPARE(f.session.snapshot()->best_hypothesis, before->best_hypothesis);
    QVERIFY(f.session.snapshot()->best_trajectory == before->best_trajectory);
    QCOMPARE(title->text(), QString("Last scan"));
    f.trigger("action_restart");
    QTRY_VERIFY(title->text().startsWith("First scan"));
    // It is that of the parameters in use.
    Configuracion lines_alone = Fixture::tour(10);
    set_parameter(lines_alone, "features.detect=lines");
    f.session.set_configuration(lines_alone);
    QTRY_VERIFY(looked() && look->snapshot()->observation.corners.empty());
    QVERIFY(!before->observation.corners.empty());
    // A log that cannot be run is told by the run; without a source there is nothing to show.
    QVERIFY(f.window->configuration_actions().open(f.write("small.txt", "ODOM 0 0 0\n")));
    QTest::qWait(50);
    QVERIFY(!looked() && !title->text().startsWith("First scan"));
}

void RunTest::one_step_is_one_scan() {
    Fixture f;
    for (quint64 step = 1; step <= 3; ++step) {
        f.trigger("action_step");
        QTRY_VERIFY(f.state() == State::paused && f.shows_everything());
        QCOMPARE(f.steps(), step);
    }
    QVERIFY(f.action("action_best_map")->isEnabled());
    // The status line is renewed on a timer of its own.
    QTRY_VERIFY(f.window->findChild<QLabel*>("status_scan")->text().contains('3'));
}

void RunTest::it_stops_and_goes_on() {
    Fixture f;
    f.session.set_pace(kUnhurried);
    f.trigger("action_run");
    QTRY_VERIFY(f.steps() > 2);
    QVERIFY(!f.action("action_run")->isEnabled());
    f.trigger("action_stop");
    QTRY_VERIFY(f.state() == State::paused && f.shows_everything());
    const quint64 there = f.steps();
    QTest::qWait(60);
    QCOMPARE(f.steps(), there);
    QVERIFY(f.action("action_run")->isEnabled());
    f.trigger("action_run");
    QTRY_VERIFY(f.steps() > there);
}

void RunTest::at_the_end_the_run_buttons_are_inactive() {
    Fixture f;
    f.run_to_end();
    QCOMPARE(f.steps(), 1050U);
    QTRY_VERIFY(!run_enabled(f));
    QVERIFY(!f.action("action_stop")->isEnabled());
    QVERIFY(f.action("action_restart")->isEnabled());
    QVERIFY(f.action("action_save_map")->isEnabled());
    QCOMPARE(f.window->findChild<QLabel*>("status_state")->text(), QString("End of the log"));
}

void RunTest::the_end_of_the_tour_is_shown_too() {
    // Of a run that is looked at after its last scan: the end moves path and map once more.
    Fixture f;
    f.run_to_end();
    const quint64 scans = f.steps();
    f.trigger("action_restart");
    f.run_steps(scans);
    QVERIFY(f.state() == State::paused);
    QVERIFY(f.session.snapshot()->advice.empty());
    f.trigger("action_step");
    QTRY_VERIFY(f.state() == State::finished && f.shows_everything());
    QCOMPARE(f.steps(), scans);
    QCOMPARE(f.session.snapshot()->revision, scans + 1);
}

void RunTest::after_the_end_it_restarts() {
    Fixture f;
    f.run_to_end();
    f.trigger("action_restart");
    QCOMPARE(f.steps(), 0U);
    QVERIFY(run_enabled(f));
    QVERIFY(!f.session.snapshot());
    QVERIFY(!f.action("action_save_map")->isEnabled());
    f.run_steps(2);
    QCOMPARE(f.steps(), 2U);
}

void RunTest::it_restarts_while_running() {
    Fixture f;
    f.session.set_pace(kUnhurried);
    f.trigger("action_run");
    QTRY_VERIFY(f.action("action_restart")->isEnabled());
    QCOMPARE(f.state(), State::running);
    f.trigger("action_restart");
    QVERIFY(!f.session.snapshot());
    QTRY_COMPARE(f.state(), State::ready);
    QCOMPARE(f.steps(), 0U);
    QVERIFY(run_enabled(f));
    f.run_steps(2);
    QCOMPARE(f.steps(), 2U);
}

void RunTest::the_space_bar_runs_and_stops() {
    Fixture f;
    f.session.set_pace(kUnhurried);
    QTest::keyClick(f.window.get(), Qt::Key_Space);
    QTRY_VERIFY(f.steps() > 2);
    QCOMPARE(f.state(), State::running);
    QTest::keyClick(f.window.get(), Qt::Key_Space);
    QTRY_COMPARE(f.state(), State::paused);
    QTRY_VERIFY(f.shows_everything() && run_enabled(f));
    const quint64 there = f.steps();
    QTest::keyClick(f.window.get(), Qt::Key_Right);
    QTRY_COMPARE(f.steps(), there + 1);
}

void RunTest::the_keyboard_stays_with_running_and_stopping() {
    Fixture f;
    f.session.set_pace(kUnhurried);
    auto* run = f.window->findChild<QToolButton*>("button_run");
    auto* stop = f.window->findChild<QToolButton*>("button_stop");
    auto* step = f.window->findChild<QToolButton*>("button_step");
    QTRY_VERIFY(run->isEnabled());
    for (auto* first : {run, step}) {
        first->setFocus(Qt::TabFocusReason);
        f.window->findChild<QAction*>("action_run")->trigger();
        QTRY_VERIFY(stop->hasFocus());
        const quint64 there = f.steps();
        QTRY_VERIFY(f.steps() > there);
        QTest::keyClick(stop, Qt::Key_Space);
        QTRY_COMPARE(f.state(), State::paused);
        QTRY_VERIFY(first->hasFocus());
        QTRY_VERIFY(f.shows_everything() && run_enabled(f));
    }
}

void RunTest::the_space_bar_presses_what_has_the_focus() {
    Fixture f;
    auto* step = f.window->findChild<QToolButton*>("button_step");
    QTRY_VERIFY(step->isEnabled());
    step->setFocus(Qt::TabFocusReason);
    QTest::keyClick(step, Qt::Key_Space);
    QTRY_VERIFY(f.state() == State::paused && f.shows_everything());
    QCOMPARE(f.steps(), 1U);
    for (const auto key : {Qt::Key_Space, Qt::Key_Return}) {
        QWidget* card = nullptr;
        for (auto* frame : f.window->findChildren<QFrame*>()) {
            const auto group = frame->property("group");
            if (group.isValid() && group.toInt() == static_cast<int>(ParameterGroup::motion)) {
                card = frame;
            }
        }
        QVERIFY(card != nullptr);
        card->setFocus();
        in_dialog<ConfigurationDialog>([](ConfigurationDialog& dialog) { dialog.reject(); });
        QTest::keyClick(card, key);
        expect_no_awaited_dialog();
    }
    QCOMPARE(f.steps(), 1U);
    f.session.set_configuration(Fixture::tour(7));  // the cards are made anew
    QVERIFY(f.window->focusWidget() != nullptr);
    QCOMPARE(f.window->focusWidget()->property("group").toInt(),
             static_cast<int>(ParameterGroup::motion));
}

void RunTest::closing_while_running_ends_it() {
    Fixture f;
    f.session.set_pace(kUnhurried);
    f.trigger("action_run");
    QTRY_VERIFY(f.steps() > 2);
    QVERIFY(f.window->close());
    QTRY_VERIFY(f.state() != State::running);
}

void RunTest::a_run_that_fails_is_told() {
    Fixture f(false);
    const QString path = f.write("empty.txt", "ODOM 0 0 0\nLASER broken\nODOM 1 0 0\n");
    QVERIFY(f.window->configuration_actions().open(path));
    f.trigger("action_run");
    QTRY_COMPARE(f.state(), State::failed);
    QTRY_COMPARE(f.prompts.warnings.size(), 1);
    QVERIFY2(f.prompts.warnings.front().contains("empty.txt"),
             qPrintable(f.prompts.warnings.front()));
    QVERIFY(!run_enabled(f));
}

void RunTest::the_odometry_map_grows_and_can_be_stopped() {
    Fixture f;
    f.trigger("action_odometry");
    MapWindow* map = f.window->result_actions().odometry_window();
    QVERIFY(map != nullptr && map->isVisible());
    QTRY_VERIFY(!map->view().tiles().empty());
    map->findChild<QPushButton*>("stop")->click();
    QTRY_VERIFY(!map->builder().state().running);
    const bool whole = map->builder().state().path.size() == 1050;
    QVERIFY(map->builder().state().stopped || whole);
    // Asked for anew, it begins anew; the run itself has not moved.
    f.trigger("action_odometry");
    map = f.window->result_actions().odometry_window();
    QTRY_VERIFY(!map->builder().state().running);
    QCOMPARE(map->builder().state().path.size(), 1050U);
    QCOMPARE(f.steps(), 0U);
    map->close();
}

void RunTest::the_odometry_map_can_be_closed_while_it_grows() {
    Fixture f;
    f.trigger("action_odometry");
    QPointer<MapWindow> map = f.window->result_actions().odometry_window();
    QVERIFY(map->builder().state().running);
    map->close();
    QTRY_VERIFY(!map);
    QVERIFY(f.window->result_actions().odometry_window() == nullptr);
}

void RunTest::the_odometry_map_of_a_lost_log_says_so() {
    Fixture f(false);
    const QString path = f.write("small.txt", "ODOM 0 0 0\nLASER 0 2 1 0 1 1\n");
    QVERIFY(f.window->configuration_actions().open(path));
    QFile::remove(path);
    f.trigger("action_odometry");
    MapWindow* map = f.window->result_actions().odometry_window();
    auto* verdict = map->findChild<QLabel*>("verdict");
    QTRY_VERIFY2(verdict->text().contains("small.txt"), qPrintable(verdict->text()));
    QVERIFY(!map->findChild<QPushButton*>("picture")->isEnabled());
}

void RunTest::the_best_particles_map_while_running_is_that_moments() {
    Fixture f;
    f.session.set_pace(kUnhurried);
    f.trigger("action_run");
    QTRY_VERIFY(f.steps() > 20 && f.session.snapshot() && f.session.snapshot()->steps > 0);
    f.trigger("action_best_map");
    MapWindow* map = f.window->result_actions().best_window();
    f.trigger("action_stop");
    QTRY_VERIFY(!map->builder().state().running);
    QVERIFY(!map->builder().state().path.empty());
    QVERIFY(map->builder().state().path.size() <= f.steps());
}

void RunTest::the_best_particles_map_is_shown() {
    Fixture f;
    f.run_steps(60);
    f.trigger("action_best_map");
    MapWindow* map = f.window->result_actions().best_window();
    QVERIFY(map != nullptr && map->isVisible());
    QTRY_VERIFY(!map->builder().state().running);
    QCOMPARE(map->builder().state().path.size(), 60U);
    QVERIFY(!map->view().tiles().empty());
}

void RunTest::any_particles_map_is_shown() {
    Fixture f(true, 12);
    QVERIFY(!f.action("action_particle_map")->isEnabled());
    f.run_steps(60);
    f.trigger("action_particle_map");  // cancelled
    QCOMPARE(f.prompts.greatest_number, 11);
    QVERIFY(f.window->result_actions().particle_window() == nullptr);
    f.prompts.numbers = {7};
    f.trigger("action_particle_map");
    MapWindow* map = f.window->result_actions().particle_window();
    QVERIFY(map != nullptr && map->isVisible());
    QVERIFY2(map->windowTitle().contains('7'), qPrintable(map->windowTitle()));
    QTRY_VERIFY(map->builder().state().path.size() == 60U && !map->builder().state().running);
    const Trajectory path =
        f.session.worker()
            ->with_run([](const Algoritmo& run) { return run.trajectory_of(7); })
            .get();
    QVERIFY(map->builder().state().path == path);
}

}  // namespace hitos::window
