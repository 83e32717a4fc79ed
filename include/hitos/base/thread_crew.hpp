// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces of work that do not depend on each other, on several threads.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <cstddef>
#include <optional>
#include <thread>
#include <vector>

namespace hitos {

/// Threads that come as long as there is work for them, and wait between; one alone works in the
/// caller's.
class ThreadCrew {
  public:
    /// `threads` 0: as many as the machine has.
    explicit ThreadCrew(int threads) : arena_(threads > 0 ? threads : tbb::task_arena::automatic) {
        if (threads > tbb::info::default_concurrency()) {
            more_threads_.emplace(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads));
        }
    }

    std::size_t threads() const { return static_cast<std::size_t>(arena_.max_concurrency()); }

    /// Calls body(0 … count - 1), in any order and at once.
    template <class Body>
    void operator()(std::size_t count, const Body& body) {
#ifdef HITOS_THREAD_SANITIZER
        // The sanitizer cannot see how TBB, which is not built for it, hands work over. The same
        // bodies on threads that it knows show every race between them.
        std::atomic<std::size_t> next = 0;
        const auto work = [&] {
            for (std::size_t i = next++; i < count; i = next++) body(i);
        };
        std::vector<std::jthread> others;
        for (std::size_t i = 1; i < threads(); ++i) others.emplace_back(work);
        work();
#else
        arena_.execute([&] {
            tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count),
                              [&](const tbb::blocked_range<std::size_t>& range) {
                                  for (std::size_t i = range.begin(); i < range.end(); ++i) {
                                      body(i);
                                  }
                              });
        });
#endif
    }

  private:
    std::optional<tbb::global_control> more_threads_;  // where more than the machine has are asked
    tbb::task_arena arena_;
};

}  // namespace hitos
