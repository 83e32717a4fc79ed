// SPDX-License-Identifier: GPL-3.0-or-later
// The small texts of maps and paths.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "hitos/services/evaluation/distances.hpp"
#include "hitos/services/evaluation/relations.hpp"
#include "hitos/services/files/dxf_file.hpp"
#include "hitos/services/files/g2o_file.hpp"
#include "hitos/services/files/map_file.hpp"
#include "hitos/services/files/segment_file.hpp"
#include "hitos/services/files/trajectory_file.hpp"
#include "laws.hpp"
#include "targets.hpp"

namespace hitos::fuzz {
namespace {

constexpr const char* kMapName = "input";

bool is_normal(const Recta& line) {
    return std::isfinite(line.rho) && line.rho >= 0.0 && line.theta > -kPi && line.theta <= kPi;
}

/// Degrees may cost the last bit of an angle.
bool same(const Recta& a, const Recta& b) {
    constexpr double kLastBits = 1e-15;
    return a.rho == b.rho && std::abs(wrap_angle(a.theta - b.theta)) <= kLastBits;
}

template <class Feature>
std::vector<Feature> all_of(const LandmarkMap& map) {
    std::vector<Feature> found;
    for (const ICaracteristica& landmark : map) {
        if (const auto* feature = std::get_if<Feature>(&landmark.value)) found.push_back(*feature);
    }
    return found;
}

/// A map of that many lines.
LandmarkMap lines_of(int count) {
    return LandmarkMap(static_cast<std::size_t>(count), ICaracteristica{Recta{1.0, 0.0}});
}

}  // namespace

bool check_map(std::string_view input) {
    const auto map = unless_refused([&] { return parse_map(input, kMapName); });
    if (!map) return false;
    const std::vector<Recta> lines = all_of<Recta>(*map);
    const std::vector<Esquina> corners = all_of<Esquina>(*map);
    require(std::ranges::all_of(lines, is_normal), "lines are read in normal form");
    require(std::ranges::all_of(corners,
                                [](const Esquina& c) {
                                    return is_finite({c.x, c.y});
                                }),
            "corners are finite");
    const LandmarkMap again = parse_map(map_to_text(*map), kMapName);
    require(std::ranges::equal(lines, all_of<Recta>(again), same), "lines read back");
    require(all_of<Esquina>(again) == corners, "corners read back to the last bit");
    unless_refused([&] { return dxf_text(*map, {}, {}); });  // too far away to be drawn
    return true;
}

bool check_segments(std::string_view input) {
    const auto segments = unless_refused([&] { return parse_segments(input, kMapName); });
    if (!segments) return false;
    int lines = 0;
    for (const LineExtent& segment : *segments) {
        require(segment.landmark >= 0, "a segment belongs to a line");
        require(is_finite(segment.a) && is_finite(segment.b), "segments are finite");
        lines = std::max(lines, segment.landmark + 1);
    }
    constexpr int kMostLines = 1000;
    if (lines > kMostLines) return true;
    const auto again = parse_segments(segments_to_text(lines_of(lines), *segments), kMapName);
    require(std::ranges::equal(*segments, again,
                               [](const LineExtent& a, const LineExtent& b) {
                                   return a.landmark == b.landmark && a.a == b.a && a.b == b.b;
                               }),
            "segments read back to the last bit");
    return true;
}

bool check_distances(std::string_view input) {
    const auto distances = unless_refused([&] { return parse_distances(input, kMapName); });
    if (!distances) return false;
    for (const NamedDistance& distance : *distances) {
        require(is_distance_name(distance.name), "distances have names");
        require(is_finite(distance.a) && is_finite(distance.b), "distances have finite ends");
        require(distance.true_m() >= kLeastDistance, "distances have a length");
    }
    require(parse_distances(distances_text(*distances), kMapName) == *distances,
            "distances read back to the last bit");
    const LandmarkMap box{{Recta{2.0, 0.0}}, {Recta{2.0, kPi}}, {Recta{1.0, kPi / 2.0}}};
    const std::vector<MeasuredDistance> measured = measure_distances(box, *distances);
    require(measured.size() == distances->size(), "every distance is measured");
    require(!distance_table(measured).empty() && !distances_csv(measured).empty(),
            "what is measured can be told");
    return true;
}

bool check_relations(std::string_view input) {
    const auto relations = unless_refused([&] { return parse_relations(input, kMapName); });
    if (!relations) return false;
    for (const PoseRelation& relation : *relations) {
        require(std::isfinite(relation.from_s) && std::isfinite(relation.to_s) &&
                    is_finite({relation.pose_from_to.x, relation.pose_from_to.y}),
                "relations are finite");
    }
    require(parse_relations(relations_text(*relations), kMapName) == *relations,
            "relations read back to the last bit");
    const Trajectory path{{0.0, {}}, {1.0, {1.0, 2.0, 3.0}}};
    constexpr double kAnyStamp = 1e15;
    const auto measured = measure_relations(path, *relations, kAnyStamp);
    const RelationErrors errors = relation_errors(measured);
    for (const auto* figures : {&errors.translation_m, &errors.rotation_rad,
                                &errors.translation_squared_m2, &errors.rotation_squared_rad2}) {
        require(std::isfinite(figures->rmse) && std::isfinite(figures->deviation) &&
                    std::isfinite(figures->maximum),
                "figures of what is read are numbers");
    }
    require(!relations_csv(measured).empty(), "what is measured can be told");
    return true;
}

bool check_trajectory(std::string_view input) {
    const auto path = unless_refused([&] { return parse_trajectory(input, kMapName); });
    if (!path) return false;
    for (const auto& [time_s, pose, begins] : *path) {
        require(std::isfinite(time_s) && is_finite({pose.x, pose.y}), "poses are finite");
        require(pose.theta > -kPi && pose.theta <= kPi, "headings are wrapped");
        require(!begins || time_s != path->front().time_s || path->size() > 1,
                "no tour comes before the first pose");
    }
    const Trajectory again = parse_trajectory(trajectory_to_text(*path), kMapName);
    constexpr double kDecimals = 1e-9;
    constexpr double kOfQuaternion = 5e-9;
    require(std::ranges::equal(*path, again,
                               [](const StampedPose& a, const StampedPose& b) {
                                   return a.time_s == b.time_s &&
                                          std::abs(a.pose.x - b.pose.x) <= kDecimals &&
                                          std::abs(a.pose.y - b.pose.y) <= kDecimals &&
                                          std::abs(wrap_angle(a.pose.theta - b.pose.theta)) <=
                                              kOfQuaternion;
                               }),
            "a path reads back to nine decimals");
    return true;
}

bool check_graph(std::string_view input) {
    auto file = unless_refused([&] { return parse_g2o(input, "input"); });
    if (!file) return false;
    const std::string text = g2o_text(file->graph);
    require(g2o_text(parse_g2o(text, "input").graph) == text, "graphs read back to the last bit");
    constexpr std::size_t kSmall = 30;  // solving goes on for 200 steps where nothing fits
    PlanarGraph& graph = file->graph;
    if (graph.vertices.size() > kSmall || graph.edges.size() > kSmall) return true;
    for (const bool robust : {false, true}) {
        const auto solution = unless_refused([&] { return solve(graph, robust); });
        if (!solution) continue;
        require(robust || solution->chi_square_after <= solution->chi_square_before,
                "chi square does not grow");
        require(!g2o_text(graph).empty(), "what is solved is finite");
    }
    return true;
}

}  // namespace hitos::fuzz
