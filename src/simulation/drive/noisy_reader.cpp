// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/simulation/drive/noisy_reader.hpp"

#include <utility>

namespace hitos {
namespace {

class NoisyReader final : public TourReader {
  public:
    NoisyReader(std::unique_ptr<TourReader> reader, const OdometryNoise& noise)
        : fresh_noise_(noise), noise_(noise), reader_(std::move(reader)) {}

    std::optional<Scan> next_scan() override { return reader_->next_scan(); }
    std::optional<Odometria> next_odometry() override {
        const std::optional<Odometria> reading = reader_->next_odometry();
        return reading ? std::optional(noise_(*reading)) : std::nullopt;
    }
    void restart() override {
        reader_->restart();
        noise_ = fresh_noise_;
    }
    std::unique_ptr<TourReader> reopen() const override {
        return std::make_unique<NoisyReader>(reader_->reopen(), fresh_noise_);
    }
    const ReadReport& report() const override { return reader_->report(); }
    std::optional<double> progress() const override { return reader_->progress(); }
    std::string name() const override { return reader_->name(); }
    std::string format() const override { return reader_->format(); }
    ReadOptions options() const override { return reader_->options(); }
    std::vector<TourFinding> findings() const override { return reader_->findings(); }
    std::optional<Truth> truth() const override { return reader_->truth(); }

  private:
    OdometryNoise fresh_noise_;  // at the beginning of the tour
    OdometryNoise noise_;
    std::unique_ptr<TourReader> reader_;
};

}  // namespace

std::unique_ptr<TourReader> make_noisy_reader(std::unique_ptr<TourReader> reader, double level,
                                              OdometryNoiseKind kind, std::uint64_t seed) {
    return std::make_unique<NoisyReader>(std::move(reader), OdometryNoise(level, kind, seed));
}

}  // namespace hitos
