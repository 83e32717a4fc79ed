// SPDX-License-Identifier: GPL-3.0-or-later
// What hitos-cli says of recordings that are not what they seem.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "hitos/base/geometry.hpp"
#include "program.hpp"

namespace hitos {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// Where the odometry's pose stands in a FLASER line of n readings.
struct Reading {
    std::vector<std::string> fields;
    std::size_t place = 0;

    Pose odometry() const {
        return {std::stod(fields[place]), std::stod(fields[place + 1]),
                std::stod(fields[place + 2])};
    }
    void place_at(const Pose& pose) {
        // The laser's pose before the robot's: it sits on the robot's centre.
        for (const std::size_t at : {place - 3, place}) {
            fields[at] = fmt::format("{:.6f}", pose.x);
            fields[at + 1] = fmt::format("{:.6f}", pose.y);
            fields[at + 2] = fmt::format("{:.6f}", pose.theta);
        }
    }
};

class RecordingTest : public test::ProgramTest {
  protected:
    /// The scans of a tour through `recinto`, changed.
    std::string recording(const std::function<void(std::vector<Reading>&)>& change) const {
        const std::string log = path("tour.log");
        const test::Outcome simulated =
            test::shell(cli_ + " simulate recinto --seed 3 --format carmen --out " + log);
        EXPECT_EQ(simulated.status, 0) << simulated.output;
        std::vector<Reading> readings;
        std::istringstream lines(test::content(log));
        for (std::string line; std::getline(lines, line);) {
            std::istringstream words(line);
            Reading reading;
            for (std::string word; words >> word;) reading.fields.push_back(word);
            if (reading.fields.empty() || reading.fields[0] != "FLASER") continue;
            reading.place = 2 + std::stoul(reading.fields[1]) + 3;
            readings.push_back(std::move(reading));
        }
        EXPECT_GT(readings.size(), 400U);
        change(readings);
        std::string text;
        for (const Reading& reading : readings) {
            text += fmt::format("{}\n", fmt::join(reading.fields, " "));
        }
        return file("changed.log", text);
    }

    /// The block `quality` of the run's summary.
    json quality_of(const std::string& log, const std::string& options = "") const {
        const test::Outcome run = test::shell(
            cli_ + " run " + log + " --preset recorded --set filter.particles=5 --replace --out " +
            path("out") + options);
        EXPECT_EQ(run.status, 0) << run.output;
        return json::parse(test::content(folder_ / "out" / "summary.json"))["quality"];
    }
};

TEST_F(RecordingTest, OfAGoodTourThereIsNothingToSay) {
    const json quality = quality_of(recording([](std::vector<Reading>&) {}));
    EXPECT_THAT(quality["warnings"], IsEmpty());
    EXPECT_THAT(quality["scans_breaking"], IsEmpty());
    // The tour ends where it began. The records say of each place what became of it.
    ASSERT_GE(quality["loops"].size(), 1U);
    EXPECT_EQ(quality["loops"].size(), quality["loops_closed"]);
    for (const json& loop : quality["loops"]) {
        EXPECT_EQ(loop["verdict"], "closed");
        EXPECT_LT(loop["earlier"], loop["scan"]);
        for (const char* figure :
             {"score", "overlap", "seen_through", "chi_square", "weight", "move_m"}) {
            EXPECT_TRUE(loop[figure].is_number()) << figure;
        }
    }
    // A place has to be found more than once.
    ASSERT_THAT(quality["refused_loops"], Not(IsEmpty()));
    std::size_t refused = 0;
    for (const json& loop : quality["refused_loops"]) {
        EXPECT_NE(loop["verdict"], "closed");
        EXPECT_FALSE(loop.contains("weight") || loop.contains("move_m"));
        if (loop["verdict"] != "alone") ++refused;
    }
    EXPECT_EQ(quality["loops_refused"], refused);
}

TEST_F(RecordingTest, ARobotThatWasCarriedIsTold) {
    constexpr std::size_t kFrom = 120;
    constexpr std::size_t kTo = 260;
    const json quality = quality_of(recording([](std::vector<Reading>& readings) {
        const Pose before = readings[kFrom - 1].odometry();
        const Pose after = readings[kTo - 1].odometry();
        for (std::size_t i = kTo; i < readings.size(); ++i) {
            const Pose since = between(after, readings[i].odometry());
            readings[i].place_at(compose(before, since));
        }
        readings.erase(readings.begin() + kFrom, readings.begin() + kTo);
    }));
    ASSERT_THAT(quality["scans_breaking"], Not(IsEmpty()));
    EXPECT_EQ(quality["scans_breaking"][0], kFrom + 1);
    ASSERT_EQ(quality["warnings"].size(), 1U);
    EXPECT_THAT(quality["warnings"][0].get<std::string>(), HasSubstr("(scan 121"));
}

TEST_F(RecordingTest, OdometryThatNeverMovesIsTold) {
    const json quality = quality_of(recording([](std::vector<Reading>& readings) {
        for (Reading& reading : readings) reading.place_at({});
    }));
    ASSERT_GE(quality["warnings"].size(), 1U);
    EXPECT_THAT(quality["warnings"][0].get<std::string>(),
                HasSubstr("The odometry never moves in"));
}

TEST_F(RecordingTest, AJumpOfTheOdometryIsTold) {
    const std::string log = recording([](std::vector<Reading>& readings) {
        for (std::size_t i = 300; i < readings.size(); ++i) {
            Pose pose = readings[i].odometry();
            pose.x += 40.0;
            readings[i].place_at(pose);
        }
    });
    const json as_logged = quality_of(log, " --set source.mend=rays");
    ASSERT_GE(as_logged["warnings"].size(), 1U);
    EXPECT_THAT(as_logged["warnings"][0].get<std::string>(), HasSubstr("(300 → 301, 40 m)"));
    const json quality = quality_of(log);
    // It is bridged, so that the map does not fall in pieces there.
    EXPECT_TRUE(quality["warnings"].empty()) << quality["warnings"];
    ASSERT_EQ(quality["findings"].size(), 1U);
    EXPECT_EQ(quality["findings"][0]["kind"], "leaping-odometry");
    EXPECT_NEAR(quality["findings"][0]["value"].get<double>(), 40.0, 1.0);
}

TEST_F(RecordingTest, ALaserThatSeesNothingCostsThePicturesOnly) {
    std::string blind;
    for (int i = 0; i < 20; ++i) {
        blind += fmt::format("FLASER 3 81.91 81.91 81.91 {0} 0 0 {0} 0 0 {1} robot {1}\n", 0.1 * i,
                             0.2 * i);
    }
    const std::string run =
        cli_ + " run " + file("blind.log", blind) + " --preset recorded --out " + path("out");
    const test::Outcome outcome = test::shell(run);
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr("warning: not written: grid_best.png"));
    EXPECT_TRUE(test::fs::exists(folder_ / "out" / "trajectory.tum"));
    EXPECT_FALSE(test::fs::exists(folder_ / "out" / "grid_best.jpg"));
    const json summary = json::parse(test::content(folder_ / "out" / "summary.json"));
    ASSERT_EQ(summary["not_written"].size(), 3U);
    EXPECT_THAT(summary["not_written"][0]["reason"].get<std::string>(),
                HasSubstr("nothing to draw"));
    EXPECT_EQ(test::shell(run + " --strict").status, 2);
    EXPECT_THAT(test::shell(run + " --grid-of 3").output,
                HasSubstr("warning: not written: grid_particle_3.png"));
}

}  // namespace
}  // namespace hitos
