// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "completions.hpp"
#include "values.hpp"

namespace hitos::manual {
namespace {

/// The names of keys in the script.
constexpr std::array kKinds{std::pair{Keys::configuration, "configuration"},
                            std::pair{Keys::world, "world"}, std::pair{Keys::study, "study"}};

/// What is the same for every program; NAME is the program as a shell's name, PROGRAM the program.
constexpr const char* kScript = R"(
NAME()
{
    local IFS=$' \t\n' line=${COMP_LINE:0:COMP_POINT}
    local -a typed
    read -ra typed <<<"$line"
    [[ $line == *[[:space:]] ]] && typed+=("")
    local current=${typed[${#typed[@]} - 1]} command= option= place=0 before= word k
    local subcommands= options= words= paths= keys=
    for ((k = 1; k < ${#typed[@]} - 1; ++k)); do
        word=${typed[k]}
        if [[ -n $option ]]; then
            option=
        elif [[ $word == -* ]]; then
            if NAME_takes "$command" "$word"; then option=$word; fi
        else
            NAME_offers "$command"
            if [[ $place == 0 && " $subcommands " == *" $word "* ]]; then
                command=${command:+$command }$word
            else
                ((++place))
            fi
        fi
    done
    NAME_offers "$command"
    if [[ -z $option && $current == --*=* ]]; then
        option=${current%%=*} before=${current%%=*}= current=${current#*=}
    fi
    if [[ -n $option ]]; then
        NAME_values "$command" "$option"
    elif [[ $current == -* ]]; then
        words=$options
    else
        NAME_values "$command" "$place"
        [[ $place == 0 ]] && words+=" $subcommands"
    fi
    if [[ -n $keys && $current == *=* ]]; then
        before+=${current%%=*}=
        NAME_choices "$keys" "${current%%=*}"
        current=${current#*=}
    elif [[ -n $keys ]]; then
        NAME_keys "$keys"
    fi
    COMPREPLY=($(compgen -W "$words" -- "$current"))
    if [[ -n $paths ]]; then
        compopt -o filenames 2>/dev/null
        while IFS= read -r word; do COMPREPLY+=("$word"); done < <(compgen "$paths" -- "$current")
    fi
    [[ ${#COMPREPLY[@]} == 1 && ${COMPREPLY[0]} == *= ]] && compopt -o nospace 2>/dev/null
    # Only what stands behind the last of the marks that divide words is replaced.
    [[ $COMP_WORDBREAKS != *=* ]] && COMPREPLY=("${COMPREPLY[@]/#/"$before"}")
    for word in : =; do
        if [[ $COMP_WORDBREAKS == *$word* && $current == *$word* ]]; then
            COMPREPLY=("${COMPREPLY[@]#"${current%$word*}$word"}")
        fi
    done
    return 0
}
complete -F NAME PROGRAM
)";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size()) {
        text.replace(at, what.size(), by);
    }
    return text;
}

std::string shell_name(const Command& program) {
    std::string name = "_" + program.words;
    std::ranges::replace(name, '-', '_');
    return name;
}

template <class Items, class Text>
std::string listed(const Items& items, const Text& text) {
    std::vector<std::string> words;
    words.reserve(items.size());
    for (const auto& item : items) words.push_back(text(item));
    return fmt::format("{}", fmt::join(words, " "));
}

std::string texts(const std::vector<Word>& words) {
    return listed(words, [](const Word& word) { return word.text; });
}

/// A function of the script: a case that sets what stands behind each pattern.
std::string function(const std::string& name, const char* about, const char* subject,
                     const std::string& cases) {
    return fmt::format("\n# {}\n{}()\n{{\n    case {} in\n{}        *) return 1 ;;\n    esac\n}}\n",
                       about, name, subject, cases);
}

std::string offers(const Command& program) {
    std::string cases;
    for (const Command* command : whole_family(program)) {
        std::vector<std::string> options;
        for (const Argument& argument : command->arguments) {
            if (!argument.positional) {
                options.insert(options.end(), argument.names.begin(), argument.names.end());
            }
        }
        const std::string below = listed(command->subcommands, [](const Command& subcommand) {
            return subcommand.words.substr(subcommand.words.rfind(' ') + 1);
        });
        cases += fmt::format("        \"{}\") subcommands=\"{}\" options=\"{}\" ;;\n",
                             command->below, below, fmt::join(options, " "));
    }
    return cases;
}

/// The patterns of "COMMAND ARGUMENT" that the argument is: one for each name; a positional is
/// known by its place, a repeated one by all from there on.
std::vector<std::string> patterns(const Command& command, const Argument& argument, int place) {
    std::vector<std::string> found;
    if (argument.positional) {
        found.push_back(fmt::format("\"{} {}\"", command.below, place));
        if (argument.repeated) {
            for (int next = place + 1; next <= 9; ++next) {
                found.push_back(fmt::format("\"{} {}\"", command.below, next));
            }
            found.push_back(fmt::format("\"{} \"[1-9][0-9]*", command.below));
        }
    } else {
        for (const std::string& name : argument.names) {
            found.push_back(fmt::format("\"{} {}\"", command.below, name));
        }
    }
    return found;
}

std::string kind_word(Keys kind) {
    const auto* const found =
        std::ranges::find(kKinds, kind, [](const auto& entry) { return entry.first; });
    return found == kKinds.end() ? "" : found->second;
}

std::string settings(const Values& values) {
    std::vector<std::string> parts;
    if (!values.words.empty()) parts.push_back(fmt::format("words=\"{}\"", texts(values.words)));
    if (values.paths == Values::Paths::files) parts.emplace_back("paths=-f");
    if (values.paths == Values::Paths::folders) parts.emplace_back("paths=-d");
    if (values.keys != Keys::none) parts.push_back("keys=" + kind_word(values.keys));
    return fmt::format("{}", fmt::join(parts, " "));
}

/// The cases of values, each list of values once.
std::string value_cases(const Command& program) {
    std::vector<std::pair<std::string, std::vector<std::string>>> cases;
    for (const Command* command : whole_family(program)) {
        int place = 0;
        for (const Argument& argument : command->arguments) {
            const std::vector<std::string> names =
                patterns(*command, argument, argument.positional ? place++ : 0);
            const std::string set = settings(values_of(*command, argument));
            if (set.empty()) continue;
            auto found = std::ranges::find(cases, set, [](const auto& c) { return c.first; });
            if (found == cases.end()) found = cases.insert(found, {set, {}});
            found->second.insert(found->second.end(), names.begin(), names.end());
        }
    }
    std::string text;
    for (const auto& [set, names] : cases) {
        text += fmt::format("        {})\n            {} ;;\n", fmt::join(names, " | "), set);
    }
    return text;
}

std::string taking(const Command& program) {
    std::vector<std::string> names;
    for (const Command* command : whole_family(program)) {
        for (const Argument& argument : command->arguments) {
            if (argument.positional || argument.value.empty() || argument.value_may_go) continue;
            const std::vector<std::string> own = patterns(*command, argument, 0);
            names.insert(names.end(), own.begin(), own.end());
        }
    }
    return names.empty() ? "" : fmt::format("        {}) ;;\n", fmt::join(names, " | "));
}

std::vector<Keys> kinds_used(const Command& program) {
    std::vector<Keys> used;
    for (const Command* command : whole_family(program)) {
        for (const Argument& argument : command->arguments) {
            const Keys kind = values_of(*command, argument).keys;
            if (kind != Keys::none && std::ranges::find(used, kind) == used.end()) {
                used.push_back(kind);
            }
        }
    }
    return used;
}

std::string key_cases(const std::vector<Keys>& kinds) {
    std::string cases;
    for (const Keys kind : kinds) {
        cases +=
            fmt::format("        {}) words=\"{}\" ;;\n", kind_word(kind),
                        listed(keys_of(kind), [](const Key& key) { return key.word.text + "="; }));
    }
    return cases;
}

std::string choice_cases(const std::vector<Keys>& kinds) {
    std::string cases;
    for (const Keys kind : kinds) {
        for (const Key& key : keys_of(kind)) {
            if (key.choices.empty()) continue;
            cases += fmt::format("        \"{} {}\") words=\"{}\" ;;\n", kind_word(kind),
                                 key.word.text, texts(key.choices));
        }
    }
    return cases;
}

}  // namespace

std::string bash_completion(const Command& program) {
    const std::string name = shell_name(program);
    const std::vector<Keys> kinds = kinds_used(program);
    std::string text = fmt::format(
        "# What bash offers for {}; made from the program's own options.\n", program.words);
    text += function(name + "_offers", "COMMAND: sets subcommands and options to what it has.",
                     "$1", offers(program));
    text +=
        function(name + "_takes", "COMMAND OPTION: whether a value follows as a word of its own.",
                 "\"$1 $2\"", taking(program));
    text +=
        function(name + "_values",
                 "COMMAND ARGUMENT, an option or the number of a place: sets words, paths, keys.",
                 "\"$1 $2\"", value_cases(program));
    text += function(name + "_keys", "KIND: sets words to the keys of KEY=VALUE.", "$1",
                     key_cases(kinds));
    text +=
        function(name + "_choices", "KIND KEY: sets words to the values of a key that has some.",
                 "\"$1 $2\"", choice_cases(kinds));
    return text + replaced(replaced(kScript, "NAME", name), "PROGRAM", program.words);
}

}  // namespace hitos::manual
