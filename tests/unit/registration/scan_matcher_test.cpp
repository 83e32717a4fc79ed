// SPDX-License-Identifier: GPL-3.0-or-later
#include "scan_matcher.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "drawn_scan.hpp"

namespace hitos {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

PointMap matched_map_of(const Walls& walls, const std::vector<Pose>& poses) {
    PointMap map;
    map.begin({0.0, 0.0}, 45.0);
    for (std::size_t i = 0; i < poses.size(); ++i) {
        map.add(test::drawn_points(walls, poses[i]), poses[i], static_cast<std::uint32_t>(i));
    }
    map.build();
    return map;
}

/// The prior of somebody who knows nothing.
PosePrior ignorant(const Pose& mean) {
    return {mean, 1e-9 * Matrix3d::Identity(), false};
}

/// Mean distance across the map's surfaces, weighted as the matcher weighs it: what H and b are
/// derivatives of while neighbours and weights stay.
double cost(const std::vector<SurfacePoint>& scan, const PointMap& map, const Pose& held,
            const Pose& pose) {
    double sum = 0.0;
    for (const SurfacePoint& p : scan) {
        const Point2 q{static_cast<double>(p.x), static_cast<double>(p.y)};
        const Point2 at = transform(held, q);
        const MapPoint* near = map.nearest(at.x, at.y, kFineStage.radius_m);
        if (near == nullptr || !near->has_normal()) continue;
        const double c = std::cos(held.theta);
        const double s = std::sin(held.theta);
        const auto nx = static_cast<double>(near->nx);
        const auto ny = static_cast<double>(near->ny);
        if (p.has_normal()) {
            const auto px = static_cast<double>(p.nx);
            const auto py = static_cast<double>(p.ny);
            if ((c * px - s * py) * nx + (s * px + c * py) * ny < 0.5) continue;
        }
        const auto across = [&](const Point2& point) {
            return (point.x - static_cast<double>(near->x)) * nx +
                   (point.y - static_cast<double>(near->y)) * ny;
        };
        const double there = across(at);
        const double half2 = kFineStage.half_weight_m * kFineStage.half_weight_m;
        const double now = across(transform(pose, q));
        sum += 0.5 * now * now / (1.0 + there * there / half2);
    }
    return sum;
}

TEST(ScanMatcher, TheLinearizationIsThatOfItsCost) {
    const Walls room = test::recess_room();
    const PointMap map = matched_map_of(room, {{0.0, 0.0, 0.3}, {0.3, 0.1, 1.9}});
    // Only points with surfaces, so that the cost above is the whole cost.
    std::vector<SurfacePoint> scan = test::drawn_points(room, {0.1, 0.0, 0.5});
    std::erase_if(scan, [](const SurfacePoint& p) { return !p.has_normal(); });
    const Pose pose{0.14, -0.03, 0.51};
    const Linearization l = ScanMatcher(0.1).linearize(scan, map, pose, kFineStage);
    ASSERT_GT(l.matches, 100);
    const double step = 1e-5;
    const auto at = [&](int component, double by) {
        Pose moved = pose;
        (component == 0 ? moved.x : component == 1 ? moved.y : moved.theta) += by;
        return cost(scan, map, pose, moved);
    };
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(l.b(i), (at(i, step) - at(i, -step)) / (2.0 * step), 1e-3 * l.b.norm()) << i;
    }
}

TEST(ScanMatcher, FindsTheWayBackToTheTruth) {
    const Walls room = test::recess_room();
    const PointMap map =
        matched_map_of(room, {{0.0, 0.0, 0.3}, {0.3, 0.1, 1.9}, {-0.5, 0.2, -2.0}});
    const Pose truth{0.2, 0.1, 0.4};
    const std::vector<SurfacePoint> scan = test::drawn_points(room, truth);
    const ScanMatcher matcher(0.1);
    for (const Pose& off : {Pose{0.2, -0.15, 0.05}, Pose{-0.25, 0.1, -0.08}, Pose{0.0, 0.3, 0.1}}) {
        const Pose start{truth.x + off.x, truth.y + off.y, truth.theta + off.theta};
        const Pose found = matcher.fit(scan, map, start, ignorant(start));
        EXPECT_NEAR(found.x, truth.x, 0.005);
        EXPECT_NEAR(found.y, truth.y, 0.005);
        EXPECT_NEAR(found.theta, truth.theta, 0.002);
        EXPECT_GT(match_score(scan, map, found, 1), 0.95);
        EXPECT_LT(match_score(scan, map, start, 1), 0.9);
    }
}

TEST(ScanMatcher, ACorridorLeavesItsDirectionToThePrior) {
    const Walls corridor{{{-40.0, -1.0}, {40.0, -1.0}}, {{-40.0, 1.0}, {40.0, 1.0}}};
    const PointMap map = matched_map_of(corridor, {{0.0, 0.0, 0.0}, {0.0, 0.0, kPi}});
    const std::vector<SurfacePoint> scan = test::drawn_points(corridor, {0.5, 0.1, 0.02});
    Matrix3d information = Matrix3d::Zero();
    information.diagonal() << 1.0 / (0.03 * 0.03), 1.0 / (0.03 * 0.03), 1.0 / (0.03 * 0.03);
    const PosePrior prior{{0.47, 0.05, 0.0}, information, true};
    const Pose found = ScanMatcher(0.1).fit(scan, map, prior.mean, prior);
    EXPECT_NEAR(found.x, 0.47, 0.01);  // as the prior says
    EXPECT_NEAR(found.y, 0.1, 0.01);   // as the walls say
    EXPECT_NEAR(found.theta, 0.02, 0.005);
}

TEST(ScanMatcher, ItsCovarianceCoversWhatNoiseDoes) {
    // sigma is the share of errors in common, ten times the noise here: the scatter of the matches
    // over many draws must lie inside the stated covariance, in every direction.
    const Walls room = test::recess_room();
    const PointMap map =
        matched_map_of(room, {{0.0, 0.0, 0.3}, {0.3, 0.1, 1.9}, {-0.5, 0.2, -2.0}});
    const Pose truth{0.2, 0.1, 0.4};
    const double sigma = 0.03;
    const ScanMatcher matcher(sigma);
    std::mt19937 engine(4);
    Matrix3d scatter = Matrix3d::Zero();
    Matrix3d stated = Matrix3d::Zero();
    constexpr int kDraws = 300;
    for (int i = 0; i < kDraws; ++i) {
        const std::vector<SurfacePoint> scan = test::drawn_points(room, truth, sigma, &engine);
        const Pose found = matcher.fit(scan, map, truth, ignorant(truth));
        const Vector3d e(found.x - truth.x, found.y - truth.y, found.theta - truth.theta);
        scatter += e * e.transpose() / kDraws;
        const Linearization l = matcher.linearize(scan, map, found, kFineStage);
        stated += (matcher.information() * l.h).inverse() / kDraws;
    }
    // The weights of Cauchy's loss make it cautious: between a third of it and all of it.
    const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix3d> ratio(scatter, stated);
    EXPECT_LT(ratio.eigenvalues().maxCoeff(), 1.6);
    EXPECT_GT(ratio.eigenvalues().minCoeff(), 0.15);
}

TEST(ScanMatcher, SourcesAddUpToTheWhole) {
    const Walls room = test::recess_room();
    const PointMap map = matched_map_of(room, {{0.0, 0.0, 0.3}, {0.3, 0.1, 1.9}});
    const std::vector<SurfacePoint> scan = test::drawn_points(room, {0.1, 0.0, 0.5});
    std::vector<Linearization> by_source(2);
    const Linearization whole =
        ScanMatcher(0.1).linearize(scan, map, {0.1, 0.0, 0.5}, kFineStage, 1, &by_source);
    EXPECT_EQ(by_source[0].matches + by_source[1].matches, whole.matches);
    EXPECT_GT(by_source[0].matches, 10);
    EXPECT_TRUE((by_source[0].h + by_source[1].h).isApprox(whole.h, 1e-12));
}

TEST(ScanMatcher, ALoosePointWeighsLessTheFurtherItIsOff) {
    // A tenth of a point on a surface, and half of that at a decimetre.
    PointMap map;
    map.begin({0.0, 0.0}, 5.0);
    map.add(std::vector<SurfacePoint>{{2.0F, 0.0F}}, {}, 0);
    map.build();
    const std::vector<SurfacePoint> scan{{2.0F, 0.0F}};
    for (const double off : {0.0, 0.1, 0.2}) {
        const Linearization l = ScanMatcher(0.1).linearize(scan, map, {off, 0.0, 0.0}, kFineStage);
        const double weight = 0.1 / (1.0 + off * off / 0.01);
        EXPECT_EQ(l.matches, 1);
        EXPECT_NEAR(l.h(0, 0), weight, 1e-6);
        EXPECT_NEAR(l.h(2, 2), 4.0 * weight, 1e-6);
        EXPECT_NEAR(l.b(0), weight * off, 1e-6);
    }
}

}  // namespace
}  // namespace hitos
