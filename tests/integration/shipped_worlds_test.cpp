// SPDX-License-Identifier: GPL-3.0-or-later
// The worlds in data/worlds do what SPEC 9 asks of them.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "hitos/simulation/drive/simulated_tour.hpp"
#include "hitos/simulation/worlds/reference_map.hpp"
#include "unit/simulation/worlds.hpp"

namespace hitos {
namespace {

class ShippedWorld : public ::testing::TestWithParam<std::string> {};

TEST_P(ShippedWorld, HasATourOfOver200MFromTheOriginThatTurnsNorthFirst) {
    const SimulatedTour tour(test::shipped(GetParam()));
    EXPECT_EQ(tour.world().tour.start, Pose{});
    EXPECT_GT(tour.path().length_m(), 200.0);
    EXPECT_LE(tour.world().robot.max_speed, 0.5);
    // Where it is 2 m away from the start it has gone north, not east.
    const auto& poses = tour.path().poses();
    const auto away = std::ranges::find_if(
        poses, [](const Pose& pose) { return std::hypot(pose.x, pose.y) > 2.0; });
    ASSERT_NE(away, poses.end());
    EXPECT_GT(away->y, 1.8);
}

/// A loop is gone round when the bearing of the robot from a point inside it grows by whole turns.
double turned_round(const SimulatedTour& tour, const Point2& inside) {
    double turned = 0.0;
    double least = 0.0;
    double most = 0.0;
    const Pose& start = tour.path().poses().front();
    double before = std::atan2(start.y - inside.y, start.x - inside.x);
    for (const Pose& pose : tour.path().poses()) {
        const double bearing = std::atan2(pose.y - inside.y, pose.x - inside.x);
        turned += wrap_angle(bearing - before);
        before = bearing;
        least = std::min(least, turned);
        most = std::max(most, turned);
    }
    return most - least;
}

constexpr double kTwice = 2.0 * 2.0 * kPi - 0.3;

TEST_P(ShippedWorld, GoesRoundEveryLoopAtLeastTwice) {
    const std::map<std::string, std::vector<Point2>> insides = {{"recinto", {{9, 4}}},
                                                                {"lineamedia", {{9, 4}}},
                                                                {"bigloop", {{9, 4}}},
                                                                {"bigloop2", {{5, 4}, {13, 4}}},
                                                                {"complex", {{20, 4}, {29, 12}}},
                                                                {"iusiani", {{3, 2.5}, {2.6, 7.8}}},
                                                                {"usc-sal", {{14, 2.5}}}};
    const SimulatedTour tour(test::shipped(GetParam()));
    for (const Point2& inside : insides.at(GetParam())) {
        EXPECT_GT(turned_round(tour, inside), kTwice) << inside.x << " " << inside.y;
    }
}

TEST(OutdoorWorlds, GoTwiceRoundEachLoopAndMissAQuarterOfTheReadings) {
    const std::map<std::string, std::vector<Point2>> insides = {{"park", {{10, 10}, {30, 10}}},
                                                                {"campus", {{35, 40}, {105, 40}}}};
    for (const auto& [name, places] : insides) {
        const SimulatedTour tour(test::shipped(name));
        for (const Point2& inside : places)
            EXPECT_GT(turned_round(tour, inside), kTwice) << name << " " << inside.x;
        double seen = 0.0;
        double rays = 0.0;
        for (std::uint64_t k = 0; k < tour.scans(); k += 20) {
            const Scan scan = tour.scan(k);
            seen += static_cast<double>(scan.points.size());
            rays += scan.fan.count;
        }
        EXPECT_NEAR(1.0 - seen / rays, 0.25, 0.02) << name;
    }
}

/// Points of each wall line in one scan, and how near the nearest of them is to a corner.
struct Seen {
    int points = 0;
    double nearest_m = 1e9;
};

/// A landmark is seen in a scan where its wall, or both walls of the corner, have kPoints readings,
/// and for a corner one of each wall within the reach at which a corner is made of two lines.
TEST_P(ShippedWorld, SeesEveryLandmarkOfItsReferenceSeveralTimes) {
    constexpr int kPoints = 12;
    constexpr int kSeveral = 5;
    constexpr double kReach = 0.1;
    const SimulatedTour tour(test::shipped(GetParam()));
    const World& world = tour.world();
    const LandmarkMap reference = reference_map(world);
    const SimulatedLaser laser(world.walls, fan_of(world.laser));
    std::vector<int> scans(reference.size(), 0);
    std::vector<RayHit> hits;
    std::vector<Point2> at(laser.fan().count);
    for (std::uint64_t k = 0; k < tour.scans(); ++k) {
        const Pose pose = tour.path().pose_at(tour.scan_time(k));
        laser.cast(pose, hits);
        std::vector<int> on_segment(world.walls.size(), 0);
        for (std::size_t i = 0; i < hits.size(); ++i) {
            if (hits[i].segment < 0) continue;
            ++on_segment[static_cast<std::size_t>(hits[i].segment)];
            const double angle = -kPi / 2 + static_cast<double>(i) * kPi / 180.0;
            at[i] = transform(
                pose, Point2{hits[i].range_m * std::cos(angle), hits[i].range_m * std::sin(angle)});
        }
        for (std::size_t m = 0; m < reference.size(); ++m) {
            std::set<int> seen;  // directions of the walls that count, in whole degrees
            const Point2 point = reference[m].point();
            for (std::size_t s = 0; s < world.walls.size(); ++s) {
                const WallSegment& wall = world.walls[s];
                if (on_segment[s] < kPoints) continue;
                if (const auto* line = std::get_if<Recta>(&reference[m].value)) {
                    const bool on = std::abs(signed_distance(*line, wall.a)) < 1e-6 &&
                                    std::abs(signed_distance(*line, wall.b)) < 1e-6;
                    if (on) seen.insert(0);
                    continue;
                }
                if (distance(wall, point) > 1e-6) continue;
                for (std::size_t i = 0; i < hits.size(); ++i) {
                    if (hits[i].segment != static_cast<int>(s)) continue;
                    // A ray on it or its neighbour's gap reaches the corner.
                    const double gap = std::hypot(at[i].x - point.x, at[i].y - point.y);
                    if (gap > kReach) continue;
                    const double direction = line_through(wall.a, wall.b).theta;
                    seen.insert(static_cast<int>(std::lround(direction * 180.0 / kPi) + 360) % 180);
                    break;
                }
            }
            const std::size_t wanted = reference[m].kind() == FeatureKind::corner ? 2 : 1;
            if (seen.size() >= wanted) ++scans[m];
        }
    }
    int fewest = 1 << 30;
    for (std::size_t m = 0; m < reference.size(); ++m) {
        fewest = std::min(fewest, scans[m]);
        EXPECT_GE(scans[m], kSeveral) << to_string(reference[m].kind()) << " with its point at "
                                      << reference[m].point().x << " " << reference[m].point().y;
    }
    RecordProperty("fewest_scans_of_a_landmark", fewest);
    std::cout << GetParam() << ": " << reference.size() << " landmarks, the rarest in " << fewest
              << " of " << tour.scans() << " scans, " << tour.path().length_m() << " m\n";
}

INSTANTIATE_TEST_SUITE_P(All, ShippedWorld, ::testing::ValuesIn(test::shipped_names()),
                         [](const auto& world) {
                             std::string name = world.param;
                             std::erase(name, '-');
                             return name;
                         });

}  // namespace
}  // namespace hitos
