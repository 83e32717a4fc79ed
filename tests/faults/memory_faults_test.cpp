// SPDX-License-Identifier: GPL-3.0-or-later
// Memory that is refused. There are too many allocations to refuse each: a seeded sample of all,
// one at a time; every one of the great ones; and the state of a machine that has no more, where
// every allocation of some size is refused from one on. HITOS_REPEAT=10 takes ten times as many.
#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <iostream>
#include <random>
#include <sstream>

#include "commands.hpp"

namespace hitos::test {
namespace {

constexpr long kGreat = 1L << 16;  // bytes: buffers, pictures, columns of landmarks
constexpr long kMiddling = 1L << 10;

std::size_t wished_sample() {
    return static_cast<std::size_t>(repeated(10));
}

class MemoryFaults : public ::testing::TestWithParam<std::string> {
  protected:
    Words refusing(long number, long least, const std::string& word = "") const {
        return {"LD_PRELOAD=" HITOS_FAULTS_LIBRARY,
                fmt::format("HITOS_FAULT_MEMORY={}:{}{}", number, least, word),
                "HITOS_FAULT_REPORT=" + place_.report_file()};
    }
    /// How many allocations of that size there are.
    long allocations(const Command& command, long least) {
        place_.restore("before");
        EXPECT_EQ(place_.run(command.words, refusing(0, least)).status, 0);
        long count = 0;
        for (const std::string& line : place_.take_report()) {
            std::istringstream text(line);
            std::string word;
            text >> word >> count;
        }
        return count;
    }
    void expect_harmless(const Command& command, const Words& environment);

    Workplace place_;
    Content after_;
};

void MemoryFaults::expect_harmless(const Command& command, const Words& environment) {
    place_.restore("before");
    const Outcome outcome = place_.run(command.words, environment);
    const std::vector<std::string> report = place_.take_report();
    if (report.empty()) return;  // it did with fewer
    SCOPED_TRACE(fmt::format("{}, {}, status {}, said:\n{}", environment[1], report.front(),
                             outcome.status, outcome.output));
    // A library that could not pass on that there was no memory: the program has ended at once.
    const bool at_once = outcome.output.find("it ended at once") != std::string::npos;
    // So they do themselves, without a message: for the results that is as if it were killed.
    const bool library_ended_it =
        (outcome.status == 128 + SIGSEGV || outcome.status == 128 + SIGABRT) &&
        std::ranges::any_of(report, [](const auto& line) { return line.starts_with("refused"); });
    EXPECT_TRUE(library_ended_it || outcome.status < 3) << "it has not ended by itself";
    EXPECT_EQ(outcome.output.find("terminate called"), std::string::npos);
    EXPECT_EQ(outcome.output.find("bad_alloc"), std::string::npos) << "that says nothing to a user";
    if (outcome.status == 1) {
        EXPECT_NE(outcome.output.find("hitos-cli: "), std::string::npos) << "nothing is said";
    }
    const Content left = outcome.status == 0 ? place_.content() : without_waiting(place_.content());
    // Without any memory nothing can be cleared either: the command below does that.
    const bool could_clear = environment[1].find("lasting") == std::string::npos;
    if (!library_ended_it && !at_once && could_clear) {
        EXPECT_EQ(difference(finished_files(left), left), "") << "temporary files are left";
    }
    if (finished_files(left) == after_) return;
    if (command.name.starts_with("run")) {
        const Outcome verdict = place_.run({"verify", place_.path("out")});
        EXPECT_EQ(verdict.status, 0) << verdict.output;
    }
    EXPECT_EQ(place_.run(command.words).status, 0);
    EXPECT_EQ(difference(after_, place_.content()), "") << "after the same command again";
}

TEST_P(MemoryFaults, EndInAMessageAndLeaveWholeResults) {
    const Command command = command_named(GetParam(), place_);
    ASSERT_EQ(place_.run(command.before).status, 0);
    place_.keep("before");
    ASSERT_EQ(place_.run(command.words).status, 0);
    after_ = place_.content();

    const std::size_t sample = wished_sample();
    std::mt19937 random(13);
    const auto some_of = [&](long least, const std::string& word) {
        const long all = allocations(command, least);
        ASSERT_GT(all, 0);
        std::uniform_int_distribution<long> any(1, all);
        for (std::size_t i = 0; i < sample; ++i) {
            expect_harmless(command, refusing(any(random), least, word));
        }
        std::cout << fmt::format("{}: {} of {} allocations of {} bytes and more{}\n", command.name,
                                 sample, all, least, word);
    };
    some_of(0, "");
    some_of(kMiddling, ":lasting");
    const long great = std::min(allocations(command, kGreat), static_cast<long>(sample));
    for (long number = 1; number <= great; ++number) {
        expect_harmless(command, refusing(number, kGreat));
    }
}

INSTANTIATE_TEST_SUITE_P(, MemoryFaults,
                         ::testing::Values("run", "run_by_threads", "convert", "simulate", "study"),
                         [](const auto& command) { return command.param; });

}  // namespace
}  // namespace hitos::test
