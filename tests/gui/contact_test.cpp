// SPDX-License-Identifier: GPL-3.0-or-later
// First contact: what a new user meets first, and what must not be lost or hidden.

#include <QDialogButtonBox>
#include <QDropEvent>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QProcess>
#include <QPushButton>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "actions/command_line.hpp"
#include "app/hint_bar.hpp"
#include "app/language.hpp"
#include "dialogs/configuration_dialog.hpp"
#include "dialogs/source_dialog.hpp"
#include "dialogs/study_dialog.hpp"
#include "gui_fixture.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/workbench/presets.hpp"
#include "look/parameter_text.hpp"
#include "tests.hpp"
#include "workers/log_counter.hpp"

namespace hitos::window {
namespace {

constexpr const char* kDamaged =
    "ODOM 0 0 0\nLASER 0 2 1 0 1 1\nLASER broken\nODOM 1 0.1 0\nLASER 1 2 1 0 1 1.1\n";

QString verdict_of(const QDialog& dialog) {
    return dialog.findChild<QLabel*>("verdict")->text();
}

void drop(MainWindow& window, const QStringList& paths) {
    QMimeData data;
    QList<QUrl> urls;
    for (const QString& path : paths) urls << QUrl::fromLocalFile(path);
    data.setUrls(urls);
    QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &enter);
    QDropEvent event(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &event);
}

}  // namespace

void ContactTest::a_log_that_does_not_suit_is_told_with_one_button() {
    Fixture f;
    auto* hint = f.window->findChild<HintBar*>("hint");
    QVERIFY(hint->isHidden());
    const auto open = [&f] {
        QVERIFY(f.window->configuration_actions().open(
            Fixture::source_file("data/logs/carmen-flaser.log.gz")));
    };
    open();
    QVERIFY(hint->isVisible());
    QVERIFY(f.window->findChild<QLabel*>("hint_text")->text().contains("carmen"));
    f.window->findChild<QPushButton*>("hint_use")->click();
    QVERIFY(f.session.configuration().filter.motion.model == "registered");
    QVERIFY(f.session.configuration().source.file.ends_with("carmen-flaser.log.gz"));
    QVERIFY(hint->isHidden());
    QCOMPARE(f.prompts.confirmed_texts.size(), 0);  // nothing was lost
    // Closed it stays closed, until there is something new to say.
    f.session.set_configuration(Fixture::tour(10));
    open();
    f.window->findChild<QPushButton*>("hint_close")->click();
    QVERIFY(hint->isHidden());
}

void ContactTest::a_recording_that_looks_wrong_is_told_before_it_is_run() {
    Fixture f;
    auto* hint = f.window->findChild<HintBar*>("hint");
    auto* words = f.window->findChild<QLabel*>("hint_text");
    auto* state = f.window->findChild<QLabel*>("status_state");
    Configuracion wrong = Fixture::tour(5);
    wrong.source.read.scan_delay_s = 5.0;
    f.session.set_configuration(wrong);
    QTRY_VERIFY(hint->isVisible());
    QVERIFY2(words->text().contains("“Scan delay”") && words->text().contains("wrong"),
             qPrintable(words->text()));
    QVERIFY(f.window->findChild<QPushButton*>("hint_use")->isHidden());
    QVERIFY(state->text().contains(QString::fromUtf8("⚠")));
    QVERIFY2(state->toolTip().contains("“Scan delay”"), qPrintable(state->toolTip()));
    // What was read is not told again of the same recording.
    f.window->findChild<QPushButton*>("hint_close")->click();
    QVERIFY(hint->isHidden());
    wrong.filter.particles = 6;
    f.session.set_configuration(wrong);
    QVERIFY(hint->isHidden());
    // Mended, there is nothing to tell.
    f.session.set_configuration(Fixture::tour(5));
    QVERIFY(hint->isHidden());
    QVERIFY2(!state->toolTip().contains("“Scan delay”"), qPrintable(state->toolTip()));
}

void ContactTest::scans_that_cannot_be_counted_are_not_said_to_be_none() {
    Fixture f;
    const QString log = f.write("small.txt", "ODOM 0 0 0\nLASER 0 2 1 0 1 1\n");
    QVERIFY(f.window->configuration_actions().open(log));
    QFile::remove(log);
    LogCounter counter(f.session, nullptr);
    int counts = 0;
    QObject::connect(&counter, &LogCounter::counted, [&counts] { ++counts; });
    QTRY_VERIFY(!counter.busy());
    QCOMPARE(counts, 0);
}

void ContactTest::what_cannot_be_opened_is_told_as_what_it_is() {
    for (const char* named : {"/nonexistent.log", "nonexistent"}) {
        Fixture f(false);
        CommandLine line;
        line.open = named;
        f.window->configuration_actions().start_or_warn(line);
        QTRY_COMPARE(f.prompts.warnings.size(), 1);
        QCOMPARE(f.prompts.warning_titles.front(), QString("The log cannot be used"));
        QVERIFY2(f.prompts.warnings.front().startsWith(named),
                 qPrintable(f.prompts.warnings.front()));
        QVERIFY(!f.prompts.warnings.front().contains("no such world"));
    }
}

void ContactTest::doubts_about_both_references_stay() {
    Fixture f;
    f.run_to_end();
    References references;  // of a few scans, and a map of another place
    references.trajectory = f.session.snapshot()->odometry_trajectory;
    references.trajectory->resize(references.trajectory->size() / 3);
    references.map = f.session.snapshot()->best_map;
    for (ICaracteristica& landmark : *references.map) {
        if (auto* recta = std::get_if<Recta>(&landmark.value)) recta->rho += 40.0;
        if (auto* corner = std::get_if<Esquina>(&landmark.value)) corner->x += 40.0;
    }
    const auto* state = f.window->findChild<QLabel*>("status_state");
    const QString before = state->text();
    f.session.set_references(references);
    QTRY_VERIFY2(state->toolTip().contains("less than half of the scans") &&
                     state->toolTip().contains("is it of this place"),
                 qPrintable(state->toolTip()));
    QVERIFY(state->text().contains(QString::fromUtf8("⚠")));
    f.session.set_references({});
    QCOMPARE(state->text(), before);
}

void ContactTest::options_without_effect_are_told() {
    const std::string log = Fixture::source_file("data/logs/carmen-flaser.log.gz").toStdString();
    CommandLine scattered;
    scattered.open = log;
    scattered.values.tour_seed = 3;
    CommandLine of_topics;
    of_topics.open = log;
    of_topics.topics.odom_topic = "/odom";
    for (const CommandLine& line : {scattered, of_topics}) {
        Fixture f(false);
        f.window->configuration_actions().start_or_warn(line);
        QTRY_COMPARE(f.prompts.warnings.size(), 1);
        QCOMPARE(f.prompts.warning_titles.front(), QString("An option has no effect"));
        QVERIFY2(f.prompts.warnings.front().contains("leave it out"),
                 qPrintable(f.prompts.warnings.front()));
        QCOMPARE(f.session.configuration().source.file, log);  // and opened
        QVERIFY_THROWS_EXCEPTION(ConfigError, f.window->configuration_actions().start(line));
    }
}

void ContactTest::a_refused_file_shows_its_first_lines() {
    Fixture f(false);
    const QString letter = f.write("letter.log", "Dear reader,\nthis is no log.\n");
    QVERIFY(!f.window->configuration_actions().open(letter));
    QVERIFY2(f.prompts.warnings.front().contains("Dear reader,\nthis is"),
             qPrintable(f.prompts.warnings.front()));
    in_dialog<SourceDialog>([letter](SourceDialog& dialog) {
        dialog.set_path(letter);
        QTRY_VERIFY(!verdict_of(dialog).startsWith("Reading"));
        QVERIFY(dialog.findChild<QPlainTextEdit*>("lines")->toPlainText().contains("Dear reader,"));
        dialog.reject();
    });
    f.trigger("action_select_source");
}

void ContactTest::file_dialogs_open_where_there_are_files() {
    Fixture f;
    // The user's documents folder need not be there; a folder that was used last may have gone.
    const auto folder_of = [&](const QString& name) {
        return QFileInfo(f.files.place_to_save(name)).absolutePath();
    };
    const QString first = folder_of("a.png");
    QVERIFY(QFileInfo(first).isDir());
    f.files.note_saved("picture", f.path("gone/a.png"));
    QCOMPARE(folder_of("a.png"), first);
    // Where something was read nothing is saved unasked; where one thing was saved, the next is.
    f.files.note_opened("map", f.path("a.map"));
    QCOMPARE(folder_of("map.txt"), first);
    f.files.note_saved("picture", f.path("a.png"));
    QCOMPARE(folder_of("map.txt"), f.folder.path());
    QCOMPARE(QFileInfo(f.files.folder_to_open("config")).canonicalFilePath(),
             QFileInfo(Fixture::source_file("config")).canonicalFilePath());
    f.files.note_opened("config", f.path("a.cfg"));
    QCOMPARE(f.files.folder_to_open("config"), f.folder.path());
    // And what comes with Hitos is one click away, once, and in no other program.
    const auto shipped = [](const QFileDialog& dialog) {
        const QList<QUrl> places = dialog.sidebarUrls();
        return std::ranges::count(places, QUrl::fromLocalFile(shipped_folder("config")));
    };
    { QFileDialog().setSidebarUrls({}); }  // as others may have left it
    for (int time = 0; time < 2; ++time) {
        in_dialog<QFileDialog>([&](QFileDialog& dialog) {
            QCOMPARE(shipped(dialog), 1);
            dialog.setSidebarUrls(dialog.sidebarUrls() << QUrl::fromLocalFile(f.folder.path()));
            dialog.reject();
        });
        QtPrompts prompts;
        const Prompts::FileQuestion question{"Open", f.folder.path(), "All files (*)", {}};
        QVERIFY(prompts.open_file(nullptr, question).isEmpty());
        QCOMPARE(shipped(QFileDialog()), 0);
        QCOMPARE(QFileDialog().sidebarUrls().count(QUrl::fromLocalFile(f.folder.path())), 1);
    }
}

void ContactTest::skipped_lines_are_listed() {
    Fixture f(false);
    QVERIFY(f.window->configuration_actions().open(f.write("small.txt", kDamaged)));
    f.run_to_end();
    auto* label = f.window->findChild<QLabel*>("status_skipped");
    QTRY_VERIFY(label->isVisible());
    emit label->linkActivated("skipped");
    QTRY_VERIFY(f.window->findChild<QDialog*>("skipped_lines") != nullptr);
    auto* list = f.window->findChild<QDialog*>("skipped_lines");
    const QString text = list->findChild<QPlainTextEdit*>()->toPlainText();
    QVERIFY2(text.startsWith("line 3: "), qPrintable(text));
    list->close();
}

void ContactTest::a_damaged_log_is_not_told_in_green() {
    Fixture f(false);
    const QByteArray whole = Fixture::read(Fixture::source_file("data/bigloop.log.gz"));
    const QString cut = f.write("cut.log.gz", whole.first(whole.size() / 2));
    in_dialog<SourceDialog>([cut](SourceDialog& dialog) {
        auto* verdict = dialog.findChild<QLabel*>("verdict");
        dialog.set_path(Fixture::source_file("data/bigloop.log.gz"));
        QTRY_VERIFY(verdict->text().contains("1050 scans"));
        QCOMPARE(verdict->property("role").toString(), QString("good"));
        dialog.set_path(cut);
        QTRY_VERIFY(verdict->text().contains("scans") && !verdict->text().contains("1050"));
        QCOMPARE(verdict->property("role").toString(), QString("warning"));
        dialog.reject();
    });
    f.trigger("action_select_source");
}

void ContactTest::no_message_hides_the_state() {
    Fixture f;
    f.session.set_pace(kUnhurried);
    f.trigger("action_run");
    auto* state = f.window->findChild<QLabel*>("status_state");
    QTRY_COMPARE(state->text(), QString("Running"));
    f.window->statusBar()->showMessage("Source loaded: tour.log, 1050 scans");
    QVERIFY(state->isVisible());
    QCOMPARE(f.window->statusBar()->toolTip(), f.notice());  // whole, however narrow the window
}

void ContactTest::map_windows_lie_beside_each_other() {
    Fixture f;
    f.run_steps(60);
    f.trigger("action_best_map");
    f.trigger("action_odometry");
    ResultActions& results = f.window->result_actions();
    MapWindow* best = results.best_window();
    MapWindow* odometry = results.odometry_window();
    QVERIFY(best->pos() != odometry->pos());
    QVERIFY2(best->windowTitle().contains("bigloop.log.gz"), qPrintable(best->windowTitle()));
    QTRY_VERIFY(!best->builder().state().running && !odometry->builder().state().running);
    // Landmarks, with the layers of the other views.
    const QImage with = best->view().grab().toImage();
    f.trigger("layer_landmarks");
    QVERIFY(best->view().grab().toImage() != with);
    QCOMPARE(best->findChild<QPushButton*>("layers")->menu(),
             f.window->findChild<QMenu*>("menu_layers"));
    QMouseEvent move(QEvent::MouseMove, QPointF(100, 100),
                     best->view().mapToGlobal(QPointF(100, 100)), Qt::NoButton, {}, {});
    QApplication::sendEvent(&best->view(), &move);
    QVERIFY(best->findChild<QLabel*>("place")->text().startsWith("x "));
    // The keys of the run.
    best->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(best));
    const QRect place = odometry->geometry();
    QPointer<MapWindow> old = odometry;
    QTest::keyClick(&best->view(), Qt::Key_O);
    QTRY_VERIFY(!old && results.odometry_window() != nullptr);
    QCOMPARE(results.odometry_window()->geometry(), place);
}

void ContactTest::after_the_form_the_window_has_the_keyboard() {
    Fixture f;
    in_dialog<ConfigurationDialog>([](ConfigurationDialog& dialog) {
        dialog.findChild<QLineEdit*>("field_filter.particles")->setText("25");
        dialog.findChild<QDialogButtonBox*>("buttons")->button(QDialogButtonBox::Ok)->click();
    });
    f.trigger("action_manual");
    QCOMPARE(f.session.configuration().filter.particles, 25);
    QTRY_COMPARE(QApplication::activeWindow(), static_cast<QWidget*>(f.window.get()));
    QVERIFY(QApplication::focusWidget() != nullptr);
}

void ContactTest::a_long_run_is_not_discarded_without_a_question() {
    Fixture f;
    f.run_steps(20);
    const auto asked = [&f] { return f.prompts.confirmed_texts.size(); };
    f.window->run_guard().set_long_run(0.0);  // any run is long
    f.trigger("action_restart");              // declined
    QCOMPARE(asked(), 1);
    // What comes with the log is about it: it does not go to the run that stays.
    f.window->configuration_actions().open_all(
        {Fixture::source_file("data/logs/carmen-flaser.log.gz"),
         Fixture::source_file("data/maps/bigloop.map")});
    QCOMPARE(asked(), 2);
    QVERIFY(!f.session.user_references().map);
    QVERIFY(!f.window->close());
    QCOMPARE(asked(), 3);
    QCOMPARE(f.steps(), 20U);
    QVERIFY(f.session.configuration().source.file.ends_with("bigloop.log.gz"));
    f.prompts.confirms = {true};
    f.trigger("action_restart");
    QTRY_COMPARE(f.steps(), 0U);
    f.trigger("action_odometry");
    QVERIFY(f.window->close());  // nothing to lose
    QCOMPARE(asked(), 4);
}

void ContactTest::a_short_run_is_discarded_at_once() {
    Fixture f;
    f.run_steps(20);
    f.trigger("action_restart");
    QTRY_COMPARE(f.steps(), 0U);
    QCOMPARE(f.prompts.confirmed_texts.size(), 0);
}

void ContactTest::the_studys_paths_are_wide() {
    Fixture f;
    StudyDialog& study = f.window->open_study();
    for (const char* name : {"reference", "folder"}) {
        auto* line = study.findChild<QLineEdit*>(name);
        const int needed =
            line->fontMetrics().horizontalAdvance("/home/somebody/Documents/hitos-study");
        QVERIFY2(line->width() > needed, qPrintable(QString::number(line->width())));
    }
}

void ContactTest::several_files_can_be_dropped_at_once() {
    Fixture f(false);
    QByteArray path;  // of the whole tour, or it would be refused
    for (int i = 0; i < 4000; ++i) path += QByteArray::number(i / 4.0) + " 0 0 0 0 0 0 1\n";
    f.prompts.confirms = {true};
    drop(*f.window, {f.write("path.tum", path), Fixture::source_file("data/maps/bigloop.map"),
                     Fixture::source_file("data/bigloop.log.gz"),
                     f.write("seven.cfg", "[filter]\nparticles = 7\n")});
    QTRY_VERIFY2(f.session.user_references().trajectory.has_value(),
                 qPrintable(f.prompts.warnings.join(' ')));
    QVERIFY(f.session.has_source());
    QCOMPARE(f.session.configuration().filter.particles, 7);
    QCOMPARE(f.session.references().map->size(), 16U);
    QCOMPARE(f.files.recent().size(), 4);
    QCOMPARE(f.prompts.warnings.size(), 1);  // of a path that stands still
    QVERIFY2(f.prompts.warnings.front().contains("reference trajectory"),
             qPrintable(f.prompts.warnings.front()));
    f.prompts.confirms = {true};
    drop(*f.window, {Fixture::source_file("data/worlds/corridor.toml")});
    QTRY_VERIFY(f.session.configuration().source.file.ends_with("corridor.toml"));
    // A text is what it reads as.
    QCOMPARE(
        kind_of(f.write("a.txt", Fixture::read(Fixture::source_file("data/maps/bigloop.map")))),
        FileKind::map);
    QCOMPARE(kind_of(f.write("b.txt", kDamaged)), FileKind::source);
}

void ContactTest::the_configuration_can_be_undone_and_redone() {
    Fixture f;
    const auto particles = [&f] { return f.session.configuration().filter.particles; };
    QVERIFY(!f.action("action_undo")->isEnabled());
    f.session.set_configuration(Fixture::tour(20));
    QVERIFY(f.window->configuration_actions().open(
        Fixture::source_file("data/logs/carmen-flaser.log.gz")));
    QVERIFY2(f.action("action_undo")->text().startsWith("Undo, back to: bigloop.log.gz"),
             qPrintable(f.action("action_undo")->text()));
    f.trigger("action_undo");
    QVERIFY(f.session.configuration().source.file.ends_with("bigloop.log.gz"));
    QVERIFY2(f.notice().startsWith("Undone, now: bigloop.log.gz"), qPrintable(f.notice()));
    QCOMPARE(f.action("action_undo")->text(), QString("Undo, back to: Particles 10"));
    f.trigger("action_undo");
    QCOMPARE(particles(), 10);
    QCOMPARE(f.notice(), QString("Undone, now: Particles 10"));
    QVERIFY(!f.action("action_undo")->isEnabled());
    QCOMPARE(f.action("action_undo")->text(), QString("Undo"));
    f.trigger("action_redo");
    QCOMPARE(particles(), 20);
    QCOMPARE(f.notice(), QString("Redone, now: Particles 20"));
    // A preset changes much; what no run makes use of changes nothing that one would see.
    f.window->configuration_actions().use_preset("recorded", true);
    f.trigger("action_undo");
    QVERIFY2(
        QRegularExpression("^Undone, now: .*, .*, .* and \\d+ more$").match(f.notice()).hasMatch(),
        qPrintable(f.notice()));
    Configuracion threads = Fixture::tour(20);
    threads.run.threads = 3;
    f.session.set_configuration(threads);
    f.trigger("action_undo");
    QVERIFY2(f.notice().startsWith("Undone, now: Threads "), qPrintable(f.notice()));
    Configuracion unused = Fixture::tour(20);
    unused.filter.association.gate_probability = 0.9;  // of other methods than this one's
    f.session.set_configuration(unused);
    f.trigger("action_undo");
    QCOMPARE(f.notice(), QString("Undone, now: nothing that this run makes use of"));
    // The same values once more are no change.
    const QString before = f.action("action_undo")->text();
    f.session.set_configuration(f.session.configuration());
    QCOMPARE(f.action("action_undo")->text(), before);
    // References belong to a log: what goes with another is told, forwards and back.
    References references;
    references.map = LandmarkMap{};
    f.session.set_references(references);
    QVERIFY(f.window->configuration_actions().open(
        Fixture::source_file("data/logs/carmen-flaser.log.gz")));
    QVERIFY2(f.notice().contains("references"), qPrintable(f.notice()));
    f.session.set_references(references);
    f.trigger("action_undo");
    QVERIFY2(f.notice().contains("references"), qPrintable(f.notice()));
    // Of two logs of one name the folder tells which.
    QDir(f.folder.path()).mkpath("b");
    QVERIFY(QFile::copy(Fixture::source_file("data/bigloop.log.gz"), f.path("b/bigloop.log.gz")));
    QVERIFY(f.window->configuration_actions().open(f.path("b/bigloop.log.gz")));
    f.trigger("action_undo");
    QVERIFY2(f.notice().startsWith("Undone, now: data/bigloop.log.gz"), qPrintable(f.notice()));
    f.session.set_configuration(Fixture::tour(30));
    QVERIFY(!f.action("action_redo")->isEnabled());  // another way was taken
    f.trigger("action_undo");
    QCOMPARE(particles(), 20);
}

void ContactTest::the_source_decides_the_parameters_until_the_user_does() {
    Fixture f(false);
    ConfigurationActions& actions = f.window->configuration_actions();
    actions.start_or_warn({});  // the ready tour, with the thesis's preset
    const auto is = [&f](Configuracion wanted) {
        const SourceParams brought = wanted.source;
        wanted.source = f.session.configuration().source;
        wanted.source.world_set = brought.world_set;
        wanted.source.read.odometry = brought.read.odometry;
        wanted.run = f.session.configuration().run;
        return ArchivoConfiguracion::to_text(wanted) ==
               ArchivoConfiguracion::to_text(f.session.configuration());
    };
    const auto open = [&](const QString& source) { QVERIFY(actions.open(source)); };
    const QString robots = Fixture::source_file("data/logs/carmen-flaser.log.gz");
    QVERIFY(is(preset_configuration("thesis")));
    open(robots);
    QVERIFY(is(preset_configuration("recorded")));
    QVERIFY2(f.notice().contains("Recorded tours, because a robot"), qPrintable(f.notice()));
    QVERIFY(f.window->findChild<HintBar*>("hint")->isHidden());
    f.trigger("action_undo");
    QVERIFY(is(preset_configuration("thesis")));
    f.trigger("action_redo");
    open(Fixture::source_file("data/worlds/recinto.toml"));
    QVERIFY(is(preset_configuration("simulated")));
    QVERIFY2(f.notice().contains("Simulated tours, because"), qPrintable(f.notice()));
    open(Fixture::source_file("data/logs/player-laser.log.gz"));
    QVERIFY(is({}));
    QVERIFY2(f.notice().contains("the defaults"), qPrintable(f.notice()));
    // Seeds and threads are no choice of parameters, and stay.
    Configuracion own = f.session.configuration();
    own.run.seed = 7;
    f.session.set_configuration(own);
    open(robots);
    QVERIFY(is(preset_configuration("recorded")));
    QCOMPARE(f.session.configuration().run.seed, std::uint64_t{7});
    // What the user has chosen stays.
    own.filter.particles = 20;
    f.session.set_configuration(own);
    open(robots);
    QVERIFY(is(own));
    QVERIFY2(!f.notice().contains("because"), qPrintable(f.notice()));
    QVERIFY(f.window->findChild<HintBar*>("hint")->isVisible());
    own = {};
    own.source.file = Fixture::source_file("data/worlds/recinto.toml").toStdString();
    own.source.world_set = "laser.sigma=0.02";
    f.session.set_configuration(own);
    open(robots);
    QVERIFY(is(own));
}

void ContactTest::a_preset_takes_its_odometry_along_and_leaves_the_users() {
    Fixture f(false);
    ConfigurationActions& actions = f.window->configuration_actions();
    const auto odometry = [&f] { return f.session.configuration().source.read.odometry; };
    actions.start_or_warn({});  // the ready tour, with the thesis's preset
    QCOMPARE(odometry(), OdometryFrom::velocities);
    QVERIFY(actions.open(QString::fromStdString(f.session.configuration().source.file)));
    QCOMPARE(odometry(), OdometryFrom::velocities);  // the same log again
    f.prompts.confirms = {true, true, true};
    actions.use_preset("recorded");
    QCOMPARE(odometry(), OdometryFrom::poses);
    actions.use_preset("thesis");
    QCOMPARE(odometry(), OdometryFrom::velocities);
    Configuracion own = f.session.configuration();
    own.source.read.odometry = OdometryFrom::scans;
    f.session.set_configuration(own);
    actions.use_preset("recorded");
    QCOMPARE(odometry(), OdometryFrom::scans);
}

void ContactTest::who_chose_is_remembered_and_not_guessed() {
    const QString robots = Fixture::source_file("data/logs/carmen-flaser.log.gz");
    const QString world = Fixture::source_file("data/worlds/corridor.toml");
    Fixture f(false);
    ConfigurationActions& actions = f.window->configuration_actions();
    const auto registered = [&f] {
        return f.session.configuration().filter.motion.model == "registered";
    };
    // The preset that Hitos would take, taken by the user: it stays.
    actions.start_or_warn({});
    f.prompts.confirms = {true};
    actions.use_preset("recorded");
    QVERIFY(actions.open(world));
    QVERIFY(registered());
    CommandLine line;
    line.open = robots.toStdString();
    line.preset = "recorded";
    actions.start_or_warn(line);
    QVERIFY(actions.open(world));
    QVERIFY(registered());
    // A world chosen in the form has no values that a preset brought for another one.
    actions.start_or_warn({});
    QVERIFY(!f.session.configuration().source.world_set.empty());
    in_dialog<SourceDialog>([world](SourceDialog& dialog) {
        dialog.set_path(world);
        auto* ok = dialog.findChild<QDialogButtonBox*>("buttons")->button(QDialogButtonBox::Ok);
        QTRY_VERIFY(ok->isEnabled());
        ok->click();
    });
    actions.select_source();
    QCOMPARE(f.session.configuration().source.world_set, std::string());
    QVERIFY(actions.open(robots));
    QVERIFY(registered());
    // A log whose name is no UTF-8 is as good as any other.
    const std::string odd = f.path("t").toStdString() + "\xe4st.log.gz";
    std::filesystem::copy_file(robots.toStdString(), odd);
    line = {};
    line.open = odd;
    actions.start_or_warn(line);
    QVERIFY(registered());
    QVERIFY(actions.open(world));
    QVERIFY(!registered());
}

void ContactTest::what_init_cfg_says_stays_whatever_the_source_is() {
    Fixture f(false);
    f.write("user/init.cfg", "");  // as good as the defaults, but chosen
    ConfigurationActions& actions = f.window->configuration_actions();
    actions.start_or_warn({});
    const QString robots = Fixture::source_file("data/logs/carmen-flaser.log.gz");
    QVERIFY(actions.open(robots));
    QVERIFY(f.session.configuration().filter.motion.model != "registered");
    QVERIFY(f.window->findChild<HintBar*>("hint")->isVisible());
    CommandLine line;
    line.open = robots.toStdString();
    QVERIFY(starting_configuration(line, f.files).filter.motion.model != "registered");
    line.preset = "auto";
    QVERIFY(starting_configuration(line, f.files).filter.motion.model == "registered");
    line.preset.clear();
    line.config = f.path("user/init.cfg").toStdString();
    QVERIFY(starting_configuration(line, f.files).filter.motion.model != "registered");
}

void ContactTest::what_the_source_decides_at_the_start_is_told() {
    Fixture f(false);
    CommandLine line;
    line.open = Fixture::source_file("data/logs/carmen-flaser.log.gz").toStdString();
    line.values.assignments = {"filter.particles=5"};
    f.window->configuration_actions().start_or_warn(line);
    QVERIFY(f.session.configuration().filter.motion.model == "registered");
    QCOMPARE(f.session.configuration().filter.particles, 5);
    QVERIFY2(f.notice().contains("because a robot"), qPrintable(f.notice()));
    // Another source that is chosen in the form decides anew.
    line.values.assignments.clear();
    f.window->configuration_actions().start_or_warn(line);
    in_dialog<SourceDialog>([](SourceDialog& dialog) {
        dialog.set_path(Fixture::source_file("data/logs/player-laser.log.gz"));
        auto* ok = dialog.findChild<QDialogButtonBox*>("buttons")->button(QDialogButtonBox::Ok);
        QTRY_VERIFY(!verdict_of(dialog).startsWith("Reading"));
        ok->click();
    });
    f.window->configuration_actions().select_source();
    QVERIFY(f.session.configuration().source.file.ends_with("player-laser.log.gz"));
    QVERIFY(f.session.configuration().filter.motion.model != "registered");
}

void ContactTest::a_preset_of_the_users_own_is_in_the_menu() {
    Fixture f;
    f.prompts.saves = {f.files.presets_folder() + "/mine.cfg"};
    f.trigger("action_save_preset");
    f.session.set_configuration(Fixture::tour(20));
    auto* menu = f.window->findChild<QMenu*>("menu_presets");
    emit menu->aboutToShow();
    QAction* mine = nullptr;
    for (QAction* action : menu->actions()) {
        if (action->text() == "mine") mine = action;
    }
    QVERIFY(mine != nullptr);
    f.prompts.confirms = {true};
    mine->trigger();
    QCOMPARE(f.session.configuration().filter.particles, 10);
}

void ContactTest::a_first_start_opens_the_noisy_tour() {
    Fixture f(false);
    f.window->configuration_actions().start_or_warn({});
    QVERIFY(f.session.configuration().source.file.ends_with("bigloop-noisy.log.gz"));
    QCOMPARE(f.session.references().map->size(), 16U);
    f.run_to_end();
    // The odometry drifts, and the run mends it: a first look shows what SLAM is for.
    const auto snapshot = f.session.snapshot();
    const auto error = map_error(snapshot->best_map, *f.session.references().map);
    QVERIFY2(error && error->mean_m < 0.1, qPrintable(QString::number(error->mean_m)));
    const Pose& by_odometry = snapshot->odometry_trajectory.back().pose;
    const Pose& best = snapshot->best_pose;
    QVERIFY(std::hypot(by_odometry.x - best.x, by_odometry.y - best.y) > 0.3);
}

void ContactTest::a_first_start_offers_three_ways() {
    {
        Fixture f(false);
        f.window->configuration_actions().start_or_warn({});
        QVERIFY(!f.window->findChild<QWidget*>("start")->isVisible());
        f.window->offer_start();
        auto* start = f.window->findChild<QWidget*>("start");
        QVERIFY(start->isVisible());
        QVERIFY(f.window->findChild<QPushButton*>("start_open") != nullptr &&
                f.window->findChild<QPushButton*>("start_draw") != nullptr);
        f.window->findChild<QPushButton*>("start_run")->click();
        QVERIFY(!start->isVisible());
        QTRY_VERIFY(f.state() == Progress::State::finished);
    }
    {
        Fixture f(false);
        f.window->configuration_actions().start_or_warn({});
        f.window->offer_start();
        f.session.run_steps(1);  // by whatever way
        QTRY_VERIFY(!f.window->findChild<QWidget*>("start")->isVisible());
    }
    Fixture f(false);  // who has been here before needs no help
    QVERIFY(f.window->configuration_actions().open(Fixture::source_file("data/bigloop.log.gz")));
    f.window->offer_start();
    QVERIFY(!f.window->findChild<QWidget*>("start")->isVisible());
}

void ContactTest::the_language_is_chosen_in_the_menu() {
    Fixture f;
    f.trigger("language_es");
    QCOMPARE(saved_language(f.files), QString("es"));
    QTRY_VERIFY(!f.notice().isEmpty());
    f.trigger("language_");
    QVERIFY(saved_language(f.files).isEmpty());
}

void ContactTest::limits_of_whole_numbers_are_whole() {
    for (const ConfigParameter& parameter : parameters()) {
        if (parameter.type != ConfigParameter::Type::integer) continue;
        QVERIFY2(!allowed_of(parameter).contains("e+"), qPrintable(allowed_of(parameter)));
    }
}

void ContactTest::what_the_command_line_opens_is_recent() {
    Fixture f(false);
    CommandLine line;
    line.open = Fixture::source_file("data/bigloop.log.gz").toStdString();
    line.config = Fixture::source_file("config/thesis.cfg").toStdString();
    f.window->configuration_actions().start_or_warn(line);
    QCOMPARE(f.files.recent().size(), 2);
    QVERIFY(f.files.recent().front().endsWith("bigloop.log.gz"));
}

}  // namespace hitos::window
