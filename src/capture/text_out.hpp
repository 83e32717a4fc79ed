// Numbers as text, whatever the locale.
#pragma once

#include <charconv>
#include <cstddef>
#include <string>

namespace hitos {

/// How printf would be asked: %+0<width>.<decimals>f. Zeros pad between sign and digits.
struct Layout {
    int decimals = 6;
    std::size_t width = 0;
    bool plus = false;
    char pad = '0';
};

inline void append_fixed(std::string& out, double value, const Layout& layout) {
    char digits[400];  // the longest double has 309 digits before the point
    const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value,
                                            std::chars_format::fixed, layout.decimals);
    static_cast<void>(error);
    const bool negative = digits[0] == '-';
    const char* begin = digits + (negative ? 1 : 0);
    const bool sign = negative || layout.plus;
    const std::size_t length = static_cast<std::size_t>(end - begin) + (sign ? 1 : 0);
    const std::size_t padding = layout.width > length ? layout.width - length : 0;
    if (layout.pad == ' ') out.append(padding, ' ');
    if (sign) out.push_back(negative ? '-' : '+');
    if (layout.pad != ' ') out.append(padding, layout.pad);
    out.append(begin, static_cast<std::size_t>(end - begin));
}

inline void append_fixed(std::string& out, double value, int decimals) {
    append_fixed(out, value, Layout{decimals, 0, false, '0'});
}

/// The shortest digits that read back as the same bits.
inline void append_exact(std::string& out, double value) {
    char digits[32];
    const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value);
    static_cast<void>(error);
    out.append(digits, static_cast<std::size_t>(end - digits));
}

inline void append_count(std::string& out, std::size_t value, std::size_t width = 0) {
    const std::string digits = std::to_string(value);
    if (digits.size() < width) out.append(width - digits.size(), '0');
    out += digits;
}

}  // namespace hitos
