// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QTimer>
#include <algorithm>
#include <chrono>
#include <memory>
#include <random>
#include <thread>
#include <vector>

#include "app/main_window.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/thread_clock.hpp"
#include "hitos/workbench/open_tour.hpp"
#include "measures.hpp"
#include "probe.hpp"
#include "session/background.hpp"
#include "session/session.hpp"
#include "views/grid_view.hpp"
#include "views/scan_view.hpp"

namespace hitos::window {
namespace {

constexpr quint64 kSliceSteps = 400;
constexpr double kGreatestCost = 0.1;
constexpr double kMostPictures = 60.0;
constexpr double kSlowestJumpMs = 500.0;
constexpr int kParticlesOfJumps = 100;
constexpr double kMostKeptMb = 200.0;

/// What some steps took.
struct Slice {
    quint64 steps = 0;
    double seconds = 0.0;
    double work_seconds = 0.0;    ///< of all threads, however long others kept them waiting
    double window_seconds = 0.0;  ///< of those the window's own thread
};

struct Figures {
    std::vector<double> slowdowns;  ///< time with the window / time without, pair by pair
    Slice bare;
    Slice shown;
    int pictures = 0;
    std::vector<double> answers_ms;
};

Slice bare_slice(RunWorker& worker) {
    const quint64 before = worker.progress().steps;
    const double work = process_seconds();
    const auto begin = Clock::now();
    worker.run(kSliceSteps);
    worker.wait();
    return {worker.progress().steps - before, seconds_since(begin), process_seconds() - work, 0.0};
}

/// The same steps while the window shows them. The last picture, which is drawn when they are over,
/// belongs to no slice.
Slice shown_slice(Session& session, Figures& figures) {
    RunWorker& worker = *session.worker();
    const quint64 before = session.progress().steps;
    QEventLoop loop;
    double seconds = 0.0;
    double work_seconds = 0.0;
    Probe probe;
    const double work = process_seconds();
    const double own = thread_seconds();
    const auto begin = Clock::now();
    session.run_steps(kSliceSteps);
    const std::jthread watch([&] {
        worker.wait();
        seconds = seconds_since(begin);
        work_seconds = process_seconds() - work;
        QMetaObject::invokeMethod(&loop, &QEventLoop::quit, Qt::QueuedConnection);
    });
    loop.exec();
    const double window_seconds = thread_seconds() - own;
    const std::vector<double> answers = probe.finish();
    figures.answers_ms.insert(figures.answers_ms.end(), answers.begin(), answers.end());
    return {session.progress().steps - before, seconds, work_seconds, window_seconds};
}

void settle(const Session& session) {
    constexpr int kStepMs = 20;
    do {
        QEventLoop loop;
        QTimer::singleShot(kStepMs, &loop, &QEventLoop::quit);
        loop.exec();
    } while (session.snapshot() && !session.up_to_date());
}

void add(Slice& sum, const Slice& slice) {
    sum.steps += slice.steps;
    sum.seconds += slice.seconds;
    sum.work_seconds += slice.work_seconds;
    sum.window_seconds += slice.window_seconds;
}

double speed(const Slice& slice) {
    return static_cast<double>(slice.steps) / slice.seconds;
}

/// The same log twice, step by step beside each other: once bare, once in the window. Slices of
/// both take turns, so that whatever else the machine does hits both alike.
Figures measured(MainWindow& window, Session& session) {
    Figures figures;
    // At the window's run's priority: only the window makes a difference.
    const auto bare = in_background([&] {
        return std::make_unique<RunWorker>(session.configuration(),
                                           open_tour(session.configuration()));
    });
    bool counting = false;
    const auto counter = QObject::connect(&window.grid_view(), &CanvasView::painted, &window,
                                          [&] { figures.pictures += counting ? 1 : 0; });
    const auto show = [&] {
        settle(session);
        counting = true;
        const Slice slice = shown_slice(session, figures);
        counting = false;
        settle(session);
        return slice;
    };
    for (bool bare_first = true;; bare_first = !bare_first) {
        Slice without;
        if (bare_first) without = bare_slice(*bare);
        const Slice with = show();
        if (!bare_first) without = bare_slice(*bare);
        if (without.steps < kSliceSteps || with.steps < kSliceSteps) break;
        add(figures.bare, without);
        add(figures.shown, with);
        figures.slowdowns.push_back(with.seconds / without.seconds);
    }
    QObject::disconnect(counter);
    std::sort(figures.slowdowns.begin(), figures.slowdowns.end());
    std::sort(figures.answers_ms.begin(), figures.answers_ms.end());
    return figures;
}

/// To scans at random, the same ones every time.
struct Jumps {
    std::vector<double> seconds;  ///< until the state is there and shown, ascending
    std::size_t checkpoint_bytes = 0;
};

Jumps measure_jumps(Session& session) {
    constexpr int kJumps = 30;
    Jumps jumps;
    const quint64 last = session.progress().steps;
    std::mt19937 random(1);
    std::uniform_int_distribution<quint64> scans(1, last);
    for (int i = 0; i < kJumps; ++i) {
        const auto begin = Clock::now();
        session.seek(scans(random));
        do {
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        } while (session.progress().state == Progress::State::running || !session.up_to_date());
        jumps.seconds.push_back(seconds_since(begin));
    }
    std::ranges::sort(jumps.seconds);
    for (const auto& checkpoint : session.snapshot()->checkpoints) {
        jumps.checkpoint_bytes += checkpoint->bytes();
    }
    return jumps;
}

}  // namespace

int measure_cost(MainWindow& window, Session& session) {
    window.show();
    session.restart();
    QCoreApplication::processEvents();
    const Figures figures = measured(window, session);
    if (figures.slowdowns.empty()) {
        throw Error(
            verbatim(fmt::format("{}: too short to measure; a log of {} scans or more is needed",
                                 session.configuration().source.file, kSliceSteps)));
    }
    const double cost = 1.0 - speed(figures.shown) / speed(figures.bare);
    const double usual = 1.0 - 1.0 / quantile(figures.slowdowns, 0.5);
    const double bare_work = figures.bare.work_seconds / static_cast<double>(figures.bare.steps);
    const double work = figures.shown.work_seconds / static_cast<double>(figures.shown.steps);
    const double own = figures.shown.window_seconds / static_cast<double>(figures.shown.steps);
    const double pictures = figures.pictures / figures.shown.seconds;
    const double slowest_ms = quantile(figures.answers_ms, 1.0);
    fmt::print("{} steps each, in turns of {}: {:.1f} steps/s without the window, {:.1f} with it\n",
               figures.shown.steps, kSliceSteps, speed(figures.bare), speed(figures.shown));
    if (cost < 0.0) {
        fmt::print("the window costs nothing that can be measured (limit {:.0f} %)\n",
                   100.0 * kGreatestCost);
    } else {
        fmt::print(
            "the window costs {:.1f} % of the speed, {:.1f} % in the median turn (limit {:.0f} "
            "%)\n",
            100.0 * cost, 100.0 * usual, 100.0 * kGreatestCost);
    }
    fmt::print(
        "processor time of a step: {:.2f} ms without the window, {:.2f} ms with it ({:+.1f} %), "
        "{:.2f} ms of it in the window's thread\n",
        1e3 * bare_work, 1e3 * work, 100.0 * (work / bare_work - 1.0), 1e3 * own);
    fmt::print("{:.1f} pictures/s of each view (limit {:.0f})\n", pictures, kMostPictures);
    fmt::print(
        "input answered after {:.2f} ms (median), {:.2f} ms (99 %), {:.2f} ms (slowest of {}; "
        "limit {:.0f} ms)\n",
        quantile(figures.answers_ms, 0.5), quantile(figures.answers_ms, 0.99), slowest_ms,
        figures.answers_ms.size(), kSlowestAnswerMs);
    const Jumps jumps = measure_jumps(session);
    const double jump_ms = 1e3 * quantile(jumps.seconds, 1.0);
    const double kept_mb = static_cast<double>(jumps.checkpoint_bytes) / 1e6;
    // The limit is for that many; more particles take longer.
    const bool jumps_count = session.configuration().filter.particles <= kParticlesOfJumps;
    fmt::print(
        "jumps to {} scans at random: {:.0f} ms (median), {:.0f} ms (slowest; limit {:.0f} ms up "
        "to {} particles)\n",
        jumps.seconds.size(), 1e3 * quantile(jumps.seconds, 0.5), jump_ms, kSlowestJumpMs,
        kParticlesOfJumps);
    fmt::print("checkpoints hold {:.0f} MB (limit {:.0f} MB)\n", kept_mb, kMostKeptMb);
    const bool good = cost < kGreatestCost && pictures <= kMostPictures &&
                      slowest_ms < kSlowestAnswerMs && kept_mb < kMostKeptMb &&
                      (!jumps_count || jump_ms < kSlowestJumpMs);
    fmt::print("{}\n", good ? "good" : "TOO MUCH");
    return good ? 0 : 1;
}

}  // namespace hitos::window
