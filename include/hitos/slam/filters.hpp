// SPDX-License-Identifier: GPL-3.0-or-later
// The SLAM algorithms and their factories.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>

#include "hitos/base/registry.hpp"
#include "hitos/slam/params.hpp"
#include "hitos/slam/slam_filter.hpp"

namespace hitos {

/// An algorithm as parameters name it.
struct SlamAlgorithmEntry : RegistryEntry {
    /// `threads` 0: as many as the machine has. make_filter() has checked the ranges.
    std::function<std::unique_ptr<SlamFilter>(const FilterParams&, std::uint64_t seed, int threads)>
        make;
    bool registered = false;  ///< reads SlamInput::registered, whatever the motion model
};

/// Those that the program knows: "fastslam", FastSLAM 1.0 [T table 3.2]; "ekf-slam" [P 4, 5], which
/// draws nothing at random and works on the caller's thread; and what was added.
Registry<SlamAlgorithmEntry>& slam_algorithms();

/// The algorithm that `params.algorithm` names, as its entry makes it. Throws ConfigError for
/// values out of range or impossible together.
std::unique_ptr<SlamFilter> make_filter(const FilterParams& params, std::uint64_t seed,
                                        int threads);

/// Whether the algorithm, with its motion model, asks for registration.
bool needs_registration(const FilterParams& params);

/// How many hypotheses the algorithm that the parameters name will have: its particles, or one.
std::size_t hypothesis_count(const FilterParams& params);

}  // namespace hitos
