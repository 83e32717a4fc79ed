// SPDX-License-Identifier: GPL-3.0-or-later
// Lasers whose driver says something wrong, or whose scans are not all their own.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>
#include <string>
#include <utility>

#include "hitos/capture/tour_summary.hpp"
#include "integration/wrong_tours.hpp"

namespace hitos {
namespace {

using Kind = TourFinding::Kind;
using test::add_reading;
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
        EXPECT_NE(advice_of(*found).english().find("twice"), std::string::npos);
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
            add_reading(scan, ray, 0.3 + off(random));
        }
    }
    const auto found = tour.of_kind(Kind::self_hits);
    ASSERT_TRUE(found) << tour.said();
    EXPECT_GE(found->value, 6.0);
    EXPECT_NE(advice_of(*found).english().find("source.min_range=0.4"), std::string::npos)
        << advice_of(*found).english();
}

/// What the laser saw, in its frame, changed.
template <class Change>
void seen_otherwise(Readings& tour, const Change& change) {
    for (Scan& scan : tour.scans) {
        const Pose laser = scan.fan.pose_robot_laser;
        for (std::size_t i = 0; i < scan.points.size(); ++i) {
            const Point2 seen = transform(inverse(laser), scan.points[i]);
            const double range = std::hypot(seen.x, seen.y);
            const auto [angle, length] = change(scan, i, std::atan2(seen.y, seen.x), range);
            scan.points[i] =
                transform(laser, Point2{length * std::cos(angle), length * std::sin(angle)});
        }
    }
}

TEST(LaserDoubts, TheUnitOfRangesIsToldByTheOdometry) {
    const std::vector<std::pair<double, std::string>> units{{0.0001, "tenths of a millimetre"},
                                                            {0.001, "millimetres"},
                                                            {0.01, "centimetres"},
                                                            {0.0254, "inches"}};
    for (const char* world : {"bigloop2", "usc-sal", "complex"}) {
        const Readings tour = test::read(source_named(world));
        for (const auto& [metres, name] : units) {
            Readings wrong = tour;
            const double unit = metres;
            seen_otherwise(wrong, [unit](const Scan&, std::size_t, double angle, double range) {
                return std::pair(angle, range / unit);
            });
            const auto found = wrong.of_kind(Kind::laser_units);
            ASSERT_TRUE(found) << world << ' ' << name << '\n' << wrong.said();
            EXPECT_NE(found->what.english().find(name), std::string::npos) << wrong.said();
            EXPECT_EQ(advice_of(*found).english(),
                      fmt::format("read them as such: --set source.range_scale={}", metres));
        }
    }
}

TEST(LaserDoubts, MetresThatAreReadAsLessAreTold) {
    for (const char* world : {"recinto", "complex"}) {
        const Readings tour = test::read(source_named(world));
        for (const double metres : {0.001, 0.01}) {
            Readings wrong = tour;
            seen_otherwise(wrong, [metres](const Scan&, std::size_t, double angle, double range) {
                return std::pair(angle, range * metres);
            });
            const auto found = wrong.findings();
            ASSERT_EQ(found.size(), 1U) << world << '\n' << wrong.said();
            EXPECT_EQ(found[0].kind, Kind::laser_units) << wrong.said();
            EXPECT_EQ(advice_of(found[0]).english(),
                      fmt::format("read them as such: --set source.range_scale={}", 1.0 / metres));
        }
    }
}

TEST(LaserDoubts, RangesBeyondTheLimitAreToldWithTheOptionsThatMendThem) {
    SourceParams params;
    params.file = std::string(HITOS_SHARED_DIR) + "/data/foreign/ranges-in-millimetres/tour.mcap";
    if (!std::filesystem::exists(params.file)) GTEST_SKIP() << "no recording " << params.file;
    params.read.max_range_m = 12.0;
    const auto found = inspect_tour(*open_tour(params)).findings;
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].kind, Kind::laser_units);
    EXPECT_EQ(advice_of(found[0]).english(),
              "by the odometry they are millimetres: --set source.range_scale=0.001 --set "
              "source.max_range=12");
    params.read.range_scale = 0.001;
    EXPECT_TRUE(inspect_tour(*open_tour(params)).findings.empty());
}

TEST(LaserDoubts, AFanThatIsALittleWiderThanItIsToldIsTold) {
    for (const char* world : {"bigloop2", "complex"}) {
        const Readings tour = test::read(source_named(world));
        for (const double scale : {0.95, 1.05}) {
            Readings wrong = tour;
            seen_otherwise(wrong, [scale](const Scan&, std::size_t, double angle, double range) {
                return std::pair(scale * angle, range);
            });
            for (Scan& scan : wrong.scans) {
                scan.fan.min_angle_rad *= scale;
                scan.fan.max_angle_rad *= scale;
            }
            const auto found = wrong.of_kind(Kind::wrong_fan);
            ASSERT_TRUE(found) << world << ' ' << scale << '\n' << wrong.said();
            const Fan& fan = tour.scans.front().fan;
            EXPECT_NEAR(found->value, fan.max_angle_rad - fan.min_angle_rad, 0.03);
            EXPECT_NE(advice_of(*found).english().find("--set source.fan_scale="),
                      std::string::npos);
        }
    }
}

TEST(LaserDoubts, RaysThatAreMissingAtOneEndAreToldAsAFanNotAsAMounting) {
    constexpr double kKept = 5.0 / 6.0;
    for (const char* name : {"aces", "freiburg-101", "acapulco"}) {
        const std::string log = std::string(HITOS_SHARED_DIR) + "/data/radish/" + name + ".log.gz";
        if (!std::filesystem::exists(log)) GTEST_SKIP() << "no recording " << log;
        for (const bool at_end : {false, true}) {
            Readings wrong = test::read(log);
            for (Scan& scan : wrong.scans) {
                // Those that are left go over the whole angle.
                const double span = scan.fan.max_angle_rad - scan.fan.min_angle_rad;
                const double from = scan.fan.min_angle_rad + (at_end ? 0.0 : (1 - kKept) * span);
                std::vector<Point2> points;
                for (const Point2& point : scan.points) {
                    const double part = (std::atan2(point.y, point.x) - from) / (kKept * span);
                    if (part < 0.0 || part > 1.0) continue;
                    const double angle = scan.fan.min_angle_rad + part * span;
                    const double range = std::hypot(point.x, point.y);
                    points.push_back({range * std::cos(angle), range * std::sin(angle)});
                }
                scan.points = points;
                scan.rays.clear();
            }
            const auto found = wrong.of_kind(Kind::wrong_fan);
            ASSERT_TRUE(found) << name << '\n' << wrong.said();
            EXPECT_NEAR(found->value, kKept * kPi, 0.12) << name;
        }
    }
}

TEST(LaserDoubts, ReadingsThatAreAllTooLongOrTooShortAreToldByHowMuch) {
    for (const char* world : {"bigloop2", "complex"}) {
        const Readings tour = test::read(source_named(world));
        for (const double longer_m : {-0.5, 0.3, 1.0, 1.8}) {
            Readings wrong = tour;
            seen_otherwise(wrong, [longer_m](const Scan&, std::size_t, double angle, double range) {
                return std::pair(angle, std::max(0.01, range + longer_m));
            });
            const auto found = wrong.of_kind(Kind::laser_units);
            ASSERT_TRUE(found) << world << ' ' << longer_m << '\n' << wrong.said();
            EXPECT_NEAR(found->value, -longer_m, 0.03) << world;
            EXPECT_EQ(found->remedies.at(0).settings.at(0).key, "source.range_offset");
        }
    }
}

TEST(LaserDoubts, AUnitIsToldOfAnotherFanToo) {
    for (const double wider : {0.8, 1.25}) {
        Readings wrong = test::read(source_named("bigloop2"));
        seen_otherwise(wrong, [wider](const Scan&, std::size_t, double angle, double range) {
            return std::pair(wider * angle, 100.0 * range);
        });
        for (Scan& scan : wrong.scans) {
            scan.fan.min_angle_rad *= wider;
            scan.fan.max_angle_rad *= wider;
        }
        const auto found = wrong.of_kind(Kind::laser_units);
        ASSERT_TRUE(found) << wider << '\n' << wrong.said();
        EXPECT_NE(found->what.english().find("centimetres"), std::string::npos) << wrong.said();
    }
}

TEST(LaserDoubts, FeetAreOfTheLaserOrOfTheOdometryAsTheyAre) {
    constexpr double kFoot = 0.3048;
    const Readings tour = test::read(source_named("bigloop2"));
    Readings laser = tour;
    seen_otherwise(laser, [](const Scan&, std::size_t, double angle, double range) {
        return std::pair(angle, range / kFoot);
    });
    const auto of_laser = laser.of_kind(Kind::odometry_scale);
    ASSERT_TRUE(of_laser) << laser.said();
    EXPECT_EQ(options_of(of_laser->remedies.at(0).settings), "--set source.range_scale=0.3048");
    Readings odometry = tour;
    for (Odometria& reading : odometry.odometry) reading.twist.v /= kFoot;
    const auto of_odometry = odometry.of_kind(Kind::odometry_scale);
    ASSERT_TRUE(of_odometry) << odometry.said();
    const SourceSetting& set = of_odometry->remedies.at(0).settings.at(0);
    EXPECT_EQ(set.key, "source.odometry_scale");
    EXPECT_NEAR(std::stod(set.value), kFoot, 0.01);
}

TEST(LaserDoubts, RayTimesThatAreSaidAndAreNoneAreTold) {
    constexpr float kSweep = 0.1F;
    for (const char* world : {"bigloop2", "complex"}) {
        Readings tour = test::read(source_named(world));
        for (Scan& scan : tour.scans) scan.last_s = kSweep;
        EXPECT_FALSE(tour.of_kind(Kind::ray_times)) << world << tour.said();
        // Moved by the time of each ray, although all were measured at once.
        seen_otherwise(tour, [&](const Scan& scan, std::size_t i, double angle, double range) {
            double turn_rad_per_s = 0.0;
            for (const Odometria& reading : tour.odometry) {
                if (reading.time_s < scan.time_s) continue;
                turn_rad_per_s = reading.twist.w;
                break;
            }
            const double share = static_cast<double>(scan.rays[i]) / scan.fan.count;
            return std::pair(angle + turn_rad_per_s * share * static_cast<double>(kSweep), range);
        });
        const auto found = tour.of_kind(Kind::ray_times);
        ASSERT_TRUE(found) << world << '\n' << tour.said();
        EXPECT_NEAR(found->value, 0.1, 1e-6);
    }
}

}  // namespace
}  // namespace hitos
