// Noise on odometry, as the thesis adds it to simulated tours [T 10.2].
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "hitos/capture/scan.hpp"

namespace hitos {

/// How the thesis's "0.1" is read.
enum class OdometryNoiseKind {
    relative_sigma,  ///< standard deviation = level * |velocity|: gives the thesis's results
    variance         ///< variance = level * |velocity|: the thesis's wording
};

/// The words of the kinds, in the enum's order.
inline constexpr std::array<std::string_view, 2> kOdometryNoiseWords = {"relative-sigma",
                                                                        "variance"};

/// Adds noise to the readings of one tour, in order: v + N(0, .), w + N(0, .). A reading at rest
/// stays at rest. The noise of reading k depends on the seed and k alone. A lateral velocity
/// (rounded poses) is scaled like v.
class OdometryNoise {
  public:
    /// level >= 0; 0 changes nothing. Throws ConfigError for another level.
    OdometryNoise(double level, OdometryNoiseKind kind, std::uint64_t seed);
    Odometria operator()(const Odometria& reading);

  private:
    double level_;
    OdometryNoiseKind kind_;
    std::uint64_t seed_;
    std::uint64_t count_ = 0;
};

}  // namespace hitos
