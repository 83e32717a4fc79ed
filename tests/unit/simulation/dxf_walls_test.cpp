// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/simulation/drawings/dxf_walls.hpp"

#include <dl_dxf.h>

#include <memory>

#include "hitos/base/error.hpp"
#include "hitos/services/files/dxf_file.hpp"
#include "worlds.hpp"

namespace hitos {
namespace {

using test::message_of;
using test::TempFolder;

/// Writes a drawing with dxflib.
class Drawing {
  public:
    explicit Drawing(const std::filesystem::path& path)
        : writer_(dxf_.out(path.c_str(), DL_Codes::AC1015)) {
        dxf_.writeHeader(*writer_);
    }
    void units(int insunits) { writer_->dxfString(9, "$INSUNITS"), writer_->dxfInt(70, insunits); }
    void entities() {
        writer_->sectionEnd();
        writer_->sectionEntities();
    }
    void line(const Point2& a, const Point2& b, const char* layer = "0") {
        dxf_.writeLine(*writer_, {a.x, a.y, 0, b.x, b.y, 0}, attributes(layer));
    }
    /// An LWPOLYLINE, as AC1015 has them.
    void polyline(const std::vector<Point2>& points, bool closed, double bulge = 0.0) {
        dxf_.writePolyline(*writer_, {static_cast<int>(points.size()), 0, 0, closed ? 1 : 0},
                           attributes("0"));
        for (const Point2& point : points) dxf_.writeVertex(*writer_, {point.x, point.y, 0, bulge});
        dxf_.writePolylineEnd(*writer_);
    }
    void circle() { dxf_.writeCircle(*writer_, {1, 1, 0, 2}, attributes("0")); }
    void point() { dxf_.writePoint(*writer_, {1, 1, 0}, attributes("0")); }
    void end() {
        writer_->sectionEnd();
        writer_->dxfEOF();
        writer_->close();
    }

  private:
    static DL_Attributes attributes(const char* layer) { return {layer, 256, -1, "BYLAYER", 1.0}; }
    DL_Dxf dxf_;
    std::unique_ptr<DL_WriterA> writer_;
};

using WallPoints = std::vector<std::vector<Point2>>;

TEST(DxfWalls, CountsThatAreStatedAreNotBelieved) {
    const TempFolder folder;
    const auto file = folder.put(
        "counts.dxf",
        "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\n0\n90\n100000000\n70\n1\n10\n0\n20\n0\n10\n5\n"
        "20\n5\n10\n5\n20\n0\n0\nSPLINE\n8\n0\n70\n8\n71\n3\n72\n100000000\n73\n100000000\n74\n"
        "100000000\n40\n0\n40\n1\n10\n0\n20\n0\n30\n0\n0\nENDSEC\n0\nEOF\n");
    const DxfWalls read = read_dxf_walls(file, {});
    ASSERT_EQ(read.walls.size(), 1U);
    EXPECT_EQ(read.walls[0].size(), 4U) << "closed, by the points that are there";
}

TEST(DxfWalls, ReadsBackWhatWasDrawn) {
    const TempFolder folder;
    Drawing drawing(folder / "room.dxf");
    drawing.entities();
    drawing.line({-1, -1.25}, {19.5, -1.25});
    drawing.point();  // no wall, passed over
    drawing.polyline({{0, 0}, {4, 0.125}, {4, 3}}, false);
    drawing.polyline({{6, 1}, {8, 1}, {7, 2}}, true);
    drawing.end();
    EXPECT_EQ(read_dxf_walls(folder / "room.dxf").walls,
              (WallPoints{{{-1, -1.25}, {19.5, -1.25}},
                          {{0, 0}, {4, 0.125}, {4, 3}},
                          {{6, 1}, {8, 1}, {7, 2}, {6, 1}}}));
}

TEST(DxfWalls, ReadsTheOldPolylineWithItsVertices) {
    const TempFolder folder;
    const auto path = folder.put(
        "old.dxf",
        "0\nSECTION\n2\nENTITIES\n"
        "0\nPOLYLINE\n8\n0\n66\n1\n70\n1\n0\nVERTEX\n8\n0\n10\n1.5\n20\n2\n0\nVERTEX\n8\n0\n10\n"
        "3\n20\n2\n0\nVERTEX\n8\n0\n10\n3\n20\n4\n0\nSEQEND\n8\n0\n"
        "0\nLINE\n8\n0\n10\n0\n20\n0\n11\n1\n21\n1\n0\nENDSEC\n0\nEOF\n");
    EXPECT_EQ(read_dxf_walls(path).walls,
              (WallPoints{{{1.5, 2}, {3, 2}, {3, 4}, {1.5, 2}}, {{0, 0}, {1, 1}}}));
}

TEST(DxfWalls, TakesTheUnitFromTheDrawingUnlessTold) {
    const TempFolder folder;
    Drawing drawing(folder / "mm.dxf");
    drawing.units(4);
    drawing.entities();
    drawing.line({0, 0}, {2500, 500});
    drawing.end();
    EXPECT_EQ(read_dxf_walls(folder / "mm.dxf").walls, (WallPoints{{{0, 0}, {2.5, 0.5}}}));
    EXPECT_EQ(read_dxf_walls(folder / "mm.dxf", {{}, 0.01}).walls, (WallPoints{{{0, 0}, {25, 5}}}));
}

TEST(DxfWalls, ReadsOneLayerAlone) {
    const TempFolder folder;
    Drawing drawing(folder / "layers.dxf");
    drawing.entities();
    drawing.line({0, 0}, {1, 0}, "furniture");
    drawing.line({0, 2}, {1, 2}, "walls");
    drawing.circle();
    drawing.end();
    EXPECT_EQ(read_dxf_walls(folder / "layers.dxf", {"walls", {}}).walls,
              (WallPoints{{{0, 2}, {1, 2}}}));
    EXPECT_NE(message_of<FormatError>([&] {
                  read_dxf_walls(folder / "layers.dxf", {"roof", {}});
              }).find("layer \"roof\" holds no wall"),
              std::string::npos);
}

TEST(DxfWalls, ReadsTheLinesOfADrawnMap) {
    const TempFolder folder;
    const LandmarkMap map = {{Recta{2.0, kPi / 2.0}, 1e-4 * Eigen::Matrix2d::Identity()},
                             {Esquina{1.0, 2.0}, 1e-4 * Eigen::Matrix2d::Identity()}};
    const std::vector<LineExtent> segments = {{0, {1.0, 2.0}, {-1.5, 2.0}, 10},
                                              {0, {-3.0, 2.0}, {-4.25, 2.0}, 10}};
    write_dxf(map, segments, {{0.0, {0.0, 0.0, 0.0}}, {1.0, {1.0, 0.5, 0.0}}}, folder / "map.dxf");
    EXPECT_EQ(read_dxf_walls(folder / "map.dxf", {"LINES", {}}).walls,
              (WallPoints{{{1.0, 2.0}, {-1.5, 2.0}}, {{-3.0, 2.0}, {-4.25, 2.0}}}));
    EXPECT_EQ(read_dxf_walls(folder / "map.dxf", {"PATH", {}}).walls,
              (WallPoints{{{0, 0}, {1, 0.5}}}));
}

TEST(DxfWalls, RefusesWhatIsNoDrawing) {
    const TempFolder folder;
    EXPECT_NE(message_of<FileError>([&] { read_dxf_walls(folder / "none.dxf"); }).find("none.dxf"),
              std::string::npos);
    EXPECT_NE(message_of<FileError>([&] { read_dxf_walls(folder / ""); }).find("is a directory"),
              std::string::npos);
    const auto text = folder.put("text.dxf", "this is\nno drawing\nat all\n");
    EXPECT_NE(message_of<FormatError>([&] {
                  read_dxf_walls(text);
              }).find("text.dxf:1: found \"this is\", expected a group code"),
              std::string::npos);
    const auto binary = folder.put("binary.dxf", "AutoCAD Binary DXF\r\n\x1a");
    EXPECT_NE(message_of<FormatError>([&] {
                  read_dxf_walls(binary);
              }).find("expected a drawing that is saved as ASCII"),
              std::string::npos);
}

TEST(DxfWalls, LongLinesAndCommentsDoNoHarm) {
    const TempFolder folder;
    const auto drawing = [](const std::string& before) {
        return before +
               "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n0\n20\n0\n11\n5\n21\n0\n0\nENDSEC\n0\nE"
               "OF\n";
    };
    const std::string very_long(5000, 'x');
    for (const std::string& before : std::vector<std::string>{
             "999\ndxflib\n", "999\n" + very_long + "\n", " 999\ndxflib 1\n",
             "1\n" + very_long.substr(0, 1023) + "\n", "1\n" + very_long.substr(0, 1024) + "\n",
             "1\n" + very_long + "\n"}) {
        const auto walls = read_dxf_walls(folder.put("long.dxf", drawing(before))).walls;
        ASSERT_EQ(walls.size(), 1U) << before.substr(0, 20);
        EXPECT_EQ(walls.front().back(), (Point2{5.0, 0.0}));
    }
    // Without an end, and without a value.
    EXPECT_THROW(read_dxf_walls(folder.put("x.dxf", very_long)), FormatError);
    EXPECT_THROW(read_dxf_walls(folder.put("y.dxf", "0\nSECTION\n2")), FormatError);
    EXPECT_THROW(read_dxf_walls("/dev/zero", {}), FileError);
}

}  // namespace
}  // namespace hitos
