// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hitos/capture/archivo.hpp"
#include "test_files.hpp"

namespace hitos {
namespace {

using test::TempDir;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* kPlayer = "1.0 16777343 6665 position2d 00 001 001 0 0 0 0 0 0 0\n";
constexpr const char* kOldPlayer = "1.0 robot 6665 position 00 1.0 0 0 0 0 0 0 0\n";
constexpr const char* kRadish = "position 0 7.420 0.0 0.0 0.0 0.0 0.0 0.0\n";
constexpr const char* kNormalized = "ODOM 1.0 0.5 0.1\n";
constexpr const char* kCarmen = "ODOM 0 0 0 0 0 0 7.4 h 7.4\n";

std::string error_of(const std::filesystem::path& path, std::string_view format = kAutoFormat) {
    std::string message = test::message_of<Error>([&] { open_log(path, format); });
    EXPECT_THAT(message, HasSubstr(path.string()));
    return message;
}

TEST(OpenLog, FindsEachFormat) {
    const TempDir folder;
    EXPECT_EQ(open_log(folder.put("a", kPlayer))->format().word, "player");
    EXPECT_EQ(open_log(folder.put("b", kOldPlayer))->format().word, "player");
    EXPECT_EQ(open_log(folder.put("c", kRadish))->format().word, "radish");
    EXPECT_EQ(open_log(folder.put("d", kNormalized))->format().word, "normalized");
    EXPECT_EQ(open_log(folder.put("e", kCarmen))->format().word, "carmen");
    EXPECT_EQ(open_log(folder.put("f", "LASER 1.0 1 2 3\n"))->format().word, "normalized");
    EXPECT_EQ(open_log(folder.put("g", "# CARMEN Logfile\n"))->format().word, "carmen");
    EXPECT_EQ(open_log(folder.put("h", "laser 0 1.0 2.0 0.1 0\n"))->format().word, "radish");
    EXPECT_EQ(open_log(folder.put_gz("i", kCarmen))->format().word, "carmen");
}

TEST(OpenLog, TheMajorityDecides) {
    const TempDir folder;
    // A CARMEN line cut short looks like one of the normalised format.
    const std::string text = std::string("ODOM 0 0 0\n") + kCarmen + kCarmen;
    EXPECT_EQ(open_log(folder.put("a", text))->format().word, "carmen");
    EXPECT_EQ(open_log(folder.put("b", text), "normalized")->format().word, "normalized");
}

TEST(OpenLog, GarbageBeforeTheLogDoesNotHideIt) {
    const TempDir folder;
    std::string text = std::string(3U << 20U, 'x') + "\n";
    for (int i = 0; i < 500; ++i) text += "?? noise\n# note\n\n";
    EXPECT_EQ(open_log(folder.put("a", text + kRadish))->format().word, "radish");
}

TEST(OpenLog, MissingFile) {
    const TempDir folder;
    EXPECT_THAT(error_of(folder / "none.log"), HasSubstr("no such file"));
    EXPECT_THROW(open_log(folder / "none.log"), FileError);
    EXPECT_THROW(open_log(folder.put("file", "x") / "none.log"), FileError);
}

TEST(OpenLog, FolderAndDevice) {
    const TempDir folder;
    EXPECT_THAT(error_of(folder.path()), HasSubstr("is a folder"));
    EXPECT_THROW(open_log(folder.path()), FileError);
    EXPECT_THAT(error_of("/dev/null"), HasSubstr("no regular file"));
}

TEST(OpenLog, EmptyFile) {
    const TempDir folder;
    EXPECT_THAT(error_of(folder.put("a.log", "")),
                AllOf(HasSubstr("is empty"), HasSubstr("expected")));
    EXPECT_THAT(error_of(folder.put_gz("a.gz", "")), HasSubstr("gzip file that holds nothing"));
    EXPECT_THAT(error_of(folder.put("b.log", "\n\n# only this\n")),
                HasSubstr("nothing but comments"));
}

TEST(OpenLog, BinaryFile) {
    const TempDir folder;
    std::string noise;
    std::mt19937 engine(3);
    for (int i = 0; i < 20000; ++i) noise.push_back(static_cast<char>(engine()));
    EXPECT_THAT(error_of(folder.put("a", noise)), HasSubstr("is not text"));
    EXPECT_THAT(error_of(folder.put_gz("b", noise)), HasSubstr("is not text once unpacked"));
    EXPECT_THAT(error_of(folder.put("c", "\x89PNG\r\n\x1a\n1234")), HasSubstr("PNG picture"));
    EXPECT_THAT(error_of(folder.put("d", "BZh91AY&SY")), HasSubstr("unpack them first"));
    EXPECT_THAT(error_of(folder.put("e", "\x1f\x8b nothing of gzip")), HasSubstr("damaged"));
    EXPECT_THAT(error_of(folder.put("f", "\x1f\x8b")), HasSubstr("end early"));
}

TEST(OpenLog, OneEndlessLine) {
    const TempDir folder;
    const std::string line(3U << 20U, 'x');
    EXPECT_THAT(error_of(folder.put("a.log", line)), HasSubstr("holds lines longer than 1 MiB"));
}

TEST(OpenLog, TextOfNoFormat) {
    const TempDir folder;
    EXPECT_THAT(error_of(folder.put("a", "rho: 1.0 theta: 90\n")),
                AllOf(HasSubstr("rho: 1.0"), HasSubstr("expected a log (player")));
}

// Of every format, whether its lines are still known or not.
TEST(OpenLog, DrawingsAreToldAsSuch) {
    const TempDir folder;
    const auto said = [&](const std::string& name, const std::string& text) {
        const auto path = folder.put(name, text);
        return test::message_of<FormatError>([&] { open_log(path); });
    };
    for (const char* text : {"0\nSECTION\n2\nHEADER\n", "  0\r\nSECTION\r\n  2\r\n",
                             "999\nmade by hand\n0\nSECTION\n"}) {
        EXPECT_THAT(said("plan.dxf", text), HasSubstr("hitos-cli world makes a world of it"));
    }
    EXPECT_THAT(said("plan.dwg", std::string("AC1032\0\0\1\2", 10)), HasSubstr("save it as DXF"));
    EXPECT_THAT(said("plan.log", "0\n1\n2\n"), HasSubstr("no line is one of a format"));
}

TEST(OpenLog, DecimalCommasAreToldAsSuch) {
    const TempDir folder;
    for (const char* line : {kPlayer, kOldPlayer, kRadish, kNormalized, kCarmen}) {
        std::string text(line);
        std::ranges::replace(text, '.', ',');
        text.insert(text.size() - 1, " 0,5 1,5");
        EXPECT_THAT(error_of(folder.put("a.log", "# a log, of 1.5 m\n" + text)),
                    AllOf(HasSubstr("is written with decimal commas"), HasSubstr("sed -E")));
    }
    // Some lines are damage, and each says why.
    std::string text;
    for (int i = 0; i < 5; ++i) text += kCarmen;
    EXPECT_NE(open_log(folder.put("b.log", text + "ODOM 0,1 0,2 0 0 0 0 7.4 h 7.4\n")), nullptr);
}

TEST(OpenLog, WhatWouldMakeALogOfATextIsTold) {
    const TempDir folder;
    const auto told = [&](std::string text, std::string_view from, std::string_view to) {
        for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
            text.replace(at, from.size(), to);
        return error_of(folder.put("a", text));
    };
    EXPECT_THAT(told(kCarmen, " ", ","), HasSubstr("with blanks in the place of \",\""));
    EXPECT_THAT(told(kRadish, " ", ";"), HasSubstr("with blanks in the place of \";\""));
    EXPECT_THAT(told(kCarmen, "ODOM", "odom"), HasSubstr("with its name in capital letters"));
    const std::string two = std::string(kCarmen) + kCarmen;
    EXPECT_THAT(told(two, "\n", "\r"), HasSubstr("lines that end with CR alone"));
    std::string wide;
    for (const char letter : two) wide += {letter, '\0'};
    EXPECT_THAT(error_of(folder.put("b", wide)), HasSubstr("it is UTF-16 text; save it as UTF-8"));
    EXPECT_THAT(error_of(folder.put("b", "\xff\xfe" + wide)), HasSubstr("it is UTF-16 text"));
}

TEST(OpenLog, WrongExplicitFormat) {
    const TempDir folder;
    const auto path = folder.put("a", kCarmen);
    for (const char* format : {"player", "radish", "normalized"}) {
        EXPECT_THROW(open_log(path, format), FormatError);
        EXPECT_THAT(error_of(path, format), AllOf(HasSubstr(format), HasSubstr("looks like carmen"),
                                                  HasSubstr("choose the format carmen or auto")));
    }
    EXPECT_NO_THROW(open_log(path, "carmen"));
}

// What SQLite holds back beside a file is read with it, and so belongs to what is watched.
TEST(LogFiles, OfSqliteHaveItsLogOfChanges) {
    const TempDir folder;
    const auto single = folder.put("a.db3", "x");
    EXPECT_THAT(log_files(single), ElementsAre(single, folder / "a.db3-wal"));
    EXPECT_THAT(log_files(folder.path()),
                ElementsAre(single, folder / "a.db3-wal", folder / "metadata.yaml"));
    const auto text = folder.put("a.log", kCarmen);
    EXPECT_THAT(log_files(text), ElementsAre(text));
}

TEST(LogFormats, AreListedWhereOneIsAskedFor) {
    EXPECT_EQ(log_formats().words(),
              "player, radish, normalized, carmen, mrclam, rosbag, mcap, db3, rosbag2");
    EXPECT_EQ(log_format_choices(),
              "auto, player, radish, normalized, carmen, mrclam, rosbag, mcap, db3 or rosbag2");
    EXPECT_EQ(writable_formats(), "player, radish, normalized, carmen or mcap");
    for (const char* word :
         {"auto", "player", "radish", "normalized", "carmen", "rosbag", "rosbag2"}) {
        EXPECT_EQ(checked_log_format(word, "--format"), word);
    }
    EXPECT_THAT(test::message_of<ConfigError>([] { checked_log_format("Player", "--format"); }),
                AllOf(HasSubstr("--format: found \"Player\""), HasSubstr(log_format_choices())));
    EXPECT_THAT(test::message_of<ConfigError>([] { checked_target_format("auto", "--to"); }),
                AllOf(HasSubstr("--to: found \"auto\""), HasSubstr("expected player, radish")));
    const TempDir folder;
    EXPECT_THROW(open_log(folder.put("a", kCarmen), "carmin"), ConfigError);
}

TEST(LogFormats, AnEndingOfOneFormatSaysWhichItIs) {
    EXPECT_EQ(format_by_ending("a/tour.mcap", "normalized"), "mcap");
    EXPECT_EQ(format_by_ending("a/tour.clf.gz", "player"), "carmen");
    // Several have it, nobody has it, or nobody can write it.
    for (const char* name : {"tour.log", "tour.txt", "tour", "tour.bag", "tour.gz", ".clf"}) {
        EXPECT_EQ(format_by_ending(name, "radish"), "radish") << name;
    }
}

}  // namespace
}  // namespace hitos
