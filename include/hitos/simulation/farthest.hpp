// SPDX-License-Identifier: GPL-3.0-or-later
// How far from its origin the things of a world may lie.
#pragma once

namespace hitos {

inline constexpr double kFarthest = 1e6;  ///< m; keeps every product of coordinates exact enough

}  // namespace hitos
