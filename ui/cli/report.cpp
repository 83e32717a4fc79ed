// SPDX-License-Identifier: GPL-3.0-or-later
#include "report.hpp"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace hitos::cli {
namespace {

/// no-color.org: set and not empty, it asks every program for none.
bool wants_colour() {
    const auto is_set = [](const char* name) {
        const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe)
        return value != nullptr && *value != '\0';
    };
    if (is_set("NO_COLOR") || isatty(STDOUT_FILENO) == 0) return false;
    const char* terminal = std::getenv("TERM");  // NOLINT(concurrency-mt-unsafe)
    return terminal != nullptr && std::string_view(terminal) != "dumb";
}

}  // namespace

void Report::print(std::string_view words) {
    fmt::print("{}", without_control(words));
}

void Report::tell(std::string_view word, const char* colour, std::string_view words) const {
    if (json_) return;
    if (wants_colour()) {
        fmt::print("\033[{}m{}\033[0m {}\n", colour, word, without_control(words));
    } else {
        fmt::print("{} {}\n", word, without_control(words));
    }
}

void Report::warn(std::string_view words) const {
    tell("warning:", "1;33", words);
}

void Report::note(std::string_view words) const {
    tell("note:", "1;36", words);
}

void Report::figure(const std::string& name, double value, int decimals) {
    if (!std::isfinite(value)) {
        say("{} -\n", name);
        object_[name] = nullptr;
        return;
    }
    say("{} {:.{}f}\n", name, value, decimals);
    object_[name] = value;
}

void Report::end() const {
    using Json = nlohmann::ordered_json;
    if (!json_) return;
    // Text from a damaged log may be no UTF-8: replace what is not instead of failing.
    fmt::print("{}\n", object_.dump(2, ' ', false, Json::error_handler_t::replace));
}

CLI::Option* add_report_option(CLI::App& command, bool& json) {
    return command.add_flag("--json", json,
                            "Say it as one JSON object on standard output, units in the names "
                            "(docs/command-line.md)");
}

nlohmann::ordered_json parsed_object(const std::string& text) {
    return nlohmann::ordered_json::parse(text);
}

}  // namespace hitos::cli
