// SPDX-License-Identifier: GPL-3.0-or-later
// Whether structures are checked after every step: a build's choice (HITOS_VALIDATE of CMake).
#pragma once

namespace hitos {

/// What checks find is a bug of ours, whatever the input: they throw std::logic_error. Called under
/// `if constexpr (kValidates)`, they cost nothing elsewhere.
#ifdef HITOS_VALIDATE
inline constexpr bool kValidates = true;
#else
inline constexpr bool kValidates = false;
#endif

}  // namespace hitos
