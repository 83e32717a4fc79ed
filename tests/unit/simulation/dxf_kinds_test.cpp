// SPDX-License-Identifier: GPL-3.0-or-later
// What every kind of entity of a drawing becomes, and what is told of what is left out.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "hitos/base/error.hpp"
#include "hitos/simulation/drawings/dxf_walls.hpp"
#include "worlds.hpp"

namespace hitos {
namespace {

using test::message_of;
using test::TempFolder;
using testing::HasSubstr;
using WallPoints = std::vector<std::vector<Point2>>;

/// Words, each of them a line.
std::string as_lines(std::string words) {
    std::ranges::replace(words, ' ', '\n');
    return words + "\n";
}

class DxfKinds : public testing::Test {
  protected:
    /// Of a drawing in metres; `before` are the sections before its entities.
    DxfWalls read(const std::string& entities, const std::string& before = {},
                  const DxfOptions& options = {{}, 1.0}) {
        return read_dxf_walls(
            folder_.put("d.dxf", (before.empty() ? "" : as_lines(before)) +
                                     as_lines("0 SECTION 2 ENTITIES " + entities) +
                                     as_lines("0 ENDSEC 0 EOF")),
            options);
    }
    /// The same by its walls alone.
    WallPoints walls(const std::string& entities, const std::string& before = {}) {
        return read(entities, before).walls;
    }
    static std::string told(const std::vector<Message>& messages) {
        std::string all;
        for (const Message& message : messages) all += message.english() + "\n";
        return all;
    }
    static double farthest(const std::vector<Point2>& wall, const Point2& middle, double radius) {
        double most = 0.0;
        for (std::size_t i = 1; i < wall.size(); ++i) {
            const Point2 half{(wall[i - 1].x + wall[i].x) / 2, (wall[i - 1].y + wall[i].y) / 2};
            most = std::max({most, std::abs(distance(half, middle) - radius),
                             std::abs(distance(wall[i], middle) - radius)});
        }
        return most;
    }
    static void expect_near(const Point2& found, const Point2& expected) {
        EXPECT_NEAR(found.x, expected.x, 2e-9);
        EXPECT_NEAR(found.y, expected.y, 2e-9);
    }
    TempFolder folder_;
};

constexpr const char* kPlainWall = " 0 LINE 8 W 10 0 20 0 11 9 21 0";
const WallPoints kItsWall = {{{0, 0}, {9, 0}}};

TEST_F(DxfKinds, ArcsAndCirclesLieWithinAHairOfTheirChords) {
    const auto arc = walls("0 ARC 8 0 10 1 20 2 40 5 50 350 51 80");
    ASSERT_EQ(arc.size(), 1U);
    EXPECT_LE(farthest(arc[0], {1, 2}, 5.0), 0.005);
    expect_near(arc[0].front(), {1 + 5 * std::cos(-kPi / 18), 2 + 5 * std::sin(-kPi / 18)});
    expect_near(arc[0].back(), {1 + 5 * std::cos(kPi / 2.25), 2 + 5 * std::sin(kPi / 2.25)});
    const auto circle = walls("0 CIRCLE 8 0 10 1 20 2 40 300");
    EXPECT_LE(farthest(circle[0], {1, 2}, 300.0), 0.005);
    expect_near(circle[0].front(), circle[0].back());
    EXPECT_THAT(told(read("0 CIRCLE 8 0 10 1 20 2 40 3").notes), HasSubstr("curves of 1 CIRCLE"));
}

TEST_F(DxfKinds, ABulgeIsTheTangentOfAQuarterOfItsArc) {
    // A half circle below the line from (0, 0) to (4, 0), as counter-clockwise ones are.
    for (const std::string& polyline :
         {std::string("0 LWPOLYLINE 8 0 90 2 70 0 10 0 20 0 42 1 10 4 20 0"),
          std::string("0 POLYLINE 8 0 66 1 70 0 0 VERTEX 8 0 10 0 20 0 42 1 0 VERTEX 8 0 10 4 20 0 "
                      "0 SEQEND")}) {
        const auto bulge = walls(polyline);
        ASSERT_EQ(bulge.size(), 1U);
        EXPECT_LE(farthest(bulge[0], {2, 0}, 2.0), 0.005);
        EXPECT_LT(bulge[0][bulge[0].size() / 2].y, -1.9);
        EXPECT_EQ(bulge[0].back(), (Point2{4, 0}));
    }
    // Closed by an arc.
    const auto closed = walls("0 LWPOLYLINE 8 0 70 1 10 0 20 0 10 4 20 0 42 -0.5");
    EXPECT_EQ(closed[0].back(), (Point2{0, 0}));
    EXPECT_GT(closed[0].size(), 5U);
}

TEST_F(DxfKinds, EllipsesAndSplinesAreFollowed) {
    const auto ellipse =
        walls("0 ELLIPSE 8 0 10 1 20 0 11 0 21 4 40 0.5 41 0 42 3.141592653589793");
    expect_near(ellipse[0].front(), {1, 4});
    expect_near(ellipse[0][ellipse[0].size() / 2], {-1, 0});
    expect_near(ellipse[0].back(), {1, -4});
    // A parabola through (0, 0), (2, 1), (4, 0), and a quarter of a circle by weights.
    const auto parabola =
        walls("0 SPLINE 8 0 71 2 40 0 40 0 40 0 40 1 40 1 40 1 10 0 20 0 10 2 20 2 10 4 20 0");
    for (const Point2& point : parabola[0]) EXPECT_NEAR(point.y, point.x * (4 - point.x) / 4, 1e-8);
    EXPECT_GT(parabola[0].size(), 5U);
    const auto quarter = walls(
        "0 SPLINE 8 0 71 2 40 0 40 0 40 0 40 1 40 1 40 1 41 1 41 0.7071067811865476 41 1 "
        "10 3 20 0 10 3 20 3 10 0 20 3");
    EXPECT_LE(farthest(quarter[0], {0, 0}, 3.0), 0.005);
    EXPECT_EQ(walls("0 SPLINE 8 0 71 3 11 0 21 0 11 2 21 1 11 4 21 0"),
              (WallPoints{{{0, 0}, {2, 1}, {4, 0}}}));
    EXPECT_THAT(
        told(read("0 SPLINE 8 0 71 3 10 0 20 0 10 1 20 1" + std::string(kPlainWall)).warnings),
        HasSubstr("1 SPLINE cannot be read"));
}

TEST_F(DxfKinds, FilledSurfacesGiveTheirOutlines) {
    const std::string corners = " 8 0 10 0 20 0 11 2 21 0 12 0 22 3 13 2 23 3";
    const WallPoints outline = {{{0, 0}, {2, 0}, {2, 3}, {0, 3}, {0, 0}}};
    EXPECT_EQ(walls("0 SOLID" + corners), outline);
    EXPECT_EQ(walls("0 TRACE" + corners), outline);
    const std::string face = "0 3DFACE 8 0 10 0 20 0 11 2 21 0 12 2 22 3 13 0 23 3";
    EXPECT_EQ(walls(face), outline);
    EXPECT_EQ(walls(face + " 70 2"), (WallPoints{{{0, 0}, {2, 0}}, {{2, 3}, {0, 3}, {0, 0}}}));
    const std::string hatch = "0 HATCH 8 0 10 0 20 0 30 0 2 SOLID 70 1 71 0 91 1 92 ";
    EXPECT_EQ(walls(hatch + "3 72 0 73 1 93 4 10 0 20 0 10 2 20 0 10 2 20 3 10 0 20 3 97 0 75 1 "
                            "98 1 10 7 20 7"),
              outline);
    EXPECT_EQ(walls(hatch + "1 93 2 72 1 10 0 20 0 11 2 21 0 72 1 10 2 20 0 11 2 21 3 97 0 75 1"),
              (WallPoints{{{0, 0}, {2, 0}}, {{2, 0}, {2, 3}}}));
    // Clockwise from 270 degrees to 180: told as from 90 to 180, seen from below.
    const auto arc = walls(hatch + "1 93 1 72 2 10 0 20 0 40 2 50 90 51 180 73 0 97 0 75 1");
    expect_near(arc[0].front(), {-2, 0});
    expect_near(arc[0].back(), {0, -2});
    const DxfWalls pattern =
        read("0 HATCH 8 0 2 ANSI31 70 0 91 1 92 3 72 0 73 1 93 0 75 1" + std::string(kPlainWall));
    EXPECT_EQ(pattern.walls, kItsWall);
    EXPECT_THAT(told(pattern.notes), HasSubstr("1 HATCH (pattern) passed over"));
}

TEST_F(DxfKinds, MultilinesGiveEachOfTheirLines) {
    // Two lines, a metre apart, round a corner; the second is cut from 2 to 3 along its first way.
    const std::string corner =
        "0 MLINE 8 0 2 DOUBLE 40 1 70 0 71 1 72 3 73 2 10 0 20 0 "
        "11 0 21 0 12 1 22 0 13 0 23 1 74 2 41 0 41 0 75 0 74 4 41 1 41 0 41 2 41 3 75 0 "
        "11 5 21 0 12 0 22 1 13 -0.7071067811865476 23 0.7071067811865476 74 2 41 0 41 0 75 0 "
        "74 2 41 1.4142135623730951 41 0 75 0 "
        "11 5 21 6 12 0 22 1 13 -1 23 0 74 2 41 0 41 0 75 0 74 2 41 1 41 0 75 0";
    const WallPoints drawn = {
        {{0, 0}, {5, 0}}, {{5, 0}, {5, 6}}, {{0, 1}, {2, 1}}, {{3, 1}, {4, 1}}, {{4, 1}, {4, 6}}};
    EXPECT_EQ(walls(corner), drawn);
    WallPoints capped = drawn;
    capped.push_back({{0, 0}, {0, 1}});
    EXPECT_EQ(
        read_dxf_walls(folder_.put("m.dxf", as_lines("0 SECTION 2 ENTITIES " + corner +
                                                     " 0 ENDSEC 0 SECTION 2 OBJECTS 0 MLINESTYLE 2 "
                                                     "Double 70 16 0 ENDSEC 0 EOF")))
            .walls,
        capped);
}

TEST_F(DxfKinds, MeshesGiveTheirEdges) {
    const std::string vertex = " 0 VERTEX 8 0 70 64 ";
    EXPECT_EQ(walls("0 POLYLINE 8 0 66 1 70 16 71 2 72 2" + vertex + "10 0 20 0" + vertex +
                    "10 1 20 0" + vertex + "10 0 20 2" + vertex + "10 1 20 2 0 SEQEND"),
              (WallPoints{{{0, 0}, {1, 0}}, {{0, 2}, {1, 2}}, {{0, 0}, {0, 2}}, {{1, 0}, {1, 2}}}));
    const std::string face = " 0 VERTEX 8 0 70 128 10 0 20 0 ";
    EXPECT_EQ(walls("0 POLYLINE 8 0 66 1 70 64 0 VERTEX 8 0 70 192 10 0 20 0 0 VERTEX 8 0 70 192 "
                    "10 1 20 0 0 VERTEX 8 0 70 192 10 1 20 1" +
                    face + "71 1 72 2 73 -3 0 SEQEND"),
              (WallPoints{{{0, 0}, {1, 0}}, {{1, 0}, {1, 1}}}));
    EXPECT_THAT(message_of<FormatError>([&] { walls("0 POLYLINE 8 0 70 16 71 2000000000 72 2"); }),
                HasSubstr("1 POLYLINE"));
}

TEST_F(DxfKinds, WhatIsSeenFromBelowIsMirrored) {
    const std::string below = " 210 0 220 0 230 -1";
    EXPECT_EQ(walls("0 LWPOLYLINE 8 0 10 1 20 2 10 3 20 4" + below),
              (WallPoints{{{-1, 2}, {-3, 4}}}));
    EXPECT_EQ(walls("0 POLYLINE 8 0 66 1" + below +
                    " 0 VERTEX 8 0 10 1 20 2 0 VERTEX 8 0 10 3 20 4 0 SEQEND"),
              (WallPoints{{{-1, 2}, {-3, 4}}}));
    EXPECT_EQ(walls("0 SOLID 8 0 10 0 20 0 11 2 21 0 12 0 22 3" + below),
              (WallPoints{{{0, 0}, {-2, 0}, {0, 3}, {0, 0}}}));
    const auto arc = walls("0 ARC 8 0 10 1 20 0 40 2 50 0 51 90" + below);
    expect_near(arc[0].front(), {-3, 0});
    expect_near(arc[0].back(), {-1, 2});
    // A line's ends are the drawing's own, whatever way it is thick; so are an ellipse's axes.
    EXPECT_EQ(walls("0 LINE 8 0 10 1 20 2 11 3 21 4" + below), (WallPoints{{{1, 2}, {3, 4}}}));
    const auto ellipse =
        walls("0 ELLIPSE 8 0 10 1 20 0 11 2 21 0 40 0.5 41 0 42 1.5707963267948966" + below);
    expect_near(ellipse[0].back(), {1, -1});
}

TEST_F(DxfKinds, BlocksAreDrawnWhereTheyAreInserted) {
    const std::string blocks =
        "0 SECTION 2 BLOCKS 0 BLOCK 8 0 2 Leaf 70 0 10 1 20 0 "
        "0 LINE 8 0 10 1 20 0 11 2 21 0 0 ENDBLK "
        "0 BLOCK 8 0 2 TWO 70 0 10 0 20 0 0 INSERT 8 0 2 LEAF 10 0 20 0 "
        "0 INSERT 8 0 2 leaf 10 0 20 5 0 ENDBLK "
        "0 BLOCK 8 0 2 SELF 10 0 20 0 0 INSERT 8 0 2 SELF 10 1 20 1 0 ENDBLK "
        "0 BLOCK 8 0 2 XREF 70 4 10 0 20 0 1 storey.dwg 0 ENDBLK 0 ENDSEC";
    EXPECT_EQ(walls("0 INSERT 8 0 2 LEAF 10 3 20 4", blocks), (WallPoints{{{3, 4}, {4, 4}}}));
    EXPECT_EQ(walls("0 INSERT 8 0 2 LEAF 10 3 20 4 41 -2 50 90", blocks),
              (WallPoints{{{3, 4}, {3, 2}}}));
    EXPECT_EQ(walls("0 INSERT 8 0 2 LEAF 10 3 20 4 210 0 220 0 230 -1", blocks),
              (WallPoints{{{-3, 4}, {-4, 4}}}));
    EXPECT_EQ(walls("0 INSERT 8 0 2 TWO 10 1 20 1 41 2 42 2", blocks),
              (WallPoints{{{1, 1}, {3, 1}}, {{1, 11}, {3, 11}}}));
    EXPECT_EQ(walls("0 INSERT 8 0 2 LEAF 10 0 20 0 50 90 70 2 71 2 44 10 45 1", blocks),
              (WallPoints{
                  {{0, 0}, {0, 1}}, {{-1, 0}, {-1, 1}}, {{0, 10}, {0, 11}}, {{-1, 10}, {-1, 11}}}));
    const DxfWalls lacking = read(
        "0 INSERT 8 0 2 SELF 10 0 20 0 0 INSERT 8 0 2 XREF 10 0 20 0 "
        "0 INSERT 8 0 2 GONE 10 0 20 0" +
            std::string(kPlainWall),
        blocks);
    EXPECT_EQ(lacking.walls, kItsWall);
    EXPECT_THAT(told(lacking.warnings), HasSubstr("1 INSERT cannot be read"));
    EXPECT_THAT(told(lacking.warnings), HasSubstr("not in the file: 1 GONE, 1 storey.dwg"));
}

TEST_F(DxfKinds, LayersThatAreOffOrFrozenAreLeftOutUnlessNamed) {
    const std::string tables =
        "0 SECTION 2 TABLES 0 TABLE 2 LAYER 0 LAYER 2 AXES 70 0 62 -7 0 LAYER 2 Furn 70 1 62 7 "
        "0 LAYER 2 W 70 4 62 7 0 ENDTAB 0 ENDSEC 0 SECTION 2 BLOCKS 0 BLOCK 2 B 10 0 20 0 "
        "0 LINE 8 0 10 0 20 0 11 0 21 1 0 LINE 8 W 10 0 20 0 11 0 21 2 0 ENDBLK 0 ENDSEC";
    const std::string hidden =
        "0 LINE 8 AXES 10 0 20 0 11 1 21 1 0 LINE 8 FURN 10 0 20 0 11 2 21 2";
    const DxfWalls all = read(hidden + kPlainWall, tables);
    EXPECT_EQ(all.walls, kItsWall);
    EXPECT_THAT(told(all.notes), HasSubstr("off or frozen: 1 AXES, 1 FURN"));
    EXPECT_EQ(read(hidden + kPlainWall, tables, {"furn", 1.0}).walls,
              (WallPoints{{{0, 0}, {2, 2}}}));
    EXPECT_EQ(read(hidden + kPlainWall, tables, {"W,axes", 1.0}).walls,
              (WallPoints{{{0, 0}, {1, 1}}, {{0, 0}, {9, 0}}}));
    EXPECT_THAT(message_of<FormatError>([&] { read(hidden, tables); }),
                HasSubstr("1 AXES, 1 FURN"));
    EXPECT_THAT(message_of<FormatError>([&] {
                    read(hidden + kPlainWall, tables, {"roof", {}});
                }),
                HasSubstr("layer \"roof\" holds no wall; expected one of the layers that do: "
                          "1 AXES, 1 FURN, 1 W"));
    // In a block, layer 0 is the insertion's; a frozen insertion takes all with it.
    EXPECT_EQ(walls("0 INSERT 8 AXES 2 B 10 0 20 0", tables), (WallPoints{{{0, 0}, {0, 2}}}));
    EXPECT_EQ(walls("0 INSERT 8 FURN 2 B 10 0 20 0" + std::string(kPlainWall), tables), kItsWall);
    EXPECT_EQ(read("0 INSERT 8 P 2 B 10 0 20 0", tables, {"P", 1.0}).walls,
              (WallPoints{{{0, 0}, {0, 1}}}));
    // Names in Latin-1 and as \U+00C4 are the same.
    EXPECT_EQ(read("0 LINE 8 W\xC4ND 10 0 20 0 11 1 21 1 0 LINE 8 w\\U+00C4nd 10 0 20 0 11 2 21 2",
                   {}, {"W\xC3\x84ND", 1.0})
                  .walls.size(),
              2U);
}

TEST_F(DxfKinds, SheetsAndWhatIsInvisibleAreLeftOut) {
    const std::string line = " 8 W 10 1 20 1 11 5 21 5";
    const std::string before =
        "0 SECTION 2 TABLES 0 TABLE 2 BLOCK_RECORD 0 BLOCK_RECORD 5 1B 2 *Paper_Space 0 ENDTAB "
        "0 ENDSEC 0 SECTION 2 BLOCKS 0 BLOCK 2 *Paper_Space0 10 0 20 0 0 LINE" +
        line +
        " 0 ENDBLK 0 BLOCK 2 *Model_Space 10 0 20 0 0 LINE 8 W 10 0 20 0 11 9 21 0 0 ENDBLK "
        "0 ENDSEC";
    const DxfWalls found =
        read("0 LINE 67 1" + line + " 0 LINE 5 30 330 1B" + line +
                 " 0 LINE 102 {ACAD_REACTORS 330 1B 102 } 330 17" + line + " 0 LINE 60 1" + line,
             before);
    EXPECT_EQ(found.walls, (WallPoints{{{1, 1}, {5, 5}}, {{0, 0}, {9, 0}}}));
    EXPECT_THAT(told(found.notes), HasSubstr("3 LINE left out, on sheets"));
    EXPECT_THAT(told(found.notes), HasSubstr("1 LINE left out, invisible"));
}

TEST_F(DxfKinds, WhatIsNoWallAndWhatCannotBeReadAreToldApart) {
    const DxfWalls found = read(
        "0 TEXT 8 0 1 Hall 10 0 20 0 0 DIMENSION 8 0 10 0 20 0 0 3DSOLID 8 0 1 x 0 REGION 8 0 "
        "0 LWPOLYLINE 8 W 43 0.2 10 0 20 0 10 9 20 0");
    EXPECT_EQ(found.walls, kItsWall);
    EXPECT_THAT(told(found.notes), HasSubstr("1 DIMENSION, 1 TEXT passed over"));
    EXPECT_THAT(told(found.warnings), HasSubstr("1 3DSOLID, 1 REGION cannot be read"));
    EXPECT_THAT(told(found.warnings), HasSubstr("with a width: 1"));
}

TEST_F(DxfKinds, UnitsAreTakenAsToldAndTheirSizesDoubted) {
    const std::string header = "0 SECTION 2 HEADER 9 $INSUNITS 70 ";
    for (const auto& [value, metres] : {std::pair{"1", 0.0254},
                                        {"2", 0.3048},
                                        {"4", 0.001},
                                        {"5", 0.01},
                                        {"6", 1.0},
                                        {"10", 0.9144},
                                        {"14", 0.1}}) {
        const auto found = read(kPlainWall + 1, header + value + " 0 ENDSEC", {}).walls;
        EXPECT_NEAR(found[0][1].x, 9.0 * metres, 1e-9) << value;
    }
    const std::string hall = "0 LINE 8 0 10 0 20 0 11 20000 21 12000";
    const DxfWalls unknown = read(hall, header + "0 0 ENDSEC", {});
    EXPECT_THAT(told(unknown.notes), HasSubstr("tells no unit"));
    EXPECT_THAT(told(unknown.warnings), HasSubstr("20000 m x 12000 m is no size"));
    EXPECT_THAT(told(unknown.warnings), HasSubstr("mm: 20 m x 12 m"));
    EXPECT_TRUE(read(hall, header + "4 0 ENDSEC", {}).warnings.empty());
    EXPECT_TRUE(read(hall, {}, {{}, 0.001}).warnings.empty());
}

TEST_F(DxfKinds, FromThreeHundredMetresOnAUnitThatNobodySaysIsAskedFor) {
    const auto hall = [](const std::string& size) {
        return "0 LINE 8 0 10 0 20 0 11 " + size + " 21 9";
    };
    const std::string none = "0 SECTION 2 HEADER 9 $INSUNITS 70 0 0 ENDSEC";
    const std::string metres = "0 SECTION 2 HEADER 9 $INSUNITS 70 6 0 ENDSEC";
    const std::string asked = told(read(hall("1500"), none, {}).warnings);
    EXPECT_THAT(asked, HasSubstr("as metres, which nothing says, it is 1500 m x 9 m"));
    EXPECT_THAT(asked, HasSubstr("cm: 15 m x 0.09 m"));
    EXPECT_THAT(asked, testing::Not(HasSubstr(" m: 1500 m")));
    EXPECT_TRUE(read(hall("280"), none, {}).warnings.empty());
    EXPECT_TRUE(read(hall("1500"), metres, {}).warnings.empty());
    EXPECT_TRUE(read(hall("1500"), {}, {{}, 1.0}).warnings.empty());
    EXPECT_FALSE(read(hall("2500"), metres, {}).warnings.empty());
}

TEST_F(DxfKinds, SurveyCoordinatesAreMovedAndStraysLeftOut) {
    const std::string far = "0 LINE 8 0 10 2600000.25 20 1200000.5 11 2600020.25 21 1200012.5";
    const DxfWalls moved = read(far);
    EXPECT_EQ(moved.walls, (WallPoints{{{0.25, 0.5}, {20.25, 12.5}}}));
    EXPECT_EQ(moved.moved, (Point2{2600000, 1200000}));
    EXPECT_THAT(told(moved.warnings), HasSubstr("moved by (-2600000, -1200000) m"));
    const std::string grid = "0 LINE 8 0 10 530000 20 180000 11 530020 21 180012";
    EXPECT_EQ(read(grid).moved, (Point2{}));
    EXPECT_EQ(read(grid, {}, {{}, 1.0, 1e4}).moved, (Point2{530000, 180000}));
    const DxfWalls stray = read(far + " 0 LINE 8 X 10 0 20 0 11 1 21 1 " + far);
    EXPECT_EQ(stray.walls.size(), 2U);
    EXPECT_THAT(told(stray.warnings), HasSubstr("1 LINE (X)"));
    EXPECT_THAT(told(read("0 LINE 8 X 10 1e300 20 0 11 -1e300 21 1 0 INSERT 8 0 2 G" +
                          std::string(kPlainWall) + kPlainWall)
                         .warnings),
                HasSubstr("1 LINE (X)"));
}

TEST_F(DxfKinds, DamageIsToldAndNeverHangs) {
    EXPECT_THAT(message_of<FormatError>([&] { read("0 LINE 8 0 10 nan 20 0 11 1 21 1"); }),
                HasSubstr("d.dxf:10: found \"nan\", expected a finite number"));
    EXPECT_THAT(message_of<FormatError>([&] { read("0 LINE 8 0 10  20 0 11 1 21 1"); }),
                HasSubstr("d.dxf:10: found \"\", expected"));
    EXPECT_THAT(message_of<FormatError>([&] { read("0 LINE 8 0 10 1,5 20 0 11 1 21 1"); }),
                HasSubstr("\"1,5\""));
    // Of what breaks off, the last entity may be half of one.
    const DxfWalls cut = read_dxf_walls(folder_.put(
        "cut.dxf",
        as_lines("0 SECTION 2 ENTITIES" + std::string(kPlainWall) + " 0 LINE 8 0 10 3 20 3 11 4")));
    EXPECT_EQ(cut.walls, kItsWall);
    EXPECT_THAT(told(cut.warnings), HasSubstr("breaks off"));
    EXPECT_THAT(told(read("0 LINE 8 0 10 3 20 3 11 4" + std::string(kPlainWall)).warnings),
                HasSubstr("1 LINE cannot be read"));
    for (const char* half : {"0 ELLIPSE 8 0 10 1 20 0 40 0.5", "0 ELLIPSE 8 0 11 1 21 0 40 0.5"})
        EXPECT_THAT(told(read(half + std::string(kPlainWall)).warnings),
                    HasSubstr("1 ELLIPSE cannot be read"));
    // A face of corners that are not there.
    EXPECT_THAT(told(read("0 POLYLINE 8 0 66 1 70 64 0 VERTEX 8 0 70 192 10 0 20 0 0 VERTEX 8 0 "
                          "70 192 10 1 20 0 0 VERTEX 8 0 70 128 10 0 20 0 71 1 72 2 73 9 "
                          "0 SEQEND" +
                          std::string(kPlainWall))
                         .warnings),
                HasSubstr("1 POLYLINE cannot be read"));
    // Ten blocks, each of ten of the one before, and a field of insertions without end.
    std::string blocks =
        "0 SECTION 2 BLOCKS 0 BLOCK 2 B0 10 0 20 0" + std::string(kPlainWall) + " 0 ENDBLK";
    for (int i = 1; i <= 10; ++i) {
        blocks += " 0 BLOCK 2 B" + std::to_string(i) + " 10 0 20 0";
        for (int k = 0; k < 10; ++k)
            blocks += " 0 INSERT 8 0 2 B" + std::to_string(i - 1) + " 10 1 20 1";
        blocks += " 0 ENDBLK";
    }
    blocks += " 0 ENDSEC";
    for (const char* insert : {"0 INSERT 8 0 2 B10 10 0 20 0",
                               "0 INSERT 8 0 2 B0 10 0 20 0 70 2000000000 71 2000000000"}) {
        EXPECT_THAT(message_of<FormatError>([&] { read(insert, blocks); }),
                    HasSubstr("shows more than"));
    }
}

TEST_F(DxfKinds, DrawingsOfOthersAreReadRightOrToldOf) {
    const auto shared = std::filesystem::path(HITOS_SHARED_DIR) / "data/foreign";
    if (!std::filesystem::exists(shared / "dxf-paper-space"))
        GTEST_SKIP() << "the foreign drawings are not here";
    const WallPoints room = {{{0, 0}, {20, 0}, {20, 12}, {10, 12}, {10, 10}, {0, 10}, {0, 0}}};
    const auto of = [&](const std::string& name, const DxfOptions& options = {}) {
        return read_dxf_walls(shared / ("dxf-" + name) / "plan.dxf", options).walls;
    };
    EXPECT_EQ(of("paper-space"), room);
    EXPECT_EQ(of("hidden-layers"), room);
    EXPECT_EQ(of("no-unit-mm", {{}, 0.001}), room);
    EXPECT_EQ(of("walls-passed-over"), (WallPoints{room[0], {{5, 0}, {5, 7}}, {{6, 0}, {6, 7}}}));
    EXPECT_EQ(of("mirrored-extrusion"),
              (WallPoints{{{0, 0}, {20, 0}, {20, 12}, {6.666666667, 12}, {0, 9}, {0, 0}}}));
    EXPECT_EQ(of("survey-coordinates"),
              (WallPoints{{{0.25, 0.5}, {20.25, 0.5}, {20.25, 12.5}, {0.25, 12.5}, {0.25, 0.5}}}));
    const WallPoints door = of("door-blocks");
    ASSERT_EQ(door.size(), 3U);
    EXPECT_EQ(door[1], (std::vector<Point2>{{3, 0}, {3.9, 0}}));
    EXPECT_LE(farthest(door[2], {3, 0}, 0.9), 0.005);
}

}  // namespace
}  // namespace hitos
