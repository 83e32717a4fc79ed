// What all files of the UTIAS Multi-Robot Cooperative Localization and Mapping Dataset begin with.
#pragma once

#include <string_view>

namespace hitos {

/// Whether a text is one of its files: its tours, the places of its marks, the ways of its robots.
inline bool is_of_mrclam(std::string_view text) {
    return text.starts_with("# UTIAS Multi-Robot Cooperative Localization and Mapping");
}

}  // namespace hitos
