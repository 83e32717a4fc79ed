// SPDX-License-Identifier: GPL-3.0-or-later
// How many there are of something, in English.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace hitos {

/// "1 scan", "2 scans"; the word as it is for one.
template <class Count>
std::string plural(const Count& count, std::string_view one) {
    return fmt::format("{} {}{}", count, one, count == Count{1} ? "" : "s");
}

}  // namespace hitos
