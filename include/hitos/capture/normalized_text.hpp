// Lines of the normalised format [T A.3], for writers and for sources that make their lines.
#pragma once

#include <string>

#include "hitos/capture/scan.hpp"

namespace hitos {

/// Appends "LASER time n x y …" with digits that read back as the same bits, without a line end;
/// runs of neighbours are parted by "0 0".
void append_normalized(std::string& out, const Scan& scan);
/// The part of the line that stands behind the time.
void append_normalized_points(std::string& out, const Scan& scan);
/// Appends "ODOM time V W", and VL where there is a lateral velocity, without a line end.
void append_normalized(std::string& out, const Odometria& odometry);

}  // namespace hitos
