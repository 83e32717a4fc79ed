// SPDX-License-Identifier: GPL-3.0-or-later
// Noise on odometry, as the thesis adds it to simulated tours [T 10.2].
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "hitos/base/translatable.hpp"
#include "hitos/capture/scan.hpp"

namespace hitos {

/// How the thesis's "0.1" is read.
enum class OdometryNoiseKind {
    relative_sigma,  ///< standard deviation = level * |velocity|: gives the thesis's results
    variance         ///< variance = level * |velocity|: the thesis's wording
};

/// What is said of a kind.
struct OdometryNoiseFacts {
    std::string_view word;
    std::string_view label;    ///< translated in the context "ParameterChoice"
    std::string_view meaning;  ///< for help texts
};

/// In the enum's order.
inline constexpr std::array kOdometryNoiseKinds = {
    OdometryNoiseFacts{"relative-sigma", HITOS_TEXT("ParameterChoice", "σ = level · speed"),
                       "sigma = level |v|"},
    OdometryNoiseFacts{"variance", HITOS_TEXT("ParameterChoice", "σ² = level · speed"),
                       "variance = level |v|"}};

/// The kind of that word. Throws ConfigError, under the name of the option, that lists the words.
OdometryNoiseKind parse_noise_kind(std::string_view word, const std::string& option);
/// "relative-sigma: sigma = level |v|; variance: variance = level |v|"
std::string noise_kind_choices();

/// Adds noise to the readings of one tour, in order: v + N(0, .), w + N(0, .). A reading at rest
/// stays at rest. The noise of reading k depends on the seed and k alone. A lateral velocity
/// (rounded poses) is scaled like v.
class OdometryNoise {
  public:
    /// level >= 0; 0 changes nothing. Throws ConfigError for another level.
    OdometryNoise(double level, OdometryNoiseKind kind, std::uint64_t seed);
    Odometria operator()(const Odometria& reading) { return (*this)(reading, level_); }
    /// The next reading with another level, of 0 or more.
    Odometria operator()(const Odometria& reading, double level);

  private:
    double level_;
    OdometryNoiseKind kind_;
    std::uint64_t seed_;
    std::uint64_t count_ = 0;
};

}  // namespace hitos
