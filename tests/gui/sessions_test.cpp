// SPDX-License-Identifier: GPL-3.0-or-later
// The recorded sessions of sessions/, each as a test; with HITOS_PICTURES they make the guide's
// pictures.

#include <QDir>
#include <QTest>

#include "gui_fixture.hpp"
#include "session_player.hpp"
#include "tests.hpp"

namespace hitos::window {

void SessionsTest::they_come_true_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("language");
    const QDir folder(Fixture::source_file("tests/gui/sessions"));
    for (const QString& name : folder.entryList({"*.session"})) {
        const QString title = name.section('.', 0, 0);
        QTest::newRow(qPrintable(title)) << folder.filePath(name) << "en";
        if (!Fixture::read(folder.filePath(name)).contains("--language"))
            QTest::newRow(qPrintable(title + "-es")) << folder.filePath(name) << "es";
    }
}

void SessionsTest::they_come_true() {
    QFETCH(const QString, file);
    QFETCH(const QString, language);
    const Effort effort = play_session(file, language);
    qInfo("%d clicks, %d keys, %.1f s", effort.clicks, effort.keys, effort.seconds);
}

/// What would pass whatever the window did is no test.
void SessionsTest::what_does_not_come_true_is_told() {
    const QTemporaryDir folder;
    const auto failure_of = [&folder](const QByteArray& text, int patience_ms) {
        QFile file(folder.filePath("wrong.session"));
        if (!file.open(QIODevice::WriteOnly)) qFatal("cannot write");
        file.write(text);
        file.close();
        return failure_of_session(file.fileName(), patience_ms);
    };
    const auto tells = [&](const QByteArray& text, const char* words) {
        const QString told = failure_of(text, 50);
        QVERIFY2(told.contains(words), qPrintable(told));
    };
    QCOMPARE(failure_of("hitos corridor\nrest\neffort 0 clicks, 0 keys\n", kPatienceMs), QString());
    tells("hitos corridor\n", "expected hitos ARGUMENTS");
    tells("hitos corridor\nsee No such words\neffort 0 clicks, 0 keys\n",
          "line 2, see No such words: it is not in sight");
    tells("hitos corridor\ngone Run\neffort 0 clicks, 0 keys\n", "it is still in sight");
    tells("hitos corridor\nclick No such button\neffort 1 clicks, 0 keys\n", "not to be clicked");
    tells("hitos corridor\npress Ctrl+Nokey\neffort 0 clicks, 1 keys\n", "there is no such key");
    tells("hitos corridor\nwave\neffort 0 clicks, 0 keys\n",
          "line 2, wave : nothing is known under");
    tells("hitos corridor\ndrive 3\neffort 0 clicks, 0 keys\n", "there is no robot");
    tells("hitos corridor\nfile a.cfg\neffort 0 clicks, 0 keys\n", "no file is asked for");
    tells("hitos corridor\nwritten out/a.cfg\neffort 0 clicks, 0 keys\n", "it is not written");
    tells("hitos corridor --screenshot a.png\neffort 0 clicks, 0 keys\n", "expected hitos");
    tells("hitos corridor\nclick Run\neffort 2 clicks, 0 keys\n", "found 1 clicks, 0 keys");
    tells("hitos corridor\npress Ctrl+O\nsee Select\neffort 0 clicks, 1 keys\n",
          "a dialog waits at the end");
}

}  // namespace hitos::window
