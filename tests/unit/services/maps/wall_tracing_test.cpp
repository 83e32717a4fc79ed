// SPDX-License-Identifier: GPL-3.0-or-later
// Walls traced from cells.
#include "hitos/services/tracing/wall_tracing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <random>

#include "hitos/base/error.hpp"
#include "hitos/services/drawing/picture_file.hpp"
#include "support.hpp"
#include "tracing/thinning.hpp"

namespace hitos {
namespace {

void occupy(OccupancyPicture& picture, int column, int row) {
    picture.occupied[static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.columns) +
                     static_cast<std::size_t>(column)] = 1;
}

using test::message_of;
using test::TempFolder;

constexpr double kCell = 0.05;

OccupancyPicture empty_picture(int columns, int rows) {
    OccupancyPicture picture;
    picture.columns = columns;
    picture.rows = rows;
    picture.resolution_m = kCell;
    picture.origin = {-1.0, -2.0, 0.0};
    picture.occupied.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0);
    return picture;
}

/// Occupies the cells whose middle lies within `half_m` of the wall, each only with `part`.
void draw(OccupancyPicture& picture, const Point2& a, const Point2& b, double half_m,
          double part = 1.0) {
    std::mt19937 random(5);
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    for (int row = 0; row < picture.rows; ++row) {
        for (int column = 0; column < picture.columns; ++column) {
            const Point2 p = picture.world(column, row);
            const double t = std::clamp(
                ((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / (length * length), 0.0,
                1.0);
            const double off = std::hypot(p.x - a.x - t * (b.x - a.x), p.y - a.y - t * (b.y - a.y));
            const bool on = std::uniform_real_distribution(0.0, 1.0)(random) < part;
            if (off <= half_m && on) occupy(picture, column, row);
        }
    }
}

double gap(const Point2& a, const Point2& b) {
    return std::hypot(b.x - a.x, b.y - a.y);
}

/// Whether one of the walls has both ends within `off` of these.
bool has_wall(const Walls& walls, const Point2& a, const Point2& b, double off) {
    return std::ranges::any_of(walls, [&](const auto& wall) {
        return (gap(wall.first, a) <= off && gap(wall.second, b) <= off) ||
               (gap(wall.first, b) <= off && gap(wall.second, a) <= off);
    });
}

TEST(WallTracing, ThickWallsOfARoomBecomeTheirMiddleLines) {
    for (const double half : {0.03, 0.07, 0.12}) {
        OccupancyPicture picture = empty_picture(200, 160);
        const std::vector<Point2> corners = {{0, 0}, {7, 0}, {7, 5}, {0, 5}};
        for (std::size_t i = 0; i < 4; ++i) draw(picture, corners[i], corners[(i + 1) % 4], half);
        draw(picture, {3, 0}, {3, 2}, half);  // ends in the room
        const Walls walls = trace_walls(picture);
        EXPECT_EQ(walls.size(), 5U) << half;
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_TRUE(has_wall(walls, corners[i], corners[(i + 1) % 4], kCell)) << half << i;
        EXPECT_TRUE(has_wall(walls, {3, 0}, {3, 2}, half + kCell)) << half;
    }
}

TEST(WallTracing, CornersAreOnePoint) {
    OccupancyPicture picture = empty_picture(200, 160);
    draw(picture, {0, 0}, {6, 1}, 0.06);
    draw(picture, {6, 1}, {5, 5}, 0.06);
    const Walls walls = trace_walls(picture);
    ASSERT_EQ(walls.size(), 2U);
    const auto& [a, b] = walls[0];
    const auto& [c, d] = walls[1];
    EXPECT_EQ((a == c) + (a == d) + (b == c) + (b == d), 1);
    EXPECT_TRUE(has_wall(walls, {0, 0}, {6, 1}, 0.08));
    EXPECT_TRUE(has_wall(walls, {6, 1}, {5, 5}, 0.08));
}

TEST(WallTracing, DoorsStayOpenAndHolesDoNot) {
    OccupancyPicture picture = empty_picture(200, 100);
    draw(picture, {0, 0}, {3, 0}, 0.04);
    draw(picture, {3.8, 0}, {7, 0}, 0.04);
    draw(picture, {0, 2}, {3, 2}, 0.04);
    draw(picture, {3.15, 2}, {7, 2}, 0.04);
    const Walls walls = trace_walls(picture);
    ASSERT_EQ(walls.size(), 3U);
    EXPECT_TRUE(has_wall(walls, {0, 0}, {3, 0}, 0.08));
    EXPECT_TRUE(has_wall(walls, {3.8, 0}, {7, 0}, 0.08));
    EXPECT_TRUE(has_wall(walls, {0, 2}, {7, 2}, 0.08));
}

TEST(WallTracing, RaggedWallsAndLooseCellsAreNoMatter) {
    OccupancyPicture picture = empty_picture(200, 160);
    draw(picture, {0, 0}, {7, 2}, 0.08, 0.7);
    draw(picture, {0, 4}, {0.1, 4}, 0.06);  // a speck
    const Walls walls = trace_walls(picture);
    ASSERT_EQ(walls.size(), 1U);
    EXPECT_TRUE(has_wall(walls, {0, 0}, {7, 2}, 0.12));
}

TEST(WallTracing, ABlockGivesItsOutline) {
    OccupancyPicture picture = empty_picture(200, 160);
    for (int row = 40; row < 100; ++row) {
        for (int column = 40; column < 120; ++column) occupy(picture, column, row);
    }
    const Walls walls = trace_walls(picture);
    EXPECT_EQ(walls.size(), 4U);
    const Point2 low = picture.world(40, 99);
    const Point2 high = picture.world(119, 40);
    EXPECT_TRUE(has_wall(walls, low, {high.x, low.y}, kCell));
    EXPECT_TRUE(has_wall(walls, low, {low.x, high.y}, kCell));
    EXPECT_TRUE(has_wall(walls, high, {high.x, low.y}, kCell));
    EXPECT_TRUE(has_wall(walls, high, {low.x, high.y}, kCell));
}

TEST(WallTracing, ARoundWallIsCutIntoPiecesWithinTheTolerance) {
    OccupancyPicture picture = empty_picture(200, 200);
    constexpr int kPieces = 360;
    const Point2 middle{3, 3};
    const auto at = [&](int i) {
        const double angle = 2.0 * kPi * i / kPieces;
        return Point2{middle.x + 2.0 * std::cos(angle), middle.y + 2.0 * std::sin(angle)};
    };
    for (int i = 0; i < kPieces; ++i) draw(picture, at(i), at(i + 1), 0.04);
    const Walls walls = trace_walls(picture);
    EXPECT_GE(walls.size(), 6U);
    EXPECT_LE(walls.size(), 24U);
    for (const auto& [a, b] : walls) {
        for (const double t : {0.1, 0.5, 0.9}) {
            const Point2 p{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
            EXPECT_NEAR(gap(p, middle), 2.0, 3.0 * kCell);
        }
    }
}

TEST(WallTracing, AnEmptyPictureHasNoWallAndBadOptionsAreRefused) {
    EXPECT_TRUE(trace_walls(empty_picture(30, 20)).empty());
    EXPECT_TRUE(trace_walls(empty_picture(0, 0)).empty());
    TracingOptions options;
    options.tolerance_m = -1.0;
    EXPECT_NE(message_of<ConfigError>([&] {
                  trace_walls(empty_picture(3, 3), options);
              }).find("tolerance: found -1, expected 0 m or more"),
              std::string::npos);
}

TEST(Thinning, KeepsWhatHangsTogetherAndLeavesOneCell) {
    std::mt19937 random(3);
    CellMask mask(60, 60);
    for (int i = 0; i < 40; ++i) {
        const int column = static_cast<int>(random() % 50);
        const int row = static_cast<int>(random() % 50);
        for (int k = 0; k < 30; ++k) mask.set(column + k % 10, row + k / 10, true);
    }
    const auto pieces = [](CellMask of) {
        int count = 0;
        for (int row = 0; row < of.rows(); ++row) {
            for (int column = 0; column < of.columns(); ++column) {
                if (!of.at(column, row)) continue;
                ++count;
                std::vector<SkeletonCell> todo{{column, row}};
                while (!todo.empty()) {
                    const SkeletonCell cell = todo.back();
                    todo.pop_back();
                    if (!of.at(cell.column, cell.row)) continue;
                    of.set(cell.column, cell.row, false);
                    for (int dy = -1; dy <= 1; ++dy) {
                        for (int dx = -1; dx <= 1; ++dx)
                            todo.push_back({cell.column + dx, cell.row + dy});
                    }
                }
            }
        }
        return count;
    };
    const CellMask thin = thinned(mask);
    EXPECT_EQ(pieces(thin), pieces(mask));
    for (int row = 0; row < 59; ++row) {
        for (int column = 0; column < 59; ++column) {
            EXPECT_FALSE(thin.at(column, row) && thin.at(column + 1, row) &&
                         thin.at(column, row + 1) && thin.at(column + 1, row + 1));
            EXPECT_TRUE(!thin.at(column, row) || mask.at(column, row));
        }
    }
}

const std::string kYaml =
    "image: room.png\nresolution: 0.1\norigin: [1, 2, 0.5]  # lower left\nnegate: 0\n"
    "occupied_thresh: 0.65\nfree_thresh: 0.196\n";

/// The same with another value.
std::string yaml_with(const std::string& key, const std::string& value) {
    const std::size_t at = kYaml.find(key + ": ");
    return kYaml.substr(0, at) + key + ": " + value + kYaml.substr(kYaml.find('\n', at));
}

/// Greys from dark to light, one row.
void put_picture(const TempFolder& folder) {
    write_picture(Grid::Picture{4, 1, {0, 80, 100, 255}}, folder / "room.png");
}

TEST(OccupancyPicture, FollowsTheRulesOfMapServer) {
    TempFolder folder;
    put_picture(folder);
    const auto cells = [&](const std::string& yaml) {
        return read_map_server(folder.put("room.yaml", yaml)).occupied;
    };
    using Cells = std::vector<std::uint8_t>;
    EXPECT_EQ(cells(kYaml), (Cells{1, 1, 0, 0}));
    EXPECT_EQ(cells(yaml_with("negate", "1")), (Cells{0, 0, 0, 1}));
    EXPECT_EQ(cells(yaml_with("occupied_thresh", "0.6")), (Cells{1, 1, 1, 0}));
    EXPECT_EQ(cells(kYaml + "mode: raw\n"), (Cells{0, 1, 1, 0}));
    const OccupancyPicture picture = read_map_server(folder / "room.yaml");
    EXPECT_EQ(picture.resolution_m, 0.1);
    EXPECT_EQ(picture.origin, (Pose{1, 2, 0.5}));
    const Point2 first = picture.world(0, 0);
    EXPECT_NEAR(first.x, 1 + 0.05 * std::cos(0.5) - 0.05 * std::sin(0.5), 1e-12);
    EXPECT_NEAR(first.y, 2 + 0.05 * std::sin(0.5) + 0.05 * std::cos(0.5), 1e-12);
}

TEST(OccupancyPicture, IsReadAsLibrariesAndPeopleWriteIt) {
    TempFolder folder;
    put_picture(folder);
    const std::string of_windows =
        "\xef\xbb\xbf%YAML 1.2\r\n---\r\n\"image\": \"room.png\"\r\n'resolution': '0.1'\r\n"
        "origin: [1,\r\n         2,  # y\r\n\r\n         0.5]\r\nnegate: false\r\n";
    for (const char* yaml :
         {"image: room.png\nmode: trinary\nresolution: 0.1\norigin:\n- 1\n- 2\n- 0.5\nnegate: 0\n",
          "image: room.png\nresolution: 0.1\norigin:\n  - 1.0  # x\n  - 2.0\n  - 0.5\n",
          of_windows.c_str(),
          "{image: room.png, resolution: 0.1, origin: [1, 2, 0.5], negate: no}\n",
          "image: /home/robot/maps/room.png\nresolution: 0.1\norigin: [1, 2, 0.5]\n",
          "image: C:\\maps\\room.png\nresolution: 0.1\norigin: [1, 2, 0.5]\n"}) {
        const OccupancyPicture picture = read_map_server(folder.put("room.yaml", yaml));
        EXPECT_EQ(picture.occupied, (std::vector<std::uint8_t>{1, 1, 0, 0})) << yaml;
        EXPECT_EQ(picture.resolution_m, 0.1);
        EXPECT_EQ(picture.origin, (Pose{1, 2, 0.5}));
        const bool elsewhere = std::string_view(yaml).find("maps") != std::string_view::npos;
        EXPECT_EQ(picture.note.empty(), !elsewhere) << picture.note.english();
    }
    write_picture(Grid::Picture{1, 1, {0}}, folder / "it's #1.png");
    const auto ones = read_map_server(folder.put(
        "a.yaml", "image: \"it's #1.png\" # 'old'\nresolution: 0.1\norigin: [0, 0, 0]\n"));
    EXPECT_EQ(ones.occupied, (std::vector<std::uint8_t>{1}));
}

// A room as map_server saves it: walls of 0 round ground of 254, unknown 205 round them.
TEST(OccupancyPicture, ANegateThatIsTheWrongWayRoundIsDoubted) {
    TempFolder folder;
    Grid::Picture room{40, 40, std::vector<std::uint8_t>(1600, 205)};
    for (std::size_t row = 5; row < 35; ++row) {
        for (std::size_t column = 5; column < 35; ++column) {
            const bool wall = row == 5 || row == 34 || column == 5 || column == 34;
            room.grey[row * 40 + column] = wall ? 0 : 254;
        }
    }
    const auto doubt = [&](const std::string& yaml, const Point2& start) {
        write_picture(room, folder / "room.png");
        return doubt_of_negate(read_map_server(folder.put("room.yaml", yaml)), start).english();
    };
    const std::string good = yaml_with("origin", "[0, 0, 0]");
    const std::string bad =
        "image: room.png\nresolution: 0.1\norigin: [0, 0, 0]\nnegate: 1\nfree_thresh: 0.196\n";
    const Point2 ground{2.0, 2.0};
    const Point2 wall{0.55, 2.0};
    EXPECT_EQ(doubt(good, ground), "");
    EXPECT_EQ(doubt(good, wall), "");
    EXPECT_EQ(doubt(good, {-5.0, 2.0}), "");
    EXPECT_EQ(doubt(bad, ground),
              "negate in line 4 may be the wrong way round: by it 7 % of the picture is free "
              "ground, with negate: 0 it would be 49 %");
    EXPECT_EQ(doubt(bad, wall), "");  // the walls are free then
    EXPECT_EQ(doubt(bad + "mode: raw\n", ground), "");
    // A picture that is negated, and nobody has said so.
    for (std::uint8_t& grey : room.grey) grey = static_cast<std::uint8_t>(255 - grey);
    const std::string silent = "image: room.png\nresolution: 0.1\norigin: [0, 0, 0]\n";
    EXPECT_EQ(doubt(silent, ground),
              "the file has no negate, which may be wrong: by it 7 % of the picture is free "
              "ground, with negate: 1 it would be 49 %");
    EXPECT_EQ(doubt(silent + "negate: 1\n", ground), "");
}

// Black, white and grey of 80, each opaque, half transparent and wholly.
TEST(OccupancyPicture, TransparencyIsWhatMapServerMakesOfItsModes) {
    TempFolder folder;
    cv::Mat image(3, 3, CV_8UC4);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            const int grey = std::array{0, 255, 80}[static_cast<std::size_t>(column)];
            const int alpha = std::array{255, 128, 0}[static_cast<std::size_t>(row)];
            image.at<cv::Vec4b>(row, column) =
                cv::Vec4b(static_cast<unsigned char>(grey), static_cast<unsigned char>(grey),
                          static_cast<unsigned char>(grey), static_cast<unsigned char>(alpha));
        }
    }
    ASSERT_TRUE(cv::imwrite((folder / "room.png").string(), image));
    const auto cells = [&](const std::string& yaml) {
        return read_map_server(folder.put("room.yaml", yaml)).occupied;
    };
    using Cells = std::vector<std::uint8_t>;
    EXPECT_EQ(cells(kYaml), (Cells{1, 0, 0, 1, 0, 0, 0, 0, 0}));
    EXPECT_EQ(cells(kYaml + "mode: scale\n"), (Cells{1, 0, 1, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(read_wall_picture(folder / "room.png", 0.1).occupied,
              (Cells{1, 0, 1, 1, 0, 1, 0, 0, 0}));
}

TEST(OccupancyPicture, WhatCannotBeIsToldWithFileAndLine) {
    TempFolder folder;
    put_picture(folder);
    const auto refusal = [&](const std::string& yaml) {
        return message_of<FormatError>([&] { read_map_server(folder.put("room.yaml", yaml)); });
    };
    const auto expect = [](const std::string& message, const std::string& part) {
        EXPECT_NE(message.find(part), std::string::npos) << message;
    };
    expect(refusal("resolution: 0.1\norigin: [0, 0, 0]\n"),
           "room.yaml: has no image; expected a line image: PICTURE");
    expect(refusal("image: room.png\norigin: [0, 0, 0]\n"), "has no resolution");
    expect(refusal("image: room.png\nresolution: 0.1\n"), "has no origin");
    expect(refusal("image: room.png\nresolution: much\norigin: [0, 0, 0]\n"),
           "room.yaml:2: resolution: found \"much\", expected 0.0001 to 10");
    expect(refusal("image: room.png\nresolution: 0.1\norigin: [0, 0]\n"),
           "room.yaml:3: origin: found \"[0, 0]\", expected [x, y, yaw]");
    expect(refusal(yaml_with("origin", "[0, 0, 90]")),
           "room.yaml:3: origin: found a yaw of 90, which is more than a turn in radians; if it is "
           "in degrees, write 1.5708");
    expect(refusal(kYaml + "# again\nnegate: 1\n"),
           "room.yaml:8: \"negate\" stands in line 4 already");
    expect(refusal(yaml_with("free_thresh", "0.65")),
           "room.yaml:5: occupied_thresh: found 0.65, expected more than free_thresh, which is "
           "0.65 in line 6");
    expect(refusal(kYaml + "mode: other\n"), "expected trinary, scale or raw");
    expect(refusal("no yaml"), "room.yaml:1: found \"no yaml\", expected key: value");
    folder.put("bad.png", "no picture");
    expect(refusal("image: bad.png\nresolution: 0.1\norigin: [0, 0, 0]\n"),
           "bad.png: is no picture");
    expect(refusal("image: none.png\nresolution: 0.1\norigin: [0, 0, 0]\n"),
           "room.yaml:1: image: found \"none.png\", expected the name of a picture that is there");
    message_of<ConfigError>([&] { read_wall_picture(folder / "room.png", 0.0); });
}

}  // namespace
}  // namespace hitos
