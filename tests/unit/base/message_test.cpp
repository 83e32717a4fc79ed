// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/message.hpp"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <string>
#include <type_traits>

#include "hitos/base/error.hpp"

namespace hitos {
namespace {

std::string in_spanish(const Message& message) {
    static const std::map<std::string, std::string> words = {
        {"found %1 fields; %2", "%2, pero hay %1 campos"},
        {"expected %1", "se esperaba %1"},
        {"a number", "un número"},
        {"%1 or %2", "%1 o %2"},
        {"line %1: %2", "línea %1: %2"}};
    return message.translated([](const char* text) {
        const auto found = words.find(text);
        return found == words.end() ? std::string(text) : found->second;
    });
}

Message nested() {
    return message("found %1 fields; %2", 3, message("expected %1", marked("a number")));
}

TEST(Message, IsItsEnglishTextWithTheArgumentsAtTheirPlaces) {
    EXPECT_EQ(nested().english(), "found 3 fields; expected a number");
    EXPECT_EQ(message("%1 %2 %3 %4", 0.1, std::string("a"), std::string_view("b"), "c").english(),
              "0.1 a b c");
    EXPECT_EQ(message("%2 before %1, 5 % and %0", 1, 2).english(), "2 before 1, 5 % and %0");
}

TEST(Message, IsTranslatedWithTheMessagesInIt) {
    EXPECT_EQ(in_spanish(nested()), "se esperaba un número, pero hay 3 campos");
}

TEST(Message, WhatIsToldAsItIsIsNotTranslated) {
    EXPECT_EQ(in_spanish(verbatim("a number")), "a number");
    EXPECT_EQ(in_spanish(message("expected %1", "a number")), "se esperaba a number");
}

TEST(Message, PlacesInsideOfArgumentsAreLeftAlone) {
    EXPECT_EQ(message("%1: %2", "100%2", "%1").english(), "100%2: %1");
}

TEST(Message, IsEmptyUntilItSaysSomething) {
    EXPECT_TRUE(Message().empty());
    EXPECT_EQ(Message().english(), "");
    EXPECT_FALSE(nested().empty());
    EXPECT_FALSE(verbatim("x").empty());
    EXPECT_TRUE(verbatim("").empty());
}

TEST(Message, IsMadeOfNoTextByAccident) {
    EXPECT_FALSE((std::is_convertible_v<std::string, Message>));
    EXPECT_FALSE((std::is_convertible_v<const char*, Message>));
    EXPECT_FALSE((std::is_constructible_v<FileError, std::string, std::string>));
}

TEST(Message, ListsWordsWithAnOr) {
    constexpr std::array<std::string_view, 3> kWords = {"a", "b", "c"};
    EXPECT_EQ(either(kWords).english(), "a, b or c");
    EXPECT_EQ(in_spanish(either(kWords)), "a, b o c");
    EXPECT_EQ(either(std::span(kWords).first(2)).english(), "a or b");
    EXPECT_EQ(either(std::span(kWords).first(1)).english(), "a");
    EXPECT_TRUE(either({}).empty());
}

TEST(Message, OfAnErrorHasThePlaceInIt) {
    EXPECT_STREQ(FileError("a.txt", nested()).what(), "a.txt: found 3 fields; expected a number");
    EXPECT_STREQ(ConfigError("key", verbatim("wrong")).what(), "key: wrong");
    const FormatError error("a.txt", 7, nested());
    EXPECT_STREQ(error.what(), "a.txt:7: found 3 fields; expected a number");
    EXPECT_EQ(in_spanish(error.message()), "a.txt:7: se esperaba un número, pero hay 3 campos");
    EXPECT_EQ(error.problem().english(), nested().english());
    EXPECT_STREQ(FormatError("a.txt", 0, verbatim("wrong")).what(), "a.txt: wrong");
    EXPECT_STREQ(FormatError("", 0, verbatim("wrong")).what(), "wrong");
    EXPECT_EQ(in_spanish(FormatError("", 7, verbatim("wrong")).message()), "línea 7: wrong");
    EXPECT_EQ(in_spanish(message_of(error)), in_spanish(error.message()));
    EXPECT_EQ(message_of(std::runtime_error("a number")).english(), "a number");
}

}  // namespace
}  // namespace hitos
