// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/simulation/text/world_editing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "hitos/simulation/text/snapping.hpp"
#include "wall_gaps.hpp"

namespace hitos {
namespace {

Point2 moved(const Point2& point, const Point2& by) {
    return to_the_micrometre({point.x + by.x, point.y + by.y});
}

bool is_box(const Disturbance& event) {
    return event.kind == DisturbanceKind::box;
}

/// Where the box of that number stands among the events; their count where there is none.
std::size_t place_of_box(const std::vector<Disturbance>& events, std::size_t number) {
    for (std::size_t i = 0; i < events.size(); ++i) {
        if (is_box(events[i]) && number-- == 0) return i;
    }
    return events.size();
}

std::vector<Polyline> lines_of(const WorldText& text, ItemKind kind) {
    const World& world = text.world();
    std::vector<Polyline> lines;
    switch (kind) {
        case ItemKind::wall:
            return text.walls();
        case ItemKind::door:
            for (const WallSegment& door : world.doors) lines.push_back({door.a, door.b});
            break;
        case ItemKind::box:
            for (const Disturbance& event : world.tour.events) {
                if (is_box(event)) lines.push_back(box_outline(event));
            }
            break;
        case ItemKind::person:
            for (const Walker& walker : world.walkers) lines.push_back(walker.way);
            break;
        case ItemKind::way_point:
            for (const WayPoint& point : world.tour.way_points) lines.push_back({point.at});
            break;
        case ItemKind::start:
            lines.push_back({{world.tour.start.x, world.tour.start.y}});
            break;
    }
    return lines;
}

std::vector<Point2> way_points_of(const World& world) {
    std::vector<Point2> points;
    for (const WayPoint& point : world.tour.way_points) points.push_back(point.at);
    return points;
}

Walls doors_of(const World& world) {
    Walls doors;
    for (const WallSegment& door : world.doors) doors.emplace_back(door.a, door.b);
    return doors;
}

bool has_pieces(ItemKind kind) {
    return kind == ItemKind::wall || kind == ItemKind::door || kind == ItemKind::person;
}

bool is_piece(const WorldItem& item) {
    return has_pieces(item.kind) && item.last == item.first + 1;
}

bool is_there(const std::vector<Polyline>& lines, const WorldItem& item) {
    if (item.index >= lines.size() || item.first > item.last) return false;
    return item.last < lines[item.index].size() || !has_pieces(item.kind);
}

/// What is done to a copy becomes the text's where nothing threw.
template <class Edit>
void together(WorldText& text, Edit edit) {
    WorldText next = text;
    edit(next);
    text = std::move(next);
}

void set_walls(WorldText& text, std::vector<Polyline> walls) {
    std::erase_if(walls, [](const Polyline& wall) { return wall.size() < 2; });
    text.set_walls(walls);
}

/// With its gap in the walls from one place to another.
void put_door(WorldText& text, std::size_t index, const Point2& a, const Point2& b) {
    Walls doors = doors_of(text.world());
    set_walls(text, without_stretch(text.walls(), a, b));
    if (index == doors.size()) {
        doors.emplace_back(a, b);
    } else {
        doors[index] = {a, b};
    }
    text.set_doors(doors);
}

/// The first point of a closed way is its last one too.
void move_points(Polyline& line, std::size_t first, std::size_t last, const Point2& by) {
    const bool closed = line.size() > 2 && line.front() == line.back();
    const std::size_t end = line.size() - 1;
    std::vector<bool> moves(line.size(), false);
    for (std::size_t i = first; i <= last; ++i) moves[i] = true;
    if (closed && (moves.front() || moves[end])) moves.front() = moves[end] = true;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (moves[i]) line[i] = moved(line[i], by);
    }
}

void put_line(WorldText& text, const WorldItem& item, const Polyline& line) {
    switch (item.kind) {
        case ItemKind::wall: {
            std::vector<Polyline> walls = text.walls();
            walls[item.index] = line;
            set_walls(text, std::move(walls));
            break;
        }
        case ItemKind::door: {
            // In its wall again, wherever that is.
            const WallSegment& door = text.world().doors[item.index];
            set_walls(text, with_stretch(text.walls(), door.a, door.b));
            put_door(text, item.index, line[0], line[1]);
            break;
        }
        case ItemKind::person: {
            std::vector<Walker> people = text.world().walkers;
            people[item.index].way = line;
            text.set_people(people);
            break;
        }
        default:
            break;
    }
}

void remove_door(WorldText& text, std::size_t index) {
    const WallSegment door = text.world().doors[index];
    std::vector<Disturbance> events = text.world().tour.events;
    const auto number = static_cast<double>(index + 1);
    const auto of_doors = [](const Disturbance& event) {
        return event.kind == DisturbanceKind::open || event.kind == DisturbanceKind::close;
    };
    std::erase_if(events, [&](const Disturbance& event) {
        return of_doors(event) && event.values[0] == number;
    });
    text.set_events(events);
    // Door by door: of several changes at once nobody could tell which event became which, and
    // comments would go to others.
    for (std::size_t later = index + 1; later < text.world().doors.size(); ++later) {
        for (Disturbance& event : events) {
            if (of_doors(event) && event.values[0] == static_cast<double>(later + 1))
                event.values[0] -= 1.0;
        }
        text.set_events(events);
    }
    Walls doors = doors_of(text.world());
    doors.erase(doors.begin() + static_cast<std::ptrdiff_t>(index));
    text.set_doors(doors);
    set_walls(text, with_stretch(text.walls(), door.a, door.b));
}

/// Without these points, or the pieces between them.
std::vector<Polyline> without_points(const Polyline& line, std::size_t first, std::size_t last) {
    const auto at = [&](std::size_t i) { return line.begin() + static_cast<std::ptrdiff_t>(i); };
    const bool closed = line.size() > 3 && line.front() == line.back();
    if (first == 0 && last + 1 == line.size()) return {};
    if (first == last) {
        Polyline rest = line;
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(first));
        if (closed && (first == 0 || first + 1 == line.size())) {
            if (first == 0)
                rest.pop_back();
            else
                rest.erase(rest.begin());
            rest.push_back(rest.front());
        }
        // What is left of a triangle is a piece, there and not back again.
        if (closed && rest.size() == 3) rest.pop_back();
        return {rest};
    }
    if (closed) {  // opened there
        Polyline rest(at(last), line.end());
        rest.insert(rest.end(), at(1), at(first + 1));
        return {rest};
    }
    return {Polyline(line.begin(), at(first + 1)), Polyline(at(last), line.end())};
}

void remove_wall(WorldText& text, const WorldItem& item) {
    std::vector<Polyline> walls = text.walls();
    const std::vector<Polyline> rest = without_points(walls[item.index], item.first, item.last);
    const auto at = walls.erase(walls.begin() + static_cast<std::ptrdiff_t>(item.index));
    walls.insert(at, rest.begin(), rest.end());
    set_walls(text, std::move(walls));
}

void remove_person(WorldText& text, const WorldItem& item) {
    std::vector<Walker> people = text.world().walkers;
    Polyline& way = people[item.index].way;
    const bool one = item.first == item.last;
    if (one && way.size() > 2) {
        way = without_points(way, item.first, item.last).front();
    } else {
        people.erase(people.begin() + static_cast<std::ptrdiff_t>(item.index));
    }
    text.set_people(people);
}

}  // namespace

std::optional<WorldItem> item_at(const WorldText& text, const Point2& point, double within_m) {
    std::optional<WorldItem> found;
    double nearest = within_m;
    const auto offer = [&](double away, const WorldItem& item) {
        if (away > nearest) return;
        nearest = away;
        found = item;
    };
    constexpr std::array kKinds = {ItemKind::wall,   ItemKind::door,      ItemKind::box,
                                   ItemKind::person, ItemKind::way_point, ItemKind::start};
    std::vector<std::vector<Polyline>> lines;
    lines.reserve(kKinds.size());
    for (const ItemKind kind : kKinds) lines.push_back(lines_of(text, kind));
    for (std::size_t k = 0; k < lines.size(); ++k) {
        const bool box = kKinds[k] == ItemKind::box;
        for (std::size_t i = 0; i < lines[k].size() && !box; ++i) {
            for (std::size_t j = 0; j < lines[k][i].size(); ++j) {
                offer(distance(lines[k][i][j], point), {kKinds[k], i, j, j});
            }
        }
    }
    if (found) return found;
    for (std::size_t k = 0; k < lines.size(); ++k) {
        for (std::size_t i = 0; i < lines[k].size(); ++i) {
            for (std::size_t j = 1; j < lines[k][i].size(); ++j) {
                const WallSegment piece{lines[k][i][j - 1], lines[k][i][j], 0, 0};
                const bool box = kKinds[k] == ItemKind::box;
                offer(distance(piece, point),
                      box ? WorldItem{kKinds[k], i, 0, 0} : WorldItem{kKinds[k], i, j - 1, j});
            }
            const bool inside = kKinds[k] == ItemKind::box && point.x >= lines[k][i][0].x &&
                                point.x <= lines[k][i][2].x && point.y >= lines[k][i][0].y &&
                                point.y <= lines[k][i][2].y;
            if (inside) offer(0.0, {kKinds[k], i, 0, 0});
        }
    }
    return found;
}

WorldItem whole_of(const WorldText& text, const WorldItem& item) {
    const std::vector<Polyline> lines = lines_of(text, item.kind);
    if (!has_pieces(item.kind) || item.index >= lines.size()) return item;
    return {item.kind, item.index, 0, lines[item.index].size() - 1};
}

Polyline outline_of(const WorldText& text, const WorldItem& item) {
    const std::vector<Polyline> lines = lines_of(text, item.kind);
    if (!is_there(lines, item)) return {};
    const Polyline& line = lines[item.index];
    if (item.kind == ItemKind::box) return line;
    return {line.begin() + static_cast<std::ptrdiff_t>(item.first),
            line.begin() + static_cast<std::ptrdiff_t>(item.last) + 1};
}

void add_wall(WorldText& text, const Polyline& wall) {
    std::vector<Polyline> walls = text.walls();
    walls.push_back(wall);
    text.set_walls(walls);
}

void add_door(WorldText& text, const Point2& a, const Point2& b) {
    together(text, [&](WorldText& next) {
        const std::size_t index = next.world().doors.size();
        put_door(next, index, a, b);
        std::vector<Disturbance> events = next.world().tour.events;
        Disturbance opened;
        opened.kind = DisturbanceKind::open;
        opened.values[0] = static_cast<double>(index + 1);
        events.push_back(opened);
        next.set_events(events);
    });
}

void add_box(WorldText& text, const Point2& middle, double side_m) {
    std::vector<Disturbance> events = text.world().tour.events;
    Disturbance box;
    box.kind = DisturbanceKind::box;
    box.values = {middle.x, middle.y, side_m};
    events.push_back(box);
    text.set_events(events);
}

void add_person(WorldText& text, const Polyline& way) {
    std::vector<Walker> people = text.world().walkers;
    Walker walker;
    walker.way = way;
    people.push_back(walker);
    text.set_people(people);
}

void add_way_point(WorldText& text, const Point2& point) {
    std::vector<Point2> points = way_points_of(text.world());
    points.push_back(point);
    text.set_way_points(points);
}

void move_item(WorldText& text, const WorldItem& item, const Point2& by_m) {
    const std::vector<Polyline> lines = lines_of(text, item.kind);
    if (!is_there(lines, item)) return;
    const World& world = text.world();
    switch (item.kind) {
        case ItemKind::box: {
            std::vector<Disturbance> events = world.tour.events;
            auto& values = events[place_of_box(events, item.index)].values;
            const Point2 to = moved({values[0], values[1]}, by_m);
            values[0] = to.x;
            values[1] = to.y;
            text.set_events(events);
            break;
        }
        case ItemKind::way_point: {
            std::vector<Point2> points = way_points_of(world);
            points[item.index] = moved(points[item.index], by_m);
            text.set_way_points(points);
            break;
        }
        case ItemKind::start: {
            const Point2 to = moved(lines[0][0], by_m);
            text.set_start({to.x, to.y, world.tour.start.theta});
            break;
        }
        default: {
            Polyline line = lines[item.index];
            move_points(line, item.first, item.last, by_m);
            together(text, [&](WorldText& next) { put_line(next, item, line); });
        }
    }
}

void remove_item(WorldText& text, const WorldItem& item) {
    if (!is_there(lines_of(text, item.kind), item)) return;
    switch (item.kind) {
        case ItemKind::wall:
            remove_wall(text, item);
            break;
        case ItemKind::door:
            together(text, [&](WorldText& next) { remove_door(next, item.index); });
            break;
        case ItemKind::box: {
            std::vector<Disturbance> events = text.world().tour.events;
            events.erase(events.begin() +
                         static_cast<std::ptrdiff_t>(place_of_box(events, item.index)));
            text.set_events(events);
            break;
        }
        case ItemKind::person:
            remove_person(text, item);
            break;
        case ItemKind::way_point: {
            std::vector<Point2> points = way_points_of(text.world());
            points.erase(points.begin() + static_cast<std::ptrdiff_t>(item.index));
            text.set_way_points(points);
            break;
        }
        case ItemKind::start:
            break;
    }
}

std::vector<ItemNumber> numbers_of(const WorldText& text, const WorldItem& item) {
    const std::vector<Polyline> lines = lines_of(text, item.kind);
    if (!is_there(lines, item)) return {};
    const World& world = text.world();
    const Polyline& line = lines[item.index];
    constexpr std::string_view kX = HITOS_TEXT("WorldItem", "x");
    constexpr std::string_view kY = HITOS_TEXT("WorldItem", "y");
    if (item.kind == ItemKind::box) {
        const auto& values = world.tour.events[place_of_box(world.tour.events, item.index)].values;
        return {{kX, "m", values[0]},
                {kY, "m", values[1]},
                {HITOS_TEXT("WorldItem", "side"), "m", values[2]}};
    }
    std::vector<ItemNumber> numbers;
    if (item.first == item.last) {
        numbers = {{kX, "m", line[item.first].x}, {kY, "m", line[item.first].y}};
    } else if (is_piece(item) && item.kind != ItemKind::person) {
        const Point2& a = line[item.first];
        const Point2& b = line[item.last];
        numbers = {{HITOS_TEXT("WorldItem", "length"), "m", distance(a, b)},
                   {HITOS_TEXT("WorldItem", "direction"), "°",
                    std::atan2(b.y - a.y, b.x - a.x) / kRadiansPerDegree}};
    }
    if (item.kind == ItemKind::start) {
        numbers.push_back(
            {HITOS_TEXT("WorldItem", "heading"), "°", world.tour.start.theta / kRadiansPerDegree});
    }
    if (item.kind == ItemKind::person && item.first != item.last) {
        numbers = {{HITOS_TEXT("WorldItem", "speed"), "m/s", world.walkers[item.index].speed},
                   {HITOS_TEXT("WorldItem", "radius"), "m", world.walkers[item.index].radius_m}};
    }
    return numbers;
}

void set_number(WorldText& text, const WorldItem& item, std::size_t place, double value) {
    const std::vector<ItemNumber> numbers = numbers_of(text, item);
    if (place >= numbers.size() || numbers[place].value == value) return;
    std::vector<double> wanted;
    wanted.reserve(numbers.size());
    for (const ItemNumber& number : numbers) wanted.push_back(number.value);
    wanted[place] = value;
    const World& world = text.world();
    if (item.kind == ItemKind::box) {
        std::vector<Disturbance> events = world.tour.events;
        std::ranges::copy(wanted, events[place_of_box(events, item.index)].values.begin());
        text.set_events(events);
    } else if (item.kind == ItemKind::start) {
        // Where the heading stays, so do its bits.
        const double theta =
            place == 2 ? wrap_angle(value * kRadiansPerDegree) : world.tour.start.theta;
        text.set_start({wanted[0], wanted[1], theta});
    } else if (item.kind == ItemKind::person && item.first != item.last) {
        std::vector<Walker> people = world.walkers;
        people[item.index].speed = wanted[0];
        people[item.index].radius_m = wanted[1];
        text.set_people(people);
    } else if (item.first == item.last) {
        const Point2 now{numbers[0].value, numbers[1].value};
        move_item(text, item, {wanted[0] - now.x, wanted[1] - now.y});
    } else {
        const Polyline piece = outline_of(text, item);
        const double heading = wanted[1] * kRadiansPerDegree;
        const Point2 end{piece[0].x + wanted[0] * std::cos(heading),
                         piece[0].y + wanted[0] * std::sin(heading)};
        move_item(text, {item.kind, item.index, item.last, item.last},
                  {end.x - piece[1].x, end.y - piece[1].y});
    }
}

}  // namespace hitos
