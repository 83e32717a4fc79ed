// SPDX-License-Identifier: GPL-3.0-or-later
// What all files of the UTIAS Multi-Robot Cooperative Localization and Mapping Dataset begin with,
// and the rows of numbers that follow.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/base/text_input.hpp"

namespace hitos {

/// Whether a text is one of its files: its tours, the places of its marks, the ways of its robots.
inline bool is_of_mrclam(std::string_view text) {
    return text.starts_with("# UTIAS Multi-Robot Cooperative Localization and Mapping");
}

/// The numbers of a line of a file of MRCLAM.
template <std::size_t N>
struct MrclamRow {
    std::array<double, N> values;
    std::uint64_t line = 0;
};

/// The rows that have exactly these columns; `name` stands in messages. Throws FormatError.
template <std::size_t N>
std::vector<MrclamRow<N>> mrclam_rows(std::string_view text,
                                      const std::array<std::string_view, N>& columns,
                                      const std::string& name) {
    std::vector<MrclamRow<N>> rows;
    std::uint64_t number = 0;
    while (const auto line = input::next_line(text)) {
        ++number;
        const std::string_view content = input::trimmed(*line);
        if (content.empty() || content.starts_with('#')) continue;
        rows.push_back({input::finite_numbers(content, columns, {name, number}), number});
    }
    return rows;
}

}  // namespace hitos
