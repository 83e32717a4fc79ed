#include "hitos/services/line_extents.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hitos {
namespace {

/// A filter that says what it is told to say.
class ToldFilter final : public SlamFilter {
  public:
    Pose pose;
    std::vector<Association> told;

    void step(std::span<const Control>, const Observation&) override {}
    std::uint64_t steps() const override { return 0; }
    Pose best_pose() const override { return pose; }
    LandmarkMap best_map() const override { return {}; }
    std::vector<Pose> best_history() const override { return {}; }
    int best_lines() const override { return 0; }
    int best_corners() const override { return 0; }
    std::span<const Association> associations() const override { return told; }
    std::vector<WeightedPose> hypotheses() const override { return {}; }
    FilterStatistics statistics() const override { return {}; }
    Eigen::Matrix3d pose_covariance() const override { return Eigen::Matrix3d::Zero(); }
};

/// One detected line between two points of the robot's frame.
Observation seen(const Point2& a, const Point2& b) {
    Observation observation;
    observation.support = {a, b};
    observation.lines = {{line_through(a, b), 0, 2}};
    return observation;
}

Association of_line(Association::Outcome outcome) {
    Association association;
    association.kind = FeatureKind::recta;
    association.outcome = outcome;
    association.landmark = 0;
    return association;
}

LandmarkMap map_of(std::vector<Recta> lines) {
    LandmarkMap map;
    for (const Recta& line : lines) map.push_back({line, Eigen::Matrix2d::Zero(), 1});
    return map;
}

TEST(LineExtents, GrowWithWhatIsSeenFromAnywhere) {
    LineExtents extents;
    ToldFilter filter;
    filter.told = {of_line(Association::Outcome::matched)};
    extents.note(filter, seen({0.0, 2.0}, {3.0, 2.0}));
    // From two metres ahead and turned by 90 degrees the same wall goes on.
    filter.pose = {2.0, 0.0, kPi / 2.0};
    extents.note(filter, seen({2.0, 0.0}, {2.0, -4.0}));
    const std::vector<LineExtent> found = extents.of(map_of({{2.0, kPi / 2.0}}));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].landmark, 0);
    EXPECT_NEAR(std::min(found[0].a.x, found[0].b.x), 0.0, 1e-9);
    EXPECT_NEAR(std::max(found[0].a.x, found[0].b.x), 6.0, 1e-9);
    EXPECT_NEAR(found[0].a.y, 2.0, 1e-9);
}

TEST(LineExtents, KeepTwoStretchesOfOneLineApart) {
    LineExtents extents;
    ToldFilter filter;
    filter.told = {of_line(Association::Outcome::created)};
    extents.note(filter, seen({0.0, 2.0}, {3.0, 2.0}));
    extents.note(filter, seen({8.0, 2.0}, {9.0, 2.0}));
    EXPECT_EQ(extents.of(map_of({{2.0, kPi / 2.0}})).size(), 2U);
}

TEST(LineExtents, BelongToTheNearestLineOrToNone) {
    LineExtents extents;
    ToldFilter filter;
    filter.told = {of_line(Association::Outcome::matched)};
    extents.note(filter, seen({0.0, 2.0}, {3.0, 2.0}));
    const auto found = extents.of(map_of({{2.3, kPi / 2.0}, {2.1, kPi / 2.0}, {2.0, 0.0}}));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].landmark, 1);
    EXPECT_TRUE(extents.of(map_of({{4.0, kPi / 2.0}})).empty());
    // The same line with its normal the other way round is the same line.
    EXPECT_EQ(extents.of(map_of({{-2.0, -kPi / 2.0}})).size(), 1U);
}

TEST(LineExtents, LeaveOutWhatWasIgnored) {
    LineExtents extents;
    ToldFilter filter;
    filter.told = {of_line(Association::Outcome::ignored)};
    extents.note(filter, seen({0.0, 2.0}, {3.0, 2.0}));
    EXPECT_TRUE(extents.of(map_of({{2.0, kPi / 2.0}})).empty());
}

}  // namespace
}  // namespace hitos
