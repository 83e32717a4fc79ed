// Whole numbers out of JSON, which a cast would take from any number.
#pragma once

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "hitos/base/error.hpp"

namespace hitos {

/// What `json` has under the name. Throws FormatError naming it and the file where that is no whole
/// number from `least` (0 at the least) to `greatest`, and JSON's own exception where there is
/// none.
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
    throw FormatError(
        file, 0,
        message(HITOS_TEXT("Errors", "%1 is %2; expected a whole number from %3 to %4"), name,
                value.dump(-1, ' ', false, Json::error_handler_t::replace), least, greatest));
}

}  // namespace hitos
