// SPDX-License-Identifier: GPL-3.0-or-later
#include "command.hpp"

#include <sstream>

namespace hitos::manual {
namespace {

/// Splits "TEXT:{en,es}" or "INT:INT in [1 - 9]", as CLI11 tells types and checks.
void take_type(const std::string& type, Argument& argument) {
    const std::size_t colon = type.find(':');
    argument.value = type.substr(0, colon);
    if (colon == std::string::npos) return;
    const std::string check = type.substr(colon + 1);
    if (check.starts_with('{') && check.ends_with('}')) {
        std::istringstream words(check.substr(1, check.size() - 2));
        for (std::string word; std::getline(words, word, ',');) argument.words.push_back(word);
        return;
    }
    const std::size_t open = check.find('[');
    argument.range =
        open == std::string::npos ? check : check.substr(open + 1, check.size() - open - 2);
}

Argument argument_of(const CLI::Option& option) {
    Argument argument;
    argument.positional = option.get_positional();
    if (argument.positional) {
        argument.names.push_back(option.get_name(true));
    } else {
        for (const std::string& name : option.get_snames()) argument.names.push_back("-" + name);
        for (const std::string& name : option.get_lnames()) argument.names.push_back("--" + name);
    }
    argument.meaning = option.get_description();
    argument.required = option.get_required();
    const bool flag = option.get_expected_max() == 0 || option.get_type_size_max() == 0;
    argument.value_may_go = !option.get_fnames().empty();
    if (!flag) take_type(option.get_type_name(), argument);
    argument.repeated = argument.positional &&
                        option.get_items_expected_max() >= CLI::detail::expected_max_vector_size;
    for (const CLI::Option* other : option.get_excludes()) {
        argument.excludes.push_back(other->get_name(false, false));
    }
    return argument;
}

/// `above`: the command that this one is a subcommand of; null for a program.
Command described(const CLI::App& app, const Command* above) {
    Command command;
    command.purpose = app.get_description();
    command.footer = app.get_footer();
    command.words = app.get_name();
    if (above != nullptr) {
        command.words = above->words + " " + app.get_name();
        command.below = (above->below.empty() ? "" : above->below + " ") + app.get_name();
        const CLI::App* parent = app.get_parent();
        if (command.footer == parent->get_footer()) command.footer.clear();  // inherited
    }
    for (const CLI::Option* option : app.get_options()) {
        if (!option->get_group().empty()) command.arguments.push_back(argument_of(*option));
    }
    for (const CLI::App* below : app.get_subcommands([](const CLI::App*) { return true; })) {
        if (!below->get_group().empty()) {
            command.subcommands.push_back(described(*below, &command));
        }
    }
    return command;
}

}  // namespace

Command command_of(const CLI::App& program) {
    return described(program, nullptr);
}

std::vector<const Command*> whole_family(const Command& command) {
    std::vector<const Command*> family{&command};
    for (std::size_t k = 0; k < family.size(); ++k) {
        for (const Command& below : family[k]->subcommands) family.push_back(&below);
    }
    return family;
}

}  // namespace hitos::manual
