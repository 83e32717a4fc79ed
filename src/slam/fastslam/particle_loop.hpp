// SPDX-License-Identifier: GPL-3.0-or-later
// Loops over particles, in parallel where that pays.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <optional>
#include <thread>
#include <vector>

namespace hitos {

/// The threads of a filter. Bodies must not depend on each other.
class ParticleLoop {
  public:
    /// `threads` 0: as many as the machine has.
    explicit ParticleLoop(int threads)
        : arena_(threads > 0 ? threads : tbb::task_arena::automatic) {
        if (threads > tbb::info::default_concurrency()) {
            more_threads_.emplace(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads));
        }
    }

    /// Particles that are worked on together, so that what is done with them becomes vectors and
    /// stays in the cache.
    static constexpr std::size_t kBlock = 64;
    static constexpr std::size_t kLeast = 16;  ///< in several threads

    /// Whether so much work is worth more than one thread.
    bool parallel(std::size_t count, std::size_t work_each) const {
        return arena_.max_concurrency() > 1 && count > kLeast && count * work_each >= kParallelWork;
    }
    /// How many particles are worked on together: fewer where threads would have nothing to do.
    std::size_t block(std::size_t count, std::size_t work_each) const {
        if (!parallel(count, work_each)) return kBlock;
        const auto pieces = 2 * static_cast<std::size_t>(arena_.max_concurrency());
        return std::clamp((count + pieces - 1) / pieces, kLeast, kBlock);
    }
    std::size_t blocks(std::size_t count, std::size_t work_each) const {
        const std::size_t size = block(count, work_each);
        return (count + size - 1) / size;
    }
    /// Calls body(number, begin, end) for each block of `count` particles.
    template <class Body>
    void operator()(std::size_t count, std::size_t work_each, const Body& body) {
        const std::size_t size = block(count, work_each);
        const auto of_block = [&](std::size_t number) {
            body(number, number * size, std::min(count, (number + 1) * size));
        };
        const std::size_t all = blocks(count, work_each);
        if (parallel(count, work_each)) {
            in_parallel(all, of_block);
        } else {
            for (std::size_t number = 0; number < all; ++number) of_block(number);
        }
    }

  private:
    /// Calls body(0 … count - 1).
    template <class Body>
    void in_parallel(std::size_t count, const Body& body) {
#ifdef HITOS_THREAD_SANITIZER
        // The sanitizer cannot see how TBB, which is not built for it, hands work over. The same
        // bodies on threads that it knows show every race between them.
        std::atomic<std::size_t> next = 0;
        const auto work = [&] {
            for (std::size_t i = next++; i < count; i = next++) body(i);
        };
        std::vector<std::jthread> others;
        for (int i = 1; i < arena_.max_concurrency(); ++i) others.emplace_back(work);
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

    /// Below this many particle x landmark x observation evaluations a step gains nothing from a
    /// second thread (measured with tests/bench).
    static constexpr std::size_t kParallelWork = 12000;

    std::optional<tbb::global_control> more_threads_;  // where more than the machine has are asked
    tbb::task_arena arena_;
};

}  // namespace hitos
