// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/input_files.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>

#include "hitos/base/error.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using test::TempFolder;

/// Longer than the steps in which file systems tell times.
void wait_for_another_time() {
    ::usleep(20'000);
}

TEST(InputFiles, ALinkAModeAndAnOwnerChangeNothing) {
    const TempFolder folder;
    const auto log = folder.put("tour.log", "content");
    const InputFiles inputs({log});
    wait_for_another_time();
    std::filesystem::create_hard_link(log, folder / "backup.log");
    EXPECT_NO_THROW(inputs.check());
    wait_for_another_time();
    ::chmod(log.c_str(), 0640);
    EXPECT_NO_THROW(inputs.check());
    wait_for_another_time();
    EXPECT_EQ(::chown(log.c_str(), ::getuid(), ::getgid()), 0);
    EXPECT_NO_THROW(inputs.check());
    EXPECT_NO_THROW(inputs.check());
}

TEST(InputFiles, AWriterWhoSetsTheTimeBackIsSeen) {
    const TempFolder folder;
    const auto log = folder.put("tour.log", "content");
    const InputFiles inputs({log});
    struct stat before {};
    ASSERT_EQ(::stat(log.c_str(), &before), 0);
    wait_for_another_time();
    folder.put("tour.log", "CONTENT");
    const std::array<timespec, 2> times{before.st_atim, before.st_mtim};
    ASSERT_EQ(::utimensat(AT_FDCWD, log.c_str(), times.data(), 0), 0);
    EXPECT_THROW(inputs.check(), FileError);
}

TEST(InputFiles, AnotherFileOrNoneIsSeen) {
    const TempFolder folder;
    const auto log = folder.put("tour.log", "content");
    const InputFiles inputs({log, folder / "none"});
    EXPECT_NO_THROW(inputs.check());
    std::filesystem::rename(folder.put("new", "content"), log);
    EXPECT_THROW(inputs.check(), FileError);
    std::filesystem::remove(log);
    EXPECT_THROW(inputs.check(), FileError);
}

}  // namespace
}  // namespace hitos
