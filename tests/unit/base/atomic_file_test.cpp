// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/atomic_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>

#include "hitos/base/text_input.hpp"
#include "unit/capture/test_files.hpp"

namespace hitos {
namespace {

using test::content;
using test::TempDir;
using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(AtomicFile, AppearsOnlyAtCommit) {
    const TempDir folder;
    const auto target = folder / "map.txt";
    {
        AtomicFile file(target);
        file.write("hello");
        EXPECT_FALSE(std::filesystem::exists(target));
        file.commit();
        EXPECT_EQ(content(target), "hello");
    }
    EXPECT_EQ(folder.files(), 1U);
}

TEST(AtomicFile, WithoutCommitTheOldFileStays) {
    const TempDir folder;
    const auto target = folder.put("map.txt", "old");
    {
        AtomicFile file(target);
        file.write(std::string(1U << 20U, 'x'));
    }
    EXPECT_EQ(content(target), "old");
    EXPECT_EQ(folder.files(), 1U);
}

TEST(AtomicFile, ReplacesAndKeepsPermissions) {
    const TempDir folder;
    const auto target = folder.put("map.txt", "old");
    ::chmod(target.c_str(), 0640);
    write_file(target, "new");
    EXPECT_EQ(content(target), "new");
    struct stat status {};
    ::stat(target.c_str(), &status);
    EXPECT_EQ(status.st_mode & 0777U, 0640U);
}

TEST(AtomicFile, FollowsALink) {
    const TempDir folder;
    const auto real = folder.put("real.txt", "old");
    std::filesystem::create_symlink("real.txt", folder / "link.txt");
    write_file(folder / "link.txt", "new");
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.txt"));
    EXPECT_EQ(content(real), "new");
}

TEST(AtomicFile, CompressesWhereAsked) {
    const TempDir folder;
    std::string text;
    for (int i = 0; i < 100000; ++i) text += std::to_string(i) + "\n";
    AtomicFile packed(folder / "a.log.gz", true);
    packed.write(text);
    packed.commit();
    EXPECT_LT(std::filesystem::file_size(folder / "a.log.gz"), text.size() / 2);
    EXPECT_EQ(input::read_text(folder / "a.log.gz"), text);
    write_file(folder / "plain.gz", "text");
    EXPECT_EQ(content(folder / "plain.gz"), "text");
}

TEST(AtomicFile, ErrorsNameThePathTheReasonAndWhatToDo) {
    const TempDir folder;
    const auto error_of = [](const std::filesystem::path& target) {
        return test::message_of<FileError>([&] { write_file(target, "x"); });
    };
    EXPECT_THAT(error_of(folder.path()),
                AllOf(HasSubstr(folder.path().string()), HasSubstr("is a folder")));
    EXPECT_THAT(error_of(folder / "none/map.txt"),
                AllOf(HasSubstr("No such file"), HasSubstr("create the folder first")));
    const auto file = folder.put("file", "x");
    EXPECT_THAT(error_of(file / "map.txt"),
                AllOf(HasSubstr("Not a directory"), HasSubstr("parent is a folder")));
    EXPECT_THAT(error_of("/proc/hitos.txt"), HasSubstr("/proc/hitos.txt: cannot be written"));
    EXPECT_THAT(error_of(folder / std::string(300, 'n')), HasSubstr("shorter name"));
    EXPECT_EQ(folder.files(), 1U);
}

TEST(AtomicFile, FullDiskLeavesTheOldFileAndNothingBeside) {
    const TempDir folder;
    const auto target = folder.put("map.txt", "old");
    const auto packed = folder.put("map.gz", "old");
    struct rlimit before {};
    ::getrlimit(RLIMIT_FSIZE, &before);
    struct rlimit small = before;
    small.rlim_cur = 4096;
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    ::setrlimit(RLIMIT_FSIZE, &small);
    std::string noise;
    std::mt19937 engine(5);
    for (int i = 0; i < 300000; ++i) noise.push_back(static_cast<char>(engine()));
    const std::string plain_error = test::message_of<FileError>([&] { write_file(target, noise); });
    const std::string packed_error = test::message_of<FileError>([&] {
        AtomicFile file(packed, true);
        file.write(noise);
        file.commit();
    });
    ::setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_THAT(plain_error, HasSubstr("File too large"));
    EXPECT_THAT(packed_error, HasSubstr("File too large"));
    EXPECT_EQ(content(target), "old");
    EXPECT_EQ(content(packed), "old");
    EXPECT_EQ(folder.files(), 2U);
}

}  // namespace
}  // namespace hitos
