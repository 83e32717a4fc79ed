// SPDX-License-Identifier: GPL-3.0-or-later
// How soon the window's event loop answers.
#pragma once

#include <QCoreApplication>
#include <QObject>
#include <chrono>
#include <thread>
#include <vector>

namespace hitos::window {

constexpr double kSlowestAnswerMs = 50.0;

using Clock = std::chrono::steady_clock;

inline double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// A thread asks the window's event loop, as a key press would, and notes when it answers.
class Probe {
  public:
    Probe()
        : thread_([this](const std::stop_token& stop) {
              constexpr auto kPause = std::chrono::milliseconds(5);
              while (!stop.stop_requested()) {
                  const auto asked = Clock::now();
                  QMetaObject::invokeMethod(
                      &window_,
                      [this, asked] { answers_ms_.push_back(seconds_since(asked) * 1e3); },
                      Qt::QueuedConnection);
                  std::this_thread::sleep_for(kPause);
              }
          }) {}

    std::vector<double> finish() {
        thread_.request_stop();
        thread_.join();
        QCoreApplication::processEvents();
        return answers_ms_;
    }

  private:
    QObject window_;                  // lives in the window's thread
    std::vector<double> answers_ms_;  // only touched by the window's thread until it is over
    std::jthread thread_;
};

}  // namespace hitos::window
