// SPDX-License-Identifier: GPL-3.0-or-later
// The resampling methods that Hitos brings along, one file each; Douc, Cappé and Moulines (2005,
// "Comparison of resampling schemes for particle filtering") compare them.
#pragma once

#include "hitos/slam/resampler.hpp"

namespace hitos {

using Selection = void (*)(std::span<const double> weights, RandomStream& random,
                           std::vector<std::uint32_t>& selected);
/// The entry of a method that is this function and reads no parameters.
ResamplingMethodEntry selecting(RegistryEntry words, Selection selection);

ResamplingMethodEntry low_variance_resampling();
ResamplingMethodEntry stratified_resampling();
ResamplingMethodEntry residual_resampling();
ResamplingMethodEntry multinomial_resampling();

/// Low-variance (systematic) selection [T table 6.2] with `start` in [0, 1), the draw r in units of
/// 1/M.
void low_variance_selection(std::span<const double> weights, double start,
                            std::vector<std::uint32_t>& selected);

}  // namespace hitos
