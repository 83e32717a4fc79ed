// SPDX-License-Identifier: GPL-3.0-or-later
// The tour of a finished run as a log with the poses that the run found.
#pragma once

#include <filesystem>

#include "hitos/services/run/algoritmo.hpp"

namespace hitos {

/// Writes the scans and the odometry of the run so far with `path`, the pose at every scan, as
/// make_corrected_log_writer() says. Throws what that does, and Error where the tour has no scan.
void write_corrected_tour(const Algoritmo& run, const Trajectory& path,
                          const std::filesystem::path& file);

}  // namespace hitos
