// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/evaluation/uncertainty.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support.hpp"

namespace hitos {
namespace {

using test::content;
using test::TempFolder;

LandmarkMap uncertain_map_of(int lines, int corners, double sigma) {
    LandmarkMap map;
    for (int i = 0; i < lines + corners; ++i) {
        ICaracteristica landmark;
        if (i < lines) {
            landmark.value = Recta{1.0 + i, 0.0};
        } else {
            landmark.value = Esquina{0.0, 1.0 * i};
        }
        landmark.covariance << sigma * sigma, 0.0, 0.0, sigma * sigma / 100.0;
        map.push_back(landmark);
    }
    return map;
}

TEST(UncertaintyRecord, HoldsEveryScanAndLandmark) {
    UncertaintyRecord record;
    record.note(10.0, {});
    record.note(10.2, uncertain_map_of(1, 1, 0.5));
    record.note(10.4, uncertain_map_of(2, 1, 0.25));
    EXPECT_EQ(uncertainty_csv(record),
              "scan,time_s,kind,landmark,sigma_1,sigma_2\n"
              "2,10.2,line,1,0.5,0.05\n"
              "2,10.2,corner,1,0.5,0.05\n"
              "3,10.4,line,1,0.25,0.025\n"
              "3,10.4,line,2,0.25,0.025\n"
              "3,10.4,corner,1,0.25,0.025\n");
    record.clear();
    EXPECT_TRUE(record.entries().empty());
    record.note(0.0, uncertain_map_of(1, 0, 0.5));
    EXPECT_EQ(record.entries().front().scan, 0U);
}

TEST(UncertaintyRecord, IsAsFineAfterClearAsAtTheStart) {
    UncertaintyRecord record(2);
    for (int scan = 0; scan < 5; ++scan) record.note(scan, uncertain_map_of(1, 0, 0.5));
    EXPECT_GT(record.every(), 1U);
    record.clear();
    EXPECT_EQ(record.every(), 1U);
    record.note(0.0, uncertain_map_of(1, 0, 0.5));
    record.note(1.0, uncertain_map_of(1, 0, 0.5));
    EXPECT_EQ(record.entries().size(), 2U);
}

TEST(UncertaintyRecord, AVarianceThatRoundingMadeNegativeIsNone) {
    LandmarkMap map = uncertain_map_of(1, 0, 0.5);
    map[0].covariance << -1e-18, 0.0, 0.0, -1e-18;
    UncertaintyRecord record;
    record.note(0.0, map);
    EXPECT_EQ(record.entries().front().sigma_1, 0.0);
    EXPECT_EQ(record.entries().front().sigma_2, 0.0);
}

TEST(UncertaintyRecord, StaysWithinItsBoundWithEvenSteps) {
    UncertaintyRecord record(100);
    std::size_t most = 0;
    for (int scan = 0; scan < 5000; ++scan) {
        record.note(0.2 * scan, uncertain_map_of(3, 0, 1.0 / (1 + scan)));
        most = std::max(most, record.entries().size());
    }
    EXPECT_LE(most, 100U);
    EXPECT_GT(record.entries().size(), 40U);
    EXPECT_EQ(record.every(),
              256U);  // 5000 / 256 scans of 3 entries, the first power of 2 that fits
    for (std::size_t i = 0; i < record.entries().size(); ++i) {
        const LandmarkSigma& entry = record.entries()[i];
        EXPECT_EQ(entry.scan, i / 3 * record.every());
        EXPECT_DOUBLE_EQ(entry.sigma_1, 1.0 / static_cast<double>(1 + entry.scan));
    }
    // A map greater than the bound is kept once, whole.
    UncertaintyRecord small(4);
    small.note(0.0, uncertain_map_of(9, 0, 1.0));
    small.note(0.2, uncertain_map_of(9, 0, 1.0));
    EXPECT_EQ(small.entries().size(), 9U);
}

TEST(UncertaintyRecord, IsDrawn) {
    const TempFolder folder;
    UncertaintyRecord record;
    EXPECT_EQ(write_uncertainty(record, folder.path()).english(), "no landmark was observed");
    EXPECT_FALSE(std::filesystem::exists(folder / "uncertainty.png"));
    for (int scan = 0; scan < 20; ++scan)
        record.note(scan, uncertain_map_of(3, 2, 1.0 / (1 + scan)));
    const std::string failure = write_uncertainty(record, folder.path()).english();
    if (failure.find("not installed") != std::string::npos) GTEST_SKIP() << failure;
    ASSERT_EQ(failure, "");
    EXPECT_TRUE(content(folder / "uncertainty.png").starts_with("\x89PNG"));
    EXPECT_EQ(content(folder / "uncertainty.csv"), uncertainty_csv(record));
    // A sigma of 1 rad / 10 is drawn as degrees.
    EXPECT_THAT(content(folder / "uncertainty.dat"),
                ::testing::StartsWith("# line 1\n1 1 5.72958\n2 0.5 2.86479\n"));
    EXPECT_EQ(folder.files(), 4U);
}

}  // namespace
}  // namespace hitos
