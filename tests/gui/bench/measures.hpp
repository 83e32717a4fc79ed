// SPDX-License-Identifier: GPL-3.0-or-later
// How much the window costs, how fast it answers (with a large graph too), how soon a log's
// first scan is there, and how late a driven robot's scans are mapped.
#pragma once

#include <cstddef>
#include <vector>

namespace hitos::window {

class MainWindow;
struct CommandLine;
class Session;

/// Of ascending numbers; 0 where there are none.
inline double quantile(const std::vector<double>& ascending, double part) {
    if (ascending.empty()) return 0.0;
    return ascending[static_cast<std::size_t>(part * static_cast<double>(ascending.size() - 1))];
}

/// Runs the session's log with and without the window, in turns, and prints steps per second,
/// pictures per second and how late input was answered. Returns the exit code: 0 where every answer
/// came within 50 ms, no view was drawn more than 60 times a second, and the window took less than
/// a tenth of the speed. Throws hitos::Error where the log is too short.
int measure_cost(MainWindow& window, Session& session);

/// Drives the robot through the session's world, from way point to way point, `pace` times as fast
/// as a clock, and prints how long after it was made each scan was in the map. Returns the exit
/// code: 0 where every scan came within 50 ms and the pace was kept. Throws hitos::Error where the
/// session has no world.
int measure_lateness(MainWindow& window, Session& session, int pace);

/// Opens the log that the line names and prints how soon its first scan stands in the views, how
/// long the survey of the whole takes behind that, and how late input was answered meanwhile.
/// Returns the exit code: 0 where the first scan was there within half a second.
int measure_opening(MainWindow& window, const CommandLine& line);

/// Opens a made graph of so many poses in a window of its own, changes it by hand, solves it
/// plainly and robustly and zooms, and prints how late input was answered meanwhile. Returns the
/// exit code: 0 where every answer came within 50 ms.
int measure_graph(MainWindow& window, int poses);

}  // namespace hitos::window
