// Lasers whose driver says something wrong, or whose scans are not all their own.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "integration/wrong_tours.hpp"

namespace hitos {
namespace {

using Kind = TourFinding::Kind;
using test::Readings;

Readings complex_tour() {
    return test::read(source_named("complex"));
}

TEST(LaserDoubts, ScansThatArePublishedTwiceAreTold) {
    for (const std::size_t every : {1U, 2U, 10U}) {
        const Readings tour = complex_tour();
        Readings twice = tour;
        twice.scans.clear();
        for (std::size_t i = 0; i < tour.scans.size(); ++i) {
            twice.scans.push_back(tour.scans[i]);
            if (i % every != 0) continue;
            twice.scans.push_back(tour.scans[i]);
            twice.scans.back().time_s += 0.09;
        }
        const auto found = twice.of_kind(Kind::frozen_laser);
        ASSERT_TRUE(found) << every << '\n' << twice.said();
        EXPECT_NE(found->remedy.english().find("twice"), std::string::npos);
    }
}

TEST(LaserDoubts, FansOfALittleMoreThanATurnAreTold) {
    for (const double degrees : {358.0, 360.0, 362.0, 365.0}) {
        Readings tour = complex_tour();
        for (Scan& scan : tour.scans) {
            scan.fan.max_angle_rad = scan.fan.min_angle_rad + degrees * kRadiansPerDegree;
        }
        EXPECT_EQ(tour.of_kind(Kind::beyond_a_turn).has_value(), degrees > 360.0) << degrees;
    }
}

TEST(LaserDoubts, APartOfTheRobotIsToldThoughItsReadingsWaverAndItsRaysAreNotAsMany) {
    Readings tour = complex_tour();
    std::mt19937 random(1);
    std::uniform_real_distribution<double> off(-0.012, 0.012);
    constexpr std::uint32_t kFirst = 40;
    constexpr std::uint32_t kRays = 8;
    for (std::size_t n = 0; n < tour.scans.size(); ++n) {
        Scan& scan = tour.scans[n];
        scan.fan.count -= static_cast<std::uint32_t>(
            n % 3);  // from scan to scan a ray or two less, over the same angle
        for (std::uint32_t ray = kFirst; ray < kFirst + kRays; ++ray) {
            const double angle = scan.fan.angle_rad(ray);
            const double range = 0.3 + off(random);
            scan.points.push_back(
                transform(scan.fan.pose_robot_laser,
                          Point2{range * std::cos(angle), range * std::sin(angle)}));
            scan.rays.push_back(ray);
        }
    }
    const auto found = tour.of_kind(Kind::self_hits);
    ASSERT_TRUE(found) << tour.said();
    EXPECT_GE(found->value, 6.0);
    EXPECT_NE(found->remedy.english().find("source.min_range=0.4"), std::string::npos)
        << found->remedy.english();
}

}  // namespace
}  // namespace hitos
