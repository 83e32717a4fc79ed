// SPDX-License-Identifier: GPL-3.0-or-later
// Reads world files; their lists of tables are read beside (world_lists).
#include "hitos/simulation/worlds/world.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <cmath>
#include <optional>
#include <system_error>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/base/text_limits.hpp"
#include "hitos/simulation/drawings/dxf_walls.hpp"
#include "world_lists.hpp"
#include "world_reading.hpp"
#include "world_values.hpp"

namespace hitos {
namespace {

class Reading {
  public:
    explicit Reading(const std::filesystem::path& path) : path_(path) {
        world_.name = path.stem().string();
        world_.file = path.string();
    }

    World read(const toml::table& document) {
        for (const auto& [key, node] : document) {
            const toml::table* group = node.as_table();
            if (group == nullptr) {
                read_top(key, node);
                continue;
            }
            const std::string_view name = key.str();
            if (name != "tour" && name != "robot" && name != "laser" && name != "landmarks" &&
                name != "raster" && name != "odometry") {
                fail(key.source(), message(HITOS_TEXT("Errors",
                                                      "[%1]: no such group; expected [tour], "
                                                      "[robot], [laser], [landmarks], [raster] or "
                                                      "[odometry]"),
                                           name));
            }
            for (const auto& [inner, value] : *group)
                read_value(fmt::format("{}.{}", name, inner.str()), inner.source(), value);
        }
        if (!drawing_.empty()) add_drawing();
        if (!world_.tour.way_points.empty() && !world_.tour.commands.empty()) {
            throw FormatError(
                path_.string(), world_.tour.commands.front().line,
                HITOS_TEXT("Errors",
                           "found way_points and commands in [tour], expected one of them"));
        }
        if (const Message problem = problem_of(world_.landmarks); !problem.empty())
            fail(radii_at_, message("landmarks.radii: %1", problem));
        world_lists::check_events(world_, path_);
        return std::move(world_);
    }

  private:
    [[noreturn]] void fail(const toml::source_region& where, const Message& problem) const {
        throw FormatError(path_.string(), where.begin.line, problem);
    }

    void read_top(const toml::key& key, const toml::node& node) {
        const std::string_view name = key.str();
        if (name == "walls") {
            read_walls(key, node);
        } else if (name == "walls_dxf") {
            drawing_ = words(key, node);
            drawing_at_ = key.source();
        } else if (name == "dxf_layer") {
            dxf_.layer = words(key, node);
        } else if (name == "dxf_unit") {
            dxf_.unit_m = number(node);
            if (!dxf_.unit_m || !(*dxf_.unit_m > 0.0) || !std::isfinite(*dxf_.unit_m)) {
                fail(key.source(),
                     message(HITOS_TEXT(
                         "Errors", "dxf_unit: expected the metres per drawing unit, more than 0")));
            }
        } else if (name == "doors") {
            world_lists::read_doors(world_, path_, node);
        } else if (name == "people") {
            world_lists::read_people(world_, path_, node);
        } else if (name == "seed") {
            read_value("seed", key.source(), node);
        } else {
            fail(key.source(),
                 message(
                     HITOS_TEXT(
                         "Errors",
                         "%1: no such key; expected walls, walls_dxf, dxf_layer, dxf_unit, doors, "
                         "people, seed, [tour], [robot], [laser], [landmarks], [raster] or "
                         "[odometry]"),
                     name));
        }
    }

    void read_value(const std::string& key, const toml::source_region& where,
                    const toml::node& node) {
        if (key == "tour.start") {
            read_start(node);
            return;
        }
        if (key == "tour.way_points") {
            read_way_points(where, node);
            return;
        }
        if (key == "landmarks.at" || key == "landmarks.radii") {
            (key == "landmarks.at" ? world_lists::read_landmarks : world_lists::read_radii)(
                world_, path_, node);
            if (key == "landmarks.radii") radii_at_ = where;
            return;
        }
        if (key == "tour.commands" || key == "tour.events") {
            (key == "tour.events" ? world_lists::read_events : world_lists::read_commands)(
                world_, path_, node);
            return;
        }
        try {
            const WorldKey& known = world_values::find(key);
            if (const auto* word = node.as_string(); word != nullptr && is_choice(known)) {
                world_values::set_word(world_, known, word->get());
            } else if (const auto* flag = node.as_boolean(); flag != nullptr) {
                world_values::set_word(world_, known, flag->get() ? "true" : "false");
            } else if (const auto value = number(node); value && !is_choice(known)) {
                world_values::set_number(world_, known, *value);
            } else {
                fail(where, message(HITOS_TEXT("Errors", "%1: expected %2"), key,
                                    world_values::allowed(known)));
            }
        } catch (const ConfigError& error) {
            fail(where, error.message());
        }
    }

    void read_walls(const toml::key& key, const toml::node& node) {
        const toml::array* walls = node.as_array();
        if (walls == nullptr) {
            fail(key.source(),
                 message(HITOS_TEXT("Errors", "walls: expected a list of polylines")));
        }
        for (const toml::node& wall : *walls) {
            ++walls_;
            const toml::array* points = wall.as_array();
            if (points == nullptr || points->size() < 2) {
                fail(
                    wall.source(),
                    message(HITOS_TEXT(
                                "Errors",
                                "wall %1: found %2, expected two points or more, [[x, y], [x, y]]"),
                            walls_,
                            points == nullptr ? message(HITOS_TEXT("Errors", "no list of points"))
                            : points->empty() ? message(HITOS_TEXT("Errors", "no point"))
                                              : message(HITOS_TEXT("Errors", "one point"))));
            }
            std::optional<Point2> before;
            for (const toml::node& entry : *points) {
                const Point2 at = world_lists::read_point(
                    path_, entry, message(HITOS_TEXT("Errors", "wall %1"), walls_));
                if (before) add_segment(*before, at, entry.source().begin.line);
                before = at;
            }
        }
    }

    void add_segment(const Point2& a, const Point2& b, std::uint64_t line) {
        if (a == b) {
            throw FormatError(path_.string(), line,
                              HITOS_TEXT("Errors",
                                         "wall %1: found the point (%2, %3) twice in a row, "
                                         "expected two different ones"),
                              walls_, fmt::format("{:g}", a.x), fmt::format("{:g}", a.y));
        }
        world_.walls.push_back({a, b, walls_, line});
    }

    void add_drawing() {
        const std::filesystem::path drawing = path_.parent_path() / drawing_;
        std::error_code ignored;  // of a path that cannot be, there is no file either
        if (!std::filesystem::exists(drawing, ignored)) {
            fail(drawing_at_,
                 message(HITOS_TEXT("Errors", "walls_dxf: %1: no such file"), drawing.string()));
        }
        world_.drawing = drawing;
        DxfWalls drawn = read_dxf_walls(drawing, dxf_);
        for (const std::vector<Point2>& wall : drawn.walls) {
            ++walls_;
            for (std::size_t i = 1; i < wall.size(); ++i) add_segment(wall[i - 1], wall[i], 0);
        }
        world_.drawing_notes = std::move(drawn.notes);
        world_.drawing_warnings = std::move(drawn.warnings);
    }

    void read_start(const toml::node& node) {
        const toml::array* values = node.as_array();
        const bool three = values != nullptr && values->size() == 3;
        const auto x = three ? number(*values->get(0)) : std::nullopt;
        const auto y = three ? number(*values->get(1)) : std::nullopt;
        const auto heading = three ? number(*values->get(2)) : std::nullopt;
        if (!x || !y || !heading || !within(*x) || !within(*y) || !within(*heading)) {
            fail(node.source(),
                 message(HITOS_TEXT("Errors",
                                    "tour.start: expected [x, y, heading] in metres and degrees")));
        }
        world_.tour.start = {*x, *y, wrap_angle(*heading * kRadiansPerDegree)};
    }

    void read_way_points(const toml::source_region& where, const toml::node& node) {
        const toml::array* points = node.as_array();
        if (points == nullptr || points->empty()) {
            fail(where, message(HITOS_TEXT("Errors",
                                           "tour.way_points: found none, expected [[x, y], ...]")));
        }
        world_.tour.line = where.begin.line;
        for (const toml::node& entry : *points) {
            const Message name =
                message(HITOS_TEXT("Errors", "way point %1"), world_.tour.way_points.size() + 1);
            world_.tour.way_points.push_back(
                {world_lists::read_point(path_, entry, name), entry.source().begin.line});
        }
    }

    static bool is_choice(const WorldKey& key) { return key.type == WorldKey::Type::choice; }

    static bool within(double value) { return std::abs(value) <= kFarthest; }

    static std::optional<double> number(const toml::node& node) { return node.value<double>(); }

    std::string words(const toml::key& key, const toml::node& node) const {
        const auto* value = node.as_string();
        if (value == nullptr) {
            fail(key.source(),
                 message(HITOS_TEXT("Errors", "%1: expected a string in quotes"), key.str()));
        }
        return value->get();
    }

    std::filesystem::path path_;
    World world_;
    int walls_ = 0;
    std::string drawing_;
    toml::source_region drawing_at_;
    toml::source_region radii_at_;
    DxfOptions dxf_;
};

}  // namespace

World parse_unfinished_world(std::string_view text, const std::filesystem::path& path) {
    try {
        return Reading(path).read(toml::parse(input::checked_toml(text, path.string())));
    } catch (const toml::parse_error& error) {
        throw FormatError(path.string(), error.source().begin.line,
                          verbatim(std::string(error.description())));
    }
}

World parse_world(std::string_view text, const std::filesystem::path& path) {
    World world = parse_unfinished_world(text, path);
    if (world.walls.empty()) {
        throw FormatError(
            path.string(), 0,
            HITOS_TEXT("Errors", "found no walls; expected the key walls or walls_dxf"));
    }
    return world;
}

std::string read_world_text(const std::filesystem::path& path) {
    std::error_code problem;
    if (std::filesystem::is_directory(path, problem)) {
        throw FileError(path.string(),
                        HITOS_TEXT("Errors", "is a directory; expected a world file"));
    }
    return input::read_text(path, input::kLargestSettings);
}

World read_world(const std::filesystem::path& path) {
    return parse_world(read_world_text(path), path);
}

}  // namespace hitos
