// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/evaluation/tour_frames.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace hitos {
namespace {

/// A way of three tours of ten scans each, one a second, along an arc.
Trajectory arc() {
    Trajectory path;
    for (int i = 0; i < 30; ++i) {
        const double angle = 0.1 * i;
        path.push_back({1.0 * i, {5.0 * std::cos(angle), 5.0 * std::sin(angle), angle}});
    }
    return path;
}

std::vector<SecondTour> tours(std::optional<std::uint64_t> second,
                              std::optional<std::uint64_t> third) {
    return {{.begin = 10, .found = second, .laid_from = 10, .beside = 3},
            {.begin = 20, .found = third, .laid_from = 20, .beside = 4}};
}

/// The scans from one to before another, elsewhere.
Trajectory moved(Trajectory path, std::size_t from, std::size_t to, const Pose& by) {
    for (std::size_t i = from; i < to; ++i) path[i].pose = compose(by, path[i].pose);
    return path;
}

TEST(TourFrames, ATourThatWasNotFoundIsInNoFrameWithTheOthers) {
    const auto found = tours(15, std::nullopt);
    EXPECT_FALSE(lies_beside(found, 9));
    EXPECT_FALSE(lies_beside(found, 10));
    EXPECT_FALSE(lies_beside(found, 19));
    EXPECT_TRUE(lies_beside(found, 20));
    EXPECT_TRUE(lies_beside(found, 29));
    const Trajectory path = moved(arc(), 20, 30, {100.0, 0.0, 1.0});
    EXPECT_EQ(in_one_frame(path, found).size(), 20U);
    EXPECT_GT(trajectory_error(path, arc())->rmse_m, 10.0);
    EXPECT_NEAR(trajectory_error(in_one_frame(path, found), arc())->rmse_m, 0.0, 1e-9);
    EXPECT_EQ(in_one_frame(path, {}), path);
    // One in the middle, with a tour behind it that was found in the first, or in that one.
    std::vector<SecondTour> middle = tours(std::nullopt, 25);
    EXPECT_EQ(in_one_frame(path, middle).at(10).time_s, 20.0);
    middle[1].beside = 12;
    EXPECT_EQ(in_one_frame(path, middle).size(), 10U);
    EXPECT_EQ(known_while_driving(path, middle).size(), 10U);
    // Behind a break in a tour that was found, what comes before lies beside it.
    std::vector<SecondTour> broken = tours(15, 25);
    broken[1].laid_from = 23;
    EXPECT_TRUE(lies_beside(broken, 22));
    EXPECT_FALSE(lies_beside(broken, 23));
    EXPECT_EQ(in_one_frame(path, broken).size(), 27U);
}

TEST(TourFrames, WhileDrivingATourIsKnownFromWhereItWasFoundOn) {
    const Trajectory known = known_while_driving(arc(), tours(15, std::nullopt));
    ASSERT_EQ(known.size(), 15U);
    EXPECT_EQ(known[9].time_s, 9.0);
    EXPECT_EQ(known[10].time_s, 15.0);
    EXPECT_EQ(known.back().time_s, 19.0);
}

TEST(TourFrames, OdometryIsLaidOnTheReferenceTourByTour) {
    // Every tour's odometry begins anew, and the third is 0.3 m off in the middle.
    Trajectory odometry = moved(moved(arc(), 10, 20, {3.0, 1.0, 2.0}), 20, 30, {-7.0, 0.5, -1.0});
    const auto each = tour_by_tour_error(odometry, tours(15, std::nullopt), arc());
    ASSERT_TRUE(each);
    EXPECT_NEAR(each->rmse_m, 0.0, 1e-9);
    EXPECT_NEAR(*each->heading_rmse_rad, 0.0, 1e-9);
    EXPECT_EQ(each->poses, 30);
    EXPECT_EQ(tour_by_tour_error(odometry, {}, arc())->rmse_m,
              trajectory_error(odometry, arc())->rmse_m);
    odometry[25].pose.x += 0.3;
    const auto off = tour_by_tour_error(odometry, tours(15, std::nullopt), arc());
    const Trajectory third(odometry.begin() + 20, odometry.end());
    const auto alone = trajectory_error(third, arc());
    EXPECT_NEAR(off->rmse_m, alone->rmse_m * std::sqrt(10.0 / 30.0), 1e-12);
    EXPECT_NEAR(off->mean_m, alone->mean_m / 3.0, 1e-9);
    EXPECT_EQ(off->maximum_m, alone->maximum_m);
    // Of the tours that the reference is of.
    const Trajectory all = arc();
    const Trajectory of_second(all.begin() + 10, all.begin() + 20);
    EXPECT_FALSE(tour_by_tour_error(odometry, {}, {}));
    EXPECT_EQ(tour_by_tour_error(odometry, tours(15, std::nullopt), of_second)->poses, 10);
}

}  // namespace
}  // namespace hitos
