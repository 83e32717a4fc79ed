// SPDX-License-Identifier: GPL-3.0-or-later
// Tours that come in while the window maps them.

#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QProcess>
#include <QProcessEnvironment>
#include <QPushButton>
#include <QTreeWidget>

#include "app/opening.hpp"
#include "dialogs/connect_dialog.hpp"
#include "gui_fixture.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/workbench/open_tour.hpp"
#include "session/incoming_tour.hpp"
#include "tests.hpp"
#include "unit/capture/ros_tours.hpp"
#include "workers/first_look.hpp"

namespace hitos::window {
namespace {

/// A window beside a file that grows as the test says.
struct ConnectFixture : Fixture {
    ConnectFixture() : Fixture(false) {}

    ConnectDialog& dialog() { return window->open_connection(); }
    QString state_words() { return dialog().findChild<QLabel*>("connect_state")->text(); }
    QPushButton* act() { return dialog().findChild<QPushButton*>("connect_act"); }
    void connect_to(const QString& address) {
        QCOMPARE(act()->text(), QString("Connect"));
        dialog().findChild<QLineEdit*>("connect_address")->setText(address);
        act()->click();
    }
    void append(const QByteArray& bytes) const {
        QFile file(path("tour.log"));
        QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Append));
        QCOMPARE(file.write(bytes), bytes.size());
    }
    /// On the first part of the ready tour, which is mapped as far as it goes.
    void begin() {
        QProcess unpack;
        unpack.start("gzip", {"-dc", source_file("data/bigloop.log.gz")});
        QVERIFY(unpack.waitForFinished(kPatienceMs));
        tour = unpack.readAllStandardOutput();
        scans_end = tour.indexOf('\n', tour.size() / 3) + 1;
        write("tour.log", tour.left(scans_end));
        connect_to(path("tour.log"));
        QTRY_VERIFY(session.is_live() && caught_up());
    }
    void rest_comes() const { append(tour.mid(scans_end)); }
    bool caught_up() {
        return session.incoming_tour() && steps() > 0 &&
               steps() == session.incoming_tour()->scans() && shows_everything();
    }

    QByteArray tour;
    qsizetype scans_end = 0;
};

/// What a run of the same file, read from disk, comes to.
std::shared_ptr<const Snapshot> again(const Configuracion& configuration) {
    RunWorker run(configuration, open_tour(configuration));
    run.run();
    run.wait();
    run.request_snapshot();
    run.wait();
    return run.latest_snapshot();
}

QByteArray scan_line(int scan) {
    const QByteArray number = QByteArray::number(scan);
    return "LASER " + number + " 3 1 0 1 1 0.5 1." + number + '\n';
}

void same_maps(const Snapshot& a, const Snapshot& b) {
    QVERIFY(a.best_trajectory == b.best_trajectory);
    QCOMPARE(a.best_map.size(), b.best_map.size());
    for (std::size_t i = 0; i < a.best_map.size(); ++i) {
        QVERIFY(a.best_map[i].point() == b.best_map[i].point());
        QVERIFY(a.best_map[i].covariance == b.best_map[i].covariance);
    }
}

}  // namespace

void ConnectTest::a_log_that_is_being_written_is_mapped_as_it_comes() {
    ConnectFixture f;
    f.begin();
    QVERIFY(!f.window->open_connection().isHidden());  // which shows it again
    const quint64 first = f.steps();
    QVERIFY(first > 100 && first < 1050);
    QTRY_VERIFY2(f.state_words().contains("grows") || f.state_words().contains("No scan"),
                 qPrintable(f.state_words()));
    auto* said = f.window->findChild<QLabel*>("status_state");
    QTRY_VERIFY2(said->text().startsWith("Live"), qPrintable(said->text()));
    QVERIFY(!f.action("action_study")->isEnabled());
    QVERIFY(f.action("action_stop")->isEnabled());
    f.rest_comes();
    QTRY_COMPARE(f.steps(), 1050U);
    QVERIFY(f.session.is_live());
    QCOMPARE(f.act()->text(), QString("Disconnect"));
    f.act()->click();
    QTRY_VERIFY(f.state() == Progress::State::finished && f.shows_everything());
    QVERIFY(!f.session.is_live());
    QVERIFY2(f.state_words().contains("tour.log"), qPrintable(f.state_words()));
    QTRY_VERIFY(f.window->findChild<QLabel*>("status_scan")->text().contains("1050 of 1050"));
    QVERIFY(f.action("action_study")->isEnabled());
    QVERIFY(f.session.configuration().source.read.opening_bytes > 0);
    const auto live = f.session.snapshot();
    same_maps(*live, *again(f.session.configuration()));
    QVERIFY(f.prompts.warnings.isEmpty());
}

void ConnectTest::the_run_may_stand_still_or_go_back_meanwhile() {
    ConnectFixture f;
    f.begin();
    const quint64 first = f.steps();
    f.trigger("action_stop");
    QTRY_COMPARE(f.state(), Progress::State::paused);
    f.rest_comes();
    QTRY_COMPARE(f.session.incoming_tour()->scans(), 1050U);
    QCOMPARE(f.steps(), first);
    f.session.seek(5);
    QTRY_VERIFY(f.steps() == 5 && f.shows_everything());
    f.session.seek(5000);  // no further than what is there
    QTRY_VERIFY(f.steps() == 1050 && f.shows_everything());
    const std::shared_ptr<const Snapshot> last = f.session.snapshot();
    f.trigger("action_restart");
    QTRY_COMPARE(f.steps(), 0U);
    // What is known of the tour is still seen, and nothing of the run.
    const std::shared_ptr<const Snapshot> look = f.window->findChild<FirstLook*>()->snapshot();
    QVERIFY(look && look->scan.stamp_s() == last->scan.stamp_s());
    QVERIFY(look->best_map.empty() && look->best_trajectory.empty());
    QVERIFY(f.window->findChild<QLabel*>("scan_panel_title")->text().startsWith("Newest scan"));
    f.trigger("action_run");
    QTRY_VERIFY(f.steps() == 1050 && f.shows_everything());
    QCOMPARE(f.window->findChild<QLabel*>("scan_panel_title")->text(), QString("Last scan"));
    QVERIFY(f.session.is_live());
}

void ConnectTest::parameters_and_reading_change_on_the_way() {
    ConnectFixture f;
    f.begin();
    const quint64 first = f.steps();
    Configuracion other = f.session.configuration();
    other.filter.particles = 7;
    f.session.set_configuration(other);
    QVERIFY(f.session.is_live());
    QTRY_VERIFY(f.caught_up());
    QCOMPARE(f.steps(), first);
    other.source.read.min_range_m = 0.5;
    f.session.set_configuration(other);
    QVERIFY(f.session.is_live());
    QTRY_VERIFY(f.caught_up() && f.steps() == first);
    f.rest_comes();
    QTRY_COMPARE(f.steps(), 1050U);
    QCOMPARE(f.session.configuration().source.read.min_range_m, 0.5);
}

void ConnectTest::another_log_ends_the_connection() {
    ConnectFixture f;
    f.begin();
    f.session.set_configuration(Fixture::tour(10));
    QVERIFY(!f.session.is_live());
    QVERIFY(f.session.incoming_tour() == nullptr);
    QTRY_COMPARE(f.act()->text(), QString("Connect"));
    f.run_to_end();
    QCOMPARE(f.steps(), 1050U);
    f.window->configuration_actions().undo();  // the file as it is
    QVERIFY(!f.session.is_live());
    f.run_to_end();
    QVERIFY(f.steps() > 100 && f.steps() < 1050);
}

void ConnectTest::a_window_that_closes_waits_for_nothing() {
    ConnectFixture f;
    f.begin();
    f.prompts.confirms = {true};
    QVERIFY(f.window->close());
    f.window.reset();
}

void ConnectTest::nobody_leaves_a_tour_that_comes_in_unasked() {
    ConnectFixture f;
    f.begin();
    ConfigurationActions& actions = f.window->configuration_actions();
    const QString other = f.write("small.txt", "ODOM 0 0 0\nLASER 0 2 1 0 1 1\n");
    Configuracion another = f.session.configuration();
    another.source = {};
    another.source.file = other.toStdString();
    const QString with_other = f.path("other.cfg");
    ArchivoConfiguracion::write(another, with_other.toStdString());
    auto refused = [&f, asked = qsizetype{0}](const auto& leave) mutable {
        leave();
        QCOMPARE(f.prompts.confirmed_texts.size(), ++asked);
        QVERIFY2(f.prompts.confirmed_texts.back().contains("tour.log"),
                 qPrintable(f.prompts.confirmed_texts.back()));
        QVERIFY(f.session.is_live());
    };
    refused([&] { QVERIFY(!actions.open(other)); });
    f.prompts.confirms = {true};  // of the configuration; then the tour is asked about
    actions.open(with_other);
    f.prompts.confirmed_texts.removeFirst();
    refused([] {});
    refused([&] { QVERIFY(!f.window->close()); });
    refused([&] { f.trigger("action_lesson_1"); });
    // What begins anew on the same tour ends nothing.
    Configuracion next = f.session.configuration();
    next.filter.particles = 7;
    QVERIFY(actions.use_again(next));
    actions.undo();
    QTRY_VERIFY(f.caught_up());
    f.trigger("action_stop");
    f.trigger("action_restart");
    f.rest_comes();
    QTRY_VERIFY2(f.state_words().contains("stands still") || f.state_words().contains("No scan"),
                 qPrintable(f.state_words()));
    QCOMPARE(f.prompts.confirmed_texts.size(), 4);
    QVERIFY(f.session.is_live());
    f.prompts.confirms = {true};
    f.trigger("action_lesson_1");
    QCOMPARE(f.prompts.confirmed_texts.size(), 5);
    QVERIFY(!f.session.is_live());
}

void ConnectTest::a_map_whose_log_is_gone_is_not_thrown_away_unasked() {
    ConnectFixture f;
    f.begin();
    const auto* file = f.dialog().findChild<QLineEdit*>("connect_file");
    QVERIFY(file->isHidden() || !file->isVisibleTo(&f.dialog()));  // it is kept already
    const quint64 mapped = f.steps();
    f.write("tour.log", "ODOM 0 0 0\n");  // whoever wrote it begins anew
    QTRY_VERIFY2(f.state_words().contains("shorter"), qPrintable(f.state_words()));
    f.trigger("action_restart");
    QCOMPARE(f.prompts.confirmed_texts.size(), 1);
    QVERIFY2(f.prompts.confirmed_texts.back().contains("cannot be mapped again"),
             qPrintable(f.prompts.confirmed_texts.back()));
    QCOMPARE(f.steps(), mapped);
    f.dialog().findChild<QLineEdit*>("connect_address")->setText("ws://localhost:8765");
    QVERIFY(file->isVisibleTo(&f.dialog()));
}

void ConnectTest::what_there_is_to_doubt_is_told_after_a_restart_too() {
    ConnectFixture f;
    f.begin();
    auto* said = f.window->findChild<QLabel*>("status_state");
    f.trigger("action_stop");
    QTRY_VERIFY2(said->text().contains("the tour goes on"), qPrintable(said->text()));
    f.trigger("action_restart");
    f.rest_comes();
    f.append(f.tour.mid(f.tour.indexOf("ODOM")));  // played again
    QVERIFY(!said->text().contains("⚠"));
    f.trigger("action_run");
    QTRY_COMPARE(f.steps(), 2100U);
    QTRY_VERIFY2(said->text().contains("⚠"), qPrintable(said->text()));
    QVERIFY2(said->toolTip().contains("goes back"), qPrintable(said->toolTip()));
    // Who looks how it stands does not end it by the way.
    QTest::keyClick(&f.dialog(), Qt::Key_Return);
    QVERIFY(f.session.is_live());
}

void ConnectTest::the_beginning_is_waited_for() {
    ConnectFixture f;
    f.write("tour.log", "# nothing yet\n");
    f.connect_to(f.path("tour.log"));
    QTRY_VERIFY2(f.state_words().startsWith("Waits") || f.state_words().startsWith("Scan 0 of 20"),
                 qPrintable(f.state_words()));
    QVERIFY(!f.session.has_source());
    for (int scan = 0; scan < 20; ++scan)
        f.append("ODOM " + QByteArray::number(scan) + " 0 0\n" + scan_line(scan));
    QTRY_VERIFY(f.session.is_live() && f.steps() == 20);
    f.act()->click();
    QTRY_VERIFY(f.state() == Progress::State::finished);
}

void ConnectTest::without_odometry_the_scans_say_how_it_goes() {
    ConnectFixture f;
    f.write("tour.log", {});
    // No more than the beginning: nobody waits for the next one.
    for (int scan = 0; scan < 20; ++scan) f.append(scan_line(scan));
    f.connect_to(f.path("tour.log"));
    QTRY_VERIFY(f.session.is_live() && f.steps() == 20);
    f.append(scan_line(20));
    QTRY_COMPARE(f.steps(), 21U);
    f.dialog();
    f.act()->click();
    QTRY_VERIFY(f.state() == Progress::State::finished && f.shows_everything());
    same_maps(*f.session.snapshot(), *again(f.session.configuration()));
}

void ConnectTest::a_scan_is_not_there_before_its_odometry() {
    ConnectFixture f;
    f.write("tour.log", {});
    for (int scan = 0; scan < 20; ++scan)
        f.append("ODOM " + QByteArray::number(scan) + " 0 0\n" + scan_line(scan));
    f.append(scan_line(20));
    f.connect_to(f.path("tour.log"));
    QTRY_VERIFY(f.session.is_live() && f.steps() == 20);
    f.trigger("action_stop");
    QTRY_COMPARE(f.state(), Progress::State::paused);
    QCOMPARE(f.session.incoming_tour()->scans(), 20U);
    f.append("ODOM 20 0 0\n");
    QTRY_COMPARE(f.session.incoming_tour()->scans(), 21U);
    QCOMPARE(f.steps(), 20U);
    // It is over while it stands still: what is not for live tours comes back.
    QVERIFY(!f.action("action_study")->isEnabled());
    f.dialog();
    f.act()->click();
    QTRY_VERIFY(f.action("action_study")->isEnabled());
    QTRY_VERIFY(f.window->findChild<QLabel*>("status_scan")->text().contains("20 of 21"));
}

void ConnectTest::of_several_lasers_one_is_chosen() {
    ConnectFixture f;
    const test::Bytes cdr = test::Bytes::cdr();
    std::vector<test::Said> said = test::small_tour(cdr, 30);
    std::vector<test::Said> both;
    for (const test::Said& one : said) {
        both.push_back(one);
        if (one.topic != "/scan") continue;
        both.push_back(one);
        both.back().topic = "/rear";
    }
    f.write("tour.log", {});
    f.append(QByteArray::fromStdString(test::mcap_of(both)).chopped(8));
    f.connect_to(f.path("tour.log"));
    QTRY_VERIFY2(f.state_words().contains("several lasers"), qPrintable(f.state_words()));
    auto* topics = f.dialog().findChild<QTreeWidget*>("connect_topics");
    QTRY_VERIFY(topics->topLevelItemCount() >= 3);
    QVERIFY(topics->isEnabled());
    const auto rows = topics->findItems("/rear", Qt::MatchExactly);
    QCOMPARE(rows.size(), 1);
    rows.front()->setCheckState(0, Qt::Checked);
    QTRY_VERIFY(f.session.is_live());
    QCOMPARE(f.session.configuration().source.read.scan_topic, std::string("/rear"));
    f.dialog();
    f.act()->click();
    QTRY_VERIFY(f.state() == Progress::State::finished);
    QCOMPARE(f.steps(), 30U);
}

/// By a server that others have written.
void ConnectTest::a_robot_is_mapped_lost_and_let_go() {
    QProcess npm;
    npm.start("npm", {"root", "-g"});
    const bool has_npm = npm.waitForFinished(kPatienceMs) && npm.exitCode() == 0;
    QProcessEnvironment with_packages = QProcessEnvironment::systemEnvironment();
    if (has_npm && !with_packages.contains("NODE_PATH"))
        with_packages.insert("NODE_PATH", QString(npm.readAll()).trimmed());
    QProcess packages;
    packages.setProcessEnvironment(with_packages);
    packages.start("node", {"-e", "require('@foxglove/ws-protocol'); require('ws')"});
    if (!packages.waitForFinished(kPatienceMs) || packages.exitCode() != 0)
        QSKIP("node or its packages @foxglove/ws-protocol and ws are missing");
    ConnectFixture f;
    const auto recording = test::mcap_of(test::small_tour(test::Bytes::cdr(), 60));
    const QString tour = f.write("tour.mcap", QByteArray::fromStdString(recording));
    QProcess robot;
    robot.setProcessEnvironment(with_packages);
    robot.start("node", {Fixture::source_file("tests/programs/foxglove_server.js"), tour, "2"});
    QTRY_VERIFY(robot.canReadLine() || robot.state() == QProcess::NotRunning);
    const QString port = QString(robot.readLine()).trimmed();
    f.dialog().findChild<QLineEdit*>("connect_file")->setText(f.path("kept.mcap"));
    f.connect_to("ws://127.0.0.1:" + port);
    QTRY_VERIFY(f.session.is_live());
    QVERIFY(!f.window->findChild<ConnectDialog*>()->isVisible());  // the map is what is looked at
    QTRY_COMPARE(f.steps(), 60U);
    auto* said = f.window->findChild<QLabel*>("status_state");
    QTRY_VERIFY2(said->text().startsWith("Connection lost"), qPrintable(said->text()));
    auto* topics = f.dialog().findChild<QTreeWidget*>("connect_topics");
    QTRY_COMPARE(topics->findItems("/scan", Qt::MatchExactly).value(0)->text(3), QString("60"));
    QVERIFY(f.state_words().contains("lost"));
    f.act()->click();
    QTRY_VERIFY(f.state() == Progress::State::finished && f.shows_everything());
    QTRY_VERIFY2(f.state_words().contains("kept.mcap"), qPrintable(f.state_words()));
    QCOMPARE(f.session.configuration().source.file, f.path("kept.mcap").toStdString());
    same_maps(*f.session.snapshot(), *again(f.session.configuration()));
    // Its file's name is used up.
    QVERIFY(f.dialog().findChild<QLineEdit*>("connect_file")->text() != f.path("kept.mcap"));
    robot.kill();
    robot.waitForFinished();
}

void ConnectTest::what_cannot_be_followed_is_told() {
    ConnectFixture f;
    f.connect_to(f.path("none.log"));
    QTRY_VERIFY2(f.state_words().contains("none.log"), qPrintable(f.state_words()));
    QCOMPARE(f.act()->text(), QString("Connect"));
    f.write("prose.log", "once upon a time\n");
    const QString nobody = "ws://127.0.0.1:1";
    f.dialog().findChild<QLineEdit*>("connect_file")->setText(f.path("kept.mcap"));
    f.connect_to(nobody);
    QTRY_VERIFY2(f.state_words().contains("127.0.0.1"), qPrintable(f.state_words()));
    QVERIFY(!QFile::exists(f.path("kept.mcap")));
    f.connect_to("ws://");
    QTRY_VERIFY2(f.state_words().contains("ws://"), qPrintable(f.state_words()));
    QVERIFY(!f.session.has_source());
    // So the command line says it.
    CommandLine line;
    line.open = "ws://127.0.0.1:1/robot";
    open_named(*f.window, line, Audience::somebody);
    QTRY_VERIFY2(f.state_words().contains("/robot"), qPrintable(f.state_words()));
    QVERIFY(f.prompts.warnings.isEmpty());
    f.session.set_configuration({});
    // What was there is not written over unasked.
    f.write("kept.mcap", "mine");
    auto* name = f.dialog().findChild<QLineEdit*>("connect_file");
    int asked = 0;
    for (const char* typed : {"kept.mcap", "kept"}) {
        name->setText(f.path(typed));
        f.connect_to(nobody);
        QCOMPARE(f.prompts.confirmed_texts.size(), ++asked);
    }
    name->setText("");
    f.connect_to(nobody);
    QVERIFY(f.prompts.warnings.takeFirst().contains("Name the file"));
    // Nor where it was agreed to once.
    f.prompts.saves = {f.path("kept.mcap")};
    f.prompts.confirms = {true};
    for (auto* button : f.dialog().findChildren<QPushButton*>())
        if (button->text().startsWith("Browse")) button->click();
    QCOMPARE(name->text(), f.path("kept.mcap"));
    asked = static_cast<int>(f.prompts.confirmed_texts.size());
    f.connect_to(nobody);
    QCOMPARE(f.prompts.confirmed_texts.size(), asked);
    QTRY_COMPARE(f.act()->text(), QString("Connect"));
    name->setText(f.path("kept.mcap"));
    f.connect_to(nobody);
    QCOMPARE(f.prompts.confirmed_texts.size(), asked + 1);
    QCOMPARE(Fixture::read(f.path("kept.mcap")), QByteArray("mine"));
    // The log of the run is read again and again.
    const auto recording = test::mcap_of(test::small_tour(test::Bytes::cdr(), 60));
    const QString log = f.write("run.mcap", QByteArray::fromStdString(recording));
    QVERIFY(f.window->configuration_actions().open(log));
    QTRY_COMPARE(f.act()->text(), QString("Connect"));
    name->setText(log);
    f.connect_to(nobody);
    QVERIFY(f.prompts.warnings.takeFirst().contains("this window runs"));
}

}  // namespace hitos::window
