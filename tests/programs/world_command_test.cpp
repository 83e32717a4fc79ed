// SPDX-License-Identifier: GPL-3.0-or-later
// hitos-cli world as a user calls it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "command_test.hpp"
#include "hitos/services/files/map_file.hpp"
#include "hitos/simulation/drive/driven_path.hpp"
#include "hitos/simulation/text/world_text.hpp"

namespace hitos::test {
namespace {

using nlohmann::json;

class WorldCommand : public CommandTest {
  protected:
    WorldCommand() : CommandTest("world") {}
    std::string world(const std::string& name) const {
        return kSource + "/data/worlds/" + name + ".toml";
    }
};

/// How far the furthest end of one world's walls is from the other's walls.
double furthest(const World& of, const World& from) {
    double most = 0.0;
    for (const WallSegment& wall : of.walls) {
        for (const Point2& end : {wall.a, wall.b}) {
            double least = std::numeric_limits<double>::infinity();
            for (const WallSegment& other : from.walls)
                least = std::min(least, distance(other, end));
            most = std::max(most, least);
        }
    }
    return most;
}

TEST_F(WorldCommand, TheGridOfARunThroughBigloopGivesItsWalls) {
    const Outcome run =
        shell(cli_ + " run " + world("bigloop") +
              " --preset simulated --world-set tour.laps=1 --write all --seed 1 --out " +
              path("run") + " 2>&1");
    ASSERT_EQ(run.status, 0) << run.output;
    const World truth = read_world(world("bigloop"));
    constexpr double kCell = 0.05;
    constexpr double kMapError = 0.2;  // m, of the run
    for (const std::string& source :
         {path("run/map.yaml"), path("run/map.pgm") + " --resolution 0.05"}) {
        const json said = object(source + " --out " + path("traced.toml"));
        const World traced = read_world(path("traced.toml"));
        EXPECT_EQ(traced.walls.size(), 8U) << source;
        EXPECT_EQ(said.at("polylines"), 2) << source;
        if (source.find("yaml") == std::string::npos) continue;  // has another origin
        EXPECT_EQ(said.at("good"), true) << said;
        EXPECT_LE(furthest(traced, truth), kMapError);
        EXPECT_LE(furthest(truth, traced), kMapError);
        // The lines that the run found in the same scans along nearly the same path.
        const LandmarkMap map = read_map(path("run/map.txt"));
        for (const WallSegment& wall : traced.walls) {
            const Point2 middle{(wall.a.x + wall.b.x) / 2.0, (wall.a.y + wall.b.y) / 2.0};
            double least = std::numeric_limits<double>::infinity();
            for (const ICaracteristica& landmark : map) {
                if (const auto* line = std::get_if<Recta>(&landmark.value))
                    least = std::min(least, std::abs(signed_distance(*line, middle)));
            }
            EXPECT_LE(least, kCell);
        }
    }
    // The segments of the same run.
    object(path("run") + " --out " + path("segments.toml"));
    EXPECT_LE(furthest(read_world(path("segments.toml")), truth), kMapError);
}

TEST_F(WorldCommand, AMapWhoseNegateIsWrongIsWarnedOf) {
    std::string pixels(1600, static_cast<char>(205));
    for (std::size_t row = 5; row < 35; ++row) {
        for (std::size_t column = 5; column < 35; ++column) {
            const bool wall = row == 5 || row == 34 || column == 5 || column == 34;
            pixels[row * 40 + column] = static_cast<char>(wall ? 0 : 254);
        }
    }
    file("room.pgm", "P5\n40 40\n255\n" + pixels);
    const std::string yaml = "image: room.pgm\nresolution: 0.1\norigin: [-2, -2, 0]\nnegate: ";
    const auto warnings = [&](const char* negate) {
        const std::string source = file("room.yaml", yaml + negate + "\n");
        return object(source + " --start 0,0,0 --out " + path("w.toml")).at("warnings").size();
    };
    EXPECT_EQ(warnings("0"), 0U);
    EXPECT_EQ(warnings("1"), 1U);
}

TEST_F(WorldCommand, TheMapOfBigloopIsBigloop) {
    const json said = object(map_ + " --start 1,0.5,90 --out " + path("w.toml"));
    EXPECT_EQ(said.at("walls"), 8);
    EXPECT_EQ(said.at("lines_left_out"), 0);
    EXPECT_EQ(said.at("good"), true);
    EXPECT_EQ(said.at("has_tour"), false);
    const World made = read_world(path("w.toml"));
    const World truth = read_world(world("bigloop"));
    EXPECT_LE(furthest(made, truth), 1e-9);
    EXPECT_LE(furthest(truth, made), 1e-9);
    EXPECT_EQ(made.tour.start, (Pose{1, 0.5, kPi / 2}));
    const Outcome run =
        shell(cli_ + " simulate " + path("w.toml") + " --out " + path("t.log") + " 2>&1");
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.output.find("has no tour to drive"), std::string::npos) << run.output;
    EXPECT_FALSE(fs::exists(path("t.log")));
}

TEST_F(WorldCommand, ADrawingBecomesAWorldAndItsFaultsAreTold) {
    const std::string drawing = file("room.dxf",
                                     "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\nWALLS\n10\n0\n20\n-"
                                     "1\n11\n4\n21\n-1\n0\nENDSEC\n0\nEOF\n");
    const Outcome outcome = call(drawing + " --start 2,-0.9,0 --out " + path("w.toml"));
    EXPECT_EQ(outcome.status, 0);
    EXPECT_NE(outcome.output.find("start: 0.100 m from what is nearest"), std::string::npos);
    EXPECT_NE(outcome.output.find("room: open, a ray from the start at"), std::string::npos);
    EXPECT_NE(outcome.output.find("tour: none yet"), std::string::npos);
    EXPECT_EQ(content(path("w.toml")),
              "# The walls of room.dxf.\nwalls = [\n    [[0, -1], [4, -1]],\n]\n\n[tour]\n"
              "start = [2, -0.9, 0]\n");
}

TEST_F(WorldCommand, ADrawingIsReadByUnitAndLayerAndItsSizeIsTold) {
    const auto line = [](const char* layer, const char* to) {
        return fmt::format("0\nLINE\n8\n{}\n10\n0\n20\n0\n11\n{}\n21\n12000\n", layer, to);
    };
    const std::string drawing = file(
        "mm.dxf", "0\nSECTION\n2\nENTITIES\n" + line("WALLS", "20000") + line("AXES", "90000") +
                      "0\nTEXT\n8\n0\n1\nHall\n0\n3DSOLID\n8\nX\n0\nENDSEC\n0\nEOF\n");
    const std::string to = " --out " + path("w.toml");
    const json all = object(drawing + to);
    EXPECT_EQ(all.at("size_m"), json::array({90000.0, 12000.0}));
    EXPECT_NE(all.at("notes").dump().find("tells no unit"), std::string::npos) << all;
    EXPECT_NE(all.at("warnings").dump().find("mm: 90 m x 12 m"), std::string::npos) << all;
    EXPECT_NE(all.at("warnings").dump().find("1 3DSOLID cannot be read"), std::string::npos);
    for (const char* unit : {"mm", "0.001"}) {
        const json chosen = object(drawing + to + " --layer walls --unit " + unit);
        EXPECT_EQ(chosen.at("size_m"), json::array({20.0, 12.0}));
        EXPECT_EQ(chosen.at("warnings"), json::array());
    }
    EXPECT_NE(
        call(drawing + to + " --layer walls --unit mm").output.find("size: 20.000 m x 12.000"),
        std::string::npos);
    refused(drawing + to + " --layer ROOF", "expected one of the layers that do: 1 AXES, 1 WALLS");
    refused(drawing + to + " --unit furlong", "expected mm, cm, m, in, ft");
    refused(drawing + to + " --unit -1", "more than 0");
    refused(map_ + to + " --unit mm", "is no drawing");
    refused("bigloop --layer walls", "is no drawing");
    // A world that takes its walls from the drawing tells the same.
    const Outcome named = call(file("named.toml", "walls_dxf = \"mm.dxf\"\n"));
    EXPECT_NE(named.output.find("1 TEXT passed over"), std::string::npos) << named.output;
    EXPECT_NE(named.output.find("1 3DSOLID cannot be read"), std::string::npos) << named.output;
}

TEST_F(WorldCommand, ADrawingInSurveyCoordinatesIsMoved) {
    const std::string drawing =
        file("far.dxf",
             "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n530000\n20\n180000\n11\n530020\n"
             "21\n180012\n0\nENDSEC\n0\nEOF\n");
    const std::string to = " --out " + path("w.toml");
    const json moved = object(drawing + to + " --start 2,9,0");
    EXPECT_EQ(moved.at("low_m"), json::array({0.0, 0.0}));
    EXPECT_NE(moved.at("warnings").dump().find("moved by (-530000, -180000) m"), std::string::npos);
    // Whoever starts out there means the drawing's own coordinates.
    EXPECT_EQ(object(drawing + to + " --start 530002,180009,0").at("low_m"),
              json::array({530000.0, 180000.0}));
}

TEST_F(WorldCommand, AWorldIsChecked) {
    EXPECT_EQ(object(world("complex")).at("good"), true);
    EXPECT_EQ(object("bigloop --start 0,0,45 --out " + path("b.toml")).at("has_tour"), true);
    EXPECT_NE(content(path("b.toml")).find("start = [0, 0, 45]"), std::string::npos);
    EXPECT_EQ(content(path("b.toml")).size(), content(world("bigloop")).size() + 1);
}

TEST_F(WorldCommand, WhatCannotBeIsRefused) {
    const std::string picture = kSource + "/docs/images/none.png";
    refused(map_, "give --out WORLD.toml");
    refused(map_ + " --out " + path("w.txt"), "expected a name that ends in .toml");
    refused(map_ + " --start 1,2 --out " + path("w.toml"), "expected X,Y,DEG");
    refused(picture + " --out " + path("w.toml"), "none.png");
    refused(file("p.png", "") + " --resolution 0.05 --out " + path("w.toml"),
            "p.png: is no picture");
    refused(file("q.png", "") + " --out " + path("w.toml"), "does not tell how large a pixel is");
    refused(file("m.yaml", "image: x.png\n") + " --out " + path("w.toml"), "m.yaml: has no");
    EXPECT_FALSE(fs::exists(path("w.toml")));
}

}  // namespace
}  // namespace hitos::test
