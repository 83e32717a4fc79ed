// SPDX-License-Identifier: GPL-3.0-or-later
// A second tour in the map of the first.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "ring_tour.hpp"

namespace hitos {
namespace {

using test::greatest_path_error;
using test::kRing;
using test::ring_of_two_halves;
using test::ring_walls;
using test::round_tour;

/// A lap, then another tour that begins where `put_down` says, of that lap's poses.
struct TwoTours {
    std::vector<Pose> truth;
    std::size_t begin = 0;
    std::vector<Pose> first_path;  // at the end of the first tour
    Registration registration;
};

TwoTours two_tours(const Walls& first, const Walls& second, std::size_t put_down,
                   const TourBegin& begin, const RegistrationParams& params = {}) {
    const std::vector<Point2>& way = kRing;
    TwoTours tours{round_tour(way, 1), 0, {}, Registration{params}};
    tours.begin = tours.truth.size();
    const std::vector<Pose> again = round_tour(way, 2);
    tours.truth.insert(tours.truth.end(), again.begin() + static_cast<std::ptrdiff_t>(put_down),
                       again.end());
    std::mt19937 engine(9);
    for (std::size_t i = 0; i < tours.truth.size(); ++i) {
        std::vector<Control> controls;
        const bool begins = i == tours.begin;
        if (begins) {
            tours.registration.finish(true);
            tours.first_path = tours.registration.path();
        } else if (i > 0) {
            controls.push_back(test::control_between(tours.truth[i - 1], tours.truth[i]));
        }
        Scan scan =
            test::drawn_scan(i < tours.begin ? first : second, tours.truth[i], 0.005, &engine);
        if (begins) scan.begins_tour = begin;
        tours.registration.add(scan, controls);
    }
    tours.registration.finish();
    return tours;
}

SecondTour second_of(const TwoTours& tours) {
    return tours.registration.figures().later_tours.at(0);
}

TEST(SecondTour, IsFoundAndGoesOnWithTheMap) {
    const TwoTours tours = two_tours(ring_walls(), ring_walls(), 20, {});
    const SecondTour second = second_of(tours);
    EXPECT_EQ(second.begin, tours.begin);
    ASSERT_TRUE(second.found);
    EXPECT_LT(second.way_m, 40.0) << "a lap is 48 m, and three corners of four are much alike";
    EXPECT_LT(greatest_path_error(tours.registration.path(), tours.truth), 0.1);
    EXPECT_TRUE(tours.registration.figures().breaks.empty()) << "nobody carried the robot";
    // To have laid it where it belongs corrects nothing.
    EXPECT_LT(tours.registration.figures().largest_correction_m, 1.0);
    for (const PoseEdge& edge : tours.registration.edges()) {
        if (edge.kind != EdgeKind::odometry) continue;
        const std::span<const KeyPose> keys = tours.registration.keys();
        EXPECT_FALSE(keys[edge.from].scan < tours.begin && tours.begin <= keys[edge.to].scan);
    }
    EXPECT_TRUE(tours.registration.changes().empty());
}

TEST(SecondTour, LeavesAMapThatIsHeldToTheLastBit) {
    const TwoTours tours = two_tours(ring_walls(), ring_walls(), 35, {true, {}});
    ASSERT_TRUE(second_of(tours).found);
    const std::vector<Pose> path = tours.registration.path();
    for (std::size_t i = 0; i < tours.begin; ++i) EXPECT_EQ(path[i], tours.first_path[i]) << i;
    EXPECT_LT(greatest_path_error(path, tours.truth), 0.1);
}

TEST(SecondTour, LiesBesideTheMapWhereItIsOfAnotherPlace) {
    const Walls hall = test::closed({{-3, -3}, {17, -3}, {17, 13}, {9, 13}, {9, 8}, {-3, 8}});
    const TwoTours tours = two_tours(ring_walls(), hall, 20, {});
    EXPECT_FALSE(second_of(tours).found);
    const std::vector<Pose> path = tours.registration.path();
    double furthest = 0.0;
    for (std::size_t i = 0; i < tours.begin; ++i) furthest = std::max(furthest, path[i].x);
    for (std::size_t i = tours.begin; i < path.size(); ++i)
        EXPECT_GT(path[i].x, furthest + 50.0) << i;
    EXPECT_TRUE(tours.registration.changes().empty());
}

TEST(SecondTour, IsFoundInOneOfTwoPlacesThatAreAlikeWhereSomebodySaysInWhich) {
    const Walls walls = ring_of_two_halves();
    EXPECT_FALSE(second_of(two_tours(walls, walls, 20, {})).found);
    const Pose begin = round_tour(kRing, 1)[20];
    const Pose about{begin.x + 1.5, begin.y - 1.0, begin.theta + 0.26};
    const TwoTours here = two_tours(walls, walls, 20, {false, about});
    ASSERT_TRUE(second_of(here).found);
    EXPECT_LT(greatest_path_error(here.registration.path(), here.truth), 0.15);
    const Pose opposite{14.0 - begin.x, 10.0 - begin.y, wrap_angle(begin.theta + kPi)};
    const TwoTours there = two_tours(walls, walls, 20, {false, opposite});
    ASSERT_TRUE(second_of(there).found);
    EXPECT_GT(greatest_path_error(there.registration.path(), there.truth), 10.0);
}

TEST(SecondTour, IsLaidWhereSomebodySaysThatAScanIs) {
    const Walls walls = ring_of_two_halves();
    RegistrationParams params;
    const std::size_t begin = round_tour(kRing, 1).size();
    const Pose fixed = round_tour(kRing, 2)[20 + 9];
    params.edits =
        fmt::format("fix {} {} {} {}", begin + 10, fixed.x, fixed.y, wrap_angle(fixed.theta));
    const TwoTours tours = two_tours(walls, walls, 20, {}, params);
    EXPECT_EQ(second_of(tours).found, begin + 9);
    EXPECT_LT(greatest_path_error(tours.registration.path(), tours.truth), 0.15);
}

TEST(SecondTour, IsFoundBehindABreakWhereItBeginsElsewhere) {
    const Walls hall = test::closed({{-3, -3}, {17, -3}, {17, 13}, {9, 13}, {9, 8}, {-3, 8}});
    std::vector<Pose> truth = round_tour(kRing, 1);
    const std::size_t begin = truth.size();
    const std::vector<Pose> ring = round_tour(kRing, 2);
    constexpr std::size_t kInHall = 25;
    truth.insert(truth.end(), ring.begin(), ring.begin() + kInHall);
    truth.insert(truth.end(), ring.begin() + 60, ring.end());
    Registration registration{RegistrationParams{}};
    std::mt19937 engine(9);
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const bool in_hall = i >= begin && i < begin + kInHall;
        std::vector<Control> controls;
        if (i > 0 && i != begin) {
            const bool carried = i == begin + kInHall;
            controls.push_back(carried ? Control{twist_between({0.05, 0.0, 0.0}, 1.0), 1.0}
                                       : test::control_between(truth[i - 1], truth[i]));
        }
        Scan scan = test::drawn_scan(in_hall ? hall : ring_walls(), truth[i], 0.005, &engine);
        if (i == begin) scan.begins_tour.emplace();
        registration.add(scan, controls);
    }
    const SecondTour second = registration.figures().later_tours.at(0);
    ASSERT_TRUE(second.found);
    EXPECT_EQ(second.laid_from, begin + kInHall);
    EXPECT_LT(registration.figures().largest_correction_m, 1.0);
    const std::vector<Pose> path = registration.path();
    for (std::size_t i = 0; i < path.size(); ++i) {
        const Pose at = compose(truth.front(), path[i]);
        const double off = std::hypot(at.x - truth[i].x, at.y - truth[i].y);
        if (i >= begin && i < begin + kInHall) {
            EXPECT_GT(off, 50.0) << i;
        } else {
            EXPECT_LT(off, 0.2) << i;
        }
    }
}

/// Where the last metres fit, all that was seen since the tour began has to.
TEST(SecondTour, IsNotFoundWhereItsBeginningLooksThroughWallsOfTheMap) {
    Walls wide = ring_walls();  // with a hall in the place of the first corridor
    std::erase_if(wide,
                  [](const auto& wall) { return std::max(wall.first.y, wall.second.y) <= 1.0; });
    const Walls hall = test::closed({{-1, -1}, {-1, -9}, {15, -9}, {15, -1}});
    wide.insert(wide.end(), hall.begin(), hall.end() - 1);
    EXPECT_TRUE(second_of(two_tours(ring_walls(), ring_walls(), 0, {})).found);
    EXPECT_FALSE(second_of(two_tours(ring_walls(), wide, 0, {})).found);
}

TEST(SecondTour, TellsWhatIsGoneAndWhatIsNew) {
    Walls later = ring_walls();
    const Walls box = test::closed({{8.0, -1.0}, {8.0, -0.5}, {9.5, -0.5}, {9.5, -1.0}});
    later.insert(later.end(), box.begin(), box.end());
    for (const bool box_is_new : {true, false}) {
        const TwoTours tours = box_is_new ? two_tours(ring_walls(), later, 20, {})
                                          : two_tours(later, ring_walls(), 20, {});
        ASSERT_TRUE(second_of(tours).found);
        const std::vector<ChangedPlace> changes = tours.registration.changes();
        ASSERT_EQ(changes.size(), 1U);
        EXPECT_EQ(changes[0].gone, !box_is_new);
        const Bounds bounds = changes[0].bounds();
        EXPECT_NEAR(bounds.low.x, 8.0, 0.3);
        EXPECT_NEAR(bounds.high.x, 9.5, 0.3);
        EXPECT_NEAR(bounds.high.y, -0.5, 0.2);
    }
}

}  // namespace
}  // namespace hitos
