// SPDX-License-Identifier: GPL-3.0-or-later
#include "free_view.hpp"

#include <gtest/gtest.h>

#include "drawn_scan.hpp"

namespace hitos {
namespace {

using test::closed;
using test::drawn_points;

const Walls kRoom = closed({{-4, -3}, {4, -3}, {4, 3}, {-4, 3}});

TEST(FreeView, SaysWhatIsThereWhatItLooksThroughAndWhatItCannotTell) {
    const Pose pose{-1.0, 0.5, 0.4};
    const FreeView view(drawn_points(kRoom, pose), pose);
    EXPECT_EQ(view.of({4.0, 1.0}), FreeView::Said::there);
    EXPECT_EQ(view.of({2.0, 1.0}), FreeView::Said::through);
    EXPECT_EQ(view.of({9.0, 1.0}), FreeView::Said::nothing) << "behind the wall";
    EXPECT_EQ(view.of({-3.5, 0.5}), FreeView::Said::nothing) << "behind the robot";
}

TEST(FreeView, TheSameWallsContradictNothingAndAWallAcrossMuch) {
    const Pose then{-1.0, 0.0, 0.0};
    const Pose now{-0.6, 0.2, 0.1};
    const std::vector<FreeView> views{FreeView(drawn_points(kRoom, then), then)};
    std::vector<Point2> points;
    place(drawn_points(kRoom, now), now, points);
    EXPECT_LT(contradiction(points, views), 0.02);

    const Walls shorter = closed({{-4, -3}, {2, -3}, {2, 3}, {-4, 3}});
    points.clear();
    place(drawn_points(shorter, now), now, points);
    EXPECT_GT(contradiction(points, views), 0.3);
}

TEST(FreeView, TooFewPointsContradictNothing) {
    const Pose pose{};
    const std::vector<FreeView> views{FreeView(drawn_points(kRoom, pose), pose)};
    const std::vector<Point2> points{{1.0, 0.0}, {1.5, 0.5}};
    EXPECT_EQ(contradiction(points, views), 0.0);
    EXPECT_EQ(contradiction({}, {}), 0.0);
}

}  // namespace
}  // namespace hitos
