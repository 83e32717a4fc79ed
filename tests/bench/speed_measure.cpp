// SPDX-License-Identifier: GPL-3.0-or-later
#include "speed_measure.hpp"

#include <fmt/format.h>
#include <linux/perf_event.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <ctime>

namespace speed {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::array<Event, kEvents> kCounted = {{
    {"cycles", PERF_COUNT_HW_CPU_CYCLES},
    {"instructions", PERF_COUNT_HW_INSTRUCTIONS},
    {"branch_misses", PERF_COUNT_HW_BRANCH_MISSES},
    {"cache_misses", PERF_COUNT_HW_CACHE_MISSES},
}};

/// Counters of this process and of threads that it starts later.
class EventCounters {
  public:
    EventCounters() {
        for (std::size_t i = 0; i < kEvents; ++i) {
            perf_event_attr attributes{};
            attributes.type = PERF_TYPE_HARDWARE;
            attributes.size = sizeof attributes;
            attributes.config = kCounted[i].config;
            attributes.disabled = 1;
            attributes.inherit = 1;
            attributes.exclude_kernel = 1;
            attributes.exclude_hv = 1;
            files_[i] = static_cast<int>(syscall(SYS_perf_event_open, &attributes, 0, -1, -1, 0));
        }
    }
    ~EventCounters() {
        for (const int file : files_) {
            if (file >= 0) close(file);
        }
    }
    EventCounters(const EventCounters&) = delete;
    EventCounters& operator=(const EventCounters&) = delete;

    void start() {
        for (const int file : files_) {
            if (file < 0) continue;
            ioctl(file, PERF_EVENT_IOC_RESET, 0);
            ioctl(file, PERF_EVENT_IOC_ENABLE, 0);
        }
    }
    std::array<std::optional<double>, kEvents> stop() {
        std::array<std::optional<double>, kEvents> counts;
        for (std::size_t i = 0; i < kEvents; ++i) {
            if (files_[i] < 0) continue;
            ioctl(files_[i], PERF_EVENT_IOC_DISABLE, 0);
            std::uint64_t count = 0;
            if (read(files_[i], &count, sizeof count) == sizeof count) {
                counts[i] = static_cast<double>(count);
            }
        }
        return counts;
    }

  private:
    std::array<int, kEvents> files_{};
};

double cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

}  // namespace

void print(std::string_view name, double value, std::string_view unit) {
    fmt::print("{} {:.6g} {}\n", name, value, unit);
    std::fflush(stdout);
}

Cost cheapest(double seconds, const std::function<void()>& prepare,
              const std::function<void()>& work) {
    EventCounters events;
    std::optional<Cost> best;
    const Clock::time_point begin = Clock::now();
    do {
        prepare();
        Cost cost;
        events.start();
        const double cpu_before = cpu_seconds();
        const Clock::time_point before = Clock::now();
        work();
        cost.wall_s = seconds_since(before);
        cost.cpu_s = cpu_seconds() - cpu_before;
        cost.events = events.stop();
        if (!best || cost.wall_s < best->wall_s) best = cost;
    } while (seconds_since(begin) < seconds);
    return *best;
}

void print_per(const Cost& cost, double count, std::string_view part) {
    print(fmt::format("wall_per_{}", part), cost.wall_s * 1e6 / count, "us");
    print(fmt::format("cpu_per_{}", part), cost.cpu_s * 1e6 / count, "us");
    for (std::size_t i = 0; i < kEvents; ++i) {
        if (cost.events[i]) {
            print(fmt::format("{}_per_{}", kCounted[i].name, part), *cost.events[i] / count, "1");
        }
    }
}

}  // namespace speed
