// The factory of SLAM algorithms.
#pragma once

#include <cstdint>
#include <memory>

#include "hitos/slam/params.hpp"
#include "hitos/slam/slam_filter.hpp"

namespace hitos {

/// FastSLAM 1.0 [T table 3.2]. `threads` 0: as many as the machine has. Throws ConfigError for
/// values out of range.
std::unique_ptr<SlamFilter> make_fastslam(const FastSlamParams& params, std::uint64_t seed,
                                          int threads);

}  // namespace hitos
