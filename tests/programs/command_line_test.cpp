// SPDX-License-Identifier: GPL-3.0-or-later
// Manners of the command line: reports for programs, status, standard input, colours.

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "program.hpp"

namespace hitos::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

class CommandLine : public ProgramTest {
  protected:
    /// What a command says on standard output alone.
    Outcome said(const std::string& arguments) const {
        return shell(fmt::format("{} {} 2> {}", cli_, arguments, path("stderr")));
    }
    /// The object that a command says with --json.
    json object(const std::string& arguments, int status = 0) const {
        const Outcome outcome = said(arguments + " --json");
        EXPECT_EQ(outcome.status, status) << outcome.output << content(path("stderr"));
        return json::parse(outcome.output);
    }
    std::string run(const std::string& name, const std::string& more = "") const {
        return fmt::format("run {} --set filter.particles=5 --seed 3 --out {} {}", short_log_,
                           path(name), more);
    }

    const std::string short_log_ = kSource + "/data/logs/radish.log.gz";
};

TEST_F(CommandLine, ARunSaysItsSummaryAsJson) {
    const json whole = object(run("run"));
    json summary = json::parse(content(path("run/summary.json")));
    EXPECT_EQ(whole.at("folder"), path("run"));
    summary.erase("rest_xxh3_128");  // of the file's text
    for (const auto& [name, value] : summary.items()) EXPECT_EQ(whole.at(name), value) << name;
    // A table that could not be written is in it too, and the status says so where it is asked.
    const json missing = object(run("again", "--strict --figures " + path("again") + "/no.csv"), 0);
    EXPECT_TRUE(missing.at("not_written").empty());
}

TEST_F(CommandLine, TheSourceDecidesThePresetWhereNobodyChooses) {
    const std::string few = " --set filter.particles=5 --set filter.algorithm=ekf-slam --out ";
    const auto results = [&](const std::string& source, const std::string& how) {
        fs::remove_all(path("out"));
        EXPECT_EQ(said("run " + source + ' ' + how + few + path("out")).status, 0)
            << content(path("stderr"));
        std::string all;
        for (const char* name : {"config.cfg", "map.txt", "trajectory.tum", "grid_best.png"})
            all += content(path("out") + '/' + name);
        return all;
    };
    const std::string logs = kSource + "/data/logs/";
    for (const auto& [source, chosen] :
         {std::pair(short_log_, std::string("--preset recorded")),
          std::pair(std::string("corridor"), std::string("--preset simulated")),
          std::pair(logs + "player-laser.log.gz", "--config " + kSource + "/config/init.cfg")}) {
        const std::string asked_for = results(source, chosen);
        EXPECT_EQ(results(source, ""), asked_for) << source;
        EXPECT_EQ(results(source, "--preset auto"), asked_for) << source;
    }
    // What is given is not overridden.
    EXPECT_NE(results(short_log_, "--config " + config_), results(short_log_, ""));
}

TEST_F(CommandLine, ResultsDoNotHideTheWorldOfTheirName) {
    const std::string here = fmt::format("cd {} && {} ", path("."), cli_);
    const std::string run = "run lineamedia --set filter.particles=2 --out lineamedia";
    ASSERT_EQ(shell(here + run).status, 0);
    const Outcome again = shell(here + run);
    EXPECT_EQ(again.status, 0) << again.output;
    EXPECT_EQ(shell(here + "simulate lineamedia --out lineamedia.log").status, 0);
    // A folder that is no world's is what is asked for.
    std::filesystem::create_directories(path("nowhere"));
    EXPECT_NE(shell(here + "run nowhere --out x").output.find("without a recording"),
              std::string::npos);
}

TEST_F(CommandLine, WhatTheSourceHasDecidedIsTold) {
    const std::string told = "parameters: preset recorded (a robot recorded it)";
    EXPECT_EQ(said(run("a")).status, 0);
    EXPECT_NE(content(path("stderr")).find(told), std::string::npos) << content(path("stderr"));
    EXPECT_EQ(object(run("b")).at("suited_preset"), "recorded");
    EXPECT_FALSE(object(run("c", "--preset recorded")).contains("suited_preset"));
    EXPECT_EQ(said(run("d", "--config " + config_)).status, 0);
    EXPECT_EQ(content(path("stderr")).find("parameters:"), std::string::npos);
    const Outcome study = said(
        fmt::format("study {} --vary filter.particles=5 --runs 1 --out {}", short_log_, path("s")));
    EXPECT_EQ(study.status, 0) << content(path("stderr"));
    EXPECT_NE(content(path("stderr")).find("parameters: preset recorded"), std::string::npos);
}

TEST_F(CommandLine, EveryReportHasItsJson) {
    ASSERT_EQ(said(run("run")).status, 0);
    EXPECT_EQ(object("info " + short_log_).at("scans"), object(run("b")).at("scans"));
    EXPECT_EQ(object("verify " + path("run")).at("run").at("whole"), true);
    EXPECT_GT(object("evaluate " + path("run")).at("cells_per_point").get<double>(), 0.0);
    const json evaluated =
        object(fmt::format("evaluate --trajectory {0} --reference-trajectory "
                           "{0} --rpe-distance 0.1",
                           path("run/trajectory.tum")));
    EXPECT_LT(evaluated.at("ate_rmse_m").get<double>(), 1e-9);
    EXPECT_GT(evaluated.at("rpe_distance_pairs").get<int>(), 0);
    EXPECT_EQ(object(fmt::format("convert {} --to carmen --out {}", short_log_, path("x.log")))
                  .at("file"),
              path("x.log"));
    EXPECT_EQ(object("simulate bigloop --out " + path("w.log")).at("files").size(), 1U);
    EXPECT_GT(object(fmt::format("relations {} --distance 0.1 --out {}", path("run/trajectory.tum"),
                                 path("r.txt")))
                  .at("relations")
                  .get<int>(),
              0);
    const json parameters = object("parameters filter.particles").at("parameters");
    ASSERT_EQ(parameters.size(), 1U);
    EXPECT_EQ(parameters[0].at("key"), "filter.particles");
    EXPECT_GT(object("presets").at("presets").size(), 3U);
    const json study = object(fmt::format("study {} --vary filter.particles=5,6 --runs 2 --out {}",
                                          short_log_, path("study")));
    ASSERT_EQ(study.at("summary").size(), 2U);
    EXPECT_EQ(study["summary"][1]["values"]["filter.particles"], "6");
    EXPECT_EQ(study["summary"][1]["landmarks"]["measured"], 2);
    EXPECT_EQ(object("verify " + path("study")).at("study").at("runs"), 4);
    EXPECT_EQ(object("recover " + path("study")).at("runs_found"), 4);
}

TEST_F(CommandLine, VerifySaysWhatIsWrongAsJson) {
    ASSERT_EQ(said(run("run")).status, 0);
    std::filesystem::remove(path("run/map.dxf"));
    const json check = object("verify " + path("run"), 1).at("run");
    EXPECT_EQ(check.at("whole"), false);
    EXPECT_EQ(check.at("missing"), json::array({"map.dxf"}));
}

TEST_F(CommandLine, InfoSaysWhatALogHolds) {
    const json info = object("info " + log_);
    EXPECT_EQ(info.at("format"), "player");
    EXPECT_EQ(info.at("scans"), 1050);
    EXPECT_EQ(info.at("log").at("duplicate_scans"), 291);
    EXPECT_FALSE(info.at("first_lines").empty());
    const Outcome words = said("info " + short_log_);
    EXPECT_NE(words.output.find(": radish\n"), std::string::npos) << words.output;
    EXPECT_NE(words.output.find("laser: 181 rays"), std::string::npos) << words.output;
    // A world is driven.
    EXPECT_EQ(object("info bigloop").at("format"), "world");
    // What is no log is told as everywhere.
    EXPECT_EQ(said("info " + file("no.log", "hello\nworld\n")).status, 1);
}

TEST_F(CommandLine, InfoListsTheTopicsToChooseFrom) {
    const std::string bag = test::kSource + "/tests/unit/capture/two-lasers-cut.bag";
    const Outcome words = said("info " + bag);
    EXPECT_EQ(words.status, 0) << words.output;
    EXPECT_NE(words.output.find("found 2 laser topics"), std::string::npos) << words.output;
    EXPECT_NE(words.output.find("\n  /scan_rear  sensor_msgs/LaserScan  9\n"), std::string::npos)
        << words.output;
    const json choice = object("info " + bag);
    EXPECT_EQ(choice.at("format"), "rosbag");
    EXPECT_NE(choice.at("choice").get<std::string>().find("--scan-topic"), std::string::npos);
    const json& topics = choice.at("topics");
    EXPECT_EQ(std::ranges::count(topics, "sensor_msgs/LaserScan",
                                 [](const json& topic) { return topic.at("type"); }),
              2);
    // A name that it does not have is refused.
    EXPECT_EQ(said("info " + bag + " --scan-topic /none").status, 1);
    const json info = object("info " + bag + " --scan-topic all");
    EXPECT_EQ(info.at("scans"), 11);
    EXPECT_EQ(info.at("topics"), topics);
    EXPECT_FALSE(info.contains("choice"));
}

TEST_F(CommandLine, ScansBeforeTheOdometryAreToldAndLeftOut) {
    const std::string bag = test::kSource + "/tests/unit/capture/two-lasers-cut.bag";
    const std::string read = bag + " --scan-topic all";
    const json kept = object("info " + read).at("log");
    const int early = kept.at("early_scans");
    EXPECT_GT(early, 0);
    EXPECT_EQ(kept.at("early_scans_left_out"), 0);
    EXPECT_NE(
        said("info " + read)
            .output.find(
                "used as if the robot had stood still until then; source.early_scans=leave_out"),
        std::string::npos);
    const std::string without = read + " --set source.early_scans=leave_out";
    const json left = object("info " + without);
    EXPECT_EQ(left.at("scans"), 11 - early);
    EXPECT_EQ(left.at("log").at("early_scans"), 0);
    EXPECT_EQ(left.at("log").at("early_scans_left_out"), early);
    const Outcome ran = said("run " + without + " --out " + path("late"));
    ASSERT_EQ(ran.status, 0) << ran.output;
    EXPECT_NE(ran.output.find("left out, as source.early_scans says"), std::string::npos)
        << ran.output;
    const json summary = json::parse(content(path("late/summary.json")));
    EXPECT_EQ(summary.at("log").at("early_scans_left_out"), early);
    EXPECT_EQ(summary.at("scans"), 11 - early);
}

TEST_F(CommandLine, DamageOfARecordingIsNoLine) {
    const std::string whole = content(test::kSource + "/tests/unit/capture/two-lasers-cut.bag");
    const std::string cut = file("cut.bag", whole.substr(0, whole.size() / 2));
    const Outcome words = said("info " + cut + " --scan-topic all");
    EXPECT_EQ(words.status, 0) << words.output;
    EXPECT_NE(words.output.find(" damaged message"), std::string::npos) << words.output;
    EXPECT_NE(words.output.find("skipped; message "), std::string::npos) << words.output;
    EXPECT_EQ(words.output.find(" line"), std::string::npos) << words.output;
}

TEST_F(CommandLine, RunsAreSetSideBySide) {
    ASSERT_EQ(said(run("five")).status, 0);
    ASSERT_EQ(said(run("seven", "--set filter.particles=7")).status, 0);
    const std::string both = path("five") + " " + path("seven");
    const Outcome table = said("compare " + both);
    EXPECT_EQ(table.output.find("| run | five | seven |"), 0U) << table.output;
    EXPECT_NE(table.output.find("\n| filter.particles | 5 | 7 |\n"), std::string::npos)
        << table.output;
    const Outcome latex = said("compare " + both + " --as latex");
    EXPECT_EQ(latex.output.find("\\begin{tabular}{rrr}"), 0U) << latex.output;
    EXPECT_NE(latex.output.find("filter.particles"), std::string::npos);
    ASSERT_EQ(said("compare " + both + " --as csv --out " + path("t.csv")).status, 0);
    EXPECT_EQ(content(path("t.csv")).find("run,filter.particles,scans,"), 0U);
    const json runs = object("compare " + both).at("runs");
    ASSERT_EQ(runs.size(), 2U);
    EXPECT_EQ(runs[0].at("settings"), (json{{"filter.particles", "5"}}));
    const json summary = json::parse(content(path("seven/summary.json")));
    EXPECT_EQ(runs[1].at("figures").at("cells_per_point"),
              summary.at("quality").at("cells_per_point"));
    // Folders of one name are told apart, and so are logs.
    std::filesystem::create_directory(path("other"));
    ASSERT_EQ(said("run bigloop --set filter.particles=5 --world-set tour.laps=1 --out " +
                   path("other/five"))
                  .status,
              0);
    const Outcome logs = said(fmt::format("compare {} {}", path("five"), path("other/five")));
    EXPECT_NE(logs.output.find("\n| log | radish.log.gz | bigloop.toml |\n"), std::string::npos)
        << logs.output;
    EXPECT_NE(logs.output.find(" | " + path("other/five") + " |"), std::string::npos);
    EXPECT_NE(logs.output.find("ATE (m)"), std::string::npos);  // of the world alone
    EXPECT_EQ(said("compare " + path("five") + " " + path("none")).status, 1);
}

TEST_F(CommandLine, StandardInputIsReadAsAFileIs) {
    const std::string unpacked = fmt::format("zcat {} | {} ", short_log_, cli_);
    ASSERT_EQ(said(run("file")).status, 0);
    ASSERT_EQ(shell(fmt::format("{}run - --set filter.particles=5 --seed 3 --out {} 2>&1", unpacked,
                                path("pipe")))
                  .status,
              0);
    for (const char* name : {"map.txt", "trajectory.tum", "grid_best.png", "odometry.tum"}) {
        EXPECT_EQ(content(path("pipe/") + name), content(path("file/") + name)) << name;
    }
    EXPECT_EQ(json::parse(content(path("pipe/summary.json"))).at("source"), "/dev/stdin");
    // Packed, and from a file.
    EXPECT_EQ(shell(fmt::format("{} convert - --to carmen --out {} < {} 2>&1", cli_, path("a.log"),
                                short_log_))
                  .status,
              0);
    ASSERT_EQ(
        said(fmt::format("convert {} --to carmen --out {}", short_log_, path("b.log"))).status, 0);
    EXPECT_EQ(content(path("a.log")), content(path("b.log")));
    // A run whose log came that way is measured against it the same way.
    EXPECT_EQ(shell(unpacked + "evaluate " + path("pipe")).output,
              said("evaluate " + path("file")).output);
    // Configurations and trajectories too.
    EXPECT_EQ(shell(fmt::format("cat {0}/file/config.cfg | {1} run {2} --config - --out {0}/c "
                                "2>&1 && cmp {0}/c/map.txt {0}/file/map.txt",
                                folder_.path().string(), cli_, short_log_))
                  .status,
              0);
    EXPECT_EQ(shell(fmt::format("cat {0} | {1} evaluate --trajectory - --reference-trajectory {0} "
                                "| grep 'ate_rmse_m 0.0000'",
                                path("file/trajectory.tum"), cli_))
                  .status,
              0);
}

TEST_F(CommandLine, StandardInputWithoutALogIsTold) {
    const Outcome empty = shell(cli_ + " run - --out " + path("out") + " < /dev/null");
    EXPECT_EQ(empty.status, 1);
    EXPECT_NE(empty.output.find("/dev/stdin"), std::string::npos) << empty.output;
    const Outcome study = shell("zcat " + short_log_ + " | " + cli_ +
                                " study - --vary filter.particles=5,6 --out " + path("out"));
    EXPECT_EQ(study.status, 1);
    EXPECT_NE(study.output.find("give a file"), std::string::npos) << study.output;
    // No room to keep it, and no such folder.
    const Outcome folder =
        shell(fmt::format("zcat {} | TMPDIR={} {} info -", short_log_, path("none"), cli_));
    EXPECT_EQ(folder.status, 1);
    EXPECT_NE(folder.output.find("TMPDIR"), std::string::npos) << folder.output;
    EXPECT_FALSE(std::filesystem::exists(path("out/summary.json")));
}

TEST_F(CommandLine, AWrongCommandLineHasAStatusOfItsOwn) {
    EXPECT_EQ(shell(cli_).status, 64);
    EXPECT_EQ(shell(cli_ + " run").status, 64);
    EXPECT_EQ(shell(cli_ + " presets --no-such-option").status, 64);
    EXPECT_EQ(shell(cli_ + " compare a --as word").status, 64);
    EXPECT_EQ(shell(batch_ + " a b").status, 64);
    EXPECT_EQ(shell(cli_ + " run --help").status, 0);
    EXPECT_EQ(shell(cli_ + " --version").status, 0);
    EXPECT_EQ(shell(cli_ + " info " + path("none.log")).status, 1);
}

TEST_F(CommandLine, OptionsThatTheSourceDoesNotHeedAreRefused) {
    const auto expect = [&](const std::string& command, const std::string& words) {
        const Outcome refused = shell(cli_ + " " + command);
        EXPECT_EQ(refused.status, 1) << command;
        EXPECT_THAT(refused.output, HasSubstr("hitos-cli: " + words)) << command;
        EXPECT_FALSE(std::filesystem::exists(path("out"))) << command;
    };
    const std::string out = " --out " + path("out");
    const std::string no_recording = ": is of ROS recordings, and ";
    const std::string no_world = ": is of worlds, which are simulated, and " + short_log_;
    for (const std::string command : {"run ", "info ", "check "}) {
        const std::string end = command == "run " ? out : "";
        for (const std::string option : {"--scan-topic", "--odom-topic", "--same-frames"}) {
            const std::string given = fmt::format("{} {} x=y", end, option);
            expect(fmt::format("{}{}{}", command, short_log_, given),
                   fmt::format("{}{}{}", option, no_recording, short_log_));
            expect(fmt::format("{}corridor{}", command, given), option + no_recording);
        }
        const std::string of_log = fmt::format("{}{}{}", command, short_log_, end);
        expect(of_log + " --world-set laser.sigma=0", "--world-set" + no_world);
        expect(of_log + " --tour-seed 3", "--tour-seed" + no_world);
    }
    expect("convert " + short_log_ + " --to carmen --scan-topic x" + out,
           "--scan-topic" + no_recording);
    expect("study " + short_log_ + " --vary p=3 --tour-seed 3" + out, "--tour-seed" + no_world);
    expect("run " + short_log_ + " --tolerance 1" + out,
           "--tolerance: is of the stamps of a reference trajectory, and there is none");
    // A log that is not there is told as that.
    expect("run nosuch.log --tour-seed 3" + out, "nosuch.log: there is no such file");
    // What a configuration says beside is for whatever source there is.
    folder_.put("c.cfg", "[source]\nscan_topic = \"/x\"\ntour_seed = 3\n[filter]\nparticles = 2\n");
    EXPECT_EQ(shell(cli_ + " run " + short_log_ + " --config " + path("c.cfg") + out).status, 0);
    EXPECT_EQ(shell(cli_ + " run corridor --tolerance 1 --tour-seed 3 --set filter.particles=2" +
                    " --world-set laser.rate=2 --out " + path("world"))
                  .status,
              0);
    EXPECT_EQ(shell(cli_ + " study " + short_log_ + " --vary source.file=" + short_log_ + "," +
                    kSource + "/data/worlds/corridor.toml --tour-seed 3 --runs 1 --set " +
                    "filter.particles=2 --out " + path("study"))
                  .status,
              0);
}

TEST_F(CommandLine, ASeedBelowZeroIsNoGreatOne) {
    for (const char* command : {"run", "convert", "study", "simulate"}) {
        const Outcome outcome =
            shell(cli_ + " " + command + " " + log_ + " --seed -1 --out " + path("x"));
        EXPECT_NE(outcome.status, 0) << command;
        EXPECT_FALSE(std::filesystem::exists(path("x"))) << command;
    }
    EXPECT_THAT(shell(cli_ + " convert " + log_ + " --seed -1 --out " + path("x")).output,
                HasSubstr("found -1, expected a whole number from 0 on"));
}

TEST_F(CommandLine, ColoursAreForTerminalsAlone) {
    // A recording without registration brings a note.
    const std::string command = cli_ + " " + run("run", "--preset recorded-fastslam1");
    EXPECT_EQ(shell(command).output.find('\033'), std::string::npos);
    if (shell("command -v script").status != 0) GTEST_SKIP() << "without script(1) no terminal";
    const auto on_terminal = [&](const std::string& variables) {
        return shell(fmt::format("script -qec '{} {} 2> /dev/null' /dev/null", variables, command))
            .output;
    };
    const std::string words = on_terminal("TERM=xterm NO_COLOR=");
    ASSERT_TRUE(words.find("note:") != std::string::npos ||
                words.find("warning:") != std::string::npos)
        << words;
    EXPECT_NE(words.find('\033'), std::string::npos) << words;
    EXPECT_EQ(on_terminal("TERM=xterm NO_COLOR=1").find('\033'), std::string::npos);
    EXPECT_EQ(on_terminal("TERM=dumb NO_COLOR=").find('\033'), std::string::npos);
}

TEST_F(CommandLine, ANameStaysOnItsLineAndSteersNoTerminal) {
    const std::string name = "a\nwarning: b\x1b[31m\t.log";
    folder_.put(name, content(log_));
    folder_.put("no\nlog", "nothing of a log\n");
    const std::string known = "'" + path(name) + "'";
    for (const std::string& command :
         {"info " + known, "check " + known, "run " + known + " --out '" + path("r\ns") + "'",
          "convert " + known + " --to carmen --out '" + path("c\nd") + "'",
          "info '" + path("no\nlog") + "'"}) {
        const Outcome said = shell(cli_ + " " + command);
        EXPECT_NE(said.output.find("\\x0a"), std::string::npos) << said.output;
        EXPECT_EQ(said.output.find("\nwarning: b"), std::string::npos) << said.output;
        EXPECT_EQ(said.output.find_first_of("\x1b\t"), std::string::npos) << said.output;
    }
}

TEST_F(CommandLine, SlipsOfThePenAreToldWithWhatWasMeant) {
    for (const auto& [line, words] : std::vector<std::pair<std::string, std::string>>{
             {"rnu x", "rnu: hitos-cli has no such command; did you mean run?"},
             {"frobnicate", "frobnicate: hitos-cli has no such command\n"},
             {"run corridor --prest recorded --out x",
              "--prest: hitos-cli run has no such option; did you mean --preset?"},
             {"run corridor --otu=x",
              "--otu: hitos-cli run has no such option; did you mean --out?"},
             {"study merge x --jsno",
              "--jsno: hitos-cli study merge has no such option; did you mean --json?"},
             {"info x --frobnicate", "--frobnicate: hitos-cli info has no such option\n"},
             {"--versoin", "--versoin: hitos-cli has no such option; did you mean --version?"}}) {
        const Outcome outcome = shell(cli_ + " " + line);
        EXPECT_EQ(outcome.status, 64) << line;
        EXPECT_THAT(outcome.output, ::testing::StartsWith(words)) << line;
        EXPECT_THAT(outcome.output, ::testing::EndsWith("Run with --help for more information.\n"));
        EXPECT_EQ(outcome.output.find("describe"), std::string::npos);  // the help hides it
    }
    // Where nothing is misspelt, what is missing is told.
    EXPECT_THAT(shell(cli_ + " run corridor").output, ::testing::StartsWith("--out is required"));
    EXPECT_THAT(shell(cli_).output, ::testing::StartsWith("A subcommand is required"));
    EXPECT_THAT(
        shell(batch_ + " a b c p -3 --rnus 4").output,
        ::testing::StartsWith("--rnus: BatchSLAM has no such option; did you mean --runs?"));
}

TEST_F(CommandLine, StandardInputIsOneThingOnly) {
    ASSERT_EQ(said(run("run")).status, 0);
    const std::string map = path("run/map.txt");
    for (const auto& [line, words] : std::vector<std::pair<std::string, std::string>>{
             {"run - --reference - --out " + path("x"),
              "--reference: found \"-\", but standard input is log already; give one of the two as "
              "a file"},
             {"run - --config /dev/stdin --out " + path("x"),
              "--config: found \"/dev/stdin\", but standard input is log already"},
             {"evaluate --map - --reference - ",
              "--reference: found \"-\", but standard input is --map already"},
             {"study corridor --vary p=3 --reference - --reference-trajectory - --out " + path("x"),
              "--reference-trajectory: found \"-\", but standard input is --reference already"}}) {
        for (const std::string& input : {fmt::format("{} {} < {}", cli_, line, map),
                                         fmt::format("cat {} | {} {}", map, cli_, line)}) {
            const Outcome outcome = shell(input);
            EXPECT_EQ(outcome.status, 1) << input;
            EXPECT_THAT(outcome.output, ::testing::HasSubstr(words)) << input;
        }
    }
    EXPECT_FALSE(fs::exists(path("x")));
    // A study reads its maps from there too.
    EXPECT_EQ(shell(fmt::format("{} study corridor --vary p=3 --runs 1 --reference - --out {} < {}",
                                cli_, path("y"), map))
                  .status,
              0);
}

TEST_F(CommandLine, ADashIsNoNameToWriteTo) {
    ASSERT_EQ(said(run("run")).status, 0);
    const std::string there = "cd " + path("") + " && ";
    for (const std::string& line : std::vector<std::string>{
             "run " + short_log_ + " --out -", "run " + short_log_ + " --out x --figures -",
             "convert " + short_log_ + " --to carmen --out -", "simulate corridor --out -",
             "simulate corridor --truth -", "simulate corridor --picture -",
             "simulate corridor --reference -", "study corridor --vary p=3 --out -",
             "study merge -", "relations run/trajectory.tum --out -", "reproduce --out -",
             "graph g --out -", "reproduce --report -",
             "evaluate --map run/map.txt --distances x --out -"}) {
        const Outcome outcome = shell(fmt::format("{}{} {}", there, cli_, line));
        EXPECT_EQ(outcome.status, 64) << line;
        EXPECT_THAT(outcome.output,
                    ::testing::HasSubstr("found \"-\", but this does not go to standard output"))
            << line;
    }
    EXPECT_EQ(shell(there + batch_ + " c - m p 1").status, 64);
    EXPECT_FALSE(fs::exists(path("-")));
    // Where one text comes of it, it does go there.
    EXPECT_EQ(said("compare " + path("run") + " --out -").output,
              said("compare " + path("run")).output);
    const std::string written = said("parameters --write -").output;
    ASSERT_EQ(said("parameters --write " + path("all.cfg")).status, 0);
    EXPECT_EQ(written, content(path("all.cfg")));
    EXPECT_FALSE(fs::exists("-"));
}

TEST_F(CommandLine, InfoAndRunCountTheSameOdometry) {
    // Readings follow the last scan here, one of them damaged.
    const std::string last = shell("zcat " + kSource +
                                   "/data/logs/carmen-flaser.log.gz | grep ^ODOM | tail -1 | awk "
                                   "'{$8 += 1; $10 += 1; print}'")
                                 .output;
    const std::string carmen =
        file("carmen.log", shell("zcat " + kSource + "/data/logs/carmen-flaser.log.gz").output +
                               last + "ODOM 1 2 nonsense\n");
    const json info = object("info " + carmen);
    const json run =
        object(fmt::format("run {} --set filter.particles=5 --out {}", carmen, path("run")));
    EXPECT_EQ(info.at("log"), run.at("log"));
    EXPECT_GT(info.at("log").at("odometry_readings"), 99);
}

}  // namespace
}  // namespace hitos::test
