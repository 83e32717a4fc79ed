// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as text, whatever the locale.
#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>

namespace hitos {

/// How printf would be asked: %+0<width>.<decimals>f. Zeros pad between sign and digits.
struct Layout {
    int decimals = 6;
    std::size_t width = 0;
    bool plus = false;
    char pad = '0';
};

inline void append_fixed(std::string& out, double value, const Layout& layout) {
    std::array<char, 400> digits;  // the longest double has 309 digits before the point
    const std::to_chars_result end =
        std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed,
                      layout.decimals);
    std::string_view text(digits.data(), static_cast<std::size_t>(end.ptr - digits.data()));
    const bool negative = text.starts_with('-');
    if (negative) text.remove_prefix(1);
    const bool sign = negative || layout.plus;
    const std::size_t length = text.size() + (sign ? 1 : 0);
    const std::size_t padding = layout.width > length ? layout.width - length : 0;
    if (layout.pad == ' ') out.append(padding, ' ');
    if (sign) out.push_back(negative ? '-' : '+');
    if (layout.pad != ' ') out.append(padding, layout.pad);
    out += text;
}

inline void append_fixed(std::string& out, double value, int decimals) {
    append_fixed(out, value, Layout{decimals, 0, false, '0'});
}

/// Each with a blank before it.
inline void append_all(std::string& out, std::initializer_list<double> values,
                       const Layout& layout) {
    for (const double value : values) {
        out += ' ';
        append_fixed(out, value, layout);
    }
}

inline void append_all(std::string& out, std::initializer_list<double> values, int decimals) {
    append_all(out, values, Layout{decimals, 0, false, '0'});
}

/// The shortest digits that read back as the same bits.
inline void append_exact(std::string& out, double value) {
    std::array<char, 32> digits;
    const std::to_chars_result end =
        std::to_chars(digits.data(), digits.data() + digits.size(), value);
    out.append(digits.data(), static_cast<std::size_t>(end.ptr - digits.data()));
}

inline void append_count(std::string& out, std::size_t value, std::size_t width = 0) {
    const std::string digits = std::to_string(value);
    if (digits.size() < width) out.append(width - digits.size(), '0');
    out += digits;
}

}  // namespace hitos
