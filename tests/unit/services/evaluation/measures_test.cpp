// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/evaluation/measures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

namespace hitos {
namespace {

ICaracteristica line(double rho, double theta) {
    return {normalized(Recta{rho, theta})};
}
ICaracteristica corner(double x, double y) {
    return {Esquina{x, y}};
}

LandmarkMap moved(const LandmarkMap& map, const Pose& pose) {
    LandmarkMap out;
    for (const ICaracteristica& landmark : map) out.push_back(transform(pose, landmark));
    return out;
}

/// A room of 10 x 8 m with its corners and a slanted wall.
LandmarkMap room() {
    return {line(1.0, kPi),       line(9.0, 0.0),   line(2.0, -kPi / 2.0),
            line(6.0, kPi / 2.0), line(4.0, 0.7),   corner(-1.0, -2.0),
            corner(9.0, -2.0),    corner(9.0, 6.0), corner(-1.0, 6.0)};
}

/// The sum of squared distances that the alignment lowers, by brute force.
double sum_of_squares(const LandmarkMap& map, const LandmarkMap& reference) {
    double sum = 0.0;
    for (const ICaracteristica& a : map) {
        double best = HUGE_VAL;
        for (const ICaracteristica& b : reference) {
            if (a.kind() != b.kind()) continue;
            best = std::min(best, std::hypot(a.point().x - b.point().x, a.point().y - b.point().y));
        }
        if (best < HUGE_VAL) sum += best * best;
    }
    return sum;
}

ICaracteristica named(double x, double y, std::int32_t identity) {
    ICaracteristica landmark = corner(x, y);
    landmark.identity = identity;
    return landmark;
}

TEST(MapError, WhereBothMapsHaveNamesIsThatOfNamesakes) {
    const LandmarkMap reference = {named(0, 0, 1), named(4, 0, 2), named(4, 3, 3)};
    const LandmarkMap map = {named(4, 1, 1), named(4, 2, 2), named(9, 9, 7), corner(4, 3)};
    const MapError error = map_error(map, reference).value();
    EXPECT_EQ(error.landmarks, 2);
    EXPECT_EQ(error.without_reference, 2);
    EXPECT_EQ(error.reference_found, 2);
    EXPECT_DOUBLE_EQ(error.mean_m, (std::hypot(4.0, 1.0) + 2.0) / 2.0);
    // Where only one of them has, the nearest.
    EXPECT_EQ(map_error(map, {corner(4, 1), corner(4, 3)}).value().landmarks, 4);
}

TEST(AlignedMapError, OfMapsWithNamesNeedsNoFrameInCommon) {
    LandmarkMap reference;
    for (int i = 0; i < 9; ++i) reference.push_back(named(3.0 * (i % 3), 2.0 * i, i));
    const Pose pose{-40.0, 25.0, 2.9};
    const AlignedMapError aligned = aligned_map_error(moved(reference, pose), reference).value();
    EXPECT_LT(aligned.error.maximum_m, 1e-9);
    EXPECT_EQ(aligned.error.reference_found, 9);
    EXPECT_NEAR(wrap_angle(aligned.pose_reference_map.theta + pose.theta), 0.0, 1e-12);
}

TEST(MapError, IsTheMeanDistanceToTheNearestOfTheSameKind) {
    const LandmarkMap reference = {line(2.0, 0.0), line(5.0, kPi / 2.0), corner(0.0, 0.0)};
    // The corner lies on the foot of a line, which is of another kind.
    const LandmarkMap map = {line(2.5, 0.0), line(1.0, 0.0), corner(3.0, 4.0), corner(2.0, 0.0)};
    const MapError error = map_error(map, reference).value();
    EXPECT_DOUBLE_EQ(error.mean_m, (0.5 + 1.0 + 5.0 + 2.0) / 4.0);
    EXPECT_DOUBLE_EQ(error.maximum_m, 5.0);
    EXPECT_EQ(error.landmarks, 4);
    EXPECT_EQ(error.lines, 2);
    EXPECT_EQ(error.corners, 2);
    EXPECT_EQ(error.without_reference, 0);
    EXPECT_EQ(error.reference_landmarks, 3);
    // Nothing is within a metre of the second line, nor of the corner.
    EXPECT_EQ(error.reference_found, 1);
}

TEST(MapError, LinesAreComparedByTheirFeet) {
    const MapError error = map_error({line(3.0, 0.0)}, {line(4.0, kPi / 2.0)}).value();
    EXPECT_DOUBLE_EQ(error.mean_m, 5.0);
    // (rho, theta) and (-rho, theta + pi) are one line.
    EXPECT_NEAR(map_error({{Recta{-3.0, kPi}}}, {line(3.0, 0.0)})->mean_m, 0.0, 1e-15);
}

TEST(MapError, CountsLandmarksWithoutAReference) {
    const MapError error = map_error({line(1.0, 0.0), corner(1.0, 1.0)}, {line(1.5, 0.0)}).value();
    EXPECT_DOUBLE_EQ(error.mean_m, 0.5);
    EXPECT_EQ(error.landmarks, 1);
    EXPECT_EQ(error.corners, 0);
    EXPECT_EQ(error.without_reference, 1);
}

TEST(MapError, IsNothingWhereNothingCanBeCompared) {
    EXPECT_FALSE(map_error({}, room()).has_value());
    EXPECT_FALSE(map_error(room(), {}).has_value());
    EXPECT_FALSE(map_error({line(1.0, 0.0)}, {corner(1.0, 0.0)}).has_value());
    // Of a wrong reference the squares may become less and the mean greater.
    const LandmarkMap near{corner(0.0, 0.0), corner(1.0, 0.0), corner(2.0, 0.0)};
    const LandmarkMap wrong{corner(0.0, 0.0), corner(1.0, 0.0), corner(2.0, 9.0)};
    const auto wrongly = aligned_map_error(near, {corner(0.0, 0.0), corner(1.0, 9.0)});
    EXPECT_LE(wrongly->error.mean_m, map_error(near, {corner(0.0, 0.0), corner(1.0, 9.0)})->mean_m);
    EXPECT_LE(aligned_map_error(near, wrong)->error.mean_m, map_error(near, wrong)->mean_m);
    EXPECT_FALSE(aligned_map_error({}, room()).has_value());
    EXPECT_FALSE(aligned_map_error({line(1.0, 0.0)}, {corner(1.0, 0.0)}).has_value());
}

TEST(MapError, OfAMapAgainstItselfIsZero) {
    const MapError error = map_error(room(), room()).value();
    EXPECT_EQ(error.mean_m, 0.0);
    EXPECT_EQ(error.reference_found, 9);
}

TEST(AlignedMapError, UndoesARigidMotion) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> shifts(-0.5, 0.5);
    std::uniform_real_distribution<double> turns(-0.05, 0.05);
    for (int i = 0; i < 100; ++i) {
        const Pose pose{shifts(random), shifts(random), turns(random)};
        const LandmarkMap map = moved(room(), inverse(pose));
        const AlignedMapError aligned = aligned_map_error(map, room()).value();
        EXPECT_NEAR(aligned.error.mean_m, 0.0, 1e-9);
        EXPECT_NEAR(aligned.pose_reference_map.x, pose.x, 1e-8);
        EXPECT_NEAR(aligned.pose_reference_map.y, pose.y, 1e-8);
        EXPECT_NEAR(aligned.pose_reference_map.theta, pose.theta, 1e-8);
        EXPECT_GT(map_error(map, room())->mean_m, 1e-3);
    }
}

TEST(AlignedMapError, FindsPairsAnew) {
    // The turn puts far corners nearer to wrong partners at first.
    std::mt19937_64 random(12);
    std::uniform_real_distribution<double> places(-10.0, 10.0);
    LandmarkMap reference;
    for (int i = 0; i < 30; ++i) reference.push_back(corner(places(random), places(random)));
    const Pose pose{0.1, -0.2, 0.12};
    const LandmarkMap map = moved(reference, inverse(pose));
    const AlignedMapError aligned = aligned_map_error(map, reference).value();
    EXPECT_NEAR(aligned.error.mean_m, 0.0, 1e-9);
    EXPECT_EQ(aligned.error.reference_found, 30);
    EXPECT_LT(map_error(map, reference)->reference_found, 28);
}

TEST(AlignedMapError, IsAMinimumAndNeverWorseThanNoMotion) {
    std::mt19937_64 random(2);
    std::normal_distribution<double> noise(0.0, 0.2);
    std::uniform_real_distribution<double> places(-10.0, 10.0);
    std::uniform_real_distribution<double> angles(-kPi, kPi);
    int better = 0;
    for (int i = 0; i < 100; ++i) {
        LandmarkMap map = moved(room(), {noise(random), noise(random), 0.1 * noise(random)});
        for (ICaracteristica& landmark : map) {
            if (auto* recta = std::get_if<Recta>(&landmark.value)) {
                *recta =
                    normalized({recta->rho + noise(random), recta->theta + 0.1 * noise(random)});
            } else {
                std::get<Esquina>(landmark.value).x += noise(random);
            }
        }
        map.push_back(line(std::abs(places(random)), angles(random)));  // found by mistake
        const AlignedMapError aligned = aligned_map_error(map, room()).value();
        const Pose& pose = aligned.pose_reference_map;
        const double cost = sum_of_squares(moved(map, pose), room());
        EXPECT_LE(cost, sum_of_squares(map, room()));
        EXPECT_DOUBLE_EQ(aligned.error.mean_m, map_error(moved(map, pose), room())->mean_m);
        EXPECT_LE(aligned.error.mean_m, map_error(map, room())->mean_m);
        if (pose.theta == 0.0) continue;  // what was found by mistake draws it to a greater mean
        ++better;
        for (const double step : {1e-3, -1e-3}) {
            for (const Pose& near :
                 {Pose{pose.x + step, pose.y, pose.theta}, Pose{pose.x, pose.y + step, pose.theta},
                  Pose{pose.x, pose.y, pose.theta + step}}) {
                EXPECT_GE(sum_of_squares(moved(map, near), room()), cost * (1.0 - 1e-9));
            }
        }
    }
    EXPECT_GT(better, 40);
}

TEST(AlignedMapError, LeavesWhatParallelLinesDoNotFix) {
    for (int i = 0; i < 100; ++i) {
        const double theta = 0.06 * i;
        const LandmarkMap reference = {line(1.0, theta), line(2.0, theta + kPi), line(4.0, theta)};
        const LandmarkMap map = {line(1.25, theta), line(1.76, theta + kPi), line(4.24, theta)};
        const Pose pose = aligned_map_error(map, reference)->pose_reference_map;
        const double across = pose.x * std::cos(theta) + pose.y * std::sin(theta);
        const double along = pose.y * std::cos(theta) - pose.x * std::sin(theta);
        EXPECT_NEAR(across, -0.73 / 3.0, 1e-6);
        EXPECT_NEAR(along, 0.0, 1e-6);
        EXPECT_NEAR(pose.theta, 0.0, 1e-6);
    }
}

// ---- trajectories

Trajectory wavy(int poses) {
    Trajectory trajectory;
    for (int i = 0; i < poses; ++i) {
        const double t = 0.1 * i;
        trajectory.push_back({t, {3.0 * t, 2.0 * std::sin(t), wrap_angle(std::atan(std::cos(t)))}});
    }
    return trajectory;
}

Trajectory moved(const Trajectory& trajectory, const Pose& pose) {
    Trajectory out;
    for (const StampedPose& p : trajectory) out.push_back({p.time_s, compose(pose, p.pose)});
    return out;
}

Trajectory shaken(Trajectory trajectory, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> noise(0.0, 0.3);
    for (StampedPose& p : trajectory) {
        p.pose = {p.pose.x + noise(random), p.pose.y + noise(random),
                  wrap_angle(p.pose.theta + 0.1 * noise(random))};
    }
    return trajectory;
}

TEST(TrajectoryError, OfARigidlyMovedTrajectoryIsZero) {
    const Pose pose{3.0, -7.0, 2.5};
    const TrajectoryError error =
        trajectory_error(moved(wavy(100), inverse(pose)), wavy(100)).value();
    EXPECT_NEAR(error.rmse_m, 0.0, 1e-12);
    EXPECT_NEAR(error.heading_rmse_rad.value(), 0.0, 1e-12);
    EXPECT_EQ(error.poses, 100);
    EXPECT_NEAR(error.pose_reference_estimate.x, pose.x, 1e-11);
    EXPECT_NEAR(error.pose_reference_estimate.y, pose.y, 1e-11);
    EXPECT_NEAR(error.pose_reference_estimate.theta, pose.theta, 1e-12);
}

TEST(TrajectoryError, KnownAnswer) {
    // Along x: a stretch by 2 leaves 1, 0, 1 m; the headings are off by 0.1, 0, -0.2 rad.
    const Trajectory reference = {
        {0.0, {0.0, 0.0, 0.0}}, {1.0, {1.0, 0.0, 0.0}}, {2.0, {2.0, 0.0, 0.0}}};
    const Trajectory estimate = {
        {0.0, {-1.0, 0.0, 0.1}}, {1.0, {1.0, 0.0, 0.0}}, {2.0, {3.0, 0.0, -0.2}}};
    const TrajectoryError error = trajectory_error(estimate, reference).value();
    EXPECT_NEAR(error.rmse_m, std::sqrt(2.0 / 3.0), 1e-14);
    EXPECT_NEAR(error.mean_m, 2.0 / 3.0, 1e-14);
    EXPECT_NEAR(error.maximum_m, 1.0, 1e-14);
    EXPECT_NEAR(error.heading_rmse_rad.value(), std::sqrt(0.05 / 3.0), 1e-14);
}

TEST(TrajectoryError, HeadingsAreComparedModuloATurnAndAfterAlignment) {
    Trajectory reference = wavy(50);
    Trajectory estimate = moved(reference, {0.0, 0.0, kPi / 2.0});
    for (StampedPose& p : estimate) p.pose.theta += 0.2 + 6.0 * kPi;
    EXPECT_NEAR(trajectory_error(estimate, reference)->heading_rmse_rad.value(), 0.2, 1e-12);
}

TEST(TrajectoryError, DoesNotDependOnTheFrames) {
    const Trajectory reference = wavy(200);
    const Trajectory estimate = shaken(reference, 3);
    const TrajectoryError error = trajectory_error(estimate, reference).value();
    EXPECT_GT(error.rmse_m, 0.2);
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> shifts(-100.0, 100.0);
    for (int i = 0; i < 50; ++i) {
        const Trajectory a = moved(estimate, {shifts(random), shifts(random), shifts(random)});
        const Trajectory b = moved(reference, {shifts(random), shifts(random), shifts(random)});
        const TrajectoryError other = trajectory_error(a, b).value();
        EXPECT_NEAR(other.rmse_m, error.rmse_m, 1e-9);
        EXPECT_NEAR(other.mean_m, error.mean_m, 1e-9);
        EXPECT_NEAR(other.maximum_m, error.maximum_m, 1e-9);
        EXPECT_NEAR(other.heading_rmse_rad.value(), error.heading_rmse_rad.value(), 1e-9);
    }
}

double rmse(const Trajectory& estimate, const Trajectory& reference, const Pose& pose) {
    double sum = 0.0;
    for (std::size_t i = 0; i < estimate.size(); ++i) {
        const Pose p = compose(pose, estimate[i].pose);
        sum += std::pow(p.x - reference[i].pose.x, 2) + std::pow(p.y - reference[i].pose.y, 2);
    }
    return std::sqrt(sum / static_cast<double>(estimate.size()));
}

TEST(TrajectoryError, AgreesWithASlowSearch) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        const Trajectory reference = wavy(60);
        const Trajectory estimate = shaken(moved(reference, {1.0, 2.0, 2.0}), seed);
        // Pattern search over (x, y, theta) about a coarse scan of the angle.
        Pose best;
        for (int i = -63; i < 63; ++i) {
            const double theta = 0.05 * i;
            const Pose middle = compose({0.0, 0.0, theta}, estimate[30].pose);
            const Pose tried{reference[30].pose.x - middle.x, reference[30].pose.y - middle.y,
                             theta};
            if (rmse(estimate, reference, tried) < rmse(estimate, reference, best)) best = tried;
        }
        for (double step = 0.5; step > 1e-8;) {
            Pose next = best;
            for (int dx = -1; dx <= 1; ++dx) {
                for (int dy = -1; dy <= 1; ++dy) {
                    for (int turn = -1; turn <= 1; ++turn) {
                        const Pose tried{best.x + step * dx, best.y + step * dy,
                                         best.theta + 0.1 * step * turn};
                        if (rmse(estimate, reference, tried) < rmse(estimate, reference, next)) {
                            next = tried;
                        }
                    }
                }
            }
            if (next == best) step /= 2.0;
            best = next;
        }
        const TrajectoryError error = trajectory_error(estimate, reference).value();
        EXPECT_NEAR(error.rmse_m, rmse(estimate, reference, best), 1e-9);
        EXPECT_LE(error.rmse_m, rmse(estimate, reference, best) + 1e-12);
        EXPECT_NEAR(error.pose_reference_estimate.theta, wrap_angle(best.theta), 1e-5);
    }
}

TEST(TrajectoryError, ComparesPosesWhoseStampsAgree) {
    Trajectory reference = wavy(10);
    Trajectory estimate = wavy(10);
    for (Trajectory* path : {&reference, &estimate}) {
        for (StampedPose& pose : *path) pose.time_s *= 10.0;  // too far apart to interpolate
    }
    estimate.erase(estimate.begin() + 3);
    estimate[5].time_s += 0.03;                     // beyond the tolerance
    estimate[6].time_s += 0.015;                    // within it
    estimate.push_back({50.0, {100.0, 0.0, 0.0}});  // without a partner
    std::ranges::reverse(estimate);                 // the order does not matter
    const TrajectoryError error = trajectory_error(estimate, reference).value();
    EXPECT_EQ(error.poses, 8);
    EXPECT_NEAR(error.maximum_m, 0.0, 1e-12);
    EXPECT_EQ(trajectory_error(estimate, reference, 0.04)->poses, 9);
    EXPECT_EQ(trajectory_error(estimate, reference, 0.0)->poses, 7);
}

/// Of all pairs that are left, the nearest in time, again and again.
int slow_pairs(const Trajectory& a, const Trajectory& b, double tolerance_s) {
    std::vector<char> used_a(a.size());
    std::vector<char> used_b(b.size());
    for (int count = 0;; ++count) {
        double best = tolerance_s;
        std::optional<std::pair<std::size_t, std::size_t>> pair;
        for (std::size_t i = 0; i < a.size(); ++i) {
            for (std::size_t k = 0; k < b.size(); ++k) {
                const double apart = std::abs(a[i].time_s - b[k].time_s);
                if (used_a[i] == 0 && used_b[k] == 0 && apart <= best) {
                    best = apart;
                    pair = {i, k};
                }
            }
        }
        if (!pair) return count;
        used_a[pair->first] = used_b[pair->second] = 1;
    }
}

TEST(TrajectoryError, PairsEveryPoseOnceNearestFirst) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> times(0.0, 300.0);
    std::uniform_real_distribution<double> early(0.0, 1.9);
    for (int i = 0; i < 200; ++i) {
        Trajectory a(30);
        Trajectory b(25);
        for (StampedPose& p : a) p.time_s = times(random);
        double after_s = 0.0;  // too far apart to interpolate
        for (StampedPose& p : b) p.time_s = (after_s += 12.0) + early(random);
        EXPECT_EQ(trajectory_error(a, b, 5.0)->poses, slow_pairs(a, b, 5.0));
    }
    // Two estimates near one reference: only the nearer counts.
    const Trajectory reference = {{1.0, {}}, {5.0, {4.0, 0.0, 0.0}}};
    const Trajectory estimate = {{0.99, {9.0, 9.0, 0.0}}, {1.001, {}}, {5.0, {4.0, 0.0, 0.0}}};
    EXPECT_EQ(trajectory_error(estimate, reference)->poses, 2);
    EXPECT_NEAR(trajectory_error(estimate, reference)->rmse_m, 0.0, 1e-15);
}

TEST(TrajectoryError, IsInterpolatedBetweenPosesThatAreNear) {
    // A turn through pi at 4 Hz, and what drives it between: straight from pose to pose.
    const Trajectory reference = {
        {0.0, {0.0, 0.0, 3.0}}, {0.25, {1.0, 0.0, -3.0}}, {0.5, {1.0, 1.0, -3.0}}};
    Trajectory estimate;
    for (const double time : {0.1, 0.125, 0.2, 0.3, 0.4}) {
        const double along = time / 0.25;
        estimate.push_back(
            {time, along < 1.0 ? Pose{along, 0.0, wrap_angle(3.0 + along * (2.0 * kPi - 6.0))}
                               : Pose{1.0, along - 1.0, -3.0}});
    }
    const auto error = trajectory_error(estimate, reference);
    ASSERT_TRUE(error.has_value());
    EXPECT_EQ(error->poses, 5);
    EXPECT_NEAR(error->maximum_m, 0.0, 1e-12);
    EXPECT_NEAR(error->heading_rmse_rad.value(), 0.0, 1e-12);
    // At 1 Hz only who allows for it is told.
    Trajectory slow = reference;
    for (StampedPose& pose : slow) pose.time_s *= 4.0;
    for (StampedPose& pose : estimate) pose.time_s *= 4.0;
    EXPECT_FALSE(trajectory_error(estimate, slow).has_value());
    EXPECT_EQ(trajectory_error(estimate, slow, 0.5)->poses, 5);
    EXPECT_NEAR(trajectory_error(estimate, slow, 0.5)->maximum_m, 0.0, 1e-12);
    // What lies outside is not continued.
    EXPECT_FALSE(trajectory_error({{2.1, {}}}, slow).has_value());
}

TEST(TrajectoryError, IsNothingWithoutCommonStamps) {
    EXPECT_FALSE(trajectory_error({}, wavy(3)).has_value());
    EXPECT_FALSE(trajectory_error(wavy(3), {}).has_value());
    EXPECT_FALSE(trajectory_error({{100.0, {}}}, wavy(3)).has_value());
    EXPECT_FALSE(trajectory_error({{std::nan(""), {}}}, {{std::nan(""), {}}}).has_value());
}

TEST(TrajectoryError, ARobotAtRestFixesNoRotation) {
    // Rounding alone tells the places apart, and it would turn the robot by pi/2.
    const Trajectory estimate = {{0.0, {1.0, 2.0, 0.5}},
                                 {1.0, {std::nextafter(1.0, 2.0), 2.0, 0.5}}};
    const Trajectory reference = {{0.0, {5.0, 5.0, 0.75}},
                                  {1.0, {5.0, std::nextafter(5.0, 6.0), 0.75}}};
    const TrajectoryError error = trajectory_error(estimate, reference).value();
    EXPECT_EQ(error.pose_reference_estimate.theta, 0.0);
    EXPECT_NEAR(error.pose_reference_estimate.x, 4.0, 1e-14);
    EXPECT_NEAR(error.pose_reference_estimate.y, 3.0, 1e-14);
    EXPECT_NEAR(error.rmse_m, 0.0, 1e-14);
    EXPECT_DOUBLE_EQ(error.heading_rmse_rad.value(), 0.25);
}

// Positions that no decomposition takes leave the rotation open; the figures say so.
TEST(TrajectoryError, OfPositionsThatOverflowIsNotFinite) {
    Trajectory estimate = wavy(10);
    estimate[3].pose.x = 1e300;
    const TrajectoryError error = trajectory_error(estimate, wavy(10)).value();
    EXPECT_EQ(error.pose_reference_estimate.theta, 0.0);
    EXPECT_FALSE(std::isfinite(error.rmse_m));
}

TEST(TrajectoryError, PlacesATenthOfAMillimetreApartFixTheRotation) {
    Trajectory small = wavy(50);
    for (StampedPose& p : small) p.pose = {1e-4 * p.pose.x, 1e-4 * p.pose.y, p.pose.theta};
    const TrajectoryError error = trajectory_error(moved(small, {3.0, -7.0, 0.7}), small).value();
    EXPECT_NEAR(error.pose_reference_estimate.theta, -0.7, 1e-6);
    EXPECT_NEAR(error.heading_rmse_rad.value(), 0.0, 1e-6);
}

}  // namespace
}  // namespace hitos
