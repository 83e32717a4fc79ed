// hitos: the window.

#include <fmt/core.h>

#include <QApplication>
#include <QTemporaryDir>
#include <QThreadPool>
#include <exception>

#include "actions/configuration_actions.hpp"
#include "actions/pace_control.hpp"
#include "application.hpp"
#include "benchmark.hpp"
#include "command_line.hpp"
#include "dialogs/study_dialog.hpp"
#include "language.hpp"
#include "main_window.hpp"
#include "measure/measurements.hpp"
#include "runs/runs.hpp"
#include "screen_fit.hpp"
#include "screenshot.hpp"
#include "views/view_settings.hpp"

namespace {

using namespace hitos::window;  // the program is nothing but the window

void prepare_study(StudyDialog& study, const CommandLine& line) {
    study.form().set_assignment(QString::fromStdString(line.vary));
    study.form().set_runs(line.study_runs);
    if (!line.study_folder.empty()) {
        study.form().set_folder(QString::fromStdString(line.study_folder));
    }
}

/// Where no screen limits it.
constexpr QSize kWithoutScreen(1360, 860);

/// Pictures and measurements need no display, and leave the user's files alone.
bool without_display(const CommandLine& line) {
    return !line.screenshot.empty() || line.benchmark;
}

int run(int argc, char** argv, const CommandLine& line) {
    if (without_display(line)) {
        if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
        if (line.scale != 1.0) qputenv("QT_SCALE_FACTOR", QByteArray::number(line.scale));
    }
    QApplication application(argc, argv);
    prepare_application();
    QTemporaryDir scratch;
    UserFiles files(without_display(line) ? scratch.path() : QString());
    if (without_display(line)) PaceControl::set_full_speed(files.settings());
    speak(application,
          line.language.empty() ? saved_language(files) : QString::fromStdString(line.language));
    apply_theme(application, line.theme.empty() && !without_display(line)
                                 ? ViewSettings::saved_theme(files)
                                 : theme_from(QString::fromStdString(line.theme)));
    Session session;
    QtPrompts prompts;
    MainWindow window(session, files, prompts);
    if (without_display(line)) window.resize(kWithoutScreen);
    apply_size(window, line.size);

    ConfigurationActions& actions = window.configuration_actions();
    without_display(line) ? actions.start(line) : actions.start_or_warn(line);
    const QString named = QString::fromStdString(line.open);
    if (!named.isEmpty() && kind_of(named) == FileKind::results) window.runs().open(named);
    const QString distances = QString::fromStdString(line.distances);
    if (!distances.isEmpty()) {
        without_display(line) ? window.measurements().open(distances)
                              : window.open_distances(distances);
    }
    int code = 0;
    if (!line.screenshot.empty()) {
        take_screenshot(window, session, line);
    } else if (line.benchmark) {
        code = run_benchmark(window, session);
    } else {
        window.show();
        if (!line.vary.empty()) prepare_study(window.open_study(), line);
        if (line.run) session.run();
        code = QApplication::exec();
    }
    QThreadPool::globalInstance()->waitForDone();
    return code;
}

}  // namespace

int main(int argc, char** argv) {
    CommandLine line;
    if (const auto code = parse(argc, argv, line)) return *code;
    try {
        return run(argc, argv, line);
    } catch (const std::exception& error) {
        fmt::print(stderr, "hitos: {}\n", error.what());
        return 1;
    }
}
