// SPDX-License-Identifier: GPL-3.0-or-later
// JSON that somebody else may have written: how deep it goes, and whole numbers in it.
#pragma once

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/base/text_limits.hpp"

namespace hitos {

/// The JSON of a file's text. Throws what checked_json() does, and JSON's own exception where it is
/// none.
template <class Json>
Json parsed(const std::string& text, const std::string& file) {
    return Json::parse(input::checked_json(text, file));
}

/// What is no UTF-8 becomes U+FFFD, as wherever JSON is written.
inline std::string in_utf8(const std::string& text) {
    using nlohmann::json;
    return json::parse(json(text).dump(-1, ' ', false, json::error_handler_t::replace));
}
/// Names of files and text of damaged logs may be no UTF-8: they do not make it fail.
inline std::string json_text(const nlohmann::ordered_json& json, int indent = 2) {
    return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}
inline bool is_utf8(const std::string& text) {
    return in_utf8(text) == text;
}

/// What `json` has under the name. Throws FormatError naming it and the file where that is no whole
/// number from `least` (0 at the least) to `greatest`, and JSON's own exception where it is no
/// number.
template <class Number, class Json>
Number whole_number(const Json& json, const char* name, const std::string& file, Number least = 0,
                    Number greatest = std::numeric_limits<Number>::max()) {
    const Json& value = json.at(name);
    if (value.is_number_unsigned()) {  // as every number from 0 on is read
        const auto number = value.template get<std::uint64_t>();
        if (std::cmp_greater_equal(number, least) && std::cmp_less_equal(number, greatest)) {
            return static_cast<Number>(number);
        }
    }
    // What is no number at all is refused in JSON's words.
    if (!value.is_number() && !value.is_boolean()) static_cast<void>(value.template get<Number>());
    throw FormatError(file, 0,
                      HITOS_TEXT("Errors", "%1 is %2; expected a whole number from %3 to %4"), name,
                      value.dump(), least, greatest);
}

}  // namespace hitos
