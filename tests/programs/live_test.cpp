// SPDX-License-Identifier: GPL-3.0-or-later
// Runs whose tour comes in while it is mapped: run --follow.
#include <gmock/gmock.h>

#include <map>
#include <string>

#include "programs/program.hpp"

namespace hitos {
namespace {

using test::content;
using test::Outcome;
using test::shell;
using testing::HasSubstr;

class LiveRunTest : public test::ProgramTest {
  protected:
    void SetUp() override {
        ASSERT_EQ(shell("gunzip -c " + shipped_ + " > " + path("whole.log")).status, 0);
    }
    /// What a run leaves but for its own account of itself.
    std::map<std::string, std::string> results(std::string_view name) const {
        auto all = files(name);
        EXPECT_TRUE(all.contains("summary.json"));
        all.erase("summary.json");
        return all;
    }
    /// Another run of what was received, as that run was.
    void expect_again(const std::string& received, const std::string& name) {
        const std::string again = name + "-again";
        const Outcome run = shell(cli_ + " run " + path(received) + " --config " +
                                  path(name + "/config.cfg") + " --out " + path(again));
        ASSERT_EQ(run.status, 0) << run.output;
        EXPECT_EQ(results(name), results(again));
    }
    const std::string shipped_ = test::kSource + "/data/logs/normalized.log.gz";
    const std::string whole_ = path("whole.log");
};

TEST_F(LiveRunTest, OfAPipeKeepsWhatCameAndIsMadeOfItAgain) {
    const Outcome run =
        shell("cat " + whole_ + " | " + cli_ + " run - --follow --preset recorded " +
              "--json --poses " + path("poses.csv") + " --out " + path("a"));
    ASSERT_EQ(run.status, 0) << run.output;
    EXPECT_EQ(content(path("a.received.log")), content(whole_));
    EXPECT_THAT(run.output, HasSubstr("\"received\""));
    expect_again("a.received.log", "a");
    // Every scan has its line, under a heading.
    const Outcome lines = shell("wc -l < " + path("poses.csv") + "; grep -c ^LASER " + whole_);
    EXPECT_EQ(std::stoi(lines.output), std::stoi(lines.output.substr(lines.output.find('\n'))) + 1);
    EXPECT_THAT(content(path("poses.csv")), testing::StartsWith("time_s,x_m,y_m,theta_rad,xx,"));
    // What was received once is not written over.
    const Outcome other =
        shell("cat " + whole_ + " | " + cli_ + " run - --follow --out " + path("a"));
    EXPECT_NE(other.status, 0);
    EXPECT_THAT(other.output, HasSubstr("a.received.log"));
    EXPECT_EQ(content(path("a.received.log")), content(whole_));
}

/// The first Ctrl-C is the end of the tour, not of the run.
TEST_F(LiveRunTest, OfAFileEndsWhereItIsToldTo) {
    const std::string until = "until [ $(cat " + path("poses.csv") + " 2>/dev/null | wc -l) -ge ";
    const std::string g = path("g.log");
    const Outcome run = shell(
        "head -n 100 " + whole_ + " > " + g + "; " + cli_ + " run " + g + " --follow --poses " +
        path("poses.csv") + " --out " + path("a") + " > " + path("said") + " 2>&1 & run=$!; " +
        until + "2 ]; do sleep 0.05; kill -0 $run || exit 1; done; tail -n +101 " + whole_ +
        " >> " + g + "; " + until +
        "50 ]; do sleep 0.05; kill -0 $run || exit 1; done; kill -TERM $run; wait $run");
    ASSERT_EQ(run.status, 0) << run.output << content(path("said"));
    EXPECT_THAT(content(path("said")), HasSubstr("the tour ends here"));
    EXPECT_THAT(content(path("said")), HasSubstr("from a scan's last byte to its pose"));
    expect_again("g.log", "a");
}

TEST_F(LiveRunTest, ThatIsKilledLeavesWhatCame) {
    const std::string poses = path("poses.csv");
    // In the background standard input is nothing; by another number it stays.
    shell("mkfifo " + path("pipe") + "; exec 3<>" + path("pipe") + "; cat " + whole_ + " >&3 & " +
          cli_ + " run - --follow --poses " + poses + " --out " + path("a") +
          " <&3 & run=$!; while kill -0 $run && [ $(cat " + poses +
          " 2>/dev/null | wc -l) -lt 30 ]; do sleep 0.05; done; kill -KILL $run");
    EXPECT_EQ(content(path("a.received.log")), content(whole_));
    EXPECT_FALSE(std::filesystem::exists(path("a/summary.json")));
    const Outcome later = shell(cli_ + " run " + path("a.received.log") + " --out " + path("b"));
    EXPECT_EQ(later.status, 0) << later.output;
}

/// Nobody is waited for but the robot.
TEST_F(LiveRunTest, DoesNotWaitForAReaderOfItsPosesNorLosesThemSilently) {
    const std::string run = cli_ + " run - --follow --out " + path("a") + " --poses ";
    const Outcome nobody =
        shell("mkfifo " + path("pipe") + "; cat " + whole_ + " | timeout 60 " + run + path("pipe"));
    EXPECT_EQ(nobody.status, 0) << nobody.output;
    const Outcome full =
        shell("cat " + whole_ + " | " + run + "/dev/full --strict --json --replace");
    EXPECT_EQ(full.status, 2) << full.output;
    EXPECT_THAT(full.output, HasSubstr("not written: /dev/full: No space left"));
    EXPECT_THAT(full.output, HasSubstr("\"file\": \"/dev/full\""));
}

TEST_F(LiveRunTest, OfAFileThatIsReplacedSaysSo) {
    const std::string g = path("g.log");
    const Outcome run =
        shell("cp " + whole_ + " " + g + "; " + cli_ + " run " + g + " --follow --poses " +
              path("poses.csv") + " --out " + path("a") + " > " + path("said") +
              " 2>&1 & run=$!; until [ $(cat " + path("poses.csv") +
              " 2>/dev/null | wc -l) -ge 50 ]; do sleep 0.05; kill -0 $run || exit 9; done; cp " +
              whole_ + " " + path("other") + "; mv " + path("other") + " " + g +
              "; until grep -q replaced " + path("said") +
              "; do sleep 0.05; kill -0 $run || exit 8; done; kill -TERM $run; wait $run");
    EXPECT_EQ(run.status, 1) << content(path("said"));
    EXPECT_TRUE(std::filesystem::exists(path("a/summary.json")));
}

TEST_F(LiveRunTest, OfWhatCannotBeFollowedSaysSo) {
    const auto refused = [&](const std::string& words) {
        const Outcome run = shell("timeout 60 " + cli_ + " run " + words + " --out " + path("x"));
        EXPECT_NE(run.status, 0) << words;
        EXPECT_NE(run.status, 124) << words;
        return run.output;
    };
    EXPECT_THAT(refused(path("missing.log") + " --follow"), HasSubstr("there is no such file"));
    EXPECT_THAT(refused(log_ + " --follow"), HasSubstr("is compressed"));
    EXPECT_THAT(refused("bigloop.toml --follow"), HasSubstr("a world is simulated"));
    EXPECT_THAT(refused("ws://127.0.0.1:1 --follow"), HasSubstr("cannot be connected to"));
    EXPECT_THAT(refused("wss://robot --follow"), HasSubstr("tunnel"));
    EXPECT_THAT(refused(log_ + " --poses " + path("p.csv")), HasSubstr("--follow"));
    EXPECT_THAT(refused(whole_ + " --follow --config - < " + config_), HasSubstr("from a file"));
    const std::string before = content(whole_);
    EXPECT_THAT(refused("- --follow --poses " + whole_ + " --reference-trajectory " + whole_ +
                        " < " + whole_),
                testing::Not(testing::IsEmpty()));
    EXPECT_EQ(content(whole_), before);
    EXPECT_FALSE(std::filesystem::exists(path("x")));
}

/// By a server that others wrote: the same as of the recording itself.
TEST_F(LiveRunTest, OfARobotIsThatOfItsRecording) {
    const std::string server = test::kSource + "/tests/programs/foxglove_server.js";
    const std::string node = "NODE_PATH=${NODE_PATH:-$(npm root -g 2>/dev/null)} node ";
    if (shell(node + "-e \"require('@foxglove/ws-protocol'); require('ws')\"").status != 0) {
        GTEST_SKIP() << "node, or its packages @foxglove/ws-protocol and ws, are missing; they "
                        "would replay a recording (npm install --global, or NODE_PATH)";
    }
    const std::string recording =
        std::string(HITOS_SHARED_DIR) + "/data/ros/freiburg-101_mcap/freiburg-101_mcap_0.mcap";
    if (!std::filesystem::exists(recording)) GTEST_SKIP() << recording << " is missing";
    const Outcome run =
        shell(node + server + " " + recording + " 2 > " + path("port") + " & while ! [ -s " +
              path("port") + " ]; do sleep 0.05; done; " + cli_ + " run ws://127.0.0.1:$(cat " +
              path("port") + ") --follow --patience 0 --out " + path("a"));
    ASSERT_EQ(run.status, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("receives /scan"));
    EXPECT_THAT(run.output, HasSubstr("the tour ends here"));
    expect_again("a.received.mcap", "a");
    const Outcome read = shell(cli_ + " run " + recording + " --out " + path("b"));
    ASSERT_EQ(read.status, 0) << read.output;
    auto live = results("a");
    auto recorded = results("b");
    live.erase("config.cfg");
    recorded.erase("config.cfg");
    EXPECT_EQ(live, recorded);
}

}  // namespace
}  // namespace hitos
