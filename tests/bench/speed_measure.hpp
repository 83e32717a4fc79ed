// SPDX-License-Identifier: GPL-3.0-or-later
// Clocks, counters and the lines on stdout of the bench of speed.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace speed {

/// What the program was asked for; a workload reads what concerns it.
struct Options {
    std::string log;       ///< instead of the workload's own
    int particles = 100;   ///< of FastSLAM
    int threads = 1;       ///< of FastSLAM
    int landmarks = 1000;  ///< of a field
    int warm = 300;        ///< scans that a tour's filter gets before the clock starts
    int scans = 0;         ///< of a tour that are measured, 0: all that are left
    int steps = 200;       ///< in a field that are measured at a time
    double seconds = 1.0;  ///< how long a measurement is repeated
    bool count = false;    ///< memory instead of time
};

/// A line `name value unit`.
void print(std::string_view name, double value, std::string_view unit);

/// What the processor counts, where it lets programs read it.
struct Event {
    std::string_view name;
    std::uint64_t config;
};
inline constexpr std::size_t kEvents = 4;

/// What a piece of work took.
struct Cost {
    double wall_s = 0.0;
    double cpu_s = 0.0;  ///< of all threads
    std::array<std::optional<double>, kEvents> events;
};

/// Does the work again and again for about so long, at least once, each time after `prepare`, which
/// is not measured. Gives the cheapest: what other programs on the machine take comes on top.
Cost cheapest(double seconds, const std::function<void()>& prepare,
              const std::function<void()>& work);

/// Prints the cost of one of `count` equal parts of the work, in microseconds and in events.
void print_per(const Cost& cost, double count, std::string_view part);

/// The compiler must believe that the value is used.
template <class T>
void keep(const T& value) {
    asm volatile("" : : "r"(&value) : "memory");
}

/// What programs have asked of malloc, which everything on the heap comes from in the end.
struct MemoryCount {
    std::int64_t allocations = 0;
    std::int64_t live_bytes = 0;  ///< as malloc gives them, since counting began
    std::int64_t peak_bytes = 0;
};

/// False where a sanitizer has its own malloc.
bool can_count_memory();
void start_counting_memory();
MemoryCount counted_memory();

}  // namespace speed
