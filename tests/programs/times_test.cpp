// SPDX-License-Identifier: GPL-3.0-or-later
// hitos-cli run --times: where the processor time goes.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <string>

#include "program.hpp"

namespace hitos::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

class Times : public ProgramTest {
  protected:
    Outcome run(const std::string& folder, const std::string& options) const {
        return shell(cli_ + " run complex --preset recorded --out " + path(folder) + options);
    }
    json summary(const std::string& folder) const {
        return json::parse(content(path(folder + "/summary.json")), nullptr, false);
    }
};

double sum(const json& seconds) {
    double all = 0.0;
    for (const auto& [name, value] : seconds.items()) {
        EXPECT_GE(value.get<double>(), 0.0) << name;
        all += value.get<double>();
    }
    return all;
}

TEST_F(Times, AreSaidOfEveryPartAndAddUpToNoMoreThanAll) {
    const Outcome timed = run("timed", " --times");
    ASSERT_EQ(timed.status, 0) << timed.output;
    for (const char* row : {"reading", "  smoothing", "judging", "grid_best.png", "all"})
        EXPECT_THAT(timed.output, HasSubstr(row));
    const json times = summary("timed")["times"];
    EXPECT_EQ(times["stages_s"].size(), 5U);
    EXPECT_EQ(times["registration_s"].size(), 5U);
    for (const char* part : {"points", "matching", "search", "smoothing"})
        EXPECT_GT(times["registration_s"][part].get<double>(), 0.0) << part;
    constexpr double kBetween = 1e-3;  // [s], from one clock's look to the other's
    EXPECT_LE(sum(times["registration_s"]),
              times["stages_s"]["registration"].get<double>() + kBetween);
    EXPECT_GT(times["files_s"]["map.txt"].get<double>(), 0.0);
    EXPECT_LE(times["before_s"].get<double>() + sum(times["stages_s"]) + sum(times["files_s"]) +
                  times["judging_s"].get<double>(),
              times["all_s"].get<double>());
}

TEST_F(Times, AreNotSaidUnaskedAndChangeNoOtherFile) {
    ASSERT_EQ(run("timed", " --times").status, 0);
    ASSERT_EQ(run("plain", "").status, 0);
    EXPECT_FALSE(summary("plain").contains("times"));
    const json files = summary("plain")["files"];
    EXPECT_GT(files.size(), 5U);
    EXPECT_EQ(files, summary("timed")["files"]);
}

}  // namespace
}  // namespace hitos::test
