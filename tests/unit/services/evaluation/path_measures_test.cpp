// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of poses, relations between them, and the relative error of paths.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "hitos/base/error.hpp"
#include "hitos/services/evaluation/path_errors.hpp"
#include "hitos/services/evaluation/position_error.hpp"
#include "hitos/services/evaluation/relations.hpp"
#include "hitos/services/evaluation/relative_error.hpp"
#include "hitos/services/files/tour_time.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using test::message_of;
using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pointwise;
using By = PairSpacing::By;

constexpr double kToday = 1.7e9;  // [s] stamps count from 1970

/// At (x, 0) after so many tenths of a second each.
Trajectory along_x(const std::vector<double>& places) {
    Trajectory trajectory;
    for (std::size_t i = 0; i < places.size(); ++i) {
        trajectory.push_back({kToday + 0.1 * static_cast<double>(i), {places[i], 0.0, 0.0}});
    }
    return trajectory;
}

/// A circle of radius 3 m, half a metre a pose.
Trajectory circle() {
    Trajectory trajectory;
    for (int i = 0; i < 60; ++i) {
        const double turn = i / 6.0;
        trajectory.push_back(
            {kToday + 0.1 * i,
             {3.0 * std::sin(turn), 3.0 - 3.0 * std::cos(turn), wrap_angle(turn)}});
    }
    return trajectory;
}

Trajectory moved_path(Trajectory trajectory, const Pose& frame) {
    for (StampedPose& stamped : trajectory) stamped.pose = compose(frame, stamped.pose);
    return trajectory;
}

TEST(ErrorFigures, AreThoseOfTheBooks) {
    const ErrorFigures even = figures_of({4.0, 1.0, 2.0, 1.0});
    EXPECT_DOUBLE_EQ(even.mean, 2.0);
    EXPECT_DOUBLE_EQ(even.deviation, std::sqrt(6.0 / 4.0));
    EXPECT_DOUBLE_EQ(even.rmse, std::sqrt(22.0 / 4.0));
    EXPECT_DOUBLE_EQ(even.median, 1.5);
    EXPECT_DOUBLE_EQ(even.maximum, 4.0);
    EXPECT_DOUBLE_EQ(figures_of({5.0, 1.0, 2.0}).median, 2.0);
    EXPECT_EQ(figures_of({}).maximum, 0.0);
    EXPECT_EQ(figures_of({7.0}).deviation, 0.0);
}

TEST(PosePairs, OverlappingTakeTheNearestAndTheFirstOfThose) {
    // The robot rests at 1 m; from 0.4 m nothing lies 1 m on within a tenth of it.
    const Trajectory path = along_x({0.0, 0.4, 1.0, 1.0, 1.25, 1.55, 1.9375, 2.0625});
    EXPECT_THAT(pose_pairs(path, {By::distance, 1.0, 0.1}),
                ElementsAre(PosePair{0, 2}, PosePair{2, 6}, PosePair{3, 6}));
    // The way counts, not the straight line: there and back again.
    EXPECT_THAT(pose_pairs(along_x({0.0, 0.5, 0.0}), {By::distance, 1.0, 0.1}),
                ElementsAre(PosePair{0, 2}));
    EXPECT_THAT(pose_pairs(path, {By::time, 0.5, 0.1}),
                ElementsAre(PosePair{0, 5}, PosePair{1, 6}, PosePair{2, 7}));
}

TEST(PosePairs, ConsecutiveBeginWhereTheWayFirstReachesTheLength) {
    const Trajectory path = along_x({0.0, 0.5, 1.0, 1.5, 2.25, 2.5, 3.5});
    EXPECT_THAT(pose_pairs(path, {By::distance, 1.0, 0.1, true}),
                ElementsAre(PosePair{2, 4}, PosePair{4, 6}));
    // Stamps of today are a quarter of a microsecond apart at best: tenths do not add up exactly.
    const Trajectory rest = along_x(std::vector<double>(41, 0.0));
    EXPECT_THAT(pose_pairs(rest, {By::time, 1.0, 0.1, true}),
                ElementsAre(PosePair{10, 20}, PosePair{20, 30}, PosePair{30, 40}));
}

TEST(PosePairs, NoTimeOfATourPassesBetweenTwo) {
    Trajectory path = along_x({0.0, 1.0, 2.0, 3.0, 4.0});
    const PairSpacing spacing{.by = By::time, .length = 0.2, .consecutive = true};
    const auto pairs = pose_pairs(path, spacing);
    EXPECT_THAT(pairs, ElementsAre(PosePair{2, 4}));
    for (std::size_t i : {3U, 4U}) path[i].time_s += 1e5;
    path[3].begins = true;
    EXPECT_THAT(pose_pairs(path, spacing), IsEmpty());
    EXPECT_NEAR(tour_duration_s(path), 0.3, 1e-6);
    EXPECT_THAT(tour_seconds(path), Pointwise(DoubleNear(1e-4), {0.0, 0.1, 0.2, 0.2, 0.3}));
    EXPECT_EQ(tour_duration_s({}), 0.0);
}

TEST(PosePairs, AreNoneWhereThereAreNone) {
    for (const bool consecutive : {false, true}) {
        for (const By by : {By::distance, By::time}) {
            for (const double length : {0.0, -1.0, 1e9, std::numeric_limits<double>::infinity(),
                                        std::numeric_limits<double>::quiet_NaN()}) {
                EXPECT_THAT(pose_pairs(circle(), {by, length, 0.1, consecutive}), IsEmpty());
            }
            EXPECT_THAT(pose_pairs({}, {by, 1.0, 0.1, consecutive}), IsEmpty());
            EXPECT_THAT(pose_pairs(along_x({1.0}), {by, 1.0, 0.1, consecutive}), IsEmpty());
        }
    }
}

TEST(RelativeError, IsZeroForTheSamePathInAnyFrame) {
    for (const Pose& frame : {Pose{}, Pose{5.0, -300.0, 2.5}}) {
        const auto error =
            relative_error(moved_path(circle(), frame), circle(), {By::distance, 2.0});
        ASSERT_TRUE(error);
        EXPECT_EQ(error->poses, 60);
        EXPECT_EQ(error->pairs, 56);
        EXPECT_NEAR(error->translation_m.maximum, 0.0, 1e-12);
        EXPECT_NEAR(error->rotation_rad.maximum, 0.0, 1e-12);
    }
}

TEST(RelativeError, OfAKnownDriftIsThatDrift) {
    // 1 % too long and turning 0.01 rad at every pose, on a straight way of 0.1 m a pose.
    std::vector<double> places;
    for (int i = 0; i < 50; ++i) places.push_back(0.1 * i);
    const Trajectory truth = along_x(places);
    Trajectory estimate = truth;
    for (StampedPose& stamped : estimate) stamped.pose.x *= 1.01;
    auto error = relative_error(estimate, truth, {By::time, 1.0, 0.05});
    ASSERT_TRUE(error);
    EXPECT_EQ(error->pairs, 40);
    EXPECT_NEAR(error->translation_m.mean, 0.01, 1e-9);
    EXPECT_NEAR(error->translation_m.deviation, 0.0, 1e-9);
    EXPECT_NEAR(error->rotation_rad.maximum, 0.0, 1e-12);
    estimate = truth;
    for (std::size_t i = 0; i < estimate.size(); ++i) {
        estimate[i].pose.theta = wrap_angle(0.01 * static_cast<double>(i));
    }
    error = relative_error(estimate, truth, {By::time, 1.0, 0.05});
    EXPECT_NEAR(error->rotation_rad.rmse, 0.1, 1e-9);
    EXPECT_NEAR(error->rotation_rad.median, 0.1, 1e-9);
}

TEST(RelativeError, NeedsCommonStampsAndALongEnoughWay) {
    Trajectory later = circle();
    for (StampedPose& stamped : later) stamped.time_s += 100.0;
    EXPECT_FALSE(relative_error(later, circle(), {By::distance, 1.0}));
    EXPECT_FALSE(relative_error(circle(), circle(), {By::distance, 1000.0}));
    EXPECT_FALSE(relative_error({circle().front()}, circle(), {By::distance, 1.0}));
    // The order of the lines does not matter.
    Trajectory shuffled = circle();
    std::ranges::reverse(shuffled);
    EXPECT_NEAR(relative_error(shuffled, circle(), {By::distance, 1.0})->translation_m.maximum, 0.0,
                1e-12);
}

/// The circle as odometry has it that turns too far, every pose.
Trajectory drifted_circle() {
    Trajectory path = circle();
    for (std::size_t i = 0; i < path.size(); ++i) {
        path[i].pose = compose(path[i].pose, {0.01 * static_cast<double>(i), -0.02, 0.001});
    }
    return path;
}

TEST(PathErrors, AreNoneForTheSamePathInAnyFrame) {
    const Trajectory moved = moved_path(circle(), {5.0, -3.0, 2.5});
    const auto whole = trajectory_error(moved, circle());
    ASSERT_TRUE(whole);
    for (const auto& frame :
         {std::optional(whole->pose_reference_estimate), std::optional<Pose>()}) {
        const auto errors = path_errors(moved, circle(), frame);
        ASSERT_EQ(errors.size(), moved.size());
        for (const PathError& error : errors) EXPECT_NEAR(error.error_m, 0.0, 1e-9);
    }
    // Where it lies already there is nothing to move.
    for (const PathError& error : path_errors(circle(), circle(), Pose{}))
        EXPECT_EQ(error.error_m, 0.0);
}

TEST(PathErrors, AlignedTheyAreThoseOfTheAteToTheLastBit) {
    const Trajectory path = drifted_circle();
    const auto whole = trajectory_error(path, circle());
    ASSERT_TRUE(whole && whole->rmse_m > 0.05);
    const auto errors = path_errors(path, circle(), whole->pose_reference_estimate);
    double squares = 0.0;
    double greatest = 0.0;
    for (const PathError& error : errors) {
        squares += error.error_m * error.error_m;
        greatest = std::max(greatest, error.error_m);
    }
    EXPECT_EQ(std::sqrt(squares / static_cast<double>(errors.size())), whole->rmse_m);
    EXPECT_EQ(greatest, whole->maximum_m);
}

TEST(PathErrors, WithoutAlignmentTheyAreThePositionErrors) {
    const Trajectory path = moved_path(drifted_circle(), {1.0, 2.0, -1.0});
    const auto errors = path_errors(path, circle());
    ASSERT_EQ(errors.size(), path.size());
    EXPECT_NEAR(errors.front().error_m, 0.0, 1e-12);
    EXPECT_GT(errors.back().error_m, 0.1);
    PositionError position(circle());
    for (const PathError& error : errors) {
        EXPECT_EQ(error.time_s, path[error.pose].time_s);
        EXPECT_NEAR(error.error_m, position.at(path[error.pose]).value(), 1e-9);
    }
}

TEST(PathErrors, CountTheWholeWayAndLeaveOutPosesWithoutReference) {
    // There and back again; the reference knows the last three places only.
    const Trajectory path = along_x({0.0, 2.0, 1.0, 1.5, 1.5});
    const Trajectory reference(path.begin() + 2, path.end());
    const auto errors = path_errors(path, reference);
    ASSERT_EQ(errors.size(), 3U);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(errors[k].pose, k + 2);
    EXPECT_DOUBLE_EQ(errors[0].way_m, 3.0);
    EXPECT_DOUBLE_EQ(errors[1].way_m, 3.5);
    EXPECT_DOUBLE_EQ(errors[2].way_m, 3.5);
    EXPECT_THAT(path_errors(path, {}), IsEmpty());
    EXPECT_THAT(path_errors({}, path), IsEmpty());
    Trajectory later = path;
    for (StampedPose& stamped : later) stamped.time_s += 1e5;
    EXPECT_THAT(path_errors(path, later), IsEmpty());
}

TEST(Relations, OfAPathAreZeroOnItAndReadBackToTheLastBit) {
    const Trajectory path = circle();
    const auto relations = relations_of(path, pose_pairs(path, {By::distance, 4.0}));
    EXPECT_EQ(relations.size(), 52U);
    EXPECT_EQ(parse_relations(relations_text(relations), "text"), relations);
    for (const Pose& frame : {Pose{}, Pose{1.0, 2.0, -3.0}}) {
        const RelationErrors errors =
            relation_errors(measure_relations(moved_path(path, frame), relations));
        EXPECT_EQ(errors.used, 52);
        EXPECT_NEAR(errors.translation_m.maximum, 0.0, 1e-12);
        EXPECT_NEAR(errors.rotation_rad.maximum, 0.0, 1e-12);
    }
}

TEST(Relations, KnownOffsetsAreKnownErrors) {
    // Off by (0.3, 0.4) m as the first pose sees it; by more than half a turn in the angle.
    const std::vector<PoseRelation> relations{{0.0, 1.0, {1.0, 0.0, 3.0}},
                                              {1.0, 0.0, {-1.0, 0.0, 0.0}}};
    const Trajectory estimate{{0.0, {5.0, 5.0, kPi / 2.0}},
                              {1.0, {4.6, 6.3, wrap_angle(kPi / 2.0 - 3.1)}}};
    const auto measured = measure_relations(estimate, relations);
    EXPECT_NEAR(measured[0].estimate_from_to->x, 1.3, 1e-12);
    EXPECT_NEAR(measured[0].estimate_from_to->y, 0.4, 1e-12);
    EXPECT_NEAR(measured[0].translation_m(), 0.5, 1e-12);
    EXPECT_NEAR(measured[0].rotation_rad(), 2.0 * kPi - 6.1, 1e-12) << "the shorter way round";
    EXPECT_NEAR(measured[1].rotation_rad(), 3.1, 1e-12) << "backwards in time";
    const RelationErrors errors = relation_errors(std::span(measured).first(1));
    EXPECT_NEAR(errors.translation_squared_m2.mean, 0.25, 1e-12);
    EXPECT_NEAR(errors.rotation_squared_rad2.mean, std::pow(2.0 * kPi - 6.1, 2), 1e-12);
}

TEST(Relations, TakeTheNearestPoseWithinTheTolerance) {
    const Trajectory estimate{
        {kToday + 1.0, {2.0, 0.0, 0.0}}, {kToday, {}}, {kToday + 0.015, {1.0, 0.0, 0.0}}};
    const auto at = [&](double t1, double t2, double tolerance) {
        const std::vector<PoseRelation> one{{kToday + t1, kToday + t2, {}}};
        return measure_relations(estimate, one, tolerance).front();
    };
    EXPECT_NEAR(at(0.004, 0.99, 0.02).translation_m(), 2.0, 1e-12);
    EXPECT_NEAR(at(0.011, 1.01, 0.02).translation_m(), 1.0, 1e-12);
    EXPECT_FALSE(at(0.5, 1.0, 0.02).has_from);
    EXPECT_FALSE(at(-1.0, 2.0, 0.02).has_to);
    EXPECT_FALSE(at(-1.0, 2.0, 0.02).estimate_from_to);
    EXPECT_EQ(at(0.0, 0.0, 0.0).translation_m(), 0.0) << "one pose may be both";
}

TEST(Relations, CountsWhoseEndsAPathDoesNotHave) {
    const Trajectory path = along_x({0.0, 1.0, 2.0});
    const double before = kToday - 10.0;
    const double behind = kToday + 10.0;
    const std::vector<PoseRelation> relations{{kToday, kToday + 0.1, {1.0, 0.0, 0.0}},
                                              {before, kToday, {}},
                                              {before, kToday + 0.1, {}},
                                              {kToday, behind, {}},
                                              {kToday + 0.1, behind, {}},
                                              {kToday + 0.2, behind, {}},
                                              {before, behind, {}}};
    const RelationErrors errors = relation_errors(measure_relations(path, relations, 0.01));
    EXPECT_EQ(errors.used, 1);
    EXPECT_EQ(errors.without_from, 2);
    EXPECT_EQ(errors.without_to, 3);
    EXPECT_EQ(errors.without_both, 1);
}

TEST(Relations, BadFilesSayWhereAndWhat) {
    const auto parse = [](const char* text) {
        return message_of<FormatError>([&] { parse_relations(text, "r.relations"); });
    };
    EXPECT_THAT(parse(""), HasSubstr("r.relations: no relation in the file"));
    EXPECT_THAT(parse("# only words\n\n"), HasSubstr("t1 t2 x y z roll pitch yaw"));
    EXPECT_THAT(parse("1 2 0 0 0 0 0\n"), HasSubstr("r.relations:1: "));
    EXPECT_THAT(parse("1 2 0 0 0 0 0 0\n1 2 0 -1e308 0 0 0 0\n"),
                HasSubstr("r.relations:2: y is \"-1e308\"; expected a number from -1e+12"));
    EXPECT_THAT(parse("1 2 0 0 0 0 0 0\n\n1 2 0 0 0 0 0 0 0\n"), HasSubstr("r.relations:3: "));
    EXPECT_THAT(parse("1 2 0 0 0 left 0 0\n"), HasSubstr("roll"));
    EXPECT_THAT(parse("1 2 0 0 0 0 0 nan\n"), HasSubstr("yaw"));
    EXPECT_THAT(message_of<FileError>([] { read_relations("/none/r.relations"); }),
                HasSubstr("/none/r.relations"));
    const std::vector<PoseRelation> endless{{0.0, HUGE_VAL, {}}};
    EXPECT_THAT(message_of<Error>([&] { relations_text(endless); }), HasSubstr("relation 1"));
}

}  // namespace
}  // namespace hitos
