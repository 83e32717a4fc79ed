// SPDX-License-Identifier: GPL-3.0-or-later
// A small table as text: for papers, pages and spreadsheets.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hitos {

/// Words in rows under a head; every row is as long as the head.
struct TextTable {
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows;
};

/// Stands in tables for people where there is no figure.
inline constexpr const char* kNoFigure = "–";

/// "time (s)"; the name alone where the unit is empty.
std::string with_unit(std::string_view name, std::string_view unit);

/// Rows for columns.
TextTable transposed(const TextTable& table);

/// One line of a CSV file: fields with commas, quotes or control characters in quotes, line ends as
/// spaces, and before what a spreadsheet would take for a formula an apostrophe.
std::string csv_line(std::vector<std::string> fields);

/// The head and a line a row; kNoFigure gives an empty field.
std::string csv(const TextTable& table);

/// A table of pipes, its columns flush right.
std::string markdown(const TextTable& table);

/// A tabular between two `\hline`; "m^2" gets its exponent, and what TeX would read is escaped.
std::string latex(const TextTable& table);

}  // namespace hitos
