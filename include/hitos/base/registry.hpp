// SPDX-License-Identifier: GPL-3.0-or-later
// Named ways of doing one thing: line methods, motion models, log formats and the like.
#pragma once

#include <atomic>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/base/translatable.hpp"

namespace hitos {

/// What every entry of a registry has; help texts, forms and messages are made of it.
struct RegistryEntry {
    std::string word;     ///< as files and command lines say it: "split-merge"
    std::string label;    ///< as forms show it: HITOS_TEXT("ParameterChoice", "Split and Merge")
    std::string purpose;  ///< half a sentence for help texts
    /// Keys of the parameters that only some entries of the registry read, this one among them. A
    /// parameter that an entry names has no effect where another entry is chosen that does not.
    std::vector<std::string> reads = {};
};

/// The entries that a program knows, in the order of their arrival; the first is the default.
/// `Entry` derives from RegistryEntry or has its word and label. A registry is filled by explicit
/// calls before it is first used: from the first look-up on it is closed, so that every part of a
/// program, on every thread, sees the same entries.
template <class Entry>
class Registry {
  public:
    /// `what` names the kind of thing in messages: "line method"; `key` the parameter or option
    /// that chooses one: "features.method".
    Registry(std::string what, std::string key, std::vector<Entry> built_in)
        : what_(std::move(what)), key_(std::move(key)) {
        for (Entry& entry : built_in) add(std::move(entry));
    }

    /// Throws ConfigError where the word is empty or taken, or the registry closed.
    void add(Entry entry) {
        if (closed_) {
            throw ConfigError(
                key_,
                HITOS_TEXT("Errors",
                           "the %1 \"%2\" comes too late; add it before anything is read or run"),
                what_, entry.word);
        }
        if (entry.word.empty() || entry.word == "auto") {
            throw ConfigError(
                key_, HITOS_TEXT("Errors", "found a %1 of the word \"%2\"; give it one of its own"),
                what_, entry.word);
        }
        if (const Entry* known = look_up(entry.word)) {
            throw ConfigError(
                key_,
                HITOS_TEXT("Errors",
                           "the %1 \"%2\" (%3) is known already as %4; give it another word"),
                what_, entry.word, entry.label, known->label);
        }
        entries_.push_back(std::move(entry));
    }

    /// All of them; closes the registry.
    const std::vector<Entry>& entries() const {
        closed_ = true;
        return entries_;
    }
    /// The entry of that word. Throws ConfigError that lists the words there are.
    const Entry& find(std::string_view word) const {
        closed_ = true;
        if (const Entry* entry = look_up(word)) return *entry;
        throw ConfigError(key_, HITOS_TEXT("Errors", "found \"%1\", expected %2"), word, either());
    }
    bool knows(std::string_view word) const {
        closed_ = true;
        return look_up(word) != nullptr;
    }
    /// "split-merge, ransac".
    std::string words() const {
        closed_ = true;
        std::string list;
        for (const Entry& entry : entries_) list += (list.empty() ? "" : ", ") + entry.word;
        return list;
    }

    /// "split-merge or ransac".
    Message either() const {
        return either([](const Entry&) { return true; });
    }
    /// Of the entries that are wanted.
    template <class Wanted>
    Message either(const Wanted& wanted) const {
        closed_ = true;
        std::vector<std::string_view> listed;
        for (const Entry& entry : entries_) {
            if (wanted(entry)) listed.push_back(entry.word);
        }
        return hitos::either(listed);
    }

    /// Whether the parameter has an effect where the entry of this word is chosen: it reads the
    /// parameter, or no entry of this registry names it.
    bool reads(std::string_view word, std::string_view parameter) const {
        closed_ = true;
        bool named = false;
        for (const Entry& entry : entries_) {
            for (const std::string& key : entry.reads) {
                if (key != parameter) continue;
                named = true;
                if (entry.word == word) return true;
            }
        }
        return !named;
    }

  private:
    const Entry* look_up(std::string_view word) const {
        for (const Entry& entry : entries_) {
            if (entry.word == word) return &entry;
        }
        return nullptr;
    }

    std::string what_;
    std::string key_;
    std::vector<Entry> entries_;
    mutable std::atomic<bool> closed_ = false;
};

}  // namespace hitos
