// SPDX-License-Identifier: GPL-3.0-or-later
// Walks that the resampling methods share.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "hitos/base/random_stream.hpp"

namespace hitos {

/// Weights laid end to end, `weight(i)` for i below `count`; finds in whose stretch a place lies.
/// Places are asked for in ascending order, so that a walk over all costs one pass.
template <class Weight>
class CumulatedWeights {
  public:
    CumulatedWeights(std::size_t count, const Weight& weight)
        : weight_(weight), last_(count - 1), cumulated_(weight(0)) {
        while (last_ > 0 && !(weight_(last_) > 0.0)) --last_;
    }
    std::uint32_t at(double place) {
        // The bound: rounding may leave the last cumulated weight a little below their sum.
        while (place > cumulated_ && i_ < last_) cumulated_ += weight_(++i_);
        return static_cast<std::uint32_t>(i_);
    }

  private:
    const Weight& weight_;
    std::size_t last_;  ///< the last that weighs anything
    std::size_t i_ = 0;
    double cumulated_;
};

/// A draw from each M-th part of the weights: draw(), in [0, 1), says where in its part.
template <class Draw>
void select_from_parts(std::span<const double> weights, Draw draw,
                       std::vector<std::uint32_t>& selected) {
    const std::size_t count = weights.size();
    selected.resize(count);
    const double spacing = 1.0 / static_cast<double>(count);
    const auto weight = [&](std::size_t i) { return weights[i]; };
    CumulatedWeights walk(count, weight);
    for (std::size_t m = 0; m < count; ++m) {
        selected[m] = walk.at((draw() + static_cast<double>(m)) * spacing);
    }
}

/// n independent uniform draws in (0, 1) in ascending order, one after the other: the least of n is
/// distributed as 1 - u^(1/n), and the others are uniform in what it leaves (Bentley and Saxe,
/// 1980, "Generating sorted lists of random numbers").
class AscendingDraws {
  public:
    AscendingDraws(std::size_t count, RandomStream& random) : left_(count), random_(random) {}
    double next() {
        const double part = -std::expm1(std::log(random_.uniform()) / static_cast<double>(left_--));
        at_ += (1.0 - at_) * part;
        return at_;
    }

  private:
    std::size_t left_;
    RandomStream& random_;
    double at_ = 0.0;
};

}  // namespace hitos
