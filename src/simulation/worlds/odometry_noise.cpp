// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/simulation/worlds/odometry_noise.hpp"

#include <cmath>
#include <string_view>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/base/random_stream.hpp"

namespace hitos {

OdometryNoiseKind parse_noise_kind(std::string_view word, const std::string& option) {
    std::vector<std::string_view> words;
    for (std::size_t i = 0; i < kOdometryNoiseKinds.size(); ++i) {
        if (kOdometryNoiseKinds[i].word == word) return static_cast<OdometryNoiseKind>(i);
        words.push_back(kOdometryNoiseKinds[i].word);
    }
    throw ConfigError(option, HITOS_TEXT("Errors", "found \"%1\", expected %2"), word,
                      either(words));
}

std::string noise_kind_choices() {
    std::string text;
    for (const OdometryNoiseFacts& kind : kOdometryNoiseKinds) {
        if (!text.empty()) text += "; ";
        text.append(kind.word).append(": ").append(kind.meaning);
    }
    return text;
}

OdometryNoise::OdometryNoise(double level, OdometryNoiseKind kind, std::uint64_t seed)
    : level_(level), kind_(kind), seed_(seed) {
    if (!(level >= 0.0) || !std::isfinite(level)) {
        throw ConfigError("odometry noise",
                          HITOS_TEXT("Errors", "found %1, expected a number of 0 or more"),
                          std::to_string(level));
    }
}

Odometria OdometryNoise::operator()(const Odometria& reading, double level) {
    const std::uint64_t number = count_++;
    if (level == 0.0) return reading;
    RandomStream random(seed_, RandomPurpose::odometry_noise, number, 0);
    const auto [n_v, n_w] = random.normal_pair();
    const auto sigma = [this, level](double velocity) {
        return kind_ == OdometryNoiseKind::relative_sigma ? level * std::abs(velocity)
                                                          : std::sqrt(level * std::abs(velocity));
    };
    Odometria noisy = reading;
    noisy.twist.v += n_v * sigma(reading.twist.v);
    noisy.twist.w += n_w * sigma(reading.twist.w);
    if (reading.twist.v != 0.0) noisy.twist.v_lateral *= noisy.twist.v / reading.twist.v;
    return noisy;
}

}  // namespace hitos
