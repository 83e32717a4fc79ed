// SPDX-License-Identifier: GPL-3.0-or-later
// The log that a configuration names, as a reader.
#pragma once

#include <memory>

#include "hitos/capture/tour_reader.hpp"
#include "hitos/services/configuration/configuracion.hpp"

namespace hitos {

/// Where the log has no odometry, it is made from the scans (make_scan_odometry), as it is where
/// that is asked for. Throws as open_log does, and ConfigError where no file is named.
std::unique_ptr<TourReader> open_source(const SourceParams& source);

}  // namespace hitos
