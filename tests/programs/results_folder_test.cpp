// SPDX-License-Identifier: GPL-3.0-or-later
// A folder of results is always of one run, whatever happens to the processes that write it; how
// programs end.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "program.hpp"

namespace hitos {
namespace {

using test::content;
using test::Outcome;
using test::shell;
using testing::HasSubstr;

class ResultsFolder : public test::ProgramTest {
  protected:
    /// A run of about a second, pictures and all.
    std::string run(int seed) const {
        return fmt::format(
            "{} run {} --config {} --set filter.particles=10 --seed {} --replace --out {}", cli_,
            log_, config_, seed, path("out"));
    }
    std::string verify() const { return cli_ + " verify " + path("out"); }
    /// What is in the test's folder beside the results, hidden or not.
    std::vector<std::string> left() const {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(path(""))) {
            if (entry.path().filename() != "out") names.push_back(entry.path().filename());
        }
        return names;
    }
    int seed_there() const {
        return nlohmann::json::parse(content(path("out/summary.json")))["seed"];
    }
};

TEST_F(ResultsFolder, IsVerified) {
    ASSERT_EQ(shell(run(1)).status, 0);
    const Outcome whole = shell(verify());
    EXPECT_EQ(whole.status, 0) << whole.output;
    EXPECT_NE(whole.output.find("whole: "), std::string::npos);
    ASSERT_EQ(
        shell("cd " + path("out") + " && rm map.dxf && echo >> map.txt && cp map.txt distances.csv")
            .status,
        0);
    const Outcome broken = shell(verify());
    EXPECT_EQ(broken.status, 1);
    for (const char* line :
         {"map.dxf: missing\n", "map.txt: changed", "distances.csv: left over"}) {
        EXPECT_NE(broken.output.find(line), std::string::npos) << broken.output;
    }
    EXPECT_GT(shell(cli_ + " verify " + path("nowhere")).status, 0);
    // The next run makes it whole again, but for what it cannot know to be nobody's.
    ASSERT_EQ(shell(run(2)).status, 0);
    EXPECT_EQ(shell(verify()).output, "distances.csv: left over: not of this run\n");
    std::filesystem::remove(path("out/distances.csv"));
    EXPECT_EQ(shell(verify()).status, 0);
}

TEST_F(ResultsFolder, OfAnotherRunIsKeptUnlessItIsToBeReplaced) {
    const std::string log =
        file("tour.log", shell("zcat " + test::kSource + "/data/logs/player-laser.log.gz").output);
    const auto run = [&](const std::string& source, const std::string& how) {
        return shell(fmt::format("{} run {} {} --set grid.resolution=0.2 --out {}", cli_, source,
                                 how, path("out")));
    };
    const auto expect_kept = [&](const Outcome& outcome, const std::vector<std::string>& words) {
        EXPECT_EQ(outcome.status, 1) << outcome.output;
        for (const std::string& word : words) EXPECT_THAT(outcome.output, HasSubstr(word));
        EXPECT_THAT(outcome.output, HasSubstr("--replace"));
        EXPECT_EQ(shell(verify()).status, 0);
    };
    const std::string few = "--set filter.particles=5 --seed 3";
    ASSERT_EQ(run(log, few).status, 0);
    const std::map<std::string, std::string> former = files("out");
    // The same run, however its source and what changes no result are written, takes its place.
    EXPECT_EQ(run(path("./tour.log"), few + " --threads 1 --write svg").status, 0);
    EXPECT_TRUE(test::fs::exists(path("out/map.svg")));
    // Files that were asked for are not lost by who does not ask for them again.
    expect_kept(run(log, few), {"map.svg", "--write svg"});
    EXPECT_TRUE(test::fs::exists(path("out/map.svg")));
    EXPECT_EQ(run(log, few + " --write svg,landmarks --grid-of 3").status, 0);
    expect_kept(run(log, few), {"(--grid-of 3 --write landmarks,svg)"});
    expect_kept(run(log, few + " --write svg,landmarks --grid-of 1"),
                {"grid_particle_3.", "(--grid-of 3)"});
    EXPECT_EQ(run(log, few + " --grid-of 3 --write landmarks,svg").status, 0);
    EXPECT_EQ(run(log, few + " --grid-of 3 --uncertainty --write all").status, 0);
    expect_kept(run(log, few + " --grid-of 3 --write all"), {"uncertainty.csv", "(--uncertainty)"});
    EXPECT_EQ(run(log, few + " --replace").status, 0);
    EXPECT_FALSE(test::fs::exists(path("out/map.svg")));
    expect_kept(run(log, "--set filter.particles=6 --seed 3"),
                {path("out"), log, ", written 20", "filter.particles 5"});
    expect_kept(run(log, "--set filter.particles=5 --seed 4"), {"run.seed 3"});
    expect_kept(run(log, "--preset ekf --seed 4"), {"…"});
    expect_kept(run("corridor", few), {"another source, " + log});
    for (const auto& [name, text] : files("out")) {
        if (name == "summary.json") continue;  // which has times
        EXPECT_EQ(text, former.at(name)) << name;
    }
    EXPECT_EQ(left(), std::vector<std::string>{"tour.log"});
    EXPECT_EQ(run("corridor", few + " --replace").status, 0);
    EXPECT_THAT(content(path("out/config.cfg")), HasSubstr("corridor.toml"));
    // A log that has gone since is still another one, and what cannot be known is not the same.
    ASSERT_EQ(run(log, few + " --replace").status, 0);
    test::fs::rename(log, path("moved.log"));
    expect_kept(run(path("moved.log"), few), {"another source, " + log});
    test::fs::remove(path("out/config.cfg"));
    const Outcome unknown = run(path("moved.log"), few);
    EXPECT_EQ(unknown.status, 1);
    EXPECT_THAT(unknown.output, HasSubstr("cannot be compared"));
    EXPECT_EQ(run(path("moved.log"), few + " --replace").status, 0);
}

TEST_F(ResultsFolder, FilesOfNoRunAreNotWrittenOver) {
    const auto write = [&](const std::string& how) {
        return shell(fmt::format("{} run {} --config {} --set filter.particles=5 {} --out {}", cli_,
                                 log_, config_, how, path("out")));
    };
    std::filesystem::create_directories(path("out"));
    for (const char* name : {"config.cfg", "map.txt", "map.svg", "notes.md"})
        file(std::string("out/") + name, "mine\n");
    const std::map<std::string, std::string> mine = files("out");
    const Outcome refused = write("");
    EXPECT_EQ(refused.status, 1);
    EXPECT_THAT(refused.output, HasSubstr(", which is of no run; choose another folder, or say "
                                          "--replace to put this run in its place"));
    EXPECT_EQ(files("out"), mine);
    // What the run does not write stays, and is in nobody's way.
    std::filesystem::remove(path("out/config.cfg"));
    std::filesystem::remove(path("out/map.txt"));
    ASSERT_EQ(write("").status, 0);
    EXPECT_EQ(content(path("out/map.svg")), "mine\n");
    const Outcome drawn = write("--write svg");
    EXPECT_EQ(drawn.status, 1);
    EXPECT_THAT(drawn.output, HasSubstr("holds map.svg, which is of no run"));
    ASSERT_EQ(write("--write svg --replace").status, 0);
    EXPECT_NE(content(path("out/map.svg")), "mine\n");
    // Results whose summary is gone are nobody's that could be compared.
    std::filesystem::remove(path("out/summary.json"));
    EXPECT_EQ(write("").status, 1);
    EXPECT_EQ(write("--replace").status, 0);
    // The same of a study's tables.
    std::filesystem::create_directories(path("study"));
    file("study/summary.csv", "mine\n");
    const Outcome study = shell(fmt::format(
        "{} study corridor --vary filter.particles=2 --runs 1 --out {}", cli_, path("study")));
    EXPECT_EQ(study.status, 1);
    EXPECT_THAT(study.output, HasSubstr("holds summary.csv, which is of no study"));
    EXPECT_EQ(content(path("study/summary.csv")), "mine\n");
}

TEST_F(ResultsFolder, IsOfOneRunAfterEveryKill) {
    ASSERT_EQ(shell(run(1)).status, 0);
    for (int kill = 0; kill < 12; ++kill) {
        shell(fmt::format("timeout -s KILL {:.2f} {} > {} 2>&1", 0.1 * (kill + 1), run(2 + kill),
                          path("said")));
        const Outcome verdict = shell(verify());
        ASSERT_EQ(verdict.status, 0) << kill << ": " << verdict.output;
        EXPECT_LE(seed_there(), 2 + kill);  // it may have been killed with all done
    }
    ASSERT_EQ(shell(run(99)).status, 0);
    EXPECT_EQ(seed_there(), 99);
    EXPECT_EQ(shell("ls -A " + path(".") + " | grep -v -e '^out$' -e '^said$'").output, "")
        << "what killed processes left is cleared away";
}

TEST_F(ResultsFolder, ASecondRunIsToldWhoWritesIt) {
    // The first one, long enough to be met at it, stands still while the second one comes.
    const Outcome both =
        shell(fmt::format("{0} --set filter.particles=3000 > {1} 2>&1 & while [ ! -e {2} ]; do "
                          "sleep 0.01; done; sleep 0.05; kill -STOP $!; {3}; echo second $?; "
                          "kill -CONT $!; wait $!; echo first $?",
                          run(1), path("said"), path(".out.hitos-lock"), run(2)));
    EXPECT_NE(both.output.find("is being written by process "), std::string::npos) << both.output;
    EXPECT_NE(both.output.find("second 1"), std::string::npos) << both.output;
    EXPECT_NE(both.output.find("first 0"), std::string::npos) << both.output;
    EXPECT_EQ(seed_there(), 1);
    EXPECT_EQ(shell(verify()).status, 0);
}

TEST_F(ResultsFolder, KeepsWhatItHadWhereTheDiskIsFull) {
    ASSERT_EQ(shell(run(1)).status, 0);
    // A file that may not grow beyond 20 blocks is what a full disk is to its writer.
    const Outcome full = shell("trap '' XFSZ; ulimit -f 20; " + run(2));
    EXPECT_GT(full.status, 0) << full.output;
    EXPECT_NE(full.output.find(path("out/")), std::string::npos) << full.output;
    EXPECT_NE(full.output.find("File too large"), std::string::npos) << full.output;
    EXPECT_EQ(seed_there(), 1);
    EXPECT_EQ(shell(verify()).status, 0);
}

TEST_F(ResultsFolder, HoldsTheFirstScansOfARunThatWasAskedToStop) {
    // However slow the machine, some delay falls into the run.
    Outcome stopped;
    for (double delay = 0.4; !std::filesystem::exists(path("out/summary.json")); delay *= 2.0) {
        stopped = shell(fmt::format("timeout --preserve-status -s INT {} {} --set {}", delay,
                                    run(1), "filter.particles=3000"));
        ASSERT_EQ(stopped.status, 130) << stopped.output;
    }
    EXPECT_NE(stopped.output.find("stopped: these are the results of the first "),
              std::string::npos)
        << stopped.output;
    EXPECT_EQ(shell(verify()).status, 0);
    const auto summary = nlohmann::json::parse(content(path("out/summary.json")));
    EXPECT_EQ(summary["finished"], false);
    EXPECT_FALSE(summary["not_written"].empty()) << "what reads the log again";
    EXPECT_LT(summary["scans"], 1050);
    ASSERT_EQ(shell(run(2)).status, 0);
    EXPECT_EQ(nlohmann::json::parse(content(path("out/summary.json")))["finished"], true);
}

TEST_F(ResultsFolder, OfAFinishedRunIsNotGivenUpForAStoppedOne) {
    ASSERT_EQ(shell(run(1)).status, 0);
    const std::map<std::string, std::string> finished = files("out");
    const std::string other = run(2) + " --set filter.particles=3000";
    for (const auto& [signal, status] : {std::pair("TERM", 143), std::pair("INT", 130)}) {
        // However slow the machine, some delay falls into the run.
        Outcome stopped;
        for (double delay = 0.4; stopped.output.find(": these ") == std::string::npos &&
                                 stopped.output.find("keeps the results") == std::string::npos;
             delay *= 2.0) {
            stopped =
                shell(fmt::format("timeout --preserve-status -s {} {} {}", signal, delay, other));
            ASSERT_EQ(stopped.status, status) << stopped.output;
        }
        EXPECT_THAT(stopped.output,
                    HasSubstr("nothing is written: " + path("out") +
                              " keeps the results of a run to its tour's end, written 20"));
        EXPECT_THAT(stopped.output, HasSubstr("; --out with another folder keeps what"));
        EXPECT_EQ(files("out"), finished);
        EXPECT_TRUE(left().empty());
    }
}

TEST_F(ResultsFolder, IsWholeAfterASecondRequest) {
    ASSERT_EQ(shell(run(1)).status, 0);
    const Outcome ended = shell(fmt::format(
        "{} --set filter.particles=20000 & sleep 0.3; kill -TERM $!; sleep 0.3; kill -TERM $!; "
        "wait $!; echo status $?",
        run(2)));
    EXPECT_NE(ended.output.find("status 143"), std::string::npos) << ended.output;
    EXPECT_EQ(left(), std::vector<std::string>());
    EXPECT_EQ(shell(verify()).status, 0);
}

TEST_F(ResultsFolder, IsWholeAfterEverySignalThatATerminalSends) {
    ASSERT_EQ(shell(run(1)).status, 0);
    // The first may come while the log is opened, the second ends at once.
    for (const char* signals : {"QUIT INT", "INT QUIT", "INT INT"}) {
        const Outcome ended =
            shell(fmt::format("env --default-signal=INT,QUIT {} --set filter.particles=20000 & "
                              "sleep 0.3; for s in {}; do kill "
                              "-s $s $!; sleep 0.3; "
                              "done; wait $!; echo status $?",
                              run(2), signals));
        EXPECT_NE(ended.output.find("status 13"), std::string::npos) << signals << ended.output;
        EXPECT_EQ(left(), std::vector<std::string>()) << signals;
        EXPECT_EQ(shell(verify()).status, 0) << signals;
    }
}

TEST_F(ResultsFolder, ALinkThatLeadsNowhereIsToldAsThat) {
    std::filesystem::create_symlink("nowhere", path("out"));
    const Outcome outcome = shell(run(1));
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.output.find("out: is a link to nowhere, which is not there"),
              std::string::npos)
        << outcome.output;
}

TEST_F(ResultsFolder, IsWholeWhereARequestTakesTooLong) {
    ASSERT_EQ(shell(run(1)).status, 0);
    // What was there stays; what was made for a folder that was not there goes. However fast or
    // slow the machine, some request falls into a step that takes longer than its patience.
    for (const char* out : {"out", "fresh"}) {
        Outcome ended;
        // One that falls behind the exchange finds the new results there, which are whole too.
        const auto cut_short = [&] {
            return ended.output.find("ended before all was written") != std::string::npos &&
                   seed_there() == 1 && !std::filesystem::exists(path("fresh"));
        };
        for (int delay = 0; delay < 40 && !cut_short(); ++delay) {
            std::filesystem::remove_all(path("fresh"));
            ASSERT_EQ(shell(run(1)).status, 0);
            ended = shell(
                fmt::format("HITOS_STOP_SECONDS=0.01 {} run {} --seed 2 --set "
                            "filter.particles=200000 --replace --out {} & sleep {:.2f}; kill -TERM "
                            "$!; wait $!; echo status $?",
                            cli_, log_, path(out), 0.3 + 0.07 * delay));
            ASSERT_NE(ended.output.find("status 143"), std::string::npos) << ended.output;
            ASSERT_EQ(shell(verify()).status, 0);
        }
        EXPECT_TRUE(cut_short()) << ended.output;
        EXPECT_EQ(left(), std::vector<std::string>());
    }
}

TEST_F(ResultsFolder, ALogWhoseNameNoTextCanHoldIsWarnedOf) {
    folder_.put("bad\xff.log.gz", content(log_));
    const std::string options = " --set filter.particles=2 --config " + config_ + " --out ";
    const Outcome bad =
        shell(cli_ + " run '" + path("bad\xff.log.gz") + "'" + options + path("out"));
    EXPECT_EQ(bad.status, 0);
    EXPECT_THAT(bad.output, HasSubstr("is no UTF-8, which config.cfg has to be"));
    EXPECT_THAT(bad.output, HasSubstr("Rename it and run it again"));
    EXPECT_EQ(shell(cli_ + " run " + log_ + options + path("good")).output.find("UTF-8"),
              std::string::npos);
}

TEST_F(ResultsFolder, ALogThatCannotBeReadLeavesNoFolder) {
    const Outcome outcome = shell(cli_ + " run nosuch.log --out " + path("out"));
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.output.find("nosuch.log: there is no such file"), std::string::npos)
        << outcome.output;
    EXPECT_EQ(outcome.output.find("world"), std::string::npos) << outcome.output;
    folder_.put("none.log", "nothing of a log\n");
    EXPECT_EQ(shell(cli_ + " run " + path("none.log") + " --out " + path("out")).status, 1);
    EXPECT_FALSE(std::filesystem::exists(path("out")));
}

TEST_F(ResultsFolder, WhatIsReadIsNotWritten) {
    folder_.put("tour.log", content(log_));
    const std::string log = path("tour.log");
    const std::string before = content(log);
    std::filesystem::create_directory(path("out"));
    std::filesystem::create_symlink(log, path("link.log"));
    for (const std::string& command :
         {fmt::format("run {0} --out {1} --figures {0}", log, path("out")),
          fmt::format("convert {0} --to carmen --out {0}", log),
          fmt::format("convert {} --to carmen --out {}", log, path("link.log")),
          fmt::format("convert {} --to carmen --out {}", path("link.log"),
                      path("out/../tour.log"))}) {
        const Outcome refused = shell(cli_ + " " + command);
        EXPECT_EQ(refused.status, 1) << command;
        EXPECT_NE(refused.output.find("is read by this very command"), std::string::npos)
            << refused.output;
        EXPECT_TRUE(content(log) == before) << command;
    }
    const Outcome twice =
        shell(cli_ + " simulate bigloop --out " + path("s") + " --truth " + path("s"));
    EXPECT_NE(twice.output.find("is to be written twice"), std::string::npos) << twice.output;
    const Outcome figures = shell(run(1) + " --figures " + path("out/map.txt"));
    EXPECT_NE(figures.output.find("is the name of one of the results"), std::string::npos)
        << figures.output;
}

TEST_F(ResultsFolder, ALogThatChangesMeanwhileGivesTheScansUntilThen) {
    for (const char* change : {"cp {0} {0}.new; mv {0}.new {0}", "rm {0}"}) {
        std::filesystem::remove_all(path("out"));
        // It is another file, or none, from when the run has begun, however late it ends.
        Outcome outcome;
        for (int halves = 1; halves < 40; halves *= 2) {
            folder_.put("tour.log.gz", content(log_));
            outcome =
                shell(fmt::format("{0} run {1} --config {2} --set filter.particles=3000 --seed 2 "
                                  "--replace --out {3} & sleep "
                                  "{4}; {5}; wait $!; echo status $?",
                                  cli_, path("tour.log.gz"), config_, path("out"), halves / 2.0,
                                  fmt::format(fmt::runtime(change), path("tour.log.gz"))));
            if (outcome.output.find("status 0") == std::string::npos &&
                outcome.output.find("there is no such file") == std::string::npos) {
                break;  // before it was opened
            }
        }
        EXPECT_NE(outcome.output.find("status 1"), std::string::npos) << outcome.output;
        EXPECT_NE(outcome.output.find("has changed while it was being worked on"),
                  std::string::npos)
            << outcome.output;
        // None where it was so early that there is no scan.
        if (std::filesystem::exists(path("out"))) {
            EXPECT_NE(outcome.output.find("the results are of the first "), std::string::npos)
                << outcome.output;
            const auto summary = nlohmann::json::parse(content(path("out/summary.json")));
            EXPECT_FALSE(summary["finished"]);
            EXPECT_FALSE(summary["not_written"].empty()) << "what reads the log again";
            EXPECT_EQ(shell(verify()).status, 0);
        }
    }
}

TEST_F(ResultsFolder, ALogWhoseModeChangesIsTheSame) {
    folder_.put("tour.log.gz", content(log_));
    const Outcome outcome = shell(fmt::format(
        "{0} run {1} --config {2} --set filter.particles=500 --out {3} & for i in 1 2 3 4 "
        "5 6; do sleep 0.2; chmod 64$((i % 2 * 4)) {1}; ln -f {1} {1}.backup; done; wait "
        "$!; echo status $?",
        cli_, path("tour.log.gz"), config_, path("out")));
    EXPECT_NE(outcome.output.find("status 0"), std::string::npos) << outcome.output;
    EXPECT_EQ(shell(verify()).status, 0);
}

TEST_F(ResultsFolder, AShortageOfMemorySaysWhatToLower) {
#ifdef HITOS_SANITIZED
    GTEST_SKIP() << "sanitizers need more address space than may be limited";
#endif
    ASSERT_EQ(shell(run(1)).status, 0);
    const Outcome outcome =
        shell("ulimit -v 1200000; " + run(2) + " --set filter.particles=1000000");
    EXPECT_EQ(outcome.status, 1) << outcome.output;
    EXPECT_NE(outcome.output.find("out of memory"), std::string::npos) << outcome.output;
    EXPECT_NE(outcome.output.find("lower filter.particles"), std::string::npos) << outcome.output;
    EXPECT_EQ(seed_there(), 1);
    EXPECT_EQ(shell(verify()).status, 0);
}

class Streams : public test::ProgramTest {
  protected:
    /// The command, into a new folder, stopped while its runs are under way: however fast or slow
    /// the machine, some delay falls there.
    Outcome stopped_on_the_way(const std::string& command, const std::string& out,
                               const std::string& signal) const {
        Outcome stopped;
        for (int delay_ms = 20; delay_ms < 1'000'000; delay_ms += delay_ms / 5) {
            std::filesystem::remove_all(path(out));
            stopped = shell(fmt::format("timeout --preserve-status -s {} {:.3f} {}{}", signal,
                                        0.001 * delay_ms, command, path(out)));
            if (stopped.output.find("the same command goes on") != std::string::npos) break;
        }
        return stopped;
    }
};

TEST_F(Streams, AFullOrClosedStandardOutputIsAnError) {
    const Outcome outcome =
        shell(fmt::format("{{ {} parameters; echo status $? >&2; }} > /dev/full", cli_));
    EXPECT_NE(outcome.output.find("status 1"), std::string::npos) << outcome.output;
    EXPECT_NE(outcome.output.find("standard output: "), std::string::npos) << outcome.output;
    EXPECT_EQ(shell(cli_ + " parameters >&- ").status, 1);
}

TEST_F(Streams, NoFileTakesThePlaceOfAClosedOne) {
    const std::string simulate = cli_ + " simulate recinto --set tour.laps=8 --out ";
    ASSERT_EQ(shell(simulate + path("whole.log")).status, 0);
    ASSERT_EQ(shell(simulate + path("closed.log") + " 2>&-").status, 0);
    EXPECT_EQ(content(path("closed.log")), content(path("whole.log")));
    EXPECT_EQ(shell(cli_ + " info - <&-").status, 1);
}

TEST_F(Streams, WhoReadsNoFurtherHearsNoComplaint) {
    const Outcome outcome =
        shell(fmt::format("{{ sleep 0.5; {} parameters; echo status $? >&2; }} | true", cli_));
    EXPECT_EQ(outcome.output, "status 141\n");
    // What the command is for is done all the same.
    const Outcome run =
        shell(fmt::format("{{ {} run {}/data/logs/radish.log.gz --set filter.particles=5 --out {} "
                          "2> /dev/null; echo status $? >&2; }} | true",
                          cli_, test::kSource, path("run")));
    EXPECT_EQ(run.output, "status 141\n");
    EXPECT_EQ(shell(cli_ + " verify " + path("run")).status, 0);
}

TEST_F(Streams, ASignalLeavesNoTemporaryFile) {
    folder_.put("tour.log", "precious");
    for (const char* delay : {"0.05", "0.1", "0.2"}) {
        shell(fmt::format("timeout -s TERM {} {} simulate bigloop2 --format player --out {}", delay,
                          cli_, path("tour.log")));
        EXPECT_EQ(folder_.files(), 1U) << delay;
    }
    const std::string left = content(path("tour.log"));
    EXPECT_TRUE(left == "precious" || left.size() > 1'000'000) << left.size();
}

TEST_F(Streams, AReproductionThatWasAskedToStopGoesOnLater) {
    const std::string reproduce =
        cli_ + " reproduce --only 10.28 --runs 2 --world tour.laps=1 --threads 1 --out ";
    EXPECT_EQ(stopped_on_the_way(reproduce, "half", "INT").status, 130);
    EXPECT_FALSE(std::filesystem::exists(path("half/reproduction.csv")));
    ASSERT_EQ(shell(reproduce + path("half")).status, 0);
    ASSERT_EQ(shell(reproduce + path("whole")).status, 0);
    EXPECT_EQ(files("half"), files("whole"));
}

TEST_F(Streams, AStudyThatWasAskedToStopGoesOnLater) {
    const std::string study = fmt::format(
        "{} study {} --config {} --vary filter.particles=5,6 --runs 12 --threads 1 --out ", cli_,
        log_, config_);
    const Outcome stopped = stopped_on_the_way(study, "study", "TERM");
    EXPECT_EQ(stopped.status, 143);
    EXPECT_EQ(stopped.output.find("100 %"), std::string::npos) << stopped.output;
    ASSERT_EQ(shell(study + path("study")).status, 0);
    ASSERT_EQ(shell(study + path("whole")).status, 0);
    EXPECT_EQ(files("study"), files("whole"));
    EXPECT_EQ(shell(cli_ + " verify " + path("study")).status, 0);
    folder_.put("study/summary.csv", "other");
    const Outcome broken = shell(cli_ + " verify " + path("study"));
    EXPECT_EQ(broken.status, 1);
    EXPECT_NE(broken.output.find("summary.csv: missing, changed"), std::string::npos);
    ASSERT_EQ(shell(cli_ + " recover " + path("study")).status, 0);
    EXPECT_EQ(files("study"), files("whole"));
}

}  // namespace
}  // namespace hitos
