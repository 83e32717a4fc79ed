// Checks of parameters.
#pragma once

#include <string>

#include "hitos/base/error.hpp"

namespace hitos {

/// Throws ConfigError where the value of `key` is not allowed.
inline void require(bool allowed, const char* key, const char* expected) {
    if (!allowed) throw ConfigError(key, std::string("expected ") + expected);
}

}  // namespace hitos
