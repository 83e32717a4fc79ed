// SPDX-License-Identifier: GPL-3.0-or-later
// hitos-cli parameters: what --set and configuration files can say.

#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "commands.hpp"
#include "hitos/base/parameter.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "report.hpp"

namespace hitos::cli {
namespace {

/// Prints words in lines of at most 100 columns, indented.
void print_paragraph(std::string_view text) {
    constexpr std::size_t kColumns = 100;
    constexpr std::string_view kIndent = "     ";
    std::string line(kIndent);
    for (const std::string_view word : input::fields(text)) {
        if (line.size() + 1 + word.size() > kColumns) {
            fmt::print("{}\n", line);
            line = kIndent;
        }
        line += ' ';
        line += word;
    }
    fmt::print("{}\n", line);
}

void print(const ConfigParameter& parameter) {
    static const Configuracion defaults;
    fmt::print(
        "  {} = {}{}\n", parameter.key, parameter.text(defaults),
        parameter.symbol.empty() ? "" : fmt::format("   {} in the thesis", parameter.symbol));
    print_paragraph(parameter.description);
    std::string rules = parameter.allowed();
    for (const ConfigParameter::Condition& condition : parameter.conditions) {
        rules += fmt::format("; read where {} is {}", condition.key, condition.needed);
    }
    print_paragraph(rules);
    for (const ParameterChoice& choice : parameter.choices) {
        if (!choice.purpose.empty()) print_paragraph(choice.word + ": " + choice.purpose);
    }
}

bool names(std::string_view word, const ConfigParameter& parameter) {
    return word == parameter.key || word == parameter.table();
}

nlohmann::ordered_json object_of(const ConfigParameter& parameter) {
    static const Configuracion defaults;
    nlohmann::ordered_json object{{"key", parameter.key},
                                  {"default", parameter.text(defaults)},
                                  {"unit", parameter.unit},
                                  {"symbol", parameter.symbol},
                                  {"meaning", parameter.description},
                                  {"allowed", parameter.allowed()}};
    object["read_where"] = nlohmann::ordered_json::array();
    for (const ConfigParameter::Condition& condition : parameter.conditions) {
        object["read_where"].push_back({{"key", condition.key}, {"is", condition.needed}});
    }
    object["choices"] = nlohmann::ordered_json::array();
    for (const ParameterChoice& choice : parameter.choices) {
        object["choices"].push_back({{"word", choice.word}, {"purpose", choice.purpose}});
    }
    return object;
}

void list(const std::vector<std::string>& words, bool json) {
    for (const std::string& word : words) {
        const bool known =
            std::ranges::any_of(parameters(), [&](const auto& p) { return names(word, p); });
        if (!known) find_parameter(word);  // throws, and names near keys
    }
    Report report(json);
    std::string_view table;
    for (const ConfigParameter& parameter : parameters()) {
        const bool wanted = words.empty() || std::ranges::any_of(words, [&](const auto& word) {
                                return names(word, parameter);
                            });
        if (!wanted) continue;
        if (json) {
            report.object()["parameters"].push_back(object_of(parameter));
            continue;
        }
        if (parameter.table() != table) {
            fmt::print("{}[{}]\n", table.empty() ? "" : "\n", parameter.table());
            table = parameter.table();
        }
        print(parameter);
    }
    report.end();
}

}  // namespace

void add_parameters(CLI::App& program) {
    auto words = std::make_shared<std::vector<std::string>>();
    auto file = std::make_shared<std::string>();
    CLI::App* command = program.add_subcommand(
        "parameters", "List the keys for --set: default, meaning, range, when they are read");
    command->add_option("key", *words,
                        "Keys, or tables such as split_merge, to list (default: all)");
    command->add_option("--write", *file,
                        "Write a configuration file with the default of every key instead; - for "
                        "standard output");
    auto json = std::make_shared<bool>(false);
    add_report_option(*command, *json);
    command->callback([words, file, json] {
        if (file->empty()) {
            list(*words, *json);
        } else if (*file == "-") {
            fmt::print("{}", ArchivoConfiguracion::to_text(Configuracion()));
        } else {
            const Configuracion values;
            ArchivoConfiguracion::write(values, *file);
        }
    });
}

}  // namespace hitos::cli
