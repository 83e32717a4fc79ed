// Time that this thread was at work, which other programs on a busy machine do not lengthen.
#pragma once

#include <ctime>

namespace hitos::window {

inline double thread_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

}  // namespace hitos::window
