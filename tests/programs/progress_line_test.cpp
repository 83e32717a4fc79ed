// SPDX-License-Identifier: GPL-3.0-or-later
#include "progress_line.hpp"

#include <gtest/gtest.h>

namespace hitos::cli {
namespace {

TEST(ProgressLine, SaysWholePercentsAnd100OfTheWholeAlone) {
    EXPECT_EQ(percent_text(0.0), "  0 %");
    EXPECT_EQ(percent_text(0.379), " 37 %");
    EXPECT_EQ(percent_text(0.9951), " 99 %");
    EXPECT_EQ(percent_text(0.999999), " 99 %");
    EXPECT_EQ(percent_text(1.0), "100 %");
}

}  // namespace
}  // namespace hitos::cli
