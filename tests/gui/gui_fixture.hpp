// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of the window share: answers to its questions, a window, and ways to wait.
#pragma once

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QPointer>
#include <QStatusBar>
#include <QStringList>
#include <QTemporaryDir>
#include <QTest>
#include <QThreadPool>
#include <QTimer>
#include <functional>
#include <memory>
#include <utility>

#include "actions/configuration_actions.hpp"
#include "actions/pace_control.hpp"
#include "actions/result_actions.hpp"
#include "app/main_window.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "look/written_number.hpp"
#include "views/grid_view.hpp"
#include "views/map_window.hpp"
#include "views/scan_view.hpp"

// Qt's own give up after five seconds; no test is to depend on the machine's speed.
#undef QTRY_VERIFY
#undef QTRY_VERIFY2
#undef QTRY_COMPARE
#define QTRY_VERIFY(...) QTRY_VERIFY_WITH_TIMEOUT((__VA_ARGS__), kPatienceMs)
#define QTRY_VERIFY2(condition, words) QTRY_VERIFY2_WITH_TIMEOUT(condition, words, kPatienceMs)
#define QTRY_COMPARE(found, wanted) QTRY_COMPARE_WITH_TIMEOUT(found, wanted, kPatienceMs)

namespace hitos::window {

constexpr int kPatienceMs = 300000;

/// The ready tour takes 50 s: still under way when a test looks at it, on any machine.
constexpr Pace kUnhurried{Pace::Kind::scans, 20.0};

/// Answers from lists; where a list is at its end, the answer is "cancel".
class ScriptedPrompts final : public Prompts {
  public:
    QStringList opens;
    QStringList saves;
    QStringList filters;  ///< chosen with them; where there is none, the dialog's first
    QStringList folders;
    QList<bool> confirms;
    QList<int> numbers;
    QStringList texts;
    // What was asked.
    QStringList warnings;
    QStringList warning_titles;
    QStringList starts;  ///< where saving was to begin
    QStringList confirmed_texts;
    QStringList number_texts;
    QStringList offered;
    QString offered_first;  ///< stands chosen
    int greatest_number = -1;
    int opens_asked = 0;
    int saves_asked = 0;

    QString open_file(QWidget*, const FileQuestion&) override {
        ++opens_asked;
        return opens.isEmpty() ? QString() : opens.takeFirst();
    }
    QString save_file(QWidget*, const FileQuestion& question) override {
        ++saves_asked;
        starts << question.start;
        if (question.chosen != nullptr && !saves.isEmpty()) {
            *question.chosen =
                filters.isEmpty() ? question.filters.section(";;", 0, 0) : filters.takeFirst();
        }
        return saves.isEmpty() ? QString() : saves.takeFirst();
    }
    QString choose_folder(QWidget*, const QString&, const QString&) override {
        return folders.isEmpty() ? QString() : folders.takeFirst();
    }
    bool confirm(QWidget*, const Question& question) override {
        confirmed_texts << question.text + '\n' + question.details;
        return !confirms.isEmpty() && confirms.takeFirst();
    }
    std::optional<int> number(QWidget*, const QString&, const QString& text, int,
                              int greatest) override {
        number_texts << text;
        greatest_number = greatest;
        return numbers.isEmpty() ? std::nullopt : std::optional(numbers.takeFirst());
    }
    std::optional<int> choice(QWidget*, const QString&, const QString&, const QStringList& words,
                              int first) override {
        offered = words;
        offered_first = words.value(first);
        return numbers.isEmpty() ? std::nullopt : std::optional(numbers.takeFirst());
    }
    std::optional<QString> text(QWidget*, const QString&, const QString&) override {
        return texts.isEmpty() ? std::nullopt : std::optional(texts.takeFirst());
    }
    void warn(QWidget*, const QString& title, const QString& text) override {
        warning_titles << title;
        warnings << text;
    }
};

/// Those of in_dialog() that have not met their dialog yet.
inline QList<QPointer<QTimer>>& awaited_dialogs() {
    static QList<QPointer<QTimer>> awaited;
    return awaited;
}

/// The test fails where a dialog that it awaits has not opened.
inline void expect_no_awaited_dialog() {
    int never_opened = 0;
    for (const QPointer<QTimer>& timer : std::exchange(awaited_dialogs(), {})) {
        if (!timer) continue;
        ++never_opened;
        delete timer.data();
    }
    QCOMPARE(never_opened, 0);
}

/// A window with files of its own, whose questions `Asked` answers.
template <class Asked>
struct WindowFixture {
    QTemporaryDir folder;
    UserFiles files{folder.filePath("user")};
    Asked prompts;
    Session session;
    std::unique_ptr<MainWindow> window;

    WindowFixture() {
        QDir().mkpath(folder.filePath("user"));
        PaceControl::set_full_speed(files.settings());
        window = std::make_unique<MainWindow>(session, files, prompts);
        window->run_guard().set_long_run(kPatienceMs);  // no question, however slow the machine
        window->resize(1360, 860);                      // with the cards, however small the screen
        window->show();
        // A desktop gives the keyboard to a new window; without a screen the end of the window
        // before may take it away again.
        window->activateWindow();
        if (!QTest::qWaitForWindowActive(window.get(), kPatienceMs)) qFatal("no active window");
    }
    ~WindowFixture() {
        expect_no_awaited_dialog();
        window.reset();
        QThreadPool::globalInstance()->waitForDone();
    }

    QString path(const QString& name) const { return folder.filePath(name); }
    QString write(const QString& name, const QByteArray& content) const {
        QFile file(path(name));
        if (!file.open(QIODevice::WriteOnly)) qFatal("cannot write %s", qPrintable(name));
        file.write(content);
        return path(name);
    }
    /// What the status bar says for a while.
    QString notice() const { return window->statusBar()->currentMessage(); }
    Progress::State state() const { return session.progress().state; }
    quint64 steps() const { return session.progress().steps; }
    bool shows_everything() const { return session.up_to_date(); }
};

/// In a country that writes decimal commas.
struct DecimalCommas {
    DecimalCommas() { set_decimal_comma(true); }
    ~DecimalCommas() { set_decimal_comma(false); }
    DecimalCommas(const DecimalCommas&) = delete;
    DecimalCommas& operator=(const DecimalCommas&) = delete;
};

/// On the ready tour.
struct Fixture : WindowFixture<ScriptedPrompts> {
    explicit Fixture(bool with_source = true, int particles = 10) {
        if (with_source) session.set_configuration(tour(particles));
    }

    static Configuracion tour(int particles) {
        Configuracion configuration =
            ArchivoConfiguracion::read(source_file("config/thesis.cfg").toStdString());
        configuration.source.file = source_file("data/bigloop.log.gz").toStdString();
        configuration.filter.particles = particles;
        return configuration;
    }
    static QString source_file(const QString& path) {
        return QString(HITOS_SOURCE_DIR) + '/' + path;
    }

    QAction* action(const char* name) const {
        auto* found = window->findChild<QAction*>(name);
        if (found == nullptr) qFatal("no action %s", name);
        return found;
    }
    /// As a user does: no sooner than it is possible.
    void trigger(const char* name) const {
        QTRY_VERIFY2(action(name)->isEnabled(), name);
        action(name)->trigger();
    }
    static QByteArray read(const QString& path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    void run_steps(quint64 count) {
        session.run_steps(count);
        QTRY_VERIFY(state() != Progress::State::running && shows_everything());
    }
    void run_to_end() {
        trigger("action_run");
        QTRY_VERIFY(state() == Progress::State::finished && shows_everything());
    }
};

/// Where a place of the world [m] is in a view.
inline QPoint pixel_in(const CanvasView& view, const QPointF& world) {
    return view.camera().to_screen(view.size()).map(world).toPoint();
}

/// Does something with the modal dialog of that kind once it is there; by the end of the fixture it
/// has to have been.
template <class Dialog>
void in_dialog(std::function<void(Dialog&)> act) {
    auto* timer = new QTimer(qApp);
    timer->setInterval(10);
    QObject::connect(timer, &QTimer::timeout, qApp, [timer, act] {
        auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
        if (dialog == nullptr) return;
        timer->stop();
        timer->deleteLater();
        awaited_dialogs().removeAll(QPointer<QTimer>(timer));
        const QPointer<Dialog> still_there(dialog);
        act(*dialog);
        if (still_there && still_there->isVisible()) still_there->reject();  // a test has failed
    });
    timer->start();
    awaited_dialogs() << timer;
}

}  // namespace hitos::window
