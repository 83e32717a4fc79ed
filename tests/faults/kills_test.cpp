// SPDX-License-Identifier: GPL-3.0-or-later
// Commands that are killed at a random moment of their work: what is there then is whole, and the
// same command again gives what it would have given. HITOS_REPEAT=10 kills ten times as often.
#include <fmt/format.h>

#include <array>
#include <chrono>
#include <iostream>
#include <random>
#include <string_view>
#include <thread>

#include "commands.hpp"

namespace hitos::test {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr int kCommands = 5;

/// What commands put in place as a whole.
constexpr std::array<std::string_view, 6> kParts{"out/",     "made.log", "made.tum",
                                                 "made.map", "made.png", "tour.txt.gz"};

int kills_of_each() {
    return repeated(30) / kCommands;
}

class Kills : public ::testing::TestWithParam<std::string> {
  protected:
    void expect_whole(const Command& command, const Content& found) const;

    Workplace place_;
    Content before_;
    Content after_;
};

/// What is in its place is of before or of after, file by file, and a folder of results all of one
/// time.
void Kills::expect_whole(const Command& command, const Content& found) const {
    if (command.resumes) {
        for (const auto& [name, bytes] : found) {
            const auto old = before_.find(name);
            const auto fresh = after_.find(name);
            const bool known = (old != before_.end() && old->second == bytes) ||
                               (fresh != after_.end() && fresh->second == bytes);
            // Tables and pages show what there was when they were made; that they are whole texts
            // is seen by the command that goes on.
            EXPECT_TRUE(known || bytes.ends_with('\n')) << name << " is half a file";
        }
        return;
    }
    for (const std::string_view part : kParts) {
        const auto of = [part](const Content& content) {
            Content some = content;
            std::erase_if(some, [part](const auto& one) { return !one.first.starts_with(part); });
            return some;
        };
        // While files of one command change places there is no log that others do not belong to.
        const bool away = command.name == "simulate" && part == "made.log" && of(found).empty();
        EXPECT_TRUE(away || of(found) == of(before_) || of(found) == of(after_))
            << part << " is neither as before nor as after:\n"
            << difference(of(before_), of(found));
    }
}

TEST_P(Kills, LeaveWholeResultsAndTheSameCommandGivesTheRest) {
    const Command command = command_named(GetParam(), place_);
    ASSERT_EQ(place_.run(command.before).status, 0);
    place_.keep("before");
    before_ = place_.content();
    // How long it takes here and now: the moments are parts of that.
    const auto start = Clock::now();
    ASSERT_EQ(place_.run(command.words).status, 0);
    Seconds duration = Clock::now() - start;
    after_ = place_.content();

    std::mt19937 random(2013);
    std::uniform_real_distribution<double> any(0.0, 1.0);
    const int kills = kills_of_each();
    int at_work = 0;
    for (int kill = 0; kill < kills; ++kill) {
        SCOPED_TRACE(fmt::format("kill {} of {}", kill + 1, command.name));
        place_.restore("before");
        const auto begin = Clock::now();
        const auto process = place_.start(command.words);
        std::this_thread::sleep_for(any(random) * duration);
        process->kill();
        const Outcome outcome = process->ended();
        if (outcome.status == 0) {
            duration = Clock::now() - begin;  // the machine has become faster
        } else {
            ++at_work;
        }
        expect_whole(command, finished_files(place_.content()));
        const Outcome again = place_.run(command.words);
        ASSERT_EQ(again.status, 0) << again.output;
        // Of a file that stands alone nobody knows that its name was being given.
        const bool alone = command.name == "convert" || command.name == "simulate";
        const Content found = alone ? finished_files(place_.content()) : place_.content();
        EXPECT_EQ(difference(after_, found), "") << "after the same command again";
        if (command.name.starts_with("run") || command.name == "study") {
            const std::string folder = place_.path(command.name == "study" ? "study" : "out");
            const Outcome verdict = place_.run({"verify", folder});
            EXPECT_EQ(verdict.status, 0) << verdict.output;
        }
        if (HasFailure()) return;
    }
    std::cout << fmt::format("{}: {} kills, {} of them at work, over {:.2f} s\n", command.name,
                             kills, at_work, duration.count());
}

INSTANTIATE_TEST_SUITE_P(, Kills,
                         ::testing::Values("run", "run_by_threads", "convert", "simulate", "study",
                                           "reproduce"),
                         [](const auto& command) { return command.param; });

}  // namespace
}  // namespace hitos::test
