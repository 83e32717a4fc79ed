// How late the scans of a driven robot are mapped.
#pragma once

namespace hitos::window {

class MainWindow;
class Session;

/// Drives the robot through the session's world, from way point to way point, `pace` times as fast
/// as a clock, and prints how long after it was made each scan was in the map. Returns the exit
/// code: 0 where every scan came within 50 ms and the pace was kept. Throws hitos::Error where the
/// session has no world.
int run_drive_benchmark(MainWindow& window, Session& session, int pace);

}  // namespace hitos::window
