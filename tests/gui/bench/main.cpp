// SPDX-License-Identifier: GPL-3.0-or-later
// What the window costs a run and how fast it answers, a large graph too; or how late a driven
// robot's scans are mapped.
//
// usage: build/release/bench/bench_window [--drive PACE | --graph POSES | --open 1] ARGUMENT...
//
// ARGUMENTs are those of `hitos`: a log to run with and without the window in turns, or, with
// --drive, a world to drive through for half a minute, PACE times as fast as a clock; with --graph
// a made graph of that many poses is opened, changed and solved; with --open a log is only opened.
// Needs no display, and leaves the user's files alone. Exits with 1 where a limit is not kept.

#include <fmt/core.h>

#include <QApplication>
#include <QTemporaryDir>
#include <QThreadPool>
#include <algorithm>
#include <charconv>
#include <cstring>
#include <exception>
#include <limits>
#include <optional>

#include "actions/command_line.hpp"
#include "actions/pace_control.hpp"
#include "app/application.hpp"
#include "app/main_window.hpp"
#include "app/opening.hpp"
#include "hitos/base/process.hpp"
#include "look/prompts.hpp"
#include "look/theme.hpp"
#include "measures.hpp"
#include "runs/run_keeper.hpp"
#include "world/live_drive.hpp"

namespace {

using namespace hitos::window;

constexpr QSize kSize(1360, 860);

/// What an option says that stands first, if it is there, and takes both arguments away; 0: it is
/// not, nothing: it says no number from 1 to that.
std::optional<int> taken(const char* option, int most, int& argc, char** argv) {
    if (argc < 2 || std::strcmp(argv[1], option) != 0) return 0;
    int number = 0;
    if (argc > 2) std::from_chars(argv[2], argv[2] + std::strlen(argv[2]), number);
    if (number < 1 || number > most) {
        fmt::print(stderr, "{}: expected a number from 1 to {}\n", option, most);
        return std::nullopt;
    }
    argc -= 2;
    std::copy(argv + 3, argv + argc + 2, argv + 1);
    return number;
}

int measure(UserFiles& files, const CommandLine& line, int pace, int poses, bool opening) {
    Session session;
    NobodyThere nobody;
    MainWindow window(session, files, nobody);
    window.resize(kSize);
    window.run_keeper().set_long_run(std::numeric_limits<double>::infinity());
    if (opening) return measure_opening(window, line);
    open_named(window, line, Audience::nobody);
    if (nobody.warned()) return 1;
    if (poses > 0) return measure_graph(window, poses);
    return pace > 0 ? measure_lateness(window, session, pace) : measure_cost(window, session);
}

}  // namespace

int main(int argc, char** argv) {
    hitos::prepare_process();
    try {
        constexpr int kMostPoses = 1'000'000;
        const std::optional<int> pace = taken("--drive", LiveDrive::kFastest, argc, argv);
        const std::optional<int> poses = taken("--graph", kMostPoses, argc, argv);
        const std::optional<int> opening = taken("--open", 1, argc, argv);
        if (!pace || !poses || !opening) return 2;
        CommandLine line;
        if (const auto code = parse(argc, argv, line)) return *code;
        if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
        QApplication application(argc, argv);
        prepare_application();
        apply_theme(application, theme_from(QString::fromStdString(line.theme)));
        const QTemporaryDir scratch;
        UserFiles files(scratch.path());
        PaceControl::set_full_speed(files.settings());
        speak(application, "en");
        const int code = measure(files, line, *pace, *poses, *opening > 0);
        QThreadPool::globalInstance()->waitForDone();
        return code;
    } catch (const std::exception& error) {
        fmt::print(stderr, "bench_window: {}\n", error.what());
        return 1;
    }
}
