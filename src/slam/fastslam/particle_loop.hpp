// SPDX-License-Identifier: GPL-3.0-or-later
// Loops over particles, in parallel where that pays.
#pragma once

#include <algorithm>
#include <cstddef>

#include "hitos/base/thread_crew.hpp"

namespace hitos {

/// The threads of a filter. Bodies must not depend on each other.
class ParticleLoop {
  public:
    /// `threads` 0: as many as the machine has.
    explicit ParticleLoop(int threads) : crew_(threads) {}

    /// Particles that are worked on together, so that what is done with them becomes vectors and
    /// stays in the cache.
    static constexpr std::size_t kBlock = 64;
    static constexpr std::size_t kLeast = 16;  ///< in several threads

    /// Whether so much work is worth more than one thread.
    bool parallel(std::size_t count, std::size_t work_each) const {
        return crew_.threads() > 1 && count > kLeast && count * work_each >= kParallelWork;
    }
    /// How many particles are worked on together: fewer where threads would have nothing to do.
    std::size_t block(std::size_t count, std::size_t work_each) const {
        if (!parallel(count, work_each)) return kBlock;
        const auto pieces = 2 * crew_.threads();
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
            crew_(all, of_block);
        } else {
            for (std::size_t number = 0; number < all; ++number) of_block(number);
        }
    }

  private:
    /// Below this many particle x landmark x observation evaluations a run gains nothing from a
    /// second thread, which waits for the next step at the cost of a processor.
    static constexpr std::size_t kParallelWork = 100000;

    ThreadCrew crew_;
};

}  // namespace hitos
