// SPDX-License-Identifier: GPL-3.0-or-later
// What can stand as the value of an argument, for completions: from the tables of formats, presets,
// worlds and parameters.
#pragma once

#include <string>
#include <vector>

#include "command.hpp"

namespace hitos::manual {

/// Whose keys come before the `=` of KEY=VALUE.
enum class Keys { none, configuration, world, study };

struct Word {
    std::string text;
    std::string meaning;  ///< half a sentence, or empty

    bool operator==(const Word&) const = default;
};

/// What an argument takes.
struct Values {
    enum class Paths { none, files, folders };

    std::vector<Word> words;
    Paths paths = Paths::none;
    Keys keys = Keys::none;

    bool operator==(const Values&) const = default;
};

/// A key of KEY=VALUE with the words that it can take, where it takes some.
struct Key {
    Word word;
    std::vector<Word> choices;
};

/// All of that kind.
std::vector<Key> keys_of(Keys kind);

Values values_of(const Command& command, const Argument& argument);

}  // namespace hitos::manual
