// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/simulation/worlds/world.hpp"

#include "hitos/base/error.hpp"
#include "hitos/simulation/drive/simulated_tour.hpp"
#include "hitos/simulation/worlds/world_key.hpp"
#include "worlds.hpp"

namespace hitos {
namespace {

using test::message_of;
using test::TempFolder;
using ::testing::Test;

const std::string kWalls = "walls = [[[0, 0], [4, 0]]]\n";
const std::string kTour = "[tour]\nway_points = [[1, 2]]\n";

std::string refusal(const std::string& text) {
    return message_of<FormatError>([&] { parse_world(text, "folder/w.toml"); });
}
void expect_refusal(const std::string& text, const std::string& expected) {
    const std::string message = refusal(text);
    EXPECT_NE(message.find(expected), std::string::npos) << message;
}

TEST(World, AKeyWithoutEndIsRefusedBeforeAnybodyFollowsIt) {
    std::string key;
    for (int i = 0; i < 200'000; ++i) key += "a.";
    expect_refusal(kWalls + key + "a = 1\n", "w.toml:2: has a key of more than 16 parts");
}

TEST(World, ATourOfTooManyStepsIsToldBeforeItIsDriven) {
    World far =
        parse_world(kWalls + "[tour]\nstart = [1000000, 0, 0]\nway_points = [[1, 2]]\n", "w.toml");
    EXPECT_NE(message_of<FormatError>([&] { SimulatedTour{far}; })
                  .find("w.toml:4: way point 1 at (1, 2) is 999999 m from the start: the tour "
                        "takes more than 10000000 control steps"),
              std::string::npos);
    far.tour.start = {1, 1.5, 0};
    far.tour.rest_s = 1e7;
    EXPECT_THROW(SimulatedTour{far}, Error);
}

TEST(World, ReadsEveryKey) {
    const World world = parse_world(
        "seed = 7\n"
        "walls = [[[0, 0], [4, 0], [4, 3]], [[1, 1], [2, 1.5]]]\n"
        "[tour]\nstart = [1, 2, 90]\nway_points = [[1, 2],\n [3, 4]]\nlaps = 3\nrest = 2.5\n"
        "look_around = true\n"
        "[robot]\nradius = 0.3\nmax_speed = 0.4\nacceleration = 0.2\nmax_turn_rate = 0.6\n"
        "turn_acceleration = 0.7\ntolerance = 0.15\ncontrol_rate = 20\n"
        "[laser]\nrays = 361\nfield_of_view = 270\nmax_range = 30\nsigma = 0.003\nrate = 10\n"
        "mount_x = 0.1\nmount_y = -0.2\nmount_heading = 45\n"
        "[odometry]\nrate = 20\nnoise = 0.05\nnoise_kind = \"variance\"\n",
        "folder/lab.toml");
    EXPECT_EQ(world.name, "lab");
    EXPECT_EQ(world.file, "folder/lab.toml");
    EXPECT_EQ(world.seed, 7U);
    ASSERT_EQ(world.walls.size(), 3U);
    EXPECT_EQ(world.walls[1].a, (Point2{4, 0}));
    EXPECT_EQ(world.walls[1].b, (Point2{4, 3}));
    EXPECT_EQ(world.walls[1].wall, 1);
    EXPECT_EQ(world.walls[2].wall, 2);
    EXPECT_EQ(world.walls[2].line, 2U);
    EXPECT_EQ(world.tour.start, (Pose{1, 2, kPi / 2}));
    ASSERT_EQ(world.tour.way_points.size(), 2U);
    EXPECT_EQ(world.tour.way_points[1].at, (Point2{3, 4}));
    EXPECT_EQ(world.tour.way_points[1].line, 6U);
    EXPECT_EQ(world.tour.laps, 3);
    EXPECT_EQ(world.tour.rest_s, 2.5);
    EXPECT_TRUE(world.tour.look_around);
    EXPECT_EQ(world.robot.radius_m, 0.3);
    EXPECT_EQ(world.robot.max_speed, 0.4);
    EXPECT_EQ(world.robot.acceleration, 0.2);
    EXPECT_EQ(world.robot.max_turn_rate, 0.6);
    EXPECT_EQ(world.robot.turn_acceleration, 0.7);
    EXPECT_EQ(world.robot.tolerance_m, 0.15);
    EXPECT_EQ(world.robot.control_rate_hz, 20.0);
    EXPECT_EQ(world.laser.rays, 361);
    EXPECT_EQ(world.laser.field_of_view_deg, 270.0);
    EXPECT_EQ(world.laser.max_range_m, 30.0);
    EXPECT_EQ(world.laser.sigma_m, 0.003);
    EXPECT_EQ(world.laser.rate_hz, 10.0);
    EXPECT_EQ(world.laser.mount_x_m, 0.1);
    EXPECT_EQ(world.laser.mount_y_m, -0.2);
    EXPECT_EQ(world.laser.mount_heading_deg, 45.0);
    EXPECT_EQ(world.odometry.rate_hz, 20.0);
    EXPECT_EQ(world.odometry.noise, 0.05);
    EXPECT_EQ(world.odometry.noise_kind, OdometryNoiseKind::variance);
}

TEST(World, HasTheDefaultsOfTheThesis) {
    const World world = parse_world(kWalls + kTour, "w.toml");
    EXPECT_EQ(world.laser.rays, 181);
    EXPECT_EQ(world.laser.field_of_view_deg, 180.0);
    EXPECT_EQ(world.laser.max_range_m, 8.0);
    EXPECT_EQ(world.laser.sigma_m, 0.01);
    EXPECT_EQ(world.laser.rate_hz, 5.0);
    EXPECT_EQ(world.odometry.rate_hz, 10.0);
    EXPECT_EQ(world.odometry.noise, 0.1);
    EXPECT_EQ(world.odometry.noise_kind, OdometryNoiseKind::relative_sigma);
    EXPECT_EQ(world.robot.max_speed, 0.5);
    EXPECT_EQ(world.tour.start, Pose{});
    check(world);
}

TEST(World, NamesTheLineOfEveryMistake) {
    expect_refusal("walls = [\n[[0, 0], [4, 0]]\n[tour]", "folder/w.toml:3: ");
    expect_refusal(kWalls + kTour + "speed = 1\n",
                   "w.toml:4: tour.speed: no such key; expected one of tour.laps, tour.rest, "
                   "tour.look_around, tour.reverse, tour.start, tour.way_points");
    expect_refusal("wals = 3\n" + kWalls + kTour, "w.toml:1: wals: no such key; expected walls,");
    expect_refusal(kWalls + kTour + "[lasers]\nrays = 5\n", "w.toml:4: [lasers]: no such group");
    expect_refusal(kWalls + kTour + "[laser]\nsigma = -1\n",
                   "w.toml:5: laser.sigma: found -1, expected 0 to 1 m");
    expect_refusal(kWalls + kTour + "[laser]\nrays = 5.5\n",
                   "w.toml:5: laser.rays: found 5.5, expected a whole number");
    expect_refusal(kWalls + kTour + "[laser]\nsigma = nan\n", "w.toml:5: laser.sigma: found nan");
    expect_refusal(kWalls + kTour + "[laser]\nsigma = \"big\"\n",
                   "w.toml:5: laser.sigma: expected");
    expect_refusal(kWalls + kTour + "[odometry]\nnoise_kind = \"loud\"\n",
                   "found \"loud\", expected one of relative-sigma, variance");
    expect_refusal(kWalls + kTour + "laps = 0\n", "w.toml:4: tour.laps: found 0");
    expect_refusal(kWalls + kTour + "look_around = 3\n",
                   "w.toml:4: tour.look_around: expected one");
    expect_refusal(kWalls + "tour = 3\n", "w.toml:2: tour: no such key");
    expect_refusal(kWalls + kTour + "start = [1, 2]\n",
                   "w.toml:4: tour.start: expected [x, y, head");
}

TEST(World, RefusesWallsAndToursThatAreNone) {
    expect_refusal("walls = [[[0, 0], [4, 0]],\n[[1, 1]]]\n" + kTour,
                   "w.toml:2: wall 2: found one point, expected two points or more");
    expect_refusal("walls = [[]]\n" + kTour, "wall 1: found no point");
    expect_refusal("walls = [[[0, 0],\n[0, 0]]]\n" + kTour,
                   "w.toml:2: wall 1: found the point (0, 0) twice in a row");
    expect_refusal("walls = [[[0, 0], [1, inf]]]\n" + kTour, "wall 1: expected a point [x, y]");
    expect_refusal("walls = [[[0, 0], [1, 2, 3]]]\n" + kTour, "wall 1: expected a point [x, y]");
    expect_refusal("walls = 4\n" + kTour, "walls: expected a list of polylines");
    expect_refusal("walls = []\n" + kTour, "found no walls");
    expect_refusal(kTour, "found no walls");
    expect_refusal(kWalls + "[tour]\nway_points = []\n", "w.toml:3: tour.way_points: found none");
    expect_refusal(kWalls + "[tour]\nway_points = [[1, 1], 7]\n", "way point 2: expected a point");
    expect_refusal("", "found no walls");
}

TEST(World, OneWithoutATourIsToDriveByHandAlone) {
    for (const std::string& rest :
         {std::string("[tour]\n"), std::string("[tour]\nstart = [1, 2, 0]\n")}) {
        World world = parse_world(kWalls + rest, "folder/w.toml");
        world.tour.start.y = 2.0;
        const std::string message = message_of<FormatError>([&] { SimulatedTour{world}; });
        EXPECT_NE(message.find("folder/w.toml: has no tour to drive; expected way_points"),
                  std::string::npos)
            << message;
        EXPECT_TRUE(SimulatedTour::live(world)->is_live());
    }
}

TEST(World, RefusesBytesThatAreNoText) {
    expect_refusal("walls = [[[0, 0], [4, 0]]]\n\xff\xfe\n",
                   "folder/w.toml:1: Encountered invalid utf-8");
}

TEST(World, ReadsWallsFromADrawingBesideIt) {
    const TempFolder folder;
    folder.put("room.dxf",
               "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n0\n20\n0\n11\n4\n21\n0\n"
               "0\nLINE\n8\n0\n10\n0\n20\n9\n11\n9\n21\n9\n0\nENDSEC\n0\nEOF\n");
    const auto path = folder.put("room.toml", "walls_dxf = \"room.dxf\"\n" + kTour);
    const World world = read_world(path);
    ASSERT_EQ(world.walls.size(), 2U);
    EXPECT_EQ(world.walls[1].b, (Point2{9, 9}));
    const World scaled =
        read_world(folder.put("cm.toml", "walls_dxf = \"room.dxf\"\ndxf_unit = 0.01\n" + kTour));
    EXPECT_EQ(scaled.walls[1].b, (Point2{0.09, 0.09}));
    const auto missing = folder.put("no.toml", "walls_dxf = \"no.dxf\"\n" + kTour);
    EXPECT_NE(message_of<FormatError>([&] { read_world(missing); }).find("no.dxf: no such file"),
              std::string::npos);
    const auto layer =
        folder.put("layer.toml", "walls_dxf = \"room.dxf\"\ndxf_layer = \"roof\"\n" + kTour);
    EXPECT_NE(message_of<FormatError>([&] { read_world(layer); }).find("layer \"roof\""),
              std::string::npos);
}

TEST(World, RefusesFilesThatCannotBeRead) {
    const TempFolder folder;
    EXPECT_NE(message_of<FileError>([&] { read_world(folder / "no.toml"); }).find("no such file"),
              std::string::npos);
    EXPECT_NE(message_of<FileError>([&] { read_world(folder / ""); }).find("is a directory"),
              std::string::npos);
}

TEST(World, ValuesCanBeSetByKey) {
    World world = test::small_world();
    for (const WorldKey& key : world_keys()) {
        // Whatever stands there can be set again, by the words that the key gives for it.
        set_world_value(world, std::string(key.key) + "=" + key.text(world));
        EXPECT_FALSE(key.description.empty());
    }
    set_world_value(world, "laser.sigma=0.25");
    EXPECT_EQ(world.laser.sigma_m, 0.25);
    set_world_value(world, "odometry.noise_kind=variance");
    EXPECT_EQ(world.odometry.noise_kind, OdometryNoiseKind::variance);
    set_world_value(world, "seed=12345678901");
    EXPECT_EQ(world.seed, 12345678901U);
    for (const char* bad : {"laser.sigma", "laser.sigma=", "laser.sigma=1m", "laser.sigma=-1",
                            "laser.sigma=nan", "laser.rays=1e9", "seed=1.5", "laser.=1", "x=1",
                            "tour.look_around=1", "odometry.noise_kind=0"}) {
        EXPECT_THROW(set_world_value(world, bad), ConfigError) << bad;
    }
    EXPECT_EQ(world.laser.sigma_m, 0.25);
}

TEST(World, ValuesSetByCodeAreChecked) {
    World world = test::small_world();
    world.laser.rate_hz = 0.0;
    EXPECT_NE(message_of<ConfigError>([&] { check(world); }).find("laser.rate: found 0"),
              std::string::npos);
    world = test::small_world();
    world.walls.clear();
    EXPECT_THROW(check(world), ConfigError);
}

}  // namespace
}  // namespace hitos
