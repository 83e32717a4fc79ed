// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_reader.hpp"

#include <gtest/gtest.h>

#include "test_files.hpp"

namespace hitos {
namespace {

using test::TempDir;

struct Got {
    std::string text;
    std::uint64_t number;
    std::string damage;
};

std::vector<Got> lines_of(const std::filesystem::path& path) {
    std::vector<Got> lines;
    LineReader reader(path);
    while (const std::optional<LineReader::Line> line = reader.next()) {
        lines.push_back({std::string(line->text), line->number, line->damage.english()});
    }
    EXPECT_FALSE(reader.next());
    return lines;
}

std::string many_lines(int count) {
    std::string text;
    for (int i = 1; i <= count; ++i) text += "line " + std::to_string(i) + "\n";
    return text;
}

TEST(LineReader, TrimsNumbersAndAcceptsEveryEnding) {
    const TempDir folder;
    const auto lines = lines_of(folder.put("a", "\xef\xbb\xbf one \r\n\n\ttwo\r\nthree"));
    ASSERT_EQ(lines.size(), 4U);
    EXPECT_EQ(lines[0].text, "one");
    EXPECT_EQ(lines[1].text, "");
    EXPECT_EQ(lines[2].text, "two");
    EXPECT_EQ(lines[3].text, "three");
    EXPECT_EQ(lines[3].number, 4U);
}

TEST(LineReader, GzipByContentNotByName) {
    const TempDir folder;
    const std::string text = many_lines(50000);
    const auto plain = lines_of(folder.put("plain.gz", text));
    const auto packed = lines_of(folder.put_gz("packed.txt", text));
    ASSERT_EQ(plain.size(), 50000U);
    ASSERT_EQ(packed.size(), 50000U);
    EXPECT_EQ(packed.back().text, "line 50000");
    EXPECT_EQ(packed.back().number, 50000U);
}

TEST(LineReader, ReadsSeveralGzipMembersAndPadding) {
    const TempDir folder;
    const std::string one = test::content(folder.put_gz("1", "first\n"));
    const std::string two = test::content(folder.put_gz("2", "second\n"));
    const auto lines = lines_of(folder.put("both.gz", one + two + std::string(512, '\0')));
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(lines[1].text, "second");
    const auto spoilt = lines_of(folder.put("spoilt.gz", one + "garbage"));
    ASSERT_EQ(spoilt.size(), 2U);
    EXPECT_NE(spoilt[1].damage.find("not gzip"), std::string::npos);
}

TEST(LineReader, TruncatedGzipGivesWholeLinesThenOneDamage) {
    const TempDir folder;
    const std::string packed = test::content(folder.put_gz("a", many_lines(20000)));
    const auto lines = lines_of(folder.put("cut.gz", packed.substr(0, packed.size() / 2)));
    ASSERT_GT(lines.size(), 1000U);
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
        ASSERT_EQ(lines[i].text, "line " + std::to_string(i + 1));
        ASSERT_TRUE(lines[i].damage.empty());
    }
    EXPECT_EQ(lines.back().damage, "the compressed data end early");
    EXPECT_EQ(lines.back().number, lines.size());
}

TEST(LineReader, CorruptGzipGivesWhatCameBefore) {
    const TempDir folder;
    std::string packed = test::content(folder.put_gz("a", many_lines(20000)));
    packed[packed.size() - 6] ^= '\x55';  // in the checksum
    const auto lines = lines_of(folder.put("bad.gz", packed));
    ASSERT_EQ(lines.size(), 20001U);
    EXPECT_EQ(lines.back().damage, "the compressed data are damaged");
}

TEST(LineReader, TenMegabyteLineIsSkippedWhole) {
    const TempDir folder;
    const std::string text = "one\n" + std::string(10U << 20U, 'x') + "\nthree\n";
    for (const auto& path : {folder.put("a", text), folder.put_gz("b", text)}) {
        const auto lines = lines_of(path);
        ASSERT_EQ(lines.size(), 3U);
        EXPECT_EQ(lines[1].damage, "the line is longer than 1 MiB");
        EXPECT_EQ(lines[1].number, 2U);
        EXPECT_EQ(lines[2].text, "three");
    }
}

TEST(LineReader, LongestLineExactly) {
    const TempDir folder;
    const std::string longest(kLongestLine, 'x');
    const auto fits = lines_of(folder.put("a", longest + "\nb"));
    ASSERT_EQ(fits.size(), 2U);
    EXPECT_EQ(fits[0].text.size(), kLongestLine);
    const auto over = lines_of(folder.put("b", longest + "x\nb"));
    ASSERT_EQ(over.size(), 2U);
    EXPECT_FALSE(over[0].damage.empty());
    EXPECT_EQ(over[1].text, "b");
    const auto last = lines_of(folder.put("c", "a\n" + longest + "x"));
    ASSERT_EQ(last.size(), 2U);
    EXPECT_FALSE(last[1].damage.empty());
}

TEST(LineReader, ControlCharactersAreDamage) {
    const TempDir folder;
    const auto lines = lines_of(folder.put("a", std::string("a\0b\nok\tfine\n\x01\n\x7f\n", 16)));
    ASSERT_EQ(lines.size(), 4U);
    EXPECT_FALSE(lines[0].damage.empty());
    EXPECT_EQ(lines[1].text, "ok\tfine");
    EXPECT_FALSE(lines[2].damage.empty());
    EXPECT_FALSE(lines[3].damage.empty());
}

TEST(LineReader, ProgressReachesTheEnd) {
    const TempDir folder;
    LineReader reader(folder.put("a", many_lines(100000)));
    reader.next();
    const double early = reader.bytes().progress();
    EXPECT_GT(early, 0.0);
    EXPECT_LT(early, 0.5);
    while (reader.next()) {
    }
    EXPECT_EQ(reader.bytes().progress(), 1.0);
}

}  // namespace
}  // namespace hitos
