// SPDX-License-Identifier: GPL-3.0-or-later
// What is added to the times of scans whose clock runs otherwise than the odometry's.
#include "hitos/capture/scan_clock.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hitos/base/error.hpp"

namespace hitos {
namespace {

TEST(ScanClock, AddsEvenlyMoreBetweenTwoPoints) {
    ScanClock clock("0.5@0, -1.5@100");
    EXPECT_EQ(clock.added(1000.0), 0.5);
    EXPECT_NEAR(clock.added(1025.0), 0.0, 1e-12);
    EXPECT_NEAR(clock.added(1100.0), -1.5, 1e-12);
    EXPECT_EQ(clock.added(1200.0), -1.5);
    EXPECT_EQ(ScanClock().added(7.0), 0.0);
}

TEST(ScanClock, ALeapCountsFromThenOn) {
    ScanClock clock("0@10,-2.5@10");
    EXPECT_EQ(clock.added(0.0), 0.0);
    EXPECT_EQ(clock.added(10.0), 0.0);
    EXPECT_EQ(clock.added(12.6), -2.5);
    // Set back: what follows is later all the same.
    ScanClock back("0@10,2.5@10");
    EXPECT_EQ(back.added(0.0), 0.0);
    EXPECT_EQ(back.added(10.0), 0.0);
    EXPECT_EQ(back.added(7.6), 2.5);
    EXPECT_EQ(back.added(7.7), 2.5);
}

TEST(ScanClock, OtherTextsAreRefused) {
    for (const char* wrong : {"1", "1@", "@1", "a@1", "1@2,1@1", "1@2 3", "nan@1", "0@5,1@5,2@5"}) {
        try {
            const ScanClock clock{wrong};
            ADD_FAILURE() << wrong;
        } catch (const ConfigError& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr("source.scan_clock: found \""));
        }
    }
}

}  // namespace
}  // namespace hitos
