// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/staged_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <set>
#include <string>

#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "unit/capture/test_files.hpp"

namespace hitos {
namespace {

namespace fs = std::filesystem;
using test::content;
using test::TempDir;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::set<std::string> names_of_files_in(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) {
        names.insert(entry.path().filename().string());
    }
    return names;
}

std::string refusal(const auto& work) {
    try {
        work();
    } catch (const FileError& error) {
        return error.what();
    }
    return {};
}

class StagedFilesTest : public ::testing::Test {
  protected:
    void SetUp() override {
        fs::create_directory(dir_ / "x");
        fs::create_directory(dir_ / "y");
        a_ = dir_ / "x/a";
        b_ = dir_ / "y/b";
    }
    void fill(const StagedFiles& files, const std::string& text) const {
        files.write([&] {
            for (const fs::path& file : {a_, b_}) write_file(files.staged(file), text);
        });
    }

    TempDir dir_;
    fs::path a_;
    fs::path b_;
};

TEST_F(StagedFilesTest, ComeTogetherInWhateverFoldersTheyLie) {
    write_file(a_, "old");
    {
        StagedFiles files({a_, b_});
        fill(files, "new");
        EXPECT_EQ(content(a_), "old");
        EXPECT_FALSE(fs::exists(b_));
        files.commit();
        EXPECT_EQ(content(a_), "new");
        EXPECT_EQ(content(b_), "new");
    }
    {
        StagedFiles files({a_, b_});
        fill(files, "newer");  // and no commit
    }
    EXPECT_EQ(content(a_), "new");
    EXPECT_EQ(content(b_), "new");
    EXPECT_THAT(names_of_files_in(dir_ / "x"), ElementsAre("a"));
    EXPECT_THAT(names_of_files_in(dir_ / "y"), ElementsAre("b"));
}

TEST_F(StagedFilesTest, AreAllAsTheyWereWhereOneCannotBePutInPlace) {
    write_file(a_, "old");
    write_file(b_, "old");
    std::optional<StagedFiles> files(std::in_place, std::vector{a_, b_});
    fill(*files, "new");
    fs::remove(files->staged(b_));
    fs::remove(b_);
    fs::create_directory(b_);  // somebody's folder meanwhile
    EXPECT_THAT(refusal([&] { files->commit(); }), HasSubstr("it is a folder"));
    EXPECT_EQ(content(a_), "old");
    fs::remove(b_);
    write_file(b_, "older");
    fs::remove(files->staged(a_).parent_path() / "a");  // nothing to put there
    fs::rename(dir_ / "y", dir_ / "z");
    EXPECT_THAT(refusal([&] { files->commit(); }), HasSubstr("cannot be put in place"));
    EXPECT_EQ(content(a_), "old");
    files.reset();
    EXPECT_EQ(content(dir_ / "z/b"), "older");
    EXPECT_THAT(names_of_files_in(dir_ / "x"), ElementsAre("a"));
}

TEST_F(StagedFilesTest, AreForOneWriterAtATime) {
    const StagedFiles files({a_, b_});
    EXPECT_THAT(refusal([&] {
                    StagedFiles({dir_ / "x/c", b_});
                }),
                HasSubstr("is being written by"));
    EXPECT_THAT(names_of_files_in(dir_ / "x"), ElementsAre(".a.hitos-lock", ".a.hitos-new"));
}

TEST_F(StagedFilesTest, TellOfTheFilesThatTheyAreFor) {
    const StagedFiles files({a_});
    const std::string told = refusal([&] {
        files.write([&] { throw FileError(files.staged(a_).string(), verbatim("is too big")); });
    });
    EXPECT_EQ(told, a_.string() + ": is too big");
    EXPECT_THAT(refusal([&] { StagedFiles({dir_ / "no/a"}); }),
                HasSubstr("create the folder first"));
    EXPECT_THAT(refusal([&] { StagedFiles({dir_ / "x"}); }), HasSubstr("it is a folder"));
}

}  // namespace
}  // namespace hitos
