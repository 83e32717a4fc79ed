// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/files/segment_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "hitos/base/error.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using test::content;
using test::message_of;
using test::TempFolder;
using ::testing::HasSubstr;

/// A corner first, so that a landmark's index and its number among the lines differ.
LandmarkMap small_map() {
    return {{Esquina{1.0, 2.0}}, {Recta{2.0, kPi / 2.0}}, {Recta{1.0 / 3.0, 0.1}}};
}

TEST(SegmentFile, ReadsBackWhatItWrites) {
    const TempFolder folder;
    const std::vector<LineExtent> segments = {{1, {1.0 / 3.0, 2.0}, {-0.0, 2.0}, 40},
                                              {2, {0.1, 1e-17}, {1e9, -7.25}, 12},
                                              {1, {5.0, 2.0}, {6.5, 2.0}, 11}};
    write_segments(small_map(), segments, folder / "segments.txt");
    const std::vector<LineExtent> read = read_segments(folder / "segments.txt");
    ASSERT_EQ(read.size(), segments.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
        EXPECT_EQ(read[i].a, segments[i].a);
        EXPECT_EQ(read[i].b, segments[i].b);
        EXPECT_EQ(read[i].landmark, segments[i].landmark - 1) << "a corner stands before";
    }
    EXPECT_FALSE(std::signbit(read[0].b.x));
    EXPECT_EQ(folder.files(), 1U);
    EXPECT_THAT(content(folder / "segments.txt"), ::testing::EndsWith("\n5 2 6.5 2 1\n"));
}

TEST(SegmentFile, PassesOverCommentsAndMayBeEmpty) {
    const auto read = parse_segments("# head\n\n 1 2\t3 4 2 # the southern wall\r\n", "s");
    ASSERT_EQ(read.size(), 1U);
    EXPECT_EQ(read[0].landmark, 1);
    EXPECT_EQ(read[0].b, (Point2{3.0, 4.0}));
    EXPECT_TRUE(parse_segments("# nothing\n", "s").empty());
}

TEST(SegmentFile, NamesTheLineOfAMistake) {
    const auto message = [](const char* text) {
        return message_of<FormatError>([&] { static_cast<void>(parse_segments(text, "s.txt")); });
    };
    EXPECT_THAT(message("1 2 3 4 1\n1 2 3 4\n"), HasSubstr("s.txt:2: found 4 fields; expected 5"));
    EXPECT_THAT(message("1 2 nan 4 1\n"), HasSubstr("s.txt:1: x2 is \"nan\"; expected a finite"));
    for (const char* number : {"0", "-1", "1.5", "1e11"}) {
        EXPECT_THAT(message((std::string("1 2 3 4 ") + number).c_str()),
                    HasSubstr("landmark is \"" + std::string(number) + "\"; expected the number"));
    }
}

TEST(SegmentFile, RefusesWhatCannotBeReadBackAndLeavesTheOldFile) {
    const TempFolder folder;
    const auto path = folder.put("segments.txt", "old");
    const auto refusal = [&](const LineExtent& segment) {
        return message_of<Error>([&] { write_segments(small_map(), std::vector{segment}, path); });
    };
    EXPECT_THAT(refusal({0, {}, {1.0, 0.0}}), HasSubstr("landmark 0, which is no line"));
    EXPECT_THAT(refusal({3, {}, {1.0, 0.0}}), HasSubstr("landmark 3, which is no line"));
    EXPECT_THAT(refusal({-1, {}, {1.0, 0.0}}), HasSubstr("landmark -1, which is no line"));
    EXPECT_THAT(refusal({1, {}, {std::numeric_limits<double>::quiet_NaN(), 0.0}}),
                HasSubstr("not finite"));
    EXPECT_EQ(content(path), "old");
    EXPECT_EQ(folder.files(), 1U);
}

}  // namespace
}  // namespace hitos
