// SPDX-License-Identifier: GPL-3.0-or-later
// Worlds edited as text: nothing changes but what is set.
#include "hitos/simulation/text/world_text.hpp"

#include <algorithm>
#include <limits>
#include <random>
#include <sstream>

#include "hitos/base/error.hpp"
#include "worlds.hpp"

namespace hitos {
namespace {

using test::message_of;
using test::TempFolder;

const std::string kRoom =
    "# A room.\n"
    "walls = [  # all of them\n"
    "    # round the room\n"
    "    [[-2, -2], [8, -2], [8, 4.0], [-2, 4], [-2, -2]],  # closed\n"
    "    [[1, 1], [2, 1]],  # a desk\n"
    "    [[3, 1], [4, 1]]  # another\n"
    "]\n"
    "\n"
    "# How it is driven.\n"
    "[tour]\n"
    "start = [0, 0, 450]  # north\n"
    "way_points = [\n"
    "    [0, 2], [5, 2],  # north wall\n"
    "    [5, 0],\n"
    "]\n"
    "laps = 2 # twice\n"
    "\n"
    "[laser]\n"
    "sigma = 1e-2\n";

WorldText room() {
    return {kRoom, "room.toml"};
}

/// The text with one piece in the place of another, which stands there once.
std::string with(std::string text, const std::string& piece, const std::string& other) {
    const std::size_t at = text.find(piece);
    EXPECT_NE(at, std::string::npos) << piece;
    EXPECT_EQ(text.find(piece, at + 1), std::string::npos) << piece;
    return at == std::string::npos ? text : text.replace(at, piece.size(), other);
}

std::vector<std::string> lines(const std::string& text) {
    std::vector<std::string> found;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) found.push_back(line);
    return found;
}

std::vector<std::filesystem::path> world_files() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(
             std::filesystem::path(HITOS_SOURCE_DIR) / "data/worlds")) {
        if (entry.path().extension() == ".toml") files.push_back(entry.path());
    }
    return files;
}

TEST(WorldText, WhatIsNotChangedKeepsEveryByteInEveryWorld) {
    ASSERT_GE(world_files().size(), 8U);
    for (const std::filesystem::path& file : world_files()) {
        WorldText text = WorldText::read(file);
        const std::string before = test::content(file);
        EXPECT_TRUE(same_world(text.world(), read_world(file))) << file;
        text.set(read_world(file));
        text.set_walls(text.walls());
        EXPECT_EQ(text.text(), before) << file;
    }
}

TEST(WorldText, ChangingOnePointChangesOneLineOfEveryWorld) {
    for (const std::filesystem::path& file : world_files()) {
        WorldText text = WorldText::read(file);
        const std::vector<std::string> before = lines(text.text());
        std::vector<Polyline> walls = text.walls();
        walls.back().back().x += 0.125;
        text.set_walls(walls);
        EXPECT_EQ(text.walls(), walls) << file;
        const std::vector<std::string> after = lines(text.text());
        ASSERT_EQ(after.size(), before.size()) << file;
        std::size_t changed = 0;
        for (std::size_t i = 0; i < after.size(); ++i) changed += after[i] != before[i];
        EXPECT_EQ(changed, 1U) << file;
        EXPECT_TRUE(same_world(parse_world(text.text(), file), text.world())) << file;
    }
}

TEST(WorldText, ANumberChangesAlone) {
    WorldText text = room();
    text.set_value("laser.sigma", "0.01");
    EXPECT_EQ(text.text(), kRoom);  // 1e-2 is that
    text.set_value("tour.laps", "3");
    EXPECT_EQ(text.text(), with(kRoom, "laps = 2 # twice", "laps = 3 # twice"));
    text = room();
    std::vector<Polyline> walls = text.walls();
    walls[0][2].x = 8.5;
    text.set_walls(walls);
    EXPECT_EQ(text.text(), with(kRoom, "[8, 4.0]", "[8.5, 4.0]"));
}

TEST(WorldText, TheHeadingKeepsItsDigitsWhereTheStartMoves) {
    WorldText text = room();
    Pose start = text.world().tour.start;
    start.y = 1.5;
    text.set_start(start);
    EXPECT_EQ(text.text(), with(kRoom, "[0, 0, 450]", "[0, 1.5, 450]"));
    start.theta = -kPi / 4.0;
    text.set_start(start);
    EXPECT_EQ(text.text(), with(kRoom, "[0, 0, 450]", "[0, 1.5, -45]"));
}

TEST(WorldText, EntriesComeAndGoAndOthersKeepTheirComments) {
    const std::vector<Polyline> all = room().walls();
    WorldText text = room();
    text.set_walls(std::vector{all[0], all[2]});
    EXPECT_EQ(text.text(), with(kRoom, "    [[1, 1], [2, 1]],  # a desk\n", ""));
    text = room();
    text.set_walls(std::vector{all[0], all[1]});
    EXPECT_EQ(text.text(), with(kRoom, "    [[3, 1], [4, 1]]  # another\n", ""));
    text = room();
    const Polyline fresh = {{6, 1}, {6, 2.25}};
    text.set_walls(std::vector{all[0], fresh, all[1], all[2]});
    EXPECT_EQ(text.text(), with(kRoom, "# closed\n", "# closed\n    [[6, 1], [6, 2.25]],\n"));
    text = room();
    text.set_walls(std::vector{all[0], all[1], all[2], fresh});
    EXPECT_EQ(text.text(), with(kRoom, "[[3, 1], [4, 1]]  # another\n",
                                "[[3, 1], [4, 1]],  # another\n    [[6, 1], [6, 2.25]]\n"));
    text = room();
    text.set_walls(std::vector{fresh, all[0], all[1], all[2]});
    EXPECT_EQ(text.text(),
              with(kRoom, "# all of them\n", "# all of them\n    [[6, 1], [6, 2.25]],\n"));
}

TEST(WorldText, PointsOnOneLineComeAndGo) {
    WorldText text = room();
    text.set_way_points(std::vector<Point2>{{0, 2}, {5, 0}});
    EXPECT_EQ(text.text(), with(kRoom, "[0, 2], [5, 2],  # north", "[0, 2], # north"));
    text = room();
    text.set_way_points(std::vector<Point2>{{5, 0}});
    EXPECT_EQ(text.text(), with(kRoom, "    [0, 2], [5, 2],  # north wall\n", ""));
    text = room();
    text.set_way_points(std::vector<Point2>{{0, 2}, {3, 3}, {5, 2}, {5, 0}, {0, 0}});
    EXPECT_EQ(text.text(), with(with(kRoom, "[0, 2], [5, 2]", "[0, 2], [3, 3], [5, 2]"),
                                "    [5, 0],\n", "    [5, 0],\n    [0, 0],\n"));
}

TEST(WorldText, NewKeysGoToTheirGroups) {
    WorldText text = room();
    text.set_value("tour.rest", "1.5");
    text.set_value("robot.radius", "0.3");
    text.set_value("seed", "7");
    text.set_doors(std::vector<std::pair<Point2, Point2>>{{{0, 1}, {0, 3}}});
    EXPECT_EQ(text.text(), with(with(kRoom, "twice\n", "twice\nrest = 1.5\n"), "]\n\n# How",
                                "]\nseed = 7\ndoors = [\n    [[0, 1], [0, 3]],\n]\n\n# How") +
                               "\n[robot]\nradius = 0.3\n");
    text.set_doors({});
    EXPECT_EQ(text.text(), with(with(kRoom, "twice\n", "twice\nrest = 1.5\n"), "]\n\n# How",
                                "]\nseed = 7\n\n# How") +
                               "\n[robot]\nradius = 0.3\n");
}

TEST(WorldText, AWorldIsMadeFromNothing) {
    WorldText text("made.toml");
    EXPECT_EQ(text.text(), "");
    EXPECT_TRUE(text.world().walls.empty());
    text.set_value("laser.no_return", "max-range");
    text.set_walls(std::vector<Polyline>{{{0, 0}, {4, 0}}, {{0, 1}, {4, 1}}});
    text.set_value("tour.look_around", "true");
    EXPECT_EQ(text.text(),
              "walls = [\n    [[0, 0], [4, 0]],\n    [[0, 1], [4, 1]],\n]\n\n"
              "[laser]\nno_return = \"max-range\"\n\n[tour]\nlook_around = true\n");
    EXPECT_TRUE(same_world(parse_world(text.text(), "made.toml"), text.world()));
}

TEST(WorldText, CommandsTakeThePlaceOfWayPoints) {
    WorldText text = room();
    text.set_commands(std::vector<DriveCommand>{{0.5, 0.1, 2.0}});
    EXPECT_TRUE(text.world().tour.way_points.empty());
    EXPECT_EQ(text.text().find("way_points"), std::string::npos);
    EXPECT_NE(text.text().find("laps = 2 # twice\ncommands = [[0.5, 0.1, 2]]\n"), std::string::npos)
        << text.text();
    text.set_way_points(std::vector<Point2>{{1, 2}});
    EXPECT_TRUE(text.world().tour.commands.empty());
    EXPECT_EQ(text.world().tour.way_points.size(), 1U);
}

TEST(WorldText, EventsAndPeopleKeepTheirWayOfBeingWritten) {
    const std::string before =
        kRoom +
        "# Who walks\n[[people]]\nway = [[1, 2], [3, 2]]  # to and fro\nspeed = 0.8\n"
        "\n[[people]] # a second\nway = [[1, 3], [3, 3]]\n";
    WorldText text(before, "room.toml");
    std::vector<Walker> people = text.world().walkers;
    ASSERT_EQ(people.size(), 2U);
    people[0].way[1].x = 4;
    people[1].radius_m = 0.5;
    text.set_people(people);
    EXPECT_EQ(text.text(), with(with(before, "[3, 2]]  # to", "[4, 2]]  # to"), "# a second\n",
                                "# a second\nradius = 0.5\n"));
    people.erase(people.begin());
    text.set_people(people);
    people.push_back({{{0, 0}, {1, 0}}, 1.5, 0.25});
    text.set_people(people);
    EXPECT_NE(text.text().find("[[people]]\nway = [[0, 0], [1, 0]]\nspeed = 1.5\n"),
              std::string::npos)
        << text.text();
    EXPECT_EQ(text.text().find("to and fro"), std::string::npos);
    text.set_people({});
    EXPECT_EQ(text.text().find("[[people]]"), std::string::npos);

    const std::string events = with(kRoom, "laps = 2 # twice\n",
                                    "events = [\n  { at = 2.0, blind = 1.5 },  # dark\n"
                                    "  { at = 3, push = [1, 0, 20] },\n]\n");
    WorldText other(events, "room.toml");
    std::vector<Disturbance> happens = other.world().tour.events;
    happens[1].values[2] = 25;
    happens.push_back({DisturbanceKind::box, 4.0, {1, 3, 0.4}});
    other.set_events(happens);
    EXPECT_EQ(other.text(), with(events, "{ at = 3, push = [1, 0, 20] },\n",
                                 "{ at = 3, push = [1, 0, 25] },\n"
                                 "  { at = 4, box = [1, 3, 0.4] },\n"));
}

TEST(WorldText, OtherWaysToWriteATableAreKept) {
    const std::string walls = "walls = [[[0, 0], [4, 0]]]\n";
    WorldText dotted(walls + "tour.laps = 2\ntour.way_points = [[1, 2]]\n", "w.toml");
    dotted.set_value("tour.rest", "1");
    EXPECT_EQ(dotted.text(), walls + "tour.laps = 2\ntour.way_points = [[1, 2]]\ntour.rest = 1\n");
    WorldText inside(walls + "tour = { laps = 2, way_points = [[1, 2]] } # short\n", "w.toml");
    inside.set_value("tour.rest", "1");
    inside.set_way_points({});
    EXPECT_EQ(inside.text(), walls + "tour = { laps = 2, rest = 1 } # short\n");
    WorldText headed(walls + "\n# it happens\n[[tour.events]]\nat = 1\nblind = 2\n", "w.toml");
    headed.set_value("tour.rest", "1");
    EXPECT_EQ(headed.text(), walls +
                                 "\n[tour]\nrest = 1\n\n# it happens\n[[tour.events]]\nat = 1\n"
                                 "blind = 2\n");
}

TEST(WorldText, LineEndsMarksAndLettersAreNoMatter) {
    const std::string text =
        "\xef\xbb\xbfwalls = [[[0, 0], [4, 0]], # \xc3\xb1\xe2\x82\xac\r\n"
        "  [[0, 1], [4, 1]]] # ma\xc3\xb1"
        "ana\r\n[tour]\r\nway_points = [[1, 2]]\r\n";
    WorldText edited(text, "w.toml");
    std::vector<Polyline> walls = edited.walls();
    walls[1][0].y = 2;
    edited.set_walls(walls);
    EXPECT_EQ(edited.text(), with(text, "[[0, 1]", "[[0, 2]"));
    edited.set_value("tour.laps", "2");
    EXPECT_EQ(edited.text(), with(text, "[[0, 1]", "[[0, 2]") + "laps = 2\r\n");
}

TEST(WorldText, WhatCannotBeIsRefusedAndChangesNothing) {
    for (const std::string damaged :
         {"walls = [", "walls = 3", "nonsense = 1", "[tour]\nlaps = 0", "walls = [[[0, 0]]]"}) {
        const std::string expected =
            message_of<FormatError>([&] { parse_world(damaged, "w.toml"); });
        EXPECT_EQ(message_of<FormatError>([&] { WorldText(damaged, "w.toml"); }), expected);
    }
    TempFolder folder;
    const auto empty = folder.put("empty.toml", "");
    EXPECT_NE(message_of<FormatError>([&] { WorldText::read(empty); }).find("found no walls"),
              std::string::npos);
    WorldText text = room();
    message_of<ConfigError>([&] { text.set_value("laser.sigma", "-1"); });
    message_of<ConfigError>([&] { text.set_value("laser.colour", "1"); });
    message_of<FormatError>([&] { text.set_walls(std::vector<Polyline>{{{0, 0}}}); });
    message_of<FormatError>([&] {
        text.set_walls(
            std::vector<Polyline>{{{0, 0}, {0, std::numeric_limits<double>::quiet_NaN()}}});
    });
    message_of<FormatError>([&] {
        text.set_events(std::vector<Disturbance>{{DisturbanceKind::open, 1.0, {1, 0, 0}}});
    });
    EXPECT_EQ(text.text(), kRoom);
}

TEST(WorldText, ADrawingsWallsStayInTheDrawing) {
    TempFolder folder;
    folder.put("room.dxf",
               "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\nWALLS\n10\n0\n20\n0\n11\n4\n21\n0\n0\nENDSEC\n"
               "0\nEOF\n");
    const auto file = folder.put("w.toml", "walls_dxf = \"room.dxf\"\n");
    WorldText text = WorldText::read(file);
    EXPECT_TRUE(text.walls().empty());
    text.set_walls(std::vector<Polyline>{{{0, 1}, {4, 1}}});
    EXPECT_EQ(text.world().walls.size(), 2U);
    World other = text.world();
    other.walls.back().b.x = 5;
    EXPECT_NE(message_of<ConfigError>([&] { text.set(other); }).find("room.dxf"),
              std::string::npos);
    TempFolder elsewhere;
    message_of<FormatError>([&] { text.save(elsewhere / "w.toml"); });
    EXPECT_EQ(elsewhere.files(), 0U);
    text.save(file);
    EXPECT_TRUE(same_world(read_world(file), text.world()));
}

/// Numbers of every size and of few digits and many.
class Draw {
  public:
    double number(double greatest) {
        const double value = std::uniform_real_distribution(-greatest, greatest)(random_);
        switch (random_() % 5) {
            case 0:
                return std::round(value);
            case 1:
                return std::round(value * 100.0) / 100.0;
            case 2:
                return value * 1e-9;
            case 3:
                return random_() % 2 == 0 ? 0.0 : -0.0;
            default:
                return value;
        }
    }
    Point2 point() { return {number(1000.0), number(1000.0)}; }
    std::size_t count(std::size_t most) { return random_() % (most + 1); }

  private:
    std::mt19937 random_{11};
};

World random_world(Draw& draw, World world) {
    world.walls.clear();
    const std::size_t walls = 1 + draw.count(6);
    for (std::size_t i = 0; i < walls; ++i) {
        Point2 a = draw.point();
        for (std::size_t k = 0; k < 1 + draw.count(3); ++k) {
            const Point2 b = draw.point();
            if (a == b) continue;
            world.walls.push_back({a, b, static_cast<int>(i) + 1});
            a = b;
        }
        if (world.walls.empty() || world.walls.back().wall != static_cast<int>(i) + 1)
            world.walls.push_back({a, {a.x + 1, a.y}, static_cast<int>(i) + 1});
    }
    world.tour.way_points.clear();
    world.tour.commands.clear();
    for (std::size_t i = draw.count(8); i > 0; --i) {
        world.tour.way_points.push_back({draw.point()});
    }
    if (world.tour.way_points.empty()) {
        for (std::size_t i = draw.count(5); i > 0; --i)
            world.tour.commands.push_back(
                {draw.number(0.4), draw.number(0.4), std::abs(draw.number(30.0))});
    }
    world.tour.events.clear();
    for (std::size_t i = draw.count(4); i > 0; --i)
        world.tour.events.push_back({DisturbanceKind::push,
                                     std::abs(draw.number(60.0)),
                                     {draw.number(3.0), draw.number(3.0), draw.number(90.0)}});
    world.walkers.clear();
    for (std::size_t i = draw.count(3); i > 0; --i) {
        const Point2 a = draw.point();
        world.walkers.push_back({{a, {a.x + 1, a.y}, draw.point()}, std::abs(draw.number(2.0))});
    }
    world.tour.start = {draw.number(10.0), draw.number(10.0),
                        wrap_angle(draw.number(180.0) * (kPi / 180.0))};
    world.laser.sigma_m = std::abs(draw.number(1.0));
    world.tour.laps = 1 + static_cast<int>(draw.count(5));
    world.seed = draw.count(1) == 0 ? 0 : (std::uint64_t{1} << 53U) - draw.count(5);
    return world;
}

TEST(WorldText, RandomWorldsReadBackToTheLastBit) {
    Draw draw;
    const std::vector<std::filesystem::path> files = world_files();
    for (int round = 0; round < 200; ++round) {
        const auto& file = files[static_cast<std::size_t>(round) % files.size()];
        WorldText text = round % 3 == 0 ? WorldText("new.toml") : WorldText::read(file);
        for (int again = 0; again < 3; ++again) {
            const World wanted = random_world(draw, text.world());
            text.set(wanted);
            ASSERT_TRUE(same_world(parse_world(text.text(), file), wanted)) << text.text();
            const std::string before = text.text();
            text.set(wanted);
            ASSERT_EQ(text.text(), before);
        }
    }
}

TEST(WorldText, CommentsOfEveryWorldOutliveOtherWalls) {
    for (const std::filesystem::path& file : world_files()) {
        WorldText text = WorldText::read(file);
        std::vector<std::string> comments;
        for (const std::string& line : lines(text.text())) {
            if (line.find_first_not_of(" \t") != std::string::npos &&
                line[line.find_first_not_of(" \t")] == '#')
                comments.push_back(line);
        }
        std::vector<Polyline> walls = text.walls();
        for (std::size_t i = 0; i < walls.size(); i += 2) walls[i].front().x -= 0.5;
        if (walls.size() > 1)
            walls.erase(walls.begin() + static_cast<std::ptrdiff_t>(walls.size()) / 2);
        text.set_walls(walls);
        EXPECT_EQ(text.walls(), walls);
        for (const std::string& comment : comments) {
            EXPECT_NE(text.text().find(comment), std::string::npos) << file << comment;
        }
    }
}

}  // namespace
}  // namespace hitos
