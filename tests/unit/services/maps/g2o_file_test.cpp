// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/files/g2o_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <string_view>

#include "hitos/base/error.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using test::message_of;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using VertexKind = PlanarVertex::Kind;
using EdgeKind = PlanarEdge::Kind;

constexpr std::string_view kEveryTag =
    "VERTEX_SE2 0 0 0 0\n"
    "VERTEX_SE2 9223372036854775807 1 0.5 0.25\n"
    "VERTEX_LINE2D 2 1.5707963267948966 2 -1 3\n"
    "VERTEX_XY 3 -1 2\n"
    "FIX 0\n"
    "EDGE_SE2 0 9223372036854775807 1 0.5 0.25 1 0.5 0 1 0 1\n"
    "EDGE_SE2_LINE2D 9223372036854775807 2 1.25 1.5 2 0 4\n"
    "EDGE_SE2_XY 0 3 -1 2 4 0 2\n"
    "EDGE_PRIOR_SE2 0 0 0 0 1 0 0 1 0 1e-300\n"
    "EDGE_PRIOR_SE2_XY 0 0.1 0.30000000000000004 1 0 1\n"
    "EDGE_PRIOR_XY 3 -1 2 1 0.1 1\n";

G2oFile parsed(std::string_view text) {
    return parse_g2o(text, "some.g2o");
}

std::string refusal(std::string_view text) {
    return message_of<FormatError>([&] { parsed(text); });
}

TEST(G2oFile, ReadsBackWhatItWritesToTheLastBit) {
    const G2oFile file = parsed(kEveryTag);
    EXPECT_EQ(g2o_text(file.graph), kEveryTag);
    EXPECT_TRUE(file.unread.empty());
}

TEST(G2oFile, ReadsEveryTag) {
    const PlanarGraph graph = parsed(kEveryTag).graph;
    ASSERT_EQ(graph.vertices.size(), 4U);
    EXPECT_EQ(graph.vertices[1].pose(), (Pose{1.0, 0.5, 0.25}));
    EXPECT_EQ(graph.vertices[2].kind, VertexKind::line);
    EXPECT_EQ(graph.vertices[2].at(1), 2.0) << "rho";
    EXPECT_EQ(graph.vertices[2].ends[1], 3);
    EXPECT_EQ(graph.vertices[3].point(), (Point2{-1.0, 2.0}));
    EXPECT_TRUE(graph.vertices[0].fixed);
    EXPECT_FALSE(graph.vertices[1].fixed);
    ASSERT_EQ(graph.edges.size(), 6U);
    EXPECT_EQ(graph.edges[0].to, 1U);
    EXPECT_EQ(graph.edges[0].information(1, 0), 0.5);
    EXPECT_EQ(graph.edges[1].kind, EdgeKind::line);
    EXPECT_EQ(graph.edges[1].from, 1U);
    EXPECT_EQ(graph.edges[2].information(1, 1), 2.0);
    for (std::size_t i = 3; i < 6; ++i) EXPECT_TRUE(graph.edges[i].prior()) << i;
    EXPECT_EQ(graph.edges[5].to, 3U);
}

TEST(G2oFile, TakesLinesInAnyOrder) {
    const PlanarGraph graph = parsed(
                                  "\xef\xbb\xbf# a graph\r\n"
                                  "FIX 7 5\r\n"
                                  "EDGE_SE2 7 5 1 0 0 1 0 0 1 0 1 # back\r\n"
                                  "\r\n"
                                  "VERTEX_SE2 5 1 0 +0\r\n"
                                  "VERTEX_SE2 7 0 0 0")
                                  .graph;
    ASSERT_EQ(graph.edges.size(), 1U);
    EXPECT_EQ(graph.edges[0].from, 1U);
    EXPECT_EQ(graph.edges[0].to, 0U);
    EXPECT_TRUE(graph.vertices[0].fixed);
    EXPECT_TRUE(graph.vertices[1].fixed);
}

TEST(G2oFile, CountsWhatItPassesOver) {
    std::string text =
        "VERTEX_SE2 0 0 0 0\nVERTEX_SE3:QUAT 1 0 0 0 0 0 0 1\nVERTEX_SE3:QUAT 2\nODOM x\n";
    const G2oFile file = parsed(text);
    ASSERT_EQ(file.unread.size(), 2U);
    EXPECT_EQ(file.unread[0].tag, "VERTEX_SE3:QUAT");
    EXPECT_EQ(file.unread[0].lines, 2U);
    EXPECT_EQ(file.unread[1].lines, 1U);
    for (int i = 0; i < 100; ++i) text += "T" + std::to_string(i) + "\n";
    const auto many = parsed(text).unread;
    EXPECT_EQ(many.size(), 32U);
    EXPECT_EQ(many.back().tag, "others");
    EXPECT_EQ(many.back().lines, 71U);
}

TEST(G2oFile, RefusesAFileWithoutPoses) {
    EXPECT_THAT(refusal(""), HasSubstr("some.g2o: no pose in the file; expected"));
    EXPECT_THAT(refusal("VERTEX_SE3:QUAT 1 0 0 0 0 0 0 1\n"),
                HasSubstr("no pose in the file, and lines \"VERTEX_SE3:QUAT\"; expected a graph of "
                          "the plane"));
    EXPECT_THAT(refusal("VERTEX_XY 0 0 0\n"), HasSubstr("no pose"));
}

TEST(G2oFile, SaysWhatIsWrongWithALine) {
    const std::string two = "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 0 0 0\nVERTEX_XY 2 0 0\n";
    const auto fourth = [&](const std::string& line) { return refusal(two + line); };
    EXPECT_THAT(fourth("VERTEX_SE2 4 0 0"),
                StartsWith("some.g2o:4: found 3 fields; expected 4 numbers, id x y theta"));
    EXPECT_THAT(fourth("EDGE_SE2 0 1 0 0 0 1 0 0 1 0"), HasSubstr("found 10 fields; expected 11"));
    EXPECT_THAT(fourth("VERTEX_LINE2D 4 0 0"), HasSubstr("id theta rho p1 p2"));
    EXPECT_THAT(fourth("FIX"), HasSubstr("found 0 fields"));
    EXPECT_THAT(fourth("VERTEX_XY 4 0 zero"), HasSubstr("y is \"zero\"; expected a finite number"));
    EXPECT_THAT(fourth("VERTEX_XY 4 0 nan"), HasSubstr("y is \"nan\""));
    EXPECT_THAT(fourth("VERTEX_XY 4 inf 0"), HasSubstr("x is \"inf\""));
    EXPECT_THAT(fourth("VERTEX_XY 4 0,5 0"), HasSubstr("with a decimal comma"));
    EXPECT_THAT(fourth("VERTEX_XY 4 1e13 0"), HasSubstr("from -1e+12 to 1e+12"));
    EXPECT_THAT(fourth("VERTEX_XY -4 0 0"),
                HasSubstr("id is \"-4\"; expected a whole number from 0 to 9223372036854775807"));
    EXPECT_THAT(fourth("VERTEX_XY 9223372036854775808 0 0"), HasSubstr("expected a whole number"));
    EXPECT_THAT(fourth("VERTEX_XY 1.0 0 0"), HasSubstr("expected a whole number"));
    EXPECT_THAT(fourth("VERTEX_XY 1 0 0"),
                StartsWith("some.g2o:4: vertex 1 is there already, in line 2"));
    EXPECT_THAT(fourth("EDGE_SE2 1 1 0 0 0 1 0 0 1 0 1"), HasSubstr("from vertex 1 to itself"));
    EXPECT_THAT(fourth("EDGE_SE2 1 5 0 0 0 1 0 0 1 0 1\n\n"),
                StartsWith("some.g2o:4: names vertex 5, which the file does not have"));
    EXPECT_THAT(fourth("FIX 0 6"), StartsWith("some.g2o:4: names vertex 6"));
    EXPECT_THAT(fourth("EDGE_PRIOR_XY 6 0 0 1 0 1"), HasSubstr("names vertex 6"));
    EXPECT_THAT(fourth("EDGE_SE2 1 2 0 0 0 1 0 0 1 0 1"),
                HasSubstr("vertex 2 is of VERTEX_XY; expected one of VERTEX_SE2"));
    EXPECT_THAT(fourth("EDGE_SE2_XY 2 0 0 0 1 0 1"),
                HasSubstr("vertex 0 is of VERTEX_SE2; expected one of VERTEX_XY"));
    EXPECT_THAT(fourth("EDGE_SE2_LINE2D 0 2 0 0 1 0 1"),
                HasSubstr("expected one of VERTEX_LINE2D"));
    EXPECT_THAT(fourth("EDGE_SE2 0 1 0 0 0 1 2 0 1 0 1"),
                HasSubstr("the information has the eigenvalue -1; expected none below 0"));
    EXPECT_THAT(fourth("EDGE_SE2_XY 0 2 0 0 1 0 -1"), HasSubstr("the eigenvalue -1"));
    // However great the others are.
    EXPECT_THAT(fourth("EDGE_SE2_XY 0 2 0 0 1e12 0 -0.5"), HasSubstr("the eigenvalue -0.5"));
    EXPECT_THAT(fourth("EDGE_SE2_XY 0 2 0 0 1 0 1e19"), HasSubstr("I22 is \"1e19\""));
}

TEST(G2oFile, TakesInformationThatIsSingular) {
    const auto graph = parsed(
                           "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 0 0 0\n"
                           "EDGE_SE2 0 1 0 0 0 1 1 0 1 0 0\n"
                           "EDGE_SE2 0 1 0 0 0 0 0 0 0 0 0\n")
                           .graph;
    EXPECT_EQ(graph.edges.size(), 2U);
}

TEST(G2oFile, RefusesToWriteWhatItWouldNotRead) {
    const PlanarGraph graph = parsed(kEveryTag).graph;
    const auto written = [&](auto change) {
        PlanarGraph other = graph;
        change(other);
        return message_of<Error>([&] { g2o_text(other); });
    };
    for (const double y : {std::numeric_limits<double>::quiet_NaN(),
                           -std::numeric_limits<double>::infinity(), 1.0001e12}) {
        EXPECT_THAT(
            written([&](PlanarGraph& other) { other.vertices[1].at(1) = y; }),
            HasSubstr(
                "the graph cannot be written: \"VERTEX_SE2 9223372036854775807 1\" would go on"))
            << y;
    }
    EXPECT_THAT(written([](PlanarGraph& other) { other.edges[0].z(0) = 2e12; }),
                HasSubstr("would go on with 2e+12, and numbers from -1e+12 to 1e+12 are read"));
    EXPECT_THAT(written([](PlanarGraph& other) { other.edges[0].information(0, 0) = 2e18; }),
                HasSubstr("from -1e+18 to 1e+18"));
    PlanarGraph greatest = graph;
    greatest.vertices[1].at(1) = 1e12;
    greatest.edges[0].information(0, 0) = 1e18;
    EXPECT_EQ(parsed(g2o_text(greatest)).graph.vertices[1].at(1), 1e12);
}

}  // namespace
}  // namespace hitos
