// SPDX-License-Identifier: GPL-3.0-or-later
// Worlds to simulate, and drawings of their walls.
#include <algorithm>
#include <cmath>
#include <string>

#include "hitos/services/files/dxf_file.hpp"
#include "hitos/simulation/drawings/dxf_walls.hpp"
#include "hitos/simulation/text/world_editing.hpp"
#include "hitos/simulation/text/world_text.hpp"
#include "hitos/simulation/worlds/reference_map.hpp"
#include "hitos/simulation/worlds/world_key.hpp"
#include "laws.hpp"
#include "targets.hpp"
#include "worlds/world_reading.hpp"

namespace hitos::fuzz {
namespace {

/// Beside every world, so that it can name it.
constexpr std::string_view kDrawing =
    "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\nWALLS\n10\n0\n20\n0\n11\n4\n21\n0\n0\nENDSEC\n0\nEOF\n";

const std::filesystem::path& world_file() {
    static const ScratchFolder scratch;
    static const std::filesystem::path drawing_file = scratch.put("walls.dxf", kDrawing);
    static const std::filesystem::path input_file = scratch.path() / "input.toml";
    return input_file;
}

void require_sound(const World& world) {
    require(!world.walls.empty(), "a world has walls");
    require(std::ranges::all_of(world.walls,
                                [](const WallSegment& wall) {
                                    return is_finite(wall.a) && is_finite(wall.b) &&
                                           wall.a != wall.b;
                                }),
            "walls are finite and have two ends");
    require(std::ranges::all_of(world.tour.way_points,
                                [](const WayPoint& point) { return is_finite(point.at); }),
            "way points are finite");
    require(std::ranges::all_of(world_keys(),
                                [&](const WorldKey& key) { return key.allows(key.get(world)); }),
            "a world's values are allowed");
    // Values that are each allowed can be impossible together.
    unless_refused([&] { return check(world), true; });
    for (const ICaracteristica& landmark : reference_map(world)) {
        const auto* line = std::get_if<Recta>(&landmark.value);
        const auto* corner = std::get_if<Esquina>(&landmark.value);
        require(line != nullptr ? std::isfinite(line->rho) && std::isfinite(line->theta)
                                : is_finite({corner->x, corner->y}),
                "a world's landmarks are finite");
    }
}

using Walls = std::vector<std::vector<Point2>>;

/// The pieces of the walls as a drawing of a map, and that one read again.
void require_round_trip(const Walls& walls) {
    constexpr double kGreatest = 1e6;    // m; beyond it decimals are missing
    constexpr double kTolerance = 1e-6;  // m
    constexpr std::size_t kMost = 50;
    LandmarkMap map;
    std::vector<LineExtent> pieces;
    for (const std::vector<Point2>& wall : walls) {
        for (std::size_t i = 1; i < wall.size() && pieces.size() < kMost; ++i) {
            const Point2& a = wall[i - 1];
            const Point2& b = wall[i];
            const double greatest =
                std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)});
            if (greatest > kGreatest || std::hypot(b.x - a.x, b.y - a.y) < kTolerance) continue;
            pieces.push_back({static_cast<int>(map.size()), a, b, 0});
            map.push_back({line_through(a, b)});
        }
    }
    if (pieces.empty()) return;
    const Walls again = read_dxf_walls(file_of(dxf_text(map, pieces, {})), {kDxfLines, 1.0}).walls;
    const auto near = [](const Point2& a, const Point2& b) {
        return std::abs(a.x - b.x) <= kTolerance && std::abs(a.y - b.y) <= kTolerance;
    };
    require(std::ranges::equal(pieces, again,
                               [&](const LineExtent& piece, const std::vector<Point2>& wall) {
                                   return wall.size() == 2 && near(piece.a, wall[0]) &&
                                          near(piece.b, wall[1]);
                               }),
            "a drawing of a map reads back");
}

/// A world set to itself changes no byte, and one that is set reads back.
void require_editable(std::string_view input, const World& world) {
    WorldText text(std::string(input), world_file());
    text.set(world);
    require(text.text() == input, "a world set to itself stays as it is written");
    World other = world;
    other.tour.start.x += 1.0;
    other.laser.sigma_m = 0.125;
    other.tour.events.clear();
    std::vector<Polyline> walls = text.walls();
    walls.push_back({{1, 2}, {3, 4.5}});
    unless_refused([&] {
        text.set(other);
        text.set_walls(walls);
        return true;
    });
    require(same_world(parse_world(text.text(), world_file()), text.world()),
            "what was edited reads back");
}

/// One of the things that a user does to a drawn world.
void edit(WorldText& text, unsigned what, const Point2& a, const Point2& b, unsigned number) {
    constexpr unsigned kKinds = 8;
    constexpr double kReach = 4.0;  // m
    const auto item = item_at(text, a, kReach);
    switch (what % kKinds) {
        case 0:
            return add_wall(text, {a, b});
        case 1:
            return add_door(text, a, b);
        case 2:
            return add_box(text, a, number / 64.0);
        case 3:
            return add_person(text, {a, b});
        case 4:
            return add_way_point(text, a);
        case 5:
            if (item) move_item(text, *item, b);
            return;
        case 6:
            if (item) remove_item(text, number % 2 == 0 ? *item : whole_of(text, *item));
            return;
        default:
            if (!item) return;
            const std::vector<ItemNumber> numbers = numbers_of(text, *item);
            if (numbers.empty()) return;
            return set_number(text, *item, number % numbers.size(), b.x);
    }
}

}  // namespace

bool check_world(std::string_view input) {
    const auto world = unless_refused([&] { return parse_world(input, world_file()); });
    if (world) {
        require_sound(*world);
        require_editable(input, *world);
    }
    return world.has_value();
}

bool check_world_edits(std::string_view input) {
    const std::size_t end = std::min(input.find('\0'), input.size());
    const auto world =
        unless_refused([&] { return WorldText(std::string(input.substr(0, end)), world_file()); });
    if (!world) return false;
    WorldText text = *world;
    constexpr std::size_t kEdit = 6;  // bytes
    constexpr std::size_t kMost = 30;
    std::string_view rest = input.substr(std::min(end + 1, input.size()));
    for (std::size_t i = 0; i < kMost && rest.size() >= kEdit; ++i, rest.remove_prefix(kEdit)) {
        const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(rest[at]); };
        const auto metres = [&](std::size_t at) { return (byte(at) - 128) / 8.0; };
        const Point2 a{metres(1), metres(2)};
        const Point2 b{metres(3), metres(4)};
        const std::string before = text.text();
        const auto done = unless_refused([&] {
            edit(text, byte(0), a, b, byte(5));
            return true;
        });
        require(done || text.text() == before, "what cannot be changes nothing");
        require(same_world(parse_unfinished_world(text.text(), world_file()), text.world()),
                "what was edited reads back");
    }
    return true;
}

bool check_drawing(std::string_view input) {
    const std::filesystem::path& file = file_of(input);
    const auto of_layer = unless_refused([&] { return read_dxf_walls(file, {"WALLS", {}}).walls; });
    const auto walls = unless_refused([&] { return read_dxf_walls(file).walls; });
    for (const auto& found : {of_layer, walls}) {
        if (!found) continue;
        require(!found->empty(), "a drawing that is read has walls");
        for (const std::vector<Point2>& wall : *found) {
            require(wall.size() >= 2, "a wall has two points");
            require(std::ranges::all_of(wall, is_finite), "walls are finite");
        }
    }
    if (walls) require_round_trip(*walls);
    return walls.has_value();
}

}  // namespace hitos::fuzz
