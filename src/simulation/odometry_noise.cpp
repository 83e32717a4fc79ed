#include "hitos/simulation/odometry_noise.hpp"

#include <cmath>

#include "hitos/base/error.hpp"
#include "hitos/base/random_stream.hpp"

namespace hitos {

OdometryNoise::OdometryNoise(double level, OdometryNoiseKind kind, std::uint64_t seed)
    : level_(level), kind_(kind), seed_(seed) {
    if (!(level >= 0.0) || !std::isfinite(level)) {
        throw ConfigError("odometry noise",
                          "found " + std::to_string(level) + ", expected a number of 0 or more");
    }
}

Odometria OdometryNoise::operator()(const Odometria& reading) {
    if (level_ == 0.0) return reading;
    RandomStream random(seed_, RandomPurpose::odometry_noise, count_++, 0);
    const auto [n_v, n_w] = random.normal_pair();
    const auto sigma = [this](double velocity) {
        return kind_ == OdometryNoiseKind::relative_sigma ? level_ * std::abs(velocity)
                                                          : std::sqrt(level_ * std::abs(velocity));
    };
    Odometria noisy = reading;
    noisy.twist.v += n_v * sigma(reading.twist.v);
    noisy.twist.w += n_w * sigma(reading.twist.w);
    if (reading.twist.v != 0.0) noisy.twist.v_lateral *= noisy.twist.v / reading.twist.v;
    return noisy;
}

}  // namespace hitos
