// SPDX-License-Identifier: GPL-3.0-or-later
// Worlds made of drawings, maps, runs and pictures.
#include "hitos/workbench/world_import.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

#include "hitos/base/error.hpp"
#include "hitos/services/drawing/picture_file.hpp"
#include "hitos/services/files/dxf_file.hpp"
#include "hitos/services/grid/grid.hpp"
#include "hitos/simulation/drive/driven_path.hpp"
#include "hitos/simulation/drive/simulated_tour.hpp"
#include "hitos/workbench/shipped_data.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using test::message_of;
using test::TempFolder;

constexpr double kCell = 0.05;

/// The grid that the world's laser draws along the true path, as map_server's files.
std::filesystem::path drawn_grid(const TempFolder& folder, const std::string& name) {
    const SimulatedTour tour(read_world(find_world(name)));
    GridParams params;
    params.resolution_m = kCell;
    Grid grid(params);
    for (std::uint64_t k = 0; k < tour.scans(); k += 3)
        grid.add(tour.scan(k), compose(tour.world().tour.start, tour.true_pose(k)));
    write_picture(grid.picture(), folder / (name + ".png"));
    const float likely = std::log(0.65F / 0.35F);  // as map_server takes it for a wall
    return folder.put(name + ".yaml", fmt::format("image: {}.png\nresolution: {}\n"
                                                  "origin: [{}, {}, 0]\nnegate: 0\n"
                                                  "occupied_thresh: {}\n",
                                                  name, kCell, grid.origin().x, grid.origin().y,
                                                  (255.0 - grey_of(likely)) / 255.0));
}

/// How far a wall is from the other world's walls where it is furthest, for the wall that is.
double furthest(const World& of, const World& from) {
    double most = 0.0;
    for (const WallSegment& wall : of.walls) {
        for (int i = 0; i <= 20; ++i) {
            const double t = i / 20.0;
            const Point2 p{wall.a.x + t * (wall.b.x - wall.a.x),
                           wall.a.y + t * (wall.b.y - wall.a.y)};
            double least = std::numeric_limits<double>::infinity();
            for (const WallSegment& other : from.walls) least = std::min(least, distance(other, p));
            most = std::max(most, least);
        }
    }
    return most;
}

TEST(WorldImport, GridsOfTheTruePathGiveTheWallsWithinACell) {
    TempFolder folder;
    for (const auto& [name, walls] : {std::pair{"bigloop", 8U}, std::pair{"bigloop2", 12U},
                                      std::pair{"complex", 14U}, std::pair{"lineamedia", 5U}}) {
        const World truth = read_world(find_world(name));
        const World traced = import_world(drawn_grid(folder, name), "w.toml", {}).world();
        EXPECT_EQ(traced.walls.size(), walls) << name;
        EXPECT_LE(furthest(traced, truth), kCell) << name;
        EXPECT_LE(furthest(truth, traced), kCell) << name;
    }
    // Rooms with open doors: the doors stay open, so more walls than joints.
    const World truth = read_world(find_world("usc-sal"));
    const World traced = import_world(drawn_grid(folder, "usc-sal"), "w.toml", {}).world();
    EXPECT_LE(furthest(traced, truth), kCell);
    EXPECT_LE(furthest(truth, traced), 2.0 * kCell);
}

TEST(WorldImport, SegmentsOfARunAreJoinedAndRounded) {
    TempFolder folder;
    folder.put("segments.txt", "# x1 y1 x2 y2\n0.00004 0 4 0 1\n4 0 4 3.00049 2\n9 9 9 8 3\n");
    const WorldText text = import_world(folder.path(), "w.toml", {});
    EXPECT_EQ(text.walls(), (std::vector<Polyline>{{{0, 0}, {4, 0}, {4, 3}}, {{9, 9}, {9, 8}}}));
    EXPECT_NE(text.text().find("start = [0, 0, 0]"), std::string::npos) << text.text();
    EXPECT_EQ(wall_source(folder / "segments.txt"), WallSource::segments);
}

TEST(WorldImport, LinesOfAMapEndAtTheirCorners) {
    TempFolder folder;
    const auto map = folder.put("some.map",
                                "rho: 0 theta: 0\nrho: 2 theta: 90\nrho: 50 theta: 90\n"
                                "x: 0 y: 2\nx: 0.04 y: -3\nx: 0 y: 1\nx: 7 y: 2.2\n");
    ImportReport report;
    EXPECT_EQ(import_walls(map, {}, &report),
              (std::vector<Polyline>{{{0.04, -3}, {0, 1}, {0, 2}}}));
    EXPECT_EQ(report.left_out, 2U);
    ImportOptions wide;
    wide.tolerance_m = 0.25;
    EXPECT_EQ(import_walls(map, wide).size(), 2U);
}

TEST(WorldImport, ADrawingToLayOnAMapStaysWhereItIs) {
    TempFolder folder;
    std::ofstream(folder / "survey.dxf")
        << "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n691000.25\n20\n5334000.5\n"
           "11\n691004.25\n21\n5334000.5\n0\nENDSEC\n0\nEOF\n";
    ImportReport report;
    EXPECT_EQ(walls_as_drawn(folder / "survey.dxf", {}, &report),
              (std::vector<Polyline>{{{691000.25, 5334000.5}, {691004.25, 5334000.5}}}));
    for (const Message& warning : report.warnings)
        EXPECT_EQ(warning.english().find("moved"), std::string::npos) << warning.english();
    EXPECT_EQ(import_walls(folder / "survey.dxf", {})[0][0].x, 0.25);
    const World world = read_world(find_world("bigloop"));
    EXPECT_EQ(walls_as_drawn(find_world("bigloop"), {}).size(), world.walls.size());
}

TEST(WorldImport, WhatShowsNoWallIsRefused) {
    TempFolder folder;
    write_picture(Grid::Picture{2, 2, {255, 255, 255, 255}}, folder / "white.png");
    EXPECT_NE(message_of<ConfigError>([&] {
                  import_walls(folder / "white.png", {});
              }).find("does not tell how large a pixel is"),
              std::string::npos);
    ImportOptions options;
    options.resolution_m = 0.1;
    EXPECT_NE(message_of<FormatError>([&] {
                  import_walls(folder / "white.png", options);
              }).find("white.png: found no wall"),
              std::string::npos);
    EXPECT_NE(message_of<FormatError>([&] {
                  import_walls(find_world("bigloop"), {});
              }).find("is a world; expected a drawing"),
              std::string::npos);
    message_of<FileError>([&] { import_walls(folder / "none.map", {}); });
}

TEST(WorldImport, OfAWorldOfStageItsPictureIsAskedFor) {
    TempFolder folder;
    for (const char* plan :
         {"floorplan\n(\n  size [20 12 0.8]\n  bitmap \"plan.png\"\n)\n",
          "floorplan (\n\tbitmap\t\"plan.png\" # walls\n\tsize [20 12 0.8]\n)\n",
          "floorplan( name \"a\" bitmap \"plan.png\" size [20 12 0.8] ) # all of it\n"}) {
        const auto file =
            folder.put("tour.world", std::string("# ours\nresolution 0.02\nwindow\n(\n"
                                                 "  size [600 400]\n)\n") +
                                         plan + "robot\n(\n  size [1 1 1]\n)\n");
        const std::string told = message_of<FormatError>([&] { import_walls(file, {}); });
        EXPECT_NE(told.find("is a world of Stage"), std::string::npos) << told;
        EXPECT_NE(told.find("\"plan.png\", with --resolution"), std::string::npos) << told;
        EXPECT_NE(told.find("(size [20 12 0.8])"), std::string::npos) << told;
    }
}

TEST(WorldImport, APictureThatIsNotWhereItsYamlSaysIsTold) {
    const TempFolder folder;
    drawn_grid(folder, "bigloop");
    const auto yaml = folder.put("map.yaml",
                                 "image: /home/robot/bigloop.png\nresolution: 0.05\n"
                                 "origin:\n- 0\n- 0\n- 0\n");
    ImportReport report;
    EXPECT_FALSE(import_walls(yaml, {}, &report).empty());
    ASSERT_EQ(report.notes.size(), 1U);
    EXPECT_EQ(report.notes.front().english(),
              "the picture is the file of that name beside map.yaml, as there is no "
              "/home/robot/bigloop.png");
}

TEST(WorldImport, TheDrawingOfARunGivesItsSegments) {
    const TempFolder folder;
    LandmarkMap map;
    ICaracteristica wall;
    wall.value = Recta{2.0, 0.0};
    map.push_back(wall);
    ICaracteristica corner;
    corner.value = Esquina{2.0, 3.0};
    corner.covariance << 0.01, 0.002, 0.002, 0.02;  // an ellipse in the drawing
    map.push_back(corner);
    const LineExtent extent{0, {2.0, -1.0}, {2.0, 3.0}, 7};
    write_dxf(map, {&extent, 1}, {}, folder / "map.dxf");
    const auto walls = import_walls(folder / "map.dxf", {});
    EXPECT_EQ(walls, (std::vector<Polyline>{{{2.0, -1.0}, {2.0, 3.0}}}));
}

}  // namespace
}  // namespace hitos
