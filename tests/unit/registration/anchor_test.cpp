// SPDX-License-Identifier: GPL-3.0-or-later
// Anchors of a tour to a drawing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/registration/laid_drawing.hpp"
#include "hitos/registration/seen_wall.hpp"
#include "ring_tour.hpp"

namespace hitos {
namespace {

using Kind = GraphEdit::Kind;
using testing::HasSubstr;

/// Along a corridor that is longer than the laser sees, and round its corner into another one: how
/// long they are the odometry alone says.
class BentCorridor : public testing::Test {
  protected:
    static constexpr double kScale = 1.05;

    test::Driven driven(const std::vector<GraphEdit>& edits, double key_m = 0.3) const {
        RegistrationParams params;
        params.edits = text_of(edits);
        params.range_m = 8.0;
        params.loops = false;
        params.key_distance_m = key_m;
        return test::drive(walls_, truth_, 0.0, kScale, params);
    }
    test::Driven finished(const std::vector<GraphEdit>& edits) const {
        test::Driven driven = this->driven(edits);
        driven.registration.finish();
        return driven;
    }
    double error_of(const test::Driven& driven) const {
        return test::greatest_path_error(driven.registration.path(), truth_);
    }
    std::string said_of(const std::vector<GraphEdit>& edits) const {
        try {
            driven(edits);
        } catch (const ConfigError& error) {
            EXPECT_EQ(error.key(), kGraphEditsKey);
            return error.what();
        }
        return {};
    }

    /// That the scan sees the wall from `left` to `right` of the corridors, in the direction of its
    /// point nearest to `near`; the drawing has another frame than they.
    GraphEdit wall(std::size_t scan, const Point2& near, const Point2& left,
                   const Point2& right) const {
        const Point2 seen = transform(inverse(truth_[scan]), near);
        return {.kind = Kind::wall,
                .scan = {scan},
                .bearing = std::atan2(seen.y, seen.x),
                .left = transform(drawn_, left),
                .right = transform(drawn_, right)};
    }
    GraphEdit point(std::size_t scan, const Point2& at) const {
        return {.kind = Kind::point,
                .scan = {scan},
                .seen = transform(inverse(truth_[scan]), at),
                .left = transform(drawn_, at)};
    }
    GraphEdit left_wall(std::size_t scan) const {
        return wall(scan, {truth_[scan].x + 1.0, 1.0}, {0, 1}, {30, 1});
    }
    /// The first corridor's end, from where it is near.
    GraphEdit end_wall(std::size_t scan) const {
        return wall(scan, {41.0, truth_[scan].y}, {41, 20}, {41, -1});
    }
    GraphEdit right_wall(std::size_t scan) const {
        return wall(scan, {truth_[scan].x + 1.0, -1.0}, {41, -1}, {-1, -1});
    }
    GraphEdit last_right_wall(std::size_t scan) const {
        return wall(scan, {41.0, truth_[scan].y + 1.0}, {41, 31}, {41, -1});
    }
    /// The second corridor's end.
    GraphEdit last_wall(std::size_t scan) const {
        return wall(scan, {truth_[scan].x, 31.0}, {39, 31}, {41, 31});
    }
    /// The niche at the beginning of the first corridor, the side that is looked at.
    GraphEdit niche_wall() const { return wall(0, {3.0, 1.5}, {3, 2}, {3, 1}); }
    std::vector<GraphEdit> all_round() const {
        const std::size_t corner = scan_at({38, 0});
        const std::size_t end = truth_.size() - 3;
        return {left_wall(0),       niche_wall(),   end_wall(corner),
                right_wall(corner), last_wall(end), last_right_wall(end)};
    }
    std::vector<GraphEdit> at_begin() const { return {left_wall(0), niche_wall()}; }
    std::size_t scan_at(const Point2& place) const {
        const auto nearest = std::ranges::min_element(truth_, {}, [&](const Pose& pose) {
            return std::hypot(pose.x - place.x, pose.y - place.y);
        });
        return static_cast<std::size_t>(nearest - truth_.begin());
    }

    const Walls walls_ = test::closed({{-1, -1},
                                       {41, -1},
                                       {41, 31},
                                       {39, 31},
                                       {39, 1},
                                       {3, 1},
                                       {3, 2},
                                       {1.5, 2},
                                       {1.5, 1},
                                       {-1, 1}});
    std::vector<Pose> truth_ = [] {
        std::vector<Pose> poses = test::round_tour({{0, 0}, {40, 0}, {40, 30}}, 1);
        const auto back =
            std::ranges::find_if(poses, [](const Pose& pose) { return pose.y > 29.5; });
        poses.erase(back, poses.end());
        return poses;
    }();
    Pose drawn_{691000.0, 5334000.0, 2.0};  // of the corridors' frame in the drawing's
};

TEST_F(BentCorridor, WallsOfADrawingStraightenIt) {
    const test::Driven bent = finished({});
    ASSERT_GT(error_of(bent), 2.0) << "the corridors are as long as the odometry says";
    const test::Driven straight = finished(all_round());
    EXPECT_LT(error_of(straight), 0.25);
    const RegistrationFigures figures = straight.registration.figures();
    ASSERT_EQ(figures.anchors.size(), 6U);
    for (const AnchorFigures& anchor : figures.anchors) {
        EXPECT_LT(anchor.off_m, 0.05) << anchor.change;
        EXPECT_LT(std::abs(anchor.off_rad.value()), 0.02) << anchor.change;
    }
    EXPECT_TRUE(figures.edits_unmet.empty());
    // The drawing lies where the corridors' frame, which is that of the first scan, has it.
    ASSERT_TRUE(figures.drawing && figures.drawing->firm);
    const Pose truth = inverse(drawn_);
    const Pose& laid = figures.drawing->pose;
    EXPECT_NEAR(laid.theta, truth.theta, 0.01);
    const Point2 corner = transform(laid, transform(drawn_, Point2{39, 1}));
    EXPECT_NEAR(corner.x, 39.0, 0.1);
    EXPECT_NEAR(corner.y, 1.0, 0.3);
}

TEST_F(BentCorridor, WhereTheDrawingHasItsOriginSaysNothing) {
    drawn_ = {1.0, -2.0, 2.0};
    const test::Driven near = finished(all_round());
    const std::vector<Pose> path = near.registration.path();
    const Pose laid_near = near.registration.drawing()->pose;
    for (const Point2& shift : {Point2{5e5, 4.6e6}, Point2{-4.6e6, 1e7}}) {
        drawn_ = {1.0 + shift.x, -2.0 + shift.y, 2.0};
        const test::Driven far = finished(all_round());
        EXPECT_LT(test::greatest_path_error(far.registration.path(), path), 1e-6) << shift.y;
        const Pose laid = far.registration.drawing()->pose;
        EXPECT_NEAR(laid.theta, laid_near.theta, 1e-8);  // coordinates have 2 nm
        EXPECT_LT(distance(transform(laid, shift), {laid_near.x, laid_near.y}), 1e-6);
    }
}

TEST_F(BentCorridor, WhichPlacesDrawAWallSaysNothing) {
    std::vector<GraphEdit> edits = all_round();
    const std::vector<Pose> path = finished(edits).registration.path();
    for (const double longer : {1e3, 1e6}) {
        for (GraphEdit& edit : edits) {
            const Point2 way{edit.right.x - edit.left.x, edit.right.y - edit.left.y};
            const double length = std::hypot(way.x, way.y);
            edit.left.x -= longer * way.x / length;
            edit.left.y -= longer * way.y / length;
        }
        EXPECT_LT(test::greatest_path_error(finished(edits).registration.path(), path), 1e-4)
            << longer;
    }
}

TEST_F(BentCorridor, PointsStraightenItToo) {
    std::vector<GraphEdit> edits{point(0, {3, 1}), point(scan_at({38, 0}), {39, 1}),
                                 point(truth_.size() - 3, {41, 31})};
    EXPECT_LT(error_of(finished(edits)), 0.25);
    edits.resize(2);
    const test::Driven two = finished(edits);
    EXPECT_TRUE(two.registration.figures().drawing->firm);
    const std::vector<Pose> path = two.registration.path();
    EXPECT_NEAR(path[scan_at({38, 0})].x, truth_[scan_at({38, 0})].x, 0.1) << "their distance";
}

TEST_F(BentCorridor, OneSaysNothingYet) {
    const std::size_t scan = driven({}).registration.keys()[40].scan;
    const test::Driven plain = finished({});
    for (const std::vector<GraphEdit>& edits :
         {std::vector{left_wall(scan)}, std::vector{point(scan, {20, 1})}, at_begin()}) {
        const test::Driven anchored = finished(edits);
        const RegistrationFigures figures = anchored.registration.figures();
        EXPECT_EQ(figures.drawing->firm, edits.size() == 2);
        EXPECT_LT(figures.anchors.front().off_m, 0.03);
        EXPECT_TRUE(figures.edits_unmet.empty());
        const std::vector<Pose> path = anchored.registration.path();
        const std::vector<Pose> before = plain.registration.path();
        for (std::size_t i = 0; i < path.size(); ++i) {
            ASSERT_LT(std::hypot(path[i].x - before[i].x, path[i].y - before[i].y), 0.05) << i;
        }
    }
    EXPECT_FALSE(plain.registration.drawing().has_value());
}

TEST_F(BentCorridor, WhatContradictsIsTold) {
    std::vector<GraphEdit> edits = at_begin();
    const std::size_t scan = scan_at({38, 0});
    edits.push_back(end_wall(scan));
    edits.push_back(end_wall(scan + 1));
    for (Point2* end : {&edits.back().left, &edits.back().right}) {
        end->x += 3.0 * std::cos(drawn_.theta);
        end->y += 3.0 * std::sin(drawn_.theta);
    }
    std::vector<AnchorFigures> anchors = finished(edits).registration.figures().anchors;
    ASSERT_EQ(anchors.size(), 4U);
    EXPECT_GT(anchors[3].chi_square, anchors[3].chi_square_limit) << "the map tears";
    // Of one scan they cannot both be true.
    edits[3].scan = edits[2].scan;
    edits[3].bearing += 0.05;
    anchors = finished(edits).registration.figures().anchors;
    EXPECT_GT(anchors[2].off_m, 1.0);
    EXPECT_GT(anchors[3].off_m, 1.0);
}

TEST_F(BentCorridor, AWallThatIsNoneIsRefused) {
    GraphEdit nothing = left_wall(30);
    nothing.bearing = 3.0;  // behind, where the laser does not look
    EXPECT_THAT(
        said_of({niche_wall(), nothing}),
        HasSubstr("change 2: scan 31 sees no straight wall of half a metre in the direction "
                  "of 3 rad"));
    GraphEdit turned = left_wall(30);
    std::swap(turned.left, turned.right);
    EXPECT_THAT(said_of({left_wall(0), turned}),
                HasSubstr("change 2: the wall that scan 31 sees is "
                          "turned by"));
    GraphEdit another = left_wall(30);
    another.left = end_wall(30).left;
    another.right = end_wall(30).right;
    EXPECT_THAT(said_of({left_wall(0), another}), HasSubstr("is it another wall"));
}

TEST_F(BentCorridor, AScanThatIsNoKeyBecomesOne) {
    const test::Driven plain = driven({}, 1.0);
    const auto is_key = [](const test::Driven& driven, std::size_t scan) {
        return std::ranges::any_of(driven.registration.keys(),
                                   [&](const KeyPose& key) { return key.scan == scan; });
    };
    std::size_t scan = 20;
    while (scan < truth_.size() && is_key(plain, scan)) ++scan;
    ASSERT_LT(scan, truth_.size());
    EXPECT_TRUE(is_key(driven({left_wall(scan)}, 1.0), scan));
}

TEST_F(BentCorridor, IsForeseenAndTakenBack) {
    std::vector<GraphEdit> edits = at_begin();
    edits.push_back(end_wall(scan_at({38, 0})));
    test::Driven straight = finished(edits);
    test::Driven bent = finished(at_begin());
    const std::vector<Pose> before = bent.registration.path();
    ASSERT_TRUE(bent.registration.foresee(text_of(edits)));
    EXPECT_LT(std::abs(bent.registration.path().back().x - straight.registration.path().back().x),
              0.2);
    ASSERT_TRUE(bent.registration.correction().has_value());
    ASSERT_TRUE(straight.registration.foresee(text_of(at_begin())));
    EXPECT_LT(std::abs(straight.registration.path().back().x - before.back().x), 0.2);
    EXPECT_EQ(straight.registration.figures().anchors.size(), 2U);
}

TEST_F(BentCorridor, WhoKnowsNoDrawingHasThemAsEdgesFromTheFirst) {
    std::vector<GraphEdit> edits = at_begin();
    const test::Driven begun = finished(edits);
    const auto by_hand = [](const test::Driven& driven) {
        std::vector<PoseEdge> found;
        for (const PoseEdge& edge : driven.registration.edges()) {
            EXPECT_NE(edge.kind, EdgeKind::anchor);
            if (edge.kind == EdgeKind::fix) found.push_back(edge);
        }
        return found;
    };
    EXPECT_TRUE(by_hand(begun).empty()) << "of one scan alone they bend nothing";
    edits.push_back(end_wall(scan_at({38, 0})));
    const test::Driven bent = finished(edits);
    const std::vector<PoseEdge> told = by_hand(bent);
    ASSERT_EQ(told.size(), 1U) << "those of the first key say nothing of another";
    const auto keys = bent.registration.keys();
    const EdgeError error = edge_error(told[0], keys[told[0].from].pose, keys[told[0].to].pose);
    EXPECT_LT(error.value.dot(told[0].information * error.value), 1.0);
}

TEST_F(BentCorridor, IsTheSameTwiceAndFromACopy) {
    std::vector<GraphEdit> edits = at_begin();
    edits.push_back(end_wall(scan_at({38, 0})));
    test::Driven first = driven(edits);
    test::Driven second = driven(edits);
    Registration copy(first.registration);
    EXPECT_EQ(first.online, second.online);
    first.registration.finish();
    second.registration.finish();
    copy.finish();
    EXPECT_EQ(first.registration.path(), second.registration.path());
    EXPECT_EQ(first.registration.path(), copy.path());
    EXPECT_EQ(first.registration.drawing(), copy.drawing());
}

TEST(LaidDrawing, IsFirmWhereAnchorsSayAllOfIt) {
    const std::vector<KeyPose> keys{{{}, 0}, {{5.0, 1.0, 0.5}, 4}};
    const Pose drawn{4e6, -5e6, -2.0};  // of the world in the drawing
    const auto wall = [&](std::uint32_t key, double heading) {
        PoseEdge edge;
        edge.kind = EdgeKind::anchor;
        edge.to = key;
        edge.at = {1.0, 2.0};
        const Point2 at = transform(drawn, transform(keys[key].pose, edge.at));
        edge.z = {at.x, at.y, wrap_angle(drawn.theta + keys[key].pose.theta)};
        const Eigen::Vector2d across(-std::sin(heading), std::cos(heading));
        edge.information.topLeftCorner<2, 2>() = 400.0 * across * across.transpose();
        edge.information(2, 2) = 1e4;
        return edge;
    };
    const auto point = [&](std::uint32_t key) {
        PoseEdge edge = wall(key, 0.0);
        edge.information.setZero();
        edge.information.diagonal().head<2>().setConstant(400.0);
        return edge;
    };
    // Any two places on it draw a wall.
    const auto far = [&](PoseEdge edge, double heading) {
        edge.z.x += 1000.0 * std::cos(heading);
        edge.z.y += 1000.0 * std::sin(heading);
        return edge;
    };
    using Edges = std::vector<PoseEdge>;
    EXPECT_FALSE(laid_drawing(keys, Edges{PoseEdge{0, 1, {}, {}, EdgeKind::by_hand}}));
    for (const auto& [edges, firm] :
         {std::pair(Edges{wall(0, 0.3)}, false), std::pair(Edges{point(1)}, false),
          std::pair(Edges{wall(0, 0.3), wall(1, 0.3)}, false),
          std::pair(Edges{wall(0, 0.3), wall(1, 1.8)}, true),
          std::pair(Edges{point(0), wall(0, 1.0)}, true),
          std::pair(Edges{far(wall(0, 0.3), 0.3), wall(1, 1.8)}, true),
          std::pair(Edges{far(wall(0, 0.3), 0.3), wall(1, 0.3)}, false),
          std::pair(Edges{point(0), point(1)}, true)}) {
        const auto laid = laid_drawing(keys, edges);
        ASSERT_TRUE(laid);
        EXPECT_EQ(laid->firm, firm);
        for (const PoseEdge& edge : edges) {
            const Eigen::Vector3d error = edge_error(edge, laid->pose, keys[edge.to].pose).value;
            EXPECT_LT(error.dot(edge.information * error), 1e-6);
        }
        if (!firm) continue;
        EXPECT_NEAR(wrap_angle(laid->pose.theta - inverse(drawn).theta), 0.0, 1e-9);
        const Point2 origin = transform(laid->pose, Point2{drawn.x, drawn.y});
        EXPECT_NEAR(std::hypot(origin.x, origin.y), 0.0, 1e-6);
    }
}

TEST(SeenWall, IsTheOneInThatDirection) {
    const Walls walls{{{3, -2}, {3, 0.5}}, {{3, 1.5}, {3, 3}}, {{1, 2}, {0, 4}}};
    const Pose eye{0, 0, 0.1};
    const Scan scan = test::drawn_scan(walls, eye);
    const auto wall = seen_wall(scan, 80.0, -0.1);
    ASSERT_TRUE(wall);
    const Point2 left = transform(eye, wall->left);
    const Point2 right = transform(eye, wall->right);
    EXPECT_NEAR(left.x, 3.0, 0.01);
    EXPECT_NEAR(left.y, 0.5, 0.1) << "beyond the gap another one begins";
    EXPECT_NEAR(right.y, -2.0, 0.1);
    EXPECT_FALSE(seen_wall(scan, 80.0, 0.22)) << "through the gap nothing is seen";
    EXPECT_FALSE(seen_wall(scan, 2.0, -0.1)) << "beyond the range";
    EXPECT_FALSE(seen_wall({}, 80.0, 0.0));
    EXPECT_FALSE(seen_wall(scan, 80.0, 3.0));
    const std::vector<SeenWall> all = seen_walls(scan, 80.0);
    EXPECT_EQ(all.size(), 3U);
    for (const SeenWall& one : all) {
        const auto again = seen_wall(scan, 80.0, one.bearing);
        ASSERT_TRUE(again);
        EXPECT_LT(distance(again->left, one.left), 1e-9);
    }
}

TEST(SeenWall, EndsWhereItStepsBackByTheDepthOfADoor) {
    const Walls walls{{{3, -2}, {3, 0}}, {{3.15, 0}, {3.15, 2}}};
    const auto wall = seen_wall(test::drawn_scan(walls, {}), 80.0, -0.3);
    ASSERT_TRUE(wall);
    EXPECT_NEAR(wall->left.y, 0.0, 0.2);
    EXPECT_NEAR(wall->left.x, 3.0, 0.01);
}

TEST(SeenWall, AShortOneOrARoundThingIsNone) {
    Walls walls{{{3, -0.2}, {3, 0.2}}};
    for (int i = 0; i < 24; ++i) {
        const double a = i * kPi / 12.0;
        const double b = (i + 1) * kPi / 12.0;
        walls.push_back({{2.0 + 0.4 * std::cos(a), 3.0 + 0.4 * std::sin(a)},
                         {2.0 + 0.4 * std::cos(b), 3.0 + 0.4 * std::sin(b)}});
    }
    const Scan scan = test::drawn_scan(walls, {});
    EXPECT_FALSE(seen_wall(scan, 80.0, 0.0));
    EXPECT_FALSE(seen_wall(scan, 80.0, std::atan2(3.0, 2.0)));
    EXPECT_TRUE(seen_walls(scan, 80.0).empty());
}

}  // namespace
}  // namespace hitos
