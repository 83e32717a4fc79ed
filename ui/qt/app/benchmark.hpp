// How much the window costs, and how fast it answers.
#pragma once

#include <cstddef>
#include <vector>

#include "hitos/services/configuration/configuracion.hpp"

namespace hitos::window {

class MainWindow;
class Session;

/// Of ascending numbers; 0 where there are none.
inline double quantile(const std::vector<double>& ascending, double part) {
    if (ascending.empty()) return 0.0;
    return ascending[static_cast<std::size_t>(part * static_cast<double>(ascending.size() - 1))];
}

/// Runs the session's log with and without the window, in turns, and prints steps per second,
/// pictures per second and how late input was answered. Returns the exit code: 0 where every answer
/// came within 50 ms, no view was drawn more than 60 times a second, and the window took less than
/// a fifth of the speed. Throws hitos::Error where the log is too short.
int run_benchmark(MainWindow& window, Session& session);

}  // namespace hitos::window
