// SPDX-License-Identifier: GPL-3.0-or-later
// hitos-cli graph as a user calls it.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "command_test.hpp"
#include "hitos/services/files/g2o_file.hpp"

namespace hitos::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

/// A square that its odometry leaves open, seen closed, beside two points and what is not known.
constexpr const char* kSquare =
    "VERTEX_SE2 1 0 0 0\n"
    "VERTEX_SE2 2 1 0 1.7\n"
    "VERTEX_SE2 3 1 1.2 -3\n"
    "VERTEX_SE2 4 0.1 1.2 -1.5\n"
    "VERTEX_XY 10 2 2\n"
    "VERTEX_TAG 12 1 1\n"
    "EDGE_SE2 1 2 1 0 1.5707963267948966 100 0 0 100 0 400\n"
    "EDGE_SE2 2 3 1 0 1.5707963267948966 100 0 0 100 0 400\n"
    "EDGE_SE2 3 4 1 0 1.5707963267948966 100 0 0 100 0 400\n"
    "EDGE_SE2 4 1 1 0 1.5707963267948966 100 0 0 100 0 400\n"
    "EDGE_SE2_XY 1 10 2 2 100 0 100\n"
    "EDGE_SE2_XY 3 10 -1 -1 100 0 100\n";

class GraphCommand : public CommandTest {
  protected:
    GraphCommand() : CommandTest("graph") {}
    std::string square() const { return file("square.g2o", kSquare); }
};

TEST_F(GraphCommand, SolvesDrawsAndWrites) {
    const json told = object(square() + " --out " + path("out"));
    EXPECT_EQ(told.at("VERTEX_SE2"), 4);
    EXPECT_EQ(told.at("EDGE_SE2_XY"), 2);
    EXPECT_EQ(told.at("unread"), (json{{"VERTEX_TAG", 1}}));
    EXPECT_EQ(told.at("held"), json::array({1}));
    EXPECT_GT(told.at("chi_square_before"), 1.0);
    EXPECT_LT(told.at("chi_square_after"), 1e-9) << "all its edges fit";
    EXPECT_TRUE(told.at("converged"));
    EXPECT_EQ(told.at("worst").size(), 6U);
    const PlanarGraph solved = read_g2o(path("out/graph.g2o")).graph;
    EXPECT_NEAR(solved.vertices[3].at(0), 0.0, 1e-6);
    EXPECT_NEAR(solved.vertices[3].at(1), 1.0, 1e-6);
    EXPECT_EQ(solved.vertices[4].id, 10U);
    EXPECT_EQ(g2o_text(solved), content(path("out/graph.g2o")));
    EXPECT_THAT(content(path("out/graph.svg")), Not(HasSubstr("the greatest error"))) << "as none";
    EXPECT_EQ(content(path("out/graph.png")).substr(1, 3), "PNG");
    const Outcome words = call(square());
    EXPECT_THAT(words.output, HasSubstr("VERTEX_SE2 4\n"));
    EXPECT_THAT(words.output, HasSubstr("1 line of VERTEX_TAG is passed over, and not written"));
    EXPECT_THAT(words.output, HasSubstr("nothing is fixed in 1 part: held is vertex 1"));
}

TEST_F(GraphCommand, MarksWhatIsOff) {
    const std::string wrong = square() + " --edits " + file("false", "close 3 1 5 5 0\n");
    EXPECT_EQ(call(wrong + " --out " + path("out")).status, 0);
    EXPECT_THAT(content(path("out/graph.svg")), HasSubstr("the 7 edges of the greatest errors"));
}

TEST_F(GraphCommand, DoubtsDegreesAndEdgesThatAreFarFromWhatTheySay) {
    EXPECT_THAT(call(square()).output, Not(HasSubstr("warning: Solved")));
    std::string degrees = kSquare;
    for (std::size_t at = 0; (at = degrees.find("1.5707963267948966", at)) != std::string::npos;)
        degrees.replace(at, 18, "90");
    const std::string told = call(file("degrees.g2o", degrees)).output;
    EXPECT_THAT(told, HasSubstr("warning: Of the edges 4/6 turn by more than a whole turn"));
    EXPECT_THAT(told, HasSubstr("are these degrees?"));
    EXPECT_THAT(told, HasSubstr("times as far off as their information says"));
}

TEST_F(GraphCommand, WritesTheSameBytesAgain) {
    call(square() + " --out " + path("one"));
    call(square() + " --out " + path("two"));
    EXPECT_EQ(files("one"), files("two"));
    EXPECT_EQ(files("one").size(), 4U);
}

TEST_F(GraphCommand, PutsNothingInThePlaceOfAGraph) {
    const std::string arguments =
        square() + " --edits " + file("false", "close 3 1 5 5 0\n") + " --out " + path("out");
    EXPECT_EQ(call(arguments).status, 0);
    const auto before = files("out");
    refused(arguments + " --robust", "say --replace to put this graph in its place");
    EXPECT_EQ(files("out"), before);
    EXPECT_EQ(call(arguments + " --worst 0 --replace").status, 0);
    EXPECT_NE(files("out"), before);
    refused(path("out/graph.g2o") + " --replace --out " + path("out"), "graph.g2o");
}

TEST_F(GraphCommand, TakesChangesByHand) {
    const std::string edits = file("edits", "refuse 4 1  # no loop\nfix 4 0 3 -1.57\nslip 3\n");
    const json told = object(square() + " --edits " + edits + " --out " + path("out"));
    EXPECT_EQ(told.at("edits"), 3);
    EXPECT_EQ(told.at("EDGE_SE2"), 3);
    EXPECT_EQ(told.at("EDGE_PRIOR_SE2"), 1);
    EXPECT_THAT(content(path("out/graph.g2o")), HasSubstr("EDGE_PRIOR_SE2 4 0 3 -1.57 10000"));
    EXPECT_EQ(
        content(path("out/edits.txt")),
        "# Changes by hand of square.g2o\n\nrefuse 4 1  # no loop\nfix 4 0 3 -1.57\nslip 3\n");
    call(square() + " --edits " + path("out/edits.txt") + " --out " + path("again"));
    EXPECT_EQ(files("again"), files("out"));
    EXPECT_THAT(
        test::shell(cli_ + " graph " + square() + " --edits " + file("none", "# nothing\n")).output,
        HasSubstr("none: has no change by hand"));
    refused(square() + " --edits " + file("other", "slip 7\n"),
            "/other:1: change 1: the graph has no pose with the id 7");
    refused(square() + " --edits " + file("wrong", "slip 3; slip 2\n# no\nmove 7\n"),
            "/wrong:3: change 3: found \"move 7\"; expected");
    refused(square() + " --edits " + file("twice", "\nslip 3\nslip 3\n"),
            "/twice:3: change 2: is of the same poses as change 1");
    const std::string marked = file("marked", "\xef\xbb\xbfslip 3\r\n");
    EXPECT_EQ(object(square() + " --edits " + marked).at("edits"), 1);
}

TEST_F(GraphCommand, RefusesWhatIsNoGraph) {
    refused(file("wrong.g2o", "VERTEX_SE2 1 0 0\n"), "wrong.g2o:1: found 3 fields");
    refused(path("none.g2o"), "no such file");
    refused(log_, "no pose in the file");
    refused(file("no.g2o", "VERTEX_SE2 0 0 0 0\n") + " --out " + file("taken", ""), "taken");
}

TEST_F(GraphCommand, WritesNothingThatItWouldNotRead) {
    const std::string far = file("far.g2o",
                                 "VERTEX_SE2 1 0 0 0\nVERTEX_SE2 2 0 0 0\nVERTEX_SE2 3 0 0 0\n"
                                 "EDGE_SE2 1 2 9e11 0 0 1 0 0 1 0 1\n"
                                 "EDGE_SE2 2 3 9e11 0 0 1 0 0 1 0 1\n");
    EXPECT_EQ(call(far).status, 0);
    refused(far + " --out " + path("far"), "\"VERTEX_SE2 3\" would go on with 1.8e+12");
    EXPECT_FALSE(std::filesystem::exists(path("far")));
}

TEST_F(GraphCommand, LeavesNoFolderThatItMadeForNothing) {
    const std::string broken = file("broken.g2o", "VERTEX_SE2 1 0 0\n");
    refused(broken + " --out " + path("new"), "broken.g2o:1");
    EXPECT_FALSE(std::filesystem::exists(path("new")));
    std::filesystem::create_directory(path("old"));
    refused(broken + " --out " + path("old"), "broken.g2o:1");
    EXPECT_TRUE(std::filesystem::exists(path("old"))) << "somebody else made it";
}

TEST_F(GraphCommand, ReadsTheGraphOfARun) {
    ASSERT_EQ(shell(cli_ + " run corridor --set filter.particles=10 --write g2o --out " +
                    path("run") + " 2>&1")
                  .status,
              0);
    // A run's results stay what they were.
    refused(square() + " --replace --out " + path("run"), "holds the results of a run");
    const json told = object(path("run/graph.g2o"));
    EXPECT_GT(told.at("VERTEX_LINE2D"), 0);
    EXPECT_TRUE(told.at("unread").empty());
    EXPECT_TRUE(told.at("converged"));
    EXPECT_LE(told.at("chi_square_after"), told.at("chi_square_before"));
}

}  // namespace
}  // namespace hitos::test
