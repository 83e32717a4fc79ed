// SPDX-License-Identifier: GPL-3.0-or-later
// hitos-cli run --hashes and compare: where two runs part.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <string>

#include "program.hpp"

namespace hitos::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

class HashesCommand : public ProgramTest {
  protected:
    void run(const std::string& hashes, const std::string& options) const {
        const Outcome done =
            shell(cli_ + " run corridor --set filter.particles=5 --replace --out " + path("out") +
                  " --hashes " + path(hashes) + " " + options);
        ASSERT_EQ(done.status, 0) << done.output;
    }
    Outcome compare(const std::string& files) const {
        return shell("cd " + path("") + " && " + cli_ + " compare " + files);
    }
};

TEST_F(HashesCommand, NamesTheFirstScanAndPartThatDiffer) {
    run("one.csv", "--set run.threads=1");
    run("two.csv", "--set run.threads=2");
    run("other.csv", "--set split_merge.dmax=0.2");
    const Outcome same = compare("one.csv two.csv");
    EXPECT_EQ(same.status, 0) << same.output;
    EXPECT_EQ(content(path("one.csv")), content(path("two.csv")));
    const Outcome differ = compare("one.csv other.csv --json");
    EXPECT_EQ(differ.status, 2) << differ.output;
    // The world is the same, what is found in it is not.
    const json told = json::parse(differ.output, nullptr, false);
    EXPECT_EQ(told["same"], false) << differ.output;
    EXPECT_EQ(told["part"], "features") << differ.output;
}

TEST_F(HashesCommand, WhatIsNoSuchTableIsRefused) {
    run("one.csv", "");
    for (const auto& [files, words] :
         {std::pair("one.csv", "found 1 file"), std::pair("one.csv out/map.txt", "out/map.txt:1:"),
          std::pair("one.csv none.csv", "none.csv")}) {
        const Outcome refused = compare(files);
        EXPECT_EQ(refused.status, 1) << refused.output;
        EXPECT_THAT(refused.output, HasSubstr(words));
    }
    for (const char* option : {"--as latex", "--out table.md"}) {
        const Outcome refused = compare(std::string("one.csv one.csv ") + option);
        EXPECT_EQ(refused.status, 1) << refused.output;
        EXPECT_THAT(refused.output, HasSubstr("is for folders of runs"));
    }
    const std::string table = content(path("one.csv"));
    file("shorter.csv", table.substr(0, table.rfind('\n', table.size() - 2) + 1));
    const Outcome ends = compare("one.csv shorter.csv");
    EXPECT_EQ(ends.status, 2) << ends.output;
    EXPECT_THAT(ends.output, HasSubstr("the same up to scan end, where one of them ends"));
    const Outcome own = shell(cli_ + " run corridor --replace --out " + path("out") + " --hashes " +
                              path("out/map.txt"));
    EXPECT_EQ(own.status, 1);
    EXPECT_THAT(own.output, HasSubstr("is the name of one of the results"));
}

}  // namespace
}  // namespace hitos::test
