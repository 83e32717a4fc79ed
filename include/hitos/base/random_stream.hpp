// SPDX-License-Identifier: GPL-3.0-or-later
// Counter-based random numbers: the draw is a function of (seed, purpose, step, index), so results
// do not depend on the number or the order of threads.
#pragma once

#include <Random123/philox.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "hitos/base/elementary.hpp"

namespace hitos {

/// What a stream is for; streams of different purposes never overlap.
enum class RandomPurpose : std::uint32_t {
    motion = 1,
    resampling = 2,
    odometry_noise = 3,
    laser_noise = 4,
    line_sampling = 5,
    association = 6
};

/// Two draws that come together.
struct NormalPair {
    double one;
    double other;
};

/// Two independent standard normal draws of two uniform ones in (0, 1) (Box and Muller, 1958).
HITOS_INLINE NormalPair normal_pair(double u0, double u1) {
    const double radius = std::sqrt(-2.0 * elementary::log(u0));
    const auto [sine, cosine] = elementary::sine_cosine(2.0 * std::numbers::pi * u1);
    return {radius * cosine, radius * sine};
}

/// Philox4x32-10 (Salmon et al., SC11) keyed by seed and addressed by purpose, step and index.
/// Reproducible on every machine.
class RandomStream {
  public:
    RandomStream(std::uint64_t seed, RandomPurpose purpose, std::uint64_t step, std::uint32_t index)
        : key_{{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}},
          counter_{{0, index, static_cast<std::uint32_t>(step),
                    static_cast<std::uint32_t>(step >> 32) ^
                        (static_cast<std::uint32_t>(purpose) << 24)}} {}

    /// Uniform in (0, 1), 2^-33 away from both ends at the least.
    double uniform() { return (static_cast<double>(next()) + 0.5) * 0x1p-32; }

    /// Two independent standard normal draws.
    std::array<double, 2> normal_pair() {
        const double u0 = uniform();
        const auto [one, other] = hitos::normal_pair(u0, uniform());
        return {one, other};
    }

    /// 32 random bits.
    std::uint32_t next() {
        if (used_ == block_.size()) {
            block_ = r123::Philox4x32{}(counter_, key_);
            ++counter_[0];
            used_ = 0;
        }
        return block_[used_++];
    }

    /// For those who draw from many streams at once.
    const r123::Philox4x32::ctr_type& counter() const { return counter_; }
    const r123::Philox4x32::key_type& key() const { return key_; }

  private:
    r123::Philox4x32::key_type key_;
    r123::Philox4x32::ctr_type counter_;
    r123::Philox4x32::ctr_type block_{};
    std::size_t used_ = 4;
};

}  // namespace hitos
