// SPDX-License-Identifier: GPL-3.0-or-later
// MCAP as a user writes it, read by a second implementation and by Hitos itself.
#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "program.hpp"

namespace hitos {
namespace {

using test::content;
namespace fs = test::fs;
using test::Outcome;
using test::shell;
using ::testing::Each;
using ::testing::Ge;
using ::testing::HasSubstr;

#define HITOS_SKIP_WITHOUT_READER()                                                        \
    if (shell("python3 -c pass && zstd --version").status != 0) {                          \
        GTEST_SKIP() << "python3 or the program zstd is not here: no second reader of it"; \
    }

class McapFiles : public test::ProgramTest {
  protected:
    /// The file, converted from the log.
    std::string converted(const std::string& log) const {
        const Outcome outcome =
            shell(cli_ + " convert " + log + " --to mcap --out " + path("tour.mcap"));
        EXPECT_EQ(outcome.status, 0) << outcome.output;
        return path("tour.mcap");
    }
    /// What the second implementation says of a file and of the log that it was made from.
    static Outcome read(const std::string& mcap, const std::string& log = "") {
        return shell(test::kSource + "/tests/programs/mcap_reader.py " + mcap + " " + log);
    }
    static std::map<std::string, double> figures(const Outcome& outcome) {
        EXPECT_EQ(outcome.status, 0) << outcome.output;
        std::map<std::string, double> found;
        std::istringstream lines(outcome.output);
        std::string name;
        for (std::string line; std::getline(lines, line);) {
            std::istringstream words(line);
            double value = 0.0;
            if (words >> name >> value) found[name] = value;
        }
        return found;
    }
    /// By which the best particle's path is wrong.
    double ate_m(const std::string& log, const std::string& reference) const {
        const Outcome run =
            shell(cli_ + " run " + log + " --preset recorded --set filter.particles=10 --seed 1" +
                  " --reference-trajectory " + reference + " --replace --out " + path("run"));
        EXPECT_EQ(run.status, 0) << run.output;
        const auto summary = nlohmann::json::parse(content(folder_ / "run" / "summary.json"));
        return summary["trajectory_error"]["ate_rmse_m"].get<double>();
    }
};

TEST_F(McapFiles, EveryShippedLogIsTheSameToASecondImplementation) {
    HITOS_SKIP_WITHOUT_READER();
    std::vector<fs::path> logs{test::kSource + "/data/bigloop.log.gz",
                               test::kSource + "/data/bigloop-noisy.log.gz"};
    for (const auto& entry : fs::directory_iterator(test::kSource + "/data/logs")) {
        if (entry.path().extension() == ".gz") logs.push_back(entry.path());
    }
    ASSERT_EQ(logs.size(), 9U);
    for (const fs::path& log : logs) {
        SCOPED_TRACE(log);
        const std::string normalized = path("tour.log");
        ASSERT_EQ(shell(cli_ + " convert " + log.string() + " --to normalized --out " + normalized)
                      .status,
                  0);
        const auto found = figures(read(converted(log), normalized));
        EXPECT_GE(found.at("file_scans"), 50.0);
        EXPECT_LE(found.at("greatest_time_s"), 1e-9);
        EXPECT_LE(found.at("greatest_point_m"), 1e-5);  // bearings of six decimals among them
        EXPECT_LE(found.at("greatest_place_m"), 1e-9);
        EXPECT_LE(found.at("greatest_turn_rad"), 1e-9);
        EXPECT_EQ(found.at("greatest_twist"), 0.0);
    }
}

TEST_F(McapFiles, ASimulatedTourOfManyChunksIsWholeAndItsWriterIsNamed) {
    HITOS_SKIP_WITHOUT_READER();
    const Outcome simulated =
        shell(cli_ + " simulate bigloop --laps 5 --format mcap --out " + path("tour.mcap"));
    ASSERT_EQ(simulated.status, 0) << simulated.output;
    const Outcome outcome = read(path("tour.mcap"));
    EXPECT_GT(figures(outcome).at("chunks"), 1.0) << outcome.output;
    const std::string version = shell(cli_ + " --version").output;
    const std::string number = version.substr(0, version.find('\n'));
    EXPECT_THAT(number, HasSubstr(outcome.output.substr(outcome.output.find("Hitos ") + 6, 3)));
}

// The second implementation can fail: every single byte counts.
TEST_F(McapFiles, AWrongByteAnywhereIsFoundByTheSecondImplementation) {
    HITOS_SKIP_WITHOUT_READER();
    const std::string whole = content(converted(test::kSource + "/data/logs/player-laser.log.gz"));
    ASSERT_EQ(read(path("tour.mcap")).status, 0);
    std::vector<int> found;
    for (std::size_t i = 0; i < 24; ++i) {
        const std::size_t at = i * (whole.size() - 1) / 23;
        std::string changed = whole;
        changed[at] = static_cast<char>(changed[at] ^ 0x10);
        found.push_back(read(file("changed.mcap", changed)).status);
    }
    EXPECT_THAT(found, Each(Ge(1)));
}

TEST_F(McapFiles, GiveTheErrorOfTheirLogToOneMillimetre) {
    const std::string truth = path("truth/odometry.tum");
    ASSERT_EQ(shell(cli_ + " run " + log_ + " --preset thesis --set filter.particles=1 --out " +
                    path("truth"))
                  .status,
              0);
    const double of_log = ate_m(log_, truth);
    EXPECT_GT(of_log, 0.001);
    EXPECT_NEAR(ate_m(converted(log_), truth), of_log, 0.001);
}

}  // namespace
}  // namespace hitos
