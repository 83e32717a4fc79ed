// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/text_input.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <cmath>
#include <limits>

#include "hitos/base/error.hpp"
#include "support.hpp"

namespace hitos::input {
namespace {

using test::message_of;
using test::TempFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string gzipped(const TempFolder& folder, std::string_view text) {
    std::string path = (folder / "packed.gz").string();
    auto* const file = gzopen(path.c_str(), "wb");
    EXPECT_EQ(gzwrite(file, text.data(), static_cast<unsigned>(text.size())),
              static_cast<int>(text.size()));
    EXPECT_EQ(gzclose(file), Z_OK);
    return path;
}

std::string long_text() {
    std::string text;
    for (int i = 0; i < 50000; ++i) text += std::to_string(i * 7919) + "\n";
    return text;
}

TEST(ReadText, GivesPlainFilesByteByByte) {
    const TempFolder folder;
    const std::string text("a\r\n\0\xff", 5);
    EXPECT_EQ(read_text(folder.put("plain", text)), text);
    EXPECT_EQ(read_text(folder.put("empty", "")), "");
    EXPECT_EQ(read_text(folder.put("long", long_text())), long_text());
}

TEST(ReadText, TakesTextsAsEditorsSaveThem) {
    const TempFolder folder;
    EXPECT_EQ(read_text(folder.put("a",
                                   "\xef\xbb\xbf"
                                   "fix 1\r\n")),
              "fix 1\r\n");
    EXPECT_EQ(read_text(folder.put("b", "x: 1\ry: 2\r")), "x: 1\ny: 2\n");
    EXPECT_EQ(read_text(folder.put("c", std::string_view("\0\r", 2))), std::string("\0\r", 2));
    const std::string letters = "rho: 1 theta: 90";
    std::string little;
    std::string big;
    for (const char letter : letters) {
        little += {letter, '\0'};
        big += {'\0', letter};
    }
    for (const std::string& wide : {little, big, "\xff\xfe" + little, "\xfe\xff" + big}) {
        EXPECT_THAT(message_of<FormatError>([&] { read_text(folder.put("d", wide)); }),
                    HasSubstr("is UTF-16 text; save it as UTF-8"));
    }
}

TEST(ReadText, UnpacksGzip) {
    const TempFolder folder;
    EXPECT_EQ(read_text(gzipped(folder, long_text())), long_text());
}

TEST(ReadText, RefusesTruncatedAndDamagedGzip) {
    const TempFolder folder;
    const std::string packed = test::content(gzipped(folder, long_text()));
    const auto cut = folder.put("cut.gz", packed.substr(0, packed.size() / 2));
    EXPECT_THAT(message_of<FileError>([&] { read_text(cut); }),
                HasSubstr(cut.string() + ": damaged gzip file: "));
    std::string bent = packed;
    bent[bent.size() / 2] = static_cast<char>(~bent[bent.size() / 2]);
    const auto damaged = folder.put("bent.gz", bent);
    EXPECT_THAT(message_of<FileError>([&] { read_text(damaged); }),
                HasSubstr(damaged.string() + ": damaged gzip file: "));
}

TEST(ReadText, TellsMissingFilesAndFolders) {
    const TempFolder folder;
    const auto missing = folder / "missing";
    EXPECT_EQ(message_of<FileError>([&] { read_text(missing); }),
              missing.string() + ": no such file");
    const auto below_a_file = folder.put("file", "x") / "y";
    EXPECT_EQ(message_of<FileError>([&] { read_text(below_a_file); }),
              below_a_file.string() + ": no such file");
    EXPECT_EQ(message_of<FileError>([&] { read_text(folder.path()); }),
              folder.path().string() + ": is a directory; expected a file");
}

TEST(ReadText, RefusesWhatHasNoEnd) {
    const TempFolder folder;
    std::filesystem::create_symlink("/dev/zero", folder / "link.cfg");
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    for (const char* name : {"link.cfg", "pipe"}) {
        EXPECT_THAT(message_of<FileError>([&] { read_text(folder / name); }),
                    HasSubstr("is a device or a pipe"));
    }
    const auto long_one = folder.put("long", std::string(3U << 20U, 'x'));
    EXPECT_EQ(read_text(long_one).size(), 3U << 20U);
    EXPECT_THAT(message_of<FileError>([&] { read_text(long_one, 1U << 20U); }),
                HasSubstr("is greater than 1 MiB"));
}

TEST(ReadText, RefusesAFewBytesThatUnpackToMany) {
    const TempFolder folder;
    const std::string bomb = gzipped(folder, std::string(65U << 20U, '\n'));
    EXPECT_THAT(message_of<FileError>([&] { read_text(bomb); }),
                HasSubstr("unpacks to more than 64 MiB, 64 times its size"));
    EXPECT_EQ(read_text(gzipped(folder, std::string(1U << 20U, '\n'))).size(), 1U << 20U);
}

TEST(ReadText, DoesNotWaitForTheKernel) {
    const char* log = "/proc/kmsg";
    if (::access(log, R_OK) != 0) GTEST_SKIP() << "only root may read it";
    try {
        read_text(log);
    } catch (const FileError&) {
        return;
    }
}

TEST(FiniteNumber, HasBoundsBeyondWhichItIsAMistake) {
    const std::string file = "f";
    EXPECT_EQ(finite_number("-1e12", "x", {file, 3}), -1e12);
    EXPECT_EQ(finite_number("1e18", "t", {file, 3}, 1e20), 1e18);
    EXPECT_EQ(message_of<FormatError>([&] {
                  finite_number("-1.1e12", "x", {file, 3});
              }),
              "f:3: x is \"-1.1e12\"; expected a number from -1e+12 to 1e+12");
    EXPECT_THAT(message_of<FormatError>([&] {
                    finite_number("inf", "x", {file, 3});
                }),
                HasSubstr("expected a finite number"));
}

TEST(Trimmed, TakesWhiteSpaceOffBothEnds) {
    EXPECT_EQ(trimmed(" \t a b\r\n"), "a b");
    EXPECT_EQ(trimmed("a"), "a");
    EXPECT_EQ(trimmed(" \t\r\n"), "");
    EXPECT_EQ(trimmed(""), "");
}

TEST(Fields, AreTheWordsBetweenWhiteSpace) {
    EXPECT_THAT(fields(" a  bc\td\r"), ElementsAre("a", "bc", "d"));
    EXPECT_THAT(fields("a"), ElementsAre("a"));
    EXPECT_THAT(fields(" \t"), IsEmpty());
}

TEST(NextLine, CutsLinesUntilNothingIsLeft) {
    std::string_view rest = "a\n\nb";
    EXPECT_EQ(next_line(rest), "a");
    EXPECT_EQ(next_line(rest), "");
    EXPECT_EQ(next_line(rest), "b");
    EXPECT_EQ(next_line(rest), std::nullopt);
    rest = "a\n";
    EXPECT_EQ(next_line(rest), "a");
    EXPECT_EQ(next_line(rest), std::nullopt);
}

TEST(ParseNumber, TakesTheWholeTextOrNothing) {
    EXPECT_EQ(parse_number("-1.5e3"), -1500.0);
    EXPECT_EQ(parse_number("+2"), 2.0);
    EXPECT_EQ(parse_number(".5"), 0.5);
    EXPECT_EQ(parse_number("4.9e-324"), std::numeric_limits<double>::denorm_min());
    for (const char* text :
         {"", "+", "-", "1x", "1 ", " 1", "1,5", "++1", "+-1", "0x10", "1e999"}) {
        EXPECT_EQ(parse_number(text), std::nullopt) << text;
    }
    EXPECT_EQ(parse_number("inf"), std::numeric_limits<double>::infinity());
    EXPECT_TRUE(std::isnan(parse_number("nan").value()));
}

TEST(InQuotes, EscapesAndCuts) {
    EXPECT_EQ(in_quotes("a b"), "\"a b\"");
    EXPECT_EQ(in_quotes(std::string_view("a\0\x1b\x7f", 4)), "\"a\\x00\\x1b\\x7f\"");
    EXPECT_EQ(in_quotes(std::string(60, 'x')), '"' + std::string(60, 'x') + '"');
    EXPECT_EQ(in_quotes(std::string(61, 'x')), '"' + std::string(60, 'x') + "...\"");
    // The cut never falls inside a character.
    EXPECT_EQ(in_quotes(std::string(59, 'x') + "ñññ"), '"' + std::string(59, 'x') + "...\"");
}

}  // namespace
}  // namespace hitos::input
