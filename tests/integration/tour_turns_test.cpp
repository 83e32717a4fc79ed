// SPDX-License-Identifier: GPL-3.0-or-later
// Turns, and what only turns show, that are wrong: told with their number.
#include <gtest/gtest.h>

#include <cmath>

#include "integration/wrong_tours.hpp"

namespace hitos {
namespace {

using Kind = TourFinding::Kind;
using test::Readings;

class OfTurns : public testing::TestWithParam<std::string> {
  protected:
    Readings tour_ = test::read(source_named(GetParam()));
};

TEST_P(OfTurns, AGyroOrAnEncoderThatIsDeadIsTold) {
    for (const double factor : {0.0, 0.05}) {
        Readings dead = tour_;
        for (Odometria& reading : dead.odometry) reading.twist.w *= factor;
        const auto turns = dead.of_kind(Kind::still_odometry);
        ASSERT_TRUE(turns) << factor << '\n' << dead.said();
        EXPECT_NE(turns->what.english().find("turns"), std::string::npos);
    }
    Readings dead = tour_;
    for (Odometria& reading : dead.odometry) reading.twist.v = reading.twist.v_lateral = 0.0;
    EXPECT_TRUE(dead.of_kind(Kind::still_odometry)) << dead.said();
}

TEST_P(OfTurns, TurnsFarFromThoseOfTheScansAreTold) {
    for (const double factor : {0.7, 0.85, 1.15, 1.5}) {
        Readings far = tour_;
        for (Odometria& reading : far.odometry) reading.twist.w *= factor;
        const auto found = far.of_kind(Kind::odometry_turns);
        ASSERT_TRUE(found) << factor << '\n' << far.said();
        EXPECT_NEAR(found->value * factor, 1.0, 0.05) << factor;
    }
}

TEST_P(OfTurns, AShortDelayIsToldWhereItMovesWalls) {
    for (const double delay : {-0.2, 0.1, 0.2}) {
        Readings late = tour_;
        constexpr double kFaster = 4.0;  // turns at 2 rad/s
        for (Odometria& reading : late.odometry) {
            reading.time_s /= kFaster;
            reading.twist.v *= kFaster;
            reading.twist.w *= kFaster;
        }
        for (Scan& scan : late.scans) scan.time_s = scan.time_s / kFaster + delay;
        const auto found = late.of_kind(Kind::scan_delay);
        ASSERT_TRUE(found) << delay << '\n' << late.said();
        EXPECT_NEAR(found->value, -delay, 0.03);
        EXPECT_TRUE(found->later_s);
    }
}

TEST_P(OfTurns, ALaserThatSitsElsewhereIsTold) {
    for (const Point2& off : {Point2{0.5, 0.0}, Point2{-0.3, 0.0}, Point2{0.1, 0.3}}) {
        Readings moved = tour_;
        for (Scan& scan : moved.scans) {
            for (Point2& point : scan.points) point = {point.x - off.x, point.y - off.y};
        }
        const auto found = moved.of_kind(Kind::misplaced_laser);
        ASSERT_TRUE(found) << off.x << '\n' << moved.said();
        EXPECT_NEAR(found->value, std::hypot(off.x, off.y), 0.06);
        EXPECT_NE(advice_of(*found).english().find("--laser-pose"), std::string::npos);
    }
}

TEST_P(OfTurns, ALaserThatIsSaidToSitFarOffAndDoesNotIsTold) {
    constexpr double kSaid = 2.0;
    Readings moved = tour_;
    for (Scan& scan : moved.scans) {
        scan.fan.pose_robot_laser.x += kSaid;
        for (Point2& point : scan.points) point.x += kSaid;
    }
    const auto found = moved.of_kind(Kind::misplaced_laser);
    ASSERT_TRUE(found) << moved.said();
    EXPECT_NEAR(found->value, kSaid, 0.1);
}

INSTANTIATE_TEST_SUITE_P(Worlds, OfTurns,
                         testing::Values("recinto", "bigloop", "bigloop2", "complex", "usc-sal"),
                         [](const auto& world) {
                             return world.param == "usc-sal" ? "usc_sal" : world.param;
                         });

}  // namespace
}  // namespace hitos
