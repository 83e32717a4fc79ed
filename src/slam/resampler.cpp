#include "hitos/slam/resampler.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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

void low_variance_selection(std::span<const double> weights, double start,
                            std::vector<std::uint32_t>& selected) {
    const std::size_t count = weights.size();
    selected.resize(count);
    const double spacing = 1.0 / static_cast<double>(count);
    std::size_t last = count - 1;  // the last that weighs anything
    while (last > 0 && weights[last] == 0.0) --last;
    std::size_t i = 0;
    double cumulated = weights[0];
    for (std::size_t m = 0; m < count; ++m) {
        const double u = (start + static_cast<double>(m)) * spacing;
        // The bound on i: rounding may leave the last cumulated weight a little below 1.
        while (u > cumulated && i < last) cumulated += weights[++i];
        selected[m] = static_cast<std::uint32_t>(i);
    }
}

std::unique_ptr<Resampler> make_resampler(const ResamplingParams& params) {
    if (params.rule == ResamplingRule::neff) {
        return std::make_unique<ResamplerNeff>(params.neff_threshold);
    }
    return std::make_unique<ResamplerNoNeff>();
}

}  // namespace hitos
