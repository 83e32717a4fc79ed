// SPDX-License-Identifier: GPL-3.0-or-later
// hitos-cli benchmark as a user calls it.
#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "command_test.hpp"

namespace hitos::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

class BenchmarkCommand : public CommandTest {
  protected:
    BenchmarkCommand() : CommandTest("benchmark") {}

    /// Without the progress, which stderr tells.
    json object(const std::string& arguments) const {
        const Outcome outcome = shell(cli_ + " benchmark " + arguments + " --json 2>/dev/null");
        EXPECT_EQ(outcome.status, 0) << outcome.output;
        return json::parse(outcome.output);
    }
    /// When each run's record was written.
    std::map<std::string, std::filesystem::file_time_type> records_of(const char* out) const {
        std::map<std::string, std::filesystem::file_time_type> times;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(path(out))) {
            const std::filesystem::path& file = entry.path();
            if (file.extension() == ".json" && file.parent_path().filename() == "runs")
                times[file.string()] = entry.last_write_time();
        }
        return times;
    }
    /// Two algorithms on a few scans.
    std::string plan(const std::string& particles = "10") const {
        return file("plan" + particles + ".toml",
                    "runs = 3\n[[tour]]\nfile = \"recinto\"\nmap = \"" HITOS_SOURCE_DIR
                    "/data/maps/recinto.map\"\nset = [\"source.world_set=laser.rate=0.5\"]\n"
                    "[[algorithm]]\nname = \"particles\"\nset = [\"filter.particles=" +
                        particles + "\"]\n[[algorithm]]\nname = \"EKF\"\npreset = \"ekf\"\n");
    }
};

TEST_F(BenchmarkCommand, MakesATableWithPicturesAndGoesOn) {
    const json told = object(plan() + " --out " + path("out"));
    ASSERT_EQ(told.at("rows").size(), 2U);
    EXPECT_EQ(told.at("rows")[0].at("runs"), 3);
    EXPECT_FALSE(told.at("rows")[0].at("pose_in_95").is_null());
    for (const char* name : {"benchmark.md", "benchmark.csv", "benchmark.tex", "benchmark.json"})
        EXPECT_TRUE(fs::exists(path(std::string("out/") + name))) << name;
    const std::string page = content(path("out/benchmark.html"));
    EXPECT_THAT(page, HasSubstr("<img src=\"runs/recinto/particles/contact-sheet.png\""));
    EXPECT_TRUE(fs::exists(path("out/runs/recinto/particles/contact-sheet.png")));
    EXPECT_THAT(content(path("out/benchmark.tex")), HasSubstr("m$^2$"));
    EXPECT_THAT(page, HasSubstr("<img src=\"calibration.svg\""));
    EXPECT_TRUE(fs::exists(path("out/calibration.png")));
    EXPECT_THAT(content(path("out/benchmark.md")), HasSubstr("| filter [ms/scan] |"));
    const auto records = records_of("out");
    EXPECT_EQ(records.size(), 6U);
    EXPECT_EQ(call(plan() + " --out " + path("out")).status, 0);
    EXPECT_EQ(records_of("out"), records) << "nothing is done twice";
}

/// As `run` does: a figure of a tour that is read wrong is none, however many runs it is of.
TEST_F(BenchmarkCommand, SaysWhatIsWrongWithATourAndSoDoesAStudy) {
    const std::string log = HITOS_SOURCE_DIR "/data/bigloop.log.gz";
    const std::string cut = file("cut.log.gz", content(log).substr(0, 30000));
    const std::string plan = file(
        "wrong.toml",
        "runs = 2\n[[tour]]\nfile = \"" + log + "\"\nname = \"good\"\n[[tour]]\nfile = \"" + log +
            "\"\nname = \"mirrored\"\nset = [\"source.laser_pose=0,0,0,upside-down\"]\n"
            "[[tour]]\nfile = \"" +
            cut + "\"\nname = \"cut\"\n[[algorithm]]\nname = \"EKF\"\npreset = \"ekf\"\n");
    for (int time = 0; time < 2; ++time) {  // found done, it is said again
        const json rows = object(plan + " --no-pictures --out " + path("out")).at("rows");
        EXPECT_EQ(rows[0].at("remark"), "");
        EXPECT_THAT(rows[1].at("remark").get<std::string>(),
                    HasSubstr("the scans turn against the odometry"));
        EXPECT_THAT(rows[2].at("remark").get<std::string>(), HasSubstr("the first: line"));
    }
    EXPECT_THAT(content(path("out/benchmark.md")),
                HasSubstr("mirrored, EKF: the scans turn against the odometry"));

    const std::string study = cli_ + " study " + log + " --preset ekf --runs 2 --out ";
    const Outcome good = shell(study + path("good") + " --vary observation.common_sigma=0.01,0.02");
    EXPECT_THAT(good.output, Not(HasSubstr("warning")));
    const Outcome wrong =
        shell(study + path("wrong") + " --set source.laser_pose=0,0,0,upside-down" +
              " --vary observation.common_sigma=0.01,0.02");
    EXPECT_THAT(wrong.output, HasSubstr("warning: the scans turn against the odometry"));
    EXPECT_THAT(content(path("wrong/summary.md")), HasSubstr("Look at the log: the scans turn"));
}

TEST_F(BenchmarkCommand, HasTheSameHashesWithoutPicturesAndInParts) {
    const json whole = object(plan() + " --out " + path("whole"));
    const Outcome part = call(plan() + " --no-pictures --shard 1/2 --out " + path("parts"));
    EXPECT_EQ(part.status, 0);
    EXPECT_THAT(part.output, HasSubstr("part 1 of 2 done"));
    EXPECT_THAT(part.output, Not(HasSubstr("benchmark.html")));
    EXPECT_EQ(call(plan() + " --no-pictures --shard 2/2 --out " + path("parts")).status, 0);
    const auto records = records_of("parts");
    EXPECT_EQ(records.size(), 6U);
    EXPECT_EQ(call(plan() + " --no-pictures --out " + path("parts")).status, 0);
    EXPECT_EQ(records_of("parts"), records);
    const json parts = json::parse(content(path("parts/benchmark.json")));
    for (std::size_t row : {0U, 1U})
        EXPECT_EQ(parts.at("rows")[row].at("hash"), whole.at("rows")[row].at("hash"));
}

TEST_F(BenchmarkCommand, TellsWhereTimeAndMemoryGo) {
    const json told = object(plan() + " --no-pictures --out " + path("out"));
    for (const json& row : told.at("rows")) {
        double sum = 0.0;
        for (const char* stage : {"reading", "features", "registration", "filter", "rest"})
            sum += row.at("stage_seconds").at(stage).get<double>();
        const double all = row.at("cpu_seconds");
        EXPECT_GT(row.at("stage_seconds").at("filter"), 0.0);
        EXPECT_GT(sum, 0.0);
        EXPECT_LE(sum, all) << "parts of the whole";
        EXPECT_GT(row.at("state_bytes"), 1000);
    }
}

TEST_F(BenchmarkCommand, MeasuresTheRelationsOfAFolder) {
    const std::string folder = path("relations");
    refused(plan() + " --relations " + folder + " --out " + path("out"), "relations");
    fs::create_directory(folder);
    refused(plan() + " --relations " + folder + " --out " + path("out"),
            "expected files such as recinto.relations");
    // The robot is where it is, and a metre off.
    file("relations/recinto.relations", "2 2 0 0 0 0 0 0\n2 2 1 0 0 0 0 0\n");
    const json told =
        object(plan() + " --no-pictures --relations " + folder + " --out " + path("out"));
    for (const json& row : told.at("rows"))
        EXPECT_EQ(row.at("relations_m").at("mean"), 0.5) << row.dump();
}

TEST_F(BenchmarkCommand, ComparesWithWhatWasThereBefore) {
    const std::string out = " --no-pictures --out " + path("out");
    const std::string compare = " --compare " + path("out");
    EXPECT_EQ(call(plan() + out).status, 0);
    EXPECT_EQ(object(plan() + out + compare).at("changes").at("same"), 2);
    // With one particle the map is worse; EKF-SLAM is what it was.
    const Outcome worse = call(plan("1") + out + compare);
    EXPECT_EQ(worse.status, 2) << worse.output;
    EXPECT_THAT(worse.output, HasSubstr("worse"));
    EXPECT_THAT(content(path("out/changes.md")), HasSubstr("same bits"));
    EXPECT_EQ(call(plan("1") + out).status, 0);
    EXPECT_FALSE(fs::exists(path("out/changes.md"))) << "of another table";
    refused(plan() + out + " --compare " + path("nowhere"), "nowhere");
    refused(plan() + out + compare + " --shard 1/2", "a part is compared with nothing");
}

TEST_F(BenchmarkCommand, TakesAPartOfThePlan) {
    const json told = object(plan() + " --no-pictures --runs 1 --only EKF --out " + path("out"));
    ASSERT_EQ(told.at("rows").size(), 1U);
    EXPECT_EQ(told.at("rows")[0].at("algorithm"), "EKF");
    refused(plan() + " --only GMapping --out " + path("out"),
            "expected a tour, an algorithm or a peer of the plan: recinto, particles, EKF");
    refused("nothing --out " + path("out"),
            "those are all-worlds, calibration, perturbed, recorded, thesis, worlds");
}

// Nobody has to be refused to learn a file's digest.
TEST_F(BenchmarkCommand, InfoTellsTheDigestThatAPlanNames) {
    const std::string log = HITOS_SOURCE_DIR "/data/logs/carmen-flaser.log.gz";
    const std::string info = cli_ + " info " + log;
    const std::string digest = json::parse(shell(info + " --json").output).at("digest");
    EXPECT_THAT(shell(info).output, HasSubstr("\ndigest: " + digest + "\n"));
    const auto plan_with = [&](const std::string& named) {
        return file("digest.toml", "runs = 1\n[[tour]]\nfile = \"" + log + "\"\ndigest = \"" +
                                       named + "\"\n[[algorithm]]\nname = \"EKF\"\n" +
                                       "preset = \"ekf\"\n");
    };
    const std::string out = " --no-pictures --out " + path("out");
    EXPECT_EQ(call(plan_with(digest) + out).status, 0);
    const Outcome other = call(plan_with("0" + digest.substr(1, 30) + "x") + out);
    EXPECT_EQ(other.status, 2);
    EXPECT_THAT(other.output, HasSubstr("its digest is " + digest));
    std::string capitals = digest;
    std::ranges::transform(capitals, capitals.begin(), ::toupper);
    EXPECT_EQ(call(plan_with(capitals) + out).status, 0);
    EXPECT_THAT(call(file("true.toml",
                          "runs = true\n[[tour]]\nfile = \"recinto\"\n"
                          "[[algorithm]]\nname = \"EKF\"\n") +
                     out)
                    .output,
                HasSubstr("runs: expected a whole number"));
}

// Of a tour in several files the one that is named says little.
TEST_F(BenchmarkCommand, ADigestIsOfAllFilesOfATour) {
    fs::create_directories(path("mr"));
    const std::string head = "# UTIAS Multi-Robot Cooperative Localization and Mapping Dataset\n";
    const std::string odometry = file("mr/Robot1_Odometry.dat", head + "0 0 0\n1 0.1 0\n2 0.1 0\n");
    const std::string seen = file("mr/Robot1_Measurement.dat", head + "1 63 2 0.1\n2 63 1.9 0.1\n");
    file("mr/Barcodes.dat", head + "6 63\n");
    const auto digest_of = [&](const std::string& name) -> std::string {
        return json::parse(shell(cli_ + " info " + name + " --json").output).at("digest");
    };
    const std::string digest = digest_of(odometry);
    EXPECT_EQ(digest_of(seen), digest);
    file("mr/Robot1_Measurement.dat", head + "1 63 2.1 0.1\n2 63 1.9 0.1\n");
    EXPECT_NE(digest_of(odometry), digest);
}

TEST_F(BenchmarkCommand, ARowThatCannotBeIsTold) {
    const std::string broken = file("broken.toml", content(plan()) +
                                                       "[[tour]]\nfile = \"gone.log\"\n"
                                                       "address = \"https://example.org/\"\n");
    const Outcome outcome = call(broken + " --no-pictures --out " + path("out"));
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.output, HasSubstr("gone, EKF: "));
    EXPECT_THAT(outcome.output, HasSubstr("it can be had from https://example.org/"));
    EXPECT_THAT(content(path("out/benchmark.html")), HasSubstr("gone.log: is not there"));
}

}  // namespace
}  // namespace hitos::test
