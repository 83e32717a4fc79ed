// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/text_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "hitos/base/text_input.hpp"

namespace hitos {
namespace {

/// Spreadsheets take a text that begins so for a formula, and run it.
bool is_formula(std::string_view text) {
    return !text.empty() && std::string_view("=+-@\t\r").find(text[0]) != std::string_view::npos &&
           !input::parse_number(text);
}

std::string csv_field(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    if (is_formula(text)) text.insert(text.begin(), '\'');
    const auto plain = [](unsigned char c) { return c >= 0x20 && c != ',' && c != '"'; };
    if (std::ranges::all_of(text, plain)) return text;
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + '"';
}

std::string escaped(const std::string& text, std::string_view special, std::string_view with) {
    std::string result;
    for (const char c : text) {
        if (special.find(c) != std::string_view::npos) result += with;
        result += c;
    }
    return result;
}

std::string markdown_line(const std::vector<std::string>& fields) {
    std::string text = "|";
    for (const std::string& field : fields) {
        std::string cell = escaped(field, "|\\", "\\");
        std::ranges::replace_if(
            cell, [](unsigned char c) { return c < 0x20; }, ' ');
        fmt::format_to(std::back_inserter(text), " {} |", cell);
    }
    return text + '\n';
}

std::string latex_field(const std::string& text) {
    if (text == kNoFigure) return "--";
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '\\') {
            result += "\\textbackslash{}";
        } else if (c == '~') {
            result += "\\~{}";
        } else if (c == '^' && i + 1 < text.size() && text[i + 1] >= '0' && text[i + 1] <= '9') {
            result += fmt::format("$^{}$", text[++i]);  // of a unit such as m^2
        } else if (c == '^') {
            result += "\\^{}";
        } else if (static_cast<unsigned char>(c) < 0x20) {
            result += ' ';
        } else {
            result += escaped(std::string(1, c), "&%$#_{}", "\\");
        }
    }
    return result;
}

std::string latex_line(const std::vector<std::string>& fields) {
    std::vector<std::string> cells;
    cells.reserve(fields.size());
    for (const std::string& field : fields) cells.push_back(latex_field(field));
    return fmt::format("{} \\\\\n", fmt::join(cells, " & "));
}

}  // namespace

std::string with_unit(std::string_view name, std::string_view unit) {
    return unit.empty() ? std::string(name) : fmt::format("{} ({})", name, unit);
}

TextTable transposed(const TextTable& table) {
    TextTable result;
    if (table.head.empty()) return result;
    result.head.push_back(table.head.front());
    for (const std::vector<std::string>& row : table.rows) result.head.push_back(row.front());
    for (std::size_t column = 1; column < table.head.size(); ++column) {
        std::vector<std::string> row{table.head[column]};
        for (const std::vector<std::string>& other : table.rows) row.push_back(other[column]);
        result.rows.push_back(std::move(row));
    }
    return result;
}

std::string csv_line(std::vector<std::string> fields) {
    for (std::string& field : fields) field = csv_field(std::move(field));
    return fmt::format("{}\n", fmt::join(fields, ","));
}

std::string csv(const TextTable& table) {
    std::string text = csv_line(table.head);
    for (std::vector<std::string> row : table.rows) {
        std::replace(row.begin(), row.end(), std::string(kNoFigure), std::string());
        text += csv_line(std::move(row));
    }
    return text;
}

std::string markdown(const TextTable& table) {
    std::string text = markdown_line(table.head) + '|';
    for (std::size_t i = 0; i < table.head.size(); ++i) text += "---:|";
    text += '\n';
    for (const std::vector<std::string>& row : table.rows) text += markdown_line(row);
    return text;
}

std::string latex(const TextTable& table) {
    std::string text =
        fmt::format("\\begin{{tabular}}{{{}}}\n\\hline\n", std::string(table.head.size(), 'r'));
    text += latex_line(table.head) + "\\hline\n";
    for (const std::vector<std::string>& row : table.rows) text += latex_line(row);
    return text + "\\hline\n\\end{tabular}\n";
}

}  // namespace hitos
