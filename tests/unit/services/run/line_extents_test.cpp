// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/files/line_extents.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace hitos {
namespace {

/// A filter that says what it is told to say.
class ToldFilter final : public SlamFilter {
  public:
    Pose pose;
    std::vector<Association> told;

    void step(const SlamInput&) override {}
    std::uint64_t steps() const override { return 0; }
    Pose best_pose() const override { return pose; }
    LandmarkMap best_map() const override { return {}; }
    std::vector<Pose> best_history() const override { return {}; }
    int best_count(FeatureKind) const override { return 0; }
    std::span<const Association> associations() const override { return told; }
    std::vector<WeightedPose> hypotheses() const override { return {}; }
    FilterStatistics statistics() const override { return {}; }
    Eigen::Matrix3d pose_covariance() const override { return Eigen::Matrix3d::Zero(); }
};

/// One detected line with these points.
Observation seen(std::vector<Point2> points) {
    Observation observation;
    observation.lines = {{line_through(points.front(), points.back()), 0,
                          static_cast<std::uint32_t>(points.size())}};
    observation.support = std::move(points);
    return observation;
}

/// Points every 5 cm from a to b, both included.
std::vector<Point2> wall_row(const Point2& a, const Point2& b) {
    const int n = std::max(1, static_cast<int>(std::hypot(b.x - a.x, b.y - a.y) / 0.05));
    std::vector<Point2> points;
    for (int i = 0; i <= n; ++i) {
        const double part = static_cast<double>(i) / n;
        points.push_back({a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)});
    }
    return points;
}

Association of_line(Association::Outcome outcome) {
    Association association;
    association.kind = FeatureKind::line;
    association.outcome = outcome;
    association.landmark = 0;
    return association;
}

LandmarkMap extents_map_of(const std::vector<Recta>& lines) {
    LandmarkMap map;
    for (const Recta& line : lines) map.push_back({line, Eigen::Matrix2d::Zero(), 1});
    return map;
}

/// Notes scans and keeps the path that belongs to them.
class Noted {
  public:
    Noted() { filter_.told = {of_line(Association::Outcome::matched)}; }
    void scan(const Pose& pose, std::vector<Point2> points,
              Association::Outcome outcome = Association::Outcome::matched) {
        filter_.told = {of_line(outcome)};
        extents_.note(filter_, seen(std::move(points)));
        path_.push_back({0.2 * static_cast<double>(path_.size()), pose});
    }
    std::vector<LineExtent> of(const LandmarkMap& map) const { return extents_.of(map, path_); }
    std::vector<LineExtent> along(const Trajectory& path, const LandmarkMap& map) const {
        return extents_.of(map, path);
    }

  private:
    ToldFilter filter_;
    LineExtents extents_;
    Trajectory path_;
};

const Recta kNorth{2.0, kPi / 2.0};  // y = 2; its segments run from greater to smaller x

TEST(LineExtents, GrowWithWhatIsSeenFromAnywhere) {
    Noted noted;
    noted.scan({}, wall_row({0.0, 2.0}, {3.0, 2.0}));
    // From two metres ahead and turned by 90 degrees the same wall goes on.
    noted.scan({2.0, 0.0, kPi / 2.0}, wall_row({2.0, 0.0}, {2.0, -4.0}));
    const std::vector<LineExtent> found = noted.of(extents_map_of({kNorth}));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].landmark, 0);
    EXPECT_NEAR(std::min(found[0].a.x, found[0].b.x), 0.0, 1e-9);
    EXPECT_NEAR(std::max(found[0].a.x, found[0].b.x), 6.0, 1e-9);
    EXPECT_EQ(found[0].points, 61U + 81U);
}

TEST(LineExtents, LieOnTheLandmarkNotOnThePoints) {
    Noted noted;
    noted.scan({}, wall_row({0.0, 2.1}, {3.0, 1.95}));
    const Recta line = line_through({0.0, 1.9}, {1.0, 1.95});
    const std::vector<LineExtent> found = noted.of(extents_map_of({line}));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(signed_distance(line, found[0].a), 0.0, 1e-12);
    EXPECT_NEAR(signed_distance(line, found[0].b), 0.0, 1e-12);
    // The feet of the perpendiculars of the outermost points.
    const double dx = found[0].b.x - found[0].a.x;
    const double dy = found[0].b.y - found[0].a.y;
    const std::array<Point2, 2> ends = {{{0.0, 2.1}, {3.0, 1.95}}};
    for (const Point2& end : ends) {
        const double nearest =
            std::min(std::abs((end.x - found[0].a.x) * dx + (end.y - found[0].a.y) * dy),
                     std::abs((end.x - found[0].b.x) * dx + (end.y - found[0].b.y) * dy));
        EXPECT_NEAR(nearest, 0.0, 1e-9);
    }
}

TEST(LineExtents, KeepAnOpeningWithinTheSupportOfOneLine) {
    // Merged pieces on both sides of a door of 0.8 m, as Split & Merge hands them over.
    std::vector<Point2> points = wall_row({0.0, 2.0}, {3.0, 2.0});
    for (const Point2& point : wall_row({3.8, 2.0}, {5.0, 2.0})) points.push_back(point);
    Noted noted;
    for (int i = 0; i < 5; ++i) noted.scan({}, points);
    const std::vector<LineExtent> found = noted.of(extents_map_of({kNorth}));
    ASSERT_EQ(found.size(), 2U);
    std::vector<double> ends;
    for (const LineExtent& extent : found) {
        ends.push_back(extent.a.x);
        ends.push_back(extent.b.x);
    }
    std::ranges::sort(ends);
    EXPECT_NEAR(ends[1], 3.0, 1e-9);
    EXPECT_NEAR(ends[2], 3.8, 1e-9);
}

TEST(LineExtents, GrazingScansFillEachOthersGapsButNoOpening) {
    // Neighbours 0.9 m apart, from scan to scan 0.1 m further; nothing between x = 5 and x = 6.
    Noted noted;
    for (int k = 0; k < 9; ++k) {
        std::vector<Point2> points;
        for (int i = 0; i < 10; ++i) {
            const double x = 0.9 * i;
            if (x + 0.1 * k <= 5.0 || x + 0.1 * k >= 6.0) points.push_back({x, 2.0});
        }
        noted.scan({0.1 * k, 0.0, 0.0}, points);
    }
    const std::vector<LineExtent> found = noted.of(extents_map_of({kNorth}));
    ASSERT_EQ(found.size(), 2U);
    EXPECT_NEAR(found[0].a.x - found[0].b.x, 8.9 - 6.0, 0.201);
    EXPECT_NEAR(found[1].a.x - found[1].b.x, 5.0, 0.201);
}

TEST(LineExtents, EndWhereTheWallDoesThoughPosesScatter) {
    // A wall from x = 0 to 3 seen by 40 scans whose places are off by up to 0.12 m either way,
    // every fourth of which sees half of it only.
    Noted noted;
    for (int k = 0; k < 40; ++k) {
        const double off = 0.12 * std::sin(1.7 * k);
        noted.scan({off, 0.0, 0.0}, wall_row({0.0, 2.0}, {k % 4 == 3 ? 1.5 : 3.0, 2.0}));
    }
    const std::vector<LineExtent> found = noted.of(extents_map_of({kNorth}));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].a.x, 3.0, 0.07);
    EXPECT_NEAR(found[0].b.x, 0.0, 0.07);
}

TEST(LineExtents, OfFewPointsAreLeftOutWhereTheLineHasOthers) {
    Noted noted;
    noted.scan({}, wall_row({0.0, 2.0}, {3.0, 2.0}));
    noted.scan({}, {{7.0, 2.0}, {7.1, 2.0}, {7.2, 2.0}});
    EXPECT_EQ(noted.of(extents_map_of({kNorth})).size(), 1U);
    // A line seen in few far points only still gets its ends.
    Noted far;
    far.scan({}, {{1.0, 2.0}, {2.0, 2.0}, {3.2, 2.0}, {5.0, 2.0}});
    const std::vector<LineExtent> found = far.of(extents_map_of({kNorth}));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(std::abs(found[0].a.x - found[0].b.x), 4.0, 1e-9);
    EXPECT_EQ(found[0].points, 4U);
}

TEST(LineExtents, FollowThePathThatBelongsToTheMap) {
    // At the time the best hypothesis stood elsewhere; the finished map has another past.
    Noted noted;
    noted.scan({5.0, 3.0, 1.0}, wall_row({0.0, 2.0}, {3.0, 2.0}));
    EXPECT_TRUE(noted.of(extents_map_of({kNorth})).empty());
    const std::vector<LineExtent> found =
        noted.along({{0.0, {1.0, 0.0, 0.0}}}, extents_map_of({kNorth}));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(std::max(found[0].a.x, found[0].b.x), 4.0, 1e-9);
    // A path that ends before the scan has no place for it.
    EXPECT_TRUE(noted.along({}, extents_map_of({kNorth})).empty());
}

TEST(LineExtents, BelongToTheNearestLineOrToNone) {
    Noted noted;
    noted.scan({}, wall_row({0.0, 2.0}, {3.0, 2.0}));
    const auto found = noted.of(extents_map_of({{2.3, kPi / 2.0}, {2.1, kPi / 2.0}, {2.0, 0.0}}));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].landmark, 1);
    EXPECT_TRUE(noted.of(extents_map_of({{4.0, kPi / 2.0}})).empty());
    // The same line with its normal the other way round is the same line.
    EXPECT_EQ(noted.of(extents_map_of({{-2.0, -kPi / 2.0}})).size(), 1U);
}

TEST(LineExtents, BelongToTheWallThatWasSeenThere) {
    // Of two walls in a row, a door between them, the one that lies nearer ends before the door.
    Noted noted;
    noted.scan({}, wall_row({0.0, 2.0}, {3.0, 2.0}));
    LandmarkMap map = extents_map_of({{2.02, kPi / 2.0}, kNorth});
    map[0].from_m = -3.0;
    map[0].to_m = 0.0;
    map[1].from_m = -8.0;
    map[1].to_m = -5.0;
    const auto found = noted.of(map);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].landmark, 0);
}

TEST(LineExtents, OfShortPiecesGoByTheWholeLinesDirection) {
    // Two far points in the corner of x = 0 and y = 2, 4 m of opening after them.
    Noted noted;
    noted.scan({}, {{0.0, 2.0}, {4.5, 2.0}, {5.0, 2.0}});
    const auto found = noted.of(extents_map_of({{0.0, 0.0}, kNorth}));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].landmark, 1);
}

TEST(LineExtents, KeepAWallOnWhichTheScansSeamLies) {
    // A laser all round begins and ends its scan on the wall behind it: the first point of the line
    // and its last are neighbours, and the way between them is across the wall.
    std::vector<Point2> points = wall_row({-2.0, 0.0}, {-2.0, -3.0});
    const std::vector<Point2> before = wall_row({-2.0, 3.0}, {-2.0, 0.05});
    points.insert(points.end(), before.begin(), before.end());
    points.back() = {-2.02, 0.0};
    ToldFilter filter;
    filter.told = {of_line(Association::Outcome::matched)};
    Observation observation;
    observation.lines = {{{2.0, kPi}, 0, static_cast<std::uint32_t>(points.size())}};
    observation.support = std::move(points);
    LineExtents extents;
    extents.note(filter, observation);
    const auto found = extents.of(extents_map_of({{2.0, kPi}}), {{0.0, Pose{}}});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(std::abs(found[0].a.y - found[0].b.y), 6.0, 0.1);
}

TEST(LineExtents, PassOverPosesThatAreNoNumbers) {
    Noted noted;
    noted.scan({}, wall_row({0.0, 2.0}, {3.0, 2.0}));
    for (const double bad : {std::nan(""), HUGE_VAL, 1e308}) {
        noted.scan({bad, 0.0, 0.0}, wall_row({0.0, 2.0}, {3.0, 2.0}));
        noted.scan({0.0, bad, 0.0}, wall_row({0.0, 2.0}, {3.0, 2.0}));
    }
    noted.scan({0.0, 0.0, std::nan("")}, wall_row({0.0, 2.0}, {3.0, 2.0}));
    const std::vector<LineExtent> found =
        noted.of(extents_map_of({kNorth, {std::nan(""), 0.0}, {2.0, std::nan("")}}));
    ASSERT_FALSE(found.empty());
    for (const LineExtent& extent : found) {
        EXPECT_EQ(extent.landmark, 0);
        EXPECT_TRUE(std::isfinite(extent.a.x) && std::isfinite(extent.b.x));
    }
}

TEST(LineExtents, LeaveOutWhatWasIgnored) {
    Noted noted;
    noted.scan({}, wall_row({0.0, 2.0}, {3.0, 2.0}), Association::Outcome::ignored);
    EXPECT_TRUE(noted.of(extents_map_of({kNorth})).empty());
    // The next scan is still the second.
    noted.scan({1.0, 0.0, 0.0}, wall_row({0.0, 2.0}, {3.0, 2.0}));
    const std::vector<LineExtent> found = noted.of(extents_map_of({kNorth}));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(std::max(found[0].a.x, found[0].b.x), 4.0, 1e-9);
}

}  // namespace
}  // namespace hitos
