// SPDX-License-Identifier: GPL-3.0-or-later
// Things of a drawn world: found, put in, moved, taken out.
#include "hitos/simulation/text/world_editing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/simulation/drive/simulated_tour.hpp"
#include "hitos/simulation/text/snapping.hpp"
#include "worlds.hpp"

namespace hitos {
namespace {

constexpr const char* kHouse =
    "# A house.\n"
    "walls = [\n"
    "    [[0, 0], [6, 0], [6, 4], [0, 4], [0, 0]],  # all round\n"
    "    [[3, 4], [3, 2]],\n"
    "]\n"
    "people = [{way = [[1, 1], [2, 1], [2, 2]], speed = 0.5}]  # the cat\n"
    "[tour]\n"
    "start = [1, 1, 90]  # looks north\n"
    "way_points = [[5, 1], [5, 3]]\n"
    "events = [{at = 0, box = [4, 2, 0.5]}, {at = 3, push = [1, 0, 0]}]\n"
    "[laser]\n"
    "sigma = 0.02  # old\n";

WorldText house() {
    return {kHouse, "house.toml"};
}

WorldItem found_at(const WorldText& text, const Point2& point) {
    const auto item = item_at(text, point, 0.1);
    EXPECT_TRUE(item) << point.x << ", " << point.y;
    return item.value_or(WorldItem{});
}

TEST(WorldEditing, FindsWhatIsBelow) {
    const WorldText text = house();
    using enum ItemKind;
    EXPECT_EQ(found_at(text, {6.02, 3.95}), (WorldItem{wall, 0, 2, 2}));
    EXPECT_EQ(found_at(text, {6.02, 2.0}), (WorldItem{wall, 0, 1, 2}));
    EXPECT_EQ(found_at(text, {3.05, 3.0}), (WorldItem{wall, 1, 0, 1}));
    EXPECT_EQ(found_at(text, {4.25, 2.0}), (WorldItem{box, 0, 0, 0}));
    EXPECT_EQ(found_at(text, {1.5, 1.05}), (WorldItem{person, 0, 0, 1}));
    EXPECT_EQ(found_at(text, {5.0, 3.02}), (WorldItem{way_point, 1, 0, 0}));
    EXPECT_EQ(found_at(text, {1.0, 1.0}).kind, start);  // what is drawn above
    EXPECT_FALSE(item_at(text, {4.0, 3.0}, 0.1));
    EXPECT_EQ(whole_of(text, {wall, 0, 1, 2}), (WorldItem{wall, 0, 0, 4}));
    EXPECT_EQ(outline_of(text, {wall, 0, 1, 2}), (Polyline{{6, 0}, {6, 4}}));
    EXPECT_EQ(outline_of(text, {box, 0, 0, 0}).size(), 5U);
    EXPECT_TRUE(outline_of(text, {wall, 7, 0, 1}).empty());
    EXPECT_TRUE(outline_of(text, {wall, 0, 4, 5}).empty());
}

TEST(WorldEditing, ADoorTakesItsPlaceInTheWallAndLeavesItAgain) {
    WorldText text = house();
    add_door(text, {6, 1}, {6, 2});
    EXPECT_EQ(text.walls()[0], (Polyline{{6, 2}, {6, 4}, {0, 4}, {0, 0}, {6, 0}, {6, 1}}));
    EXPECT_EQ(text.walls()[1], (Polyline{{3, 4}, {3, 2}}));
    ASSERT_EQ(text.world().doors.size(), 1U);
    // Moved along, and to another wall.
    const WorldItem door = whole_of(text, found_at(text, {6, 1.5}));
    EXPECT_EQ(door.kind, ItemKind::door);
    move_item(text, door, {0, 1.5});
    EXPECT_EQ(text.walls()[0].front(), (Point2{6, 3.5}));
    EXPECT_EQ(text.walls()[0].back(), (Point2{6, 2.5}));
    remove_item(text, door);
    EXPECT_TRUE(text.world().doors.empty());
    const auto walls = text.walls();
    ASSERT_EQ(walls.size(), 2U);
    EXPECT_EQ(walls[0].size(), 5U);
    EXPECT_EQ(walls[0].front(), walls[0].back());
    EXPECT_NE(text.text().find("# A house."), std::string::npos);
    EXPECT_NE(text.text().find("# the cat"), std::string::npos);
    EXPECT_NE(text.text().find("# looks north"), std::string::npos);
}

TEST(WorldEditing, DoorsAtEndsAndAcrossPieces) {
    WorldText text("walls = [[[0, 0], [2, 0], [4, 0], [4, 3]]]\n", "w.toml");
    add_door(text, {1.5, 0.004}, {2.5, 0.0});  // over a point, and a little beside the wall
    EXPECT_EQ(text.walls(),
              (std::vector<Polyline>{{{0, 0}, {1.5, 0.004}}, {{2.5, 0.0}, {4, 0}, {4, 3}}}));
    add_door(text, {4, 2}, {4, 3});  // up to its end
    EXPECT_EQ(text.walls()[1], (Polyline{{2.5, 0.0}, {4, 0}, {4, 2}}));
    remove_item(text, {ItemKind::door, 1, 0, 1});  // no wall goes on behind it: the gap stays
    EXPECT_EQ(text.walls()[1], (Polyline{{2.5, 0.0}, {4, 0}, {4, 2}}));
    // One up to a corner of a room, and one a little beside its wall, give the wall back.
    for (const auto& [a, b] : Walls{{{6, 3}, {6, 4}}, {{6, 0}, {6, 1}}, {{2, 0.004}, {3, 0.004}}}) {
        WorldText room = house();
        const std::size_t walls = room.world().walls.size();
        add_door(room, a, b);
        EXPECT_NE(room.walls()[0].front(), room.walls()[0].back());
        remove_item(room, {ItemKind::door, 0, 0, 1});
        EXPECT_EQ(room.world().walls.size(), walls);
        EXPECT_EQ(room.walls()[0].front(), room.walls()[0].back());
    }
    // One in the open touches nothing, nor one behind a wall's end.
    const auto walls = text.walls();
    add_door(text, {1, 1}, {2, 1});
    EXPECT_EQ(text.walls(), walls);
    WorldText beside("walls = [[[0, 0], [4, 0], [4, 3]]]\n", "w.toml");
    add_door(beside, {4, 0}, {5, 0});
    EXPECT_EQ(beside.walls(), (std::vector<Polyline>{{{0, 0}, {4, 0}, {4, 3}}}));
}

TEST(WorldEditing, EventsOfDoorsFollowTheirNumbers) {
    WorldText text(
        "walls = [[[0, 0], [9, 0]]]\n"
        "doors = [[[1, 1], [2, 1]], [[3, 1], [4, 1]], [[5, 1], [6, 1]]]\n"
        "[tour]\nevents = [{at = 1, open = 3}, {at = 2, open = 2}, {at = 4, close = 1}]\n",
        "w.toml");
    remove_item(text, {ItemKind::door, 1, 0, 1});
    const auto& events = text.world().tour.events;
    ASSERT_EQ(events.size(), 2U);
    EXPECT_EQ(events[0].values[0], 2.0);
    EXPECT_EQ(events[1].values[0], 1.0);
}

TEST(WorldEditing, CommentsStayWithTheEventsThatTheyAreOf) {
    WorldText text(
        "walls = [[[0, 0], [9, 0]]]\n"
        "doors = [[[1, 1], [2, 1]], [[3, 1], [4, 1]], [[5, 1], [6, 1]]]\n"
        "[tour]\nevents = [\n    { at = 0, open = 1 },  # first\n    { at = 0, open = 2 },  # "
        "second\n"
        "    { at = 0, open = 3 },  # third\n]\n",
        "w.toml");
    remove_item(text, {ItemKind::door, 0, 0, 1});
    EXPECT_EQ(text.text().find("# first"), std::string::npos) << text.text();
    EXPECT_NE(text.text().find("{ at = 0, open = 1 },  # second"), std::string::npos)
        << text.text();
    EXPECT_NE(text.text().find("{ at = 0, open = 2 },  # third"), std::string::npos) << text.text();
}

TEST(WorldEditing, ACommaOnALineOfItsOwnGoesWithItsEvent) {
    WorldText text(
        "walls = [[[0, 0], [9, 0]]]\n"
        "doors = [[[1, 1], [2, 1]], [[3, 1], [4, 1]]]\n"
        "[tour]\nevents = [\n    { at = 0, open = 1 }\n    ,\n    { at = 0, open = 2 }\n]\n",
        "w.toml");
    remove_item(text, {ItemKind::door, 0, 0, 1});
    ASSERT_EQ(text.world().tour.events.size(), 1U) << text.text();
    EXPECT_EQ(text.world().tour.events[0].values[0], 1.0);
}

TEST(WorldEditing, ATourLeadsThroughADoorThatWasDrawn) {
    WorldText text("walls = [[[4, -2], [4, 6]]]\n[tour]\nway_points = [[2, 0], [6, 0]]\n",
                   "w.toml");
    EXPECT_THROW(SimulatedTour(text.world()), FormatError);
    add_door(text, {4, -1}, {4, 1});
    ASSERT_EQ(text.world().tour.events.size(), 1U);
    EXPECT_NO_THROW(SimulatedTour(text.world()));
    remove_item(text, {ItemKind::door, 0, 0, 1});
    EXPECT_TRUE(text.world().tour.events.empty());
    EXPECT_THROW(SimulatedTour(text.world()), FormatError);
}

TEST(WorldEditing, MovesPointsPiecesAndWholes) {
    WorldText text = house();
    move_item(text, {ItemKind::wall, 0, 0, 0}, {-1, 0});  // begins and ends the wall
    EXPECT_EQ(text.walls()[0], (Polyline{{-1, 0}, {6, 0}, {6, 4}, {0, 4}, {-1, 0}}));
    move_item(text, {ItemKind::wall, 0, 1, 2}, {0.1, 0.2});
    EXPECT_EQ(text.walls()[0], (Polyline{{-1, 0}, {6.1, 0.2}, {6.1, 4.2}, {0, 4}, {-1, 0}}));
    move_item(text, {ItemKind::box, 0, 0, 0}, {0.3, 0});
    EXPECT_EQ(text.world().tour.events[0].values[0], 4.3);
    move_item(text, {ItemKind::person, 0, 0, 2}, {1, 1});
    EXPECT_EQ(text.world().walkers[0].way, (Polyline{{2, 2}, {3, 2}, {3, 3}}));
    move_item(text, {ItemKind::way_point, 1, 0, 0}, {0, 0.5});
    EXPECT_EQ(text.world().tour.way_points[1].at, (Point2{5, 3.5}));
    move_item(text, {ItemKind::start, 0, 0, 0}, {0.5, 0});
    EXPECT_EQ(text.world().tour.start.x, 1.5);
    EXPECT_NE(text.text().find("start = [1.5, 1, 90]  # looks north"), std::string::npos);
}

TEST(WorldEditing, TakesOutPointsPiecesAndWholes) {
    WorldText text = house();
    remove_item(text, {ItemKind::wall, 0, 1, 2});  // a closed wall opens
    EXPECT_EQ(text.walls()[0], (Polyline{{6, 4}, {0, 4}, {0, 0}, {6, 0}}));
    remove_item(text, {ItemKind::wall, 0, 1, 2});  // an open one falls into two
    EXPECT_EQ(text.walls(),
              (std::vector<Polyline>{{{6, 4}, {0, 4}}, {{0, 0}, {6, 0}}, {{3, 4}, {3, 2}}}));
    remove_item(text, {ItemKind::wall, 2, 0, 0});  // of two points none stays
    EXPECT_EQ(text.walls().size(), 2U);
    remove_item(text, {ItemKind::person, 0, 1, 1});
    EXPECT_EQ(text.world().walkers[0].way, (Polyline{{1, 1}, {2, 2}}));
    remove_item(text, {ItemKind::person, 0, 0, 1});
    EXPECT_TRUE(text.world().walkers.empty());
    remove_item(text, {ItemKind::box, 0, 0, 0});
    ASSERT_EQ(text.world().tour.events.size(), 1U);
    EXPECT_EQ(text.world().tour.events[0].kind, DisturbanceKind::push);
    remove_item(text, {ItemKind::way_point, 0, 0, 0});
    EXPECT_EQ(text.world().tour.way_points.size(), 1U);
    const std::string as_it_was = text.text();
    remove_item(text, {ItemKind::start, 0, 0, 0});
    remove_item(text, {ItemKind::wall, 9, 0, 1});
    EXPECT_EQ(text.text(), as_it_was);
}

TEST(WorldEditing, ACornerOfAClosedWallGoesToo) {
    WorldText text = house();
    remove_item(text, {ItemKind::wall, 0, 0, 0});
    EXPECT_EQ(text.walls()[0], (Polyline{{6, 0}, {6, 4}, {0, 4}, {6, 0}}));
    remove_item(text, {ItemKind::wall, 0, 3, 3});
    EXPECT_EQ(text.walls()[0], (Polyline{{6, 4}, {0, 4}}));
}

TEST(WorldEditing, Numbers) {
    WorldText text = house();
    const auto value = [&](const WorldItem& item, std::size_t place) {
        return numbers_of(text, item).at(place).value;
    };
    const WorldItem wall{ItemKind::wall, 1, 0, 1};
    EXPECT_DOUBLE_EQ(value(wall, 0), 2.0);
    EXPECT_DOUBLE_EQ(value(wall, 1), -90.0);
    set_number(text, wall, 0, 2.5);
    set_number(text, wall, 1, 180.0);
    EXPECT_EQ(text.walls()[1], (Polyline{{3, 4}, {0.5, 4}}));
    set_number(text, {ItemKind::box, 0, 0, 0}, 2, 0.75);
    EXPECT_EQ(text.world().tour.events[0].values[2], 0.75);
    set_number(text, {ItemKind::start, 0, 0, 0}, 2, -45.0);
    EXPECT_NE(text.text().find("start = [1, 1, -45]"), std::string::npos);
    set_number(text, {ItemKind::person, 0, 0, 1}, 1, 0.3);
    EXPECT_EQ(text.world().walkers[0].radius_m, 0.3);
    set_number(text, {ItemKind::way_point, 0, 0, 0}, 0, 4.5);
    EXPECT_EQ(text.world().tour.way_points[0].at, (Point2{4.5, 1}));
    // What cannot be changes nothing.
    const std::string as_it_was = text.text();
    EXPECT_THROW(set_number(text, {ItemKind::box, 0, 0, 0}, 2, -1.0), Error);
    EXPECT_THROW(set_number(text, wall, 0, 0.0), Error);
    EXPECT_THROW(set_number(text, {ItemKind::person, 0, 0, 1}, 0, -1.0), Error);
    EXPECT_THROW(add_wall(text, {{1, 1}}), Error);
    EXPECT_THROW(add_door(text, {1, 1}, {1, 1}), Error);
    EXPECT_THROW(add_box(text, {std::nan(""), 0}, 1.0), Error);
    EXPECT_EQ(text.text(), as_it_was);
}

/// Whatever is done, the text reads back as the world that it holds, and its comments stay.
TEST(WorldEditing, RandomEditsOfShippedWorldsLeaveThemWhole) {
    for (const std::string& name : test::shipped_names()) {
        WorldText text = WorldText::read(std::filesystem::path(HITOS_SOURCE_DIR) / "data/worlds" /
                                         (name + ".toml"));
        const bool remarked = text.text().starts_with('#');
        const std::string remark = text.text().substr(0, text.text().find('\n'));
        std::mt19937 random(7);
        const auto among = [&](double low, double high) {
            return std::uniform_real_distribution(low, high)(random);
        };
        for (int step = 0; step < 60; ++step) {
            const Point2 at = to_the_micrometre({among(-5, 20), among(-5, 20)});
            const auto item = item_at(text, at, 3.0);
            const std::string before = text.text();
            try {
                switch (step % 6) {
                    case 0:
                        add_box(text, at, among(0.1, 1.0));
                        break;
                    case 1:
                        add_wall(text, {at, {at.x + 1.0, at.y + among(-1, 1)}});
                        break;
                    case 2:
                        if (item) move_item(text, *item, {among(-1, 1), among(-1, 1)});
                        break;
                    case 3:
                        if (item) remove_item(text, *item);
                        break;
                    case 4:
                        add_way_point(text, at);
                        break;
                    default:
                        add_door(text, at, {at.x, at.y + 1.0});
                }
            } catch (const Error&) {  // it cannot be
                ASSERT_EQ(text.text(), before) << name << ", step " << step;
            }
            ASSERT_TRUE(same_world(WorldText(text.text(), text.path()).world(), text.world()))
                << name << ", step " << step;
        }
        EXPECT_TRUE(!remarked || text.text().starts_with(remark)) << name;
    }
}

}  // namespace
}  // namespace hitos
