// Loops over particles, in parallel where that pays.
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

    /// Calls body(0 … count - 1), in parallel where the work is worth it.
    template <class Body>
    void operator()(std::size_t count, std::size_t work_each, const Body& body) {
        if (arena_.max_concurrency() == 1 || count * work_each < kParallelWork) {
            for (std::size_t i = 0; i < count; ++i) body(i);
            return;
        }
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
            tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, kGrain),
                              [&](const tbb::blocked_range<std::size_t>& range) {
                                  for (std::size_t i = range.begin(); i < range.end(); ++i) {
                                      body(i);
                                  }
                              });
        });
#endif
    }

  private:
    /// Below this many particle x landmark x observation evaluations a step gains nothing from a
    /// second thread (measured with tests/bench).
    static constexpr std::size_t kParallelWork = 30000;
    static constexpr std::size_t kGrain = 32;

    std::optional<tbb::global_control> more_threads_;  // where more than the machine has are asked
    tbb::task_arena arena_;
};

}  // namespace hitos
