// SPDX-License-Identifier: GPL-3.0-or-later
#include "pages.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <vector>

#include "hitos/base/parameter.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/services/configuration/configuracion.hpp"
#include "roff.hpp"

namespace hitos::manual {
namespace {

constexpr const char* kConfigurationPage = "hitos.cfg";

std::string page_reference(std::string_view page, int section) {
    return fmt::format("{}({})", bold(page), section);
}

/// "Build a map." as it stands behind the name: "build a map".
std::string half_sentence(std::string text) {
    const bool word = text.size() > 1 && std::islower(static_cast<unsigned char>(text[1])) != 0;
    if (word) text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
    if (text.ends_with('.')) text.pop_back();
    return text;
}

std::string name_section(std::string_view page, const std::string& purpose) {
    return roff_section("Name") +
           fmt::format("{} \\- {}\n", roff(page), roff(half_sentence(purpose)));
}

std::string synopsis_of(const Argument& argument) {
    const std::string name = italic(argument.name()) + (argument.repeated ? " ..." : "");
    return argument.required ? name : "[" + name + "]";
}

std::string synopsis(const Command& command) {
    std::string text = roff_section("Synopsis") + ".B " + roff(command.words) + "\n";
    text += "[" + italic("OPTIONS") + "]\n";
    for (const Argument& argument : command.arguments) {
        if (!argument.positional && argument.required) {
            text += fmt::format("{} {}\n", bold(argument.name()), italic(argument.value));
        }
    }
    for (const Argument& argument : command.arguments) {
        if (argument.positional) text += synopsis_of(argument) + "\n";
    }
    if (!command.subcommands.empty()) {
        text += fmt::format(".br\n{} {} [{}]\n", bold(command.words), italic("SUBCOMMAND"),
                            italic("OPTIONS"));
    }
    return text;
}

/// "--pictures[=first]", "--out TEXT", "-h, --help"
std::string tag_of(const Argument& argument) {
    if (argument.positional) return italic(argument.name());
    std::string tag;
    for (const std::string& name : argument.names) tag += (tag.empty() ? "" : ", ") + bold(name);
    if (argument.value_may_go) return tag + "[=" + italic("WORD") + "]";
    if (!argument.value.empty()) tag += " " + italic(argument.value);
    return tag;
}

std::string limits_of(const Argument& argument) {
    std::string text;
    const bool listed = std::ranges::all_of(argument.words, [&](const std::string& word) {
        return argument.meaning.find(word) != std::string::npos;
    });
    if (!listed) text += roff(fmt::format(" One of {}.", fmt::join(argument.words, ", ")));
    if (argument.range == "POSITIVE") {
        text += " Greater than 0.";
    } else if (argument.range == "NONNEGATIVE") {
        text += " 0 or more.";
    } else if (!argument.range.empty()) {
        text += roff(fmt::format(" In the range {}.", argument.range));
    }
    if (argument.required && !argument.positional) text += " Required.";
    if (!argument.excludes.empty()) {
        text += roff(fmt::format(" Not with {}.", fmt::join(argument.excludes, ", ")));
    }
    return text;
}

std::string arguments_section(const Command& command, bool positional, const char* heading) {
    std::string text;
    for (const Argument& argument : command.arguments) {
        if (argument.positional != positional) continue;
        const bool ended = argument.meaning.ends_with('.');
        text += roff_item(tag_of(argument),
                          roff(argument.meaning) + (ended ? "" : ".") + limits_of(argument));
    }
    return text.empty() ? text : roff_section(heading) + text;
}

std::string subcommands_section(const Command& command) {
    if (command.subcommands.empty()) return "";
    std::string text = roff_section("Subcommands");
    for (const Command& below : command.subcommands) {
        text += roff_item(page_reference(page_name(below), 1), roff(below.purpose) + ".");
    }
    return text;
}

std::string see_also(const Command& command) {
    std::vector<std::string> pages;
    std::string above;
    for (std::size_t k = 0; (k = command.words.find(' ', k)) != std::string::npos; ++k) {
        above = command.words.substr(0, k);
        std::ranges::replace(above, ' ', '-');
        pages.push_back(page_reference(above, 1));
    }
    for (const char* program : {"hitos", "hitos-cli", "BatchSLAM"}) {
        const std::string page = page_reference(program, 1);
        if (page_name(command) != program && std::ranges::find(pages, page) == pages.end()) {
            pages.push_back(page);
        }
    }
    pages.push_back(page_reference(kConfigurationPage, 5));
    return roff_section("See also") + fmt::format("{}\n", fmt::join(pages, ",\n")) +
           ".PP\nThe documents in " + italic("/usr/share/doc/hitos/docs") +
           " say more: formats of files, worlds, studies, measures, formulas.\n";
}

/// Where the second part of the prose begins: its first heading.
std::size_t end_of_description(std::string_view prose) {
    if (prose.starts_with("## ")) return 0;
    const std::size_t heading = prose.find("\n## ");
    return heading == std::string_view::npos ? prose.size() : heading + 1;
}

std::string parameter_entry(const ConfigParameter& parameter, const Configuracion& defaults) {
    const std::string value = parameter.text(defaults);
    std::string text = roff(parameter.description) + "\n.br\n";
    text += roff(fmt::format("Allowed: {}", parameter.allowed()));
    for (const ConfigParameter::Condition& condition : parameter.conditions) {
        text += roff(fmt::format("; read where {} is {}", condition.key, condition.needed));
    }
    text += ".";
    if (!parameter.symbol.empty())
        text += roff(fmt::format(" {} in the thesis.", parameter.symbol));
    for (const ParameterChoice& choice : parameter.choices) {
        if (choice.purpose.empty()) continue;
        text += "\n.br\n" + bold(choice.word) + ": " + roff(choice.purpose) + ".";
    }
    std::string tag = bold(parameter.key);
    if (!value.empty()) tag += " = " + roff(value);
    return roff_item(tag, text);
}

}  // namespace

std::string page_name(const Command& command) {
    std::string name = command.words;
    std::ranges::replace(name, ' ', '-');
    return name;
}

std::string command_page(const Command& command, std::string_view prose) {
    const std::size_t rest = end_of_description(prose);
    std::string purpose = command.purpose;
    // A program's own words begin with its name.
    const std::size_t colon = purpose.find(": ");
    if (command.below.empty() && colon != std::string::npos) purpose.erase(0, colon + 2);
    std::string text = roff_title(page_name(command), 1) +
                       name_section(page_name(command), purpose) + synopsis(command) +
                       roff_section("Description");
    text += rest > 0 ? roff_of_prose(prose.substr(0, rest)) : roff(command.purpose) + ".\n";
    text += subcommands_section(command) + arguments_section(command, true, "Arguments") +
            arguments_section(command, false, "Options");
    if (!command.footer.empty()) text += roff_section("Notes") + roff_verbatim(command.footer);
    return text + roff_of_prose(prose.substr(rest)) + see_also(command);
}

std::string configuration_page(std::string_view prose) {
    const std::size_t rest = end_of_description(prose);
    std::string text = roff_title(kConfigurationPage, 5) +
                       name_section(kConfigurationPage, "Configuration files of Hitos") +
                       roff_section("Description") + roff_of_prose(prose.substr(0, rest)) +
                       roff_section("Parameters");
    const Configuracion defaults;
    std::string_view table;
    for (const ConfigParameter& parameter : parameters()) {
        if (table != parameter.table()) {
            table = parameter.table();
            text += fmt::format(".SS [{}]\n", roff(table));
        }
        text += parameter_entry(parameter, defaults);
    }
    return text + roff_of_prose(prose.substr(rest)) + roff_section("See also") +
           page_reference("hitos", 1) + ",\n" + page_reference("hitos-cli", 1) + ",\n" +
           page_reference("hitos-cli-parameters", 1) + "\n";
}

}  // namespace hitos::manual
