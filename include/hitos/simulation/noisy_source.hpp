// A log with noise added to its odometry, as a source.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "hitos/capture/conversor.hpp"
#include "hitos/capture/fuente.hpp"
#include "hitos/simulation/odometry_noise.hpp"

namespace hitos {

/// The lines, in the normalised format, that a file would hold which was written from `source` with
/// OdometryNoise(level, kind, seed) on its odometry; only that scans and odometry are not in one
/// order, which the two cursors do not need. Nothing is written to disk, so that every run of a
/// study can have noise of its own. `logged_velocities` as in ReadOptions. A scan keeps its own
/// stamp, also in logs whose stamps go backwards. Throws ConfigError for an impossible level.
std::unique_ptr<Fuente> make_noisy_source(std::unique_ptr<Fuente> source, double level,
                                          OdometryNoiseKind kind, std::uint64_t seed,
                                          bool logged_velocities = false);

}  // namespace hitos
