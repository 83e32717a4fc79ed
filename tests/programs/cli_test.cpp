// SPDX-License-Identifier: GPL-3.0-or-later
// The command line as a user meets it.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/services/configuration/configuracion.hpp"
#include "hitos/services/files/map_file.hpp"
#include "hitos/services/files/trajectory_file.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using test::content;
using test::Outcome;
using test::run_command;
using test::TempFolder;

const std::string kCli = std::string(HITOS_BIN_DIR) + "/hitos-cli";
const std::string kSource = HITOS_SOURCE_DIR;
const std::string kLog = kSource + "/data/bigloop.log.gz";

Outcome cli(const std::string& arguments) {
    return run_command(kCli + " " + arguments);
}

std::string quick() {
    return " --config " + kSource + "/config/thesis.cfg --set filter.particles=10 ";
}

/// An error is one line that names its cause; the program must not have crashed.
void expect_error(const Outcome& outcome, const std::vector<std::string>& words) {
    EXPECT_GT(outcome.status, 0) << outcome.output;
    EXPECT_LT(outcome.status, 128) << "crashed: " << outcome.output;
    for (const std::string& word : words) {
        EXPECT_NE(outcome.output.find(word), std::string::npos)
            << "expected \"" << word << "\" in:\n"
            << outcome.output;
    }
}

TEST(Cli, RunLeavesEverythingItPromises) {
    const TempFolder folder;
    const Outcome outcome = cli("run " + kLog + quick() + "--reference " + kSource +
                                "/data/maps/bigloop.map --seed 4 --out " + folder.path().string());
    ASSERT_EQ(outcome.status, 0) << outcome.output;
    for (const char* name :
         {"map.txt", "segments.txt", "map.dxf", "trajectory.tum", "trajectory_online.tum",
          "odometry.tum", "grid_best_steps.png", "grid_best_steps.jpg", "grid_best.png",
          "grid_best.jpg", "grid_odometry.png", "grid_odometry.jpg", "config.cfg",
          "summary.json"}) {
        EXPECT_GT(std::filesystem::file_size(folder / name), 0U) << name;
    }
    EXPECT_EQ(folder.files(), 14U);  // nothing else, nothing half-written
    const auto summary = nlohmann::json::parse(content(folder / "summary.json"));
    EXPECT_EQ(summary["scans"], 1050);
    EXPECT_EQ(summary["seed"], 4);
    EXPECT_EQ(summary["algorithm"], "fastslam");
    EXPECT_EQ(summary["particles"], 10);
    EXPECT_EQ(summary["log"]["duplicate_scans"], 291);
    EXPECT_LT(summary["map_error"]["mean_m"].get<double>(), 0.3);
    EXPECT_EQ(read_map(folder / "map.txt").size(),
              summary["landmarks"]["lines"].get<std::size_t>() +
                  summary["landmarks"]["corners"].get<std::size_t>());
    EXPECT_EQ(read_trajectory(folder / "trajectory.tum").size(), 1050U);
}

TEST(Cli, TheSavedConfigurationRepeatsTheRunForAnyNumberOfThreads) {
    const TempFolder folder;
    const std::string tour = kSource + "/data/worlds/corridor.toml";
    const std::string first = (folder / "first").string();
    const Outcome alone = cli("run " + tour + quick() +
                              "--set filter.particles=600 --world-set laser.rate=2 --seed 7 "
                              "--threads 1 --out " +
                              first);
    ASSERT_EQ(alone.status, 0) << alone.output;
    for (const int threads : {2, 7}) {
        const std::string again = (folder / std::to_string(threads)).string();
        const Outcome outcome = cli(fmt::format(
            "run {} --config {}/config.cfg --threads {} --out {}", tour, first, threads, again));
        ASSERT_EQ(outcome.status, 0) << outcome.output;
        for (const char* name :
             {"/map.txt", "/trajectory.tum", "/odometry.tum", "/grid_best.png"}) {
            EXPECT_EQ(content(first + name), content(again + name)) << name << ", " << threads;
        }
    }
}

TEST(Cli, GridsMarkTheEndsOfThePathAsIsAsked) {
    const TempFolder folder;
    const auto left = [&folder](const std::string& marks, const char* name) {
        return content(folder / marks / name);
    };
    for (const std::string marks : {"discs", "x-and-o"}) {
        const Outcome outcome =
            cli(fmt::format("run {}/data/worlds/corridor.toml{}--set grid.path_marks={} --out {}",
                            kSource, quick(), marks, (folder / marks).string()));
        ASSERT_EQ(outcome.status, 0) << outcome.output;
    }
    EXPECT_EQ(left("discs", "map.txt"), left("x-and-o", "map.txt"));
    for (const char* grid : {"grid_best.png", "grid_best.jpg", "grid_odometry.png"}) {
        EXPECT_NE(left("discs", grid), left("x-and-o", grid)) << grid;
    }
}

TEST(Cli, ConvertWritesEveryFormatAndTheMapsAgree) {
    const TempFolder folder;
    std::vector<std::size_t> landmarks;
    for (const std::string format : {"normalized", "player", "radish", "carmen"}) {
        const std::string log = (folder / (format + ".log.gz")).string();
        const Outcome converted =
            cli(fmt::format("convert {} --to {} --out {}", kLog, format, log));
        ASSERT_EQ(converted.status, 0) << converted.output;
        const std::string out = (folder / format).string();
        const Outcome outcome = cli(fmt::format("run {}{}--out {}", log, quick(), out));
        ASSERT_EQ(outcome.status, 0) << outcome.output;
        const auto summary = nlohmann::json::parse(content(out + "/summary.json"));
        EXPECT_EQ(summary["format"], format);
        EXPECT_EQ(summary["scans"], 1050);
        landmarks.push_back(read_map(out + "/map.txt").size());
    }
    EXPECT_EQ(landmarks, (std::vector<std::size_t>(4, 16U)));
}

TEST(Cli, NoiseOfConvertIsSeeded) {
    const TempFolder folder;
    const auto noisy = [&](const std::string& name, const std::string& options) {
        EXPECT_EQ(cli("convert " + kLog + " --to normalized --odometry-noise 0.1 " + options +
                      " --out " + (folder / name).string())
                      .status,
                  0);
        return content(folder / name);
    };
    const std::string a = noisy("a", "--seed 1");
    EXPECT_EQ(a, noisy("b", "--seed 1"));
    EXPECT_NE(a, noisy("c", "--seed 2"));
    EXPECT_NE(a, noisy("d", "--seed 1 --odometry-noise-kind variance"));
}

TEST(Cli, EvaluateMeasuresFinishedFiles) {
    const TempFolder folder;
    const std::string map = kSource + "/data/maps/bigloop.map";
    const Outcome same = cli("evaluate --map " + map + " --reference " + map);
    EXPECT_EQ(same.status, 0);
    EXPECT_NE(same.output.find("map_error_m 0.000000"), std::string::npos) << same.output;
    EXPECT_NE(same.output.find("landmarks 16"), std::string::npos) << same.output;
    const auto path = folder.put("a.tum", "0 0 0 0 0 0 0 1\n1 1 0 0 0 0 0 1\n2 2 0 0 0 0 0 1\n");
    const auto turned = folder.put(
        "b.tum",
        "0 5 5 0 0 0 0.70710678118 0.70710678118\n1 5 6 0 0 0 0.70710678118 0.70710678118\n"
        "2 5 7 0 0 0 0.70710678118 0.70710678118\n");
    const Outcome aligned = cli("evaluate --trajectory " + path.string() +
                                " --reference-trajectory " + turned.string());
    EXPECT_EQ(aligned.status, 0);
    EXPECT_NE(aligned.output.find("ate_rmse_m 0.000000"), std::string::npos) << aligned.output;
    expect_error(cli("evaluate --map " + map), {"--reference", "--distances"});
    expect_error(cli("evaluate"), {"nothing to measure"});
}

TEST(Cli, HelpEverywhere) {
    for (const std::string command : {"", "run", "convert", "evaluate", "parameters"}) {
        const Outcome outcome = cli(command + " --help");
        EXPECT_EQ(outcome.status, 0);
        EXPECT_NE(outcome.output.find("--help"), std::string::npos);
    }
    EXPECT_NE(cli("--version").output.find('.'), std::string::npos);
    expect_error(cli(""), {"subcommand"});
}

TEST(Cli, ListsTheParameters) {
    const std::string all = cli("parameters").output;
    for (const ConfigParameter& parameter : parameters()) {
        EXPECT_NE(all.find("\n  " + std::string(parameter.key) + " = "), std::string::npos)
            << parameter.key;
    }
    const Outcome some = cli("parameters ransac split_merge.dmax");
    EXPECT_EQ(some.status, 0);
    for (const char* words :
         {"  ransac.threshold = 0.04\n", "1e-06 to 10 m; read where features.method is ransac",
          "  split_merge.dmax = 0.02   Dmax in the thesis\n"}) {
        EXPECT_NE(some.output.find(words), std::string::npos) << some.output;
    }
    EXPECT_EQ(some.output.find("split_merge.fit"), std::string::npos);
    expect_error(cli("parameters ransac.treshold"), {"did you mean ransac.threshold"});
}

class BadInput : public testing::Test {
  protected:
    Outcome run_log(const std::string& bytes, const std::string& options = "") {
        folder_.put("bad.log", bytes);
        return cli("run " + (folder_ / "bad.log").string() + " " + options + " --out " + out_);
    }
    /// Nothing useful came out: no result file is there.
    void expect_no_results() {
        EXPECT_FALSE(std::filesystem::exists(out_ + "/map.txt"));
        EXPECT_FALSE(std::filesystem::exists(out_ + "/summary.json"));
        if (std::filesystem::exists(out_)) {
            EXPECT_TRUE(std::filesystem::is_empty(out_));
        }
    }
    TempFolder folder_;
    std::string out_ = (folder_ / "out").string();
};

TEST_F(BadInput, MissingFile) {
    expect_error(cli("run " + (folder_ / "none.log").string() + " --out " + out_), {"none.log"});
    expect_no_results();
}

TEST_F(BadInput, Directory) {
    expect_error(cli("run " + folder_.path().string() + " --out " + out_),
                 {folder_.path().string(), "folder"});
    expect_no_results();
}

TEST_F(BadInput, EmptyFile) {
    expect_error(run_log(""), {"bad.log", "empty"});
    expect_no_results();
}

TEST_F(BadInput, BinaryFile) {
    std::string bytes;
    for (int i = 0; i < 5000; ++i) bytes += static_cast<char>(i * 31 % 256);
    expect_error(run_log(bytes), {"bad.log"});
    expect_no_results();
}

TEST_F(BadInput, WrongExplicitFormat) {
    expect_error(cli("run " + kLog + " --format radish --out " + out_), {"radish", "player"});
    expect_error(cli("run " + kLog + " --format elephant --out " + out_), {"elephant", "carmen"});
    expect_no_results();
}

TEST_F(BadInput, TruncatedGzipGivesWhatCanBeRead) {
    const std::string whole = content(kLog);
    const Outcome outcome = run_log(whole.substr(0, whole.size() / 2), quick());
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    const auto summary = nlohmann::json::parse(content(out_ + "/summary.json"));
    EXPECT_GT(summary["scans"], 100);
    EXPECT_LT(summary["scans"], 1050);
    EXPECT_EQ(summary["log"]["skipped_lines"], 1);
}

std::string wall_scan(int k, const std::string& extra = "") {
    std::string line =
        "LASER " + std::to_string(k) + " " + std::to_string(30 + (extra.empty() ? 0 : 1)) + extra;
    for (int i = 0; i < 30; ++i) line += " 2 " + std::to_string(0.1 * i - 1.5);
    return line + "\n";
}

TEST_F(BadInput, EndlessFilesAreRefused) {
    const std::string long_one =
        folder_.put("long.toml", std::string((std::size_t{16} << 20U) + 1, '\n')).string();
    const std::string run = "run " + kLog + " --out " + out_;
    for (const std::string& file : {std::string("/dev/zero"), long_one}) {
        const char* const words = file == long_one ? "is greater than 16 MiB" : "is a device";
        expect_error(cli(fmt::format("{} --config {}", run, file)), {file, words});
        expect_error(cli("world " + file + " --out " + out_ + ".toml"), {file, words});
    }
    expect_error(cli(run + " --reference /dev/zero"), {"/dev/zero", "is a device"});
    expect_error(cli("run /dev/zero --out " + out_), {"/dev/zero"});
    expect_no_results();
}

TEST_F(BadInput, DamagedLinesAreSkippedAndCounted) {
    std::string log = "ODOM 0 0 0\n" + wall_scan(1) + "ODOM 2 0.1 0\n";
    log += "LASER 3 -4 1 2\n";            // negative count
    log += "LASER 3 0\n";                 // no ray returned: an empty scan, no damage
    log += "LASER 3 50 1 2 3 4\n";        // a count that lies
    log += "LASER three 1 1 1\n";         // no number
    log += "ODOM 3 abc 0\n";              // no number
    log.append(10'000'000, 'x') += '\n';  // a line of 10 MB
    log += wall_scan(4, " nan inf");      // no point, but a scan
    log += wall_scan(3);                  // backwards: still a scan
    const Outcome outcome = run_log(log, quick());
    ASSERT_EQ(outcome.status, 0) << outcome.output;
    EXPECT_NE(outcome.output.find("damaged lines"), std::string::npos) << outcome.output;
    const auto summary = nlohmann::json::parse(content(out_ + "/summary.json"));
    EXPECT_EQ(summary["scans"], 4);
    EXPECT_EQ(summary["log"]["skipped_lines"], 5);
    EXPECT_EQ(summary["log"]["skipped_examples"][0]["line"], 4);
    EXPECT_EQ(summary["landmarks"]["lines"], 1);
}

TEST_F(BadInput, WhoAsksWhetherALogIsWholeIsToldOfDamage) {
    const std::string whole =
        run_command("zcat " + kSource + "/data/logs/player-laser.log.gz").output;
    const Outcome fine = cli("check " + folder_.put("whole.log", whole).string());
    EXPECT_EQ(fine.status, 0) << fine.output;
    EXPECT_NE(fine.output.find("\nnothing looks wrong in it\n"), std::string::npos) << fine.output;
    const Outcome cut = cli("check " + folder_.put("cut.log", whole + "ODOM 9 abc 0\n").string());
    EXPECT_EQ(cut.status, 1);
    EXPECT_NE(cut.output.find("1 damaged line was skipped"), std::string::npos) << cut.output;
    EXPECT_NE(cut.output.find("\nnothing else looks wrong in it\n"), std::string::npos);
}

TEST_F(BadInput, ConfigurationMistakes) {
    const std::string run = "run " + kLog + " --out " + out_ + " ";
    expect_error(cli(run + "--set filter.partycles=5"), {"filter.partycles", "filter.particles"});
    expect_error(cli(run + "--set filter.particles=-5"), {"filter.particles", "-5"});
    expect_error(cli(run + "--set filter.particles"), {"key=value"});
    expect_error(cli(run + "--set split_merge.dmax=nan"), {"split_merge.dmax"});
    const auto config = folder_.put("c.cfg", "[filter]\nparticles = 10\nwheels = 4\n");
    expect_error(cli(run + "--config " + config.string()), {"c.cfg:3", "wheels"});
    expect_error(cli(run + "--config " + (folder_ / "no.cfg").string()), {"no.cfg"});
    expect_no_results();
}

TEST_F(BadInput, ReferencesThatCannotBeRead) {
    const std::string run = "run " + kLog + " --out " + out_ + " ";
    expect_error(cli(run + "--reference " + (folder_ / "no.map").string()), {"no.map"});
    const auto map = folder_.put("bad.map", "rho: 1 theta: 90\nrho: x\n");
    expect_error(cli(run + "--reference " + map.string()), {"bad.map:2"});
    const auto tum = folder_.put("bad.tum", "0 1 2\n");
    expect_error(cli(run + "--reference-trajectory " + tum.string()), {"bad.tum:1"});
    expect_no_results();
}

TEST_F(BadInput, ASeedWithASign) {
    for (const char* option : {"--seed", "--tour-seed"}) {
        expect_error(cli(fmt::format("run {} {} -1 --out {}", kLog, option, out_)),
                     {option, "found -1, expected a whole number"});
    }
    expect_no_results();
}

TEST_F(BadInput, UnwritableOutput) {
    const auto file = folder_.put("file", "");
    expect_error(cli("run " + kLog + " --out " + file.string() + "/out"), {"--out"});
    expect_error(cli("convert " + kLog + " --to carmen --out " + file.string() + "/x.log"),
                 {"x.log"});
}

TEST_F(BadInput, AFileOfFiguresThatCannotBeIsToldBeforeTheRun) {
    const std::string run = "run " + kLog + quick() + "--out " + (folder_.path() / "out").string();
    const std::string nowhere = (folder_.path() / "no" / "figures.csv").string();
    expect_error(cli(run + " --figures " + nowhere), {nowhere, "there is no folder"});
    expect_error(cli(run + " --figures " + folder_.path().string()), {"is a folder"});
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "out"));
}

TEST_F(BadInput, AFailedConversionLeavesTheTargetAsItWas) {
    const auto target = folder_.put("kept.log", "precious");
    folder_.put("odometry.log", "ODOM 0 0 0\nODOM 1 1 0\n");
    const std::string log = (folder_ / "odometry.log").string();
    expect_error(cli("convert " + log + " --to normalized --out " + target.string()),
                 {"no readable scan"});
    EXPECT_EQ(content(target), "precious");
    EXPECT_EQ(folder_.files(), 2U);
}

}  // namespace
}  // namespace hitos
