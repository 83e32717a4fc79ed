// SPDX-License-Identifier: GPL-3.0-or-later
// Use case 8.2.2.1: selecting the data source.

#include <QAbstractItemModel>
#include <QCheckBox>
#include <QComboBox>
#include <QCompleter>
#include <QDialogButtonBox>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTimer>
#include <QTreeWidget>
#include <chrono>
#include <optional>
#include <string>
#include <thread>

#include "actions/command_line.hpp"
#include "dialogs/source_dialog.hpp"
#include "gui_fixture.hpp"
#include "hitos/base/error.hpp"
#include "hitos/capture/odometry_axes.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "look/parameter_text.hpp"
#include "session/background.hpp"
#include "tests.hpp"

namespace hitos::window {
namespace {

QPushButton* ok(const SourceDialog& dialog) {
    return dialog.findChild<QDialogButtonBox*>("buttons")->button(QDialogButtonBox::Ok);
}

QString verdict(const SourceDialog& dialog) {
    return dialog.findChild<QLabel*>("verdict")->text();
}

void wait_for_check(SourceDialog& dialog) {
    QTRY_VERIFY(!verdict(dialog).startsWith("Reading"));
}

}  // namespace

void SourceTest::a_log_is_chosen() {
    Fixture f(false);
    QVERIFY(!f.action("action_run")->isEnabled());
    f.prompts.opens = {Fixture::source_file("data/bigloop.log.gz")};
    in_dialog<SourceDialog>([](SourceDialog& dialog) {
        QVERIFY(!ok(dialog)->isEnabled());
        dialog.findChild<QPushButton*>("browse")->click();
        wait_for_check(dialog);
        QVERIFY2(verdict(dialog).contains("1050 scans"), qPrintable(verdict(dialog)));
        QVERIFY(verdict(dialog).contains("2102 odometry"));
        QVERIFY(dialog.findChild<QPlainTextEdit*>("lines")->toPlainText().startsWith("## Player"));
        ok(dialog)->click();
    });
    f.trigger("action_select_source");
    QVERIFY(f.session.has_source());
    QVERIFY(f.action("action_run")->isEnabled());
    QTRY_VERIFY2(f.notice().contains("1050"), qPrintable(f.notice()));
    QCOMPARE(f.files.recent().size(), 1);
    QTRY_VERIFY(f.window->findChild<QLabel*>("status_scan")->text().contains("1050"));
}

/// It counts when the file turns out good; another name is another matter.
void SourceTest::return_is_not_lost_while_a_file_is_read() {
    Fixture f(false);
    const QString log = Fixture::source_file("data/bigloop.log.gz");
    in_dialog<SourceDialog>([&log](SourceDialog& dialog) {
        auto* path = dialog.findChild<QLineEdit*>("path");
        dialog.set_path(log);
        QTest::keyClick(path, Qt::Key_Return);
        QVERIFY(!ok(dialog)->isEnabled());
        QTest::keyClicks(path, "x");
        wait_for_check(dialog);
        QVERIFY(dialog.isVisible());
        QTest::keyClick(path, Qt::Key_Backspace);
        wait_for_check(dialog);
        QVERIFY(dialog.isVisible());
        dialog.set_path("");
        dialog.set_path(log);
        QTest::keyClick(path, Qt::Key_Return);
        QVERIFY(dialog.isVisible());
        QTRY_VERIFY(!dialog.isVisible());
        QCOMPARE(dialog.result(), int(QDialog::Accepted));
    });
    f.trigger("action_select_source");
    QVERIFY(f.session.has_source());
}

void SourceTest::a_missing_file_is_told_in_the_form() {
    Fixture f;
    const std::string before = f.session.configuration().source.file;
    in_dialog<SourceDialog>([](SourceDialog& dialog) {
        wait_for_check(dialog);
        dialog.set_path("/nowhere/tour.log");
        wait_for_check(dialog);
        QVERIFY2(verdict(dialog).contains("/nowhere/tour.log"), qPrintable(verdict(dialog)));
        QVERIFY(!ok(dialog)->isEnabled());
        QVERIFY(dialog.isVisible());
        dialog.reject();
    });
    f.trigger("action_select_source");
    QCOMPARE(f.session.configuration().source.file, before);
}

void SourceTest::another_type_than_said_is_told_in_the_form() {
    Fixture f;
    in_dialog<SourceDialog>([](SourceDialog& dialog) {
        wait_for_check(dialog);
        dialog.findChild<QComboBox*>("type")->setCurrentIndex(
            dialog.findChild<QComboBox*>("type")->findData("carmen"));
        wait_for_check(dialog);
        QVERIFY(!ok(dialog)->isEnabled());
        QVERIFY2(verdict(dialog).contains("carmen"), qPrintable(verdict(dialog)));
        dialog.findChild<QComboBox*>("type")->setCurrentIndex(
            dialog.findChild<QComboBox*>("type")->findData("player"));
        wait_for_check(dialog);
        QVERIFY(ok(dialog)->isEnabled());
        ok(dialog)->click();
    });
    f.trigger("action_select_source");
    QCOMPARE(f.session.configuration().source.format, std::string("player"));
}

void SourceTest::a_file_that_is_no_log_is_told_in_the_form() {
    Fixture f(false);
    const QString path = f.write("letter.txt", "Dear reader,\nthis is no log.\n");
    in_dialog<SourceDialog>([path](SourceDialog& dialog) {
        dialog.set_path(path);
        wait_for_check(dialog);
        QVERIFY(!ok(dialog)->isEnabled());
        QVERIFY(verdict(dialog).contains("letter.txt"));
        dialog.reject();
    });
    f.trigger("action_select_source");
    QVERIFY(!f.session.has_source());
}

void SourceTest::damaged_lines_are_counted() {
    Fixture f(false);
    const QString path = f.write("small.txt",
                                 "ODOM 0 0 0\nLASER 0 2 1 0 1 1\nLASER broken\n"
                                 "ODOM 1 0.1 0\nLASER 1 2 1 0 1 1.1\n");
    in_dialog<SourceDialog>([path](SourceDialog& dialog) {
        dialog.set_path(path);
        wait_for_check(dialog);
        QVERIFY2(verdict(dialog).contains("line 3"), qPrintable(verdict(dialog)));
        QVERIFY(ok(dialog)->isEnabled());
        ok(dialog)->click();
    });
    f.trigger("action_select_source");
    QVERIFY(f.session.has_source());
    f.run_to_end();
    QVERIFY(f.window->findChild<QLabel*>("status_skipped")->text().contains('1'));
}

void SourceTest::why_no_scan_can_be_read_is_told() {
    Fixture f(false);
    SourceParams source;
    source.file =
        f.write("no-scan.txt", "ODOM 0 0 0\nLASER 0 2 1 broken 1 1\nODOM 1 0.1 0\n").toStdString();
    SourceDialog dialog(source, f.prompts, {}, nullptr);
    wait_for_check(dialog);
    QVERIFY(!ok(dialog)->isEnabled());
    QVERIFY2(verdict(dialog).contains("not one readable scan"), qPrintable(verdict(dialog)));
    QVERIFY2(verdict(dialog).contains("line 2") && verdict(dialog).contains("\"broken\""),
             qPrintable(verdict(dialog)));
}

void SourceTest::lists_are_read_as_the_country_writes_them_data() {
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("written");
    QTest::addColumn<QString>("read");
    QTest::addColumn<bool>("commas");
    const QString laser = "source.laser_pose";
    const QString place = "-0.2,0,180";
    for (const char* written :
         {"-0,2; 0; 180", "-0,2 0 180", "-0.2; 0; 180", "-0.2,0,180", "-0.2, 0, 180"})
        QTest::newRow(written) << laser << QString(written) << place << true;
    for (const char* written : {"-0.2; 0; 180", "-0.2 0 180", "-0.2,0,180"})
        QTest::addRow("with a point %s", written) << laser << QString(written) << place << false;
    QTest::newRow("as files have it") << laser << "0,0,180"
                                      << "0,0,180" << true;
    QTest::newRow("upside down") << laser << "0,1; 0; 90; upside-down"
                                 << "0.1,0,90,upside-down" << true;
    QTest::newRow("clock") << "source.scan_clock"
                           << "0@0; -1,39@680"
                           << "0@0,-1.39@680" << true;
    QTest::newRow("axes") << "source.odometry_axes"
                          << "x; y; 90,5-theta"
                          << "x,y,90.5-theta" << true;
}

void SourceTest::lists_are_read_as_the_country_writes_them() {
    QFETCH(const QString, key);
    QFETCH(const QString, written);
    QFETCH(const QString, read);
    QFETCH(const bool, commas);
    Fixture f;
    std::optional<DecimalCommas> country;
    if (commas) country.emplace();
    const auto& parameter = find_parameter(key.toStdString());
    const auto text_of = [&](const SourceDialog& dialog) {
        Configuracion configuration;
        configuration.source = dialog.source();
        return QString::fromStdString(parameter.text(configuration));
    };
    Configuracion before = f.session.configuration();
    SourceDialog dialog(before.source, f.prompts, {}, nullptr);
    wait_for_check(dialog);
    dialog.findChild<QCheckBox*>("how")->click();
    auto* field = dialog.findChild<QLineEdit*>("field_" + key);
    QTest::keyClicks(field, written);
    QTRY_COMPARE(text_of(dialog), read);
    wait_for_check(dialog);
    QVERIFY2(ok(dialog)->isEnabled(), qPrintable(verdict(dialog)));
    parameter.set(before, read.toStdString());  // what was kept is shown as it may be written
    SourceDialog again(before.source, f.prompts, {}, nullptr);
    QCOMPARE(text_of(again), read);
    QCOMPARE(again.findChild<QLineEdit*>("field_" + key)->text().contains("; "), commas);
}

void SourceTest::what_findings_advise_is_set_in_the_form() {
    Fixture f;
    in_dialog<SourceDialog>([](SourceDialog& dialog) {
        wait_for_check(dialog);
        auto* delay = dialog.findChild<QLineEdit*>("field_source.scan_delay");
        QVERIFY(!delay->isVisible());
        dialog.findChild<QCheckBox*>("how")->click();
        QVERIFY(delay->isVisible());
        delay->selectAll();
        QTest::keyClicks(delay, "late");
        QVERIFY(!ok(dialog)->isEnabled());
        QTRY_VERIFY(dialog.findChild<QLabel*>("error_source.scan_delay")->isVisible());
        QVERIFY(!ok(dialog)->isEnabled());
        delay->selectAll();
        QTest::keyClicks(delay, "-5");
        QVERIFY(!ok(dialog)->isEnabled());  // nobody has read it like that yet
        QTRY_VERIFY(verdict(dialog).contains("“Scan delay”"));
        QVERIFY(ok(dialog)->isEnabled());
        auto* remedy = dialog.findChild<QPushButton*>("remedy_source.scan_delay");
        QVERIFY(remedy != nullptr);
        remedy->click();
        QVERIFY2(std::abs(delay->text().toDouble()) < 0.2, qPrintable(delay->text()));
        QTRY_VERIFY(ok(dialog)->isEnabled());
        QVERIFY2(!verdict(dialog).contains("“Scan delay”"), qPrintable(verdict(dialog)));
        QTRY_VERIFY(dialog.findChild<QPushButton*>("remedy_source.scan_delay") == nullptr);
        ok(dialog)->click();
    });
    f.trigger("action_select_source");
    QVERIFY(std::abs(f.session.configuration().source.read.scan_delay_s) < 0.2);
}

void SourceTest::the_window_goes_on_while_a_source_is_opened() {
    QTimer clock;
    int ticks = 0;
    connect(&clock, &QTimer::timeout, &clock, [&ticks] { ++ticks; });
    clock.start(10);
    const auto slowly = [](bool good) {
        std::this_thread::sleep_for(std::chrono::milliseconds(400));
        if (!good) throw Error(verbatim("no"));
        return 7;
    };
    QCOMPARE(in_background([&] { return slowly(true); }), 7);
    QVERIFY2(ticks > 3, qPrintable(QString::number(ticks)));
    QVERIFY_THROWS_EXCEPTION(Error, in_background([&] { return slowly(false); }));
    QVERIFY(QGuiApplication::overrideCursor() == nullptr);
    // Meanwhile nothing else can be opened. A long tour of a world is driven first.
    Fixture f(false);
    Configuracion slow = f.session.configuration();
    slow.source.file = Fixture::source_file("data/worlds/campus.toml").toStdString();
    slow.source.world_set = "tour.laps=4";
    QString refused;
    connect(&clock, &QTimer::timeout, &clock, [&] {
        try {
            f.session.set_configuration(Configuracion());
        } catch (const Error& error) {
            refused = error.what();
        }
    });
    f.session.set_configuration(slow);
    clock.stop();
    QVERIFY2(refused.contains("another source is being opened"), qPrintable(refused));
    QVERIFY(f.session.has_source());
}

void SourceTest::findings_are_set_apart() {
    Fixture f;
    SourceParams source = f.session.configuration().source;
    source.read.scan_delay_s = -5.0;  // scans before the odometry, and clocks that differ
    SourceDialog dialog(source, f.prompts, {}, nullptr);
    wait_for_check(dialog);
    const QStringList lines = verdict(dialog).split('\n');
    QVERIFY2(lines.size() > 2, qPrintable(verdict(dialog)));
    for (const QString& note : lines.mid(1)) {
        QVERIFY2(note.startsWith(QString::fromUtf8("• ")), qPrintable(note));
        QVERIFY2(!note.at(2).isLower(), qPrintable(note));
    }
    QCOMPARE(dialog.findChild<QLabel*>("lines_label")->text(), "First lines");
}

void SourceTest::topics_of_another_recording_are_forgotten() {
    Fixture f;
    SourceParams source = f.session.configuration().source;
    source.read.scan_topic = "/front";
    source.read.odom_topic = "tf";
    source.read.scan_delay_s = -1.7;
    source.read.odometry_axes = "y,x,theta";
    source.read.odometry = OdometryFrom::velocities;
    SourceDialog dialog(source, f.prompts, {}, nullptr);
    QCOMPARE(dialog.source().read, source.read);
    QVERIFY(dialog.findChild<QCheckBox*>("how")->isChecked());
    dialog.set_path("/nowhere/tour.bag");
    QCOMPARE(dialog.source().read, ReadOptions());
    dialog.set_path(QString::fromStdString(source.file));
    QCOMPARE(dialog.source().read, source.read);
    wait_for_check(dialog);
}

void SourceTest::topics_are_listed_to_choose_from() {
    Fixture f(false);
    const QString path = Fixture::source_file("tests/unit/capture/two-lasers-cut.bag");
    in_dialog<SourceDialog>([path](SourceDialog& dialog) {
        dialog.set_path(path);
        wait_for_check(dialog);
        QVERIFY2(verdict(dialog).contains("several lasers"), qPrintable(verdict(dialog)));
        QCOMPARE(dialog.findChild<QLabel*>("verdict")->property("role").toString(), "warning");
        QVERIFY(!ok(dialog)->isEnabled());
        QCOMPARE(dialog.findChild<QLabel*>("lines_label")->text(), "Topics");
        auto* topic = dialog.findChild<QLineEdit*>("scan_topic");
        auto* list = dialog.findChild<QTreeWidget*>("topics");
        QVERIFY(list->isVisible() && !dialog.findChild<QWidget*>("lines")->isVisible());
        const auto row = [list](const QString& name) {
            return list->findItems(name, Qt::MatchExactly).front();
        };
        QTreeWidgetItem* front = row("/scan_front");
        QCOMPARE(front->text(2), "sensor_msgs/LaserScan");
        QCOMPARE(front->text(3), "9");
        QVERIFY(!front->text(4).isEmpty());  // its frame, which the transforms place
        QVERIFY(!list->findItems(front->text(4), Qt::MatchExactly | Qt::MatchRecursive).isEmpty());
        QCOMPARE(front->checkState(0), Qt::Unchecked);
        // A tick reads it at once; the other laser beside it, too.
        front->setCheckState(0, Qt::Checked);
        QCOMPARE(topic->text(), "/scan_front");
        wait_for_check(dialog);
        QVERIFY2(verdict(dialog).contains("9 scans"), qPrintable(verdict(dialog)));
        QCOMPARE(row("/scan_front")->checkState(0), Qt::Checked);
        row("/scan_rear")->setCheckState(0, Qt::Checked);
        QCOMPARE(topic->text(), "/scan_rear, /scan_front");  // as they are listed
        wait_for_check(dialog);
        QVERIFY(ok(dialog)->isEnabled());
        // One odometry gives way to another, and a topic that gives nothing has no box.
        row("/tf")->setCheckState(0, Qt::Checked);
        QCOMPARE(dialog.findChild<QLineEdit*>("odom_topic")->text(), "tf");
        wait_for_check(dialog);
        QCOMPARE(row("/odom")->checkState(0), Qt::Unchecked);
        const QAbstractItemModel& offered = *topic->completer()->model();
        QCOMPARE(offered.rowCount(), 3);
        topic->setText(offered.index(0, 0).data().toString());
        emit topic->editingFinished();
        wait_for_check(dialog);
        QVERIFY2(verdict(dialog).contains("9 scans"), qPrintable(verdict(dialog)));
        QVERIFY(ok(dialog)->isEnabled());
        topic->setText("/none");
        emit topic->editingFinished();
        wait_for_check(dialog);
        QVERIFY2(verdict(dialog).contains("found \"/none\""), qPrintable(verdict(dialog)));
        topic->setText("all");
        emit topic->editingFinished();
        wait_for_check(dialog);
        ok(dialog)->click();
    });
    f.trigger("action_select_source");
    QVERIFY(f.session.has_source());
    QCOMPARE(f.session.configuration().source.read.scan_topic, std::string("all"));
}

void SourceTest::topics_are_asked_for_wherever_it_is_opened_from() {
    const QString path = Fixture::source_file("tests/unit/capture/two-lasers-cut.bag");
    const auto choose = [path](SourceDialog& dialog) {
        wait_for_check(dialog);
        QCOMPARE(dialog.findChild<QLineEdit*>("path")->text(), path);
        QVERIFY2(verdict(dialog).contains("several lasers"), qPrintable(verdict(dialog)));
        auto* topic = dialog.findChild<QLineEdit*>("scan_topic");
        topic->setText("all");
        emit topic->editingFinished();
        wait_for_check(dialog);
        ok(dialog)->click();
    };
    Fixture f;  // topics of another recording are none of this one
    Configuracion before = f.session.configuration();
    before.source.read.scan_topic = "/front";
    f.session.set_configuration(before);
    in_dialog<SourceDialog>([](SourceDialog& dialog) { dialog.reject(); });
    QVERIFY(!f.window->configuration_actions().open(path));
    QVERIFY(f.session.configuration().source == before.source);
    in_dialog<SourceDialog>(choose);  // as a drop and the recent files do
    f.window->configuration_actions().open_all({path});
    QCOMPARE(f.session.configuration().source.read.scan_topic, std::string("all"));
    QCOMPARE(f.files.recent().front(), path);
    Fixture started(false);
    CommandLine line;
    line.open = path.toStdString();
    line.reference = Fixture::source_file("data/maps/bigloop.map").toStdString();
    in_dialog<SourceDialog>(choose);
    started.window->configuration_actions().start_or_warn(line);
    QTRY_VERIFY(started.session.has_source());
    QTRY_VERIFY(started.session.references().map);
    QVERIFY(started.prompts.warnings.isEmpty() && f.prompts.warnings.isEmpty());
}

void SourceTest::scans_before_the_odometry_are_counted() {
    Fixture f(false);
    SourceParams source;
    source.file = f.write("late.txt",
                          "LASER 0 2 1 0 1 1\nLASER 1 2 1 0 1 1.1\nODOM 2 0 0\n"
                          "LASER 3 2 1 0 1 1.2\nODOM 4 0.1 0\n")
                      .toStdString();
    SourceDialog kept(source, f.prompts, {}, nullptr);
    wait_for_check(kept);
    QVERIFY2(verdict(kept).contains("3 scans"), qPrintable(verdict(kept)));
    QVERIFY2(verdict(kept).contains("odometry reading: 2."), qPrintable(verdict(kept)));
    QVERIFY2(verdict(kept).contains("Scans before the odometry"), qPrintable(verdict(kept)));
    QCOMPARE(kept.findChild<QLabel*>("verdict")->property("role").toString(), "warning");
    source.read.leave_out_early_scans = true;
    SourceDialog left(source, f.prompts, {}, nullptr);
    wait_for_check(left);
    QVERIFY2(verdict(left).contains("1 scan,"), qPrintable(verdict(left)));
    QVERIFY2(verdict(left).contains("left out: 2."), qPrintable(verdict(left)));
}

void SourceTest::cancel_changes_nothing() {
    Fixture f;
    f.run_steps(5);
    in_dialog<SourceDialog>([](SourceDialog& dialog) {
        dialog.set_path(Fixture::source_file("data/maps/bigloop.map"));
        dialog.reject();
    });
    f.trigger("action_select_source");
    QCOMPARE(f.steps(), 5U);
    QVERIFY(f.session.configuration().source.file.ends_with("bigloop.log.gz"));
}

void SourceTest::the_source_changes_while_running() {
    Fixture f;
    f.session.set_pace(kUnhurried);
    f.trigger("action_run");
    QTRY_VERIFY(f.steps() > 3);
    const QString path = f.write("small.txt", "ODOM 0 0 0\nLASER 0 2 1 0 1 1\n");
    QVERIFY(f.window->configuration_actions().open(path));
    QCOMPARE(f.steps(), 0U);
    QVERIFY(!f.session.snapshot());
    QCOMPARE(f.state(), Progress::State::ready);
    QVERIFY(f.action("action_run")->isEnabled());
    f.run_to_end();
    QCOMPARE(f.steps(), 1U);
}

void SourceTest::a_bad_log_leaves_the_run_as_it_was() {
    Fixture f;
    f.run_steps(4);
    QVERIFY(!f.window->configuration_actions().open("/nowhere/tour.log"));
    QCOMPARE(f.prompts.warnings.size(), 1);
    QVERIFY(f.prompts.warnings.front().contains("/nowhere/tour.log"));
    QCOMPARE(f.steps(), 4U);
    QVERIFY(f.session.configuration().source.file.ends_with("bigloop.log.gz"));
}

void SourceTest::files_can_be_dropped() {
    Fixture f(false);
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(Fixture::source_file("data/bigloop.log.gz"))});
    QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(f.window.get(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(f.window.get(), &drop);
    QTRY_VERIFY(f.session.has_source());
}

void SourceTest::what_is_no_file_cannot_be_dropped() {
    Fixture f;
    f.run_steps(3);
    QMimeData data;
    data.setUrls({QUrl("https://example.org/tour.log")});
    QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(f.window.get(), &enter);
    QVERIFY(!enter.isAccepted());
    QDropEvent drop(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(f.window.get(), &drop);
    QTest::qWait(50);
    QVERIFY(!f.window->configuration_actions().open({}));
    QCOMPARE(f.steps(), 3U);
    QVERIFY(f.session.has_source() && f.prompts.warnings.isEmpty());
}

}  // namespace hitos::window
