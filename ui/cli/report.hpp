// SPDX-License-Identifier: GPL-3.0-or-later
// What a command says on standard output: lines for people, or one JSON object for programs.
#pragma once

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <concepts>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "hitos/base/message.hpp"

namespace hitos::cli {

/// Lines appear as they are said; the object appears whole, at end().
class Report {
  public:
    explicit Report(bool json) : json_(json) {}

    bool is_json() const { return json_; }

    /// Words for people; nothing with --json.
    template <class... Args>
    void say(fmt::format_string<Args...> format, Args&&... args) const {
        if (!json_) print(fmt::format(format, std::forward<Args>(args)...));
    }
    /// A line "warning: …" or "note: …", its first word in colour where a terminal shows it.
    void warn(std::string_view words) const;
    void note(std::string_view words) const;

    /// One measure: a line "name value" with so many decimals, or a member of the object with
    /// all its digits.
    void figure(const std::string& name, double value, int decimals);
    template <std::integral Count>
    void count(const std::string& name, Count value) {
        say("{} {}\n", name, value);
        object_[name] = value;
    }

    /// The object, for what the lines say in other words.
    nlohmann::ordered_json& object() { return object_; }

    /// Prints the object. Once, and before the command leaves with a status of its own.
    void end() const;

  private:
    static void print(std::string_view words);
    void tell(std::string_view word, const char* colour, std::string_view words) const;

    bool json_;
    nlohmann::ordered_json object_ = nlohmann::ordered_json::object();
};

/// --json
CLI::Option* add_report_option(CLI::App& command, bool& json);

/// What a layer below has said as JSON.
nlohmann::ordered_json parsed_object(const std::string& text);

}  // namespace hitos::cli
