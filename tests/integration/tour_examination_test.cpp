// SPDX-License-Identifier: GPL-3.0-or-later
// Doubts about tours that are whole: nothing is said of clean ones, and what was made wrong on
// purpose is told with its number.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <future>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/capture/joined_tour.hpp"
#include "hitos/capture/tour_summary.hpp"
#include "hitos/features/control.hpp"
#include "hitos/registration/scan_odometry.hpp"
#include "hitos/services/run/algoritmo.hpp"
#include "integration/wrong_tours.hpp"
#include "support.hpp"

namespace hitos {
namespace {

namespace fs = std::filesystem;
using Kind = TourFinding::Kind;
using test::add_reading;
using test::read;
using test::Readings;

const fs::path kShared = HITOS_SHARED_DIR;

class OfWorld : public testing::TestWithParam<std::string> {
  protected:
    Readings tour_ = read(source_named(GetParam()));
};

TEST_P(OfWorld, NothingIsSaid) {
    EXPECT_EQ(tour_.said(), "");
}

TEST_P(OfWorld, ADelayIsToldToATenthOfASecond) {
    if (GetParam() == "corridor") GTEST_SKIP() << "it looks alike at every time";
    for (const double delay : {-14.0, -7.3, 0.8, 20.15}) {
        Readings late = tour_;
        for (Scan& scan : late.scans) scan.time_s += delay;
        const auto found = late.of_kind(Kind::scan_delay);
        ASSERT_TRUE(found) << delay;
        EXPECT_NEAR(found->value, -delay, 0.1);
        EXPECT_NE(advice_of(*found).english().find("--scan-delay"), std::string::npos);
    }
}

TEST_P(OfWorld, ClocksThatShareNoTimeAreTold) {
    if (GetParam() == "corridor") GTEST_SKIP() << "it looks alike at every time";
    Readings apart = tour_;
    for (Scan& scan : apart.scans) scan.time_s += 3.5e6;
    const auto found = apart.of_kind(Kind::clocks_apart);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->value, -3.5e6, 0.2);
}

/// Seen by a laser that is turned and, in place of its rays, mirrored.
Scan mounted(const Scan& scan, double turn_rad, bool mirrored) {
    Scan other = scan;
    for (Point2& point : other.points) {
        Point2 seen = transform(inverse(scan.fan.pose_robot_laser), point);
        if (mirrored) seen.y = -seen.y;
        point = transform(compose(scan.fan.pose_robot_laser, {0, 0, -turn_rad}), seen);
    }
    return other;
}

TEST_P(OfWorld, ALaserMountedOtherwiseIsTold) {
    if (GetParam() == "corridor") GTEST_SKIP() << "it looks alike from its other end";
    for (const double degrees : {-90.0, 45.0, 180.0, 7.0, -12.0}) {
        Readings turned = tour_;
        for (Scan& scan : turned.scans) scan = mounted(scan, degrees * kRadiansPerDegree, false);
        const auto found = turned.of_kind(Kind::turned_laser);
        ASSERT_TRUE(found) << degrees << '\n' << turned.said();
        const double off = wrap_angle(found->value - degrees * kRadiansPerDegree);
        EXPECT_LE(std::abs(off), 4.0 * kRadiansPerDegree) << degrees;
        EXPECT_NE(advice_of(*found).english().find("--laser-pose"), std::string::npos);
        EXPECT_EQ(advice_of(*found).english().find("upside-down"), std::string::npos);
    }
    Readings mirrored = tour_;
    for (Scan& scan : mirrored.scans) scan = mounted(scan, 0.0, true);
    EXPECT_TRUE(mirrored.of_kind(Kind::mirrored_laser)) << mirrored.said();
}

TEST_P(OfWorld, WhatIsUpsideDownAlreadyIsAdvisedAsThat) {
    if (GetParam() == "corridor") GTEST_SKIP() << "it looks alike from its other end";
    for (const bool mirrored : {false, true}) {
        Readings turned = tour_;
        for (Scan& scan : turned.scans) {
            scan = mounted(scan, mirrored ? 0.0 : kPi / 2.0, mirrored);
            scan.fan.upside_down = true;
        }
        const auto found = turned.of_kind(mirrored ? Kind::mirrored_laser : Kind::turned_laser);
        ASSERT_TRUE(found) << turned.said();
        EXPECT_EQ(advice_of(*found).english().find("upside-down") != std::string::npos, !mirrored)
            << advice_of(*found).english();
    }
}

TEST_P(OfWorld, UnitsAndBrokenDriversAreTold) {
    Readings millimetres = tour_;
    for (Scan& scan : millimetres.scans) {
        for (Point2& point : scan.points) point = {1000.0 * point.x, 1000.0 * point.y};
    }
    EXPECT_TRUE(millimetres.of_kind(Kind::laser_units));
    Readings fast = tour_;
    for (Odometria& reading : fast.odometry) {
        reading.twist.v *= 1000.0;
        reading.twist.v_lateral *= 1000.0;
    }
    EXPECT_TRUE(fast.of_kind(Kind::odometry_units));
    Readings still = tour_;
    for (Odometria& reading : still.odometry) reading.twist = {};
    EXPECT_TRUE(still.of_kind(Kind::still_odometry));
    Readings none = tour_;
    none.odometry.clear();
    EXPECT_TRUE(none.of_kind(Kind::no_odometry));
    Readings leap = tour_;
    leap.odometry[leap.odometry.size() / 2].twist.v = 170.0;
    EXPECT_TRUE(leap.of_kind(Kind::leaping_odometry));
    Readings frozen = tour_;
    for (Scan& scan : frozen.scans) scan.points = frozen.scans.front().points;
    EXPECT_TRUE(frozen.of_kind(Kind::frozen_laser));
    Readings blind = tour_;
    for (Scan& scan : blind.scans) scan.points.clear();
    EXPECT_TRUE(blind.of_kind(Kind::blind_laser));
}

TEST_P(OfWorld, TimesThatAreNoSecondsAreNotSaidToBeCentimetres) {
    if (GetParam() == "corridor") GTEST_SKIP() << "it looks alike all along";
    constexpr double kMuch = 150.0;
    for (Scan& scan : tour_.scans) scan.time_s /= kMuch;
    for (Odometria& reading : tour_.odometry) {
        reading.time_s /= kMuch;
        reading.twist = {reading.twist.v * kMuch, 0.0, reading.twist.w * kMuch};
    }
    EXPECT_TRUE(tour_.of_kind(Kind::coarse_stamps)) << tour_.said();
    EXPECT_FALSE(tour_.of_kind(Kind::odometry_units)) << tour_.said();
}

TEST_P(OfWorld, OdometryThatStandsForAWhileIsTold) {
    if (GetParam() == "corridor") GTEST_SKIP() << "it looks alike all along";
    const double begin = tour_.scans.front().time_s;
    const double end = tour_.scans.back().time_s;
    const double third = begin + (end - begin) / 3.0;
    Readings frozen = tour_;
    for (Odometria& reading : frozen.odometry) {
        if (reading.time_s > third && reading.time_s < third + 30.0) reading.twist = {};
    }
    const auto stands = frozen.of_kind(Kind::still_odometry);
    ASSERT_TRUE(stands) << frozen.said();
    EXPECT_GE(stands->value, 9.0) << stands->what.english();
    EXPECT_LE(stands->value, 36.0);
    EXPECT_NE(advice_of(*stands).english().find("source.odometry=scans"), std::string::npos);
    Readings ended = tour_;
    std::erase_if(ended.odometry, [&](const Odometria& one) { return one.time_s > third; });
    const auto ends = ended.of_kind(Kind::still_odometry);
    ASSERT_TRUE(ends) << ended.said();
    EXPECT_NE(ends->what.english().find("the odometry ends"), std::string::npos);
    Readings late = tour_;
    std::erase_if(late.odometry, [&](const Odometria& one) { return one.time_s < third; });
    const auto begins = late.of_kind(Kind::still_odometry);
    ASSERT_TRUE(begins) << late.said();
    EXPECT_NE(begins->what.english().find("the odometry begins"), std::string::npos);
}

TEST_P(OfWorld, WaysFarFromThoseOfTheScansAreTold) {
    if (GetParam() == "corridor") GTEST_SKIP() << "it looks alike all along";
    for (const double factor : {0.2, 0.305, 3.28}) {
        Readings far = tour_;
        for (Odometria& reading : far.odometry) reading.twist.v *= factor;
        const auto found = far.of_kind(Kind::odometry_scale);
        ASSERT_TRUE(found) << factor << '\n' << far.said();
        EXPECT_NEAR(found->value * factor, 1.0, 0.06) << factor;
    }
}

/// As over a slow link: six at a time, stamped 2 ms apart when they came.
TEST_P(OfWorld, OdometryInBurstsIsOfNoOtherUnit) {
    constexpr std::size_t kBurst = 6;
    std::vector<Odometria> burst = tour_.odometry;
    for (std::size_t i = 0; i < burst.size(); ++i) {
        const std::size_t last = std::min(i / kBurst * kBurst + kBurst, burst.size()) - 1;
        burst[i].time_s = tour_.odometry[last].time_s - 0.002 * static_cast<double>(last - i);
        if (i == 0) continue;
        const double before = tour_.odometry[i].time_s - tour_.odometry[i - 1].time_s;
        const double after = burst[i].time_s - burst[i - 1].time_s;
        burst[i].twist.v *= before / after;  // the same way
        burst[i].twist.w *= before / after;
    }
    tour_.odometry = std::move(burst);
    EXPECT_FALSE(tour_.of_kind(Kind::odometry_units)) << tour_.said();
}

TEST_P(OfWorld, OdometryOfCoarseStampsIsNotSaidToBeMillimetres) {
    Readings coarse = tour_;
    double last_s = -1.0;
    for (Odometria& reading : coarse.odometry) {  // as a reader puts right what does not advance
        const double driven_s = 0.1;
        const double stamp_s = std::max(std::floor(reading.time_s), last_s + 1e-3);
        const double factor = last_s < 0.0 ? 1.0 : driven_s / (stamp_s - last_s);
        reading.twist = {reading.twist.v * factor, reading.twist.v_lateral * factor,
                         reading.twist.w * factor};
        reading.time_s = last_s = stamp_s;
    }
    EXPECT_TRUE(coarse.of_kind(Kind::coarse_stamps)) << coarse.said();
    EXPECT_FALSE(coarse.of_kind(Kind::odometry_units)) << coarse.said();
}

TEST_P(OfWorld, OdometryThatHasNothingToDoWithTheScansIsTold) {
    if (GetParam() == "corridor") GTEST_SKIP() << "it looks alike all along";
    Readings other = tour_;
    for (std::size_t i = 0; i < other.odometry.size(); ++i) {
        other.odometry[i].twist.w = (i / 37) % 2 == 0 ? 1.5 : -1.1;
    }
    const auto found = other.of_kind(Kind::unfit_odometry);
    ASSERT_TRUE(found) << other.said();
    EXPECT_LT(found->value, 0.8);
}

TEST_P(OfWorld, RaysThatSawNothingAreToldWhereTheyAreTakenForWallsAndHideNoClock) {
    constexpr double kCode = 30.0;
    Readings late = tour_;
    for (Scan& scan : late.scans) scan.time_s += 2.0;
    Readings other = late;
    for (std::size_t i = 0; i < other.scans.size(); ++i) {
        Scan& scan = other.scans[i];
        if (i % 2 == 0) continue;  // some scans see walls all round
        for (std::uint32_t ray = 0; ray < scan.fan.count; ray += 9) {
            add_reading(scan, ray, kCode);
        }
    }
    const auto found = other.of_kind(Kind::no_return);
    ASSERT_TRUE(found) << other.said();
    EXPECT_NEAR(found->value, kCode, 1e-9);
    EXPECT_EQ(other.of_kind(Kind::scan_delay).has_value(),
              late.of_kind(Kind::scan_delay).has_value())
        << other.said() << late.said();
    // Of what rounding has made of it nothing stays.
    EXPECT_EQ(options_of(found->remedies.at(0).settings), "--set source.max_range=29.99");
    // And where each ray has a code of its own.
    Readings own = tour_;
    for (std::size_t i = 0; i < own.scans.size(); ++i) {
        Scan& scan = own.scans[i];
        for (std::uint32_t ray = i % 2; ray < scan.fan.count; ray += 2)
            add_reading(scan, ray, kCode + 0.002 * ray);
    }
    const auto codes = own.of_kind(Kind::no_return);
    ASSERT_TRUE(codes) << own.said();
    EXPECT_NE(codes->what.english().find("the greatest of their ray"), std::string::npos);
    EXPECT_EQ(options_of(codes->remedies.at(0).settings), "--set source.max_range=29.99");
}

TEST_P(OfWorld, APartOfTheRobotThatTheLaserSeesIsTold) {
    Readings own = tour_;
    double left = 1.0;
    for (Scan& scan : own.scans) {
        constexpr std::uint32_t kFirst = 40;
        constexpr std::uint32_t kRays = 6;
        left = -left;  // rounding to millimetres
        for (std::uint32_t ray = kFirst; ray < kFirst + kRays; ++ray) {
            add_reading(scan, ray, 0.301 + 0.0005 * left);
        }
    }
    const auto found = own.of_kind(Kind::self_hits);
    if (GetParam() == "corridor") {
        EXPECT_FALSE(found);  // it hardly turns there, so that walls beside it look so too
        return;
    }
    ASSERT_TRUE(found) << own.said();
    EXPECT_EQ(found->value, 6.0);
    EXPECT_NE(advice_of(*found).english().find("source.min_range=0.40"), std::string::npos)
        << advice_of(*found).english();
}

TEST_P(OfWorld, RaysThatAreStuckAreTold) {
    EXPECT_FALSE(tour_.of_kind(Kind::stuck_rays));
    if (GetParam() == "corridor") return;  // it hardly turns there
    for (const double stuck_m : {1.5, 4.0}) {
        Readings broken = tour_;
        for (Scan& scan : broken.scans) {
            for (std::uint32_t ray = 40; ray < 70; ++ray) add_reading(scan, ray, stuck_m);
        }
        const auto found = broken.of_kind(Kind::stuck_rays);
        ASSERT_TRUE(found) << broken.said();
        EXPECT_GE(found->value, 28.0);
        EXPECT_LE(found->value, 32.0);
        EXPECT_FALSE(broken.of_kind(Kind::self_hits));
        EXPECT_NE(found->what.english().find(fmt::format("{:.2f} m and more", stuck_m)),
                  std::string::npos)
            << found->what.english();
    }
}

TEST_P(OfWorld, OfARobotAtRestNoRayIsStuck) {
    constexpr double kPeriod = 0.1;     // [s]
    constexpr double kTrembles = 2e-3;  // [rad], of its heading
    Readings still;
    double to = kTrembles;
    for (std::uint64_t k = 0; k < 2000; ++k) {
        const double time_s = kPeriod * static_cast<double>(k);
        Odometria reading = tour_.odometry.front();
        reading.time_s = time_s;
        reading.twist = {0.0, 0.0, (to = -to) / kPeriod};
        reading.line = 2 * k + 1;
        still.odometry.push_back(reading);
        Scan scan = tour_.scans.front();
        scan.time_s = time_s;
        scan.line = 2 * k + 2;
        // Readings are rounded, so that only some of them tremble.
        for (std::size_t i = scan.points.size() / 3; i < scan.points.size(); ++i) {
            const double longer = 1.0 + 0.01 * static_cast<double>(k % 3);
            scan.points[i] = {longer * scan.points[i].x, longer * scan.points[i].y};
        }
        still.scans.push_back(std::move(scan));
    }
    EXPECT_FALSE(still.of_kind(Kind::stuck_rays)) << still.said();
}

TEST_P(OfWorld, WhatSaysThatNothingWasSeenIsNotStuckNorHidesTheRobot) {
    if (GetParam() == "corridor") return;  // it hardly turns there
    Readings open = tour_;
    const std::uint32_t count = open.scans.front().fan.count;
    for (Scan& scan : open.scans) {
        // Of every ray from the middle on, and some that see the robot.
        for (std::uint32_t ray = count / 2; ray < count; ++ray) add_reading(scan, ray, 30.0);
        for (std::uint32_t ray = 4; ray < 10; ++ray) add_reading(scan, ray, 0.3);
    }
    EXPECT_TRUE(open.of_kind(Kind::no_return)) << open.said();
    EXPECT_FALSE(open.of_kind(Kind::stuck_rays)) << open.said();
    const auto own = open.of_kind(Kind::self_hits);
    ASSERT_TRUE(own) << open.said();
    EXPECT_EQ(own->value, 6.0);
}

TEST_P(OfWorld, APartOfTheRobotIsToldThoughRaysGoByItNowAndThen) {
    if (GetParam() == "corridor") return;  // it hardly turns there
    Readings own = tour_;
    std::size_t number = 0;
    for (Scan& scan : own.scans) {
        for (std::uint32_t ray = 40; ray < 46; ++ray)
            add_reading(scan, ray, number++ % 17 == 0 ? 3.7 : 0.4);
    }
    const auto found = own.of_kind(Kind::self_hits);
    ASSERT_TRUE(found) << own.said();
    EXPECT_EQ(found->value, 6.0);
}

TEST_P(OfWorld, OdometryThatLooksAsideOfItsWayIsTold) {
    for (const double degrees : {-90.0, 30.0}) {
        const double c = std::cos(degrees * kRadiansPerDegree);
        const double s = std::sin(degrees * kRadiansPerDegree);
        Readings aside = tour_;
        for (Odometria& reading : aside.odometry) {
            reading.twist.v_lateral = s * reading.twist.v;
            reading.twist.v *= c;
        }
        const auto found = aside.of_kind(Kind::sideways_odometry);
        ASSERT_TRUE(found) << degrees;
        // Ahead and back are one: a robot may drive either way.
        const double off = std::remainder(found->value - degrees * kRadiansPerDegree, kPi);
        EXPECT_NEAR(off, 0.0, 1e-6);
    }
}

TEST_P(OfWorld, StampsOfTooFewDigitsAreTold) {
    Readings coarse = tour_;
    for (Scan& scan : coarse.scans) scan.time_s = std::floor(scan.time_s / 2.0) * 2.0;
    EXPECT_TRUE(coarse.of_kind(Kind::coarse_stamps)) << coarse.said();
}

INSTANTIATE_TEST_SUITE_P(Worlds, OfWorld,
                         testing::Values("recinto", "lineamedia", "bigloop", "bigloop2", "complex",
                                         "corridor"),
                         [](const auto& world) { return world.param; });

TEST(TourExamination, HeadingsInDegreesAreTold) {
    SourceParams params;
    params.file = source_named("bigloop");
    params.world_set = "odometry.rate=50";
    Readings tour = read(params);
    Pose pose;
    Pose degrees;
    double time_s = tour.odometry.front().time_s;
    for (Odometria& reading : tour.odometry) {
        const double seconds = reading.time_s - time_s;
        time_s = reading.time_s;
        if (!(seconds > 0.0)) continue;
        pose = compose(pose, displacement(reading.twist, seconds));
        const Pose next{pose.x, pose.y, wrap_angle(pose.theta * kDegreesPerRadian)};
        reading.twist = twist_between(between(degrees, next), seconds);
        degrees = next;
    }
    const auto found = tour.of_kind(Kind::odometry_units);
    ASSERT_TRUE(found) << tour.said();
    EXPECT_NEAR(found->value, kRadiansPerDegree, 1e-9);
}

/// Everything in a folder of recordings whose name ends so.
std::vector<fs::path> recordings(const char* folder, std::string_view ending) {
    std::vector<fs::path> found;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(kShared / "data" / folder, none)) {
        if (entry.path().string().ends_with(ending) &&
            entry.path().string().find("two-lasers") == std::string::npos)
            found.push_back(entry.path());
    }
    return found;
}

TEST(TourExamination, NothingIsSaidOfRealTours) {
    std::vector<fs::path> tours = recordings("radish", ".log.gz");
    for (const fs::path& log : recordings("player", ".log.gz")) tours.push_back(log);
    for (const fs::path& log : recordings("ros", ".bag")) tours.push_back(log);
    if (tours.empty()) GTEST_SKIP() << "no recordings in " << kShared;
    for (const fs::path& tour : tours) EXPECT_EQ(read(tour.string()).said(), "") << tour;
}

/// It begins anywhere in the map, which is no step of its odometry.
TEST(TourExamination, ATourBehindAnotherIsExaminedAlone) {
    const auto bigloop = [](double odometry_scale) {
        SourceParams params;
        params.file = (fs::path(HITOS_SOURCE_DIR) / "data/bigloop.log.gz").string();
        params.read.odometry_scale = odometry_scale;
        return open_tour(params);
    };
    for (const double of_map : {1.0, 1.3}) {
        const auto both = make_joined_tour({bigloop(of_map)}, bigloop(1.0));
        for (const TourFinding& finding : inspect_tour(*both).findings)
            ADD_FAILURE() << of_map << ": " << finding.what.english();
    }
    const auto both = make_joined_tour({bigloop(1.0)}, bigloop(1.3));
    EXPECT_FALSE(inspect_tour(*both).findings.empty());
}

TEST(TourExamination, TellsWhatIsWrongWithRecordingsFromElsewhere) {
    const fs::path foreign = kShared / "data" / "foreign";
    if (!fs::exists(foreign)) GTEST_SKIP() << "no recordings in " << foreign;
    const std::map<std::string, std::vector<Kind>> wrong = {
        {"00-control/tour.mcap", {}},
        {"carmen-millimetres/tour.log", {Kind::laser_units}},
        {"clock-no-overlap/tour.mcap", {Kind::clocks_apart}},
        {"clock-offset-12s/tour.mcap", {Kind::scan_delay}},
        {"clock-offset-60s/tour.mcap", {Kind::scan_delay}},
        {"laser-backwards/tour.mcap", {Kind::turned_laser}},
        {"laser-only/tour.mcap", {Kind::no_odometry}},
        {"mirrored-laser/tour.mcap", {Kind::mirrored_laser}},
        {"multi-echo-only/tour.mcap", {}},
        {"no-transforms-at-all/tour.mcap", {Kind::assumed_mounting, Kind::turned_laser}},  // by 6°
        {"odometry-reset/tour.mcap", {Kind::leaping_odometry}},
        {"range-limits-swapped/tour.mcap", {Kind::blind_laser}},
        {"ranges-in-millimetres/tour.mcap", {Kind::laser_units}},
        {"segments-of-a-turn/tour.mcap", {Kind::ray_times}},  // its parts are of one time
        {"sweep-control/tour.mcap", {}},
        {"sweep-distortion/tour.mcap", {}},
        {"twist-only/tour.mcap", {Kind::still_odometry}}};
    for (const auto& [file, kinds] : wrong) {
        SourceParams params;
        params.file = (foreign / file).string();
        std::vector<Kind> found;
        for (const TourFinding& finding : inspect_tour(*open_tour(params)).findings) {
            found.push_back(finding.kind);
        }
        EXPECT_EQ(found, kinds) << file;
    }
}

TEST(TourExamination, AnglesInDegreesAreRefusedAndMendedByTheOptionThatIsAdvised) {
    const fs::path tour = kShared / "data" / "foreign" / "angles-in-degrees" / "tour.mcap";
    if (!fs::exists(tour)) GTEST_SKIP() << "no recording in " << tour;
    SourceParams params;
    params.file = tour.string();
    const TourSummary refused = inspect_tour(*open_tour(params));
    EXPECT_EQ(refused.report.scans, 0U);
    ASSERT_FALSE(refused.report.examples.empty());
    EXPECT_NE(refused.report.examples[0].reason.english().find("source.fan_scale=0.0174"),
              std::string::npos);
    params.read.fan_scale = kRadiansPerDegree;
    const TourSummary read = inspect_tour(*open_tour(params));
    EXPECT_TRUE(read.findings.empty());
    EXPECT_GT(read.report.scans, 0U);
}

TEST(TourExamination, AScaleOfTheOdometryIsTold) {
    const fs::path tour = kShared / "data" / "foreign" / "00-control" / "tour.mcap";
    if (!fs::exists(tour)) GTEST_SKIP() << "no recording in " << tour;
    SourceParams params;
    params.file = tour.string();
    for (const double scale : {0.8, 0.9, 1.1, 1.25}) {
        params.read.odometry_scale = scale;
        const auto found = inspect_tour(*open_tour(params)).findings;
        ASSERT_EQ(found.size(), 1U) << scale;
        EXPECT_EQ(found.front().kind, Kind::odometry_scale);
        EXPECT_NEAR(found.front().value, 1.0 / scale, 0.03);
    }
}

TEST(TourExamination, AScaleOfTheLaserIsToldOfScansThatLieFarApart) {
    const std::vector<fs::path> tours = recordings("radish", ".log.gz");
    if (tours.empty()) GTEST_SKIP() << "no recordings in " << kShared;
    int right = 0;
    int all = 0;
    for (const fs::path& tour : tours) {
        SourceParams params;
        params.file = tour.string();
        for (const double scale : {0.5, 0.85, 1.2, 2.0}) {
            params.read.range_scale = scale;
            const auto found = inspect_tour(*open_tour(params)).findings;
            ++all;
            if (std::ranges::any_of(found, [scale](const TourFinding& finding) {
                    return finding.kind == Kind::odometry_scale &&
                           std::abs(finding.value / scale - 1.0) < 0.06;
                })) {
                ++right;
            }
        }
    }
    EXPECT_GE(right, 9 * all / 10) << "of " << all;
}

TEST(TourExamination, WheelsThatSlipWhileTheRobotKnowsItsTurnsAreTold) {
    const std::vector<std::pair<std::string, double>> cases{{"freiburg-101", 450.0},
                                                            {"intel", 1325.0}};
    for (const auto& [name, begin_s] : cases) {
        const fs::path log = kShared / "data" / "radish" / (name + ".log.gz");
        if (!fs::exists(log)) GTEST_SKIP() << "no recording in " << log;
        Readings tour = read(log.string());
        EXPECT_EQ(tour.said(), "") << name;
        const double from = tour.scans.front().time_s + begin_s;
        for (Odometria& reading : tour.odometry)
            if (reading.time_s > from && reading.time_s < from + 12.0) reading.twist.v = 0.0;
        const auto found = tour.of_kind(Kind::still_odometry);
        ASSERT_TRUE(found) << name << tour.said();
        EXPECT_NE(found->what.english().find("wheels slip"), std::string::npos) << tour.said();
    }
}

TEST(TourExamination, AHeadingThatDriftsIsToldWithItsSide) {
    for (const char* name : {"aces", "freiburg-101", "intel", "acapulco"}) {
        const fs::path log = kShared / "data" / "radish" / (std::string(name) + ".log.gz");
        if (!fs::exists(log)) GTEST_SKIP() << "no recording in " << log;
        const Readings tour = read(log.string());
        Readings gyro = tour;
        for (Odometria& reading : gyro.odometry) reading.twist.w += 2.0 * kRadiansPerDegree;
        const auto found = gyro.of_kind(Kind::unfit_odometry);
        ASSERT_TRUE(found) << name << gyro.said();
        EXPECT_NE(found->what.english().find("drifts to the left"), std::string::npos);
        EXPECT_NE(found->what.english().find("degrees a second"), std::string::npos);
        Readings wheels = tour;
        for (Odometria& reading : wheels.odometry)
            reading.twist.w -= 15.0 * kRadiansPerDegree * reading.twist.v;
        const auto bent = wheels.of_kind(Kind::unfit_odometry);
        ASSERT_TRUE(bent) << name << wheels.said();
        EXPECT_NE(bent->what.english().find("drifts to the right"), std::string::npos);
        EXPECT_NE(bent->what.english().find("degrees a metre"), std::string::npos);
    }
}

TEST(TourExamination, RatesInDegreesAreToldWhereWholeTurnsAreLost) {
    for (const char* name : {"aces", "freiburg-101"}) {
        const fs::path log = kShared / "data" / "radish" / (std::string(name) + ".log.gz");
        if (!fs::exists(log)) GTEST_SKIP() << "no recording in " << log;
        Readings tour = read(log.string());
        for (Odometria& reading : tour.odometry) reading.twist.w *= kDegreesPerRadian;
        const auto found = tour.of_kind(Kind::odometry_units);
        ASSERT_TRUE(found) << name << tour.said();
        EXPECT_NE(advice_of(*found).english().find("source.odometry_turns=0.01745"),
                  std::string::npos)
            << tour.said();
    }
}

/// The pose at every scan by the odometry alone.
std::vector<Pose> path_of(TourReader& tour) {
    std::vector<Pose> path;
    ControlTrack track([&tour] { return tour.next_odometry(); });
    std::vector<Control> controls;
    Pose pose;
    while (const auto scan = tour.next_scan()) {
        track.controls_until(*scan, controls);
        pose = compose(pose, driven_way(controls).pose_start_end);
        path.push_back(pose);
    }
    return path;
}

TEST(ScanOdometry, FollowsTheRobotByItsScansAlone) {
    for (const char* rate : {"7", "10", "20"}) {  // where it drives slowly, 7 are enough
        SourceParams params;
        params.file = source_named("recinto");
        params.world_set = std::string("laser.rate=") + rate +
                           " laser.field_of_view=360 laser.rays=360 laser.max_range=30";
        const auto tour = make_scan_odometry(open_tour(params));
        const std::vector<Pose> path = path_of(*tour);
        const Truth truth = open_tour(params)->truth().value();
        ASSERT_EQ(path.size(), truth.path.size());
        double greatest = 0.0;
        for (std::size_t i = 0; i < path.size(); ++i) {
            greatest = std::max(greatest, std::hypot(path[i].x - truth.path[i].pose.x,
                                                     path[i].y - truth.path[i].pose.y));
        }
        EXPECT_LT(greatest, 0.15) << rate;
        ASSERT_EQ(tour->findings().size(), 1U);
        EXPECT_EQ(tour->findings().front().kind, Kind::no_odometry);
        EXPECT_EQ(tour->findings().front().what.english().find("wrongly"), std::string::npos);
        // To the last bit the same again.
        EXPECT_EQ(path_of(*tour->reopen()), path);
        tour->restart();
        EXPECT_EQ(path_of(*tour), path);
    }
}

TEST(TourExamination, ARunAdvisesWhatCheckDoes) {
    const auto expect_same = [](const SourceParams& source) {
        Configuracion configuration;
        configuration.source = source;
        configuration.filter.particles = 1;
        const TourSummary checked = inspect_tour(*open_tour(configuration.source));
        ASSERT_FALSE(checked.findings.empty());
        configuration.run.threads = 1;  // then they are looked for by whoever asks first
        for (const bool ahead : {false, true}) {
            Algoritmo run(configuration, open_tour(configuration.source),
                          {.go_back = true, .doubts_ahead = ahead});
            const auto known = [&run] {
                return run.doubts().wait_for(std::chrono::seconds(0)) == std::future_status::ready;
            };
            for (int i = 0; i < 20; ++i) run.step();
            const auto checkpoint = run.checkpoint();
            ASSERT_TRUE(checkpoint);
            while (run.step()) {
            }
            const std::vector<TourFinding> told = run.doubts().get();
            EXPECT_EQ(known(), ahead);
            run.go_to(*checkpoint);
            EXPECT_FALSE(known());
            while (run.step()) {
            }
            EXPECT_EQ(run.doubts().get().size(), told.size());
            run.restart();
            EXPECT_FALSE(known());
            ASSERT_EQ(told.size(), checked.findings.size());
            for (std::size_t i = 0; i < told.size(); ++i) {
                EXPECT_EQ(told[i].what.english(), checked.findings[i].what.english());
                EXPECT_EQ(advice_of(told[i]).english(), advice_of(checked.findings[i]).english());
            }
        }
    };
    SourceParams world;
    world.file = source_named("recinto");
    world.read.odometry_turns = 0.8;
    world.read.odometry_scale = 0.7;
    expect_same(world);
    // Scans that are stamped an hour on from the middle, as their lines are in the log.
    SourceParams log;
    log.file = (kShared / "data" / "radish" / "freiburg-101.log.gz").string();
    if (!fs::exists(log.file)) GTEST_SKIP() << "no recording in " << log.file;
    log.read.scan_clock = "0@0,0@450,3600@450";
    expect_same(log);
}

TEST(TourExamination, TheDelayThatIsAdvisedMendsTheTour) {
    const fs::path tour = kShared / "data" / "foreign" / "clock-offset-12s" / "tour.mcap";
    if (!fs::exists(tour)) GTEST_SKIP() << "no recording in " << tour;
    SourceParams params;
    params.file = tour.string();
    const double delay = inspect_tour(*open_tour(params)).findings.at(0).value;
    params.read.scan_delay_s = delay;
    EXPECT_TRUE(inspect_tour(*open_tour(params)).findings.empty());
}

}  // namespace
}  // namespace hitos
