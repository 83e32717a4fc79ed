// SPDX-License-Identifier: GPL-3.0-or-later
// Rounded numbers, of which no zero has a sign.
#pragma once

#include <fmt/format.h>

#include <string>

namespace hitos {

inline double without_sign_of_zero(double value) {
    return value == 0.0 ? 0.0 : value;
}

/// With so many decimals: "0.25"; "0.00", never "-0.00".
inline std::string fixed_point(double value, int decimals) {
    std::string text = fmt::format("{:.{}f}", value, decimals);
    const bool zero = text.find_first_not_of("-0.") == std::string::npos;
    return zero && text.front() == '-' ? text.substr(1) : text;
}

}  // namespace hitos
