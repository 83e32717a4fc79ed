// SPDX-License-Identifier: GPL-3.0-or-later
// hitos-cli: the loops of a run in files, against a reference, and changed by hand.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "hitos/base/geometry.hpp"
#include "program.hpp"

namespace hitos {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

class LoopsTest : public test::ProgramTest {
  protected:
    void SetUp() override {
        test::ProgramTest::SetUp();
        const test::Outcome simulated =
            test::shell(cli_ + " simulate recinto --seed 3 --format carmen --truth " +
                        path("truth.tum") + " --out " + tour_);
        ASSERT_EQ(simulated.status, 0) << simulated.output;
    }
    test::Outcome run(const std::string& folder, const std::string& options = "") const {
        return test::shell(cli_ + " run " + tour_ +
                           " --preset recorded --set filter.particles=5 --replace --out " +
                           path(folder) + " " + options);
    }
    json quality_of(const std::string& folder) const {
        return json::parse(test::content(folder_ / folder / "summary.json"))["quality"];
    }
    std::string content(const std::string& file) const { return test::content(folder_ / file); }
    /// The truth's file with other stamps, positions or quaternions.
    template <class Change>
    std::string changed_truth(const std::string& name, Change change) const {
        std::string changed;
        std::istringstream lines(content("truth.tum"));
        for (std::string line; std::getline(lines, line);) {
            std::istringstream words(line);
            std::array<double, 8> values{};
            for (double& value : values) words >> value;
            change(values);
            changed += fmt::format("{}\n", fmt::join(values, " "));
        }
        return file(name, changed);
    }
    std::string mirrored_truth() const {
        return changed_truth("mirrored.tum", [](auto& pose) { pose[2] = -pose[2]; });
    }
    /// Runs against a reference that is doubted in these words, by which no loop is false.
    void expect_no_loop_judged(const std::string& reference, const std::string& doubt) const {
        const std::string option = " --reference-trajectory " + reference;
        const test::Outcome told = run("out", option);
        ASSERT_EQ(told.status, 0) << told.output;
        EXPECT_THAT(told.output, HasSubstr("warning: " + doubt));
        EXPECT_THAT(told.output, Not(HasSubstr("them false")));
        const json quality = quality_of("out");
        ASSERT_FALSE(quality["loops"].empty());
        EXPECT_FALSE(quality.contains("loops_false"));
        const test::Outcome evaluated = test::shell(cli_ + " evaluate " + path("out") + option);
        ASSERT_EQ(evaluated.status, 0) << evaluated.output;
        EXPECT_THAT(evaluated.output, HasSubstr(doubt));
        EXPECT_THAT(evaluated.output, HasSubstr("loops_judged 0"));
        const test::Outcome compared = test::shell(cli_ + " compare " + path("out"));
        EXPECT_THAT(compared.output, HasSubstr("warning: out: " + doubt));
    }

    const std::string tour_ = path("tour.log");
};

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::size_t begin = 0;
    for (std::size_t end = 0; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
        lines.push_back(text.substr(begin, end - begin));
    return lines;
}

TEST_F(LoopsTest, EveryPlaceIsARowAndJudgedByTheReference) {
    const test::Outcome told = run("out", "--reference-trajectory " + path("truth.tum"));
    ASSERT_EQ(told.status, 0) << told.output;
    const json quality = quality_of("out");
    ASSERT_FALSE(quality["loops"].empty());
    const std::vector<std::string> rows = lines_of(content("out/loops.csv"));
    EXPECT_EQ(rows.size(), 1 + quality["loops"].size() + quality["refused_loops"].size());
    EXPECT_THAT(rows[0], HasSubstr("scan,earlier,verdict,"));
    const auto is_closed = [](const std::string& row) {
        return row.find(",closed,") != std::string::npos;
    };
    EXPECT_EQ(std::ranges::count_if(rows, is_closed), quality["loops_closed"]);
    // The log has noise of millimetres: no loop is false.
    EXPECT_EQ(quality["loops_judged"], quality["loops_closed"]);
    EXPECT_EQ(quality["loops_false"], 0);
    EXPECT_LT(quality["worst_loop_m"], 0.2);
    EXPECT_THAT(told.output,
                HasSubstr("0 of " + quality["loops_judged"].dump() + " of them false"));
    for (const json& loop : quality["loops"]) EXPECT_LT(loop["error_m"], 0.2);

    const test::Outcome evaluated =
        test::shell(cli_ + " evaluate " + path("out") + " --reference-trajectory " +
                    path("truth.tum") + " --json --out " + path("measured"));
    ASSERT_EQ(evaluated.status, 0) << evaluated.output;
    const json figures = json::parse(evaluated.output);
    for (const char* figure : {"loops_judged", "loops_false", "worst_loop_m"})
        EXPECT_EQ(figures[figure], quality[figure]) << figure;
    EXPECT_EQ(content("measured/loops.csv"), content("out/loops.csv"));
}

TEST_F(LoopsTest, NoneIsFalseByAMirroredReference) {
    expect_no_loop_judged(mirrored_truth(), "The reference trajectory is a mirror image");
}

TEST_F(LoopsTest, NoneIsFalseByAReferenceOfAnotherClock) {
    expect_no_loop_judged(changed_truth("late.tum", [](auto& pose) { pose[0] += 4.0; }),
                          "The reference trajectory fits the path where its stamps are taken 4.0 s "
                          "earlier");
}

TEST_F(LoopsTest, NoneIsFalseByAReferenceWithoutHeadings) {
    const std::string positions = changed_truth(
        "positions.tum", [](auto& pose) { std::fill(pose.begin() + 4, pose.end(), 0.0); });
    expect_no_loop_judged(positions, "The reference trajectory has no headings");
    const json error =
        json::parse(test::content(folder_ / "out" / "summary.json"))["trajectory_error"];
    EXPECT_FALSE(error.contains("heading_rmse_rad"));
    EXPECT_LT(error["ate_rmse_m"].get<double>(), 0.2);
    const test::Outcome told = test::shell(cli_ + " evaluate --rpe-distance 1 " + path("out") +
                                           " --reference-trajectory " + positions);
    ASSERT_EQ(told.status, 0) << told.output;
    EXPECT_THAT(told.output, Not(HasSubstr("rpe_")));
    EXPECT_THAT(told.output, Not(HasSubstr("heading_rmse")));
}

TEST_F(LoopsTest, AStudyHasRunsWithoutAndWithAChangeByHand) {
    ASSERT_EQ(run("plain").status, 0);
    const json plain = quality_of("plain");
    const json& loop = plain["loops"][0];
    const std::string study = cli_ + " study " + tour_ +
                              " --preset recorded --set filter.particles=5 --runs 1 --vary "
                              "'registration.edits=,refuse " +
                              loop["scan"].dump() + " " + loop["earlier"].dump() +
                              "' --reference-trajectory " + mirrored_truth() + " --out " +
                              path("study");
    const test::Outcome told = test::shell(study);
    ASSERT_EQ(told.status, 0) << told.output;
    EXPECT_THAT(told.output, HasSubstr("mirror image of the path"));
    const std::vector<std::string> rows = lines_of(content("study/quality.csv"));
    ASSERT_EQ(rows.size(), 3U) << content("study/quality.csv");
    // Done again it is the same study, all of whose runs are there.
    EXPECT_EQ(test::shell(study).status, 0);
    EXPECT_EQ(lines_of(content("study/quality.csv")), rows);
}

TEST_F(LoopsTest, WhereNoneIsClosedThoseThatWereRefusedAreJudged) {
    std::string refusals;
    for (int closed = -1; closed != 0;) {
        ASSERT_EQ(run("none", "--set 'registration.edits=" + refusals + "'").status, 0);
        const json quality = quality_of("none");
        for (const json& loop : quality["loops"])
            refusals += "refuse " + loop["scan"].dump() + " " + loop["earlier"].dump() + ";";
        ASSERT_NE(quality["loops_closed"], closed);
        closed = quality["loops_closed"];
    }
    const test::Outcome evaluated =
        test::shell(cli_ + " evaluate " + path("none") + " --reference-trajectory " +
                    path("truth.tum") + " --json --out " + path("measured"));
    ASSERT_EQ(evaluated.status, 0) << evaluated.output;
    const json figures = json::parse(evaluated.output);
    EXPECT_EQ(figures["loops_judged"], 0);
    EXPECT_FALSE(figures.contains("worst_loop_m"));
    const std::vector<std::string> rows = lines_of(content("measured/loops.csv"));
    ASSERT_GT(rows.size(), 1U);
    EXPECT_THAT(rows[0], HasSubstr("error_m"));
}

TEST_F(LoopsTest, ChangesByHandAreDoneAgainToTheSameBytes) {
    ASSERT_EQ(run("plain").status, 0);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "plain/edits.toml"));
    EXPECT_FALSE(quality_of("plain").contains("by_hand"));
    const json first = quality_of("plain")["loops"][0];
    const std::string scans = first["scan"].dump() + " " + first["earlier"].dump();
    const test::Outcome changed =
        run("changed", "--set 'registration.edits=refuse " + scans + "; slip 100; slip 101'");
    ASSERT_EQ(changed.status, 0) << changed.output;
    EXPECT_THAT(changed.output, HasSubstr("by hand 1 loop refused, 2 slips"));
    const json quality = quality_of("changed");
    EXPECT_EQ(quality["by_hand"], json::parse(R"({"closed": 0, "refused": 1, "fixed": 0, "slips": 2,
                                                 "anchors": 0, "met_nothing": 0})"));
    const auto& refused = quality["refused_loops"];
    EXPECT_TRUE(std::ranges::any_of(refused, [&](const json& loop) {
        return loop["verdict"] == "by-hand" && loop["scan"] == first["scan"];
    })) << refused;
    EXPECT_THAT(content("changed/edits.toml"), HasSubstr("refuse " + first["scan"].dump() + "@"));

    ASSERT_EQ(run("again", "--edits " + path("changed/edits.toml")).status, 0);
    for (const char* file : {"map.txt", "trajectory.tum", "loops.csv", "edits.toml", "config.cfg",
                             "grid_best.png", "segments.txt"}) {
        const std::string name = file;
        EXPECT_EQ(content("again/" + name), content("changed/" + name)) << name;
    }
    // It is the same run, whose folder takes it.
    const test::Outcome there =
        test::shell(cli_ + " run " + tour_ + " --preset recorded --set filter.particles=5 " +
                    "--edits " + path("changed/edits.toml") + " --out " + path("changed"));
    EXPECT_EQ(there.status, 0) << there.output;
    const test::Outcome compared =
        test::shell(cli_ + " compare " + path("changed") + " " + path("again"));
    EXPECT_THAT(compared.output, Not(HasSubstr("registration.edits")));
    EXPECT_NE(content("again/trajectory.tum"), content("plain/trajectory.tum"));
    // The same changes by either way are the same configuration too.
    const std::string named = "refuse " + scans + "  # wrong\nslip 100";
    ASSERT_EQ(run("set", "--set 'registration.edits=" + named + "'").status, 0);
    ASSERT_EQ(run("file", "--edits " + file("named.toml", "[registration]\nedits = \"\"\"\n" +
                                                              named + ";\n\"\"\"\n"))
                  .status,
              0);
    EXPECT_EQ(content("file/config.cfg"), content("set/config.cfg"));
    EXPECT_EQ(content("file/edits.toml"), content("set/edits.toml"));
    // And from the configuration of the results.
    const test::Outcome from_results =
        test::shell(cli_ + " run " + tour_ + " --config " + path("changed/config.cfg") + " --out " +
                    path("third"));
    ASSERT_EQ(from_results.status, 0) << from_results.output;
    EXPECT_EQ(content("third/trajectory.tum"), content("changed/trajectory.tum"));

    // Where the stretch of a refusal goes on another one has nothing to refuse.
    json last;
    for (const json& loop : refused)
        if (loop["verdict"] == "by-hand") last = loop;
    const test::Outcome covered = run(
        "covered", fmt::format("--set 'registration.edits=refuse {} {}; slip 100; slip 101; "
                               "refuse {}'",
                               last["scan"].get<int>() + 1, last["earlier"].get<int>() + 1, scans));
    EXPECT_THAT(covered.output, HasSubstr("what other refusals name (no. 4 → 1 of the list)"));
    EXPECT_THAT(covered.output, Not(HasSubstr("have met nothing to change (no.")));
    EXPECT_EQ(content("covered/trajectory.tum"), content("changed/trajectory.tum"));
}

TEST_F(LoopsTest, ARunIsAnchoredToADrawing) {
    // The drawing is the map turned by half a turn and moved; what scan 300 sees lies 0.3 m
    // further.
    ASSERT_EQ(run("plain").status, 0);
    const auto at_scan_300 = [&](const std::string& folder) {
        std::istringstream line(lines_of(content(folder + "/trajectory.tum")).at(299));
        double stamp = 0.0;
        Point2 at;
        line >> stamp >> at.x >> at.y;
        return at;
    };
    const Point2 before = at_scan_300("plain");
    const std::string edits =
        fmt::format("point 1 10 0 90 50; point 1 0 10 100 40; point 300 0 0 {} {}",
                    100.0 - before.x - 0.3, 50.0 - before.y);
    const test::Outcome told = run("first", "--set 'registration.edits=" + edits + "'");
    ASSERT_EQ(told.status, 0) << told.output;
    EXPECT_THAT(told.output, HasSubstr("anchored to a drawing, where the first scan lies at"));
    const json drawing = quality_of("first")["drawing"];
    EXPECT_TRUE(drawing["firm"]);
    EXPECT_NEAR(drawing["x"].get<double>(), 100.0, 0.3);
    EXPECT_NEAR(drawing["y"].get<double>(), 50.0, 0.3);
    EXPECT_NEAR(std::cos(drawing["theta"].get<double>()), -1.0, 1e-3);
    ASSERT_EQ(drawing["anchors"].size(), 3U);
    EXPECT_EQ(quality_of("first")["by_hand"]["anchors"], 3);
    EXPECT_EQ(drawing["anchors"][2]["scan"], 300);
    EXPECT_GT(distance(at_scan_300("first"), before), 0.05);
    EXPECT_THAT(content("first/edits.toml"), HasSubstr("point 300@"));

    ASSERT_EQ(run("again", "--edits " + path("first/edits.toml") + " --write g2o").status, 0);
    for (const char* file : {"map.txt", "trajectory.tum", "edits.toml", "segments.txt"}) {
        const std::string name = file;
        EXPECT_EQ(content("again/" + name), content("first/" + name)) << name;
    }
    EXPECT_THAT(content("again/graph.g2o"), HasSubstr("EDGE_SE2 0 299 "));
    // An algorithm with a graph of its own has them too.
    ASSERT_EQ(
        run("graph", "--edits " + path("first/edits.toml") + " --set filter.algorithm=graph-slam")
            .status,
        0);
    EXPECT_LT(distance(at_scan_300("graph"), at_scan_300("first")), 0.1);

    const test::Outcome none = run("none", "--set 'registration.edits=wall 5 3.1 0 0 4 0'");
    EXPECT_NE(none.status, 0);
    EXPECT_THAT(none.output, HasSubstr("change 1: scan 5 sees no straight wall"));
}

TEST_F(LoopsTest, ALoopThatWasNotFoundIsClosed) {
    ASSERT_EQ(run("plain").status, 0);
    const json found = quality_of("plain")["loops"][0];
    const std::string change = "close " + found["scan"].dump() + " " + found["earlier"].dump() +
                               " " + found["pose"][0].dump() + " " + found["pose"][1].dump() + " " +
                               found["pose"][2].dump();
    const test::Outcome closed = run("closed",
                                     "--set registration.loops=off --set "
                                     "'registration.edits=" +
                                         change + "'");
    ASSERT_EQ(closed.status, 0) << closed.output;
    const json loops = quality_of("closed")["loops"];
    ASSERT_EQ(loops.size(), 1U);
    EXPECT_EQ(loops[0]["scan"], found["scan"]);
    EXPECT_GT(loops[0]["score"], 0.5);
    EXPECT_THAT(content("closed/loops.csv"), HasSubstr("somebody has put it in"));
    EXPECT_GT(loops[0]["weight"], 0.99);
    EXPECT_EQ(loops[0]["reason"], "somebody has put it in");
    // As a folder that is read again has it.
    const test::Outcome evaluated =
        test::shell(cli_ + " evaluate " + path("closed") + " --reference-trajectory " +
                    path("truth.tum") + " --out " + path("measured"));
    ASSERT_EQ(evaluated.status, 0) << evaluated.output;
    EXPECT_THAT(content("measured/loops.csv"), HasSubstr("somebody has put it in"));
    // Where nothing is registered it changes nothing, and that is told.
    const test::Outcome without = run("without",
                                      "--set motion.model=odometry --set "
                                      "'registration.edits=slip 30'");
    EXPECT_THAT(without.output, HasSubstr("with these parameters there is none"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "without/edits.toml"));
}

TEST_F(LoopsTest, ChangesThatDoNotFitAreRefusedWithTheReason) {
    const auto said = [&](const std::string& options) {
        const test::Outcome outcome = run("bad", options);
        EXPECT_NE(outcome.status, 0) << options;
        EXPECT_FALSE(std::filesystem::exists(folder_ / "bad")) << options;
        return outcome.output;
    };
    EXPECT_THAT(said("--set 'registration.edits=slip 50@1234567'"),
                HasSubstr("is of another tour"));
    EXPECT_THAT(said("--set 'registration.edits=slip fifty'"), HasSubstr("change 1: found"));
    EXPECT_THAT(said("--edits " + file("more.toml", "[filter]\nparticles = 3\n")),
                HasSubstr("sets filter.particles too"));
    EXPECT_THAT(said("--edits " + file("bad.toml", "[registration]\nedits = \"open 3\"\n")),
                HasSubstr("bad.toml:2: registration.edits: change 1"));
    EXPECT_THAT(said("--edits " + path("nowhere.toml")), HasSubstr("nowhere.toml"));
    EXPECT_THAT(said("--edits " + file("slip.toml", "[registration]\nedits = \"slip 3\"\n") +
                     " --set motion.model=odometry"),
                HasSubstr("with these parameters there is none"));
    EXPECT_THAT(said("--set 'registration.edits=slip 99999'"), HasSubstr("it names scan 99999"));
    EXPECT_THAT(said("--edits " + file("none.toml", "[registration]\nedits = \"# none\"\n")),
                HasSubstr("has no change by hand"));
    EXPECT_THAT(said("--edits " + file("slip.toml", "[registration]\nedits = \"slip 3\"\n") +
                     " --set 'registration.edits=slip 4'"),
                HasSubstr("give one of them"));
    // Another tour of the same pace, whose scans have the same stamps.
    ASSERT_EQ(run("made", "--set 'registration.edits=slip 50'").status, 0);
    const std::string other = path("other.log");
    ASSERT_EQ(
        test::shell(cli_ + " simulate recinto --seed 4 --format carmen --out " + other).status, 0);
    for (const std::string& from : {"--preset recorded --edits " + path("made/edits.toml"),
                                    "--config " + path("made/config.cfg")}) {
        const test::Outcome refused =
            test::shell(fmt::format("{} run {} --out {} {}", cli_, other, path("bad"), from));
        EXPECT_NE(refused.status, 0);
        EXPECT_THAT(refused.output, HasSubstr("scan 50 was another one when it was made"));
    }
    // One that lies on nothing is closed, and told.
    const test::Outcome absurd = run("absurd", "--set 'registration.edits=close 400 20 50 0 0'");
    EXPECT_EQ(absurd.status, 0);
    EXPECT_THAT(absurd.output, HasSubstr("lie on hardly anything that the earlier passage saw "
                                         "(scan 400)"));
    EXPECT_THAT(absurd.output, HasSubstr("by hand 1 loop closed"));
    // What meets nothing changes nothing, and is told.
    const test::Outcome told = run("unmet", "--set 'registration.edits=refuse 200 3'");
    EXPECT_EQ(told.status, 0);
    EXPECT_THAT(told.output, HasSubstr("Changes by hand have met nothing to change (no. 1"));
    EXPECT_EQ(quality_of("unmet")["by_hand"]["met_nothing"], 1);
}

}  // namespace
}  // namespace hitos
