// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/staged_folder.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <random>
#include <set>
#include <string>
#include <thread>

#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "unit/capture/test_files.hpp"

namespace hitos {
namespace {

namespace fs = std::filesystem;
using test::content;
using test::TempDir;
using ::testing::HasSubstr;

const std::set<std::string> kOwned{"a", "b", "c", "seal"};

StagedFolder staged_in(const fs::path& folder) {
    const auto owned = [](const std::string& name) { return kOwned.contains(name); };
    return {folder, {owned, owned}, "seal"};
}

std::set<std::string> names_in(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) {
        names.insert(entry.path().filename().string());
    }
    return names;
}

/// The same text in every file.
void fill(const fs::path& folder, const std::string& text) {
    for (const char* name : {"a", "b", "seal"}) write_file(folder / name, text);
}

TEST(StagedFolder, TheFolderIsWhatItWasUntilCommit) {
    const TempDir above;
    const fs::path folder = above / "out/results";
    {
        StagedFolder staged = staged_in(folder);
        fill(staged.path(), "old");
        EXPECT_TRUE(fs::is_empty(folder));
        staged.commit();
        EXPECT_EQ(content(folder / "a"), "old");
    }
    {
        const StagedFolder staged = staged_in(folder);
        fill(staged.path(), "new");
    }
    EXPECT_EQ(content(folder / "a"), "old");
    EXPECT_EQ(names_in(above / "out"), std::set<std::string>{"results"}) << "nothing stays beside";
}

TEST(StagedFolder, WhatIsFormerGoesAndWhatIsOthersStays) {
    const TempDir above;
    const fs::path folder = above / "results";
    fs::create_directory(folder);
    for (const char* name : {"a", "c", "notes.txt"}) write_file(folder / name, "mine");
    fs::create_symlink("../elsewhere", folder / "link");
    fs::permissions(folder, fs::perms::owner_all | fs::perms::group_read);
    struct stat before {};
    ASSERT_EQ(::stat((folder / "notes.txt").c_str(), &before), 0);
    StagedFolder staged = staged_in(folder);
    fill(staged.path(), "new");
    staged.commit();
    EXPECT_EQ(names_in(folder), (std::set<std::string>{"a", "b", "link", "notes.txt", "seal"}));
    EXPECT_EQ(content(folder / "notes.txt"), "mine");
    EXPECT_EQ(fs::read_symlink(folder / "link"), "../elsewhere");
    struct stat after {};
    ASSERT_EQ(::stat((folder / "notes.txt").c_str(), &after), 0);
    EXPECT_EQ(after.st_ino, before.st_ino);
    EXPECT_EQ(fs::status(folder).permissions(), fs::perms::owner_all | fs::perms::group_read);
}

TEST(StagedFolder, AFolderThatCannotChangePlacesGetsItsFilesOneByOne) {
    const TempDir above;
    const fs::path folder = above / "results";
    fs::create_directories(folder / "mine");
    fs::create_directory(folder / "c");  // named as a file of ours, and somebody's all the same
    write_file(folder / "mine/notes", "mine");
    fill(folder, "old");
    struct stat before {};
    ASSERT_EQ(::stat(folder.c_str(), &before), 0);
    StagedFolder staged = staged_in(folder);
    write_file(staged.path() / "b", "new");
    write_file(staged.path() / "seal", "new");
    staged.commit();
    EXPECT_EQ(names_in(folder), (std::set<std::string>{"b", "c", "mine", "seal"}));
    EXPECT_EQ(content(folder / "mine/notes"), "mine");
    EXPECT_EQ(content(folder / "seal"), "new");
    struct stat after {};
    ASSERT_EQ(::stat(folder.c_str(), &after), 0);
    EXPECT_EQ(after.st_ino, before.st_ino);
}

TEST(StagedFolder, WhoWorksInTheFolderStaysInIt) {
    const TempDir above;
    const fs::path folder = above / "results";
    fs::create_directory(folder);
    const fs::path before = fs::current_path();
    fs::current_path(folder);
    {
        StagedFolder staged = staged_in(".");
        fill(staged.path(), "new");
        staged.commit();
    }
    EXPECT_EQ(content("a"), "new");
    fs::current_path(before);
    EXPECT_EQ(names_in(folder), (std::set<std::string>{"a", "b", "seal"}));
}

TEST(StagedFolder, AFolderInAFilesPlaceIsNotReplaced) {
    const TempDir above;
    const fs::path folder = above / "results";
    fs::create_directories(folder / "a");
    write_file(folder / "a/mine", "mine");
    StagedFolder staged = staged_in(folder);
    fill(staged.path(), "new");
    EXPECT_THAT(test::message_of<FileError>([&] { staged.commit(); }), HasSubstr("it is a folder"));
    EXPECT_EQ(names_in(folder), std::set<std::string>{"a"});
    EXPECT_EQ(content(folder / "a/mine"), "mine");
}

TEST(StagedFolder, ASecondOneIsToldWhoHasTheFolder) {
    const TempDir above;
    fs::create_directory(above / "results");
    fs::create_directory_symlink("results", above / "link");
    {
        const StagedFolder first = staged_in(above / "results");
        const std::string told = test::message_of<FileError>(
            [&] { const StagedFolder second = staged_in(above / "link/"); });
        EXPECT_THAT(told, HasSubstr("is being written by process " + std::to_string(::getpid())));
        std::array<char, 256> host{};
        ASSERT_EQ(::gethostname(host.data(), host.size() - 1), 0);
        EXPECT_THAT(told, HasSubstr(fmt::format(" on {}, since 20", host.data())));
    }
    const StagedFolder third = staged_in(above / "results");
}

TEST(StagedFolder, AFolderThatIsAFileIsRefused) {
    const TempDir above;
    above.put("file", "x");
    EXPECT_THAT(test::message_of<FileError>([&] { const auto staged = staged_in(above / "file"); }),
                HasSubstr("--out"));
    EXPECT_EQ(content(above / "file"), "x");
}

/// Kills of a process that puts generation after generation in place: the folder is always of one.
void kill_often(const fs::path& folder, const std::set<std::string>& beside) {
    fs::create_directories(folder);
    fill(folder, "0");
    std::mt19937 random(1);
    std::uniform_int_distribution<int> microseconds(0, 4000);
    for (int kill = 0; kill < 60; ++kill) {
        const pid_t child = ::fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            for (int generation = 1;; ++generation) {
                StagedFolder staged = staged_in(folder);
                fill(staged.path(), std::to_string(kill) + " " + std::to_string(generation));
                staged.commit();
            }
        }
        std::this_thread::sleep_for(std::chrono::microseconds(microseconds(random)));
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        const std::string one = content(folder / "seal");
        ASSERT_EQ(content(folder / "a"), one) << kill;
        ASSERT_EQ(content(folder / "b"), one) << kill;
    }
    // The next one clears away what the killed ones left.
    {
        StagedFolder staged = staged_in(folder);
        fill(staged.path(), "last");
        staged.commit();
    }
    EXPECT_EQ(content(folder / "a"), "last");
    std::set<std::string> expected = beside;
    expected.insert({"a", "b", "seal"});
    EXPECT_EQ(names_in(folder), expected);
    EXPECT_EQ(names_in(folder.parent_path()).size(), 1U);
}

TEST(StagedFolder, KillsLeaveOneContentWhole) {
    const TempDir above;
    kill_often(above / "results", {});
}

TEST(StagedFolder, KillsLeaveWhatIsOthers) {
    const TempDir above;
    fs::create_directory(above / "results");
    write_file(above / "results/notes.txt", "mine");
    kill_often(above / "results", {"notes.txt"});
    EXPECT_EQ(content(above / "results/notes.txt"), "mine");
}

}  // namespace
}  // namespace hitos
