// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "test_files.hpp"
#include "text_out.hpp"

namespace hitos {
namespace {

TEST(Fields, SplitsOnRunsOfBlanks) {
    Fields fields("  a \t b  c ");
    EXPECT_EQ(fields.remaining(), 3U);
    EXPECT_EQ(fields.take(), "a");
    EXPECT_EQ(fields.peek(), "b");
    EXPECT_EQ(fields.take(), "b");
    EXPECT_EQ(fields.take(), "c");
    EXPECT_TRUE(fields.at_end());
    EXPECT_EQ(fields.take(), "");
}

TEST(Fields, ReadsNumbersAsLogsWriteThem) {
    EXPECT_EQ(parse_double("+00.500"), 0.5);
    EXPECT_EQ(parse_double("-01.234"), -1.234);
    EXPECT_EQ(parse_double("0000000300.000"), 300.0);
    EXPECT_EQ(parse_double("1e-3"), 0.001);
    EXPECT_TRUE(std::signbit(*parse_double("-0.000")));
    EXPECT_TRUE(std::isnan(*parse_double("nan")));
    EXPECT_TRUE(std::isnan(*parse_double("-nan")));
    EXPECT_TRUE(std::isinf(*parse_double("inf")));
    EXPECT_EQ(parse_integer("0181"), 181);
    EXPECT_EQ(parse_integer("008"), 8);
    EXPECT_EQ(parse_integer("-5"), -5);
    EXPECT_EQ(parse_integer("+7"), 7);
}

TEST(Fields, RefusesWhatIsNoNumber) {
    for (const char* text :
         {"", "+", "-", "+-1", "1.2x", "x1", "0x10", "1,5", "1.2.3", "--1", "1e999"}) {
        EXPECT_FALSE(parse_double(text)) << text;
    }
    for (const char* text : {"", "1.0", "1e2", "99999999999999999999", "a", "1-"}) {
        EXPECT_FALSE(parse_integer(text)) << text;
    }
}

TEST(Fields, ErrorNamesFieldFoundAndExpected) {
    const auto of = [](auto call) { return test::message_of<FormatError>(call); };
    EXPECT_EQ(of([] { Fields("1.2x", 7).number("px"); }),
              "line 7: px: found \"1.2x\", expected a number");
    EXPECT_EQ(of([] { Fields("", 7).number("px"); }),
              "line 7: px: found the end of the line, expected a value");
    EXPECT_EQ(of([] { Fields("-3", 1).count("count"); }),
              "line 1: count: found \"-3\", expected a whole number from 1");
    EXPECT_EQ(of([] { Fields("0", 1).count("count"); }),
              "line 1: count: found \"0\", expected a whole number from 1");
    EXPECT_EQ(of([] { Fields("nan", 1).number("time"); }),
              "line 1: time: found \"nan\", expected a finite number below 1e12");
    EXPECT_EQ(of([] { Fields("-1.1e12", 1).number("px"); }),
              "line 1: px: found \"-1.1e12\", expected a finite number below 1e12");
    EXPECT_EQ(of([] { Fields("9 8", 2).expect_end("stall"); }),
              "line 2: found \"9\" after stall, expected the end of the line");
    EXPECT_EQ(Fields("0", 1).count("n", 0), 0U);
    EXPECT_TRUE(std::isnan(Fields("nan", 1).reading("range")));
}

TEST(Fields, LongFieldIsCutInMessages) {
    const std::string text(5000, 'z');
    EXPECT_LT(test::message_of<FormatError>([&] { Fields(text, 1).number("px"); }).size(), 100U);
}

TEST(TextOut, LaysNumbersOutAsPrintf) {
    const auto fixed = [](double value, const Layout& layout) {
        std::string out;
        append_fixed(out, value, layout);
        return out;
    };
    EXPECT_EQ(fixed(0.5, {3, 7, true, '0'}), "+00.500");
    EXPECT_EQ(fixed(-1.234, {3, 7, true, '0'}), "-01.234");
    EXPECT_EQ(fixed(1234.5, {3, 7, true, '0'}), "+1234.500");
    EXPECT_EQ(fixed(300, {3, 14, false, '0'}), "0000000300.000");
    EXPECT_EQ(fixed(0.1, {3, 7, false, ' '}), "  0.100");
    EXPECT_EQ(fixed(-0.1, {3, 7, true, ' '}), " -0.100");
    EXPECT_EQ(fixed(1e308, {6, 0, false, '0'}).size(), 316U);
}

TEST(TextOut, ExactDigitsReadBack) {
    for (const double value : {0.1, 1.0 / 3.0, -1e-300, 5e-324, 1e22, 123456789.123456789}) {
        std::string out;
        append_exact(out, value);
        EXPECT_EQ(parse_double(out), value) << out;
    }
}

}  // namespace
}  // namespace hitos
