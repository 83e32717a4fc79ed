// SPDX-License-Identifier: GPL-3.0-or-later
// Trees and posts in scans, cast here ray by ray.
#include "circle_extractor.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "hitos/base/geometry.hpp"
#include "hitos/features/extractor.hpp"

namespace hitos {
namespace {

struct Tree {
    Point2 at;
    double radius_m = 0.0;
};
using Wall = std::pair<Point2, Point2>;

/// Half a degree over half a turn, as a SICK outdoors.
Fan half_turn() {
    return {-kPi / 2.0, kPi / 2.0, 361, 80.0, {}};
}

struct Place {
    std::vector<Tree> trees;
    std::vector<Wall> walls = {};

    std::optional<double> range(const Point2& from, double angle) const {
        const Point2 u{std::cos(angle), std::sin(angle)};
        double nearest = std::numeric_limits<double>::infinity();
        for (const Tree& tree : trees) {
            const Point2 m{tree.at.x - from.x, tree.at.y - from.y};
            const double along = m.x * u.x + m.y * u.y;
            const double off = m.x * u.y - m.y * u.x;
            if (along <= 0.0 || std::abs(off) >= tree.radius_m) continue;
            nearest =
                std::min(nearest, along - std::sqrt(tree.radius_m * tree.radius_m - off * off));
        }
        for (const auto& [a, b] : walls) {
            const Point2 d{b.x - a.x, b.y - a.y};
            const Point2 g{a.x - from.x, a.y - from.y};
            const double det = u.y * d.x - u.x * d.y;
            if (std::abs(det) < 1e-12) continue;
            const double along = (g.y * d.x - g.x * d.y) / det;
            const double part = (u.x * g.y - u.y * g.x) / det;
            if (along > 0.0 && part >= 0.0 && part <= 1.0) nearest = std::min(nearest, along);
        }
        if (!std::isfinite(nearest)) return std::nullopt;
        return nearest;
    }

    Scan seen(const Fan& fan, double sigma_m = 0.0, unsigned seed = 1) const {
        std::mt19937 engine(seed);
        std::normal_distribution<double> noise(0.0, 1.0);
        Scan scan;
        scan.fan = fan;
        const Pose& laser = fan.pose_robot_laser;
        bool open = false;
        for (std::uint32_t ray = 0; ray < fan.count; ++ray) {
            const double angle = laser.theta + fan.angle_rad(ray);
            const auto met = range({laser.x, laser.y}, angle);
            const double off = sigma_m * noise(engine);
            if (!met || *met + off > fan.max_range_m) {
                open = false;
                continue;
            }
            if (!open) scan.run_starts.push_back(static_cast<std::uint32_t>(scan.points.size()));
            open = true;
            scan.points.push_back({laser.x + (*met + off) * std::cos(angle),
                                   laser.y + (*met + off) * std::sin(angle)});
            scan.rays.push_back(ray);
        }
        return scan;
    }
};

ExtractionParams with_circles(double sigma_m = 0.01) {
    ExtractionParams params;
    params.circles.find = true;
    params.point_sigma_m = sigma_m;
    return params;
}

Observation found(const Scan& scan, const ExtractionParams& params = with_circles()) {
    Observation out;
    make_extractor(params)->extract(scan, out);
    EXPECT_EQ(out.circle_radii_m.size(), out.corner_covariances.size());
    return out;
}

struct Errors {
    double range_m = 0.0;  // means
    double across_m = 0.0;
    double radius_m = 0.0;
    double distance2 = 0.0;  // of Mahalanobis, by the covariance
    double spread_m = 0.0;   // root of the mean square
    int found = 0;
};

Errors errors_of(double range_m, double radius_m, double sigma_m, const Fan& fan, int times) {
    Errors all;
    for (int i = 0; i < times; ++i) {
        // Everywhere between two rays, and anywhere ahead.
        const double bearing = -1.0 + 2.0 * i / times + fan.pose_robot_laser.theta;
        const Pose& laser = fan.pose_robot_laser;
        const Point2 out{std::cos(bearing), std::sin(bearing)};
        const Tree tree{{laser.x + range_m * out.x, laser.y + range_m * out.y}, radius_m};
        const Observation seen = found(
            Place{{tree}}.seen(fan, sigma_m, static_cast<unsigned>(i) + 1), with_circles(sigma_m));
        if (seen.circle_radii_m.size() != 1) continue;
        ++all.found;
        const Eigen::Vector2d off(seen.corners[0].x - tree.at.x, seen.corners[0].y - tree.at.y);
        all.range_m += off.x() * out.x + off.y() * out.y;
        all.across_m += off.y() * out.x - off.x() * out.y;
        all.radius_m += seen.circle_radii_m[0] - radius_m;
        all.spread_m += off.squaredNorm();
        all.distance2 += off.dot(seen.corner_covariances[0].inverse() * off);
    }
    const double n = all.found;
    return {all.range_m / n,
            all.across_m / n,
            all.radius_m / n,
            all.distance2 / n,
            std::sqrt(all.spread_m / n),
            all.found};
}

struct Looked {
    double range_m;
    double radius_m;
    double sigma_m;
    double spread_m;  // that it may have
};

class Circles : public testing::TestWithParam<Looked> {};

// However many points there are: thirty near by, two far away.
TEST_P(Circles, LieWhereTheyAreToWithinWhatTheyClaim) {
    const auto& [range_m, radius_m, sigma_m, spread_m] = GetParam();
    Fan mounted = half_turn();
    mounted.pose_robot_laser = {1.5, -0.4, 0.3};
    for (const Fan& fan : {half_turn(), mounted}) {
        constexpr int kTimes = 400;
        const Errors off = errors_of(range_m, radius_m, sigma_m, fan, kTimes);
        EXPECT_GE(off.found, kTimes * 97 / 100);
        EXPECT_LT(off.spread_m, spread_m);
        EXPECT_LT(std::abs(off.range_m), 0.5 * spread_m);
        EXPECT_LT(std::abs(off.across_m), 0.25 * spread_m);
        EXPECT_LT(std::abs(off.radius_m), 0.5 * spread_m);
        // Of two numbers, 2 were exact; the floor of one range's sigma claims less near by.
        EXPECT_LT(off.distance2, 3.0);
    }
}

INSTANTIATE_TEST_SUITE_P(
    , Circles,
    testing::Values(Looked{3.0, 0.2, 0.01, 0.012}, Looked{3.0, 0.4, 0.03, 0.015},
                    Looked{8.0, 0.15, 0.01, 0.025}, Looked{8.0, 0.4, 0.03, 0.03},
                    Looked{20.0, 0.3, 0.03, 0.07}, Looked{40.0, 0.36, 0.03, 0.11}));

TEST(CircleFits, AreExactWhereRangesAre) {
    const Tree tree{{4.0, 1.0}, 0.3};
    const Observation seen = found(Place{{tree}}.seen(half_turn()), with_circles(1e-4));
    ASSERT_EQ(seen.circle_radii_m.size(), 1U);
    EXPECT_NEAR(seen.corners[0].x, 4.0, 1e-4);
    EXPECT_NEAR(seen.corners[0].y, 1.0, 1e-4);
    EXPECT_NEAR(seen.circle_radii_m[0], 0.3, 1e-4);
}

TEST(CircleFits, OfTwoPointsAreOfTheirAngle) {
    // Two rays of 0.01 rad at 30 m cover 0.02 rad; ranges that say next to nothing.
    const std::vector<SeenPoint> two = {{0.5, 30.0, 0}, {0.51, 30.0, 1}};
    const auto circle = fit_circle(two, {1.0, 0.01});
    ASSERT_TRUE(circle);
    EXPECT_NEAR(circle->radius_m, circle->range_m * std::sin(0.01), 1e-6);
    const double lateral = 30.0 * std::sin(0.005);
    EXPECT_NEAR(
        circle->range_m,
        30.0 * std::cos(0.005) + std::sqrt(circle->radius_m * circle->radius_m - lateral * lateral),
        1e-6);
    EXPECT_NEAR(circle->bearing_rad, 0.505, 1e-9);
    // Edges anywhere in a step each: the middle to within step / sqrt(24).
    EXPECT_NEAR(std::sqrt(circle->covariance(1, 1)), 0.01 / std::sqrt(24.0), 2e-5);
}

/// From `at` on [rad].
std::vector<double> bearings(double at, double end, double step) {
    std::vector<double> all;
    while (at < end) {
        all.push_back(at);
        at += step;
    }
    return all;
}

// Of the fit itself, which knows no floor.
TEST(CircleFits, AreAsFarOffAsTheirCovarianceSays) {
    const double step = kPi / 360.0;
    std::mt19937 engine(5);
    std::normal_distribution<double> noise(0.0, 1.0);
    std::uniform_real_distribution<double> anywhere(0.0, step);
    for (const auto& [range, radius, sigma] :
         {std::array{3.0, 0.4, 0.03}, {6.0, 0.2, 0.01}, {12.0, 0.3, 0.02}, {40.0, 0.4, 0.03}}) {
        double distance2 = 0.0;
        int fitted = 0;
        for (int i = 0; i < 1000; ++i) {
            std::vector<SeenPoint> seen;
            for (const double at : bearings(anywhere(engine) - 0.3, 0.3, step)) {
                const double off = range * std::sin(at);
                if (std::abs(off) >= radius) continue;
                seen.push_back({at,
                                range * std::cos(at) - std::sqrt(radius * radius - off * off) +
                                    sigma * noise(engine),
                                0});
            }
            const auto circle = fit_circle(seen, {sigma, step});
            if (!circle) continue;
            ++fitted;
            const Eigen::Vector2d off(circle->range_m - range, circle->bearing_rad);
            distance2 += off.dot(circle->covariance.inverse() * off);
        }
        EXPECT_GE(fitted, 980) << range;
        // 2 were exact.
        EXPECT_GT(distance2 / fitted, 1.2) << range;
        EXPECT_LT(distance2 / fitted, 2.6) << range;
    }
}

// Its points lie on a circle, but beyond the last of them the laser saw no more of it.
TEST(CircleFits, OfHalfACircleAreNone) {
    const double step = kPi / 360.0;
    for (const double from : {-0.06, 0.0}) {
        std::vector<SeenPoint> seen;
        for (const double at : bearings(from, 0.06, step)) {
            const double off = 5.0 * std::sin(at);
            if (std::abs(off) >= 0.3) continue;
            seen.push_back({at, 5.0 * std::cos(at) - std::sqrt(0.09 - off * off), 0});
        }
        EXPECT_EQ(fit_circle(seen, {0.001, step}).has_value(), from < 0.0);
    }
}

TEST(CircleFits, KnowTheirBearingRightBehind) {
    const std::vector<SeenPoint> behind = {
        {kPi - 0.01, 5.0, 0}, {kPi, 5.0, 1}, {-kPi + 0.01, 5.0, 2}};
    const auto circle = fit_circle(behind, {0.01, 0.01});
    ASSERT_TRUE(circle);
    EXPECT_NEAR(std::abs(circle->bearing_rad), kPi, 1e-9);
}

TEST(TreesInScans, AreFoundSideBySideAndBeforeAWall) {
    const Place place{{{{6.0, -0.6}, 0.2}, {{6.0, 0.6}, 0.2}, {{5.0, 3.0}, 0.1}},
                      {{{9.0, -8.0}, {9.0, 8.0}}}};
    const Observation seen = found(place.seen(half_turn()));
    ASSERT_EQ(seen.circle_radii_m.size(), 3U);
    ASSERT_EQ(seen.corners.size(), 3U);
    EXPECT_NEAR(seen.corners[0].y, -0.6, 0.01);
    EXPECT_NEAR(seen.corners[1].y, 0.6, 0.01);
    EXPECT_NEAR(seen.corners[2].y, 3.0, 0.02);
    ASSERT_GE(seen.lines.size(), 1U);
    for (const DetectedLine& line : seen.lines) {
        for (const Point2& p : seen.support_of(line)) EXPECT_NEAR(p.x, 9.0, 1e-6);
    }
}

TEST(TreesInScans, AreNotLookedForUnlessSaid) {
    const Scan scan = Place{{{{6.0, 0.0}, 0.3}}}.seen(half_turn());
    EXPECT_TRUE(found(scan, {}).empty());
}

// Each of these is round where it is seen, or looks so, but is not known whole.
TEST(TreesInScans, ThatAreNotSeenWholeAreNone) {
    const Tree tree{{6.0, 0.0}, 0.25};
    EXPECT_EQ(found(Place{{tree}}.seen(half_turn())).circle_radii_m.size(), 1U);
    // Half behind another one, which is seen whole.
    const Tree before{{3.0, 0.12}, 0.1};
    const Observation hidden = found(Place{{tree, before}}.seen(half_turn()));
    ASSERT_EQ(hidden.circle_radii_m.size(), 1U);
    EXPECT_NEAR(hidden.corners[0].x, 3.0, 0.01);
    // At the edge of the scan.
    const Place beside{{{{0.05, 4.0}, 0.25}, {{0.05, -4.0}, 0.25}}};
    EXPECT_TRUE(found(beside.seen(half_turn())).circle_radii_m.empty());
    // What is seen of a wall through a gap.
    const Place gap{
        {}, {{{3.0, -4.0}, {3.0, -0.1}}, {{3.0, 0.1}, {3.0, 4.0}}, {{9.0, -4.0}, {9.0, 4.0}}}};
    EXPECT_TRUE(found(gap.seen(half_turn())).circle_radii_m.empty());
}

TEST(TreesInScans, AreRoundThinAndAlone) {
    const auto count = [](const Place& place, const ExtractionParams& params = with_circles()) {
        return found(place.seen(half_turn()), params).circle_radii_m.size();
    };
    ExtractionParams params = with_circles();
    // Flat, and with an edge towards the laser.
    EXPECT_EQ(count({{}, {{{4.0, -0.3}, {4.0, 0.3}}}}), 0U);
    EXPECT_EQ(count({{}, {{{4.3, -0.3}, {4.0, 0.0}}, {{4.0, 0.0}, {4.3, 0.3}}}}), 0U);
    // Thick.
    const Place thick{{{{6.0, 0.0}, 0.6}}};
    EXPECT_EQ(count(thick), 0U);
    params.circles.max_radius_m = 0.7;
    EXPECT_EQ(count(thick, params), 1U);
    // Twigs: as near to each other as to what may be one thing.
    const Place bush{{{{6.0, -0.4}, 0.06}, {{6.3, -0.1}, 0.06}, {{6.0, 0.2}, 0.06}}};
    EXPECT_EQ(count(bush), 0U);
    const Place before_a_wall{bush.trees, {{{9.0, -8.0}, {9.0, 8.0}}}};  // seen between them
    EXPECT_EQ(count(before_a_wall), 0U);
    params = with_circles();
    params.circles.gap_m = 0.15;
    EXPECT_EQ(count(bush, params), 3U);
    // A wall close behind, and the end of one.
    const Tree tree{{6.0, 0.0}, 0.2};
    EXPECT_EQ(count({{tree}, {{{6.2, -3.0}, {6.2, 3.0}}}}), 0U);
    EXPECT_EQ(count({{tree}, {{{7.4, -3.0}, {7.4, 3.0}}}}), 1U);
    EXPECT_EQ(count({{tree}, {{{6.0, 0.1}, {6.0, 3.0}}}}), 0U);
    // Points.
    params = with_circles();
    EXPECT_EQ(count({{{{20.0, 0.1}, 0.2}}}, params), 1U);
    params.circles.min_points = 3;
    EXPECT_EQ(count({{{{20.0, 0.1}, 0.2}}}, params), 0U);
}

TEST(TreesInScans, AreTheSameWhicheverWayTheLaserTurnsAndWhereverItBegins) {
    const Place place{{{{5.0, 0.05}, 0.25}, {{-4.0, 0.02}, 0.3}, {{1.0, -6.0}, 0.2}},
                      {{{-9.0, -9.0}, {9.0, -9.0}},
                       {{9.0, -9.0}, {9.0, 9.0}},
                       {{9.0, 9.0}, {-9.0, 9.0}},
                       {{-9.0, 9.0}, {-9.0, -9.0}}}};
    constexpr std::uint32_t kRays = 720;
    const double step = 2.0 * kPi / kRays;
    for (int begin = 0; begin < 8; ++begin) {
        const double first = begin * kPi / 4.0;
        for (const double way : {1.0, -1.0}) {
            const Fan fan{first, first + way * (2.0 * kPi - step), kRays, 80.0, {}};
            const Observation seen = found(place.seen(fan));
            ASSERT_EQ(seen.circle_radii_m.size(), 3U) << begin << " " << way;
            double radii = 0.0;
            for (const double radius : seen.circle_radii_m) radii += radius;
            EXPECT_NEAR(radii, 0.75, 0.02);
        }
    }
}

// Between the two nothing is met over more than half a turn, or nearly a whole one.
TEST(TreesInScans, AreFoundWhateverLiesBetweenThem) {
    for (const double behind : {-2.0, -0.5, 3.0}) {
        const Place place{{{{behind, 4.0}, 0.3}, {{behind, -4.0}, 0.2}}};
        for (const double way : {1.0, -1.0}) {
            const double half = way * 0.75 * kPi;
            const Observation seen = found(place.seen({-half, half, 541, 20.0, {}}));
            ASSERT_EQ(seen.circle_radii_m.size(), 2U) << behind << " " << way;
            EXPECT_NEAR(seen.circle_radii_m[0] + seen.circle_radii_m[1], 0.5, 0.02);
        }
    }
}

TEST(TreesInScans, AreFoundWhereNobodySaysWhichRaysThereAre) {
    const Place place{{{{5.0, 0.0}, 0.25}, {{6.0, 3.0}, 0.3}, {{4.0, -3.0}, 0.2}}};
    Scan scan = place.seen(half_turn());
    scan.fan = {};
    scan.rays.clear();
    // The first and the last thing may be at the edge of what the laser sees.
    const Observation seen = found(scan);
    ASSERT_EQ(seen.circle_radii_m.size(), 1U);
    EXPECT_NEAR(seen.corners[0].x, 5.0, 0.01);
}

TEST(TreesInScans, ComeBeforeCornersAndWhatASensorTold) {
    const Place place{{{{5.0, 0.0}, 0.25}}, {{{9.0, -8.0}, {9.0, 4.0}}, {{9.0, 4.0}, {2.0, 4.0}}}};
    Scan scan = place.seen(half_turn());
    scan.landmarks = {{2.0, 0.1, 7}};
    ExtractionParams params = with_circles();
    params.corner_distance_m = 0.5;
    const Observation seen = found(scan, params);
    ASSERT_EQ(seen.circle_radii_m.size(), 1U);
    ASSERT_EQ(seen.corners.size(), 3U);
    EXPECT_NEAR(seen.corners[0].x, 5.0, 0.01);
    EXPECT_NEAR(seen.corners[1].x, 9.0, 0.1);
    EXPECT_EQ(seen.identities, (std::vector<std::int32_t>{-1, -1, 7}));
    // The common part stands for trunks that are not round.
    params.common_sigma_m = 0.1;
    const Observation rough = found(scan, params);
    EXPECT_NEAR(rough.corner_covariances[0].trace() - seen.corner_covariances[0].trace(), 0.02,
                1e-9);
    params.covariance = ObservationCovariance::points;
    Observation all;
    make_extractor(params)->extract(scan, all);
    EXPECT_EQ(all.corner_covariances.size(), 2U);
}

}  // namespace
}  // namespace hitos
