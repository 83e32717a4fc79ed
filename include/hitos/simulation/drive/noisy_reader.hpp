// SPDX-License-Identifier: GPL-3.0-or-later
// Any tour with noise added to its odometry.
#pragma once

#include <cstdint>
#include <memory>

#include "hitos/capture/tour_reader.hpp"
#include "hitos/simulation/worlds/odometry_noise.hpp"

namespace hitos {

/// What `reader`, which must stand at its beginning, gives, with OdometryNoise(level, kind, seed)
/// on its odometry; the scans are untouched. Nothing is written to disk, so that every run of a
/// study can have noise of its own. Throws ConfigError for an impossible level.
std::unique_ptr<TourReader> make_noisy_reader(std::unique_ptr<TourReader> reader, double level,
                                              OdometryNoiseKind kind, std::uint64_t seed);

}  // namespace hitos
