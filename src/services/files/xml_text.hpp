// SPDX-License-Identifier: GPL-3.0-or-later
// Text as XML 1.0 can hold it.
#pragma once

#include <string>
#include <string_view>

#include "json_input.hpp"

namespace hitos {

/// In UTF-8, with the characters that mean something as references, and "?" for those that XML
/// cannot hold.
inline std::string xml_escaped(const std::string& text) {
    std::string out;
    for (const char c : in_utf8(text)) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            case '\t':
            case '\n':
            case '\r':
                out += ' ';
                break;
            default: {
                const auto code = static_cast<unsigned char>(c);
                out += code < 0x20 ? '?' : c;
            }
        }
    }
    return out;
}

}  // namespace hitos
