// SPDX-License-Identifier: GPL-3.0-or-later
// The one file that includes toml++, which is slow to compile.
#include "hitos/services/configuration/archivo_configuracion.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/parameter.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/base/text_limits.hpp"
#include "hitos/registration/graph_edit.hpp"
#include "hitos/services/configuration/config_parameter.hpp"

namespace hitos {
namespace {

struct Mistake {
    std::uint64_t line = 0;
    Message problem;
};

std::uint64_t line_of(const toml::source_region& source) {
    return source.begin.line;
}

std::string_view name_of(std::string_view key) {
    return key.substr(key.find('.') + 1);
}

Message type_name(const toml::node& node) {
    switch (node.type()) {
        case toml::node_type::table:
            return message(HITOS_TEXT("Errors", "a table"));
        case toml::node_type::array:
            return message(HITOS_TEXT("Errors", "an array"));
        case toml::node_type::string:
            return message(HITOS_TEXT("Errors", "a string"));
        case toml::node_type::integer:
            return message(HITOS_TEXT("Errors", "an integer"));
        case toml::node_type::floating_point:
            return message(HITOS_TEXT("Errors", "a real number"));
        case toml::node_type::boolean:
            return message(HITOS_TEXT("Errors", "a boolean"));
        default:
            return message(HITOS_TEXT("Errors", "a date or time"));
    }
}

Message expected_name(ConfigParameter::Type type) {
    switch (type) {
        case ConfigParameter::Type::real:
            return message(HITOS_TEXT("Errors", "a number"));
        case ConfigParameter::Type::integer:
            return message(HITOS_TEXT("Errors", "an integer"));
        default:
            return message(HITOS_TEXT("Errors", "a string in quotes"));
    }
}

/// The node's value as the text that ConfigParameter::set takes; nothing for a wrong type.
std::optional<std::string> value_text(const toml::node& node, ConfigParameter::Type type) {
    const bool number =
        type == ConfigParameter::Type::real || type == ConfigParameter::Type::integer;
    if (node.is_integer() && number) return fmt::format("{}", node.as_integer()->get());
    if (node.is_floating_point() && type == ConfigParameter::Type::real) {
        return fmt::format("{}", node.as_floating_point()->get());
    }
    if (node.is_string() && !number) return node.as_string()->get();
    return std::nullopt;
}

/// Goes through a parsed document and gathers every mistake with its line.
class Reading {
  public:
    Configuracion configuration;
    std::vector<Mistake> mistakes;

    void read(const toml::table& document) {
        for (const auto& [key, node] : document) {
            if (is_hopeless()) break;
            const std::string_view group = key.str();
            const auto known = std::ranges::any_of(
                parameters(), [&](const ConfigParameter& p) { return p.table() == group; });
            if (const toml::table* table = node.as_table()) {
                // The mistakes inside an unknown group name near keys; an empty one is told here.
                if (!known && table->empty()) {
                    add(line_of(key.source()),
                        message(HITOS_TEXT("Errors", "[%1]: no such group"), group));
                }
                for (const auto& [name, value] : *table) {
                    if (is_hopeless()) break;
                    read(fmt::format("{}.{}", group, name.str()), line_of(name.source()), value);
                }
            } else if (known) {
                add(line_of(key.source()),
                    message(HITOS_TEXT("Errors", "%1: found %2; expected a table [%1]"), group,
                            type_name(node)));
            } else {
                read(std::string(group), line_of(key.source()), node);
            }
        }
        if (mistakes.empty()) check_together();
        std::ranges::stable_sort(mistakes, {}, &Mistake::line);
    }

    /// Whoever reads so many mistakes needs no more; each costs a search for near keys.
    bool is_hopeless() const {
        constexpr std::size_t kMostMistakes = 100;
        return mistakes.size() >= kMostMistakes;
    }

  private:
    void add(std::uint64_t line, Message problem) {
        mistakes.push_back({line, std::move(problem)});
    }

    void read(const std::string& key, std::uint64_t line, const toml::node& node) {
        try {
            const ConfigParameter& parameter = find_parameter(key);
            if (const auto text = value_text(node, parameter.type)) {
                parameter.set(configuration, *text);
                lines_.emplace_back(key, line);
            } else {
                add(line, message(HITOS_TEXT("Errors", "%1: found %2; expected %3, %4"), key,
                                  type_name(node), expected_name(parameter.type),
                                  parameter.allowed_message()));
            }
        } catch (const ConfigError& error) {
            add(line, error.message());
        }
    }

    void check_together() {
        try {
            check(configuration);
        } catch (const ConfigError& error) {
            const auto found = std::ranges::find(lines_, error.key(),
                                                 &std::pair<std::string, std::uint64_t>::first);
            add(found == lines_.end() ? 0 : found->second, error.message());
        }
    }

    std::vector<std::pair<std::string, std::uint64_t>> lines_;  ///< where each key was set
};

/// One mistake as it is; several one below the other, each with its line.
Message joined(const std::vector<Mistake>& mistakes, bool perhaps_more) {
    if (mistakes.size() == 1) return mistakes.front().problem;
    Message list = perhaps_more ? message(HITOS_TEXT("Errors", "%1 mistakes and perhaps more:"),
                                          mistakes.size())
                                : message(HITOS_TEXT("Errors", "%1 mistakes:"), mistakes.size());
    for (const Mistake& mistake : mistakes) {
        const Message placed = mistake.line == 0 ? mistake.problem
                                                 : message(HITOS_TEXT("Errors", "line %1: %2"),
                                                           mistake.line, mistake.problem);
        list = message("%1\n  %2", list, placed);
    }
    return list;
}

/// Where the bytes stop being well-formed UTF-8 (Unicode 15, table 3-7), the one encoding of TOML;
/// the size where they never do.
std::size_t end_of_utf8(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
    };
    const auto length_after = [](unsigned lead) -> std::size_t {
        if (lead < 0x80) return 1;
        if (lead < 0xc2 || lead > 0xf4) return 0;
        return lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
    };
    std::size_t i = 0;
    while (i < text.size()) {
        const unsigned lead = byte(i);
        const std::size_t length = length_after(lead);
        if (length == 0) break;
        bool good = true;
        for (std::size_t k = 1; k < length; ++k) good = good && (byte(i + k) & 0xc0U) == 0x80U;
        const unsigned second = byte(i + 1);
        const bool overlong = (lead == 0xe0 && second < 0xa0) || (lead == 0xf0 && second < 0x90);
        const bool beyond = (lead == 0xed && second > 0x9f) || (lead == 0xf4 && second > 0x8f);
        if (!good || overlong || beyond) break;
        i += length;
    }
    return i;
}

/// As it stands between quotes; line ends as they are.
std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if ((byte < 0x20 && c != '\n') || byte == 0x7f) {
            out += fmt::format("\\u{:04X}", byte);
        } else {
            out += c;
        }
    }
    return out;
}

std::string toml_string(const ConfigParameter& parameter, std::string_view text) {
    if (end_of_utf8(text) != text.size()) {
        throw ConfigError(
            std::string(parameter.key),
            HITOS_TEXT("Errors", "%1 is not UTF-8 and cannot stand in a configuration file"),
            input::in_quotes(text));
    }
    const bool lines = text.find('\n') != std::string_view::npos;
    return lines ? fmt::format("{0}\n{1}{0}", R"(""")", escaped(text)) : '"' + escaped(text) + '"';
}

std::string toml_value(const ConfigParameter& parameter, const Configuracion& configuration) {
    std::string text = parameter.text(configuration);
    switch (parameter.type) {
        case ConfigParameter::Type::integer:
            return text;
        case ConfigParameter::Type::real:
            // A point makes it a float of TOML, which keeps the sign of -0.
            return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
        default:
            return toml_string(parameter, text);
    }
}

/// Appends words as comment lines of at most 100 columns.
void append_comment(std::string& out, std::string_view text) {
    constexpr std::size_t kColumns = 100;
    std::size_t column = 0;
    for (const std::string_view word : input::fields(text)) {
        if (column == 0 || column + 1 + word.size() > kColumns) {
            out += column == 0 ? "#" : "\n#";
            column = 1;
        }
        out += ' ';
        out += word;
        column += 1 + word.size();
    }
    out += '\n';
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
    return std::filesystem::absolute(file).lexically_normal().parent_path();
}

/// A log or a map as a configuration file names it: so that it is found wherever the program is
/// started, and still is when a folder with both is moved.
std::string named_in(const std::filesystem::path& file, const std::string& log) {
    if (log.empty()) return log;
    const std::filesystem::path whole = std::filesystem::absolute(log).lexically_normal();
    const std::filesystem::path relative = whole.lexically_relative(folder_of(file));
    return (relative.empty() || *relative.begin() == ".." ? whole : relative).string();
}

}  // namespace

Configuracion ArchivoConfiguracion::read(const std::filesystem::path& path) {
    Configuracion configuration =
        parse(input::read_text(path, input::kLargestSettings), path.string());
    for (std::string* named : {&configuration.source.file, &configuration.source.map}) {
        const std::filesystem::path beside = folder_of(path) / *named;
        std::error_code ignored;
        if (!named->empty() && std::filesystem::exists(beside, ignored)) *named = beside.string();
    }
    return configuration;
}

Configuracion ArchivoConfiguracion::parse(std::string_view text, const std::string& name) {
    const std::size_t end = end_of_utf8(text);
    if (end != text.size()) {
        const auto line = 1 + std::ranges::count(text.substr(0, end), '\n');
        throw FormatError(name, static_cast<std::uint64_t>(line),
                          HITOS_TEXT("Errors", "found the byte 0x%1; expected UTF-8 text"),
                          fmt::format("{:02x}", static_cast<unsigned char>(text[end])));
    }
    Reading reading;
    try {
        reading.read(toml::parse(input::checked_toml(text, name)));
    } catch (const toml::parse_error& error) {
        throw FormatError(name, line_of(error.source()),
                          verbatim(std::string(error.description())));
    }
    if (!reading.mistakes.empty()) {
        throw FormatError(name, reading.mistakes.front().line,
                          joined(reading.mistakes, reading.is_hopeless()));
    }
    return reading.configuration;
}

std::string ArchivoConfiguracion::read_edits(const std::filesystem::path& path) {
    const std::string text = input::read_text(path, input::kLargestSettings);
    // Line by line, as those of a graph, else as a configuration.
    const bool plain = text.find('=') == std::string::npos;
    Configuracion configuration = plain ? Configuracion() : parse(text, path.string());
    std::string edits = plain ? text : std::exchange(configuration.registration.edits, {});
    const Configuracion defaults;
    for (const ConfigParameter& parameter : parameters()) {
        if (parameter.get(configuration) == parameter.get(defaults)) continue;
        throw FormatError(path.string(), 0,
                          HITOS_TEXT("Errors",
                                     "sets %1 too; expected a file of changes by hand, which sets "
                                     "%2 alone: a whole configuration is read by --config"),
                          parameter.key, kGraphEditsKey);
    }
    try {
        if (!parse_graph_edits(edits).empty()) return edits;
    } catch (const ConfigError& wrong) {
        throw FormatError(path.string(), 0, wrong.problem());
    }
    throw FormatError(path.string(), 0,
                      HITOS_TEXT("Errors", "has no change by hand; expected %1 with at least one"),
                      kGraphEditsKey);
}

std::string ArchivoConfiguracion::edits_text(const std::string& title, std::string_view edits) {
    std::string out;
    append_comment(out, title);
    const std::string key = kGraphEditsKey;
    out += fmt::format("[{}]\n{} = \"\"\"\n", key.substr(0, key.find('.')), name_of(key));
    for (const GraphEdit& edit : parse_graph_edits(edits))
        out += escaped(text_of(std::span(&edit, 1))) + (edit.comment.empty() ? "\n" : "");
    return out + "\"\"\"\n";
}

std::string ArchivoConfiguracion::to_text(const Configuracion& configuration) {
    const Configuracion defaults;
    std::string out =
        "# Configuration of Hitos (TOML). A parameter that is left out has its default value.\n";
    std::string_view group;
    for (const ConfigParameter& parameter : parameters()) {
        if (parameter.table() != group) {
            group = parameter.table();
            out += fmt::format("\n[{}]\n", group);
        }
        out += '\n';
        append_comment(out, parameter.description);
        for (const ParameterChoice& choice : parameter.choices) {
            if (!choice.purpose.empty()) append_comment(out, choice.word + ": " + choice.purpose);
        }
        append_comment(out, fmt::format("Allowed: {}. Default: {}.", parameter.allowed(),
                                        toml_value(parameter, defaults)));
        out +=
            fmt::format("{} = {}\n", name_of(parameter.key), toml_value(parameter, configuration));
    }
    return out;
}

void ArchivoConfiguracion::write(const Configuracion& configuration,
                                 const std::filesystem::path& path,
                                 const std::filesystem::path& folder) {
    Configuracion stored = configuration;
    const std::filesystem::path kept = folder.empty() ? path : folder / path.filename();
    stored.source.file = named_in(kept, configuration.source.file);
    stored.source.map = named_in(kept, configuration.source.map);
    write_file(path, to_text(stored));
}

}  // namespace hitos
