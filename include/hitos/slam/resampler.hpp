// When and how particles are resampled [T 6.3].
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "hitos/slam/params.hpp"

namespace hitos {

/// exp(log_weight - greatest), normalised to sum 1. Where no weight is finite all become equal.
void normalize_log_weights(std::span<const double> log_weights, std::vector<double>& weights);

/// Effective number of particles, 1 / sum of squares of normalised weights [T eq 6.14, table 6.4].
double effective_particles(std::span<const double> weights);

/// Low-variance (systematic) selection [T table 6.2]: which particle each of M new ones copies, in
/// ascending order; `start` in [0, 1) is the draw r in units of 1/M. The weights sum to 1.
void low_variance_selection(std::span<const double> weights, double start,
                            std::vector<std::uint32_t>& selected);

/// Decides when; the method is low-variance selection.
class Resampler {
  public:
    virtual ~Resampler() = default;
    virtual bool wants(double neff) const = 0;
};

/// Always [T 6.4].
class ResamplerNoNeff final : public Resampler {
  public:
    bool wants(double /*neff*/) const override { return true; }
};

/// When fewer than a threshold of particles are effective [T 6.4].
class ResamplerNeff final : public Resampler {
  public:
    explicit ResamplerNeff(double threshold) : threshold_(threshold) {}
    bool wants(double neff) const override { return neff < threshold_; }

  private:
    double threshold_;
};

std::unique_ptr<Resampler> make_resampler(const ResamplingParams& params);

}  // namespace hitos
