// SPDX-License-Identifier: GPL-3.0-or-later
// What every release has written opens today: folders of results, configurations, worlds, studies,
// changes by hand. tests/releases has one folder for each, which its script `make` has made.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "hitos/registration/graph_edit.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/files/map_file.hpp"
#include "hitos/services/results/kept_run.hpp"
#include "program.hpp"

namespace hitos::test {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;

class OldReleases : public ProgramTest {
  protected:
    /// Calls it for each release, in a copy of its folder: whoever opens old results has moved
    /// them.
    void each(const std::function<void()>& opens) {
        for (const auto& entry : fs::directory_iterator(kSource + "/tests/releases")) {
            if (!entry.is_directory()) continue;
            release_ = entry.path().filename();
            SCOPED_TRACE(release_);
            fs::copy(entry.path(), folder_ / release_, fs::copy_options::recursive);
            opens();
        }
        ASSERT_FALSE(release_.empty());
    }
    std::string here(std::string_view name) const {
        return path(release_ + "/" + std::string(name));
    }

    /// In the release's folder.
    Outcome call(const std::string& arguments) const {
        return shell("cd " + here("") + " && " + cli_ + " " + arguments);
    }
    std::string done(const std::string& arguments) const {
        const Outcome outcome = call(arguments);
        EXPECT_EQ(outcome.status, 0) << arguments << '\n' << outcome.output;
        return outcome.output;
    }
    json object(const std::string& arguments) const {
        return json::parse(done(arguments + " --json 2>/dev/null"), nullptr, false);
    }
    json summary(const std::string& run) const {
        return json::parse(content(here(run + "/summary.json")));
    }

    std::string release_;
};

constexpr const char* kStudy =
    "study filtered/tour.log.gz --reference reference.map --preset simulated "
    "--set filter.particles=5 --runs 2 --vary split_merge.dmax=0.02,0.04 --out study";

TEST_F(OldReleases, OneOfThisVersionIsAmongThem) {
    const std::string version = shell(cli_ + " --version").output;
    EXPECT_TRUE(fs::exists(kSource + "/tests/releases/" + version.substr(0, version.find('\n'))))
        << "tests/releases/make makes it";
}

TEST_F(OldReleases, ResultsAreWhole) {
    each([&] {
        for (const char* run : {"filtered", "edited"}) {
            EXPECT_THAT(done(std::string("verify ") + run), HasSubstr("whole: "));
        }
        for (const char* study : {"study", "batch/dmax.csv"}) {
            EXPECT_THAT(done(std::string("verify ") + study),
                        HasSubstr(", 0 failed, and the tables"));
        }
    });
}

TEST_F(OldReleases, RunsAreMeasuredAndCompared) {
    each([&] {
        const json compared = object("compare filtered edited");
        ASSERT_EQ(compared["runs"].size(), 2U);
        for (const json& run : compared["runs"]) EXPECT_TRUE(run["finished"]) << run;
        EXPECT_EQ(compared["runs"][0]["settings"]["filter.particles"], "10");
        const json& filtered = compared["runs"][0]["figures"];
        for (const char* name : {"lines", "corners", "map_error_m", "cells_per_point"}) {
            EXPECT_GT(filtered[name], 0.0) << name;
        }
        EXPECT_EQ(compared["runs"][1]["figures"]["loops_closed"], 1.0);
        EXPECT_EQ(object("evaluate filtered")["scans"], summary("filtered")["scans"])
            << "the log beside it is read again";
        const json measured = object(
            "evaluate edited --reference reference.map --reference-trajectory truth.tum "
            "--distances walls.distances");
        EXPECT_LT(measured["map_error_aligned_m"], 0.2);
        EXPECT_LT(measured["ate_rmse_m"], 0.3);
        EXPECT_NEAR(measured["distances"][0]["slam_m"], 5.0, 0.2);
        // As the window opens them.
        const KeptRun run = read_results(here("edited"));
        EXPECT_EQ(run.scans, summary("edited")["scans"]);
        EXPECT_EQ(run.path.size(), run.scans);
        EXPECT_EQ(run.map.size(), read_map(here("edited/map.txt")).size());
        EXPECT_FALSE(run.line_extents.empty());
        const auto closed = std::ranges::find_if(run.loops, &RunLoop::closed);
        ASSERT_NE(closed, run.loops.end());
        EXPECT_TRUE(closed->record.by_hand);
        EXPECT_EQ(closed->record.pose_earlier_scan, (Pose{0.71, -0.04, 0.095}));
        EXPECT_GT(closed->record.weight, 0.5);
    });
}

TEST_F(OldReleases, FilesOfRunsAreRead) {
    each([&] {
        EXPECT_TRUE(object("graph filtered/graph.g2o")["converged"]);
        EXPECT_GT(object("world filtered/segments.txt --start 0,0,0 --out traced.toml")["walls"],
                  3);
        EXPECT_GT(object("world filtered/map.yaml --start 0,0,0 --out pictured.toml")["walls"], 3);
        done("convert edited/tour.log.gz --to normalized --out again.log");
    });
}

TEST_F(OldReleases, RunsAreDoneAgain) {
    each([&] {
        // Into the folder of the former ones, which are known to be of the same run.
        done(
            "run filtered/tour.log.gz --config filtered/config.cfg --out filtered "
            "--write g2o,landmarks,map-server");
        EXPECT_EQ(summary("filtered")["scans"], summary("edited")["scans"]);
        done("verify filtered");
        EXPECT_THAT(content(here("filtered/config.cfg")), HasSubstr("\nfile = \"tour.log.gz\"\n"))
            << "the log in the folder moves with it";
        const Outcome other = call("run edited/tour.log.gz --seed 7 --out edited");
        EXPECT_EQ(other.status, 1);
        EXPECT_THAT(other.output, HasSubstr("holds the results of another run of"));
    });
}

TEST_F(OldReleases, ChangesByHandAreMadeAgain) {
    each([&] {
        done("run edited/tour.log.gz --preset recorded --edits edited/edits.toml --out again");
        const auto edits = [&](const char* run) {
            std::vector<GraphEdit> all = parse_graph_edits(
                ArchivoConfiguracion::read_edits(here(run + std::string("/edits.toml"))));
            // Scans have had marks since 0.9.0.
            for (GraphEdit& edit : all) edit.scan.mark = edit.earlier.mark = 0;
            return all;
        };
        EXPECT_EQ(edits("again"), edits("edited"));
        EXPECT_EQ(edits("again").size(), 4U);
        EXPECT_THAT(content(here("again/loops.csv")), HasSubstr("\n45,7,closed,"));
    });
}

TEST_F(OldReleases, WorldsAreDrivenByEveryConfiguration) {
    each([&] {
        EXPECT_TRUE(object("world world.toml")["start_free"]);
        done("simulate world.toml --format carmen --out driven.log");
        for (const auto& file : fs::directory_iterator(here("configurations"))) {
            done(fmt::format("run world.toml --config {} --set filter.particles=5 --out by/{}",
                             file.path().string(), file.path().stem().string()));
        }
        EXPECT_GT(std::distance(fs::directory_iterator(here("by")), fs::directory_iterator()), 4);
    });
}

TEST_F(OldReleases, StudiesGoOn) {
    each([&] {
        done("recover study");
        done("verify study");
        // Runs of another program are none of this one's, and are done anew.
        EXPECT_THAT(done(kStudy), HasSubstr("| 0.04 | 2 |"));
        done("verify study");
        // Shards of one program belong together, whichever merges them.
        EXPECT_THAT(done("study merge shards"), HasSubstr("| 10 | 1 |"));
        done("verify shards");
        done("recover batch/dmax.csv");
        done("verify batch/dmax.csv");
        EXPECT_EQ(shell("cd " + here("batch") + " && " + batch_ +
                        " tour.cfg dmax.csv ../reference.map dmax 0.02 0.04 --runs 1")
                      .status,
                  0);
    });
}

TEST_F(OldReleases, DamageIsToldByFile) {
    each([&] {
        for (const char* name : {"config.cfg", "map.txt", "segments.txt", "trajectory.tum",
                                 "odometry.tum", "loops.csv", "edits.toml"}) {
            const std::string file = here(std::string("edited/") + name);
            const std::string whole = content(file);
            folder_.put(release_ + "/edited/" + name, whole.substr(0, whole.size() / 2));
            const Outcome verified = call("verify edited");
            EXPECT_EQ(verified.status, 1);
            EXPECT_THAT(verified.output, HasSubstr(std::string(name) + ": changed"));
            folder_.put(release_ + "/edited/" + name, whole);
        }
        done("verify edited");
        fs::resize_file(here("edited/map.txt"), 20);
        const Outcome compared = call("compare filtered edited");
        EXPECT_EQ(compared.status, 1);
        EXPECT_THAT(compared.output,
                    AllOf(HasSubstr("map.txt"), HasSubstr("is not the file that summary.json")));
        for (const char* name : {"filtered/summary.json", "study/study.json"}) {
            fs::resize_file(here(name), 200);
            const Outcome verified = call("verify " + fs::path(name).parent_path().string());
            EXPECT_EQ(verified.status, 1);
            EXPECT_THAT(verified.output, HasSubstr(name));
        }
    });
}

}  // namespace
}  // namespace hitos::test
