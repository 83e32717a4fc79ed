// SPDX-License-Identifier: GPL-3.0-or-later
// The files that a run leaves for drawing programs and for the paper's tables and figures.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "hitos/services/evaluation/distances.hpp"
#include "hitos/services/files/map_file.hpp"
#include "hitos/services/files/segment_file.hpp"
#include "program.hpp"

namespace hitos {
namespace {

using test::content;
using test::Outcome;
using test::shell;
using ::testing::HasSubstr;
using ::testing::Not;

class MapFiles : public test::ProgramTest {
  protected:
    const std::string distances_ = test::kSource + "/data/worlds/corridor.distances";
    const std::string corridor_map_ = test::kSource + "/data/maps/corridor.map";
    const std::string run_ = cli_ + " run " + test::kSource +
                             "/data/worlds/corridor.toml --config " + config_ +
                             " --set split_merge.fit=least-squares" +
                             " --set observation.var_rho=0.001 --set observation.var_theta=0.0005 ";
};

TEST_F(MapFiles, OfTheCorridorHoldThePapersTableAndFigures) {
    const Outcome outcome =
        shell(run_ + "--distances " + distances_ + " --uncertainty --out " + path("out"));
    ASSERT_EQ(outcome.status, 0) << outcome.output;
    const auto summary = nlohmann::json::parse(content(path("out/summary.json")));
    EXPECT_THAT(outcome.output, HasSubstr("distance  SLAM [m]"));
    ASSERT_EQ(summary["distances"].size(), 9U);
    for (const auto& row : summary["distances"]) {
        EXPECT_LT(row["error_percent"].get<double>(), 3.35) << row.dump();
    }
    const LandmarkMap map = read_map(path("out/map.txt"));
    EXPECT_EQ(content(path("out/distances.csv")),
              distances_csv(measure_distances(map, read_distances(distances_))))
        << "the map file gives the same table";

    // Each segment lies on the line of the map file that it names, to the digits of that file.
    const std::vector<LineExtent> segments = read_segments(path("out/segments.txt"));
    EXPECT_GE(segments.size(), 10U);
    for (const LineExtent& segment : segments) {
        const auto& line =
            std::get<Recta>(map.at(static_cast<std::size_t>(segment.landmark)).value);
        EXPECT_NEAR(signed_distance(line, segment.a), 0.0, 1e-12);
        EXPECT_NEAR(signed_distance(line, segment.b), 0.0, 1e-12);
    }
    EXPECT_THAT(content(path("out/map.dxf")), HasSubstr("LWPOLYLINE"));
    EXPECT_THAT(content(path("out/uncertainty.csv")),
                ::testing::StartsWith("scan,time_s,kind,landmark,sigma_1,sigma_2\n1,0,line,1,"));
    if (outcome.output.find("gnuplot is not installed") != std::string::npos) return;
    EXPECT_THAT(outcome.output, Not(HasSubstr("not written")));
    for (const char* picture : {"out/paths.png", "out/uncertainty.png"})
        EXPECT_TRUE(content(path(picture)).starts_with("\x89PNG")) << picture;
}

TEST_F(MapFiles, AreTheSameForTheSameSeedAndAnyNumberOfThreads) {
    for (const char* threads : {"1", "3"}) {
        ASSERT_EQ(shell(run_ + "--distances " + distances_ + " --uncertainty --threads " + threads +
                        " --set filter.particles=600 --out " + path(threads))
                      .status,
                  0);
    }
    for (const char* name :
         {"/segments.txt", "/map.dxf", "/distances.csv", "/uncertainty.csv", "/paths.gp"})
        EXPECT_EQ(content(path("1") + name), content(path("3") + name)) << name;
}

TEST_F(MapFiles, AreThereOnlyWhereTheyWereAskedFor) {
    // Not even those that an earlier run left there.
    test::fs::create_directory(path("out"));
    for (const char* name : {"out/distances.csv", "out/uncertainty.png", "out/paths.png"})
        file(name, "old");
    file("out/summary.json", "{}");  // of a version that listed no files
    ASSERT_EQ(shell(cli_ + " run " + log_ + " --config " + config_ +
                    " --set filter.particles=5 --replace --out " + path("out"))
                  .status,
              0);
    for (const char* name : {"distances.csv", "uncertainty.csv", "uncertainty.png", "paths.png"})
        EXPECT_FALSE(test::fs::exists(path("out") + "/" + name)) << name;
}

TEST_F(MapFiles, EvaluateMeasuresDistancesInAFinishedMap) {
    const Outcome outcome = shell(cli_ + " evaluate --map " + corridor_map_ + " --distances " +
                                  distances_ + " --out " + path("table"));
    ASSERT_EQ(outcome.status, 0) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr("d9           3.000     3.000"));
    EXPECT_EQ(
        content(path("table/distances.csv")),
        distances_csv(measure_distances(read_map(corridor_map_), read_distances(distances_))));
    // Beside a reference map, and where a line is missing.
    const Outcome both = shell(cli_ + " evaluate --map " + map_ + " --reference " + map_ +
                               " --distances " + distances_);
    EXPECT_EQ(both.status, 0);
    EXPECT_THAT(both.output, HasSubstr("map_error_m 0.000000"));
    EXPECT_THAT(both.output, HasSubstr("no line across it within"));
}

TEST_F(MapFiles, MistakesAreNamedBeforeTheRun) {
    const auto error = [&](const std::string& command) {
        const Outcome outcome = shell(command);
        EXPECT_GT(outcome.status, 0) << outcome.output;
        EXPECT_LT(outcome.status, 128) << outcome.output;
        return outcome.output;
    };
    EXPECT_THAT(error(run_ + "--distances " + file("bad", "d 1 2 3\n") + " --out " + path("out")),
                HasSubstr("bad:1: found 4 fields"));
    EXPECT_FALSE(test::fs::exists(path("out")));
    const std::string evaluate = cli_ + " evaluate ";
    EXPECT_THAT(error(evaluate + "--distances " + distances_), HasSubstr("need --map"));
    EXPECT_THAT(error(evaluate + "--map " + map_ + " --reference " + map_ + " --out " + path("o")),
                HasSubstr("needs --distances"));
    // What it writes would be no file of the run that is there.
    test::fs::create_directories(path("run"));
    file("run/summary.json", "{}");
    EXPECT_THAT(
        error(evaluate + "--map " + map_ + " --distances " + distances_ + " --out " + path("run")),
        HasSubstr("holds the results of a run"));
    EXPECT_FALSE(test::fs::exists(path("run/distances.csv")));
    EXPECT_THAT(error(evaluate + "--map " + map_ + " --distances " + path("none")),
                HasSubstr("none"));
}

}  // namespace
}  // namespace hitos
