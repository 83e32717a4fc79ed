// SPDX-License-Identifier: GPL-3.0-or-later
#include "world_lists.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>

#include "hitos/base/error.hpp"

namespace hitos {

Message problem_of(const DriveCommand& command, const RobotParams& robot) {
    if (!(std::abs(command.v) <= robot.max_speed)) {
        return message(HITOS_TEXT("Errors", "found the speed %1 m/s, expected %2 to %3"),
                       fmt::format("{}", command.v), fmt::format("{:g}", -robot.max_speed),
                       fmt::format("{:g}", robot.max_speed));
    }
    if (!(std::abs(command.w) <= robot.max_turn_rate)) {
        return message(HITOS_TEXT("Errors", "found the turn rate %1 rad/s, expected %2 to %3"),
                       fmt::format("{}", command.w), fmt::format("{:g}", -robot.max_turn_rate),
                       fmt::format("{:g}", robot.max_turn_rate));
    }
    if (!(command.duration_s >= 0.0) || !std::isfinite(command.duration_s)) {
        return message(HITOS_TEXT("Errors", "found the time %1 s, expected 0 or more"),
                       fmt::format("{}", command.duration_s));
    }
    return {};
}

Message problem_of(const Walker& walker) {
    double length = 0.0;
    for (std::size_t i = 1; i < walker.way.size(); ++i) {
        const double part = std::hypot(walker.way[i].x - walker.way[i - 1].x,
                                       walker.way[i].y - walker.way[i - 1].y);
        if (part == 0.0) {
            return message(HITOS_TEXT("Errors", "found a point twice in a row on the way"));
        }
        length += part;
    }
    if (!(length > 0.0) || !std::isfinite(length)) {
        return message(HITOS_TEXT("Errors", "found a way of no length, expected two points"));
    }
    if (!(walker.speed >= 0.0 && walker.speed <= 10.0)) {
        return message(HITOS_TEXT("Errors", "found the speed %1 m/s, expected %2 to %3"),
                       fmt::format("{}", walker.speed), "0", "10");
    }
    if (!(walker.radius_m > 0.0 && walker.radius_m <= 10.0)) {
        return message(
            HITOS_TEXT("Errors", "found the radius %1 m, expected more than 0, at most %2"),
            fmt::format("{}", walker.radius_m), "10");
    }
    return {};
}

Message problem_of(const MarkParams& marks) {
    if (!marks.round()) return {};
    if (marks.radii_m.size() != marks.at.size()) {
        return message(
            HITOS_TEXT("Errors", "found %1 radii of %2 landmarks, expected one for each, or none"),
            marks.radii_m.size(), marks.at.size());
    }
    for (const double radius : marks.radii_m) {
        if (radius > 0.0 && radius <= 10.0) continue;
        return message(
            HITOS_TEXT("Errors", "found the radius %1 m, expected more than 0, at most %2"),
            fmt::format("{}", radius), "10");
    }
    return {};
}

namespace world_lists {
namespace {

using Path = std::filesystem::path;

[[noreturn]] void fail(const Path& path, const toml::node& node, const Message& problem) {
    throw FormatError(path.string(), node.source().begin.line, problem);
}

/// The numbers of a list of so many; a single number may stand for a list of one.
std::optional<std::vector<double>> numbers(const toml::node& node, std::size_t count) {
    std::vector<double> values;
    if (const auto one = node.value<double>(); one && count == 1) return std::vector{*one};
    const toml::array* list = node.as_array();
    if (list == nullptr || list->size() != count) return std::nullopt;
    for (const toml::node& entry : *list) {
        const auto value = entry.value<double>();
        if (!value || !(std::abs(*value) <= kFarthest)) return std::nullopt;
        values.push_back(*value);
    }
    return values;
}

const toml::array& list_of(const Path& path, const toml::node& node, const char* name,
                           const char* expected) {
    if (const toml::array* list = node.as_array()) return *list;
    fail(path, node, message(HITOS_TEXT("Errors", "%1: expected %2"), name, expected));
}

std::vector<Point2> points(const Path& path, const toml::node& node, const Message& name) {
    std::vector<Point2> found;
    if (const toml::array* list = node.as_array()) {
        for (const toml::node& entry : *list) found.push_back(read_point(path, entry, name));
    }
    if (found.size() < 2) {
        fail(path, node,
             message(HITOS_TEXT("Errors", "%1: expected two points or more, [[x, y], [x, y]]"),
                     name));
    }
    return found;
}

const DisturbanceFacts* facts_of(std::string_view word) {
    for (const DisturbanceFacts& facts : kDisturbances) {
        if (facts.word == word) return &facts;
    }
    return nullptr;
}

Message words_of_all() {
    std::string words;
    for (const DisturbanceFacts& facts : kDisturbances) {
        words += words.empty() ? "" : ", ";
        words += facts.word;
    }
    return verbatim(words);
}

/// "[ahead, left, turn]", or "seconds".
std::string expected_values(const DisturbanceFacts& facts) {
    std::string names;
    for (const DisturbanceValue& value : facts.used()) {
        names += names.empty() ? "" : ", ";
        names += value.name;
    }
    return facts.count == 1 ? names : fmt::format("[{}]", names);
}

Disturbance event_of(const Path& path, const toml::node& node) {
    const toml::table* table = node.as_table();
    const toml::node* at = table != nullptr ? table->get("at") : nullptr;
    if (at == nullptr || !at->value<double>() || table->size() != 2) {
        fail(
            path, node,
            message(HITOS_TEXT("Errors",
                               "tour.events: expected { at = SECONDS, KIND = ... } with one of %1"),
                    words_of_all()));
    }
    Disturbance event;
    event.at_s = *at->value<double>();
    event.line = node.source().begin.line;
    for (const auto& [key, value] : *table) {
        if (key.str() == "at") continue;
        const DisturbanceFacts* facts = facts_of(key.str());
        if (facts == nullptr) {
            fail(path, node,
                 message(HITOS_TEXT("Errors", "tour.events: found %1, expected one of %2"),
                         key.str(), words_of_all()));
        }
        event.kind = static_cast<DisturbanceKind>(facts - kDisturbances.data());
        const auto values = numbers(value, facts->count);
        if (!values) {
            fail(path, value,
                 message(HITOS_TEXT("Errors", "%1: expected %2"), facts->word,
                         expected_values(*facts)));
        }
        std::ranges::copy(*values, event.values.begin());
    }
    return event;
}

}  // namespace

Point2 read_point(const Path& path, const toml::node& node, const Message& name) {
    if (const auto pair = numbers(node, 2)) return {pair->at(0), pair->at(1)};
    fail(path, node,
         message(HITOS_TEXT("Errors", "%1: expected a point [x, y] within %2 m of the origin"),
                 name, fmt::format("{:g}", kFarthest)));
}

void read_commands(World& world, const Path& path, const toml::node& node) {
    for (const toml::node& entry : list_of(path, node, "tour.commands", "[[v, w, s], ...]")) {
        const auto values = numbers(entry, 3);
        if (!values) {
            fail(path, entry,
                 message(HITOS_TEXT(
                     "Errors",
                     "tour.commands: expected [speed in m/s, turn rate in rad/s, seconds]")));
        }
        world.tour.commands.push_back(
            {values->at(0), values->at(1), values->at(2), entry.source().begin.line});
    }
}

void read_events(World& world, const Path& path, const toml::node& node) {
    for (const toml::node& entry : list_of(path, node, "tour.events", "[{ at = s, ... }, ...]")) {
        world.tour.events.push_back(event_of(path, entry));
    }
}

void read_people(World& world, const Path& path, const toml::node& node) {
    for (const toml::node& entry : list_of(path, node, "people", "[{ way = [...] }, ...]")) {
        const Message name = message(HITOS_TEXT("Errors", "walker %1"), world.walkers.size() + 1);
        const toml::table* table = entry.as_table();
        const toml::node* way = table != nullptr ? table->get("way") : nullptr;
        if (way == nullptr) {
            fail(path, entry,
                 message(HITOS_TEXT(
                             "Errors",
                             "%1: expected { way = [[x, y], [x, y]], speed = 0.8, radius = 0.25 }"),
                         name));
        }
        Walker walker;
        walker.line = entry.source().begin.line;
        walker.way = points(path, *way, name);
        for (const auto& [key, value] : *table) {
            if (key.str() == "way") continue;
            const bool speed = key.str() == "speed";
            const auto number = value.value<double>();
            if ((!speed && key.str() != "radius") || !number) {
                fail(path, value,
                     message(HITOS_TEXT("Errors",
                                        "%1: %2: expected the number speed or radius, or way"),
                             name, key.str()));
            }
            (speed ? walker.speed : walker.radius_m) = *number;
        }
        const Message problem = problem_of(walker);
        if (!problem.empty()) fail(path, entry, message("%1: %2", name, problem));
        world.walkers.push_back(std::move(walker));
    }
}

void read_landmarks(World& world, const Path& path, const toml::node& node) {
    std::vector<Point2>& marks = world.landmarks.at;
    for (const toml::node& entry : list_of(path, node, "landmarks.at", "[[x, y], ...]")) {
        const Message name = message(HITOS_TEXT("Errors", "landmark %1"), marks.size());
        marks.push_back(read_point(path, entry, name));
    }
}

void read_radii(World& world, const Path& path, const toml::node& node) {
    for (const toml::node& entry : list_of(path, node, "landmarks.radii", "[radius, ...]")) {
        const std::optional<double> radius = entry.value<double>();
        if (!radius || !entry.is_number()) {
            fail(path, entry,
                 message(HITOS_TEXT("Errors", "landmarks.radii: expected a radius in metres")));
        }
        world.landmarks.radii_m.push_back(*radius);
    }
    if (world.landmarks.radii_m.empty()) {
        fail(path, node,
             message(HITOS_TEXT("Errors",
                                "landmarks.radii: found none; leave the key out "
                                "where a sensor tells the landmarks")));
    }
}

void read_doors(World& world, const Path& path, const toml::node& node) {
    for (const toml::node& entry : list_of(path, node, "doors", "[[[x, y], [x, y]], ...]")) {
        const int number = static_cast<int>(world.doors.size()) + 1;
        const Message name = message(HITOS_TEXT("Errors", "door %1"), number);
        const std::vector<Point2> ends = points(path, entry, name);
        if (ends.size() != 2 || ends[0] == ends[1]) {
            fail(path, entry,
                 message(HITOS_TEXT("Errors", "%1: expected two different points"), name));
        }
        world.doors.push_back({ends[0], ends[1], number, entry.source().begin.line});
    }
}

void check_events(const World& world, const Path& path) {
    for (const Disturbance& event : world.tour.events) {
        const Message problem = problem_of(event, world);
        if (!problem.empty()) throw FormatError(path.string(), event.line, problem);
    }
    for (const DriveCommand& command : world.tour.commands) {
        const Message problem = problem_of(command, world.robot);
        if (!problem.empty()) throw FormatError(path.string(), command.line, problem);
    }
}

}  // namespace world_lists
}  // namespace hitos
