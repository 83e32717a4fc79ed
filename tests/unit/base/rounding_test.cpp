// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/rounding.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace hitos {
namespace {

TEST(Rounding, NoZeroHasASign) {
    EXPECT_FALSE(std::signbit(without_sign_of_zero(-0.0)));
    EXPECT_EQ(without_sign_of_zero(-0.5), -0.5);
    EXPECT_EQ(fixed_point(-0.004, 2), "0.00");
    EXPECT_EQ(fixed_point(-0.4, 0), "0");
    EXPECT_EQ(fixed_point(-0.006, 2), "-0.01");
    EXPECT_EQ(fixed_point(-100.0, 1), "-100.0");
    EXPECT_EQ(fixed_point(-std::numeric_limits<double>::infinity(), 2), "-inf");
}

}  // namespace
}  // namespace hitos
