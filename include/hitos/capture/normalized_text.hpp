// Lines of the normalised format [T A.3], for files and for sources that need none.
#pragma once

#include <string>

#include "hitos/capture/scan.hpp"

namespace hitos {

/// Appends `LASER time n x y ...` without the line's end; digits read back as the same bits, and a
/// pair 0 0 ends a run of neighbours.
void append_normalized(std::string& out, const Scan& scan);

/// Appends `ODOM time V W`, with the lateral velocity behind where there is one.
void append_normalized(std::string& out, const Odometria& odometry);

/// What follows the time in the line of a scan.
void append_normalized_points(std::string& out, const Scan& scan);

}  // namespace hitos
