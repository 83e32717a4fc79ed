// SPDX-License-Identifier: GPL-3.0-or-later
// hitos: the window.

#include <fmt/core.h>

#include <QApplication>
#include <QTemporaryDir>
#include <QThreadPool>
#include <QTimer>
#include <chrono>
#include <exception>
#include <limits>

#include "actions/command_line.hpp"
#include "actions/pace_control.hpp"
#include "application.hpp"
#include "hitos/base/process.hpp"
#include "language.hpp"
#include "look/prompts.hpp"
#include "look/screen_fit.hpp"
#include "look/words_of.hpp"
#include "main_window.hpp"
#include "opening.hpp"
#include "runs/run_keeper.hpp"
#include "screenshot.hpp"
#include "views/view_settings.hpp"

namespace {

using namespace hitos::window;  // the program is nothing but the window
using hitos::StopByRequest;

/// Where no screen limits it.
constexpr QSize kWithoutScreen(1360, 860);

/// Pictures need no display, and leave the user's files alone.
bool without_display(const CommandLine& line) {
    return !line.screenshot.empty();
}

int run_window(QApplication& application, UserFiles& files, const CommandLine& line) {
    apply_theme(application, line.theme.empty() && !without_display(line)
                                 ? ViewSettings::saved_theme(files)
                                 : theme_from(QString::fromStdString(line.theme)));
    Session session;
    QtPrompts user;
    NobodyThere nobody;
    Prompts& prompts = without_display(line) ? static_cast<Prompts&>(nobody) : user;
    MainWindow window(session, files, prompts);
    if (without_display(line)) {
        window.resize(kWithoutScreen);
        window.run_keeper().set_long_run(std::numeric_limits<double>::infinity());
    }
    apply_size(window, line.size);

    if (!without_display(line)) window.show();  // opening a large recording takes a while
    open_named(window, line, without_display(line) ? Audience::nobody : Audience::somebody);
    if (nobody.warned()) return 1;
    int code = 0;
    if (without_display(line)) {
        take_screenshot(window, session, line);
        code = nobody.warned() ? 1 : 0;
    } else {
        begin(window, session, line);
        QTimer::singleShot(0, &window, &MainWindow::tell_left_runs);
        const StopByRequest request(StopByRequest::Patience::endless);
        QTimer watch;
        QObject::connect(&watch, &QTimer::timeout, &window, [&window] {
            if (!StopByRequest::wanted()) return;
            window.leave();
            window.run_keeper().let_stay();
            QApplication::exit(StopByRequest::status());
        });
        constexpr std::chrono::milliseconds kLook(100);
        watch.start(kLook);
        code = QApplication::exec();
    }
    return code;
}

int run(int argc, char** argv, const CommandLine& line) {
    if (without_display(line)) {
        if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
        if (line.scale != 1.0) qputenv("QT_SCALE_FACTOR", QByteArray::number(line.scale));
    }
    const auto no = [](const char* name) { return qEnvironmentVariableIsEmpty(name); };
    if (no("QT_QPA_PLATFORM") && no("DISPLAY") && no("WAYLAND_DISPLAY")) {
        fmt::print(
            stderr,
            "hitos: there is no display to open a window on (DISPLAY and WAYLAND_DISPLAY are "
            "not set); hitos --screenshot FILE.png draws it without one, hitos-cli run needs "
            "none\n");
        return 1;
    }
    QApplication application(argc, argv);
    prepare_application();
    QTemporaryDir scratch;
    UserFiles files(without_display(line) ? scratch.path() : QString());
    if (without_display(line)) PaceControl::set_full_speed(files.settings());
    speak(application,
          line.language.empty() ? saved_language(files) : QString::fromStdString(line.language));
    int code = 1;
    try {
        code = run_window(application, files, line);
    } catch (const std::exception& error) {  // here its words can still be said in the language
        fmt::print(stderr, "hitos: {}\n", words_of(error).toStdString());
    }
    QThreadPool::globalInstance()->waitForDone();
    return code;
}

}  // namespace

int main(int argc, char** argv) {
    hitos::prepare_process();
    try {
        CommandLine line;
        if (const auto code = parse(argc, argv, line)) return *code;
        return run(argc, argv, line);
    } catch (const std::exception& error) {
        fmt::print(stderr, "hitos: {}\n", error.what());
        return 1;
    }
}
