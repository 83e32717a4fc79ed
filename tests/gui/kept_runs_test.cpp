// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of a long run whose window ends without anybody being asked.

#include <QComboBox>
#include <QDate>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>
#include <QProcess>
#include <QStandardPaths>

#include "gui_fixture.hpp"
#include "runs/compare_window.hpp"
#include "runs/run_keeper.hpp"
#include "runs/runs.hpp"
#include "tests.hpp"

namespace hitos::window {
namespace {

QDir data_folder(const QString& name) {
    return {QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + '/' + name};
}

/// What windows keep at the moment, locks and all.
QStringList everything_kept() {
    return data_folder("running").entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
}

bool is_kept() {
    const QDir folder = data_folder("running");
    for (const QString& name : folder.entryList({"*.run"}, QDir::Dirs)) {
        if (QFileInfo::exists(folder.filePath(name) + "/results/summary.json")) return true;
    }
    return false;
}

/// Another window, with a run that it keeps.
void start_other(QProcess& other) {
    QVERIFY(data_folder("running").removeRecursively());
    other.start(QCoreApplication::applicationFilePath(), {"until_killed"});
    QVERIFY(other.waitForStarted());
    QTRY_VERIFY(is_kept() || other.state() == QProcess::NotRunning);
    QCOMPARE(other.state(), QProcess::Running);
    QCOMPARE(RunKeeper::take_left(), QString());  // it is that window's
}

/// The next window tells of it once, and shows it.
void expect_told() {
    Fixture f(false);
    f.prompts.confirms = {true};
    f.window->tell_left_runs();
    QCOMPARE(f.prompts.confirmed_texts.size(), 1);
    const QString words = f.prompts.confirmed_texts.front();
    const QString folder = words.section("Its results are in ", 1).chopped(1);
    QVERIFY2(QFileInfo::exists(folder + "/map.txt"), qPrintable(words));
    QVERIFY2(words.contains(QLocale().toString(QDate::currentDate(), QLocale::ShortFormat)),
             qPrintable(words));
    QVERIFY2(f.prompts.confirmed_texts.front().contains("with Cancel", Qt::CaseInsensitive),
             qPrintable(words));
    // Its summary says nothing of what nobody has looked for.
    const QJsonObject quality =
        QJsonDocument::fromJson(Fixture::read(folder + "/summary.json"))["quality"].toObject();
    QVERIFY(quality.contains("warnings"));
    for (const char* figure : {"cells_per_point", "odometry_cells_per_point", "findings"})
        QVERIFY(!quality.contains(figure));
    // Nothing else is there to compare it with: its odometry is.
    const CompareWindow* comparison = f.window->runs().comparison();
    QVERIFY(comparison != nullptr);
    for (const char* box : {"compare_left", "compare_right"})
        QVERIFY(comparison->findChild<QComboBox*>(box)->currentIndex() >= 0);
    QVERIFY(comparison->findChild<QComboBox*>("compare_right")->currentText().contains("odometry"));
    QCOMPARE(f.window->runs().list().runs().size(), std::size_t{1});
    QVERIFY(f.window->runs().list().runs().front().run->path.size() > 1000);
    f.window->tell_left_runs();
    QCOMPARE(f.prompts.confirmed_texts.size(), 1);
    QCOMPARE(everything_kept(), QStringList());
    QVERIFY(QDir(folder).removeRecursively());
}

}  // namespace

void RunsTest::a_long_run_is_kept_until_it_is_left() {
    QVERIFY(data_folder("running").removeRecursively());
    Fixture f;
    f.run_to_end();
    QCOMPARE(everything_kept(), QStringList());  // it has not been long
    f.trigger("action_restart");
    f.window->run_keeper().set_long_run(0.0);
    f.run_to_end();
    QTRY_VERIFY(is_kept());
    QCOMPARE(RunKeeper::take_left(), QString());
    f.trigger("action_restart");
    QTRY_COMPARE(everything_kept(), QStringList());
    f.run_to_end();
    QTRY_VERIFY(is_kept());
    f.window.reset();
    QTRY_COMPARE(everything_kept(), QStringList());
}

void RunsTest::a_killed_windows_run_is_told_by_the_next_one() {
    QProcess other;
    start_other(other);
    if (QTest::currentTestFailed()) return;
    other.kill();
    QVERIFY(other.waitForFinished(kPatienceMs));
    expect_told();
}

void RunsTest::a_run_whose_display_dies_is_told_by_the_next_window() {
    const QString xvfb = QStandardPaths::findExecutable("Xvfb");
    if (xvfb.isEmpty()) QSKIP("needs Xvfb, which is not installed");
    QProcess display;
    display.start(xvfb, {"-displayfd", "1", "-nolisten", "tcp"});
    QVERIFY(display.waitForReadyRead(kPatienceMs));
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("DISPLAY", ":" + display.readLine().trimmed());
    environment.insert("QT_QPA_PLATFORM", "xcb");
    QProcess other;
    other.setProcessEnvironment(environment);
    start_other(other);
    if (QTest::currentTestFailed()) return;
    display.kill();
    QVERIFY(display.waitForFinished(kPatienceMs));
    QVERIFY(other.waitForFinished(kPatienceMs));
    QVERIFY(other.exitCode() != 0);
    expect_told();
}

}  // namespace hitos::window
