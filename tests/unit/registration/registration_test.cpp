// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/registration/registration.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "drawn_scan.hpp"
#include "hitos/registration/odometry_step.hpp"
#include "ring_tour.hpp"

namespace hitos {
namespace {

using test::drive;
using test::Driven;
using test::greatest_path_error;
using test::kRing;
using test::ring_walls;
using test::round_tour;

TEST(Registration, ClosesTheLoopOfARing) {
    const std::vector<Pose> truth = round_tour(kRing, 2);
    Driven once = drive(ring_walls(), truth, 0.01, 1.03);
    EXPECT_GT(greatest_path_error(once.odometry, truth), 3.0);
    EXPECT_LT(greatest_path_error(once.online, truth), 0.4);
    EXPECT_GE(once.registration.loops().size(), 1U);
    for (const LoopRecord& loop : once.registration.loops()) {
        const Pose true_pose = between(truth[loop.earlier], truth[loop.scan]);
        EXPECT_NEAR(loop.pose_earlier_scan.x, true_pose.x, 0.1);
        EXPECT_NEAR(loop.pose_earlier_scan.y, true_pose.y, 0.1);
        EXPECT_NEAR(wrap_angle(loop.pose_earlier_scan.theta - true_pose.theta), 0.0, 0.02);
        EXPECT_EQ(loop.verdict, LoopVerdict::closed);
        EXPECT_GT(loop.move_m, 0.0);
        EXPECT_LT(loop.chi_square.value(), 50.0);
        EXPECT_FALSE(loop.weight) << "the tour is not at its end";
    }
    once.registration.finish();
    for (const LoopRecord& loop : once.registration.loops()) {
        EXPECT_GT(loop.weight.value(), 0.8) << loop.scan;
        EXPECT_LE(*loop.weight, 1.0);
    }
    EXPECT_LT(greatest_path_error(once.registration.path(), truth), 0.08);
    const RegistrationFigures figures = once.registration.figures();
    EXPECT_EQ(figures.unmatched, 0U);
    EXPECT_TRUE(figures.breaks.empty());
    EXPECT_GT(figures.mean_score, 0.8);
}

TEST(Registration, CorrectionsCarryTheOldPathToTheNew) {
    const std::vector<Pose> truth = round_tour(kRing, 2);
    Registration registration{RegistrationParams{}};
    std::vector<Pose> path;
    bool corrected = false;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        std::vector<Control> controls;
        if (i > 0) {
            Pose step = between(truth[i - 1], truth[i]);
            step.theta += 0.004 * std::hypot(step.x, step.y);
            controls.push_back({twist_between(step, 1.0), 1.0});
        }
        path.push_back(registration.add(test::drawn_scan(ring_walls(), truth[i]), controls).pose);
        if (const auto correction = registration.correction()) {
            corrected = true;
            ASSERT_EQ(correction->by_scan.size(), path.size());
            for (std::size_t k = 0; k < path.size(); ++k) {
                path[k] = compose(correction->by_scan[k], path[k]);
            }
        }
        EXPECT_NEAR(path.back().x, registration.path().back().x, 1e-9);
    }
    EXPECT_TRUE(corrected);
    const std::vector<Pose> stated = registration.path();
    for (std::size_t k = 0; k < path.size(); ++k) {
        EXPECT_NEAR(path[k].x, stated[k].x, 1e-9);
        EXPECT_NEAR(path[k].y, stated[k].y, 1e-9);
    }
}

TEST(Registration, TwoEqualCorridorsAreNotOne) {
    // Two corridors with the same recesses, side by side and 6 m apart: what correlates perfectly
    // is not where the odometry, good to a few centimetres, says that the robot is.
    Walls walls;
    for (const double y : {0.0, 6.0}) {
        const Walls corridor = test::closed({{-2, y - 1},
                                             {6, y - 1},
                                             {6, y - 2},
                                             {8, y - 2},
                                             {8, y - 1},
                                             {14, y - 1},
                                             {14, y - 1.5},
                                             {15, y - 1.5},
                                             {15, y - 1},
                                             {24, y - 1},
                                             {24, y + 1},
                                             {-2, y + 1}});
        walls.insert(walls.end(), corridor.begin(), corridor.end());
    }
    // The ends are open: the way between them is free.
    std::erase_if(walls, [](const auto& wall) {
        return wall.first.x == wall.second.x && (wall.first.x == 24.0 || wall.first.x == -2.0);
    });
    const Walls around = test::closed({{-6, -4}, {28, -4}, {28, 10}, {-6, 10}});
    walls.insert(walls.end(), around.begin(), around.end());
    const std::vector<Point2> way{{-4, 0}, {26, 0}, {26, 6}, {-4, 6}};
    std::vector<Pose> truth = round_tour(way, 1);
    const Driven once = drive(walls, truth, 0.0005, 1.005);
    EXPECT_LT(greatest_path_error(once.registration.path(), truth), 0.4);
    for (const LoopRecord& loop : once.registration.loops()) {
        const Pose& a = truth[loop.scan];
        const Pose& b = truth[loop.earlier];
        EXPECT_LT(std::hypot(a.x - b.x, a.y - b.y), 5.0) << loop.scan << " " << loop.earlier;
    }
}

TEST(Registration, IsTheSameTwice) {
    const std::vector<Pose> truth = round_tour(kRing, 1);
    Driven first = drive(ring_walls(), truth, 0.004, 1.02);
    Driven second = drive(ring_walls(), truth, 0.004, 1.02);
    first.registration.finish();
    second.registration.finish();
    EXPECT_EQ(first.registration.path(), second.registration.path());
    EXPECT_EQ(first.online, second.online);
}

TEST(Registration, SameBitsForAnyNumberOfThreads) {
    RegistrationParams params;
    params.key_distance_m = 0.3;  // every step a key, so that there is work for several
    const std::vector<Pose> truth = test::round_tour(test::kRing, 2);
    std::vector<Pose> alone;
    for (const int threads : {1, 2, 7}) {
        test::Driven driven =
            test::drive(test::ring_walls(), truth, 0.004, 1.01, params, 0.005, threads);
        EXPECT_GT(driven.registration.keys().size(), 200U);
        driven.registration.finish();
        const std::vector<Pose> path = driven.registration.path();
        if (alone.empty()) alone = path;
        EXPECT_EQ(path, alone) << threads << " threads";
    }
}

TEST(Registration, SaysThatARobotWasCarried) {
    // From one building to another that is nothing like it, without a word from the wheels.
    std::vector<Pose> truth = round_tour(kRing, 1);
    const std::size_t carried = truth.size() / 2;
    Registration registration{RegistrationParams{}};
    const Walls hall = test::closed({{-30, -22}, {35, -25}, {28, 31}, {4, 37}, {-33, 20}});
    for (std::size_t i = 0; i < carried + 12; ++i) {
        std::vector<Control> controls;
        if (i > 0) controls.push_back(test::control_between(truth[i - 1], truth[i]));
        const RegisteredStep step = registration.add(
            test::drawn_scan(i < carried ? ring_walls() : hall, truth[i], 0.0, nullptr, 60.0),
            controls);
        if (i == carried) {
            EXPECT_FALSE(step.matched);
            // What is not known is not claimed: as unsure as the odometry.
            EXPECT_GT(std::sqrt(step.covariance(2, 2)), 0.029);
        }
    }
    EXPECT_GE(registration.figures().unmatched, 1U);
    ASSERT_FALSE(registration.figures().breaks.empty());
    EXPECT_EQ(registration.figures().breaks.front(), carried);
}

/// Two laps, the second one begun where `put_down` says, of the first one's poses; the wheels say
/// nothing of it.
struct Carried {
    std::vector<Pose> truth;
    std::size_t at = 0;
    Registration registration;
};
Carried carried_to(const Walls& walls, const std::vector<Point2>& way, std::size_t put_down) {
    Carried carried{round_tour(way, 1), 0, Registration{RegistrationParams{}}};
    carried.at = carried.truth.size();
    const std::vector<Pose> again = round_tour(way, 2);
    carried.truth.insert(carried.truth.end(), again.begin() + static_cast<std::ptrdiff_t>(put_down),
                         again.end());
    std::mt19937 engine(9);
    for (std::size_t i = 0; i < carried.truth.size(); ++i) {
        std::vector<Control> controls;
        if (i == carried.at) {
            controls.push_back({twist_between({0.05, 0.0, 0.0}, 1.0), 1.0});
        } else if (i > 0) {
            controls.push_back(test::control_between(carried.truth[i - 1], carried.truth[i]));
        }
        carried.registration.add(test::drawn_scan(walls, carried.truth[i], 0.005, &engine),
                                 controls);
    }
    return carried;
}

TEST(Registration, FindsARobotThatWasCarried) {
    Carried carried = carried_to(ring_walls(), kRing, 20);
    ASSERT_FALSE(carried.registration.figures().breaks.empty());
    EXPECT_EQ(carried.registration.figures().breaks.front(), carried.at);
    const auto joins = [&](const LoopRecord& loop) {
        return loop.earlier < carried.at && carried.at <= loop.scan;
    };
    const std::vector<LoopRecord>& loops = carried.registration.loops();
    const auto found = std::ranges::find_if(loops, joins);
    ASSERT_NE(found, loops.end());
    const Pose true_pose = between(carried.truth[found->earlier], carried.truth[found->scan]);
    EXPECT_NEAR(found->pose_earlier_scan.x, true_pose.x, 0.1);
    EXPECT_NEAR(found->pose_earlier_scan.y, true_pose.y, 0.1);
    EXPECT_NEAR(wrap_angle(found->pose_earlier_scan.theta - true_pose.theta), 0.0, 0.02);
    // All of the piece is laid there, the scans before its first key among it, and no edge says
    // that the robot drove where it was carried.
    const std::vector<Pose> path = carried.registration.path();
    EXPECT_LT(greatest_path_error(path, carried.truth), 0.15);
    for (const PoseEdge& edge : carried.registration.edges()) {
        if (edge.kind != EdgeKind::odometry) continue;
        const std::span<const KeyPose> keys = carried.registration.keys();
        EXPECT_FALSE(keys[edge.from].scan < carried.at && carried.at <= keys[edge.to].scan);
    }
    carried.registration.finish();
    EXPECT_LT(greatest_path_error(carried.registration.path(), carried.truth), 0.1);
}

TEST(Registration, IsNotFoundInOneOfTwoPlacesThatAreAlike) {
    const Walls walls = test::ring_of_two_halves();
    const Carried carried = carried_to(walls, kRing, 20);
    ASSERT_FALSE(carried.registration.figures().breaks.empty());
    const std::vector<LoopRecord>& refused = carried.registration.refused_loops();
    EXPECT_TRUE(std::ranges::any_of(
        refused, [](const LoopRecord& loop) { return loop.verdict == LoopVerdict::ambiguous; }));
    for (const LoopRecord& loop : carried.registration.loops()) {
        EXPECT_LT(loop.move_m, 0.5) << loop.scan;  // nothing is laid anywhere else
    }
}

TEST(Registration, OdometryThatBeginsAnewWhileTheRobotStandsIsPassedOver) {
    const std::vector<Pose> truth = round_tour(kRing, 1);
    Registration registration{RegistrationParams{}};
    std::mt19937 engine(9);
    for (std::size_t i = 0; i < truth.size(); ++i) {
        std::vector<Control> controls;
        if (i > 0) {
            Pose step = between(truth[i - 1], truth[i]);
            if (i == 60) step = {4.0, -3.0, 1.5};
            controls.push_back({twist_between(step, 1.0), 1.0});
        }
        // At the leap it stands where it stood.
        const Pose& at = truth[i == 60 ? 59 : i];
        registration.add(test::drawn_scan(ring_walls(), at, 0.005, &engine), controls);
        if (i == 60) {
            const Pose there = compose(truth.front(), registration.path().back());
            EXPECT_LT(std::hypot(there.x - at.x, there.y - at.y), 0.05);
        }
    }
    EXPECT_TRUE(registration.figures().breaks.empty());
    // The graph is as unsure of that step as the match was: of half a metre that nobody saw.
    const Eigen::Vector3d unsure = odometry_variances({0.5, 0.0, 0.3}, 1.0);
    for (const PoseEdge& edge : registration.edges()) {
        const bool leapt =
            registration.keys()[edge.from].scan < 60 && 60 <= registration.keys()[edge.to].scan;
        if (edge.kind != EdgeKind::odometry || !leapt) continue;
        EXPECT_GE(edge.information.inverse().eval()(2, 2), unsure(2));
    }
    registration.finish();
    EXPECT_LT(greatest_path_error(registration.path(), truth), 0.4);
}

TEST(Registration, ScansWithoutAPointAndStandingStillAreNothingSpecial) {
    Registration registration{RegistrationParams{}};
    const Scan empty;
    for (int i = 0; i < 5; ++i) {
        const RegisteredStep step =
            registration.add(empty, std::vector<Control>{{{0.5, 0.0, 0.0}, 1.0}});
        EXPECT_FALSE(step.matched);
    }
    EXPECT_NEAR(registration.path().back().x, 2.0, 1e-9);
    const Pose there = registration.path().back();
    registration.add(empty, {});
    EXPECT_EQ(registration.path().back(), there);
    registration.finish();
    EXPECT_EQ(registration.path().size(), 6U);
}

TEST(Registration, TheWayBetweenKeysIsAsUnsureAsItsStepsTogether) {
    RegistrationParams params;
    params.key_distance_m = 1.0;
    params.calibrate = false;
    std::vector<Pose> truth;
    for (int i = 0; i < 12; ++i) truth.push_back({0.3 * i, 0.0, 0.0});
    const Driven once = drive(ring_walls(), truth, 0.0, 1.0, params);
    std::size_t edges = 0;
    for (const PoseEdge& edge : once.registration.edges()) {
        if (edge.kind != EdgeKind::odometry) continue;
        ++edges;
        const std::uint64_t steps =
            once.registration.keys()[edge.to].scan - once.registration.keys()[edge.from].scan;
        EXPECT_EQ(steps, 4U);
        const Eigen::Vector3d together =
            static_cast<double>(steps) * odometry_variances({0.3, 0.0, 0.0}, 1.0);
        EXPECT_TRUE(edge.information.inverse().diagonal().isApprox(together, 1e-6));
    }
    EXPECT_EQ(edges, 2U);
}

/// A hall that is unlike itself wherever it is shifted or turned.
Walls far_hall() {
    return test::closed({{-4, -5}, {2, -5},  {2, -4},  {5, -4}, {5, -5}, {17, -5}, {17, -3},
                         {21, -3}, {21, -5}, {26, -5}, {26, 3}, {24, 7}, {11, 7},  {11, 5.5},
                         {9, 5.5}, {9, 7},   {1, 7},   {1, 4},  {-2, 4}, {-2, 7},  {-4, 7}});
}

/// Between two passages of a hall nothing is seen for `blind` steps to and fro; then the robot is
/// elsewhere by `off`. What comes of the loop from there on.
Registration after_blindness(const Pose& off, int blind, double step_m, double scale,
                             double key_distance_m = 2.2) {
    RegistrationParams params;
    params.key_scans = 5;
    params.loops_agree = 1;
    params.key_distance_m = key_distance_m;
    params.key_angle_rad = 2.0;
    params.odometry_scale = scale;
    params.search = false;  // no scan alone finds where it is
    Registration registration(params);
    const auto add = [&](const Scan& scan, double ahead_m) {
        registration.add(scan, std::vector<Control>{{{ahead_m, 0.0, 0.0}, 1.0}});
    };
    const Walls hall = far_hall();
    for (int i = 0; i <= 16; ++i) {
        add(test::drawn_scan(hall, {0.8 * i, 0.0, 0.0}), i > 0 ? 0.8 : 0.0);
    }
    for (int i = 0; i < blind; ++i) add({}, i % 2 == 0 ? -step_m : step_m);
    for (int i = 1; i <= 4; ++i) {
        const Pose at = compose({12.8 + off.x, off.y, off.theta}, {-0.8 * i, 0.0, 0.0});
        add(test::drawn_scan(hall, at), -0.8);
    }
    return registration;
}

double moved_after_blindness(const Pose& off, int blind, double step_m, double scale) {
    return after_blindness(off, blind, step_m, scale).figures().largest_correction_m;
}

TEST(Registration, ALoopIsLookedForAsFarAsAllStepsSinceTheLastKeyAreUnsure) {
    // Steps that are no keys.
    EXPECT_GT(moved_after_blindness({-3.2, 0.0, 0.0}, 16, 2.0, 1.5), 2.5);
    EXPECT_GT(moved_after_blindness({-1.0, -0.5, -0.56}, 200, 1.0, 0.6), 1.0);
}

TEST(Registration, ALoopThatWouldStretchTheGraphIsRefused) {
    // Half a metre off: what an odometry good to centimetres cannot have erred by.
    const Pose off{-0.4, 0.3, 0.0};
    const Registration unsure = after_blindness(off, 20, 1.0, 1.0, 0.7);
    ASSERT_FALSE(unsure.loops().empty());
    EXPECT_NEAR(unsure.figures().largest_correction_m, 0.5, 0.05);
    EXPECT_EQ(unsure.figures().loops_refused, 0U);
    const Registration sure = after_blindness(off, 20, 1.0, 0.05, 0.7);
    EXPECT_TRUE(sure.loops().empty());
    EXPECT_EQ(sure.figures().largest_correction_m, 0.0);
    EXPECT_GT(sure.figures().loops_refused, 0U);
    for (const LoopRecord& refused : sure.refused_loops()) {
        // Where nothing fitted the robot may have been carried: that is looked for too.
        if (refused.verdict == LoopVerdict::alone) continue;
        EXPECT_EQ(refused.verdict, LoopVerdict::strained);
        EXPECT_GT(refused.chi_square.value(), 2.0 * unsure.loops().front().chi_square.value());
        EXPECT_EQ(refused.move_m, 0.0);
    }
}

TEST(Registration, AStepThatSlippedIsLookedForAsFarAsItsWayIsUnsure) {
    // 5.5 m by the odometry: along the way that is unsure by 0.57 m, across it by half of that.
    Walls room;
    for (const auto& [a, b] : test::recess_room()) {
        const Pose turned_room{0.0, 0.0, 0.4};
        room.emplace_back(transform(turned_room, Point2{2.5 * a.x, 2.5 * a.y}),
                          transform(turned_room, Point2{2.5 * b.x, 2.5 * b.y}));
    }
    const Point2 start = transform(Pose{0.0, 0.0, 0.4}, Point2{-7.0, 3.0});
    Registration registration{RegistrationParams{}};
    registration.add(test::drawn_scan(room, {start.x, start.y, 0.0}), {});
    const Control ahead{{5.5, 0.0, 0.0}, 1.0};
    const RegisteredStep step = registration.add(
        test::drawn_scan(room, {start.x + 7.9, start.y, 0.0}), std::span(&ahead, 1));
    EXPECT_TRUE(step.matched);
    EXPECT_NEAR(step.pose.x, 7.9, 0.1);
}

}  // namespace
}  // namespace hitos
