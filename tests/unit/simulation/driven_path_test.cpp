// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/simulation/drive/driven_path.hpp"

#include <algorithm>
#include <cmath>

#include "hitos/base/error.hpp"
#include "worlds.hpp"

namespace hitos {
namespace {

using test::message_of;
using test::small_world;

/// Speed, turn rate and their changes stay within the robot's bounds; the path follows from them.
void expect_kinematics(const World& world, const DrivenPath& path) {
    const double period = 1.0 / path.rate_hz();
    constexpr double kRounding = 1e-12;
    Twist before;
    Pose pose = world.tour.start;
    for (std::size_t i = 0; i < path.twists().size(); ++i) {
        const Twist& twist = path.twists()[i];
        ASSERT_EQ(path.poses()[i], pose);
        ASSERT_GE(twist.v, 0.0);
        ASSERT_LE(twist.v, world.robot.max_speed + kRounding);
        ASSERT_EQ(twist.v_lateral, 0.0);
        ASSERT_LE(std::abs(twist.w), world.robot.max_turn_rate + kRounding);
        ASSERT_LE(std::abs(twist.v - before.v), world.robot.acceleration * period + kRounding);
        ASSERT_LE(std::abs(twist.w - before.w), world.robot.turn_acceleration * period + kRounding);
        pose = compose(pose, displacement(twist, period));
        before = twist;
    }
    EXPECT_EQ(before, Twist{}) << "the tour ends at rest";
}

/// Every way point is passed in order, within the tolerance.
void expect_way_points(const World& world, const DrivenPath& path) {
    std::size_t from = 0;
    for (int lap = 0; lap < world.tour.laps; ++lap) {
        for (const WayPoint& point : world.tour.way_points) {
            const auto reached =
                std::find_if(path.poses().begin() + static_cast<std::ptrdiff_t>(from),
                             path.poses().end(), [&](const Pose& pose) {
                                 return std::hypot(pose.x - point.at.x, pose.y - point.at.y) <=
                                        world.robot.tolerance_m;
                             });
            ASSERT_NE(reached, path.poses().end()) << point.at.x << " " << point.at.y;
            from = static_cast<std::size_t>(reached - path.poses().begin());
        }
    }
}

TEST(DrivenPath, DrivesTheListBackwardsWithItsLastPointLast) {
    World world = small_world();
    world.tour.laps = 2;
    set_world_value(world, "tour.reverse=true");
    const DrivenPath path = drive(world);
    World other = small_world();
    other.tour.laps = 2;
    std::swap(other.tour.way_points[0], other.tour.way_points[1]);  // of three
    EXPECT_EQ(path.poses(), drive(other).poses());
    expect_way_points(other, path);
}

TEST(DrivenPath, KeepsToTheRobotsBoundsAndPassesEveryWayPoint) {
    for (const std::string& name : test::shipped_names()) {
        SCOPED_TRACE(name);
        const World world = test::shipped(name);
        const DrivenPath path = drive(world);
        expect_kinematics(world, path);
        expect_way_points(world, path);
    }
}

TEST(DrivenPath, KeepsItsBoundsWithOtherRobots) {
    for (const auto& [speed, acceleration, turn, turn_acceleration, rate] :
         {std::array{0.2, 0.1, 0.2, 0.2, 10.0}, std::array{2.0, 1.0, 2.0, 3.0, 20.0},
          std::array{0.5, 5.0, 1.0, 10.0, 4.0}, std::array{0.5, 0.4, 0.5, 0.1, 50.0}}) {
        World world = small_world();
        world.robot.max_speed = speed;
        world.robot.acceleration = acceleration;
        world.robot.max_turn_rate = turn;
        world.robot.turn_acceleration = turn_acceleration;
        world.robot.control_rate_hz = rate;
        world.tour.look_around = true;
        SCOPED_TRACE(speed);
        const DrivenPath path = drive(world);
        expect_kinematics(world, path);
        expect_way_points(world, path);
    }
}

TEST(DrivenPath, RestsAndLooksAroundBeforeItLeaves) {
    World world = small_world();
    world.tour.rest_s = 3.0;
    world.tour.look_around = true;
    const DrivenPath path = drive(world);
    EXPECT_EQ(path.pose_at(3.0), world.tour.start);
    double turned = 0.0;
    std::size_t i = 30;
    for (; path.twists()[i].v == 0.0 && path.twists()[i].w >= 0.0 && turned < 2.0 * kPi - 0.05; ++i)
        turned += path.twists()[i].w / path.rate_hz();
    EXPECT_NEAR(turned, 2.0 * kPi, 0.1);
    EXPECT_EQ(path.poses()[i].x, 0.0);
}

TEST(DrivenPath, KnowsThePoseBetweenTwoControlSteps) {
    DrivenPath path({1.0, 2.0, 0.3}, 10.0);
    path.append({0.5, 0.0, 0.4});
    path.append({0.4, 0.0, -0.2});
    const Pose half = compose(Pose{1.0, 2.0, 0.3}, displacement({0.5, 0.0, 0.4}, 0.05));
    EXPECT_NEAR(path.pose_at(0.05).x, half.x, 1e-15);
    EXPECT_NEAR(path.pose_at(0.05).y, half.y, 1e-15);
    EXPECT_EQ(path.pose_at(9.0), path.poses().back());
    EXPECT_EQ(path.pose_at(-1.0), path.poses().front());
    EXPECT_EQ(path.twist_between_times(0.1, 0.2), (Twist{0.4, 0.0, -0.2}));
    EXPECT_NEAR(path.length_m(), 0.09, 1e-15);
    // Across a change of the velocities: the twist that makes exactly that motion.
    const Twist across = path.twist_between_times(0.05, 0.15);
    const Pose there = compose(path.pose_at(0.05), displacement(across, 0.1));
    EXPECT_NEAR(there.x, path.pose_at(0.15).x, 1e-12);
    EXPECT_NEAR(there.y, path.pose_at(0.15).y, 1e-12);
    EXPECT_NEAR(there.theta, path.pose_at(0.15).theta, 1e-12);
}

TEST(DrivenPath, RefusesAWayThatComesTooNearToAWallAndNamesTheWayPoint) {
    World world = small_world();
    world.tour.way_points = {{{0, 2}, 6}, {{7.9, 2}, 7}};
    const std::string message = message_of<FormatError>([&] { drive(world); });
    EXPECT_NE(message.find("small.toml:7: on the way to way point 2 at (7.9, 2)"),
              std::string::npos)
        << message;
    EXPECT_NE(message.find("wall 1, (8, -2) to (8, 4)"), std::string::npos) << message;
    EXPECT_NE(message.find("0.26 m"), std::string::npos) << message;
}

TEST(DrivenPath, RefusesAWayThroughAWall) {
    World world = small_world();
    world.robot.radius_m = 0.0;
    world.tour.way_points = {{{0, 2}, 6}, {{12, 2}, 7}};
    EXPECT_NE(message_of<FormatError>([&] { drive(world); }).find("within 0.000 m"),
              std::string::npos);
}

TEST(DrivenPath, RefusesAStartAtAWall) {
    World world = small_world();
    world.tour.start = {-1.9, 0, 0};
    EXPECT_NE(
        message_of<FormatError>([&] { drive(world); }).find("the start at (-1.9, 0) is 0.100"),
        std::string::npos);
}

TEST(DrivenPath, RefusesWayPointsThatAreOne) {
    World world = small_world();
    world.tour.way_points = {{{0, 2}, 6}, {{0.1, 2.1}, 7}, {{5, 0}, 8}};
    const std::string message = message_of<FormatError>([&] { drive(world); });
    EXPECT_NE(
        message.find("small.toml:7: way point 2 at (0.1, 2.1) is 0.141 m from the one before"),
        std::string::npos)
        << message;
    world.tour.way_points = {{{0.05, 0}, 6}};
    EXPECT_NE(message_of<FormatError>([&] { drive(world); }).find("from the start"),
              std::string::npos);
    world.tour.way_points = {{{0, 2}, 6}, {{3, 2}, 7}, {{0, 2}, 8}};
    world.tour.laps = 2;  // the second lap begins where the first one ends
    EXPECT_NE(message_of<FormatError>([&] { drive(world); }).find("way point 1 at (0, 2) of lap 2"),
              std::string::npos);
}

TEST(DrivenPath, MeasuresTheGapBetweenAWallAndAWay) {
    const WallSegment wall{{0, 0}, {4, 0}, 1, 0};
    EXPECT_DOUBLE_EQ(distance(wall, Point2{2, 3}), 3.0);
    EXPECT_DOUBLE_EQ(distance(wall, Point2{7, 4}), 5.0);
    EXPECT_DOUBLE_EQ(distance(wall, {1, 2}, {3, 1}), 1.0);
    EXPECT_DOUBLE_EQ(distance(wall, {5, -1}, {5, 1}), 1.0);
    EXPECT_DOUBLE_EQ(distance(wall, {2, -1}, {2, 1}), 0.0);
    EXPECT_DOUBLE_EQ(distance(wall, {2, 1}, {2, 1}), 1.0);
}

}  // namespace
}  // namespace hitos
