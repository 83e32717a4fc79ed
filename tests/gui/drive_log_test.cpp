// SPDX-License-Identifier: GPL-3.0-or-later
// Logs of a driven tour, saved on the way.

#include <QProcess>
#include <QPushButton>

#include "drive_fixture.hpp"
#include "hitos/simulation/text/world_text.hpp"
#include "tests.hpp"
#include "world/log_saver.hpp"

namespace hitos::window {
namespace {

struct LogFixture : DriveFixture {
    QPushButton& button() { return *world_window().findChild<QPushButton*>("drive_log"); }
    void save_log(const QString& file, const QString& filter = {}) {
        prompts.saves << file;
        if (!filter.isEmpty()) prompts.filters << filter;
        QTest::mouseClick(&button(), Qt::LeftButton);
    }
    QStringList all_files() const {
        return QDir(folder.path())
            .entryList(QDir::Files | QDir::Dirs | QDir::Hidden | QDir::NoDotAndDotDot);
    }
};

/// As hitos-cli simulates the world.
void check_log(const QString& world, const QString& format, const QString& log) {
    const QTemporaryDir folder;
    const QString again = folder.filePath("again.log");
    const QString truth = folder.filePath("again.tum");
    QProcess program;
    program.start(QString(HITOS_BIN_DIR) + "/hitos-cli",
                  {"simulate", world, "--format", format, "--out", again, "--truth", truth});
    QVERIFY(program.waitForFinished(kPatienceMs));
    QVERIFY2(program.exitCode() == 0, program.readAllStandardError().constData());
    QVERIFY(!Fixture::read(again).isEmpty());
    QVERIFY(Fixture::read(again) == Fixture::read(log));
    QVERIFY(Fixture::read(truth) ==
            Fixture::read(QString::fromStdString(truth_beside(log.toStdString()).string())));
}

}  // namespace

void DriveTest::a_log_is_saved_on_the_way_data() {
    QTest::addColumn<QString>("format");
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("filter");
    QTest::addRow("by the filter") << "carmen"
                                   << "tour.log" << log_filters().value(3);
    QTest::addRow("by the ending") << "mcap"
                                   << "tour.mcap" << QString();
    QTest::addRow("by nothing") << "normalized"
                                << "tour.log" << QString();
}

void DriveTest::a_log_is_saved_on_the_way() {
    QFETCH(QString, format);
    QFETCH(QString, file);
    QFETCH(QString, filter);
    LogFixture f;
    f.drive().hold(0.63, 0.21);
    f.periods(40);
    Disturbance slip;
    slip.kind = DisturbanceKind::slip;
    slip.values = {1.0, 0.4, 0.0};
    f.drive().disturb(slip);
    f.periods(15);
    const auto tour = f.drive().tour();
    WorldText so_far = WorldText::read(f.path("room.toml").toStdString());
    so_far.set(tour->recorded());
    so_far.save(f.path("so-far.toml").toStdString());
    f.save_log(f.path(file), filter);
    // The tour goes on meanwhile; what was driven when it was asked for is in the log.
    QVERIFY(!f.button().isEnabled());
    f.drive().hold(-0.4, 0.5);
    f.periods(20);
    QTest::mouseClick(&f.button(), Qt::LeftButton);
    QCOMPARE(f.prompts.saves_asked, 1);
    QTRY_VERIFY(f.button().isEnabled());
    QVERIFY2(f.prompts.warnings.isEmpty(), qPrintable(f.prompts.warnings.join('\n')));
    QTRY_VERIFY(f.notice().contains(f.path(file)));
    QVERIFY(f.drive().tour() == tour);
    check_log(f.path("so-far.toml"), format, f.path(file));
    // And of the tour that is kept afterwards.
    f.prompts.confirms << true << true;
    f.save_log(f.path(file), filter);
    QTRY_VERIFY(f.button().isEnabled());
    f.drive().keep(f.path("kept.toml"));
    check_log(f.path("kept.toml"), format, f.path(file));
    QVERIFY(!f.button().isEnabled());
    QTRY_VERIFY(f.state() == Progress::State::finished);
}

void DriveTest::endings_and_filters_choose_the_format() {
    const QStringList filters = log_filters();
    QCOMPARE(filters.value(0), QString("Normalised (*.log *.txt)"));
    QStringList formats;
    for (const QString& filter : filters) {
        formats << QString::fromStdString(format_of_filter(filter));
    }
    QCOMPARE(formats, QStringList({"normalized", "player", "radish", "carmen", "mcap"}));
    QCOMPARE(format_of_filter("All files (*)"), std::string("normalized"));
}

void DriveTest::no_log_is_written_over_anything_unasked() {
    LogFixture f;
    f.drive().hold(0.5, 0.0);
    f.periods(20);
    f.write("tour.truth.tum", "mine");
    f.save_log(f.path("tour.log"));
    QCOMPARE(f.prompts.saves_asked, 2);  // no: where else?
    QCOMPARE(f.prompts.confirmed_texts.size(), 1);
    QVERIFY(f.prompts.confirmed_texts[0].contains("tour.truth.tum"));
    QVERIFY(f.button().isEnabled());
    QCOMPARE(Fixture::read(f.path("tour.truth.tum")), QByteArray("mine"));
    QVERIFY(!QFile::exists(f.path("tour.log")));
    // The world that is driven through is never written over.
    const QByteArray world = Fixture::read(f.path("room.toml"));
    f.prompts.confirms << true;
    f.save_log(f.path("room.toml"));
    QTRY_COMPARE(f.prompts.warnings.size(), 1);
    QVERIFY(f.prompts.warnings[0].contains("room.toml"));
    QCOMPARE(Fixture::read(f.path("room.toml")), world);
    f.prompts.confirms << true;
    f.save_log(f.path("tour.log"));
    QTRY_VERIFY(f.button().isEnabled());
    QVERIFY(QFile::exists(f.path("tour.log")));
    QVERIFY(Fixture::read(f.path("tour.truth.tum")) != QByteArray("mine"));
}

void DriveTest::a_log_that_cannot_be_written_is_told() {
    LogFixture f;
    f.drive().hold(0.5, 0.0);
    f.periods(20);
    const QStringList before = f.all_files();
    f.save_log(f.path("no-such-folder/tour.log"));
    QTRY_COMPARE(f.prompts.warnings.size(), 1);
    QVERIFY(f.prompts.warnings[0].contains("no-such-folder/tour."));
    QVERIFY(f.prompts.warnings[0].contains("create the folder first"));
    QVERIFY(f.drive().active());
    QVERIFY(f.button().isEnabled());
    QCOMPARE(f.all_files(), before);
}

void DriveTest::who_ends_while_a_log_is_written_has_it() {
    const QTemporaryDir folder;
    {
        LogFixture f;
        f.drive().hold(0.5, 0.1);
        f.periods(100);
        f.save_log(folder.filePath("tour.log"));
        QVERIFY(!f.button().isEnabled());
    }
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden | QDir::NoDotAndDotDot),
             QStringList({"tour.log", "tour.truth.tum"}));
}

}  // namespace hitos::window
