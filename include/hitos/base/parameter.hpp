// SPDX-License-Identifier: GPL-3.0-or-later
// One entry for each parameter: what it is, how it is reached and when it has an effect.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "hitos/base/message.hpp"
#include "hitos/base/registry.hpp"

namespace hitos {

/// A word that a parameter can take, and what forms call it.
struct ParameterChoice {
    std::string word;          ///< as files and command lines say it: "split-merge"
    std::string label = {};    ///< translated in the context "ParameterChoice"
    std::string purpose = {};  ///< half a sentence for help texts, or empty
};

/// What is said of a parameter, whichever struct it belongs to. Files, options, forms, help texts
/// and checks are made of it.
struct ParameterFacts {
    enum class Type { real, integer, choice, text };
    /// Of a real, an integer, and the word of a choice or a text.
    using Value = std::variant<double, std::int64_t, std::string>;

    std::string_view key = {};          ///< "split_merge.dmax"
    std::string_view unit = {};         ///< "m", "rad", "m^2", … or empty
    double minimum = 0.0;               ///< numbers: smallest value allowed
    double maximum = 0.0;               ///< numbers: greatest value allowed
    std::string_view label = {};        ///< translated in the context "ParameterLabel"
    std::string_view description = {};  ///< translated in the context "Parameter"
    std::string_view card = {};         ///< table of the summary card that shows it, or empty
    std::string_view symbol = {};       ///< the thesis's: "Dmax"; empty where it has none
    std::vector<ParameterChoice> choices = {};
    Type type = Type::real;  ///< the builders below set it

    /// What is allowed, in words: "0 to 10 m", "one of ml, gnn", "any text".
    std::string allowed() const;
    Message allowed_message() const;
    bool allows(const Value& value) const;
    /// Exact: reading it back gives the same bits.
    std::string text_of(const Value& value) const;
    /// Throws ConfigError that names key, value found and what is allowed.
    Value value_from(std::string_view text) const;
    /// Throws ConfigError where the value is not allowed.
    void check_value(const Value& value) const;
    /// Where the word stands among the choices.
    std::optional<std::size_t> place_of(std::string_view word) const;
    /// "split_merge" of "split_merge.dmax": the table of files that it stands in.
    std::string_view table() const { return key.substr(0, key.find('.')); }
};

/// A parameter of `Owner`, the struct that holds its value.
template <class Owner>
struct Parameter : ParameterFacts {
    /// What must be so for the parameter to have an effect.
    struct Condition {
        std::string_view key;  ///< of the parameter that decides: "features.method"
        std::string needed;    ///< "ransac", "odometry or no-odometry"
        std::function<bool(const Owner&)> holds;
    };

    std::function<Value(const Owner&)> get;
    std::function<void(Owner&, const Value&)> put;  ///< checks nothing
    std::vector<Condition> conditions;              ///< all of them must hold
    /// Which of several units the value has beside the owner's other values; null: `unit`.
    std::function<std::string_view(const Owner&)> unit_now = {};

    std::string_view unit_of(const Owner& owner) const { return unit_now ? unit_now(owner) : unit; }
    std::string text(const Owner& owner) const { return text_of(get(owner)); }
    /// Sets the value from text. Throws ConfigError that names key, value found and what is
    /// allowed; the owner is then unchanged.
    void set(Owner& owner, std::string_view value) const { put(owner, value_from(value)); }
    /// Throws ConfigError where the owner's value is not allowed.
    void check(const Owner& owner) const { check_value(get(owner)); }
    /// Whether the value has an effect beside the owner's other values.
    bool used_by(const Owner& owner) const { return unmet(owner) == nullptr; }
    /// The first condition that does not hold; null where the parameter has an effect.
    const Condition* unmet(const Owner& owner) const {
        const auto found = std::ranges::find_if(
            conditions, [&](const Condition& condition) { return !condition.holds(owner); });
        return found == conditions.end() ? nullptr : &*found;
    }
};

namespace parameter_detail {

template <class>
struct OwnerOfMember;
template <class Owner, class Member>
struct OwnerOfMember<Member Owner::*> {
    using type = Owner;
};
template <auto First, auto...>
struct OwnerOfFirst : OwnerOfMember<decltype(First)> {};

template <auto... Members>
using OwnerOf = typename OwnerOfFirst<Members...>::type;

/// Follows pointers to members from the owner down to one of its values.
template <auto... Members>
auto& reach(auto& owner) {
    return (owner.*....*Members);
}

template <auto... Members>
using Reached =
    std::remove_cvref_t<decltype(reach<Members...>(std::declval<OwnerOf<Members...>&>()))>;

std::string joined(std::span<const std::string_view> words, std::string_view last);
std::vector<std::string_view> near_keys(std::string_view key,
                                        std::span<const std::string_view> keys);
/// Throws ConfigError.
[[noreturn]] void refuse_key(std::string_view key, std::span<const std::string_view> near,
                             const Message& otherwise);

}  // namespace parameter_detail

/// What tables of parameters are written with: the facts in the order of ParameterFacts, then what
/// must be so for the parameter to have an effect.
namespace declare {

template <auto... Members>
using Conditions =
    std::vector<typename Parameter<parameter_detail::OwnerOf<Members...>>::Condition>;

/// What is said of a parameter whose values are words, as ParameterFacts has it.
struct WordFacts {
    std::string_view key = {};
    std::string_view label = {};
    std::string_view description = {};
    std::string_view card = {};
};
ParameterFacts facts_of(const WordFacts& facts, ParameterFacts::Type type,
                        std::vector<ParameterChoice> choices);

/// A real parameter at the end of pointers to members: real<&LaserParams::sigma_m>({...}).
template <auto... Members>
auto real(ParameterFacts facts, Conditions<Members...> conditions = {}) {
    using Owner = parameter_detail::OwnerOf<Members...>;
    facts.type = ParameterFacts::Type::real;
    return Parameter<Owner>{std::move(facts),
                            [](const Owner& o) { return parameter_detail::reach<Members...>(o); },
                            [](Owner& o, const ParameterFacts::Value& value) {
                                parameter_detail::reach<Members...>(o) = std::get<double>(value);
                            },
                            std::move(conditions)};
}

template <auto... Members>
auto integer(ParameterFacts facts, Conditions<Members...> conditions = {}) {
    using Owner = parameter_detail::OwnerOf<Members...>;
    facts.type = ParameterFacts::Type::integer;
    return Parameter<Owner>{
        std::move(facts),
        [](const Owner& o) {
            return static_cast<std::int64_t>(parameter_detail::reach<Members...>(o));
        },
        [](Owner& o, const ParameterFacts::Value& value) {
            parameter_detail::reach<Members...>(o) =
                static_cast<parameter_detail::Reached<Members...>>(std::get<std::int64_t>(value));
        },
        std::move(conditions)};
}

template <auto... Members>
auto text(const WordFacts& facts, Conditions<Members...> conditions = {}) {
    using Owner = parameter_detail::OwnerOf<Members...>;
    return Parameter<Owner>{facts_of(facts, ParameterFacts::Type::text, {}),
                            [](const Owner& o) { return parameter_detail::reach<Members...>(o); },
                            [](Owner& o, const ParameterFacts::Value& value) {
                                parameter_detail::reach<Members...>(o) =
                                    std::get<std::string>(value);
                            },
                            std::move(conditions)};
}

/// A choice among words. The member is a string, which holds the word, or an enum or bool, whose
/// values count the choices from 0.
template <auto... Members>
auto choice(const WordFacts& facts, const std::vector<ParameterChoice>& choices,
            Conditions<Members...> conditions = {}) {
    using Owner = parameter_detail::OwnerOf<Members...>;
    using Member = parameter_detail::Reached<Members...>;
    if constexpr (std::is_same_v<Member, std::string>) {
        Parameter<Owner> parameter = text<Members...>(facts, std::move(conditions));
        parameter.type = ParameterFacts::Type::choice;
        parameter.choices = choices;
        return parameter;
    } else {
        return Parameter<Owner>{
            facts_of(facts, ParameterFacts::Type::choice, choices),
            [choices](const Owner& o) {
                const auto place = static_cast<std::size_t>(parameter_detail::reach<Members...>(o));
                // A value out of its enum is a bug of the code that filled the struct; check()
                // tells.
                return place < choices.size() ? choices[place].word : std::to_string(place);
            },
            [choices](Owner& o, const ParameterFacts::Value& value) {
                const auto found = std::ranges::find(choices, std::get<std::string>(value),
                                                     &ParameterChoice::word);
                parameter_detail::reach<Members...>(o) =
                    static_cast<Member>(found - choices.begin());
            },
            std::move(conditions)};
    }
}

/// Those of a bool.
std::vector<ParameterChoice> off_on();

/// The choices that a registry knows; closes it.
template <class Entry>
std::vector<ParameterChoice> choices_of(const Registry<Entry>& registry) {
    std::vector<ParameterChoice> choices;
    for (const Entry& entry : registry.entries())
        choices.push_back({entry.word, entry.label, entry.purpose});
    return choices;
}

/// Read only where the parameter `other` has one of these words.
template <class Owner>
typename Parameter<Owner>::Condition where(const Parameter<Owner>& other,
                                           std::vector<std::string> words) {
    const std::vector<std::string_view> views(words.begin(), words.end());
    return {other.key, parameter_detail::joined(views, " or "),
            [get = other.get, words = std::move(words)](const Owner& owner) {
                return std::ranges::find(words, std::get<std::string>(get(owner))) != words.end();
            }};
}

/// One table of several.
template <class Owner>
std::vector<Parameter<Owner>> together(
    std::initializer_list<std::vector<Parameter<Owner>>> tables) {
    std::vector<Parameter<Owner>> all;
    for (const auto& table : tables) all.insert(all.end(), table.begin(), table.end());
    return all;
}

}  // namespace declare

/// Gives the parameters that entries of the registry say they read the condition that one of those
/// entries is chosen, by the parameter `key` of the same table. Closes the registry.
template <class Owner, class Entry>
void heed_readers(std::vector<Parameter<Owner>>& table, std::string_view key,
                  const Registry<Entry>& registry) {
    const auto chooser = std::ranges::find(table, key, &ParameterFacts::key);
    for (Parameter<Owner>& parameter : table) {
        std::vector<std::string> readers;
        for (const Entry& entry : registry.entries()) {
            if (std::ranges::find(entry.reads, parameter.key) != entry.reads.end()) {
                readers.push_back(entry.word);
            }
        }
        if (readers.empty() || readers.size() == registry.entries().size()) continue;
        // In front: what another choice needs matters only after this one.
        parameter.conditions.insert(parameter.conditions.begin(),
                                    declare::where(*chooser, std::move(readers)));
    }
}

/// The parameter of a part as one of the whole.
template <class Whole, class Part>
Parameter<Whole> lifted(const Parameter<Part>& parameter, Part Whole::*part) {
    using Value = ParameterFacts::Value;
    Parameter<Whole> whole{
        static_cast<const ParameterFacts&>(parameter),
        [get = parameter.get, part](const Whole& owner) { return get(owner.*part); },
        [put = parameter.put, part](Whole& owner, const Value& value) { put(owner.*part, value); },
        {}};
    for (const auto& condition : parameter.conditions) {
        whole.conditions.push_back(
            {condition.key, condition.needed,
             [holds = condition.holds, part](const Whole& owner) { return holds(owner.*part); }});
    }
    if (parameter.unit_now) {
        whole.unit_now = [unit = parameter.unit_now, part](const Whole& owner) {
            return unit(owner.*part);
        };
    }
    return whole;
}

/// The parameter of that key; null where there is none.
template <class Owner>
const Parameter<Owner>* look_up(std::span<const Parameter<Owner>> table, std::string_view key) {
    const auto found = std::ranges::find(table, key, &ParameterFacts::key);
    return found == table.end() ? nullptr : &*found;
}

/// The parameter of that key. Throws ConfigError that names near keys where there is none, or says
/// `otherwise` where no key is near.
template <class Owner>
const Parameter<Owner>& find_parameter(std::span<const Parameter<Owner>> table,
                                       std::string_view key, const Message& otherwise) {
    if (const Parameter<Owner>* found = look_up(table, key)) return *found;
    std::vector<std::string_view> keys;
    for (const Parameter<Owner>& parameter : table) keys.push_back(parameter.key);
    parameter_detail::refuse_key(key, parameter_detail::near_keys(key, keys), otherwise);
}

/// Throws ConfigError for the first value that is not allowed; code can fill a struct without
/// set().
template <class Owner>
void check_all(std::span<const Parameter<Owner>> table, const Owner& owner) {
    for (const Parameter<Owner>& parameter : table) parameter.check(owner);
}

}  // namespace hitos
