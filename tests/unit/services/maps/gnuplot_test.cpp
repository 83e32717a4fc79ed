// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/drawing/gnuplot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support.hpp"

namespace hitos {
namespace {

using test::content;
using test::TempFolder;
using ::testing::HasSubstr;

/// A search path with this program in it as gnuplot, or without any.
class GnuplotTest : public testing::Test {
  protected:
    void use(const std::string& program) {
        if (!program.empty()) {
            std::filesystem::permissions(bin_.put("gnuplot", "#!/bin/sh\n" + program),
                                         std::filesystem::perms::owner_all);
        }
        ::setenv("PATH", bin_.path().c_str(), 1);
    }
    ~GnuplotTest() override { ::setenv("PATH", before_.c_str(), 1); }

    std::string draw(const std::string& refusal = {}) {
        const std::vector<PlotFile> files = {{"a.gp", "script"}, {"a.dat", "1 2"}};
        const std::vector<std::string> pictures = {"a.png"};
        return draw_pictures(out_.path(), files, "a.gp", pictures, verbatim(refusal)).english();
    }

    std::string before_ = std::getenv("PATH");
    TempFolder bin_;
    TempFolder out_;
};

TEST_F(GnuplotTest, DrawsInAFolderOfItsOwnAndLeavesScriptDataAndPicture) {
    use("read -r line < a.dat; echo \"$1 $2 $line\" > a.png; echo left > scratch");
    out_.put("a.png", "old");
    EXPECT_EQ(draw(), "");
    EXPECT_EQ(content(out_ / "a.png"), "-d a.gp 1 2\n");
    EXPECT_EQ(content(out_ / "a.gp"), "script");
    EXPECT_EQ(content(out_ / "a.dat"), "1 2");
    EXPECT_EQ(out_.files(), 3U);
}

TEST_F(GnuplotTest, WhatItSaysWhenItFailsIsToldAndAnOldPictureGoes) {
    use("echo '  line 3: no such terminal '; echo half > a.png; exit 1");
    out_.put("a.png", "old");
    EXPECT_EQ(draw(), "gnuplot fails: line 3: no such terminal");
    EXPECT_FALSE(std::filesystem::exists(out_ / "a.png"));
    EXPECT_EQ(out_.files(), 2U);
}

TEST_F(GnuplotTest, WithoutItTheScriptIsLeftAndThePackageNamed) {
    use("");
    out_.put("a.png", "old");
    EXPECT_THAT(draw(), HasSubstr("gnuplot-nox"));
    EXPECT_FALSE(std::filesystem::exists(out_ / "a.png"));
    EXPECT_EQ(content(out_ / "a.gp"), "script");
}

TEST_F(GnuplotTest, ARefusalIsHandedBackAndNothingIsDrawn) {
    use("echo drawn > a.png");
    out_.put("a.png", "old");
    EXPECT_EQ(draw("nothing was estimated"), "nothing was estimated");
    EXPECT_FALSE(std::filesystem::exists(out_ / "a.png"));
}

TEST_F(GnuplotTest, WantsNothingOfTheSystem) {
    use("read -r line; echo \"read: $line\" > a.png");
    EXPECT_EQ(draw(), "");
    EXPECT_EQ(content(out_ / "a.png"), "read: \n") << "standard input is at its end";
}

TEST(GnuplotFile, NoNameIsACommand) {
    EXPECT_EQ(gnuplot_file("a-landmarks.dat"), "'a-landmarks.dat'");
    EXPECT_EQ(gnuplot_file("< ls"), "'./< ls'");
    EXPECT_EQ(gnuplot_file("|ls"), "'./|ls'");
    EXPECT_EQ(gnuplot_file("-"), "'./-'");
    EXPECT_EQ(gnuplot_file("a\n`b\"\\"), "\"a\\012\\140b\\042\\134\"");
    EXPECT_EQ(gnuplot_head("a\nsystem('ls')\\"), "# Draw again with: gnuplot a?system('ls')\\?\n");
}

/// With gnuplot itself, where there is one.
TEST(GnuplotFile, HostileNamesAreNamesOfFiles) {
    const TempFolder folder;
    for (const std::string stem :
         {"< touch HURT #", "|touch HURT #", "a\nsystem(\"touch HURT\")\n#", "`touch HURT`", "-",
          "+", "'; system('touch HURT'); '", "a\\", "$x", "@x"}) {
        const std::string script = gnuplot_head(stem + ".gp") + "set terminal svg\nset output " +
                                   gnuplot_file(stem + ".svg") + "\nplot " +
                                   gnuplot_file(stem + ".dat") + " title " + gnuplot_quoted(stem) +
                                   " noenhanced\n";
        const std::vector<PlotFile> files{{stem + ".dat", "1 2\n2 3\n"}, {stem + ".gp", script}};
        const std::string picture = stem + ".svg";
        const std::string said =
            draw_pictures(folder.path(), files, stem + ".gp", std::span(&picture, 1)).english();
        if (said.find("gnuplot-nox") != std::string::npos) GTEST_SKIP() << said;
        EXPECT_EQ(said, "") << stem;
        EXPECT_THAT(content(folder / picture), HasSubstr("<svg")) << stem;
    }
    EXPECT_EQ(folder.files(), 30U) << "nothing else was made";
}

TEST(GnuplotQuoted, KeepsQuotesAndTakesLineEndsOut) {
    EXPECT_EQ(gnuplot_quoted("a"), "'a'");
    EXPECT_EQ(gnuplot_quoted("it's\n\"x\""), "'it''s \"x\"'");
    EXPECT_EQ(gnuplot_quoted("'a\"`b`"), "\"'a\\042\\140b\\140\"");
}

}  // namespace
}  // namespace hitos
