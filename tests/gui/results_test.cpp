// SPDX-License-Identifier: GPL-3.0-or-later
// Use case 8.2.2.9: what a run leaves is saved as the command line writes it.

#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QLineEdit>
#include <QProcess>
#include <QPushButton>

#include "gui_fixture.hpp"
#include "hitos/services/files/map_file.hpp"
#include "tests.hpp"

namespace hitos::window {
namespace {

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

void save_results(Fixture& f) {
    f.prompts.saves = {f.path("results")};
    f.trigger("action_save_results");
    QVERIFY(!f.action("action_save_results")->isEnabled());
    QTRY_VERIFY(f.action("action_save_results")->isEnabled());
    QVERIFY2(f.prompts.warnings.isEmpty(), qPrintable(f.prompts.warnings.join('\n')));
}

/// Of a run that is not at its end now.
void save_as_it_ends(Fixture& f) {
    f.prompts.numbers = {1};
    f.prompts.saves = {f.path("end")};
    f.trigger("action_save_results");
    QTRY_VERIFY(QFile::exists(f.path("end/summary.json")));
    QVERIFY(!f.prompts.offered.isEmpty() && f.prompts.offered.back().contains("at its end"));
    QVERIFY(Fixture::read(f.path("end/summary.json")).contains("\"finished\": true"));
    QTRY_VERIFY(!f.window->result_actions().writing());
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
            return line.contains("\"run_seconds\"") || line.contains("\"scans_per_second\"") ||
                   line.contains("\"rest_xxh3_128\"");  // a digest of them
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

}  // namespace

void RunTest::the_map_is_saved_as_the_command_line_writes_it() {
    Fixture f(true, 30);
    f.run_to_end();
    f.prompts.saves = {f.path("map.txt")};
    f.trigger("action_save_map");
    const QByteArray mine = Fixture::read(f.path("map.txt"));
    QVERIFY(!mine.isEmpty());
    QTRY_VERIFY2(f.notice().contains("map.txt"), qPrintable(f.notice()));
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

void RunTest::a_typed_ending_wins_over_the_filter() {
    const QString drawings = "CAD drawings (*.dxf)";
    const QString all = "All files (*)";
    QCOMPARE(with_ending("/a.b/map", "Maps (*.txt *.map)", "txt"), "/a.b/map.txt");
    QCOMPARE(with_ending("/a.b/map", drawings, "txt"), "/a.b/map.dxf");
    QCOMPARE(with_ending("/a.b/map", all, "txt"), "/a.b/map.txt");
    QCOMPARE(with_ending("map.txt", drawings, "txt"), "map.txt");
    QCOMPARE(with_ending("map.v2", drawings, "txt"), "map.v2");
    QCOMPARE(with_ending("folder", "Folders (*)", {}), "folder");
    // Through the dialog itself, with the filter as it opens: "Maps (*.txt *.map)".
    const QTemporaryDir folder;
    for (const auto& [typed, written] :
         {std::pair("out1.dxf", "out1.dxf"), std::pair("out1", "out1.txt")}) {
        in_dialog<QFileDialog>([name = typed](QFileDialog& dialog) {
            dialog.findChild<QLineEdit*>("fileNameEdit")->setText(name);
            dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save)->click();
        });
        QtPrompts prompts;
        QCOMPARE(prompts.save_file(nullptr, {"Save", folder.path() + "/map",
                                             "Maps (*.txt *.map);;CAD drawings (*.dxf)", "txt"}),
                 folder.filePath(written));
        expect_no_awaited_dialog();
    }
    // A folder that is there is named, not walked into; whoever asked asks about it.
    QDir(folder.path()).mkdir("results");
    in_dialog<QFileDialog>([](QFileDialog& dialog) {
        QCOMPARE(dialog.findChild<QLineEdit*>("fileNameEdit")->text(), QString("results"));
        dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save)->click();
    });
    QtPrompts prompts;
    QCOMPARE(prompts.save_file(nullptr, {"Save", folder.path() + "/results", {}, {}, true}),
             folder.filePath("results"));
}

void RunTest::the_map_is_saved_while_running() {
    Fixture f;
    f.session.set_pace(kUnhurried);
    f.trigger("action_run");
    QTRY_VERIFY(f.steps() > 20 && f.action("action_save_map")->isEnabled());
    f.prompts.saves = {f.path("map.txt")};
    f.trigger("action_save_map");
    QVERIFY(f.prompts.warnings.isEmpty());
    QVERIFY(!read_map(f.path("map.txt").toStdString()).empty());
}

void RunTest::what_is_saved_at_an_earlier_scan_is_asked_about() {
    Fixture f;
    f.run_steps(40);
    f.session.seek(15);
    QTRY_VERIFY(f.steps() == 15 && f.shows_everything());
    // Given up.
    f.trigger("action_save_map");
    QCOMPARE(f.prompts.saves_asked, 0);
    QVERIFY(f.prompts.offered.front().contains("15") && f.prompts.offered.back().contains("40"));
    // As it is now.
    f.prompts.numbers = {0};
    f.prompts.saves = {f.path("now.txt")};
    f.trigger("action_save_map");
    QCOMPARE(read_map(f.path("now.txt").toStdString()).size(),
             f.session.snapshot()->best_map.size());
    QCOMPARE(f.steps(), quint64{15});
    // As far as it came: the run goes there first.
    f.prompts.numbers = {1};
    f.prompts.saves = {f.path("end")};
    f.trigger("action_save_results");
    QTRY_VERIFY(QFile::exists(f.path("end/summary.json")));
    QCOMPARE(f.steps(), quint64{40});
    QVERIFY(Fixture::read(f.path("end/summary.json")).contains("\"scans\": 40"));
    QTRY_VERIFY(!f.window->result_actions().writing());
    // And there nobody asks.
    f.prompts.offered.clear();
    f.prompts.saves = {f.path("again.txt")};
    f.trigger("action_save_map");
    QVERIFY(f.prompts.offered.isEmpty() && QFile::exists(f.path("again.txt")));
}

void RunTest::a_run_that_was_over_is_saved_as_it_was_then() {
    Fixture f(true, 20);
    f.run_to_end();
    const quint64 scans = f.steps();
    f.session.seek(scans - 1);
    QTRY_VERIFY(f.steps() == scans - 1 && f.shows_everything());
    save_as_it_ends(f);
}

void RunTest::a_run_at_its_last_scan_is_saved_as_it_ends() {
    const auto stand_at_the_last = [](Fixture& f) {
        f.run_to_end();
        const quint64 scans = f.steps();
        f.session.restart();
        f.session.seek(scans);
        QTRY_VERIFY(f.steps() == scans && f.shows_everything());
        QVERIFY(f.session.progress().state == Progress::State::paused);
    };
    {  // Without registration there are no last passes.
        Fixture f(true, 20);
        stand_at_the_last(f);
        f.prompts.saves = {f.path("map.txt")};
        f.trigger("action_save_map");
        QVERIFY(f.prompts.offered.isEmpty() && QFile::exists(f.path("map.txt")));
    }
    Fixture f(false);
    Configuracion registered =
        ArchivoConfiguracion::read(Fixture::source_file("config/recorded.cfg").toStdString());
    registered.source.file = Fixture::source_file("data/bigloop.log.gz").toStdString();
    registered.filter.particles = 3;
    f.session.set_configuration(registered);
    stand_at_the_last(f);
    save_as_it_ends(f);
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

void RunTest::closing_waits_for_results_that_are_being_written() {
    Fixture f(true, 20);
    f.run_to_end();
    f.prompts.saves = {f.path("results")};
    f.trigger("action_save_results");
    const QString said = f.window->statusBar()->currentMessage();
    QVERIFY2(said.contains("Writing results"), qPrintable(said));
    f.window->close();  // declined
    QVERIFY(f.window->isVisible());
    QVERIFY(f.prompts.confirmed_texts.value(0).contains("written"));
    f.prompts.confirms = {true};
    f.window->close();
    QTRY_VERIFY(!f.window->isVisible());
    QVERIFY(!f.window->result_actions().writing());
    QVERIFY(QFile::exists(f.path("results/summary.json")));
    QVERIFY(f.prompts.warnings.isEmpty());
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
