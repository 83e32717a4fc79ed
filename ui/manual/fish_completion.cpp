// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "completions.hpp"
#include "values.hpp"

namespace hitos::manual {
namespace {

/// In single quotes.
std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char letter : text) {
        if (letter == '\'' || letter == '\\') result += '\\';
        result += letter == '\n' || letter == '\t' ? ' ' : letter;
    }
    return result + "'";
}

/// The script of one program: functions first, then a line for each option.
class Script {
  public:
    explicit Script(const Command& program) : program_(program), name_("__" + program.words) {
        std::ranges::replace(name_, '-', '_');
    }

    std::string text() {
        std::string lines;
        for (const Command* command : whole_family(program_)) lines += command_lines(*command);
        return fmt::format("# What fish offers for {}; made from the program's own options.\n",
                           program_.words) +
               at_function() + functions_ + fmt::format("\ncomplete -c {} -f\n", program_.words) +
               lines;
    }

  private:
    /// Tells which subcommand the words before the cursor have chosen.
    std::string at_function() const {
        std::string cases;
        for (const Command* command : whole_family(program_)) {
            if (command->below.empty()) continue;
            const std::size_t last = command->below.rfind(' ');
            const std::string pattern =
                last == std::string::npos ? " " + command->below : command->below;
            cases += " " + quoted(pattern);
        }
        if (cases.empty()) cases = " ''";
        return fmt::format(
            "\nfunction {0}_at\n    set -l command ''\n    for word in (commandline -opc)[2..]\n"
            "        switch \"$command $word\"\n            case{1}\n"
            "                set command (string trim \"$command $word\")\n        end\n    end\n"
            "    test \"$command\" = \"$argv[1]\"\nend\n",
            name_, cases);
    }

    /// The name of a function that prints these words with their meanings, a line each.
    std::string function_of(const std::vector<Word>& words) {
        auto known = std::ranges::find(lists_, words);
        if (known == lists_.end()) {
            std::string printed;
            for (const Word& word : words) {
                printed +=
                    fmt::format(" \\\n        {} {}", quoted(word.text), quoted(word.meaning));
            }
            functions_ += fmt::format("\nfunction {}_words_{}\n    printf '%s\\t%s\\n'{}\nend\n",
                                      name_, lists_.size() + 1, printed);
            known = lists_.insert(known, words);
        }
        return fmt::format("{}_words_{}", name_, known - lists_.begin() + 1);
    }

    static std::vector<Word> assignments(Keys kind) {
        std::vector<Word> words;
        for (const Key& key : keys_of(kind)) {
            words.push_back({key.word.text + "=", key.word.meaning});
            for (const Word& choice : key.choices) {
                const std::string& meaning =
                    choice.meaning.empty() ? key.word.meaning : choice.meaning;
                words.push_back({key.word.text + "=" + choice.text, meaning});
            }
        }
        return words;
    }

    /// What follows -c NAME -n CONDITION for values: "-x -a '(…)'".
    std::string values(const Values& values) {
        const std::vector<Word> words =
            values.keys == Keys::none ? values.words : assignments(values.keys);
        const std::string list = words.empty() ? "" : function_of(words);
        if (values.paths == Values::Paths::files) {
            return " -F" + (list.empty() ? "" : fmt::format(" -a '({})'", list));
        }
        if (values.paths == Values::Paths::folders) return " -a '(__fish_complete_directories)'";
        return list.empty() ? "" : fmt::format(" -a '({})'", list);
    }

    std::string command_lines(const Command& command) {
        const std::string begin =
            fmt::format("complete -c {} -n '{}_at {}'", program_.words, name_,
                        command.below.empty() ? "\"\"" : "\"" + command.below + "\"");
        std::string lines = "\n";
        for (const Command& below : command.subcommands) {
            lines +=
                fmt::format("{} -a {} -d {}\n", begin,
                            below.words.substr(below.words.rfind(' ') + 1), quoted(below.purpose));
        }
        for (const Argument& argument : command.arguments) {
            const std::string what = values(values_of(command, argument));
            if (argument.positional) {
                if (!what.empty()) lines += begin + what + "\n";
                continue;
            }
            std::string line = begin;
            for (const std::string& name : argument.names) {
                line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
            }
            const bool takes = !argument.value.empty() && !argument.value_may_go;
            if (takes) line += what.starts_with(" -F") ? " -r" : " -x";
            if (takes || argument.value_may_go) line += what;
            lines += fmt::format("{} -d {}\n", line, quoted(argument.meaning));
        }
        return lines;
    }

    const Command& program_;
    std::string name_;
    std::vector<std::vector<Word>> lists_;
    std::string functions_;
};

}  // namespace

std::string fish_completion(const Command& program) {
    return Script(program).text();
}

}  // namespace hitos::manual
