// SPDX-License-Identifier: GPL-3.0-or-later
// Work beside the window.
#pragma once

#include <chrono>
#include <functional>
#include <future>

namespace hitos::window {

/// To be called first on a thread that computes beside the window; holds for the threads that it
/// starts from then on as well. Lowers the priority a little below the window's: where all
/// processors are busy, a key press is answered first; work that has the machine to itself is as
/// fast as before. And clears what the window's thread has left in the vector registers.
void begin_background_work();

/// Until `done` says so, which may wait that long. Where it takes its time the window is painted
/// meanwhile and timers go on; what somebody presses waits.
void wait_until(const std::function<bool(std::chrono::milliseconds)>& done);

/// Calls `make` on such a thread and waits for it: what it makes works beside the window.
template <class Make>
auto in_background(Make make) {
    auto made = std::async(std::launch::async, [&make] {
        begin_background_work();
        return make();
    });
    wait_until([&made](std::chrono::milliseconds at_most) {
        return made.wait_for(at_most) == std::future_status::ready;
    });
    return made.get();
}

}  // namespace hitos::window
