// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of a TOML file, read key by key.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"

namespace hitos {

/// One table of a file. What is missing, unknown or of another kind is told with its line.
class TomlEntry {
  public:
    TomlEntry(const std::string& file, const toml::table& table) : file_(file), table_(table) {}

    bool has(std::string_view key) { return find(key) != nullptr; }

    std::string text(std::string_view key) {
        return value<std::string>(at(key), key, "a text in quotes");
    }
    template <class Value>
    Value value_or(std::string_view key, Value otherwise, const char* expected) {
        const toml::node* node = find(key);
        return node != nullptr ? value<Value>(*node, key, expected) : otherwise;
    }
    /// A whole number from `least` to `greatest`.
    std::int64_t whole_or(std::string_view key, std::int64_t otherwise, std::int64_t least,
                          std::int64_t greatest) {
        const std::string expected = fmt::format("a whole number from {} to {}", least, greatest);
        const std::int64_t number = value_or(key, otherwise, expected.c_str());
        if (number < least || number > greatest) refuse(key, expected.c_str());
        return number;
    }
    /// Texts in a list; none where there is none.
    std::vector<std::string> texts(std::string_view key, const char* expected) {
        std::vector<std::string> texts;
        const toml::node* node = find(key);
        if (node == nullptr) return texts;
        if (!node->is_array()) refuse(*node, key, expected);
        for (const toml::node& one : *node->as_array())
            texts.push_back(value<std::string>(one, key, expected));
        return texts;
    }
    /// Throws FormatError that says what was expected of the key.
    [[noreturn]] void refuse(std::string_view key, const char* expected) {
        refuse(at(key), key, expected);
    }
    /// The words of a text, between spaces.
    std::vector<std::string> words(std::string_view key) {
        const std::string whole = text(key);
        const std::vector<std::string_view> fields = input::fields(whole);
        return {fields.begin(), fields.end()};
    }
    /// A list of lists, [[Values...], ...]; one at least.
    template <class... Values>
    std::vector<std::tuple<Values...>> rows(std::string_view key, const char* expected) {
        std::vector<std::tuple<Values...>> rows;
        const toml::node& whole = at(key);
        const toml::array* list = whole.as_array();
        if (list == nullptr || list->empty()) refuse(whole, key, expected);
        for (const toml::node& node : *list) {
            const toml::array* row = node.as_array();
            if (row == nullptr || row->size() != sizeof...(Values)) refuse(node, key, expected);
            [&]<std::size_t... I>(std::index_sequence<I...>) {
                rows.push_back({value<Values>((*row)[I], key, expected)...});
            }
            (std::index_sequence_for<Values...>());
        }
        return rows;
    }
    /// Refuses the keys that nobody asked for.
    void end() const {
        for (const auto& [key, node] : table_) {
            if (asked_.contains(std::string(key.str()))) continue;
            throw FormatError(file_, key.source().begin.line,
                              HITOS_TEXT("Errors", "no such key; expected one of %1"),
                              fmt::format("{}", fmt::join(asked_, ", ")));
        }
    }

  private:
    const toml::node* find(std::string_view key) {
        asked_.emplace(key);
        return table_.get(key);
    }
    const toml::node& at(std::string_view key) {
        const toml::node* node = find(key);
        if (node == nullptr) refuse(table_, key, "this key");
        return *node;
    }
    [[noreturn]] void refuse(const toml::node& node, std::string_view key,
                             const char* expected) const {
        throw FormatError(file_, node.source().begin.line, HITOS_TEXT("Errors", "%1: expected %2"),
                          key, expected);
    }
    template <class Value>
    Value value(const toml::node& node, std::string_view key, const char* expected) const {
        // The library would take true for 1.
        const bool fits = std::is_same_v<Value, bool> || !node.is_boolean();
        if (const auto value = node.value<Value>(); value && fits) return *value;
        refuse(node, key, expected);
    }

    const std::string& file_;
    const toml::table& table_;
    std::set<std::string> asked_;
};

}  // namespace hitos
