// SPDX-License-Identifier: GPL-3.0-or-later
// How checks of structures tell what they find.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace hitos {

/// Throws std::logic_error where it does not hold.
template <class... Args>
void expect_sound(bool holds, fmt::format_string<Args...> what, Args&&... args) {
    if (!holds) throw std::logic_error(fmt::format(what, std::forward<Args>(args)...));
}

}  // namespace hitos
