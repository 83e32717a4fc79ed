// hitos-cli parameters: what --set and configuration files can say.

#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "commands.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"

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

void list(const std::vector<std::string>& words) {
    for (const std::string& word : words) {
        const bool known =
            std::ranges::any_of(parameters(), [&](const auto& p) { return names(word, p); });
        if (!known) find_parameter(word);  // throws, and names near keys
    }
    std::string_view table;
    for (const ConfigParameter& parameter : parameters()) {
        const bool wanted = words.empty() || std::ranges::any_of(words, [&](const auto& word) {
                                return names(word, parameter);
                            });
        if (!wanted) continue;
        if (parameter.table() != table) {
            fmt::print("{}[{}]\n", table.empty() ? "" : "\n", parameter.table());
            table = parameter.table();
        }
        print(parameter);
    }
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
                        "Write a configuration file with the default of every key instead");
    command->callback([words, file] {
        if (file->empty()) {
            list(*words);
        } else {
            const Configuracion values;
            ArchivoConfiguracion::write(values, *file);
        }
    });
}

}  // namespace hitos::cli
