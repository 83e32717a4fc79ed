// SPDX-License-Identifier: GPL-3.0-or-later
// hitos-cli study as a user starts, stops and restarts it.
#include <gmock/gmock.h>
#include <spawn.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <thread>
#include <vector>

#include "program.hpp"

namespace hitos {
namespace {

using test::content;
using test::Outcome;
using test::shell;
using test::fs::exists;
using ::testing::HasSubstr;
using ::testing::Not;

class StudyCommand : public test::ProgramTest {
  protected:
    std::string study(const std::string& more) const {
        return cli_ + " study " + log_ + " --reference " + map_ + " --config " + config_ +
               " --odometry-noise 0.1 --set filter.particles=5 " + more;
    }
};

TEST_F(StudyCommand, IsWhatConvertAndRunGive) {
    // What is converted is the poses.
    ASSERT_EQ(shell(study("--set source.odometry=poses --vary dmax=0.02 --seed 3 --runs 1 --out " +
                          path("study")))
                  .status,
              0);
    ASSERT_EQ(shell(cli_ + " convert " + log_ + " --to normalized --odometry-noise 0.1 --seed 3 " +
                    "--out " + path("noisy.log"))
                  .status,
              0);
    ASSERT_EQ(shell(cli_ + " run " + path("noisy.log") + " --config " + config_ +
                    " --set filter.particles=5 --seed 3 --out " + path("run"))
                  .status,
              0);
    const std::string map = content(path("study/maps/dmax-0.02-s3.map"));
    EXPECT_FALSE(map.empty());
    EXPECT_EQ(map, content(path("run/map.txt")));
    const Outcome measured =
        shell(cli_ + " evaluate --map " + path("run/map.txt") + " --reference " + map_);
    std::istringstream row(content(path("study/summary.csv")));
    std::string head;
    std::getline(row, head);
    EXPECT_EQ(head.substr(0, 53), "split_merge.dmax,runs,failed,measured,error_m,error_v");
    std::string line;
    std::getline(row, line);
    EXPECT_EQ(line.substr(0, 11), "0.02,1,0,1,");
    std::array<char, 32> figure{};
    std::snprintf(figure.data(), figure.size(), "map_error_m %.6f",
                  std::strtod(line.c_str() + 11, nullptr));
    EXPECT_THAT(measured.output, HasSubstr(figure.data()));
}

TEST_F(StudyCommand, ReachesTheThesisOnBigloop) {
    // [T table 10.2 and figures 10.16, 10.17]: 0.09 m and 16 landmarks at Dmax 0.02.
    const Outcome result =
        shell(cli_ + " study " + log_ + " --reference " + map_ + " --config " + config_ +
              " --odometry-noise 0.1 --vary dmax=0.02 --runs 5 --csv --out " + path("out") +
              " 2>/dev/null");
    ASSERT_EQ(result.status, 0);
    std::istringstream rows(result.output);
    std::string head;
    std::string row;
    std::getline(rows, head);
    std::getline(rows, row);
    std::vector<std::string> fields;
    std::istringstream cut(row);
    for (std::string field; std::getline(cut, field, ',');) fields.push_back(field);
    ASSERT_GE(fields.size(), 17U) << row;
    EXPECT_EQ(fields[1], "5");
    EXPECT_LE(std::strtod(fields[4].c_str(), nullptr), 0.20);
    EXPECT_NEAR(std::strtod(fields[10].c_str(), nullptr), 16.0, 1.0);
    EXPECT_EQ(fields[16], "16");
}

TEST_F(StudyCommand, KilledHalfwayItGoesOnToTheSameBytes) {
    const std::string what = "--vary dmax=0.01:0.05:0.01 --vary p=5,6 --runs 2 --out ";
    ASSERT_EQ(shell(study(what + path("whole"))).status, 0);

    const std::string line = "exec " + study(what + path("killed")) + " --threads 2 2>/dev/null";
    std::vector<std::string> words{"sh", "-c", line};
    std::vector<char*> arguments{words[0].data(), words[1].data(), words[2].data(), nullptr};
    pid_t process = 0;
    ASSERT_EQ(::posix_spawn(&process, "/bin/sh", nullptr, nullptr, arguments.data(), environ), 0);
    const auto records = [&] {
        std::size_t count = 0;
        std::error_code none_yet;
        for (test::fs::directory_iterator entry(path("killed/runs"), none_yet), end;
             !none_yet && entry != end; entry.increment(none_yet)) {
            if (entry->path().extension() == ".json") ++count;
        }
        return count;
    };
    // However long it takes, unless it ends by itself.
    siginfo_t ended{};
    while (records() < 5 && ended.si_pid == 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        ::waitid(P_PID, static_cast<id_t>(process), &ended, WEXITED | WNOHANG | WNOWAIT);
    }
    ::kill(process, SIGKILL);
    int status = 0;
    ASSERT_EQ(::waitpid(process, &status, 0), process);
    ASSERT_TRUE(WIFSIGNALED(status)) << "it ended before it could be killed";
    const std::size_t done = records();
    EXPECT_GE(done, 5U);
    EXPECT_LT(done, 20U);
    EXPECT_FALSE(exists(path("killed/quality.csv")));

    const Outcome again = shell(study(what + path("killed")));
    EXPECT_EQ(again.status, 0);
    EXPECT_THAT(again.output, HasSubstr(std::to_string(20 - done) + " runs to do, " +
                                        std::to_string(done) + " found done"));
    EXPECT_EQ(files("killed"), files("whole"));
    EXPECT_THAT(shell(study(what + path("killed"))).output, Not(HasSubstr("runs to do")));
}

TEST_F(StudyCommand, ArraysGiveShardsAndMergeGivesTheWhole) {
    const std::string what = "--vary sensor=0.04/0.00122,0.01/0.0006 --runs 2 --out ";
    ASSERT_EQ(shell(study(what + path("one"))).status, 0);
    for (const char* id : {"0", "1", "2"}) {
        const Outcome task =
            shell("SLURM_ARRAY_TASK_ID=" + std::string(id) +
                  " SLURM_ARRAY_TASK_MIN=0 SLURM_ARRAY_TASK_MAX=2 SLURM_ARRAY_TASK_COUNT=3 " +
                  study(what + path(std::string("shard") + id)));
        EXPECT_EQ(task.status, 0);
        EXPECT_THAT(task.output, HasSubstr("of 3: "));
    }
    const std::string merge = cli_ + " study merge " + path("all") + " ";
    const Outcome early = shell(merge + path("shard0") + " " + path("shard2"));
    EXPECT_EQ(early.status, 1);
    EXPECT_THAT(early.output, HasSubstr("1 of 4 runs are not there: sensor=0.04/0.00122 seed 2"));
    std::string record;
    for (const auto& entry : test::fs::directory_iterator(path("shard1/runs")))
        record = entry.path().string();
    const std::string text = content(record);
    folder_.put(test::fs::path(record).lexically_relative(path("")).string(), text.substr(1));
    const Outcome damaged =
        shell(merge + path("shard0") + " " + path("shard1") + " " + path("shard2"));
    EXPECT_EQ(damaged.status, 1);
    EXPECT_THAT(damaged.output, HasSubstr(record + ": is damaged, was changed"));
    folder_.put(test::fs::path(record).lexically_relative(path("")).string(), text);
    const Outcome merged =
        shell(merge + path("shard0") + " " + path("shard1") + " " + path("shard2"));
    EXPECT_EQ(merged.status, 0) << merged.output;
    EXPECT_EQ(files("all"), files("one"));
    EXPECT_EQ(shell("SLURM_ARRAY_TASK_ID=1 " + study(what + path("x"))).status, 1);
}

TEST_F(StudyCommand, WithoutGnuplotAllElseIsThere) {
    const std::string what = "--vary dmax=0.02,0.03 --runs 1 --out ";
    const Outcome result = shell("PATH= " + study(what + path("without")));
    EXPECT_EQ(result.status, 0);
    EXPECT_THAT(result.output,
                HasSubstr("no plots: gnuplot is not installed (Debian: gnuplot-nox)"));
    EXPECT_THAT(result.output, HasSubstr("| dmax (m) | runs |"));
    EXPECT_FALSE(exists(path("without/error.png")));
    for (const char* name : {"quality.csv", "summary.csv", "summary.md", "summary.tex",
                             "timing.csv", "error.gp", "error.dat", "landmarks.gp"}) {
        EXPECT_TRUE(exists(path(std::string("without/") + name))) << name;
    }
}

TEST_F(StudyCommand, AWorldIsStudiedByItsTrueWayAndItsGridMaps) {
    const std::string world = file("room.toml",
                                   "walls = [[[-1, -1], [4, -1], [4, 3], [-1, 3], [-1, -1]]]\n"
                                   "[tour]\nstart = [0, 0, 0]\nway_points = [[3, 0], [3, 2]]\n");
    const std::string command = cli_ + " study " + world + " --config " + config_ +
                                " --odometry-noise 0.2 --vary p=5,20 --runs 2 --pictures --out ";
    const Outcome result = shell(command + path("one") + " --threads 1");
    EXPECT_EQ(result.status, 0) << result.output;
    EXPECT_THAT(result.output,
                HasSubstr("| p | runs | ATE (m) | odometry's ATE (m) | blur (m²) |"));
    EXPECT_THAT(result.output, HasSubstr("Without a reference map. ATE: error of the path."));
    EXPECT_THAT(result.output, HasSubstr("grid maps: " + path("one/contact-sheet.png")));
    EXPECT_TRUE(exists(path("one/pictures/p-20-s1.png")));
    EXPECT_FALSE(exists(path("one/pictures/p-20-s2.png")));
    EXPECT_FALSE(exists(path("one/error.dat")));
    EXPECT_TRUE(exists(path("one/trajectory-error.dat")));
    EXPECT_EQ(shell(command + path("two") + " --threads 2").status, 0);
    EXPECT_EQ(files("two"), files("one"));
    const Outcome log = shell(cli_ + " study " + log_ + " --config " + config_ +
                              " --set filter.particles=5 --runs 1 --out " + path("log"));
    EXPECT_THAT(log.output, HasSubstr("| runs | blur (m²) |")) << "a log does not know its way";
}

TEST_F(StudyCommand, SomeFailuresGiveStatusTwoAndOnlyFailuresOne) {
    const std::string gone = path("gone.log");
    const Outcome some =
        shell(study("--vary source.file=" + log_ + "," + gone + " --runs 1 --out " + path("some")));
    EXPECT_EQ(some.status, 2);
    EXPECT_THAT(some.output, HasSubstr("run failed: source.file=" + gone + " seed 1: " + gone +
                                       ": there is no"));
    EXPECT_THAT(some.output, HasSubstr("1 of 2 runs failed; the quality file says why"));
    const Outcome all =
        shell(study("--vary source.file=" + gone + " --runs 2 --out " + path("all")));
    EXPECT_EQ(all.status, 1);
    EXPECT_THAT(all.output, HasSubstr("every run failed; the first: " + gone));
}

TEST_F(StudyCommand, ValuesThatNoRunCanHaveAreRefusedBeforeAnyRuns) {
    for (const auto& [values, words] :
         {std::pair("p=5,0", "filter.particles: 0 is out of range"),
          std::pair("dmax=0.02 --vary p=5,0.5", "filter.particles: \"0.5\""),
          // Which depends on another one.
          std::pair("filter.algorithm=ekf-slam --set association.new_probability=0.5",
                    "association.new_probability: 0.5 is less than")}) {
        const Outcome refused = shell(study("--runs 1 --out " + path("out") + " --vary " + values));
        EXPECT_EQ(refused.status, 1) << values;
        EXPECT_THAT(refused.output, HasSubstr(std::string("hitos-cli: ") + words));
        EXPECT_THAT(refused.output, Not(HasSubstr("run failed")));
        EXPECT_FALSE(exists(path("out"))) << values;
    }
}

TEST_F(StudyCommand, BadInputEndsWithOneClearError) {
    const auto expect = [&](const std::string& line, const std::string& message) {
        const Outcome result = shell(line);
        EXPECT_EQ(result.status, 1) << line;
        EXPECT_THAT(result.output, HasSubstr("hitos-cli: " + message)) << line;
    };
    const std::string start = cli_ + " study ";
    const std::string reference = " --reference " + map_;
    const std::string out = " --out " + path("out");
    expect(study("--vary p=5 --pictures=some --out " + path("out")),
           "--pictures: found \"some\", expected one of none, first, all");
    expect(study("--vary p=5 --reference-trajectory " + path("no.tum") + " --out " + path("out")),
           path("no.tum") + ": ");
    expect(start + log_ + reference, "study: --out is missing");
    expect(start + reference + out, "study: LOG is missing");
    expect(start + path("no.log") + reference + out, path("no.log") + ": there is no such file");
    expect(start + log_ + " --reference " + path("no.map") + out, path("no.map"));
    expect(start + log_ + " --reference " + file("bad.map", "rho: 1\n") + out,
           path("bad.map") + ":1: ");
    expect(study("--vary nothing=1 --out " + path("out")), "nothing: no such parameter");
    expect(study("--vary sensor=1 --out " + path("out")), "sensor: found \"1\" of 1 components");
    expect(study("--vary p=1:2:0 --out " + path("out")), "1:2:0: the step does not lead");
    expect(study("--vary p=5 --shard 3/2 --out " + path("out")), "--shard: found \"3/2\"");
    expect(study("--vary p=5 --runs 0 --out " + path("out")), "runs: found 0");
    expect(start + log_ + reference + out + " --odometry-noise -1", "odometry noise: found -1");
    expect(study("--odometry-noise-kind pink --out " + path("out")), "--odometry-noise-kind");
    expect(study("--vary p=5 --out " + file("taken", "x")), path("taken") + ": cannot make");
    expect(start + "merge " + path("nothing"), path("nothing/study.json") + ": no such file");
    EXPECT_FALSE(exists(path("out")));
}

TEST_F(StudyCommand, HelpNamesEveryOption) {
    const Outcome help = shell(cli_ + " study --help");
    EXPECT_EQ(help.status, 0);
    for (const char* option :
         {"--reference", "--reference-trajectory", "--pictures", "--vary", "--runs", "--out",
          "--config", "--set", "--odometry-noise", "--odometry-noise-kind", "--shard", "--threads",
          "--seed", "--csv", "merge"}) {
        EXPECT_THAT(help.output, HasSubstr(option));
    }
    EXPECT_EQ(shell(cli_ + " study merge --help").status, 0);
}

}  // namespace
}  // namespace hitos
