// SPDX-License-Identifier: GPL-3.0-or-later
#include "live_channels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <utility>

#include "json_input.hpp"
#include "live_messages.hpp"

namespace hitos::live {
namespace {

using nlohmann::json;
using Fields = std::initializer_list<std::pair<const char*, json>>;

// JSON Schema of Foxglove's well-known messages, as far as they are told.

json object(const char* title, Fields fields) {
    json properties = json::object();
    json required = json::array();
    for (const auto& [name, schema] : fields) {
        properties[name] = schema;
        required.push_back(name);
    }
    return {{"type", "object"},
            {"title", title},
            {"properties", std::move(properties)},
            {"required", std::move(required)}};
}
json array_of(const json& items) {
    return {{"type", "array"}, {"items", items}};
}
json number() {
    return {{"type", "number"}};
}
json integer() {
    return {{"type", "integer"}, {"minimum", 0}};
}
json text() {
    return {{"type", "string"}};
}
json flag() {
    return {{"type", "boolean"}};
}
json bytes() {
    return {{"type", "string"}, {"contentEncoding", "base64"}};
}
json time() {
    return object("time", {{"sec", integer()}, {"nsec", integer()}});
}
json vector3() {
    return object("foxglove.Vector3", {{"x", number()}, {"y", number()}, {"z", number()}});
}
json quaternion() {
    return object("foxglove.Quaternion",
                  {{"x", number()}, {"y", number()}, {"z", number()}, {"w", number()}});
}
json pose() {
    return object("foxglove.Pose", {{"position", vector3()}, {"orientation", quaternion()}});
}
json fields() {
    return array_of(object("foxglove.PackedElementField",
                           {{"name", text()}, {"offset", integer()}, {"type", integer()}}));
}

json run_schema() {
    json schema = object("hitos.Run", {{"timestamp", time()},
                                       {"scans", integer()},
                                       {"lines", integer()},
                                       {"corners", integer()},
                                       {"particles", integer()}});
    schema["properties"]["tour_s"] = number();
    schema["properties"]["behind_s"] = number();
    return schema;
}

json transform_schema() {
    return object("foxglove.FrameTransform", {{"timestamp", time()},
                                              {"parent_frame_id", text()},
                                              {"child_frame_id", text()},
                                              {"translation", vector3()},
                                              {"rotation", quaternion()}});
}

json pose_schema() {
    return object("foxglove.PoseInFrame",
                  {{"timestamp", time()}, {"frame_id", text()}, {"pose", pose()}});
}

json poses_schema() {
    return object("foxglove.PosesInFrame",
                  {{"timestamp", time()}, {"frame_id", text()}, {"poses", array_of(pose())}});
}

json scene_schema() {
    const json colour = object(
        "foxglove.Color", {{"r", number()}, {"g", number()}, {"b", number()}, {"a", number()}});
    const json line = object("foxglove.LinePrimitive", {{"type", integer()},
                                                        {"pose", pose()},
                                                        {"thickness", number()},
                                                        {"scale_invariant", flag()},
                                                        {"points", array_of(vector3())},
                                                        {"color", colour},
                                                        {"colors", array_of(colour)},
                                                        {"indices", array_of(integer())}});
    const json none = array_of(object("", {}));  // of which there are none
    const json lifetime = object("duration", {{"sec", integer()}, {"nsec", integer()}});
    const json entity = object("foxglove.SceneEntity", {{"timestamp", time()},
                                                        {"frame_id", text()},
                                                        {"id", text()},
                                                        {"lifetime", lifetime},
                                                        {"frame_locked", flag()},
                                                        {"metadata", none},
                                                        {"arrows", none},
                                                        {"cubes", none},
                                                        {"spheres", none},
                                                        {"cylinders", none},
                                                        {"lines", array_of(line)},
                                                        {"triangles", none},
                                                        {"texts", none},
                                                        {"models", none}});
    return object("foxglove.SceneUpdate", {{"deletions", none}, {"entities", array_of(entity)}});
}

json grid_schema() {
    const json size = object("foxglove.Vector2", {{"x", number()}, {"y", number()}});
    return object("foxglove.Grid", {{"timestamp", time()},
                                    {"frame_id", text()},
                                    {"pose", pose()},
                                    {"column_count", integer()},
                                    {"cell_size", size},
                                    {"row_stride", integer()},
                                    {"cell_stride", integer()},
                                    {"fields", fields()},
                                    {"data", bytes()}});
}

json points_schema() {
    return object("foxglove.PointCloud", {{"timestamp", time()},
                                          {"frame_id", text()},
                                          {"pose", pose()},
                                          {"point_stride", integer()},
                                          {"fields", fields()},
                                          {"data", bytes()}});
}

constexpr std::size_t kGridChannel = 8;

constexpr std::array<Channel, 10> kChannels{{
    {"/tf", "foxglove.FrameTransform", &transform_schema, &tf_message},
    {"/pose", "foxglove.PoseInFrame", &pose_schema, &pose_message},
    {"/path", "foxglove.PosesInFrame", &poses_schema, &path_message},
    {"/particles", "foxglove.PosesInFrame", &poses_schema, &particles_message},
    {"/covariance", "foxglove.SceneUpdate", &scene_schema, &covariance_message},
    {"/landmarks", "foxglove.SceneUpdate", &scene_schema, &landmarks_message},
    {"/loops", "foxglove.SceneUpdate", &scene_schema, &loops_message},
    {"/scan", "foxglove.PointCloud", &points_schema, &scan_message},
    {"/grid", "foxglove.Grid", &grid_schema, &grid_message},
    {"/run", "hitos.Run", &run_schema, &run_message},
}};
static_assert(kChannels[kGridChannel].topic == "/grid");

}  // namespace

std::span<const Channel> channels() {
    return kChannels;
}

std::size_t grid_channel() {
    return kGridChannel;
}

std::uint64_t time_ns(const Snapshot& snapshot) {
    constexpr double kNanoseconds = 1e9;
    constexpr double kLatest = 4e9;  // [s]: of 32 bits, which readers keep seconds in
    const double stamp_s = snapshot.scan.stamp_s();
    if (!(stamp_s > 0.0)) return 0;
    const double whole_s = std::floor(std::min(stamp_s, kLatest));
    const double rest_ns =
        std::round((std::min(stamp_s, kLatest) - whole_s) * kNanoseconds);  // 1e9 too
    return static_cast<std::uint64_t>(whole_s) * 1000000000U + static_cast<std::uint64_t>(rest_ns);
}

std::string server_info(const std::string& name, const std::string& session) {
    return json_text({{"op", "serverInfo"},
                      {"name", name},
                      {"capabilities", json::array()},
                      {"sessionId", session}},
                     -1);
}

std::string advertisement() {
    json list = json::array();
    for (std::size_t id = 0; id < kChannels.size(); ++id) {
        const Channel& channel = kChannels[id];
        list.push_back({{"id", id},
                        {"topic", channel.topic},
                        {"encoding", "json"},
                        {"schemaName", channel.schema_name},
                        {"schemaEncoding", "jsonschema"},
                        {"schema", channel.schema().dump()}});
    }
    return json_text({{"op", "advertise"}, {"channels", std::move(list)}}, -1);
}

}  // namespace hitos::live
