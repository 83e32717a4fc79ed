// Counter-based random numbers: the draw is a function of (seed, purpose, step, index), so results
// do not depend on the number or the order of threads.
#pragma once

#include <Random123/philox.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

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

/// Philox4x32-10 (Salmon et al., SC11) keyed by seed and addressed by purpose, step and index.
/// Reproducible on every machine up to the last bit of the C library's log, sin and cos.
class RandomStream {
  public:
    RandomStream(std::uint64_t seed, RandomPurpose purpose, std::uint64_t step, std::uint32_t index)
        : key_{{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}},
          counter_{{0, index, static_cast<std::uint32_t>(step),
                    static_cast<std::uint32_t>(step >> 32) ^
                        (static_cast<std::uint32_t>(purpose) << 24)}} {}

    /// Uniform in (0, 1), 2^-33 away from both ends at the least.
    double uniform() { return (static_cast<double>(next()) + 0.5) * 0x1p-32; }

    /// Two independent standard normal draws (Box and Muller, 1958).
    std::array<double, 2> normal_pair() {
        const double radius = std::sqrt(-2.0 * std::log(uniform()));
        const double angle = 2.0 * std::numbers::pi * uniform();
        return {radius * std::cos(angle), radius * std::sin(angle)};
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

  private:
    r123::Philox4x32::key_type key_;
    r123::Philox4x32::ctr_type counter_;
    r123::Philox4x32::ctr_type block_{};
    std::size_t used_ = 4;
};

}  // namespace hitos
