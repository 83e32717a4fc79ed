// SPDX-License-Identifier: GPL-3.0-or-later
// hitos-cli: a tour that goes on with the map of an earlier run, or is localised in it.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <iterator>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "program.hpp"

namespace hitos {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

/// A lap round the angular hall, and a second tour of a part of it with a box in the way.
class SecondTourTest : public test::ProgramTest {
  protected:
    void SetUp() override {
        test::ProgramTest::SetUp();
        const std::string building = test::content(test::kSource + "/data/worlds/complex.toml");
        const std::string walls = building.substr(0, building.find("[tour]"));
        const auto write = [&](const char* name, const std::string& box, const char* tour) {
            std::string text = walls;
            text.insert(text.find("    [["), box);
            file(name, text + tour);
        };
        write("first.toml", "", R"([tour]
start = [0, 0, 0]
way_points = [[0.5, 7.5], [20.5, 7.5], [20.5, 17.5], [37.5, 17.5], [37.5, 0.5], [0.5, 0.5]]
[laser]
max_range = 30
rate = 2
)");
        write("second.toml", "    [[10, -1], [10, -0.4], [12, -0.4], [12, -1]],\n", R"([tour]
start = [37.5, 12, 90]
way_points = [[37.5, 0.5], [0.5, 0.5], [0.5, 7.5]]
[laser]
max_range = 30
rate = 2
)");
        const test::Outcome first = run("first.toml", "first", "--preset recorded" + few_);
        ASSERT_EQ(first.status, 0) << first.output;
    }
    test::Outcome run(const std::string& log, const std::string& folder,
                      const std::string& options) const {
        return test::shell(cli_ + " run " + path(log) + " --replace --out " + path(folder) + " " +
                           options);
    }
    json summary_of(const std::string& folder) const {
        return json::parse(test::content(folder_ / folder / "summary.json"));
    }
    std::string content(const std::string& file) const { return test::content(folder_ / file); }
    std::string map() const { return " --map " + path("first"); }

    const std::string few_ = " --set filter.particles=5";
};

TEST_F(SecondTourTest, IsLocalisedInAMapThatStaysAsItIs) {
    const test::Outcome told = run("second.toml", "out", map() + " --localise --write map-server");
    ASSERT_EQ(told.status, 0) << told.output;
    EXPECT_THAT(told.output, HasSubstr("found in the map after "));
    EXPECT_THAT(told.output, Not(HasSubstr("warning")));
    const std::string of_first = "--preset recorded" + few_ + " --write map-server";
    ASSERT_EQ(run("first.toml", "alone", of_first).status, 0);
    EXPECT_TRUE(content("out/map.pgm") == content("alone/map.pgm")) << "of the map's tour alone";
    // Of scans in which nobody looks for walls nothing is said.
    EXPECT_LT(summary_of("out")["suitability"]["empty"], 0.05);
    EXPECT_EQ(content("out/map.txt"), content("first/map.txt"));
    const json first = summary_of("first");
    const json quality = summary_of("out")["quality"];
    const json tour = quality["later_tours"][0];
    EXPECT_EQ(tour["begin"], first["scans"].get<int>() + 1);
    EXPECT_GT(tour["found"], tour["begin"]);
    EXPECT_LT(tour["found_after_m"], 40.0);
    EXPECT_LT(quality["largest_correction_m"], 1.0);
    // The first tour's path is the one that it was, the second's begins where it did.
    const std::string path = content("out/trajectory.tum");
    EXPECT_TRUE(path.starts_with(content("first/trajectory.tum")));
    EXPECT_THAT(path.substr(content("first/trajectory.tum").size()), HasSubstr(" 37."));
    // The box, at y = -1 to -0.4, and nothing else.
    const std::string changes = content("out/changes.csv");
    EXPECT_THAT(changes, HasSubstr("\nnew,"));
    EXPECT_THAT(changes, Not(HasSubstr("\ngone,")));

    const test::Outcome verified = test::shell(cli_ + " verify " + this->path("out"));
    EXPECT_EQ(verified.status, 0) << verified.output;
    const std::string before = content("out/trajectory.tum");
    ASSERT_EQ(test::shell(cli_ + " run " + this->path("second.toml") + " --config " +
                          this->path("out/config.cfg") + " --out " + this->path("again"))
                  .status,
              0);
    EXPECT_EQ(content("again/trajectory.tum"), before) << "its configuration says all of it";

    // The map of a run that held a map is that map.
    ASSERT_EQ(run("second.toml", "third", " --map " + this->path("out") + " --localise").status, 0);
    EXPECT_EQ(content("third/trajectory.tum"), before);
}

TEST_F(SecondTourTest, GoesOnWithTheMap) {
    const test::Outcome told = run("second.toml", "out", map() + " --write g2o");
    ASSERT_EQ(told.status, 0) << told.output;
    EXPECT_THAT(told.output, HasSubstr("found in the map after "));
    // Nothing was driven from the last scan of the first tour to the first one of the second.
    const int begin = summary_of("first")["scans"].get<int>();
    const auto step = [](int to) { return fmt::format("\nEDGE_SE2 {} {} ", to - 1, to); };
    EXPECT_THAT(content("out/graph.g2o"), HasSubstr(step(begin - 1)));
    EXPECT_THAT(content("out/graph.g2o"), Not(HasSubstr(step(begin))));
    EXPECT_THAT(content("out/graph.g2o"), HasSubstr(step(begin + 1)));
    EXPECT_NE(content("out/map.txt"), content("first/map.txt"));
    const json summary = summary_of("out");
    EXPECT_GT(summary["scans"], summary_of("first")["scans"].get<int>() + 50);
    EXPECT_THAT(content("out/config.cfg"), HasSubstr("map = \"" + path("first")));
    // Each tour has a way of its own, none leads from the first one's end to the second's begin.
    const auto ways = [this](const std::string& file) {
        const std::string drawing = content(file);
        const std::regex way(R"(LWPOLYLINE\s+5\s+\w+\s+100\s+AcDbEntity\s+8\s+PATH\s)");
        return std::distance(std::sregex_iterator(drawing.begin(), drawing.end(), way), {});
    };
    EXPECT_EQ(ways("first/map.dxf"), 1);
    EXPECT_EQ(ways("out/map.dxf"), 2);
}

TEST_F(SecondTourTest, HoldsTheMapThatTwoToursHaveMade) {
    ASSERT_EQ(run("second.toml", "both", map()).status, 0);
    const test::Outcome told = run("first.toml", "out", " --localise --map " + path("both"));
    ASSERT_EQ(told.status, 0) << told.output;
    EXPECT_EQ(content("out/map.txt"), content("both/map.txt"));
    const json tours = summary_of("out")["quality"]["later_tours"];
    ASSERT_EQ(tours.size(), 2U);
    for (const json& tour : tours) EXPECT_TRUE(tour.contains("found"));
    EXPECT_THAT(told.output, Not(HasSubstr("other parameters")));
    // A run that holds a map reads its own folder's configuration too.
    const test::Outcome circle = run("first.toml", "out", " --localise --map " + path("out"));
    EXPECT_NE(circle.status, 0);
    EXPECT_THAT(circle.output, HasSubstr("is read by this very command"));
}

TEST_F(SecondTourTest, ChangesByHandAreAddedToThoseThatTheMapHas) {
    file("slip.toml", "[registration]\nedits = \"slip 12 # a wet floor\"\n");
    ASSERT_EQ(
        run("first.toml", "mended", "--preset recorded" + few_ + " --edits " + path("slip.toml"))
            .status,
        0);
    const int scans = summary_of("mended")["scans"].get<int>();
    file("own.toml", "[registration]\nedits = \"slip " + std::to_string(scans + 20) + "\"\n");
    const std::string mended = " --map " + path("mended");
    const test::Outcome told =
        run("second.toml", "out", mended + " --localise --edits " + path("own.toml"));
    ASSERT_EQ(told.status, 0) << told.output;
    EXPECT_EQ(content("out/map.txt"), content("mended/map.txt"));
    EXPECT_THAT(told.output, Not(HasSubstr("other parameters")));
    EXPECT_THAT(told.output, HasSubstr("changes by hand from no. 2 on are those of the map of "));
    const std::string both = content("out/edits.toml");
    EXPECT_THAT(both, HasSubstr("slip 12"));
    EXPECT_THAT(both, HasSubstr("slip " + std::to_string(scans + 20)));
    ASSERT_EQ(run("second.toml", "again", mended + " --localise --edits " + path("out/edits.toml"))
                  .status,
              0);
    EXPECT_EQ(content("again/trajectory.tum"), content("out/trajectory.tum"));
    EXPECT_EQ(content("again/edits.toml"), both);
    // What is said of a change names it by its number in the file.
    file("own.toml", "[registration]\nedits = \"slip " + std::to_string(scans + 20) + "; refuse " +
                         std::to_string(scans + 40) + " " + std::to_string(scans + 3) + "\"\n");
    const test::Outcome unmet = run("second.toml", "out", mended + " --edits " + path("own.toml"));
    EXPECT_THAT(unmet.output, HasSubstr("met nothing to change (no. 2 of the list)"));
    EXPECT_THAT(unmet.output, HasSubstr("changes by hand from no. 3 on are those of the map of "));
    file("own.toml", "[registration]\nedits = \"slip 12@1234567\"\n");
    EXPECT_THAT(run("second.toml", "out", mended + " --edits " + path("own.toml")).output,
                HasSubstr("change 1 is of another tour"));
    // Of the same scans only one can be so: the file's. And plain lines will do.
    file("fix.toml", "[registration]\nedits = \"slip 12; fix 20 0.5 0.1 0\"\n");
    ASSERT_EQ(
        run("first.toml", "fixed", "--preset recorded" + few_ + " --edits " + path("fix.toml"))
            .status,
        0);
    file("own.txt", "fix 20 0.6 0.1 0\n");
    const test::Outcome other =
        run("second.toml", "out", " --map " + path("fixed") + " --edits " + path("own.txt"));
    ASSERT_EQ(other.status, 0) << other.output;
    EXPECT_THAT(other.output, HasSubstr("changes by hand from no. 2 on are those of the map of "));
    const std::string taken = content("out/edits.toml");
    EXPECT_THAT(taken, HasSubstr(" 0.6 0.1 0"));
    EXPECT_THAT(taken, HasSubstr("slip 12"));
    EXPECT_THAT(taken, Not(HasSubstr(" 0.5 0.1 0")));
    // From standard input, which can be read once, too.
    const test::Outcome piped =
        run("second.toml", "piped", " --map " + path("fixed") + " --edits - < " + path("own.txt"));
    ASSERT_EQ(piped.status, 0) << piped.output;
    EXPECT_EQ(content("piped/edits.toml"), taken);
}

TEST_F(SecondTourTest, ChangesOfAMapThatIsHeldAreRefused) {
    file("slip.toml", "[registration]\nedits = \"slip 12\"\n");
    const std::string edits = " --edits " + path("slip.toml");
    const test::Outcome held = run("second.toml", "out", map() + " --localise" + edits);
    EXPECT_NE(held.status, 0);
    EXPECT_THAT(held.output, HasSubstr("\"slip 12\" is of the map of "));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out" / "summary.json"));
    const test::Outcome joined = run("second.toml", "out", map() + edits);
    EXPECT_EQ(joined.status, 0) << joined.output;
    EXPECT_THAT(joined.output, HasSubstr("is another one: registration.edits\n"));
}

TEST_F(SecondTourTest, AScanIsSaidToBeWhereTheHeldMapHasAKey) {
    ASSERT_EQ(run("second.toml", "found", map() + " --localise").status, 0);
    const int begin = summary_of("first")["scans"].get<int>();
    // Of five scans in a row at least one is no key of the map, and the one that is named instead
    // is.
    const auto close = [&](int earlier) {
        file("close.toml", "[registration]\nedits = \"close " + std::to_string(begin + 120) + " " +
                               std::to_string(earlier) + " 0 0 0\"\n");
        return run("second.toml", "out", map() + " --localise --edits " + path("close.toml"));
    };
    int refused = 0;
    for (int earlier = 300; earlier < 305; ++earlier) {
        const std::string said = close(earlier).output;
        const std::size_t at = said.find("; name scan ");
        if (at == std::string::npos) continue;
        ++refused;
        const test::Outcome taken = close(std::stoi(said.substr(at + 12)));
        EXPECT_EQ(taken.status, 0) << taken.output;
        EXPECT_EQ(content("out/map.txt"), content("first/map.txt"));
        break;
    }
    EXPECT_EQ(refused, 1);
}

TEST_F(SecondTourTest, TellsAMapThatIsMadeOtherwise) {
    const test::Outcome told = run("second.toml", "out", map() + " --seed 7");
    EXPECT_EQ(told.status, 0) << told.output;
    EXPECT_THAT(told.output, HasSubstr("is another one: run.seed\n"));
}

/// Whatever its file is called.
TEST_F(SecondTourTest, TellsThatTheTourIsTheMapsOwn) {
    file("copy.toml", content("first.toml"));
    for (const char* log : {"first.toml", "copy.toml"}) {
        const test::Outcome told = run(log, "out", map());
        EXPECT_EQ(told.status, 0) << told.output;
        EXPECT_THAT(told.output, HasSubstr("warning: This is the tour that the map of"));
    }
    // With other noise it is another one.
    const test::Outcome other = run("first.toml", "out", map() + " --set source.tour_seed=7");
    EXPECT_EQ(other.status, 0) << other.output;
    EXPECT_THAT(other.output, Not(HasSubstr("This is the tour")));
}

// Where two tours do not lie in one frame no distance is one.
TEST_F(SecondTourTest, OneThatIsNotFoundIsNotMeasured) {
    ASSERT_EQ(test::shell(cli_ + " simulate " + path("first.toml") + " --truth " +
                          path("truth.tum") + " --out " + path("first.log"))
                  .status,
              0);
    const std::string reference = " --reference-trajectory " + path("truth.tum");
    const test::Outcome told = run("second.toml", "lost", map() + " --near 200,200,0" + reference);
    ASSERT_EQ(told.status, 0) << told.output;
    EXPECT_THAT(told.output, HasSubstr("was not found in the map"));
    EXPECT_THAT(told.output, HasSubstr("a tour that was not found lies beside the map"));
    const json first = summary_of("first");
    const json lost = summary_of("lost");
    EXPECT_EQ(lost["trajectory_error"]["poses"], first["scans"]);
    EXPECT_LT(lost["trajectory_error"]["ate_rmse_m"], 0.3);
    const test::Outcome measured = test::shell(cli_ + " evaluate " + path("lost") + reference);
    ASSERT_EQ(measured.status, 0) << measured.output;
    EXPECT_THAT(measured.output, HasSubstr("of the path are left out"));
    EXPECT_THAT(measured.output, HasSubstr("poses " + std::to_string(first["scans"].get<int>())));
}

TEST_F(SecondTourTest, TellsWhatItCannotGoOnWith) {
    const auto expect = [&](const std::string& options, const std::string& words) {
        const test::Outcome told = run("second.toml", "out", options);
        EXPECT_NE(told.status, 0) << options;
        EXPECT_THAT(told.output, HasSubstr(words)) << options;
        EXPECT_FALSE(std::filesystem::exists(folder_ / "out" / "summary.json"));
    };
    expect(" --map " + path("nothing"), "holds no results of a run");
    expect("--localise", "--localise requires --map");
    expect(map() + " --near 1,2", "expected a pose in the map as \"x,y,degrees\"");
    expect(map() + " --preset thesis", "source.map: only registration finds the robot");
    expect(map() + " --localise --set filter.algorithm=graph-slam", "source.hold: ");
    // Results that would be their own map.
    const test::Outcome circle = run("second.toml", "first", map());
    EXPECT_NE(circle.status, 0);
    EXPECT_THAT(circle.output, HasSubstr("is read by this very command"));
    file("empty.log", "# nothing\n");
    const test::Outcome empty = run("empty.log", "out", map());
    EXPECT_NE(empty.status, 0);
    EXPECT_THAT(empty.output, HasSubstr("empty.log"));
    // The log of the map is another one now.
    const std::string log = content("first.toml");
    file("first.toml", log.substr(0, log.find("rate = 2")) + "rate = 1\n");
    expect(map(), "the log has changed; run it again");
    file("first/config.cfg", "[source]\nmap = 3\n");
    file("first/summary.json", "{}");  // of before it named the files
    expect(map(), "config.cfg:2");
}

TEST_F(SecondTourTest, TellsAFolderThatWasChanged) {
    for (const std::string name : {"config.cfg", "map.txt", "trajectory.tum"}) {
        const std::string before = content("first/" + name);
        file("first/" + name, before + "# mine\n");
        const test::Outcome told = run("second.toml", "out", map());
        EXPECT_EQ(told.status, 1) << name;
        EXPECT_THAT(told.output,
                    HasSubstr("first/" + name + ": is not the file that summary.json beside it"));
        file("first/" + name, before);
    }
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out" / "summary.json"));
    std::filesystem::remove(folder_ / "first/summary.json");
    EXPECT_THAT(run("second.toml", "out", map()).output, HasSubstr("it has no summary.json"));
}

TEST_F(SecondTourTest, ACircleOfMapsIsTold) {
    std::string text = content("first/config.cfg");
    const std::string none = "\nmap = \"\"";
    ASSERT_NE(text.find(none), std::string::npos);
    text.replace(text.find(none), none.size(), "\nmap = \"" + path("first") + '"');
    file("first/config.cfg", text);
    file("first/summary.json", "{}");  // of before it named the files
    const test::Outcome told = run("second.toml", "out", map());
    EXPECT_NE(told.status, 0);
    EXPECT_THAT(told.output, HasSubstr("circle of them"));
}

}  // namespace
}  // namespace hitos
