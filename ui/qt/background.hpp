// Work beside the window.
#pragma once

#include <future>

namespace hitos::window {

/// Lowers the priority of this thread, and of the threads that it starts from now on, a little
/// below the window's: where all processors are busy, a key press is answered first. Work that has
/// the machine to itself is as fast as before.
void let_the_window_go_first();

/// Calls `make` on a thread of that priority, so that what it makes works at it, and waits for it.
template <class Make>
auto in_background(Make make) {
    return std::async(std::launch::async,
                      [&make] {
                          let_the_window_go_first();
                          return make();
                      })
        .get();
}

}  // namespace hitos::window
