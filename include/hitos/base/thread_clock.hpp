// SPDX-License-Identifier: GPL-3.0-or-later
// Time that this thread, or the whole program, was at work, which other programs on a busy machine
// do not lengthen.
#pragma once

#include <ctime>

namespace hitos {

inline double seconds_of(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

inline double thread_seconds() {
    return seconds_of(CLOCK_THREAD_CPUTIME_ID);
}

/// Of all threads together.
inline double process_seconds() {
    return seconds_of(CLOCK_PROCESS_CPUTIME_ID);
}

}  // namespace hitos
