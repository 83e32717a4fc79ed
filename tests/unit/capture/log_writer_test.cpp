// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/capture/log_writer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test_files.hpp"

namespace hitos {
namespace {

using test::content;
using test::expect_near;
using test::Log;
using test::TempDir;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::array<std::string, 5> kAll = {"player", "radish", "normalized", "carmen", "mcap"};

/// A scan with the given ranges; 0 is no return.
Scan scan_of(double time_s, Fan fan, const std::vector<double>& ranges) {
    fan.count = static_cast<std::uint32_t>(ranges.size());
    Scan scan;
    scan.time_s = time_s;
    scan.fan = fan;
    bool open = false;
    for (std::uint32_t i = 0; i < fan.count; ++i) {
        if (ranges[i] <= 0.0) {
            open = false;
            continue;
        }
        if (!open) scan.run_starts.push_back(static_cast<std::uint32_t>(scan.points.size()));
        open = true;
        const double angle =
            fan.min_angle_rad + i * (fan.max_angle_rad - fan.min_angle_rad) / (fan.count - 1);
        scan.points.push_back(transform(
            fan.pose_robot_laser, {ranges[i] * std::cos(angle), ranges[i] * std::sin(angle)}));
        scan.rays.push_back(i);
    }
    return scan;
}

constexpr Fan kHalf{-kPi / 2, kPi / 2, 0, 8.0, {}};

/// A short tour: readings at 10 Hz on a curve, a scan with every second one and one in between.
struct Tour {
    std::vector<Odometria> odometry;
    std::vector<Scan> scans;
};

Tour tour_with(const Fan& fan, std::size_t rays) {
    Tour tour;
    for (int i = 0; i < 40; ++i) {
        tour.odometry.push_back({100.0 + 0.1 * i, i == 0 ? Twist{} : Twist{0.4, 0.0, 0.3}, 0});
        if (i % 2 != 0) continue;
        std::vector<double> ranges(rays);
        for (std::size_t k = 0; k < rays; ++k) {
            ranges[k] = k % 7 == 3 ? 0.0 : 2.0 + 0.02 * static_cast<double>(k % 31) + 0.01 * i;
        }
        tour.scans.push_back(scan_of(100.0 + 0.1 * i + (i == 20 ? 0.05 : 0.0), fan, ranges));
    }
    return tour;
}

std::filesystem::path write_tour(std::string_view format, const std::filesystem::path& path,
                                 const Tour& tour) {
    const std::unique_ptr<LogWriter> writer = make_log_writer(format, path);
    std::size_t next = 0;
    for (const Odometria& reading : tour.odometry) {
        while (next < tour.scans.size() && tour.scans[next].time_s < reading.time_s) {
            writer->write(tour.scans[next++]);
        }
        writer->write(reading);
    }
    while (next < tour.scans.size()) writer->write(tour.scans[next++]);
    writer->finish();
    return path;
}

void expect_same_tour(const Tour& tour, const Log& log, double tolerance) {
    EXPECT_EQ(log.report.skipped, 0U);
    EXPECT_EQ(log.report.stamps_backwards, 0U);
    ASSERT_EQ(log.scans.size(), tour.scans.size());
    for (std::size_t i = 0; i < tour.scans.size(); ++i) {
        EXPECT_NEAR(log.scans[i].time_s, tour.scans[i].time_s, 1e-6);
        EXPECT_EQ(log.scans[i].run_starts, tour.scans[i].run_starts) << i;
        ASSERT_EQ(log.scans[i].points.size(), tour.scans[i].points.size()) << i;
        for (std::size_t k = 0; k < tour.scans[i].points.size(); ++k) {
            expect_near(log.scans[i].points[k], tour.scans[i].points[k], tolerance);
        }
    }
    const std::vector<Pose> written = test::summed(tour.odometry);
    const std::vector<Pose> read = test::summed(log.odometry);
    ASSERT_GE(read.size(), written.size());
    expect_near(read.back(), written.back(), 2e-6);
}

TEST(LogWriter, WhatIsWrittenIsRead) {
    const TempDir folder;
    const Tour tour = tour_with(kHalf, 181);
    for (const std::string& format : kAll) {
        const auto path = write_tour(format, folder / format, tour);
        EXPECT_EQ(open_log(path)->format().word, format);
        const Log log = test::read_log(path);
        SCOPED_TRACE(format);
        expect_same_tour(tour, log, 1e-4);
        if (format == "player" || format == "carmen") {
            EXPECT_EQ(log.scans[0].fan.count, 181U);
            EXPECT_EQ(log.scans[0].fan.max_range_m, 8.0);
            EXPECT_NEAR(log.scans[0].fan.max_angle_rad, kPi / 2, 1e-8);
            EXPECT_EQ(log.scans[0].rays, tour.scans[0].rays);
        }
    }
}

TEST(LogWriter, MountedLaserAndUnusualFan) {
    const TempDir folder;
    const Fan fan{-2.0, 1.9, 0, 30.0, {0.2, -0.1, 0.3}};
    const Tour tour = tour_with(fan, 97);
    for (const std::string& format : kAll) {
        const auto path = write_tour(format, folder / format, tour);
        const Log log = test::read_log(path);
        SCOPED_TRACE(format);
        expect_same_tour(tour, log, 2e-4);
        if (format == "carmen") {
            EXPECT_THAT(content(path), HasSubstr("ROBOTLASER1"));
        }
        if (format != "player" && format != "carmen") continue;
        expect_near(log.scans[0].fan.pose_robot_laser, fan.pose_robot_laser, 1e-5);
        EXPECT_EQ(log.scans[0].fan.count, 97U);
    }
}

TEST(LogWriter, LandmarksStandInTheNormalizedFormatAndAreRefusedByOthers) {
    const TempDir folder;
    Tour tour = tour_with(kHalf, 3);
    for (Scan& scan : tour.scans) {
        const double time_s = scan.time_s;
        scan = {};
        scan.time_s = time_s;
        scan.landmarks = {{1.0 / 3.0, -0.3, 4}, {2.0 * time_s, 0.1}};
    }
    for (const std::string& format : kAll) {
        SCOPED_TRACE(format);
        if (format != "normalized") {
            EXPECT_THROW(write_tour(format, folder / format, tour), FormatError);
            continue;
        }
        const Log log = test::read_log(write_tour(format, folder / format, tour));
        ASSERT_EQ(log.scans.size(), tour.scans.size());
        for (std::size_t i = 0; i < log.scans.size(); ++i) {
            EXPECT_EQ(log.scans[i].landmarks, tour.scans[i].landmarks);
        }
    }
}

TEST(LogWriter, GzipByName) {
    const TempDir folder;
    const Tour tour = tour_with(kHalf, 181);
    for (const std::string& format : kAll) {
        if (format == "mcap") continue;  // never in gzip
        const auto path = write_tour(format, folder / (format + ".log.gz"), tour);
        EXPECT_EQ(content(path).substr(0, 2), "\x1f\x8b");
        EXPECT_EQ(test::read_log(path).scans.size(), tour.scans.size());
    }
}

TEST(LogWriter, PlayerLinesAreLaidOutAsWritelogDoes) {
    const TempDir folder;
    const auto writer = make_log_writer("player", folder / "a");
    writer->write(Odometria{0.1, {}, 0});
    writer->write(Odometria{0.2, {1, 0, 0}, 0});
    writer->write(scan_of(0.2, {-1.0, 1.0, 0, 8.0, {}}, {1.0, 0.0}));
    writer->finish();
    const std::string text = content(folder / "a");
    EXPECT_THAT(text, HasSubstr("## File version 0.3.0 \n"));
    EXPECT_THAT(text, HasSubstr("0000000000.200000 16777343 6665 position2d 00 001 001 +00.100000 "
                                "+00.000000 +00.000000 +01.000000 +00.000000 +00.000000 0\n"));
    EXPECT_THAT(text, HasSubstr("laser 00 004 001   +0.000000  +0.000000"));
    EXPECT_THAT(text, HasSubstr("laser 00 001 001 0000 -1.00000000 +1.00000000 +2.00000000 "
                                "+8.0000 0002 1.0000  1 8.0000  0 \n"));
}

TEST(LogWriter, CarmenPosesAreThoseAtTheScansTime) {
    const TempDir folder;
    const Tour tour = tour_with(kHalf, 181);
    const Log log = test::read_log(write_tour("carmen", folder / "a", tour));
    // The scan between two readings brought a reading of its own.
    ASSERT_EQ(log.odometry.size(), tour.odometry.size() + 1);
    const std::vector<Pose> poses = test::summed(log.odometry);
    expect_near(poses[21], compose(poses[20], displacement({0.4, 0, 0.3}, 0.05)), 2e-6);
    EXPECT_NEAR(log.odometry[21].time_s, 102.05, 1e-9);
    const std::vector<Pose> written = test::summed(tour.odometry);
    expect_near(poses[22], written[21], 2e-6);
}

TEST(LogWriter, WhereTheNextReadingIsKnownNothingIsHeld) {
    const TempDir folder;
    const Tour tour = tour_with(kHalf, 181);
    for (const std::string& format : kAll) {
        const auto held = write_tour(format, folder / ("held-" + format), tour);
        const auto writer = make_log_writer(format, folder / format);
        auto reading = tour.odometry.begin();
        const auto next = [&] { return reading == tour.odometry.end() ? nullptr : &*reading; };
        for (const Scan& scan : tour.scans) {
            for (; next() != nullptr && next()->time_s <= scan.time_s; ++reading)
                writer->write(*reading);
            writer->write(scan, next());
        }
        for (; next() != nullptr; ++reading) writer->write(*reading);
        writer->finish();
        EXPECT_EQ(test::content(folder / format), test::content(held)) << format;
    }
}

TEST(LogWriter, ScanBeforeEveryReadingAndAfterTheLast) {
    const TempDir folder;
    for (const std::string& format : kAll) {
        const auto writer = make_log_writer(format, folder / "a");
        writer->write(scan_of(0.5, kHalf, std::vector<double>(181, 2.0)));
        writer->write(Odometria{1.0, {}, 0});
        writer->write(Odometria{2.0, {1, 0, 0}, 0});
        writer->write(scan_of(2.5, kHalf, std::vector<double>(181, 3.0)));
        writer->finish();
        const Log log = test::read_log(folder / "a");
        ASSERT_EQ(log.scans.size(), 2U);
        EXPECT_EQ(log.scans[1].time_s, 2.5);
        expect_near(test::summed(log.odometry).back(), {1, 0, 0}, 1e-6);
    }
}

TEST(LogWriter, ScanOvertakenByItsOwnReadingTakesItsTime) {
    // Stamps jump back by half a second: readings are repaired, their scans must go with them.
    const std::string text =
        "ODOM 0 0 0 0 0 0 1.0 h 0\nODOM 1 0 0 0 0 0 2.0 h 0\nFLASER 2 1 1 0 0 0 2 0 0 1.5 h 0\n"
        "ODOM 3 0 0 0 0 0 1.6 h 0\nFLASER 2 2 2 0 0 0 3 0 0 1.6 h 0\nODOM 4 0 0 0 0 0 3.0 h 0\n"
        "FLASER 2 3 3 0 0 0 5 0 0 4.0 h 0\n";
    const TempDir folder;
    const Log log = test::read_text("carmen", text);
    ASSERT_EQ(log.odometry.size(), 6U);
    const auto writer = make_log_writer("normalized", folder / "a");
    for (const Scan& scan : log.scans) writer->write(scan);
    for (const Odometria& reading : log.odometry) writer->write(reading);
    writer->finish();
    const Log again = test::read_log(folder / "a");
    ASSERT_EQ(again.scans.size(), 3U);
    EXPECT_EQ(again.scans[0].time_s, log.odometry[2].time_s);
    EXPECT_EQ(again.scans[1].time_s, log.odometry[3].time_s);  // its own repeated the one before
    EXPECT_EQ(again.scans[2].time_s, 4.0);
    EXPECT_EQ(again.report.stamps_backwards, 0U);
}

TEST(LogWriter, AScanBehindTheNewestReadingStandsOnThatReadingsWay) {
    // Scans that come late: half way along the reading's interval, and from before it began.
    const TempDir folder;
    const auto poses_of = [&](double time_s) {
        const auto writer = make_log_writer("carmen", folder / "a");
        writer->write(Odometria{1.0, {}, 0});
        writer->write(Odometria{2.0, {4.0, 0.0, 0.0}, 0});
        writer->write(scan_of(time_s, kHalf, std::vector<double>(181, 2.0)));
        writer->write(Odometria{3.0, {4.0, 0.0, 0.0}, 0});
        writer->finish();
        const Log log = test::read_log(folder / "a");
        EXPECT_EQ(log.odometry.size(), 4U);
        return test::summed(log.odometry);
    };
    expect_near(poses_of(1.5).at(2), {2.0, 0.0, 0.0}, 1e-6);
    expect_near(poses_of(0.5).at(2), {0.0, 0.0, 0.0}, 1e-6);
    expect_near(poses_of(0.5).back(), {8.0, 0.0, 0.0}, 1e-6);
}

TEST(LogWriter, RadishNoReturnLiesBeyondEveryReading) {
    // A laser that reaches 5 m: its code must not be a range that readers take for a point.
    const TempDir folder;
    const auto writer = make_log_writer("radish", folder / "a");
    writer->write(scan_of(1.0, {-1.0, 1.0, 0, 5.0, {}}, {1.0, 0.0, 2.0}));
    writer->finish();
    const Log log = test::read_log(folder / "a");
    EXPECT_THAT(log.scans.at(0).rays, ElementsAre(0, 2));
}

TEST(LogWriter, AFanSweptToTheRightIsFoundFromPointsAlone) {
    const TempDir folder;
    Tour tour = tour_with({1.3, -0.6, 0, 8.0, {}}, 58);
    for (Scan& scan : tour.scans) {
        scan.fan = {};
        scan.rays.clear();
    }
    expect_same_tour(tour, test::read_log(write_tour("player", folder / "a", tour)), 2e-4);
}

TEST(LogWriter, ReadingsThatRoundingWouldLose) {
    const TempDir folder;
    for (const std::string& format : kAll) {
        const auto writer = make_log_writer(format, folder / "a");
        writer->write(scan_of(1.0, kHalf, {7.99999, 0.00001, 2.0}));
        writer->finish();
        EXPECT_EQ(test::read_log(folder / "a").scans.at(0).points.size(), 3U) << format;
    }
}

TEST(LogWriter, FanFromPointsAlone) {
    const TempDir folder;
    for (const auto& [fan, rays] :
         {std::pair{kHalf, std::size_t{181}}, {kHalf, 361}, {Fan{-1.2, 0.7, 0, 8.0, {}}, 58}}) {
        Tour tour = tour_with(fan, rays);
        for (Scan& scan : tour.scans) {
            scan.fan = {};
            scan.rays.clear();
        }
        for (const std::string& format : kAll) {
            SCOPED_TRACE(format + " " + std::to_string(rays));
            expect_same_tour(tour, test::read_log(write_tour(format, folder / "a", tour)), 2e-4);
        }
    }
}

TEST(LogWriter, PointsOnNoFanAreRefused) {
    const TempDir folder;
    Scan scan;
    scan.line = 17;
    for (const double bearing : {0.0, 0.1, 0.25, 0.30}) {
        scan.points.push_back({2 * std::cos(bearing), 2 * std::sin(bearing)});
    }
    scan.points.push_back({2 * std::cos(0.4247), 2 * std::sin(0.4247)});
    scan.run_starts = {0};
    for (const char* format : {"player", "carmen"}) {
        const auto writer = make_log_writer(format, folder / "a");
        EXPECT_THAT(test::message_of<FormatError>([&] { writer->write(scan); }),
                    HasSubstr("regular rays"));
    }
    const auto writer = make_log_writer("radish", folder / "a");
    writer->write(scan);
    writer->finish();
    EXPECT_EQ(test::read_log(folder / "a").scans.at(0).points.size(), 5U);
    EXPECT_EQ(folder.files(), 1U);
}

TEST(LogWriter, ScansWithoutPoints) {
    const TempDir folder;
    for (const std::string& format : kAll) {
        for (const bool with_fan : {true, false}) {
            const auto writer = make_log_writer(format, folder / "a");
            Scan scan = scan_of(1.0, kHalf, std::vector<double>(181, 0.0));
            if (!with_fan) scan.fan = {};
            writer->write(scan);
            writer->finish();
            const Log log = test::read_log(folder / "a");
            ASSERT_EQ(log.scans.size(), 1U) << format;
            EXPECT_TRUE(log.scans[0].points.empty()) << format;
        }
    }
}

TEST(LogWriter, PointBeyondTheGreatestRangeIsRefused) {
    const TempDir folder;
    const auto writer = make_log_writer("player", folder / "a");
    EXPECT_THROW(writer->write(scan_of(1.0, kHalf, {9.0, 1.0})), FormatError);
}

TEST(LogWriter, WithoutFinishNothingIsLeft) {
    const TempDir folder;
    for (const std::string& format : kAll) {
        const auto writer = make_log_writer(format, folder / "a");
        writer->write(Odometria{1.0, {}, 0});
    }
    EXPECT_EQ(folder.files(), 0U);
}

TEST(LogWriter, WhereNothingCanBeWritten) {
    const TempDir folder;
    const auto file = folder.put("file", "x");
    for (const std::string& format : kAll) {
        EXPECT_THROW(make_log_writer(format, file / "a.log"), FileError);
        EXPECT_THROW(make_log_writer(format, folder.path()), FileError);
        EXPECT_THROW(make_log_writer(format, "/proc/a.log"), FileError);
    }
    EXPECT_THROW(make_log_writer(kAutoFormat, folder / "a"), ConfigError);
    EXPECT_EQ(folder.files(), 1U);
}

TEST(LogWriter, NormalizedBreaksAreCounted) {
    const TempDir folder;
    const auto writer = make_log_writer("normalized", folder / "a");
    Scan scan;
    scan.time_s = 0.1;
    scan.points = {{1, 2}, {0, 0}, {5, 6}};
    scan.run_starts = {0, 2};
    writer->write(scan);
    writer->write(Odometria{0.1, {0.5, 0.0, 0.1}, 0});
    writer->write(Odometria{0.2, {0.5, 0.25, 0.1}, 0});
    writer->finish();
    EXPECT_EQ(content(folder / "a"),
              "ODOM 0.1 0.5 0.1\nLASER 0.1 4 1 2 1e-300 0 0 0 5 6\nODOM 0.2 0.5 0.1 0.25\n");
    EXPECT_THAT(test::read_log(folder / "a").scans.at(0).run_starts, ElementsAre(0, 2));
}

TEST(LogWriter, PointsOfOneBearingAreRefused) {
    // A twentieth of a milliradian apart: no scanner has such rays.
    const TempDir folder;
    Scan scan;
    for (const double bearing : {0.0, 5e-5, 1e-4}) {
        scan.points.push_back({2 * std::cos(bearing), 2 * std::sin(bearing)});
    }
    scan.run_starts = {0};
    const auto writer = make_log_writer("player", folder / "a");
    EXPECT_THAT(test::message_of<FormatError>([&] { writer->write(scan); }),
                HasSubstr("two of its points have one bearing"));
}

TEST(LogWriter, RadishSaysNoReturnBetweenTwoRuns) {
    // Halfway, where the ray was: the bearings stay a fan's.
    const TempDir folder;
    Scan scan;
    for (const double bearing : {0.0, 0.1, 0.3, 0.4}) {
        scan.points.push_back({2 * std::cos(bearing), 2 * std::sin(bearing)});
    }
    scan.run_starts = {0, 2};
    const auto writer = make_log_writer("radish", folder / "a");
    writer->write(scan);
    writer->finish();
    const Log log = test::read_log(folder / "a");
    EXPECT_EQ(log.scans.at(0).fan.count, 5U);
    EXPECT_THAT(log.scans[0].rays, ElementsAre(0, 1, 3, 4));
    EXPECT_THAT(log.scans[0].run_starts, ElementsAre(0, 2));
}

}  // namespace
}  // namespace hitos
