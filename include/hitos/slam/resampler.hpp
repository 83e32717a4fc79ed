// SPDX-License-Identifier: GPL-3.0-or-later
// When and how particles are resampled [T 6.3].
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "hitos/base/random_stream.hpp"
#include "hitos/base/registry.hpp"
#include "hitos/slam/params.hpp"

namespace hitos {

/// exp(log_weight - greatest), normalised to sum 1. Where no weight is finite all become equal.
void normalize_log_weights(std::span<const double> log_weights, std::vector<double>& weights);

/// Effective number of particles, 1 / sum of squares of normalised weights [T eq 6.14, table 6.4].
double effective_particles(std::span<const double> weights);

/// Decides when [T 9.2.4].
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

/// Decides which particles are copied, and how often. A method is unbiased: of M particles one of
/// weight w is copied M w times in the mean, and never where w is 0.
class ResamplingMethod {
  public:
    virtual ~ResamplingMethod() = default;
    /// Which particle each of M new ones copies, in ascending order; M is the number of `weights`,
    /// which sum to 1.
    virtual void select(std::span<const double> weights, RandomStream& random,
                        std::vector<std::uint32_t>& selected) const = 0;
};

/// A resampling method as parameters name it.
struct ResamplingMethodEntry : RegistryEntry {
    std::function<std::unique_ptr<ResamplingMethod>(const ResamplingParams&)> make;
};

/// Those that the program knows: "low-variance", "stratified", "residual", "multinomial" and what
/// was added.
Registry<ResamplingMethodEntry>& resampling_methods();

}  // namespace hitos
