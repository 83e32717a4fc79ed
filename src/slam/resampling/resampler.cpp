// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/slam/resampler.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "hitos/base/vectorised.hpp"
#include "methods.hpp"

namespace hitos {
namespace {

/// e^(log - greatest); 0 of what is not finite.
HITOS_INLINE void exponentials(const double* logs, double greatest, std::size_t count,
                               double* weights) {
    HITOS_LANES
    for (std::size_t i = 0; i < count; ++i) {
        const double below = logs[i] - greatest;
        weights[i] = below <= 0.0 ? elementary::exp(below) : 0.0;
    }
}

class Selecting final : public ResamplingMethod {
  public:
    explicit Selecting(Selection selection) : selection_(selection) {}
    void select(std::span<const double> weights, RandomStream& random,
                std::vector<std::uint32_t>& selected) const override {
        selection_(weights, random, selected);
    }

  private:
    Selection selection_;
};

}  // namespace

ResamplingMethodEntry selecting(RegistryEntry words, Selection selection) {
    return {std::move(words), [selection](const ResamplingParams&) {
                return std::make_unique<Selecting>(selection);
            }};
}

void normalize_log_weights(std::span<const double> log_weights, std::vector<double>& weights) {
    weights.resize(log_weights.size());
    double greatest = -std::numeric_limits<double>::infinity();
    for (const double value : log_weights) {
        if (std::isfinite(value)) greatest = std::max(greatest, value);
    }
    vectorised([&]() HITOS_INLINED {
        exponentials(log_weights.data(), greatest, weights.size(), weights.data());
    });
    double sum = 0.0;
    for (const double weight : weights) sum += weight;
    if (!(sum > 0.0)) {
        std::fill(weights.begin(), weights.end(), 1.0);
        sum = static_cast<double>(weights.size());
    }
    for (double& weight : weights) weight /= sum;
}

double effective_particles(std::span<const double> weights) {
    double squares = 0.0;
    for (const double weight : weights) squares += weight * weight;
    return 1.0 / squares;
}

std::unique_ptr<Resampler> make_resampler(const ResamplingParams& params) {
    if (params.rule == ResamplingRule::neff) {
        return std::make_unique<ResamplerNeff>(params.neff_threshold);
    }
    return std::make_unique<ResamplerNoNeff>();
}

Registry<ResamplingMethodEntry>& resampling_methods() {
    static Registry<ResamplingMethodEntry> registry(
        "resampling method", "resampling.method",
        {low_variance_resampling(), stratified_resampling(), residual_resampling(),
         multinomial_resampling()});
    return registry;
}

}  // namespace hitos
