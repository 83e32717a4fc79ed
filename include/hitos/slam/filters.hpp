// The factories of the SLAM algorithms.
#pragma once

#include <cstdint>
#include <memory>

#include "hitos/slam/params.hpp"
#include "hitos/slam/slam_filter.hpp"

namespace hitos {

/// The algorithm that `params.algorithm` names. `threads` 0: as many as the machine has. Throws
/// ConfigError for values out of range.
std::unique_ptr<SlamFilter> make_filter(const FilterParams& params, std::uint64_t seed,
                                        int threads);

/// FastSLAM 1.0 [T table 3.2].
std::unique_ptr<SlamFilter> make_fastslam(const FilterParams& params, std::uint64_t seed,
                                          int threads);

/// EKF-SLAM [P 4, 5]; it draws nothing at random and works on the caller's thread.
std::unique_ptr<SlamFilter> make_ekf_slam(const FilterParams& params);

}  // namespace hitos
