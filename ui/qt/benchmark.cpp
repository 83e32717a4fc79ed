#include "benchmark.hpp"

#include <fmt/core.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QTimer>
#include <algorithm>
#include <chrono>
#include <thread>
#include <vector>

#include "common/open_tour.hpp"
#include "grid_view.hpp"
#include "main_window.hpp"
#include "scan_view.hpp"
#include "session.hpp"
#include "thread_call.hpp"

namespace hitos::window {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kRounds = 2;
constexpr double kSlowestAnswerMs = 50.0;
constexpr double kGreatestCost = 0.2;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Steps per second of the whole log without any window.
double bare_speed(const Configuracion& configuration) {
    Algoritmo algoritmo(configuration, open_tour(configuration.source));
    const auto begin = Clock::now();
    algoritmo.run();
    algoritmo.wait();
    return static_cast<double>(algoritmo.progress().steps) / seconds_since(begin);
}

struct WindowFigures {
    double steps_per_second = 0.0;
    double pictures_per_second = 0.0;
    std::vector<double> answers_ms;  ///< sorted
};

/// A thread asks the window's event loop, as a key press would, and notes when it answers.
class Probe {
  public:
    Probe()
        : thread_([this](const std::stop_token& stop) {
              constexpr auto kPause = std::chrono::milliseconds(5);
              while (!stop.stop_requested()) {
                  const auto asked = Clock::now();
                  in_window_([this, asked] { answers_ms_.push_back(seconds_since(asked) * 1e3); });
                  std::this_thread::sleep_for(kPause);
              }
          }) {}

    std::vector<double> finish() {
        thread_.request_stop();
        thread_.join();
        QCoreApplication::processEvents();
        std::sort(answers_ms_.begin(), answers_ms_.end());
        return answers_ms_;
    }

  private:
    ThreadCall in_window_;
    std::vector<double> answers_ms_;  // only touched by the window's thread until it is over
    std::jthread thread_;
};

WindowFigures window_figures(MainWindow& window, Session& session) {
    WindowFigures out;
    session.restart();
    QCoreApplication::processEvents();
    int pictures = 0;
    const auto counting = QObject::connect(&window.grid_view(), &CanvasView::painted, &window,
                                           [&pictures] { ++pictures; });
    Probe probe;
    const auto begin = Clock::now();
    QEventLoop loop;
    const auto ending = QObject::connect(&session, &Session::progress_changed, &loop, [&] {
        if (session.progress().state == Progress::State::finished) loop.quit();
    });
    session.run();
    loop.exec();
    const double seconds = seconds_since(begin);
    out.answers_ms = probe.finish();
    QObject::disconnect(ending);
    QObject::disconnect(counting);
    out.steps_per_second = static_cast<double>(session.progress().steps) / seconds;
    out.pictures_per_second = pictures / seconds;
    return out;
}

double quantile(const std::vector<double>& sorted, double part) {
    if (sorted.empty()) return 0.0;
    const auto place = static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1));
    return sorted[place];
}

}  // namespace

int run_benchmark(MainWindow& window, Session& session) {
    window.show();
    QCoreApplication::processEvents();
    double bare = 0.0;
    double shown = 0.0;
    double slowest_ms = 0.0;
    for (int round = 1; round <= kRounds; ++round) {
        const double without = bare_speed(session.configuration());
        const WindowFigures with = window_figures(window, session);
        fmt::print(
            "round {}: {:.1f} steps/s without the window, {:.1f} with it ({:+.1f} %); {:.1f} "
            "pictures/s; input answered after {:.2f} ms (median), {:.2f} ms (99 %), {:.2f} ms "
            "(slowest of {})\n",
            round, without, with.steps_per_second, 100.0 * (with.steps_per_second / without - 1.0),
            with.pictures_per_second, quantile(with.answers_ms, 0.5),
            quantile(with.answers_ms, 0.99), quantile(with.answers_ms, 1.0),
            with.answers_ms.size());
        std::fflush(stdout);
        bare += without;
        shown += with.steps_per_second;
        slowest_ms = std::max(slowest_ms, quantile(with.answers_ms, 1.0));
    }
    const double cost = 1.0 - shown / bare;
    const bool good = cost < kGreatestCost && slowest_ms < kSlowestAnswerMs;
    fmt::print(
        "the window costs {:.1f} % of the speed (limit {:.0f} %), slowest answer {:.1f} ms "
        "(limit {:.0f} ms): {}\n",
        100.0 * cost, 100.0 * kGreatestCost, slowest_ms, kSlowestAnswerMs,
        good ? "good" : "TOO MUCH");
    return good ? 0 : 1;
}

}  // namespace hitos::window
