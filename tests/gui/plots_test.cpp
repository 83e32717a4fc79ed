// SPDX-License-Identifier: GPL-3.0-or-later
// Time in the plots: every step, the errors, the shared cursor, and the figures as a table.

#include "views/plots.hpp"

#include <qcustomplot.h>

#include <QProcess>
#include <QWheelEvent>

#include "gui_fixture.hpp"
#include "tests.hpp"
#include "views/time_line.hpp"

namespace hitos::window {
namespace {

using State = Progress::State;

}  // namespace

void TimeTest::the_plots_have_every_step() {
    Fixture f;
    f.trigger("action_plots_dock");
    f.run_to_end();
    for (const Plots::Figure figure :
         {Plots::neff, Plots::landmarks, Plots::features, Plots::best_weight, Plots::step_time}) {
        QTRY_COMPARE(f.window->plots().points(figure), 1050);
    }
    f.trigger("action_restart");
    QCOMPARE(f.window->plots().points(Plots::neff), 0);
}

void TimeTest::errors_against_the_reference_are_measured() {
    Fixture f;
    f.trigger("action_plots_dock");
    References references;
    references.map = read_map(Fixture::source_file("data/maps/bigloop.map").toStdString());
    references.trajectory = Trajectory{{0.0, {0.0, 0.0, 0.0}}, {100.0, {1.0, 0.0, 0.0}}};
    f.session.set_references(references);
    f.run_steps(100);
    QTRY_VERIFY(f.window->plots().points(Plots::map_error) > 0);
}

void TimeTest::errors_against_another_reference_begin_anew() {
    Fixture f;
    f.trigger("action_plots_dock");
    References references;
    references.map = read_map(Fixture::source_file("data/maps/bigloop.map").toStdString());
    f.session.set_references(references);
    f.run_steps(50);
    constexpr int kPoints = 7;  // at every eighth scan, and at the last
    QTRY_COMPARE(f.window->plots().points(Plots::map_error), kPoints);
    f.session.set_references(references);
    QCOMPARE(f.window->plots().points(Plots::map_error), 0);
    QTRY_COMPARE(f.window->plots().points(Plots::map_error), kPoints);  // measured again
    f.session.set_references({});
    QCOMPARE(f.window->plots().points(Plots::map_error), 0);
}

void TimeTest::the_plots_share_the_time_lines_cursor() {
    Fixture f;
    f.trigger("action_plots_dock");
    f.run_to_end();
    Plots& plots = f.window->plots();
    QTRY_COMPARE(plots.points(Plots::neff), 1050);
    auto* canvas = plots.findChild<QCustomPlot*>();
    const auto on_canvas = [&](double time_s) {
        return canvas->mapFrom(&plots, plots.place_of(time_s));
    };
    QTest::mouseClick(canvas, Qt::LeftButton, {}, on_canvas(100.0));
    QTRY_VERIFY(f.state() == State::paused && f.shows_everything());
    QVERIFY2(f.steps() > 480 && f.steps() < 520, qPrintable(QString::number(f.steps())));
    auto* line = f.window->findChild<TimeLine*>("time_line");
    QTRY_COMPARE(line->value(), static_cast<int>(f.steps()));
    // What is under the mouse is told.
    QCOMPARE(plots.title(Plots::landmarks), QString("Landmarks"));
    QMouseEvent move(QEvent::MouseMove, QPointF(on_canvas(150.0)),
                     canvas->mapToGlobal(QPointF(on_canvas(150.0))), Qt::NoButton, Qt::NoButton,
                     Qt::NoModifier);
    QApplication::sendEvent(canvas, &move);
    QVERIFY2(plots.title(Plots::landmarks).startsWith("Landmarks: 1"),
             qPrintable(plots.title(Plots::landmarks)));
}

void TimeTest::the_plots_zoom_along_time() {
    Fixture f;
    f.trigger("action_plots_dock");
    f.run_to_end();
    Plots& plots = f.window->plots();
    QTRY_COMPARE(plots.points(Plots::neff), 1050);
    const auto whole = plots.times();
    auto* canvas = plots.findChild<QCustomPlot*>();
    const QPoint place = canvas->mapFrom(&plots, plots.place_of(100.0));
    QWheelEvent turn(place, canvas->mapToGlobal(place), {}, {0, 240}, Qt::NoButton, Qt::NoModifier,
                     Qt::NoScrollPhase, false);
    QApplication::sendEvent(canvas, &turn);
    QVERIFY(plots.times().second - plots.times().first < whole.second - whole.first);
    QTest::mouseDClick(canvas, Qt::LeftButton, {}, place);
    QTRY_COMPARE(plots.times(), whole);
    // A double click is no click: the run stays where it is.
    QTest::qWait(2 * QApplication::doubleClickInterval());
    QCOMPARE(f.state(), State::finished);
}

void TimeTest::plots_without_a_figure_take_no_room() {
    Fixture f;
    f.trigger("action_plots_dock");
    Plots& plots = f.window->plots();
    f.run_steps(30);
    QTRY_COMPARE(plots.points(Plots::neff), 30);
    QVERIFY(!plots.shows(Plots::map_error) && !plots.shows(Plots::trajectory_error) &&
            !plots.shows(Plots::position_error));
    Configuracion ekf = Fixture::tour(10);
    ekf.filter.algorithm = "ekf-slam";
    f.session.set_configuration(ekf);
    f.run_steps(30);
    QTRY_COMPARE(plots.points(Plots::landmarks), 30);
    QVERIFY(!plots.shows(Plots::neff) && !plots.shows(Plots::best_weight));
}

void TimeTest::errors_are_of_the_same_scans_every_time() {
    References references;
    references.map = read_map(Fixture::source_file("data/maps/bigloop.map").toStdString());
    const auto points = [&](quint64 piece) {
        Fixture f;
        f.session.set_references(references);
        f.trigger("action_plots_dock");
        for (quint64 at = 0; at < 96; at += piece) f.run_steps(piece);
        const Plots& plots = f.window->plots();
        // Every eighth scan has a checkpoint.
        if (!QTest::qWaitFor([&] { return plots.points(Plots::map_error) >= 12; }, kPatienceMs))
            return -1;
        return plots.points(Plots::map_error);
    };
    QCOMPARE(points(96), 12);
    QCOMPARE(points(24), 12);
}

void TimeTest::the_figures_are_those_of_the_command_line() {
    Fixture f;
    f.run_to_end();
    f.prompts.saves = {f.path("figures.csv")};
    f.trigger("action_save_figures");
    QProcess program;
    program.start(QString(HITOS_BIN_DIR) + "/hitos-cli",
                  {"run", Fixture::source_file("data/bigloop.log.gz"), "--config",
                   Fixture::source_file("config/thesis.cfg"), "--set", "filter.particles=10",
                   "--out", f.path("out"), "--figures", f.path("cli.csv")});
    QVERIFY(program.waitForFinished(kPatienceMs));
    QCOMPARE(program.exitCode(), 0);
    // All columns but the last, the time that each step took.
    const auto without_time = [](const QByteArray& table) {
        QList<QByteArray> lines = table.split('\n');
        for (QByteArray& line : lines) line.truncate(line.lastIndexOf(','));
        return lines;
    };
    const auto saved = without_time(Fixture::read(f.path("figures.csv")));
    QCOMPARE(saved.size(), 1052);  // with the heading and the end
    QVERIFY(saved == without_time(Fixture::read(f.path("cli.csv"))));
}

}  // namespace hitos::window
