// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/simulation/text/world_text.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "toml_text.hpp"
#include "worlds/world_reading.hpp"
#include "worlds/world_values.hpp"

namespace hitos {
namespace {

bool same(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
bool same(const Point2& a, const Point2& b) {
    return same(a.x, b.x) && same(a.y, b.y);
}
bool same(const Pose& a, const Pose& b) {
    return same(a.x, b.x) && same(a.y, b.y) && same(a.theta, b.theta);
}
bool same(const WallSegment& a, const WallSegment& b) {
    return same(a.a, b.a) && same(a.b, b.b) && a.wall == b.wall;
}
bool same(const WayPoint& a, const WayPoint& b) {
    return same(a.at, b.at);
}
bool same(const DriveCommand& a, const DriveCommand& b) {
    return same(a.v, b.v) && same(a.w, b.w) && same(a.duration_s, b.duration_s);
}
bool same(const Disturbance& a, const Disturbance& b) {
    return a.kind == b.kind && same(a.at_s, b.at_s) && same(a.values[0], b.values[0]) &&
           same(a.values[1], b.values[1]) && same(a.values[2], b.values[2]);
}
bool same(const Walker& a, const Walker& b);
template <class Entry>
bool same(const std::vector<Entry>& a, const std::vector<Entry>& b) {
    return std::ranges::equal(a, b, [](const Entry& x, const Entry& y) { return same(x, y); });
}
bool same(const Walker& a, const Walker& b) {
    return same(a.way, b.way) && same(a.speed, b.speed) && same(a.radius_m, b.radius_m);
}

bool same(const WorldKey::Value& a, const WorldKey::Value& b) {
    const auto* x = std::get_if<double>(&a);
    const auto* y = std::get_if<double>(&b);
    return x != nullptr && y != nullptr ? same(*x, *y) : a == b;
}

TomlValue value_of(const Point2& point) {
    return TomlValue::of({TomlValue::of(point.x), TomlValue::of(point.y)});
}

TomlValue points_of(std::span<const Point2> points) {
    std::vector<TomlValue> list;
    list.reserve(points.size());
    for (const Point2& point : points) list.push_back(value_of(point));
    return TomlValue::of(std::move(list));
}

TomlValue value_of(const DriveCommand& command) {
    return TomlValue::of(
        {TomlValue::of(command.v), TomlValue::of(command.w), TomlValue::of(command.duration_s)});
}

TomlValue value_of(const Disturbance& event) {
    const DisturbanceFacts& facts = event.facts();
    TomlValue values = TomlValue::of(event.values[0]);
    if (facts.count > 1) {
        std::vector<TomlValue> list;
        for (std::size_t i = 0; i < facts.count; ++i)
            list.push_back(TomlValue::of(event.values[i]));
        values = TomlValue::of(std::move(list));
    }
    std::vector<TomlValue::Member> members = {{"at", TomlValue::of(event.at_s)},
                                              {std::string(facts.word), std::move(values)}};
    return TomlValue::of(std::move(members));
}

TomlValue value_of(const Walker& walker) {
    const Walker usual;
    std::vector<TomlValue::Member> members = {
        {"way", points_of(walker.way)},
        {"speed", TomlValue::of(walker.speed), same(walker.speed, usual.speed)},
        {"radius", TomlValue::of(walker.radius_m), same(walker.radius_m, usual.radius_m)}};
    return TomlValue::of(std::move(members));
}

/// Degrees that read back to the angle, in the fewest digits; the nearest ones where none do.
double degrees_of(double angle_rad) {
    const auto reads_back = [&](double degrees) {
        return same(wrap_angle(degrees * kRadiansPerDegree), angle_rad);
    };
    const double nearest = angle_rad / kRadiansPerDegree;
    double scale = 1.0;
    for (int decimals = 0; decimals < 10; ++decimals, scale *= 10.0) {
        if (const double round = std::round(nearest * scale) / scale; reads_back(round))
            return round;
    }
    double below = nearest;
    double above = nearest;
    for (int step = 0; step < 4; ++step) {
        if (reads_back(below)) return below;
        if (reads_back(above)) return above;
        below = std::nextafter(below, -1e9);
        above = std::nextafter(above, 1e9);
    }
    return nearest;
}

std::vector<Polyline> polylines_of(std::span<const WallSegment> walls) {
    std::vector<Polyline> lines;
    int wall = 0;
    for (const WallSegment& segment : walls) {
        if (lines.empty() || segment.wall != wall || !same(lines.back().back(), segment.a))
            lines.push_back({segment.a});
        lines.back().push_back(segment.b);
        wall = segment.wall;
    }
    return lines;
}

std::size_t drawn(const World& world) {
    if (world.drawing.empty()) return 0;
    return static_cast<std::size_t>(
        std::ranges::count(world.walls, std::uint64_t{0}, &WallSegment::line));
}

}  // namespace

bool same_world(const World& a, const World& b) {
    for (const WorldKey& key : world_keys()) {
        if (!same(key.get(a), key.get(b))) return false;
    }
    return same(a.walls, b.walls) && same(a.doors, b.doors) && same(a.walkers, b.walkers) &&
           same(a.landmarks.at, b.landmarks.at) && same(a.landmarks.radii_m, b.landmarks.radii_m) &&
           same(a.tour.start, b.tour.start) && same(a.tour.way_points, b.tour.way_points) &&
           same(a.tour.commands, b.tour.commands) && same(a.tour.events, b.tour.events);
}

/// Edits that take effect together, where the text then says what is expected of it.
class WorldText::Change {
  public:
    explicit Change(WorldText& owner)
        : owner_(owner), text_(owner.text_), expected_(owner.world_) {}

    void walls(std::span<const Polyline> walls) {
        const std::size_t own = expected_.walls.size() - drawn(expected_);
        std::vector<WallSegment> segments;
        int number = 0;
        for (const Polyline& wall : walls) {
            ++number;
            for (std::size_t i = 1; i < wall.size(); ++i)
                segments.push_back({wall[i - 1], wall[i], number, 1});
        }
        const int shift = number - (own == 0 ? 0 : expected_.walls[own - 1].wall);
        for (std::size_t i = own; i < expected_.walls.size(); ++i) {
            segments.push_back(expected_.walls[i]);
            segments.back().wall += shift;
        }
        expected_.walls = std::move(segments);
        std::vector<TomlValue> list;
        list.reserve(walls.size());
        for (const Polyline& wall : walls) list.push_back(points_of(wall));
        put("", "walls", std::move(list), true);
    }

    void doors(std::span<const std::pair<Point2, Point2>> doors) {
        expected_.doors.clear();
        std::vector<TomlValue> list;
        for (const auto& [a, b] : doors) {
            expected_.doors.push_back({a, b, static_cast<int>(list.size()) + 1, 1});
            list.push_back(TomlValue::of({value_of(a), value_of(b)}));
        }
        put("", "doors", std::move(list), true);
    }

    void people(std::span<const Walker> people) {
        expected_.walkers.assign(people.begin(), people.end());
        put("", "people", values_of(people), true);
    }

    void landmarks(const MarkParams& marks) {
        expected_.landmarks.at = marks.at;
        expected_.landmarks.radii_m = marks.radii_m;
        put("landmarks", "at", points_of(marks.at).list, false);
        std::vector<TomlValue> radii;
        radii.reserve(marks.radii_m.size());
        for (const double radius : marks.radii_m) radii.push_back(TomlValue::of(radius));
        put("landmarks", "radii", std::move(radii), false);
    }

    void start(const Pose& start) {
        const Pose& before = expected_.tour.start;
        if (same(before, start)) return;
        double degrees = degrees_of(start.theta);
        // Where the heading stays, so do its digits, whichever way they were written.
        if (const auto now = text_.number("tour", "start", 2);
            now && same(before.theta, start.theta))
            degrees = *now;
        expected_.tour.start = start;
        expected_.tour.start.theta = wrap_angle(degrees * (kPi / 180.0));
        put("tour", "start",
            {TomlValue::of(start.x), TomlValue::of(start.y), TomlValue::of(degrees)}, false);
    }

    void way_points(std::span<const Point2> points) {
        expected_.tour.way_points.clear();
        for (const Point2& point : points) expected_.tour.way_points.push_back({point});
        if (!points.empty()) commands({});
        put("tour", "way_points", points_of(points).list, false);
    }

    void commands(std::span<const DriveCommand> commands) {
        expected_.tour.commands.assign(commands.begin(), commands.end());
        if (!commands.empty()) way_points({});
        put("tour", "commands", values_of(commands), false);
    }

    void events(std::span<const Disturbance> events) {
        expected_.tour.events.assign(events.begin(), events.end());
        put("tour", "events", values_of(events), true);
    }

    void value(std::string_view name, const World& from) {
        const WorldKey& key = world_values::find(name);
        const WorldKey::Value wanted = key.get(from);
        if (same(key.get(expected_), wanted)) return;
        key.put(expected_, wanted);
        const std::size_t dot = name.find('.');
        const bool top = dot == std::string_view::npos;
        const std::string text = key.text(from);
        TomlValue value = text == "true" || text == "false" ? TomlValue::flag(text == "true")
                                                            : TomlValue::word(text);
        if (const auto* real = std::get_if<double>(&wanted)) value = TomlValue::of(*real);
        if (const auto* whole = std::get_if<std::int64_t>(&wanted)) {
            value = TomlValue::of(static_cast<double>(*whole));
            value.text = std::to_string(*whole);
        }
        text_.set(top ? "" : name.substr(0, dot), top ? name : name.substr(dot + 1), value);
    }

    /// Throws, and leaves the text as it was, where it would not read as expected.
    void finish() {
        World now = parse_unfinished_world(text_.text(), owner_.path_);
        if (now.walls.size() != expected_.walls.size() && drawn(now) != drawn(expected_)) {
            throw FormatError(owner_.path_.string(), 0,
                              HITOS_TEXT("Errors",
                                         "the drawing %1 has changed meanwhile; save the world "
                                         "under another name, or open it again"),
                              now.drawing.string());
        }
        if (!same_world(now, expected_)) {
            throw FormatError(
                owner_.path_.string(), 0,
                HITOS_TEXT("Errors",
                           "this change cannot be written as TOML that reads back the same; "
                           "expected finite numbers, and polylines of two points or more"));
        }
        owner_.text_ = text_.text();
        owner_.world_ = std::move(now);
    }

    const World& expected() const { return expected_; }

  private:
    template <class Entry>
    static std::vector<TomlValue> values_of(std::span<const Entry> entries) {
        std::vector<TomlValue> list;
        list.reserve(entries.size());
        for (const Entry& entry : entries) list.push_back(value_of(entry));
        return list;
    }

    void put(std::string_view table, std::string_view key, std::vector<TomlValue> list,
             bool a_line_each) {
        if (list.empty()) {
            text_.remove(table, key);
        } else {
            text_.set(table, key, TomlValue::of(std::move(list), a_line_each));
        }
    }

    WorldText& owner_;
    TomlText text_;
    World expected_;
};

WorldText::WorldText(std::string text, std::filesystem::path path)
    : path_(std::move(path)),
      text_(std::move(text)),
      world_(parse_unfinished_world(text_, path_)) {}

WorldText WorldText::read_unfinished(const std::filesystem::path& path) {
    return {read_world_text(path), path};
}

WorldText WorldText::moved_to(const std::filesystem::path& path) const {
    if (world_.drawing.empty()) return {text_, path};
    TomlText text(text_);
    for (const bool whole_path : {false, true}) {
        if (whole_path) {
            const std::string drawing = std::filesystem::absolute(world_.drawing).string();
            text.set("", "walls_dxf", TomlValue::word(drawing));
        }
        try {
            WorldText there(text.text(), path);
            if (same_world(there.world_, world_)) return there;
        } catch (const Error&) {  // not found from there
        }
    }
    for (const char* key : {"walls_dxf", "dxf_layer", "dxf_unit"}) text.remove("", key);
    std::vector<TomlValue> list;
    for (const Polyline& wall : polylines_of(world_.walls)) list.push_back(points_of(wall));
    text.set("", "walls", TomlValue::of(std::move(list), true));
    return {text.text(), path};
}

WorldText WorldText::read(const std::filesystem::path& path) {
    WorldText text = read_unfinished(path);
    parse_world(text.text_, path);  // the file must have walls
    return text;
}

std::vector<Polyline> WorldText::walls() const {
    return polylines_of(std::span(world_.walls).first(world_.walls.size() - drawn(world_)));
}

void WorldText::set_walls(std::span<const Polyline> walls) {
    Change change(*this);
    change.walls(walls);
    change.finish();
}

void WorldText::set_doors(std::span<const std::pair<Point2, Point2>> doors) {
    Change change(*this);
    change.doors(doors);
    change.finish();
}

void WorldText::set_people(std::span<const Walker> people) {
    Change change(*this);
    change.people(people);
    change.finish();
}

void WorldText::set_start(const Pose& start) {
    Change change(*this);
    change.start(start);
    change.finish();
}

void WorldText::set_way_points(std::span<const Point2> way_points) {
    Change change(*this);
    change.way_points(way_points);
    change.finish();
}

void WorldText::set_commands(std::span<const DriveCommand> commands) {
    Change change(*this);
    change.commands(commands);
    change.finish();
}

void WorldText::set_events(std::span<const Disturbance> events) {
    Change change(*this);
    change.events(events);
    change.finish();
}

void WorldText::set_value(std::string_view key, std::string_view value) {
    World wanted = world_;
    set_world_value(wanted, std::string(key) + "=" + std::string(value));
    Change change(*this);
    change.value(key, wanted);
    change.finish();
}

void WorldText::set(const World& world) {
    Change change(*this);
    const std::size_t from_drawing = drawn(world_);
    const std::size_t own = world.walls.size() - std::min(from_drawing, world.walls.size());
    const auto drawing = std::span(world_.walls).last(from_drawing);
    if (!std::ranges::equal(drawing, std::span(world.walls).subspan(own),
                            [](const WallSegment& a, const WallSegment& b) {
                                return same(a.a, b.a) && same(a.b, b.b);
                            })) {
        throw ConfigError("walls_dxf",
                          HITOS_TEXT("Errors",
                                     "the walls of %1 are changed in the drawing, or written into "
                                     "the world file in its place"),
                          world_.drawing.string());
    }
    change.walls(polylines_of(std::span(world.walls).first(own)));
    Walls doors;
    for (const WallSegment& door : world.doors) doors.emplace_back(door.a, door.b);
    change.doors(doors);
    change.people(world.walkers);
    change.landmarks(world.landmarks);
    change.start(world.tour.start);
    std::vector<Point2> way_points;
    for (const WayPoint& point : world.tour.way_points) way_points.push_back(point.at);
    if (world.tour.commands.empty()) {
        change.commands({});
        change.way_points(way_points);
    } else {
        change.way_points(way_points);
        change.commands(world.tour.commands);
    }
    change.events(world.tour.events);
    for (const WorldKey& key : world_keys()) change.value(key.key, world);
    change.finish();
}

void WorldText::save(const std::filesystem::path& path) {
    World there = parse_unfinished_world(text_, path);  // its drawing must be found from there
    write_file(path, text_);
    path_ = path;
    world_ = std::move(there);
}

}  // namespace hitos
