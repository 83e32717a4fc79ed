// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the test class that the first argument names.

#include <QApplication>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>

#include "app/application.hpp"
#include "gui_fixture.hpp"
#include "runs/run_keeper.hpp"
#include "tests.hpp"

namespace {

template <class Tests>
int run(QStringList arguments) {
    arguments.removeAt(1);
    Tests tests;
    return QTest::qExec(&tests, arguments);
}

/// A window with a run that it keeps; kept_runs_test.cpp ends it from outside.
int run_until_killed() {
    hitos::window::Fixture window;
    window.window->run_keeper().set_long_run(0.0);
    window.session.run();
    return QApplication::exec();
}

}  // namespace

int main(int argc, char** argv) {
    using namespace hitos::window;  // the tests are part of the window
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
    if (qEnvironmentVariableIsEmpty("QTEST_FUNCTION_TIMEOUT")) {
        // Qt's five minutes are one wait's patience, and less than a user may be asked to stay.
        const int seconds = 20 * qEnvironmentVariableIntValue("HITOS_REPEAT");
        qputenv("QTEST_FUNCTION_TIMEOUT", QByteArray::number(4 * kPatienceMs + 1000 * seconds));
    }
    QStandardPaths::setTestModeEnabled(true);
    const QTemporaryDir settings;  // what Qt's dialogs keep is the user's own
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
    QApplication application(argc, argv);
    prepare_application();
    speak(application, "en");
    apply_theme(application, Theme::light);
    const QStringList arguments = QApplication::arguments();
    const QString name = arguments.value(1);
    if (name == "until_killed") return run_until_killed();
    if (name == "save") return save_as_told(arguments.mid(2));
    if (name == "contact") return run<ContactTest>(arguments);
    if (name == "fit") return run<FitTest>(arguments);
    if (name == "readings") return run<ReadingsTest>(arguments);
    if (name == "source") return run<SourceTest>(arguments);
    if (name == "configuration") return run<ConfigurationTest>(arguments);
    if (name == "connect") return run<ConnectTest>(arguments);
    if (name == "draw") return run<DrawTest>(arguments);
    if (name == "drive") return run<DriveTest>(arguments);
    if (name == "gamepad") return run<GamepadTest>(arguments);
    if (name == "graph") return run<GraphTest>(arguments);
    if (name == "guide") return run<GuideTest>(arguments);
    if (name == "run") return run<RunTest>(arguments);
    if (name == "runs") return run<RunsTest>(arguments);
    if (name == "inspect") return run<InspectTest>(arguments);
    if (name == "keyboard") return run<KeyboardTest>(arguments);
    if (name == "lessons") return run<LessonsTest>(arguments);
    if (name == "measure") return run<MeasureTest>(arguments);
    if (name == "sessions") return run<SessionsTest>(arguments);
    if (name == "study") return run<StudyTest>(arguments);
    if (name == "time") return run<TimeTest>(arguments);
    if (name == "random") return run<RandomUserTest>(arguments);
    if (name == "view") return run<ViewTest>(arguments);
    if (name == "words") return run<WordsTest>(arguments);
    qCritical(
        "expected connect, contact, draw, drive, fit, gamepad, graph, guide, source, "
        "configuration, random, "
        "run, "
        "runs, sessions, study, time, view, inspect, keyboard, lessons, measure or words");
    return 2;
}
