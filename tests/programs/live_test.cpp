// SPDX-License-Identifier: GPL-3.0-or-later
// Runs whose tour comes in while it is mapped: run --follow.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/base/geometry.hpp"
#include "programs/program.hpp"
#include "unit/capture/ros_tours.hpp"

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

/// The second one is the end of all: nothing of what was not finished stays.
TEST_F(LiveRunTest, ThatIsStoppedTwiceEndsAtOnceAndClearsUp) {
    const std::string folder = path("results");
    std::filesystem::create_directory(folder);
    const std::string said = path("said");
    const Outcome run = shell(
        "gunzip -c " + log_ + " > " + path("g.log") + "; env --default-signal=INT " + cli_ +
        " run " + path("g.log") + " --follow --set filter.particles=20000 --poses " +
        path("poses.csv") + " --out " + folder + "/a > " + said + " 2>&1 & run=$!; until [ $(cat " +
        path("poses.csv") +
        " 2>/dev/null | wc -l) -ge 3 ]; do sleep 0.05; kill -0 $run || exit 9; done; " +
        "kill -INT $run; until grep -q 'the tour ends here' " + said +
        "; do sleep 0.05; kill -0 $run || exit 8; done; sleep 0.3; kill -INT $run; wait $run");
    EXPECT_EQ(run.status, 130) << content(said);
    EXPECT_THAT(content(said), HasSubstr("stopped at once"));
    EXPECT_TRUE(std::filesystem::is_empty(folder)) << shell("ls -laR " + folder).output;
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

/// Whatever came is not lost where nothing could be made of it.
TEST_F(LiveRunTest, ThatFailsEarlySaysWhereIsWhatCame) {
    const Outcome run =
        shell("echo no tour at all | " + cli_ + " run - --follow --out " + path("a"));
    EXPECT_EQ(run.status, 1) << run.output;
    EXPECT_THAT(run.output, HasSubstr("what was received is kept in " + path("a.received.log")));
    EXPECT_EQ(content(path("a.received.log")), "no tour at all\n");
    // Of one that began, the results say it.
    const Outcome later = shell("cat " + whole_ + " | " + cli_ + " run - --follow --out " +
                                path("b") + " --poses /dev/full --strict");
    EXPECT_THAT(later.output, testing::Not(HasSubstr("what was received is kept in")));
}

/// The results, on another disk, are of what the full one has.
TEST_F(LiveRunTest, OnAFullDiskEndsWithWhatItHas) {
    const std::uintmax_t whole = std::filesystem::file_size(whole_);
    const std::string limit = std::to_string(whole / 2 / 512);  // of any file, as sh counts
    const Outcome run = shell("(ulimit -f " + limit + "; cat " + whole_ + " | " + cli_ +
                              " run - --follow --out " + path("a") + ")");
    EXPECT_EQ(run.status, 1) << run.output;
    EXPECT_THAT(run.output, HasSubstr("cannot keep what comes in"));
    const std::string kept = content(path("a.received.log"));
    EXPECT_GT(kept.size(), whole / 4);
    EXPECT_EQ(kept, content(whole_).substr(0, kept.size()));
    EXPECT_THAT(run.output, HasSubstr("results in"));
    // Nor is what little fits thrown away.
    const Outcome little = shell("(ulimit -f 8; cat " + whole_ + " | " + cli_ +
                                 " run - --follow --out " + path("b") + ")");
    EXPECT_EQ(little.status, 1) << little.output;
    EXPECT_EQ(content(path("b.received.log")), content(whole_).substr(0, 4096));
}

/// What another run shows has the protocol and no laser.
TEST_F(LiveRunTest, OfWhatNothingCameLeavesNothing) {
    const std::string said = path("said");
    const std::string served = path("served");
    const Outcome run = shell(
        "mkfifo " + path("pipe") + "; " + cli_ + " run - --follow --serve 0 --out " + path("b") +
        " < " + path("pipe") + " > " + served + " 2>&1 & server=$!; exec 3> " + path("pipe") +
        "; until grep -q ws:// " + served + "; do sleep 0.05; kill -0 $server || exit 9; done; " +
        cli_ + " run $(grep -o 'ws://[0-9.:]*' " + served + ") --follow --out " + path("a") +
        " > " + said + " 2>&1 & run=$!; until grep -q 'no laser' " + said +
        "; do sleep 0.05; kill -0 $run || exit 8; done; kill -TERM $run; wait $run");
    EXPECT_EQ(run.status, 143) << run.output << content(said);
    EXPECT_THAT(content(said), HasSubstr("nothing was received: " + path("a.received.mcap")));
    EXPECT_THAT(content(said), testing::Not(HasSubstr("was not closed")));  // it is open
    EXPECT_FALSE(std::filesystem::exists(path("a.received.mcap")));
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
    for (const char* robot : {"ws://robot", "robot:8765"})
        EXPECT_THAT(refused(robot), HasSubstr("run --follow maps what the robot sends"));
    EXPECT_THAT(refused(log_ + " --poses " + path("p.csv")), HasSubstr("--follow"));
    EXPECT_THAT(refused(whole_ + " --follow --config - < " + config_), HasSubstr("from a file"));
    const std::string before = content(whole_);
    EXPECT_THAT(refused("- --follow --poses " + whole_ + " --reference-trajectory " + whole_ +
                        " < " + whole_),
                testing::Not(testing::IsEmpty()));
    EXPECT_EQ(content(whole_), before);
    EXPECT_FALSE(std::filesystem::exists(path("x")));
}

/// By a server that others wrote.
class LiveRobotTest : public LiveRunTest {
  protected:
    void SetUp() override {
        LiveRunTest::SetUp();
        if (shell(node_ + "-e \"require('@foxglove/ws-protocol'); require('ws')\"").status != 0) {
            GTEST_SKIP() << "node, or its packages @foxglove/ws-protocol and ws, are missing; they "
                            "would replay a recording (npm install --global, or NODE_PATH)";
        }
    }
    /// A run of what it tells of the recording, within so many seconds.
    Outcome run_of(const std::string& recording, int seconds, const std::string& more) const {
        const std::string port = path("port");
        return shell(node_ + test::kSource + "/tests/programs/foxglove_server.js " + recording +
                     " " + std::to_string(seconds) + " > " + port + " & while ! [ -s " + port +
                     " ]; do sleep 0.05; done; " + cli_ + " run ws://127.0.0.1:$(cat " + port +
                     ") --follow --patience 0 --out " + path("a") + " " + more);
    }
    const std::string node_ = "NODE_PATH=${NODE_PATH:-$(npm root -g 2>/dev/null)} node ";
};

/// The same as of the recording itself.
TEST_F(LiveRobotTest, IsThatOfItsRecording) {
    const std::string recording =
        std::string(HITOS_SHARED_DIR) + "/data/ros/freiburg-101_mcap/freiburg-101_mcap_0.mcap";
    if (!std::filesystem::exists(recording)) GTEST_SKIP() << recording << " is missing";
    const Outcome run = run_of(recording, 2, "");
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

/// How far the wall of a room of 8 m by 6 m is.
float room(double x_m, double angle_rad) {
    const double c = std::cos(angle_rad);
    const double s = std::sin(angle_rad);
    const double along = (c > 0.0 ? 5.0 - x_m : 3.0 + x_m) / std::max(std::abs(c), 1e-9);
    return static_cast<float>(std::min(along, 3.0 / std::max(std::abs(s), 1e-9)));
}

/// A robot that drives through it with two lasers in one place, one of them upside down.
std::string tour_of_two_lasers() {
    constexpr std::uint32_t kScans = 60;
    constexpr double kTurn = 0.7;
    constexpr double kStep = 0.02;
    constexpr int kRays = 71;
    const test::Bytes cdr = test::Bytes::cdr();
    std::vector<test::Said> all{
        test::said_transforms({{{100, 0}, "base_link", "right", {0.2, 0.0, 0.1, 0.0, -kTurn}},
                               {{100, 0}, "base_link", "left", {0.2, 0.0, 0.1, kPi, kTurn}}},
                              cdr, "/tf_static")};
    for (std::uint32_t i = 0; i < kScans; ++i) {
        const test::Stamp stamp{100 + i / 10, i % 10 * 100'000'000};
        const double x_m = 0.02 * i;
        all.push_back(test::said_odometry(stamp, {x_m, 0.0}, cdr));
        for (const bool left : {false, true}) {
            test::LaserFields laser{stamp, left ? "left" : "right", -0.7, kStep, 0.05, 20.0, {}};
            for (int ray = 0; ray < kRays; ++ray) {
                const double angle = -0.7 + kStep * ray;
                laser.ranges.push_back(room(x_m + 0.2, left ? kTurn - angle : angle - kTurn));
            }
            // Now and then one of them says nothing.
            if (i % 7 != (left ? 3 : 5))
                all.push_back(test::said_laser(laser, cdr, left ? "/left" : "/right"));
        }
    }
    return test::mcap_of(all);
}

/// The lasers are joined by what has come, as they are from the file.
TEST_F(LiveRobotTest, WithTwoLasersIsThatOfWhatWasReceived) {
    const std::string recording = file("two.mcap", tour_of_two_lasers());
    const Outcome run = run_of(recording, 1, "--scan-topic all");
    ASSERT_EQ(run.status, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("receives /left"));
    EXPECT_THAT(run.output, HasSubstr("receives /right"));
    EXPECT_THAT(content(path("a/summary.json")), HasSubstr("\"scans\": 60"));
    expect_again("a.received.mcap", "a");
}

/// Of a recording with all that is difficult: stamps out of order, chunks packed in three ways.
TEST_F(LiveRunTest, OfTwoLasersThroughAPipeIsThatOfWhatCame) {
    const std::string recording =
        std::string(HITOS_SHARED_DIR) + "/data/ros/two-lasers_mcap/two-lasers_mcap_0.mcap";
    if (!std::filesystem::exists(recording)) GTEST_SKIP() << recording << " is missing";
    const Outcome run = shell("cat " + recording + " | " + cli_ +
                              " run - --follow --scan-topic all --opening 5 --out " + path("a"));
    ASSERT_EQ(run.status, 0) << run.output;
    EXPECT_EQ(content(path("a.received.mcap")), content(recording));
    expect_again("a.received.mcap", "a");
}

}  // namespace
}  // namespace hitos
