// SPDX-License-Identifier: GPL-3.0-or-later
#include "plain_decimal.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>

namespace hitos {
namespace {

/// Holds the front of `text` against what std::from_chars makes of its first field.
testing::AssertionResult agrees(std::string_view text) {
    const plain::Decimal found = plain::decimal(text.data(), text.data() + text.size());
    if (found.length == 0) return testing::AssertionSuccess();
    const std::string_view field = text.substr(0, text.find_first_of(" \t\v\f\r\n"));
    if (found.length != field.size()) {
        return testing::AssertionFailure() << '"' << text << "\": length " << found.length;
    }
    const char* first = field.data() + (field.front() == '+' ? 1 : 0);
    const char* end = field.data() + field.size();
    double expected = 0.0;
    const auto [stop, error] = std::from_chars(first, end, expected);
    if (error != std::errc{} || stop != end ||
        std::bit_cast<std::uint64_t>(expected) != std::bit_cast<std::uint64_t>(found.value)) {
        return testing::AssertionFailure() << '"' << text << "\": " << found.value;
    }
    return testing::AssertionSuccess();
}

TEST(PlainDecimal, AgreesOnEveryShortText) {
    constexpr std::string_view kCharacters = "059.-+ e\x1f";
    constexpr std::size_t kLongest = 6;
    std::size_t texts = 1;
    for (std::size_t length = 1; length <= kLongest; ++length) {
        texts *= kCharacters.size();
        std::string text(length, ' ');
        for (std::size_t number = 0; number < texts; ++number) {
            std::size_t rest = number;
            for (char& c : text) {
                c = kCharacters[rest % kCharacters.size()];
                rest /= kCharacters.size();
            }
            ASSERT_TRUE(agrees(text));
            ASSERT_TRUE(agrees(text + " 12.34567"));
        }
    }
}

TEST(PlainDecimal, AgreesOnNumbersOfEveryLength) {
    std::mt19937_64 random(1);
    constexpr int kNumbers = 300000;
    for (int i = 0; i < kNumbers; ++i) {
        std::string text;
        if (random() % 4 == 0) text += random() % 2 == 0 ? '-' : '+';
        for (std::uint64_t digits = random() % 13; digits > 0; --digits) {
            text += static_cast<char>('0' + random() % 10);
        }
        if (random() % 4 != 0) text += '.';
        for (std::uint64_t digits = random() % 11; digits > 0; --digits) {
            text += static_cast<char>('0' + random() % 10);
        }
        if (random() % 16 == 0) text += "e1"[random() % 2];
        ASSERT_TRUE(agrees(text));
        ASSERT_TRUE(agrees(text + " 1"));
        ASSERT_TRUE(agrees(text + "\t-77.123456"));
    }
}

TEST(PlainDecimal, KnowsWhatLogsHold) {
    for (const std::string_view text :
         {"1", "0", "81.83", "1.000", "+1.5708", "-0.000", "+37.495", "0.281475", "-50.790588",
          "0000000005.400", "152468.2151", "16777343", "+0.01735687", "1119033484.123456"}) {
        for (const std::string_view behind : {"", " ", " 1 2 3 4 5 6"}) {
            const std::string line = std::string(text).append(behind);
            EXPECT_EQ(plain::decimal(line.data(), line.data() + line.size()).length, text.size())
                << line;
            EXPECT_TRUE(agrees(line));
        }
    }
    for (const std::string_view text : {"", "-", "+", ".", "1e3", "nan", "1.2.3", "0x10", "1,5",
                                        "123456789012", "9999999999.99999999", "+-1", "--1"}) {
        EXPECT_EQ(plain::decimal(text.data(), text.data() + text.size()).length, 0U) << text;
    }
}

}  // namespace
}  // namespace hitos
