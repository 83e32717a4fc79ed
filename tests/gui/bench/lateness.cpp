// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <QElapsedTimer>
#include <QEventLoop>
#include <QTimer>
#include <algorithm>
#include <chrono>
#include <thread>
#include <vector>

#include "app/main_window.hpp"
#include "hitos/base/error.hpp"
#include "measures.hpp"
#include "session/session.hpp"
#include "world/live_drive.hpp"
#include "world/world_window.hpp"

namespace hitos::window {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kLatestMs = 50.0;
constexpr double kLeastPace = 0.98;
constexpr int kWallSeconds = 30;

/// When the run had come to each scan.
class Watch {
  public:
    explicit Watch(const RunWorker& worker)
        : thread_([this, &worker](const std::stop_token& stop) {
              constexpr auto kPause = std::chrono::microseconds(500);
              while (!stop.stop_requested()) {
                  const std::uint64_t steps = worker.progress().steps;
                  const auto now = Clock::now();
                  while (done_.size() < steps) done_.push_back(now);
                  std::this_thread::sleep_for(kPause);
              }
          }) {}
    std::vector<Clock::time_point> finish() {
        thread_.request_stop();
        thread_.join();
        return done_;
    }

  private:
    std::vector<Clock::time_point> done_;  // touched by the thread alone until it is over
    std::jthread thread_;
};

}  // namespace

int measure_lateness(MainWindow& window, Session& session, int pace) {
    const std::string file = session.configuration().source.file;
    if (!is_world_file(file)) {
        throw Error(verbatim(file + ": is no world to drive a robot through"));
    }
    const std::vector<WayPoint> way = read_world(file).tour.way_points;
    if (way.empty()) throw Error(verbatim(file + ": has no way points to drive along"));
    window.show();
    WorldWindow& world = window.open_world_window();
    world.drive_through(QString::fromStdString(file));
    LiveDrive& drive = world.drive();
    if (!drive.active()) return 1;  // it has said why
    drive.set_pace(pace);
    std::vector<Clock::time_point> made;
    std::size_t next = 0;
    QObject::connect(&drive, &LiveDrive::moved, &drive, [&] {
        const auto now = Clock::now();
        while (made.size() < drive.tour()->scans()) made.push_back(now);
        if (!drive.goal()) drive.set_goal(way[next++ % way.size()].at);
    });
    Watch watch(*session.worker());
    const double tour_before_s = drive.tour()->duration_s();
    QElapsedTimer clock;
    clock.start();
    QEventLoop loop;
    QTimer::singleShot(kWallSeconds * 1000, &loop, &QEventLoop::quit);
    loop.exec();
    const double kept = (drive.tour()->duration_s() - tour_before_s) /
                        (1e-3 * static_cast<double>(clock.elapsed()) * pace);
    drive.rest();
    constexpr int kLastMs = 500;  // for what was made a moment ago
    QTimer::singleShot(kLastMs, &loop, &QEventLoop::quit);
    loop.exec();
    const std::vector<Clock::time_point> done = watch.finish();
    drive.give_up();
    std::vector<double> late_ms;
    for (std::size_t k = 0; k < std::min(made.size(), done.size()); ++k) {
        late_ms.push_back(std::chrono::duration<double, std::milli>(done[k] - made[k]).count());
    }
    if (late_ms.empty()) throw Error(verbatim(file + ": no scan was made"));
    std::ranges::sort(late_ms);
    fmt::print(
        "{} particles, {} times as fast as a clock: {} of {} scans in the map, {:.1f} ms (median), "
        "{:.1f} ms (99 %), {:.1f} ms (latest; limit {:.0f} ms) after they were made; {:.1f} % of "
        "the pace\n",
        session.configuration().filter.particles, pace, done.size(), made.size(),
        quantile(late_ms, 0.5), quantile(late_ms, 0.99), late_ms.back(), kLatestMs, 100.0 * kept);
    const bool good =
        done.size() == made.size() && late_ms.back() <= kLatestMs && kept >= kLeastPace;
    fmt::print("{}\n", good ? "good" : "TOO LATE");
    return good ? 0 : 1;
}

}  // namespace hitos::window
