// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/text_limits.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "hitos/base/error.hpp"
#include "support.hpp"

namespace hitos::input {
namespace {

using test::message_of;
using ::testing::HasSubstr;

std::string repeated(std::string_view what, int times) {
    std::string text;
    for (int i = 0; i < times; ++i) text += what;
    return text;
}

TEST(TextLimits, WhatIsWithinThemIsHandedOnAsItIs) {
    const std::vector<std::string> files{
        "a.b.c = 1.5\n[x.y]\nz = [[1, 2.5], [3]]\n",
        "s = \"" + repeated("[", 100) + "\" # " + repeated("{", 100) + "\n",
        "s = '" + repeated(".", 100) + "'\nt = '''" + repeated("[\n", 100) + "'''\n",
        "s = \"\"\"a\\\"\"\" \"\" [ \"\"\"\"\"\nt = \"\\\"[\"\n",
        repeated("a = [1.5, 2.5]\n", 1000)};
    for (const std::string& text : files) EXPECT_EQ(checked_toml(text, "f"), text);
    const std::string json = R"({"a.b": [1.5, ")" + repeated("[", 100) + R"("], "#": "'"})";
    EXPECT_EQ(checked_json(json, "f"), json);
}

TEST(TextLimits, DepthLengthAndCountAreRefusedWithTheirLine) {
    const auto toml = [](const std::string& text) {
        return message_of<FormatError>([&] { checked_toml(text, "w.toml"); });
    };
    EXPECT_THAT(toml("\n" + repeated("a.", 31000) + "a = 1"),
                HasSubstr("w.toml:2: has a key of more than 16 parts"));
    EXPECT_THAT(toml("[" + repeated("\"a\" . ", 31000) + "a]"), HasSubstr("w.toml:1: has a key"));
    EXPECT_THAT(toml("a = {" + repeated("a.", 31000) + "a = 1}"), HasSubstr("w.toml:1: has a key"));
    EXPECT_THAT(toml("a = " + repeated("[", 65)), HasSubstr("is nested deeper than 64 levels"));
    EXPECT_THAT(toml("a = " + repeated("{a=", 65)), HasSubstr("is nested deeper than 64 levels"));
    // Quotes that end no string hide nothing.
    EXPECT_THAT(toml("a = [\"\"\"x\"\"\"\"\", " + repeated("[", 65)), HasSubstr("nested deeper"));
    EXPECT_THAT(toml("a = [" + repeated("1,", 1'000'001)), HasSubstr("more than 1000000 values"));
    EXPECT_THAT(toml(std::string((std::size_t{1} << 24) + 1, '\n')), HasSubstr("16 MiB"));
    EXPECT_THAT(message_of<FormatError>([] { checked_json(repeated("[", 65), "s.json"); }),
                HasSubstr("s.json:1: is nested deeper than 64 levels"));
}

}  // namespace
}  // namespace hitos::input
