// SPDX-License-Identifier: GPL-3.0-or-later
// What clients are told of a snapshot, by the schemas that they are told too.
#include "live/live_messages.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "live/base64.hpp"
#include "live/live_channels.hpp"
#include "shown_snapshots.hpp"

namespace hitos::live {
namespace {

using nlohmann::json;
using test::full_snapshot;
using test::snapshot_after;

/// Whether a value is what the schema has, by as much of JSON Schema as ours use.
void expect_valid(const json& value, const json& schema, const std::string& where) {
    const std::string type = schema.at("type");
    if (type == "object") {
        ASSERT_TRUE(value.is_object()) << where;
        for (const json& name : schema.at("required")) {
            EXPECT_TRUE(value.contains(name.get<std::string>())) << where << name;
        }
        for (const auto& [name, part] : value.items()) {
            ASSERT_TRUE(schema.at("properties").contains(name)) << where << "." << name;
            expect_valid(part, schema["properties"][name], fmt::format("{}.{}", where, name));
        }
    } else if (type == "array") {
        ASSERT_TRUE(value.is_array()) << where;
        for (const json& part : value) expect_valid(part, schema.at("items"), where + "[]");
    } else if (type == "integer") {
        EXPECT_TRUE(value.is_number_unsigned()) << where;
    } else if (type == "number") {
        EXPECT_TRUE(value.is_number()) << where;
    } else if (type == "boolean") {
        EXPECT_TRUE(value.is_boolean()) << where;
    } else {
        EXPECT_TRUE(type == "string" && value.is_string()) << where;
    }
}

/// The text of a base64 text, by a table made here.
std::string decoded(std::string_view text) {
    const std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned bits = 0;
    int count = 0;
    for (const char c : text) {
        if (c == '=') break;
        bits = bits << 6U | static_cast<unsigned>(digits.find(c));
        count += 6;
        if (count >= 8) {
            count -= 8;
            bytes += static_cast<char>(static_cast<unsigned char>(bits >> count & 255U));
        }
    }
    return bytes;
}

const json& entity(const json& scene, std::string_view id) {
    for (const json& one : scene.at("entities")) {
        if (one.at("id") == id) return one;
    }
    throw std::out_of_range(std::string(id));
}

TEST(LiveMessages, AreWhatTheirSchemasSay) {
    const Snapshot full = full_snapshot();
    const Snapshot none;
    for (const Channel& channel : channels()) {
        const std::string topic(channel.topic);
        EXPECT_FALSE(channel.message({full, 0.25}).empty()) << topic;
        for (const Snapshot* snapshot : {&full, &none}) {
            const std::string text = channel.message({*snapshot, 0.25});
            if (!text.empty()) expect_valid(json::parse(text), channel.schema(), topic);
        }
    }
}

/// What Foxglove's own schemas require, at the top.
TEST(LiveMessages, HaveWhatFoxgloveRequires) {
    const std::map<std::string_view, std::set<std::string>> required{
        {"foxglove.FrameTransform",
         {"timestamp", "parent_frame_id", "child_frame_id", "translation", "rotation"}},
        {"foxglove.PoseInFrame", {"timestamp", "frame_id", "pose"}},
        {"foxglove.PosesInFrame", {"timestamp", "frame_id", "poses"}},
        {"foxglove.SceneUpdate", {"deletions", "entities"}},
        {"foxglove.PointCloud",
         {"timestamp", "frame_id", "pose", "point_stride", "fields", "data"}},
        {"foxglove.Grid",
         {"timestamp", "frame_id", "pose", "column_count", "cell_size", "row_stride", "cell_stride",
          "fields", "data"}}};
    const Snapshot full = full_snapshot();
    int known = 0;
    for (const Channel& channel : channels()) {
        const auto found = required.find(channel.schema_name);
        if (found == required.end()) continue;
        ++known;
        const json message = json::parse(channel.message({full, {}}));
        for (const std::string& name : found->second) {
            EXPECT_TRUE(message.contains(name)) << channel.topic << name;
        }
        EXPECT_EQ(channel.schema()["title"], channel.schema_name);
    }
    EXPECT_EQ(known, 9);
}

TEST(LiveMessages, ThePoseIsOneTransformAndAQuaternion) {
    const Snapshot full = full_snapshot();
    const json tf = json::parse(tf_message({full, {}}));
    EXPECT_EQ(tf["timestamp"], json({{"sec", 3}, {"nsec", 0}}));
    EXPECT_DOUBLE_EQ(tf["translation"]["x"], 2.0);
    EXPECT_DOUBLE_EQ(tf["translation"]["y"], 0.5);
    EXPECT_NEAR(tf["rotation"]["z"], std::sin(0.05), 1e-6);
    EXPECT_NEAR(tf["rotation"]["w"], std::cos(0.05), 1e-6);
    const json pose = json::parse(pose_message({full, {}}));
    EXPECT_EQ(pose["pose"]["position"], tf["translation"]);
    EXPECT_EQ(pose["pose"]["orientation"], tf["rotation"]);
}

TEST(LiveMessages, LongPathsAreThinnedToBothEnds) {
    const json poses = json::parse(path_message({snapshot_after(10001), {}}))["poses"];
    EXPECT_LE(poses.size(), 2000U);
    EXPECT_GE(poses.size(), 1000U);
    EXPECT_EQ(poses.front()["position"]["x"], 0.0);
    EXPECT_EQ(poses.back()["position"]["x"], 10000.0);
    EXPECT_EQ(json::parse(path_message({snapshot_after(1999), {}}))["poses"].size(), 1999U);
    // No way leads to where another tour begins: the first pose that is told of it.
    Snapshot two = snapshot_after(10001);
    EXPECT_FALSE(json::parse(path_message({two, {}})).contains("begins"));
    two.best_trajectory[5001].begins = true;
    const std::size_t stride = two.best_trajectory.size() / (poses.size() - 1);
    EXPECT_EQ(json::parse(path_message({two, {}}))["begins"],
              json::array({(5001 + stride - 1) / stride}));
}

TEST(LiveMessages, OfOneHypothesisThereAreNoParticles) {
    Snapshot snapshot = full_snapshot();
    EXPECT_EQ(json::parse(particles_message({snapshot, {}}))["poses"].size(), 3U);
    snapshot.hypotheses.resize(1);
    EXPECT_EQ(particles_message({snapshot, {}}), "");
}

/// sqrt(5.991) standard deviations along each axis.
TEST(LiveMessages, EllipsesHold95Percent) {
    const json message = json::parse(landmarks_message({full_snapshot(), {}}));
    const json& regions = entity(message, "regions")["lines"];
    ASSERT_EQ(regions.size(), 2U);
    EXPECT_EQ(regions[0]["type"], 1);
    for (const json& point : regions[0]["points"]) {
        const double x = (point["x"].get<double>() - 1.0) / 0.3;
        const double y = (point["y"].get<double>() - 2.0) / 0.1;
        EXPECT_NEAR(x * x + y * y, 5.991, 0.02);
    }
    const json& wall = entity(message, "lines")["lines"][0];
    EXPECT_EQ(wall["type"], 2);
    EXPECT_EQ(wall["points"][0], json({{"x", -1.0}, {"y", 2.0}, {"z", 0}}));
    EXPECT_EQ(wall["points"][1], json({{"x", 3.0}, {"y", 2.0}, {"z", 0}}));
    const json covariance = json::parse(covariance_message({full_snapshot(), {}}));
    EXPECT_EQ(entity(covariance, "pose")["lines"].size(), 2U);
}

TEST(LiveMessages, LoopsAreClosedOrRefused) {
    const json message = json::parse(loops_message({full_snapshot(), {}}));
    EXPECT_EQ(entity(message, "closed")["lines"][0]["points"].size(), 4U);
    EXPECT_EQ(entity(message, "refused")["lines"][0]["points"].size(), 2U);
}

TEST(LiveMessages, TheScanIsPackedInFloats) {
    const json message = json::parse(scan_message({full_snapshot(), {}}));
    const std::string bytes = decoded(message["data"].get<std::string>());
    ASSERT_EQ(bytes.size(), 16U);
    std::vector<float> values(4);
    std::memcpy(values.data(), bytes.data(), bytes.size());  // as machines have them
    EXPECT_THAT(values, ::testing::ElementsAre(1.0F, -2.0F, 0.5F, 0.25F));
}

TEST(LiveMessages, TheGridIsItsPictureFromBelow) {
    const Snapshot full = full_snapshot();
    Grid grid;
    grid.add(full.scan, full.best_pose);
    const Grid::Picture picture = grid.picture();
    const json message = json::parse(grid_message({full, {}}));
    const std::string cells = decoded(message["data"].get<std::string>());
    const auto width = static_cast<std::size_t>(picture.width);
    const auto height = static_cast<std::size_t>(picture.height);
    ASSERT_EQ(message["column_count"], picture.width);
    ASSERT_EQ(cells.size(), width * height);
    EXPECT_DOUBLE_EQ(message["pose"]["position"]["x"], grid.origin().x);
    EXPECT_DOUBLE_EQ(message["pose"]["position"]["y"], grid.origin().y);
    for (std::size_t row = 0; row < height; ++row) {
        for (std::size_t column = 0; column < width; ++column) {
            ASSERT_EQ(static_cast<std::uint8_t>(cells[row * width + column]),
                      picture.grey[(height - 1 - row) * width + column])
                << row << ", " << column;
        }
    }
}

TEST(LiveMessages, AGreatGridIsToldInGreaterCells) {
    Snapshot snapshot = full_snapshot();
    GridTiles& grid = snapshot.step_grid;
    grid.area = {-64, -64, 4032, 4032};
    grid.first_column = grid.first_row = -1;
    grid.columns = grid.rows = 64;
    auto tile = std::make_shared<GridTile>();
    tile->grey.fill(kUnknownGrey);
    tile->grey[0] = 255;
    tile->grey[1] = 10;  // beside a free one: the darker is told
    grid.tiles.assign(4096, nullptr);
    grid.tiles[1] = tile;
    const json message = json::parse(grid_message({snapshot, {}}));
    const std::string cells = decoded(message["data"].get<std::string>());
    ASSERT_EQ(message["column_count"], 2048);
    ASSERT_EQ(cells.size(), std::size_t{2048} * 2048);
    EXPECT_DOUBLE_EQ(message["cell_size"]["x"], 2.0 * grid.resolution_m);
    EXPECT_EQ(static_cast<std::uint8_t>(cells[32]), 10);
    EXPECT_EQ(static_cast<std::uint8_t>(cells[33]), kUnknownGrey);
}

TEST(LiveMessages, WhatIsNoNumberIsLeftOut) {
    Snapshot snapshot = full_snapshot();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    snapshot.best_pose.x = nan;
    snapshot.mean_pose.y = std::numeric_limits<double>::infinity();
    snapshot.pose_covariance.setConstant(nan);
    snapshot.best_trajectory[1].pose.theta = nan;
    snapshot.best_map[1].value = Esquina{nan, 1.0};
    snapshot.scan.points[0].x = nan;
    snapshot.scan.time_s = nan;
    for (const Channel& channel : channels()) {
        const std::string text = channel.message({snapshot, {}});
        ASSERT_FALSE(text.empty()) << channel.topic;
        expect_valid(json::parse(text), channel.schema(), std::string(channel.topic));
    }
    EXPECT_EQ(json::parse(path_message({snapshot, {}}))["poses"].size(), 2U);
}

TEST(LiveMessages, TimesAreNeverNegative) {
    Snapshot snapshot;
    for (const auto& [time_s, ns] :
         std::map<double, std::uint64_t>{{-1.0, 0},
                                         {0.0, 0},
                                         {0.5, 500000000},
                                         {1234567890.25, 1234567890250000000},
                                         {1e300, 4000000000000000000}}) {
        snapshot.scan.time_s = time_s;
        EXPECT_EQ(time_ns(snapshot), ns) << time_s;
    }
}

TEST(LiveMessages, OfManyLandmarksThoseSeenLastHaveRegions) {
    Snapshot snapshot = full_snapshot();
    snapshot.line_extents.clear();
    ICaracteristica corner = snapshot.best_map[1];
    snapshot.best_map.clear();
    for (std::uint32_t i = 0; i < 1500; ++i) {
        corner.value = Esquina{static_cast<double>(i), 0.0};
        corner.last_seen = i / 3;
        snapshot.best_map.push_back(corner);
    }
    const json message = json::parse(landmarks_message({snapshot, {}}));
    EXPECT_EQ(entity(message, "regions")["lines"].size(), 1000U);
    EXPECT_EQ(entity(message, "corners")["lines"][0]["points"].size(), 6000U);
}

TEST(Base64, IsThatOfTheStandard) {
    const std::map<std::string, std::string> cases{
        {"", ""},        {"f", "Zg=="},          {"fo", "Zm8="},
        {"foo", "Zm9v"}, {"foobar", "Zm9vYmFy"}, {"\xff\xfe\xfd", "//79"}};
    for (const auto& [bytes, text] : cases) EXPECT_EQ(base64(bytes), text);
}

}  // namespace
}  // namespace hitos::live
