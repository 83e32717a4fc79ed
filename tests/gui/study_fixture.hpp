// SPDX-License-Identifier: GPL-3.0-or-later
// A window with its study open, and the folder that the command line makes of the same study.
#pragma once

#include <QDir>
#include <QDirIterator>
#include <QLabel>
#include <QLineEdit>
#include <QProcess>
#include <QPushButton>

#include "dialogs/study_dialog.hpp"
#include "gui_fixture.hpp"

namespace hitos::window {

/// A window with its study open: two values of dmax, two runs of each.
struct StudyFixture : Fixture {
    StudyDialog& study;

    explicit StudyFixture(int particles = 5) : Fixture(true, particles), study(open()) {
        set("values", "0.02, 0.05");
        study.form().set_runs(2);
        set("reference", source_file("data/maps/bigloop.map"));
        set("folder", path("study"));
    }

    StudyDialog& open() {
        trigger("action_study");
        if (window->study() == nullptr) qFatal("no study");
        window->study()->form().set_assignments({"dmax="});
        return *window->study();
    }
    void set(const char* field, const QString& text) const {
        study.findChild<QLineEdit*>(field)->setText(text);
    }
    void press(const char* button) const { study.findChild<QPushButton*>(button)->click(); }
    bool enabled(const char* button) const {
        return study.findChild<QPushButton*>(button)->isEnabled();
    }
    QString error_at(const QString& field) const {
        auto* label = study.findChild<QLabel*>("error_" + field);
        return label->isHidden() ? QString() : label->text();
    }
    QString verdict() const { return study.findChild<QLabel*>("verdict")->text(); }
    void run_study() const {
        press("start");
        QTRY_VERIFY(!study.running());
    }

    /// Runs hitos-cli study with the same inputs; gives its folder.
    QString command_line_study(const QStringList& extra = {}) {
        prompts.saves = {path("same.cfg")};
        trigger("action_save");
        QProcess cli;
        cli.start(QString(HITOS_BIN_DIR) + "/hitos-cli",
                  QStringList{"study", QString::fromStdString(session.configuration().source.file),
                              "--config", path("same.cfg"), "--reference",
                              source_file("data/maps/bigloop.map"), "--vary", "dmax=0.02,0.05",
                              "--runs", "2", "--out", path("cli")} +
                      extra);
        if (!cli.waitForFinished(kPatienceMs) || cli.exitCode() != 0)
            qFatal("hitos-cli has failed");
        return path("cli");
    }
};

/// Every file but those that tell the time that the runs took.
inline QStringList results_in(const QString& folder) {
    QStringList names;
    QDirIterator files(folder, QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        const QString name = QDir(folder).relativeFilePath(files.next());
        if (name != "timing.csv" && !name.startsWith("runs/")) names << name;
    }
    names.sort();
    return names;
}

inline void compare_folders(const QString& mine, const QString& other, int runs = 4) {
    const QStringList names = results_in(mine);
    QCOMPARE(names, results_in(other));
    QVERIFY2(names.contains("quality.csv") && names.contains("summary.csv") &&
                 names.contains("error.dat") && names.filter("maps/").size() == runs,
             qPrintable(names.join(' ')));
    for (const QString& name : names) {
        QVERIFY2(Fixture::read(mine + '/' + name) == Fixture::read(other + '/' + name),
                 qPrintable(name));
    }
}

}  // namespace hitos::window
