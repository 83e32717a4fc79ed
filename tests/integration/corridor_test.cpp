// SPDX-License-Identifier: GPL-3.0-or-later
// The corridor world is like the one of [P fig 3], and its named distances are those of its walls.
#include <algorithm>
#include <cmath>

#include "hitos/services/evaluation/distances.hpp"
#include "hitos/simulation/drive/simulated_tour.hpp"
#include "hitos/simulation/worlds/reference_map.hpp"
#include "unit/simulation/worlds.hpp"

namespace hitos {
namespace {

const std::filesystem::path kDistances =
    std::filesystem::path(HITOS_SOURCE_DIR) / "data/worlds/corridor.distances";

/// [P table 1], d1 to d9.
const std::vector<double> kTrue = {1.0, 2.0, 1.0, 2.0, 2.0, 3.0, 3.0, 3.0, 3.0};

/// As it is, and with things in it.
class Corridor : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Worlds, Corridor, testing::Values("corridor", "corridor-cluttered"));

TEST_P(Corridor, HasAStraightTourOf160Scans27DegreesOffItsAxis) {
    const SimulatedTour tour(test::shipped(GetParam()));
    EXPECT_EQ(tour.scans(), 160U);
    EXPECT_NEAR(tour.world().tour.start.theta, 2.7 * kPi / 180.0, 1e-12);
    double widest = 0.0;
    double most_turned = 0.0;
    for (std::uint64_t k = 0; k < tour.scans(); ++k) {
        widest = std::max(widest, std::abs(tour.true_pose(k).y));
        most_turned = std::max(most_turned, std::abs(tour.true_pose(k).theta));
    }
    EXPECT_LT(widest, 1e-3);
    EXPECT_LT(most_turned, 1e-4);
    EXPECT_GT(tour.path().length_m(), 15.0);
}

TEST_P(Corridor, HasTheDistancesOfThePaperBetweenItsOwnWalls) {
    const LandmarkMap reference = reference_map(test::shipped(GetParam()));
    const auto measured = measure_distances(reference, read_distances(kDistances));
    ASSERT_EQ(measured.size(), kTrue.size());
    for (std::size_t i = 0; i < measured.size(); ++i) {
        EXPECT_EQ(measured[i].distance.name, "d" + std::to_string(i + 1));
        EXPECT_NEAR(measured[i].distance.true_m(), kTrue[i], 1e-8);
        ASSERT_TRUE(measured[i].slam_m) << measured[i].missing;
        EXPECT_NEAR(*measured[i].slam_m, kTrue[i], 1e-8);
    }
}

/// How far a point is from the nearest wall.
double from_walls(const std::vector<WallSegment>& walls, const Point2& point) {
    double least = 1e9;
    for (const WallSegment& wall : walls) least = std::min(least, distance(wall, point));
    return least;
}

TEST_P(Corridor, HasItsDistancesEndOnWallsThatTheTourSees) {
    World world = test::shipped(GetParam());
    world.laser.sigma_m = 0.01;  // what can be seen, not how well
    const SimulatedTour tour(world);
    const Pose& start = tour.world().tour.start;
    for (const NamedDistance& named : read_distances(kDistances)) {
        for (const Point2& end : {named.a, named.b}) {
            const Point2 point = transform(start, end);
            EXPECT_LT(from_walls(tour.world().walls, point), 1e-6) << named.name;
        }
    }
    // Every line of a distance has points in scans, more of them than noise or a single ray could.
    const LandmarkMap reference = reference_map(tour.world());
    std::vector<int> scans(reference.size(), 0);
    for (std::uint64_t k = 0; k < tour.scans(); ++k) {
        const Scan scan = tour.scan(k);
        const Pose pose = tour.true_pose(k);
        for (std::size_t m = 0; m < reference.size(); ++m) {
            const auto* line = std::get_if<Recta>(&reference[m].value);
            if (line == nullptr) continue;
            const auto on = std::ranges::count_if(scan.points, [&](const Point2& point) {
                return std::abs(signed_distance(*line, transform(pose, point))) < 0.03;
            });
            if (on >= 12) ++scans[m];
        }
    }
    for (const MeasuredDistance& measured :
         measure_distances(reference, read_distances(kDistances))) {
        EXPECT_GE(scans[static_cast<std::size_t>(measured.line_a)], 15) << measured.distance.name;
        EXPECT_GE(scans[static_cast<std::size_t>(measured.line_b)], 15) << measured.distance.name;
    }
}

}  // namespace
}  // namespace hitos
