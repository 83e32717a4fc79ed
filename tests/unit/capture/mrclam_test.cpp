// SPDX-License-Identifier: GPL-3.0-or-later
// Tours of the MRCLAM dataset: files beside each other.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test_files.hpp"

namespace hitos {
namespace {

using test::Log;
using test::TempDir;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* kHead =
    "# UTIAS Multi-Robot Cooperative Localization and Mapping Dataset\n"
    "# produced by nobody\n";

class Mrclam : public ::testing::Test {
  protected:
    Mrclam() {
        put("Barcodes.dat", "  1 \t   5\n  2 \t  14\n  6 \t  72\n 20 \t  90\n");
        put("Robot2_Odometry.dat", "10.0 \t 0.1 \t 0.0\n10.5 \t 0.2 \t -0.1\n11.0 \t 0.2 \t 0.0\n");
        put("Robot2_Measurement.dat",
            "10.2 \t 90 \t 2.5 \t 0.025\n"
            "10.2 \t 5 \t 3.4 \t 0.006\n"  // another robot
            "10.2 \t 72 \t 1.5 \t -0.5\n"
            "10.9 \t 72 \t 1.4 \t -0.4\n");
    }

    std::filesystem::path put(const std::string& name, const std::string& text) const {
        return folder_.put(name, kHead + text);
    }

    TempDir folder_;
};

TEST_F(Mrclam, IsReadOfEitherOfATour) {
    for (const char* name : {"Robot2_Odometry.dat", "Robot2_Measurement.dat"}) {
        EXPECT_EQ(open_log(folder_ / name)->format().word, "mrclam");
        const Log log = test::read_log(folder_ / name);
        EXPECT_EQ(log.report.skipped, 0U);
        ASSERT_EQ(log.scans.size(), 2U);
        EXPECT_EQ(log.scans[0].time_s, 10.2);
        EXPECT_THAT(log.scans[0].landmarks,
                    ElementsAre(LandmarkSighting{2.5, 0.025, 20}, LandmarkSighting{1.5, -0.5, 6}));
        EXPECT_THAT(log.scans[1].landmarks, ElementsAre(LandmarkSighting{1.4, -0.4, 6}));
        EXPECT_TRUE(log.findings.empty());
        ASSERT_EQ(log.odometry.size(), 3U);
        EXPECT_EQ(log.odometry[1].twist, (Twist{0.2, 0.0, -0.1}));
    }
}

TEST_F(Mrclam, NamesAllItsFiles) {
    EXPECT_THAT(log_files(folder_ / "Robot2_Odometry.dat"),
                ElementsAre(folder_ / "Robot2_Measurement.dat", folder_ / "Robot2_Odometry.dat",
                            folder_ / "Barcodes.dat"));
}

TEST_F(Mrclam, OtherFilesOfTheDatasetAreNoTours) {
    for (const char* name : {"Barcodes.dat", "Landmark_Groundtruth.dat", "Robot2_Groundtruth.dat",
                             "Robot_Odometry.dat", "Robot2_Odometry.dat.old"}) {
        put(name, "1 2 3 4\n");
        try {
            open_log(folder_ / name);
            ADD_FAILURE() << name;
        } catch (const FormatError& error) {
            EXPECT_THAT(error.what(), HasSubstr("no tour by itself; expected a robot's Odometry"));
        }
    }
}

TEST_F(Mrclam, WhatIsMissingIsNamed) {
    std::filesystem::remove(folder_ / "Robot2_Measurement.dat");
    EXPECT_THROW(test::read_log(folder_ / "Robot2_Odometry.dat"), FileError);
    put("Robot2_Measurement.dat", "10.2 90 2.5 0.025\n");
    std::filesystem::remove(folder_ / "Barcodes.dat");
    try {
        test::read_log(folder_ / "Robot2_Odometry.dat");
        ADD_FAILURE();
    } catch (const FileError& error) {
        EXPECT_THAT(error.what(), HasSubstr("Barcodes.dat"));
    }
}

TEST_F(Mrclam, DamagedLinesAreCountedInBothFiles) {
    put("Robot2_Odometry.dat", "10.0 0.1 0.0\n10.5 0.2\n11.0 0.2 x\n11.5 0.1 0\n");
    put("Robot2_Measurement.dat",
        "10.2 90 2.5 0.025\n10.3 17 1 0\n10.4 90 -1 0\n10.5 90 1 nan\n10.6 90 1\n");
    const Log log = test::read_log(folder_ / "Robot2_Odometry.dat");
    EXPECT_EQ(log.scans.size(), 1U);
    EXPECT_EQ(log.odometry.size(), 2U);
    EXPECT_EQ(log.report.skipped, 6U);
    std::string told;
    for (const ReadReport::Skip& skip : log.report.examples) told += skip.reason.english() + '\n';
    EXPECT_THAT(told, HasSubstr("Odometry.dat: not a line of the format mrclam"));
    EXPECT_THAT(told, HasSubstr("Measurement.dat: barcode: found \"17\""));
    for (const char* barcodes : {"1 5\n6 a\n", "0 5\n", "2147483648 5\n", "6 5\n7 5\n"}) {
        put("Barcodes.dat", barcodes);
        EXPECT_THROW(test::read_log(folder_ / "Robot2_Odometry.dat"), FormatError) << barcodes;
    }
}

}  // namespace
}  // namespace hitos
