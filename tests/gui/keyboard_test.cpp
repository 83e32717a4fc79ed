// SPDX-License-Identifier: GPL-3.0-or-later
// The use cases of the thesis [T 8.2.2.1-8.2.2.11] with the keyboard alone.

#include "keyboard.hpp"

#include <QClipboard>
#include <QComboBox>
#include <QImage>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QToolTip>

#include "dialogs/configuration_dialog.hpp"
#include "dialogs/export_dialog.hpp"
#include "dialogs/run_until_dialog.hpp"
#include "dialogs/source_dialog.hpp"
#include "dialogs/study_dialog.hpp"
#include "tests.hpp"
#include "views/plots.hpp"
#include "views/study_plots.hpp"

namespace hitos::window {
namespace {

using State = Progress::State;

QString verdict_by_key(const QWidget& dialog) {
    return dialog.findChild<QLabel*>("verdict")->text();
}

void wait_until_read(const QWidget& dialog) {
    QTRY_VERIFY(!verdict_by_key(dialog).startsWith("Reading"));
}

}  // namespace

void KeyboardTest::the_source_is_selected() {
    KeyboardFixture f(0);
    in_dialog<SourceDialog>([](SourceDialog& dialog) {
        press(Qt::Key_F, Qt::AltModifier);
        QCOMPARE(focused(), QString("path"));
        type("/nowhere/tour.log");
        wait_until_read(dialog);
        QVERIFY(verdict_by_key(dialog).contains("/nowhere/tour.log"));
        press(Qt::Key_Return);  // nothing can be accepted
        QVERIFY(dialog.isVisible());
        answer_file(Fixture::source_file("data/bigloop.log.gz"));
        press(Qt::Key_B, Qt::AltModifier);
        QTRY_VERIFY2(verdict_by_key(dialog).contains("1050 scans"),
                     qPrintable(verdict_by_key(dialog)));
        press(Qt::Key_T, Qt::AltModifier);
        press(Qt::Key_Down);
        wait_until_read(dialog);
        press(Qt::Key_Up);
        wait_until_read(dialog);
        press(Qt::Key_Return);
    });
    press(Qt::Key_O, kCtrl);
    QVERIFY(f.session.has_source());
    QTRY_VERIFY2(f.notice().contains("1050"), qPrintable(f.notice()));
    answer_escape<SourceDialog>();
    press(Qt::Key_O, kCtrl);
    // What was opened is in the menu.
    f.session.set_configuration({});
    press(Qt::Key_F, Qt::AltModifier);
    press(Qt::Key_Down);
    press(Qt::Key_Right);
    press(Qt::Key_Return);
    QTRY_VERIFY(f.session.has_source());
}

void KeyboardTest::a_configuration_is_loaded() {
    KeyboardFixture f;
    const QString good = f.write("good.cfg", "[filter]\nparticles = 33\n");
    answer_file(f.write("bad.cfg", "[filter]\nparticles = 0\n"));
    in_dialog<QMessageBox>([good](QMessageBox& told) {
        QVERIFY2(told.text().contains("filter.particles"), qPrintable(told.text()));
        answer_file(good);  // it is asked for again
        answer_box();
        press(Qt::Key_Return);
    });
    press(Qt::Key_L, kCtrl);
    QCOMPARE(f.session.configuration().filter.particles, 33);
    answer_escape<QFileDialog>();
    press(Qt::Key_L, kCtrl);
    QCOMPARE(f.session.configuration().filter.particles, 33);
    // A preset, declined and taken.
    for (const QString& words : {QString("Cancel"), QString()}) {
        QCOMPARE(f.session.configuration().filter.algorithm, std::string("fastslam"));
        answer_box(words);
        choose_in_menu(Qt::Key_C, {"menu_presets", "action_preset_ekf"});
        expect_no_awaited_dialog();
    }
    QCOMPARE(f.session.configuration().filter.algorithm, std::string("ekf-slam"));
    press(Qt::Key_Z, kCtrl);
    QCOMPARE(f.session.configuration().filter.algorithm, std::string("fastslam"));
    press(Qt::Key_Z, kCtrlShift);
    QCOMPARE(f.session.configuration().filter.algorithm, std::string("ekf-slam"));
}

void KeyboardTest::the_configuration_is_saved() {
    KeyboardFixture f;
    const QString path = f.path("mine.cfg");
    answer_file(f.path("no/such/folder.cfg"));
    in_dialog<QMessageBox>([path](QMessageBox& /*told*/) {
        answer_file(path);
        press(Qt::Key_Return);
    });
    press(Qt::Key_S, kCtrl);
    QCOMPARE(ArchivoConfiguracion::read(path.toStdString()).filter.particles, 10);
    f.session.set_configuration(Fixture::tour(12));
    // Return alone replaces nothing; the name is asked for again.
    answer_file(path);
    in_dialog<QMessageBox>([path](QMessageBox& /*question*/) {
        answer_file(path);
        answer_box("Replace");
        press(Qt::Key_Return);
    });
    press(Qt::Key_S, kCtrl);
    expect_no_awaited_dialog();
    QCOMPARE(ArchivoConfiguracion::read(path.toStdString()).filter.particles, 12);
    answer_escape<QFileDialog>();
    press(Qt::Key_S, kCtrl);
}

void KeyboardTest::the_configuration_is_changed_by_hand() {
    KeyboardFixture f;
    const auto change = [](const QString& value, Qt::Key end) {
        in_dialog<ConfigurationDialog>([=](ConfigurationDialog& dialog) {
            tab_to("field_filter.particles");
            type(value);
            press(end);
            if (dialog.isVisible()) press(Qt::Key_Escape);
        });
    };
    change("0", Qt::Key_Return);
    press(Qt::Key_M, kCtrl);
    QCOMPARE(f.session.configuration().filter.particles, 10);
    change("25", Qt::Key_Escape);
    press(Qt::Key_M, kCtrl);
    QCOMPARE(f.session.configuration().filter.particles, 10);
    change("25", Qt::Key_Return);
    press(Qt::Key_M, kCtrl);
    QCOMPARE(f.session.configuration().filter.particles, 25);
    // The window has the keyboard again; a choice, and the card of what it belongs to.
    in_dialog<ConfigurationDialog>([](ConfigurationDialog& dialog) {
        tab_to("field_filter.algorithm");
        press(Qt::Key_Down);
        press(Qt::Key_Return);
        QVERIFY(!dialog.isVisible());
    });
    press(Qt::Key_M, kCtrl);
    QCOMPARE(f.session.configuration().filter.algorithm, std::string("ekf-slam"));
}

void KeyboardTest::it_is_set_as_default() {
    KeyboardFixture f;
    answer_escape<QMessageBox>();
    choose_in_menu(Qt::Key_C, {"action_set_default"});
    QVERIFY(!f.files.has_init());
    answer_box();
    choose_in_menu(Qt::Key_C, {"action_set_default"});
    QVERIFY(f.files.has_init());
}

void KeyboardTest::it_runs() {
    KeyboardFixture f(200);
    press(Qt::Key_Right);
    QTRY_VERIFY(f.rests() && f.steps() == 1);
    press(Qt::Key_Space);
    QTRY_VERIFY(f.steps() > 3);
    press(Qt::Key_Space);
    QTRY_VERIFY(f.rests());
    tab_to("time_line");
    const quint64 there = f.steps();
    press(Qt::Key_Left);
    QTRY_VERIFY(f.rests() && f.steps() == there - 1);
    press(Qt::Key_Home);
    QTRY_VERIFY(f.rests() && f.steps() == 1);
    in_dialog<RunUntilDialog>([](RunUntilDialog& dialog) {
        tab_to("until_more");
        press(Qt::Key_Space);
        tab_to("value_more");
        type("7");
        press(Qt::Key_Return);
        QVERIFY(!dialog.isVisible());
    });
    press(Qt::Key_U, kCtrl);
    QTRY_VERIFY(f.rests() && f.steps() == 8);
    // At a pace, and as fast as possible.
    tab_to("pace");
    press(Qt::Key_Up);
    const auto* full = f.window->findChild<QAction*>("action_full_speed");
    QVERIFY(!full->isChecked());
    press(Qt::Key_Space, kCtrl);
    QVERIFY(full->isChecked());
    // By the buttons too.
    tab_to("button_step");
    press(Qt::Key_Space);
    QTRY_VERIFY(f.rests() && f.steps() == 9);
    press(Qt::Key_R, kCtrl);
    QTRY_COMPARE(f.state(), State::ready);
    QCOMPARE(f.steps(), 0U);
}

void KeyboardTest::maps_are_looked_at() {
    KeyboardFixture f(12);
    ResultActions& results = f.window->result_actions();
    press(Qt::Key_O);
    QTRY_VERIFY(results.odometry_window() && results.odometry_window()->isActiveWindow());
    tab_to("close");
    tab_to("view");
    press(Qt::Key_Plus);
    press(Qt::Key_Right);  // the run goes on from there as well
    QTRY_VERIFY(f.rests() && f.steps() == 1);
    press(Qt::Key_Escape);
    QTRY_VERIFY(results.odometry_window() == nullptr);
    QTRY_VERIFY(listener()->window() == f.window.get());
    press(Qt::Key_B);
    QTRY_VERIFY(results.best_window() && results.best_window()->isActiveWindow());
    press(Qt::Key_Escape);
    QTRY_VERIFY(results.best_window() == nullptr);
    in_dialog<QInputDialog>([](QInputDialog& dialog) {
        // There is no such one: told, and not taken for the 10 that the field has kept of it.
        type("1000");
        QVERIFY2(QToolTip::text().contains("0 to 11"), qPrintable(QToolTip::text()));
        press(Qt::Key_Return);
        QVERIFY(dialog.isVisible());
        type("7");  // in its place
        press(Qt::Key_Return);
        QVERIFY(!dialog.isVisible());
    });
    press(Qt::Key_P);
    QTRY_VERIFY(results.particle_window() && results.particle_window()->isActiveWindow());
    QVERIFY(results.particle_window()->windowTitle().contains('7'));
    press(Qt::Key_Escape);
}

void KeyboardTest::the_odometry_map_is_stopped() {
    KeyboardFixture f;
    press(Qt::Key_O);
    MapWindow* map = f.window->result_actions().odometry_window();
    QVERIFY(map != nullptr);
    QTRY_VERIFY(!map->view().tiles().empty());
    if (map->builder().state().running) {
        tab_to("stop");
        press(Qt::Key_Space);
    }
    QTRY_VERIFY(!map->builder().state().running);
}

void KeyboardTest::the_map_is_saved() {
    KeyboardFixture f;
    f.session.run_steps(30);
    QTRY_VERIFY(f.rests());
    answer_file(f.path("map.txt"));
    press(Qt::Key_S, kCtrlShift);
    QVERIFY(QFile::exists(f.path("map.txt")));
    QTRY_VERIFY2(f.notice().contains("map.txt"), qPrintable(f.notice()));
    answer_escape<QFileDialog>();
    press(Qt::Key_S, kCtrlShift);
    answer_file(f.path("figures.csv"));
    choose_in_menu(Qt::Key_F, {"action_save_figures"});
    QVERIFY(QFile::exists(f.path("figures.csv")));
}

void KeyboardTest::pictures_are_saved() {
    KeyboardFixture f;
    f.session.run_steps(30);
    QTRY_VERIFY(f.rests());
    const auto saved = [&f](const QString& name, const std::function<void()>& ask) {
        in_dialog<ExportDialog>([&](ExportDialog& /*dialog*/) { press(Qt::Key_Return); });
        answer_file(f.path(name));
        ask();
        expect_no_awaited_dialog();
        QVERIFY2(!QImage(f.path(name)).isNull(), qPrintable(name));
    };
    const auto by_key = [] { press(Qt::Key_P, kCtrl); };
    tab_to("scan_view");
    saved("scan.png", by_key);
    tab_to("grid_view");
    saved("grid.jpg", by_key);
    tab_to("grid_picture");
    saved("button.png", [] { press(Qt::Key_Space); });
    press(Qt::Key_C, kCtrl);
    QVERIFY(!QApplication::clipboard()->image().isNull());
    press(Qt::Key_B);
    MapWindow* map = f.window->result_actions().best_window();
    QTRY_VERIFY(map->isActiveWindow() && !map->builder().state().running);
    tab_to("picture");
    saved("best.png", [] { press(Qt::Key_Space); });
    press(Qt::Key_Escape);
    QTRY_VERIFY(listener()->window() == f.window.get());
    press(Qt::Key_G, kCtrl);
    tab_to("plots");
    const auto all = f.window->plots().times();
    press(Qt::Key_Plus);
    QVERIFY(f.window->plots().times().second - f.window->plots().times().first < all.second);
    press(Qt::Key_F);
    QCOMPARE(f.window->plots().times(), all);
    saved("plots.png", by_key);
    answer_escape<ExportDialog>();
    tab_to("scan_view");
    press(Qt::Key_P, kCtrl);
}

void KeyboardTest::a_study_is_done() {
    KeyboardFixture f;
    press(Qt::Key_E, kCtrl);
    StudyDialog& study = *f.window->study();
    QTRY_VERIFY(study.isActiveWindow());
    press(Qt::Key_P, Qt::AltModifier);
    type("split_merge.dmax");
    press(Qt::Key_V, Qt::AltModifier);
    type("wide");
    press(Qt::Key_R, Qt::AltModifier);
    type("1");
    press(Qt::Key_M, Qt::AltModifier);
    type(Fixture::source_file("data/maps/bigloop.map"));
    press(Qt::Key_F, Qt::AltModifier);
    type(f.path("study"));
    press(Qt::Key_Return);
    QVERIFY(!study.findChild<QLabel*>("error_values")->text().isEmpty());
    press(Qt::Key_V, Qt::AltModifier);
    press(Qt::Key_A, kCtrl);
    type("0.02, 0.05");
    press(Qt::Key_Return);
    QTRY_VERIFY2(verdict_by_key(study).startsWith("Runs done: 2 of 2"),
                 qPrintable(verdict_by_key(study)));
    QVERIFY(QFile::exists(f.path("study/quality.csv")));
    QTRY_COMPARE(focused(), QString("start"));
    tab_to("save");
    in_dialog<ExportDialog>([](ExportDialog& /*dialog*/) { press(Qt::Key_Return); });
    answer_file(f.path("study.png"));
    press(Qt::Key_Space);
    QVERIFY(!QImage(f.path("study.png")).isNull());
    press(Qt::Key_Escape);
    QTRY_VERIFY(listener()->window() == f.window.get());
}

void KeyboardTest::a_pair_of_values_is_used() {
    KeyboardFixture f;
    press(Qt::Key_E, kCtrl);
    StudyDialog& study = *f.window->study();
    QTRY_VERIFY(study.isActiveWindow());
    study.form().set_folder(f.path("study"));
    const auto fill = [](Qt::Key letter, const QString& text) {
        press(letter, Qt::AltModifier);
        press(Qt::Key_A, kCtrl);
        type(text);
    };
    fill(Qt::Key_P, "split_merge.dmax");
    fill(Qt::Key_V, "0.02, 0.05");
    fill(Qt::Key_D, "filter.particles");
    fill(Qt::Key_L, "3, 4, 6");
    fill(Qt::Key_R, "1");
    press(Qt::Key_Return);
    QTRY_VERIFY2(verdict_by_key(study).startsWith("Runs done: 6 of 6"),
                 qPrintable(verdict_by_key(study)));
    QTRY_COMPARE(focused(), QString("start"));
    tab_to("plots");
    press(Qt::Key_Right);  // the best
    for (int i = 0; i < 2; ++i) press(Qt::Key_Right);
    for (int i = 0; i < 3; ++i) press(Qt::Key_Up);
    press(Qt::Key_Return);
    QCOMPARE(f.session.configuration().filter.particles, 6);
    QTRY_VERIFY(listener()->window() == f.window.get());
    press(Qt::Key_Z, kCtrl);
    QCOMPARE(f.session.configuration().filter.particles, 10);
}

}  // namespace hitos::window
