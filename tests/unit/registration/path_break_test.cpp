// SPDX-License-Identifier: GPL-3.0-or-later
#include "path_break.hpp"

#include <gtest/gtest.h>

#include "drawn_scan.hpp"

namespace hitos {
namespace {

using test::closed;
using test::drawn_points;

const Walls kBrokenRoom = closed({{-4, -3}, {4, -3}, {4, 3}, {-4, 3}});

KeyGraph graph_of(const Walls& walls, const std::vector<Pose>& poses) {
    KeyGraph graph;
    for (const Pose& pose : poses) {
        KeyScan key;
        key.hold(drawn_points(walls, pose));
        graph.add({pose, graph.size()}, std::move(key));
    }
    return graph;
}

MatchedStep matched(const Pose& pose, double score) {
    MatchedStep step;
    step.pose = pose;
    step.score = score;
    step.matched = true;
    return step;
}

class PathBreak : public testing::Test {
  protected:
    const KeyGraph graph_ = graph_of(kBrokenRoom, {{-1, 0, 0}, {-0.5, 0, 0}, {0, 0, 0}});
    const Pose now_{0.3, 0.1, 0.1};
};

TEST_F(PathBreak, AScanThatFittedNothing) {
    EXPECT_TRUE(breaks_path(drawn_points(kBrokenRoom, now_), {}, graph_));
}

TEST_F(PathBreak, AScanThatFitsWellIsNeverOne) {
    const Walls longer = closed({{-4, -3}, {9, -3}, {9, 3}, {-4, 3}});
    EXPECT_FALSE(breaks_path(drawn_points(longer, now_), matched(now_, 0.6), graph_));
}

TEST_F(PathBreak, AScanThatFitsBadlyAndAgreesIsNone) {
    EXPECT_FALSE(breaks_path(drawn_points(kBrokenRoom, now_), matched(now_, 0.3), graph_));
}

TEST_F(PathBreak, LookingThroughTheWallSeenBefore) {
    const Walls longer = closed({{-4, -3}, {9, -3}, {9, 3}, {-4, 3}});
    EXPECT_TRUE(breaks_path(drawn_points(longer, now_), matched(now_, 0.3), graph_));
}

TEST_F(PathBreak, SeeingAWallThatWasLookedThrough) {
    const Walls shorter = closed({{-4, -3}, {2, -3}, {2, 3}, {-4, 3}});
    EXPECT_TRUE(breaks_path(drawn_points(shorter, now_), matched(now_, 0.3), graph_));
}

}  // namespace
}  // namespace hitos
