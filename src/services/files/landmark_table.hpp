// SPDX-License-Identifier: GPL-3.0-or-later
// Landmarks with their covariances as a table.
#pragma once

#include <string>

#include "hitos/features/caracteristica.hpp"

namespace hitos {

/// One row a landmark, in the order of the map file; columns that the landmark's kind does not have
/// and covariances that are not known are empty. docs/formats.md names the columns. Throws Error
/// for a landmark that is not finite.
std::string landmark_table(const LandmarkMap& map);

}  // namespace hitos
