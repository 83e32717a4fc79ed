// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/simulation/drive/noisy_reader.hpp"

#include <utility>

#include "hitos/capture/derived_tour.hpp"

namespace hitos {
namespace {

class NoisyReader final : public DerivedTour {
  public:
    NoisyReader(std::unique_ptr<TourReader> reader, const OdometryNoise& noise)
        : DerivedTour(std::move(reader)), fresh_noise_(noise), noise_(noise) {}

    std::optional<Odometria> next_odometry() override {
        const std::optional<Odometria> reading = tour().next_odometry();
        return reading ? std::optional(noise_(*reading)) : std::nullopt;
    }
    void restart() override {
        tour().restart();
        noise_ = fresh_noise_;
    }
    std::unique_ptr<TourReader> reopen() const override {
        return std::make_unique<NoisyReader>(tour().reopen(), fresh_noise_);
    }

  private:
    OdometryNoise fresh_noise_;  // at the beginning of the tour
    OdometryNoise noise_;
};

}  // namespace

std::unique_ptr<TourReader> make_noisy_reader(std::unique_ptr<TourReader> reader, double level,
                                              OdometryNoiseKind kind, std::uint64_t seed) {
    return std::make_unique<NoisyReader>(std::move(reader), OdometryNoise(level, kind, seed));
}

}  // namespace hitos
