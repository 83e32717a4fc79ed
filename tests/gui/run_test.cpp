// Use cases 8.2.2.6 to 8.2.2.9: running, looking at maps, saving the map.

#include <QLabel>
#include <QProcess>
#include <QPushButton>
#include <QToolButton>

#include "dialogs/configuration_dialog.hpp"
#include "gui_fixture.hpp"
#include "tests.hpp"
#include "views/plots.hpp"

namespace hitos::window {
namespace {

using State = Progress::State;

bool run_enabled(const Fixture& f) {
    return f.action("action_run")->isEnabled() || f.action("action_step")->isEnabled();
}

/// What hitos-cli makes of the same configuration.
QString command_line_results(Fixture& f) {
    f.prompts.saves = {f.path("same.cfg")};
    f.trigger("action_save");
    QProcess cli;
    cli.start(QString(HITOS_BIN_DIR) + "/hitos-cli",
              {"run", QString::fromStdString(f.session.configuration().source.file), "--config",
               f.path("same.cfg"), "--out", f.path("cli")});
    if (!cli.waitForFinished(120000) || cli.exitCode() != 0) qFatal("hitos-cli has failed");
    return f.path("cli");
}

}  // namespace

void RunTest::without_a_source_nothing_can_run() {
    Fixture f(false);
    for (const char* name : {"action_run", "action_stop", "action_step", "action_best_map",
                             "action_odometry", "action_save_map", "action_restart"}) {
        QVERIFY2(!f.action(name)->isEnabled(), name);
    }
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
    Fixture f(true, 200);
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
    Fixture f(true, 500);
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
    Fixture f(true, 200);
    QVERIFY(QTest::qWaitForWindowActive(f.window.get()));
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
    Fixture f(true, 400);
    f.window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(f.window.get()));
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
    f.window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(f.window.get()));
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
    Fixture f(true, 300);
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

void RunTest::the_plots_have_every_step() {
    Fixture f;
    f.trigger("action_plots");
    f.run_to_end();
    for (int plot = 0; plot < 4; ++plot) QTRY_COMPARE(f.window->plots().points(plot), 1050);
    f.trigger("action_restart");
    QCOMPARE(f.window->plots().points(0), 0);
}

void RunTest::errors_against_the_reference_are_measured() {
    Fixture f;
    References references;
    references.map = read_map(Fixture::source_file("data/maps/bigloop.map").toStdString());
    references.trajectory = Trajectory{{0.0, {0.0, 0.0, 0.0}}, {100.0, {1.0, 0.0, 0.0}}};
    f.session.set_references(references);
    f.run_steps(100);
    QTRY_VERIFY(f.window->plots().points(4) > 0);
}

void RunTest::errors_against_another_reference_begin_anew() {
    Fixture f;
    References references;
    references.map = read_map(Fixture::source_file("data/maps/bigloop.map").toStdString());
    f.session.set_references(references);
    f.run_steps(50);
    QTRY_VERIFY(f.window->plots().points(4) > 0);
    f.session.set_references(references);
    QCOMPARE(f.window->plots().points(4), 0);
    QTRY_COMPARE(f.window->plots().points(4), 1);  // the moment that is shown, measured again
    f.session.set_references({});
    QCOMPARE(f.window->plots().points(4), 0);
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
    Fixture f(true, 200);
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

void RunTest::the_map_is_saved_as_the_command_line_writes_it() {
    Fixture f(true, 30);
    f.run_to_end();
    f.prompts.saves = {f.path("map.txt")};
    f.trigger("action_save_map");
    const QByteArray mine = Fixture::read(f.path("map.txt"));
    QVERIFY(!mine.isEmpty());
    QVERIFY2(f.notice().contains("map.txt"), qPrintable(f.notice()));
    const QString cli = command_line_results(f);
    QCOMPARE(mine, Fixture::read(cli + "/map.txt"));
    // The name's ending says what is saved: the segments of the lines, or a drawing.
    f.prompts.saves = {f.path("map.seg")};
    f.trigger("action_save_map");
    QCOMPARE(Fixture::read(f.path("map.seg")), Fixture::read(cli + "/segments.txt"));
    f.prompts.saves = {f.path("Map.DXF")};
    f.trigger("action_save_map");
    QCOMPARE(Fixture::read(f.path("Map.DXF")), Fixture::read(cli + "/map.dxf"));
    QVERIFY(!Fixture::read(cli + "/map.dxf").isEmpty());
}

void RunTest::a_files_ending_follows_the_chosen_filter() {
    const QString maps = "Maps (*.txt *.map)";
    const QString drawings = "CAD drawings (*.dxf)";
    const QString all = "All files (*)";
    const QString filters = maps + ";;" + drawings + ";;" + all;
    const auto ending = [&](const QString& path, const QString& chosen) {
        return with_ending(path, filters, chosen, "txt");
    };
    QCOMPARE(ending("/a.b/map", maps), "/a.b/map.txt");
    QCOMPARE(ending("/a.b/map", drawings), "/a.b/map.dxf");
    QCOMPARE(ending("/a.b/map", all), "/a.b/map.txt");
    QCOMPARE(ending("map.txt", drawings), "map.dxf");
    QCOMPARE(ending("map.MAP", maps), "map.MAP");
    QCOMPARE(ending("map.v2", drawings), "map.v2");  // the user's own wish
    QCOMPARE(ending("map.dxf", all), "map.dxf");
    QCOMPARE(with_ending("folder", "Folders (*)", "Folders (*)", {}), "folder");
}

void RunTest::the_map_is_saved_while_running() {
    Fixture f(true, 200);
    f.trigger("action_run");
    QTRY_VERIFY(f.steps() > 20 && f.action("action_save_map")->isEnabled());
    f.prompts.saves = {f.path("map.txt")};
    f.trigger("action_save_map");
    QVERIFY(f.prompts.warnings.isEmpty());
    QVERIFY(!read_map(f.path("map.txt").toStdString()).empty());
}

void save_results(Fixture& f) {
    f.prompts.saves = {f.path("results")};
    f.trigger("action_save_results");
    QVERIFY(!f.action("action_save_results")->isEnabled());
    QTRY_VERIFY(f.action("action_save_results")->isEnabled());
    QVERIFY2(f.prompts.warnings.isEmpty(), qPrintable(f.prompts.warnings.join('\n')));
}

/// Byte for byte, but for the time that the run took.
void compare_results(Fixture& f, const QStringList& others) {
    const QString cli = command_line_results(f);
    const QStringList names = QDir(cli).entryList(QDir::Files);
    QCOMPARE(QDir(f.path("results")).entryList(QDir::Files), names);
    for (const QString& name : others) QVERIFY2(names.contains(name), qPrintable(name));
    const auto without_time = [](const QByteArray& text) {
        QByteArrayList lines = text.split('\n');
        lines.removeIf([](const QByteArray& line) {
            return line.contains("\"run_seconds\"") || line.contains("\"scans_per_second\"");
        });
        return lines;
    };
    for (const QString& name : names) {
        const QByteArray mine = Fixture::read(f.path("results/") + name);
        QVERIFY2(!mine.isEmpty(), qPrintable(name));
        QVERIFY2(without_time(mine) == without_time(Fixture::read(cli + '/' + name)),
                 qPrintable(name));
    }
}

void RunTest::all_results_are_those_of_the_command_line() {
    Fixture f(true, 20);
    f.run_to_end();
    save_results(f);
    compare_results(
        f, {"map.txt", "trajectory.tum", "odometry.tum", "grid_best_steps.png", "grid_best.png",
            "grid_odometry.jpg", "config.cfg", "segments.txt", "map.dxf", "summary.json"});
    QVERIFY(!QFile::exists(f.path("results/paths.png")));
}

void RunTest::all_results_of_a_world_are_those_of_the_command_line() {
    Fixture f(false);
    Configuracion configuration = Fixture::tour(5);
    configuration.source.file = Fixture::source_file("data/worlds/recinto.toml").toStdString();
    f.session.set_configuration(configuration);
    f.run_to_end();
    save_results(f);
    compare_results(f, {"map.txt", "paths.gp", "summary.json"});
    // The truth that the world knows.
    QVERIFY(Fixture::read(f.path("results/summary.json")).contains("\"trajectory_error\""));
}

void RunTest::results_that_cannot_be_written_are_asked_for_again() {
    Fixture f;
    f.run_steps(20);
    const QString file = f.write("file", "precious");
    f.prompts.saves = {file + "/results", f.path("results")};
    f.trigger("action_save_results");
    QTRY_VERIFY(QFile::exists(f.path("results/summary.json")));
    QTRY_VERIFY(f.action("action_save_results")->isEnabled());
    QCOMPARE(f.prompts.warnings.size(), 1);
    QCOMPARE(f.prompts.saves_asked, 2);
    QCOMPARE(Fixture::read(file), QByteArray("precious"));
}

void RunTest::saving_the_map_can_fail_and_be_cancelled() {
    Fixture f;
    f.run_steps(20);
    const QString there = f.write("there.txt", "precious");
    f.prompts.saves = {f.path("no/folder/map.txt"), there};
    f.prompts.confirms = {false};
    f.trigger("action_save_map");
    QCOMPARE(f.prompts.warnings.size(), 1);
    QCOMPARE(f.prompts.saves_asked, 3);  // failed, not overwritten, given up
    QCOMPARE(Fixture::read(there), QByteArray("precious"));
}

}  // namespace hitos::window
