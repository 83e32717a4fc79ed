// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes as text (RFC 4648), for JSON.
#pragma once

#include <string>
#include <string_view>

namespace hitos::live {

inline std::string base64(std::string_view bytes) {
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        unsigned bits = 0;
        for (std::size_t i = at; i < at + 3; ++i) {
            bits = bits << 8U | (i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0U);
        }
        for (std::size_t digit = 0; digit < 4; ++digit) {
            const bool there = at + digit <= bytes.size();
            text += there ? kDigits[bits >> (18U - 6U * digit) & 63U] : '=';
        }
    }
    return text;
}

}  // namespace hitos::live
