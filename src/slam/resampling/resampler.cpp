#include "hitos/slam/resampler.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "methods.hpp"

namespace hitos {

void normalize_log_weights(std::span<const double> log_weights, std::vector<double>& weights) {
    weights.resize(log_weights.size());
    double greatest = -std::numeric_limits<double>::infinity();
    for (const double value : log_weights) {
        if (std::isfinite(value)) greatest = std::max(greatest, value);
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        weights[i] = std::isfinite(log_weights[i]) ? std::exp(log_weights[i] - greatest) : 0.0;
        sum += weights[i];
    }
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
